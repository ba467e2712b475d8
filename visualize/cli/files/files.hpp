#pragma once
// Reading what the user gave and writing what was asked for. What is written appears whole or not at all.

#include <cstdint>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/terminal/terminal.hpp"
#include "request/names.hpp"

namespace gradus::cli {

/// A whole regular file, or standard input, of any kind, for "-". `what` names the argument in errors
/// ("--maze"). Throws UsageError when it can't be read, is a folder, pipe or device, or holds more than 256
/// MiB.
std::string read_input(const std::string& path, std::string_view what);

/// Everything to one of the standard streams. Throws WorkError, or OutputClosed for a pipe nobody reads.
void write_stream(Stream stream, std::string_view bytes);
/// The same to stderr, and its failure is ignored: there is nowhere left to complain.
void note(std::string_view line);

/// Whether both paths lead to one file, by links and folders' links, too; it need not be there yet.
bool same_file(const std::string& a, const std::string& b);

/// What a new file may take the place of.
enum class Replace : std::uint8_t {
  own,       ///< what is_replaceable() takes for ours; anything else is a UsageError that names --force
  anything,  ///< said with --force, or known to be ours
};
/// What --force allows.
constexpr Replace replaces(bool force) { return force ? Replace::anything : Replace::own; }

/// Where a command writes to, and whether it says so.
struct Output {
  std::string path;  ///< or dash
  Replace replace = Replace::own;
  bool quiet = false;
};

/// Throws UsageError, beginning with the flag `what`, when the file at `path` must not be replaced.
void check_replaced(const std::string& path, std::string_view what, std::string_view bytes = {});

/// Throws UsageError when nothing can be written under this name: it is a folder, its folder does not exist,
/// it is one of the inputs, or somebody's own; WorkError when the system forbids it: before the work, not
/// after.
void check_output(const std::string& path, std::span<const std::string> inputs, Replace replace);

/// Makes a folder and those it lies in, unless it is there. Throws UsageError, naming the argument `what`.
void make_folder(const std::string& path, std::string_view what);

/// Files that appear together: each is written beside its final place and gets its name in commit().
/// Destroyed before that, no trace is left; what a killed process left is removed by the next one that writes
/// into the same folder (see leftovers.hpp). Throws WorkError.
class NewFiles {
 public:
  NewFiles() = default;
  ~NewFiles();
  NewFiles(const NewFiles&) = delete;
  NewFiles& operator=(const NewFiles&) = delete;

  /// An existing file keeps its permissions; a link is followed, also to what is not there yet; a device or
  /// pipe is written at once. Throws UsageError for a file that must not be replaced, or that another one of
  /// these will be.
  void add(const std::string& path, std::string_view bytes, Replace replace = Replace::own);
  /// Where the system refuses a name in their midst, the files before it get their old contents back; where
  /// the disk can't keep those beside the new ones, by links, the error tells which files are new. Each file
  /// is whole at any time; a process that is killed (SIGKILL, a loss of power) between two names leaves some
  /// new.
  void commit();

 private:
  struct Pending {
    std::string temporary, path;
  };
  /// What was under a name before: another name that it is kept by, or nothing.
  struct Old {
    std::string kept{};
    bool none = false;
  };
  static Old keep_old(const std::string& path);
  static void drop(const Old& old);
  /// Undoes what commit() has done; tells what it can't. done: how many files have their new contents.
  std::string take_back(const std::vector<Old>& olds, std::size_t done);

  std::vector<Pending> pending_;
  std::set<std::filesystem::path> destinations_;
};

/// One file, or standard output for "-". Throws as NewFiles does.
void write_output(const std::string& path, std::string_view bytes, Replace replace = Replace::own);

/// Opens closed standard streams, ignores SIGPIPE, and ends the program on SIGINT (130) and SIGTERM (143)
/// after removing files that are not complete. To be called first.
void prepare_process();

}  // namespace gradus::cli
