#include "cli/completion/complete.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>
#include <span>

#include "cli/command_line/choices.hpp"
#include "cli/command_line/errors.hpp"
#include "cli/commands/commands.hpp"
#include "cli/figures/figure_file.hpp"
#include "cli/files/files.hpp"
#include "cli/files/shipped.hpp"
#include "cli/film/road_film.hpp"
#include "cli/models/imported_model.hpp"
#include "figure/sheet.hpp"
#include "figure/text/wording.hpp"
#include "plan/rules.hpp"
#include "request/inputs.hpp"
#include "request/names.hpp"
#include "request/notation_reader.hpp"
#include "scene/antialiasing.hpp"
#include "scene/choices.hpp"
#include "stories/colors.hpp"
#include "stories/point_text.hpp"

namespace gradus {

std::string_view completion_text(std::string_view path);  // embedded by the build

namespace cli {
namespace {

using Texts = std::vector<std::string>;

// --- Words -------------------------------------------------------------------------------------------------

/// Collects the words that go on from what has been typed. Hyphen and underscore, upper and lower case mean
/// the same; the shell wants the beginning as it stands.
class Words {
 public:
  /// prefix: what stands before each word, "--theme=" or "title,".
  Words(Completions& to, std::string prefix, std::string_view typed)
      : to_(to), prefix_(std::move(prefix)), typed_(typed) {}

  void add(std::string_view word, std::string_view help = "") {
    if (!folded(word).starts_with(folded(typed_)) || !known_.insert(std::string(word)).second) return;
    to_.words.push_back(
        {prefix_ + std::string(typed_) + std::string(word.substr(typed_.size())), std::string(help)});
  }
  void add_all(std::span<const std::string> words) {
    for (const std::string& word : words) add(word);
  }
  bool found() const { return !known_.empty(); }
  /// Where the words go.
  Completions& to() const { return to_; }

  /// The same words behind those of a list that have been typed: "title,dra" goes on with "drawing".
  Words in_list() const {
    const std::size_t comma = typed_.rfind(',');
    if (comma == std::string_view::npos) return *this;
    return {to_, prefix_ + std::string(typed_.substr(0, comma + 1)), typed_.substr(comma + 1)};
  }

 private:
  Completions& to_;
  std::string prefix_;
  std::string_view typed_;
  std::set<std::string> known_;
};

void add_topics(Words& words) {
  for (const TopicEntry* topic : catalogue()) words.add(topic->name, topic->title);
  if (words.found()) return;
  for (const TopicEntry* topic : catalogue()) {
    for (const std::string& alias : topic->aliases) words.add(alias, topic->title);
  }
}

void add_commands(Words& words) {
  for (const Command& command : commands()) words.add(command.name, command.summary);
}

void add_files(Words& words, Texts endings) {
  words.to().files = true;
  words.to().endings = std::move(endings);
}

void add_models(Words& words) {
  for (const std::string& name : shipped_examples(".obj")) words.add(name, "comes with gradus");
  add_files(words, {".obj"});
}

void add_models_and_scenes(Words& words) {
  add_models(words);
  for (const std::string& name : shipped_examples(".json")) words.add(name, "comes with gradus");
  Texts endings{".obj", ".json"};
  for (const std::string_view ending : pipeline::own_endings) endings.push_back(fmt::format(".{}", ending));
  if (model_importer()) {
    for (const std::string_view ending : pipeline::imported_endings)
      endings.push_back(fmt::format(".{}", ending));
  }
  add_files(words, std::move(endings));
}

// --- Values of flags -----------------------------------------------------------------------------

/// A flag that may be given here: a command's, a parameter of the topic, or --method.
struct Offer {
  std::string name;  ///< with hyphens
  std::string help;
  const Flag* flag = nullptr;
  const Parameter* parameter = nullptr;

