// The only file that includes CLI11: it takes seconds to compile.

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>

#include "cli/command_line/errors.hpp"
#include "cli/command_line/spelling.hpp"
#include "cli/commands/commands.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

/// An option, and where what is read goes.
struct Bound {
  CLI::Option* option;
  std::string shown_name;
  std::map<std::string, std::string>* to;
  std::string key;
  bool many;
};

class Parser {
 public:
  Parser(const Spelled& spelled, Request& request) : spelled_(spelled), request_(request) {
    app_.set_help_flag("");
    app_.allow_windows_style_options(false);
    if (spelled.topic) add_parameters(*spelled.topic);
    if (spelled.command) add_flags(spelled.command->flags);
    add_flags(common_flags());
    operands_ = app_.add_option("operands", request.operands)->expected(0, 1 << 20);
  }

  void parse() {
    std::vector<std::string> words(spelled_.words.rbegin(),
                                   spelled_.words.rend());  // CLI11 takes them from the back
    try {
      app_.parse(std::move(words));
    } catch (const CLI::ExtrasError&) {
      refuse_unknown();
    } catch (const CLI::ParseError& error) {
      throw UsageError(error.what());
    }
    for (const Bound& bound : bound_) collect(bound);
  }

 private:
  void add(const std::string& names, const std::string& shown_name, bool takes_value,
           std::map<std::string, std::string>& to, const std::string& key, bool many = false) {
    CLI::Option* option = takes_value ? app_.add_option(names, unused_) : app_.add_flag(names);
    if (takes_value)
      option->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)->expected(1)->allow_extra_args(false);
    bound_.push_back({option, shown_name, &to, key, many});
  }

  void add_parameters(const TopicEntry& topic) {
    for (const Parameter& p : topic.parameters) {
      const bool takes_value = p.type != ParameterType::flag;
      const std::string flag = "--" + parameter_flag(*spelled_.command, p);
      add(flag, flag, takes_value, request_.arguments, p.name);
    }
    add("--method", "--method", true, request_.arguments, "method");
  }

  void add_flags(std::span<const Flag> flags) {
    for (const Flag& flag : flags) {
      const std::string letter = flag.letter ? fmt::format("-{},", flag.letter) : "";
      add(letter + "--" + flag.name, "--" + flag.name, !flag.value.empty(), request_.flags, flag.name,
          flag.many);
    }
  }

  void collect(const Bound& bound) {
    const std::vector<std::string>& values = bound.option->results();
    if (values.empty()) return;
    if (bound.many) {
      request_.labels = values;
      return;
    }
    const bool is_switch = bound.option->get_expected_max() == 0;
    if (!is_switch && values.size() > 1) {
      throw UsageError(fmt::format("{}: expected one value, found {} and {}", bound.shown_name,
                                   shown(values[0]), shown(values[1])));
    }
    const std::string given = bound.to == &request_.arguments ? "yes" : "";
    (*bound.to)[bound.key] = is_switch ? given : values.front();
  }

  [[noreturn]] void refuse_unknown() const {
    const auto left = app_.remaining();
    const std::string found = shown(left.empty() ? "" : left[0]);
    if (!spelled_.command)
      throw UsageError(fmt::format("expected a known flag (`gradus --help` lists them), found {}", found));
    throw UsageError(fmt::format("{0}: expected a known flag (`gradus {0} --help` lists them), found {1}",
                                 spelled_.command->name, found));
  }

  const Spelled& spelled_;
  Request& request_;
  CLI::App app_;
  CLI::Option* operands_ = nullptr;
  std::vector<Bound> bound_;
  std::vector<std::string> unused_;
};

/// The operand behind a topic that is about a model is that model.
void take_model(Request& request) {
  const Parameter* model = request.topic ? model_of(*request.topic) : nullptr;
  if (!model || request.operands.empty()) return;
  const auto flag = request.arguments.find(model->name);
  if (flag != request.arguments.end()) {
    throw UsageError(fmt::format("--{}: expected one model, found {} and {}", hyphened(model->name),
                                 shown(flag->second), shown(request.operands.front())));
  }
  request.arguments[model->name] = request.operands.front();
  request.operands.erase(request.operands.begin());
}

void check_operands(const Request& request) {
  const Command& command = *request.command;
  const std::size_t count = request.operands.size() + (request.topic ? 1 : 0);
  if (request.has("help") || (command.least <= count && count <= command.most)) return;
  if (count < command.least) {
    throw UsageError(fmt::format("{}: expected {}, found none (`gradus {} --help` shows examples)",
                                 command.name, command.operands, command.name));
  }
  const std::string expected = command.most == 0    ? "no words"
                               : command.least == 0 ? "at most " + command.operands
                                                    : "only " + command.operands;
  throw UsageError(
      fmt::format("{}: expected {}, found {}", command.name, expected, shown(request.operands.back())));
}

}  // namespace

Request read_request(const std::vector<std::string>& words) {
  const Spelled spelled = spelled_out(words);
  Request request;
  request.command = spelled.command;
  request.topic = spelled.topic;
  Parser(spelled, request).parse();
  // Behind other commands' topics stands a file of their own
  const bool may_be_model = request.command && request.command->operand != Operand::answers;
  if (may_be_model && request.command->about_topic) take_model(request);
  if (request.command) check_operands(request);
  return request;
}

std::string cli11_version() { return CLI11_VERSION; }

}  // namespace gradus::cli
