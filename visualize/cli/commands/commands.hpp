#pragma once
// The commands of `gradus`: what each takes, and the functions that do them.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "cli/terminal/terminal.hpp"
#include "stories/topic.hpp"

namespace gradus::cli {

/// A flag of a command, `--name` or `-letter`.
struct Flag {
  std::string name;
  char letter = 0;    ///< 0: none
  std::string value;  ///< how its value is called in help; empty: a switch
  std::string help;
  bool many = false;  ///< may be given several times
};

/// What an operand is, for completion.
enum class Operand { none, topic, page, lecture, model, figure, shell, folder, demo, data, answers };

struct Command {
  std::string name;
  std::string operands;  ///< how they are called in messages: "a TOPIC", "one WORD"
  std::string summary;
  std::size_t least = 0, most = 0;  ///< how many operands
  bool about_topic = false;         ///< the first operand is a topic, whose parameters are flags too
  std::vector<Flag> flags;
  std::vector<std::string> examples;
  Operand operand = Operand::none;    ///< behind the topic, where there is one
  std::vector<std::string> limits{};  ///< of how much it makes at once, a line each
};
std::span<const Command> commands();

/// What a topic's parameter is called among a command's flags, "svg-text": where the command has a flag of
/// that name itself, "input-points".
std::string parameter_flag(const Command& command, const Parameter& parameter);

/// Flags that every command takes.
std::span<const Flag> common_flags();

/// The looks that `figures` takes for a whole lecture, over those it names itself.
std::span<const Flag> lecture_looks();

/// A command line, read: names resolved, values as written.
struct Request {
  const Command* command = nullptr;  ///< none: `gradus` alone, or with --help or --version
  const TopicEntry* topic = nullptr;
  std::vector<std::string> operands;             ///< without the topic
  std::map<std::string, std::string> flags;      ///< the command's own, by name; a switch has the value ""
  std::map<std::string, std::string> arguments;  ///< the topic's parameters, and "method"
  std::vector<std::string> labels;               ///< every --label
  bool has(const std::string& flag) const { return flags.contains(flag); }
  bool quiet() const { return has("quiet"); }
  Color color() const;
  /// How long lines on standard output may be; 0: as long as they are.
  std::size_t width() const;
};

/// Reads a command line (without the program's name). Throws UsageError.
Request read_request(const std::vector<std::string>& words);

// Each writes its data to stdout, everything else to stderr, and returns the exit code.
int list(const Request& request);
int help(const Request& request);
int run(const Request& request);
int figure(const Request& request);
int source(const Request& request);
int cases(const Request& request);
int check(const Request& request);
int figures(const Request& request);
int worksheet(const Request& request);
int render(const Request& request);
int explain(const Request& request);
int demo(const Request& request);
int inspect(const Request& request);
int again(const Request& request);
int completion(const Request& request);
int manual(const Request& request);
/// Replaces the process by a browser.
int open_gallery(const Request& request);
/// Replaces the process by the program that does the command: gradus-bench, gradus-stress.
int hand_over(const Request& request);

/// `gradus --version`.
int version();

/// The version of the one library that only command_line.cpp may include.
std::string cli11_version();

}  // namespace gradus::cli