  bool takes_value() const {
    if (flag) return !flag->value.empty();
    return !parameter || parameter->type != ParameterType::flag;
  }
};

void add_values(Words& words, const Parameter& parameter) {
  switch (parameter.type) {
    case ParameterType::choice:
      return words.add_all(parameter.choices);
    case ParameterType::order: {
      Words list = words.in_list();
      return list.add_all(parameter.choices);
    }
    case ParameterType::color:
    case ParameterType::paint:
      return words.add_all(color_names());
    case ParameterType::picture:
      for (const std::string& name : shipped_examples(".png")) words.add(name, "comes with gradus");
      return add_files(words, {".png", ".jpg", ".jpeg"});
    case ParameterType::maze:
      return add_files(words, {});
    case ParameterType::faces:
      for (const std::string& name : shipped_examples(".obj")) words.add(name, "comes with gradus");
      return add_files(words, {".json", ".obj"});
    case ParameterType::model:
      return add_models(words);
    case ParameterType::flag:
      return;
    default:
      words.add(parameter.example, "for example");
      words.add(parameter.default_value, "the default");
  }
}

void add_values(Words& words, const Flag& flag, const TopicEntry* topic) {
  const std::string name = folded(flag.name);
  if (const Texts choices = choices_of(name); !choices.empty()) return words.add_all(choices);
  if (flag.value == "WHEN") return words.add_all(Texts{"auto", "always", "never"});
  if (flag.value == "DIR") {
    words.to().folders = true;
  } else if (flag.value == "FILE") {
    add_files(words, {});
  } else if (name == "lecture") {
    add_files(words, {".json"});
  } else if (name == "format" && flag.help.starts_with("pdf, tex")) {
    words.add_all(Texts{"pdf", "tex", "xml"});
  } else if (name == "format") {
    words.add_all(format_names());
  } else if (name == "snippet") {
    words.add_all(Texts{"beamer", "reveal", "markdown"});
  } else if (name == "slots") {
    Words list = words.in_list();
    for (const Slot slot : all_slots) list.add(name_of(slot));
  } else if (name == "steps") {
    words.add("auto", "the input, the first that decides of each phase and branch, the result");
  } else if (name == "step") {
    words.add("last", "the result");
  } else if (name == "panels") {
    words.add("phases", "a drawing for each phase");
  } else if (name == "compare" && topic) {
    for (const Method& method : topic->methods) words.add(method.name, method.title);
  } else if (name == "background") {
    words.add("none", "a transparent ground");
    words.add_all(color_names());
  } else if (name == "size") {
    words.add_all(Texts{"16:9", "4:3", "1:1"});
  } else if (name == "shading") {
    for (const std::string_view how : pipeline::shading_names) words.add(std::string(how));
  } else if (name == "projection") {
    for (const std::string_view how : pipeline::projection_names) words.add(std::string(how));
  } else if (name == "hidden_surfaces") {
    for (const std::string_view how : pipeline::hidden_surface_names) words.add(std::string(how));
  } else if (name == "culling") {
    for (const std::string_view which : pipeline::culling_names) words.add(std::string(which));
  } else if (name == "foreshortening") {
    words.add("1", "cavalier");
    words.add("0.5", "cabinet");
  } else if (name == "filter") {
    words.add_all(Texts{"nearest", "bilinear", "mipmapped", "none"});
  } else if (name == "aa") {
    for (const std::string_view method : pipeline::antialiasing_names) words.add(std::string(method));
  } else if (name == "without") {
    Words list = words.in_list();
    list.add("all", "everything is done");
    for (const std::string_view rule : pipeline::rule_names) list.add(std::string(rule));
  } else if (name == "why") {
    words.add("120,88", "for example");
  } else if (name == "part") {
    words.add("0,0,200x100", "for example");
  } else if (flag.value == "FRAMES") {
    words.add("0-124", "for example");
  } else if (name == "array") {
    words.add("1/4", "for example");
  } else if (name == "samples") {
    words.add_all(Texts{"4", "16", "64"});
  } else if (name == "only") {
    add_topics(words);
  } else if (name == "notation") {
    words.add_all(notation_names());
    add_files(words, {".json"});
  } else if (name == "label" && topic) {
    for (const std::string& symbol : topic_symbols(topic->name))
      words.add(symbol + "=", "your own name for it");
  }
}

// --- The line so far -----------------------------------------------------------------------------

/// A command line as far as it has been typed, read word by word.
class Line {
 public:
  explicit Line(const std::vector<std::string>& words) {
    for (const std::string& word : words) take(word);
  }

  Completions next(const std::string& typed) const {
    Completions found;
    if (lost_) return found;
    const std::size_t equals = typed.find('=');
    if (awaited_) {
      Words words(found, "", typed);
      add_values_of(words, *awaited_);
    } else if (unknown_value_ || plain_ || !typed.starts_with('-')) {
      Words words(found, "", typed);
      if (!unknown_value_) add_operands(words);
    } else if (typed.starts_with("--") && equals != std::string::npos) {
      const auto offer = offered(typed.substr(2, equals - 2));
      Words words(found, typed.substr(0, equals + 1), std::string_view(typed).substr(equals + 1));
      if (offer) add_values_of(words, *offer);
    } else {
      Words words(found, "", typed);
      for (const Offer& offer : offers()) {
        const bool again = offer.flag && offer.flag->many;
        if (again || !given_.contains(offer.name)) words.add("--" + offer.name, offer.help);
      }
    }
    return found;
  }

 private:
  /// All flags that may be given here, the topic's first.
  std::vector<Offer> offers() const {
    std::vector<Offer> all;
    if (topic_) {
      for (const Parameter& p : topic_->parameters)
        all.push_back({parameter_flag(*command_, p), p.help, nullptr, &p});
      all.push_back({"method", "how it is done", nullptr, nullptr});
    }
    const auto add = [&all](std::span<const Flag> flags) {
      for (const Flag& flag : flags) all.push_back({flag.name, flag.help, &flag, nullptr});
    };
    if (command_) add(command_->flags);
    add(common_flags());
    return all;
  }

  /// The flag of this name or unique beginning.
  std::optional<Offer> offered(std::string_view name) const {
    const std::vector<Offer> all = offers();
    Texts names;
    for (const Offer& offer : all) names.push_back(offer.name);
    const std::vector<std::size_t> matches = matching_names(name, names);
    return matches.empty() ? std::nullopt : std::optional(all[matches.front()]);
  }

  void take(const std::string& word) {
    if (awaited_ || unknown_value_) {
      const bool value = !word.starts_with("--");
      awaited_.reset();
      unknown_value_ = false;
      if (value) return;
    }
    if (plain_ || word.size() < 2 || word[0] != '-' || ('0' <= word[1] && word[1] <= '9'))
      return take_operand(word);
    if (word == "--") {
      plain_ = true;
    } else if (word.starts_with("--")) {
      take_flag(word);
    } else if (word.size() == 2) {
      for (const Offer& offer : offers()) {
        if (offer.flag && offer.flag->letter == word[1] && offer.takes_value()) awaited_ = offer;
      }
    }
  }

  void take_flag(const std::string& word) {
    const std::size_t equals = std::min(word.find('='), word.size());
    const auto offer = offered(std::string_view(word).substr(2, equals - 2));
    if (offer) given_.insert(offer->name);
    if (equals < word.size()) return;
    if (offer && offer->takes_value()) awaited_ = offer;
    // A topic's flag before the topic
    if (!offer) unknown_value_ = true;
  }

  void take_operand(const std::string& word) {
    try {
      if (!command_) {
        Texts names;
        for (const Command& command : commands()) names.push_back(command.name);
        command_ = &commands()[choose_name("COMMAND", word, names)];
      } else if (command_->about_topic && !topic_) {
        topic_ = &find_topic(word);
      } else {
        ++operands_;
      }
    } catch (const UsageError&) {
      lost_ = true;
    }
  }

  void add_values_of(Words& words, const Offer& offer) const {
    if (offer.parameter) return add_values(words, *offer.parameter);
    if (offer.flag) return add_values(words, *offer.flag, topic_);
    for (const Method& method : topic_->methods) words.add(method.name, method.title);
  }

  void add_operands(Words& words) const {
    if (!command_) return add_commands(words);
    if (command_->about_topic && !topic_) return add_topics(words);
    if (topic_ && command_->operand == Operand::answers) {
      if (operands_ == 0) add_files(words, {".json", ".csv"});
      return;
    }
    if (topic_) {
      if (operands_ == 0 && model_of(*topic_)) add_models(words);
      if (command_->operand == Operand::topic && operands_ + 1 < command_->most) add_topics(words);
      return;
    }
    if (operands_ >= command_->most) return;
    switch (command_->operand) {
      case Operand::none:
      case Operand::answers:  // behind a topic
        return;
      case Operand::topic:
        return add_topics(words);
      case Operand::page:
        add_topics(words);
        return add_commands(words);
      case Operand::lecture:
        return add_files(words, {".json"});
      case Operand::model:
        return add_models_and_scenes(words);
      case Operand::figure:
        return add_files(words, {".svg", ".png", ".pdf", ".pptx", ".html", ".gif", ".mp4", ".webp"});
      case Operand::shell:
        return words.add_all(Texts{"bash", "zsh", "fish"});
      case Operand::folder:
        words.to().folders = true;
        return;
      case Operand::demo:
        for (const DemoName& demo : demo_names) words.add(demo.name, demo.what);
        return;
      case Operand::data:
        words.add("pyramid_demo.json", "comes with gradus");
        return add_files(words, {".json"});
    }
  }

  const Command* command_ = nullptr;
  const TopicEntry* topic_ = nullptr;
  std::size_t operands_ = 0;      ///< without the topic
  std::optional<Offer> awaited_;  ///< the last word is a flag whose value comes next
  bool unknown_value_ = false;    ///< the same of a flag that is not known yet
  std::set<std::string> given_;   ///< flags, by name
  bool plain_ = false;            ///< behind "--"
  bool lost_ = false;             ///< a word can't be read
};

}  // namespace

Completions completions_of(const std::vector<std::string>& before, const std::string& typed) {
  return Line(before).next(typed);
}

std::string text_of(const Completions& completions) {
  std::string text;
  for (const auto& [word, help] : completions.words) text += fmt::format("{}\t{}\n", word, help);
  if (completions.folders) text += "\tfolders\n";
  if (completions.files && completions.endings.empty()) text += "\tfiles\n";
  if (completions.files && !completions.endings.empty())
    text += fmt::format("\tfiles\t{}\n", fmt::join(completions.endings, " "));
  return text;
}

std::string completion_script(std::string_view shell) {
  return std::string(completion_text(fmt::format("gradus.{}", shell)));
}

int complete_next(const std::vector<std::string>& words) {
  const std::vector<std::string> before(words.begin(), words.empty() ? words.end() : words.end() - 1);
  write_stream(Stream::out, text_of(completions_of(before, words.empty() ? "" : words.back())));
  return 0;
}

int completion(const Request& request) {
  if (request.has("next")) return complete_next(request.operands);
  if (request.operands.size() > 1) {
    throw UsageError(fmt::format("completion: expected one shell, found {}", shown(request.operands[1])));
  }
  const Texts shells{"bash", "zsh", "fish"};
  write_stream(Stream::out, completion_script(shells[choose_name("SHELL", request.operands[0], shells)]));
  return 0;
}

}  // namespace cli
}  // namespace gradus
