#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <set>

#include "cli/command_line/errors.hpp"
#include "cli/figures/compare.hpp"
#include "cli/files/files.hpp"
#include "cli/files/notation_file.hpp"
#include "cli/lecture/lecture_problem.hpp"
#include "cli/lecture/lecture_values.hpp"
#include "figure/text/wording.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {

namespace {

namespace fs = std::filesystem;
using Kind = JsonNode::Kind;

struct Given {
  std::string text;
  Place place;
};

/// What a figure can have from its lecture.
struct Settings {
  std::map<std::string, Given> flags;   ///< by the flag's name
  std::map<std::string, Given> labels;  ///< by symbol
  std::vector<Format> outputs{Format::svg, Format::png, Format::pdf, Format::html, Format::csv, Format::json};
};

/// The flag of `gradus figure` that this key stands for, if any.
const Flag* flag_of(const LectureKey& key) {
  static const Command& figure = *std::ranges::find(commands(), "figure", &Command::name);
  const auto flag =
      std::ranges::find_if(figure.flags, [&key](const Flag& f) { return folded(f.name) == key.name; });
  return flag == figure.flags.end() ? nullptr : &*flag;
}

class LectureReader : LectureValues {
 public:
  LectureReader(const LectureFile& file, const std::map<std::string, std::string>& instead)
      : LectureValues(file.name), file_(file), instead_(instead) {}

  Lecture read() {
    const JsonNode root = read_json(file_.text, file_.name);
    if (!is_object(root, {root.line, ""}, "an object with the key \"figures\"")) return std::move(lecture_);
    check_keys(root, "", &LectureKey::of_lecture);
    if (const JsonMember* title = root.member("title")) {
      lecture_.title = line_of_text(title->value, {title->line, "title"}).value_or("");
    }
    if (const JsonMember* schema = root.member("$schema")) text_of(schema->value, {schema->line, "$schema"});
    Settings defaults;
    read_settings(root, "", &LectureKey::of_lecture, defaults);
    if (!root.member("figures") && !root.member("renders")) {
      complain({root.line, ""}, "expected the key \"figures\" or \"renders\", found none");
    }
    read_figures(root, defaults);
    read_renders(root);
    for (const auto& [symbol, given] : defaults.labels) require_symbol(symbol, given.place, topics_);
    require_symbols(root, "", topics_);
    name_parts();
    std::ranges::stable_sort(lecture_.problems, {}, &Problem::line);
    return std::move(lecture_);
  }

 private:
  // --- Keys

  /// What may be meant by a key that isn't one here: a slip of the pen, or a key that belongs elsewhere.
  static std::string hint_for(const std::string& key, const Texts& allowed, const TopicEntry* topic) {
    const bool is_input =
        topic && std::ranges::find(topic->parameters, key, &Parameter::name) != topic->parameters.end();
    if (is_input) return " (it belongs into \"input\")";
    const auto elsewhere = std::ranges::find(lecture_keys(), key, &LectureKey::name);
    if (elsewhere != lecture_keys().end()) {
      return elsewhere->of_figure ? " (it belongs into a figure, beside \"topic\")"
                                  : " (it belongs to the lecture, beside \"figures\")";
    }
    if (std::ranges::find(render_keys(), key, &LectureKey::name) != render_keys().end()) {
      return " (it belongs into a render, beside \"model\")";
    }
    return suggestion(key, allowed);
  }

  void refuse_key(const JsonMember& member, const std::string& path, const Texts& allowed,
                  const std::string& hint) {
    // A list of all keys is long: only for who gets no better advice
    const std::string expected =
        hint.empty() ? fmt::format("one of {}", fmt::join(allowed, ", ")) : "a known key";
    complain({member.line, way(path, member.key)},
             fmt::format("expected {}, found {}{}", expected, shown(member.key), hint));
  }

  void check_keys(const JsonNode& node, const std::string& path, bool LectureKey::* where,
                  const TopicEntry* topic = nullptr) {
    Texts allowed;
    for (const LectureKey& key : lecture_keys()) {
      if (key.*where) allowed.push_back(key.name);
    }
    check_keys(node, path, allowed, topic);
  }
  void check_keys(const JsonNode& node, const std::string& path, const Texts& allowed,
                  const TopicEntry* topic = nullptr) {
    for (const JsonMember& member : node.members) {
      if (std::ranges::find(allowed, member.key) != allowed.end()) continue;
      refuse_key(member, path, allowed, hint_for(member.key, allowed, topic));
    }
  }

  void read_settings(const JsonNode& node, const std::string& path, bool LectureKey::* where,
                     Settings& settings) {
    // One of these gives way to the other, also to one of the lecture
    if (node.member("step") || node.member("steps"))
      settings.flags.erase("step"), settings.flags.erase("steps");
    for (const LectureKey& key : lecture_keys()) {
      const JsonMember* member = node.member(key.name);
      if (!member || !(key.*where)) continue;
      const Place place{member->line, way(path, key.name)};
      if (key.kind == KeyKind::outputs) read_outputs(member->value, place, settings);
      if (key.kind == KeyKind::labels) read_labels(member->value, place, settings);
      const Flag* flag = flag_of(key);
      if (!flag || (key.name == "title" && path.empty())) continue;
      settings.flags.erase(flag->name);
      const auto text = key.kind == KeyKind::notation ? notation_value(member->value, place)
                                                      : flag_value(key, member->value, place);
      if (text) settings.flags[flag->name] = {*text, place};
    }
  }

  void read_outputs(const JsonNode& node, const Place& place, Settings& settings) {
    const Texts names{format_names().begin(), format_names().end()};
    const std::string expected = fmt::format("a list of {}", fmt::join(names, ", "));
    if (node.kind == Kind::list ? node.elements.empty() : node.kind != Kind::text) {
      return complain(place, expected, node);
    }
    settings.outputs.clear();
    for (const JsonNode& element : node.kind == Kind::list ? node.elements : std::vector{node}) {
      if (element.kind != Kind::text) {
        complain({element.line, place.path}, expected, element);
        continue;
      }
      const auto which = whole_name(element.text, names, {element.line, place.path});
      if (!which) continue;
      const auto format = static_cast<Format>(*which);
      if (std::ranges::find(settings.outputs, format) == settings.outputs.end())
        settings.outputs.push_back(format);
    }
  }

  /// As --notation takes it: one of ours by name, all others as JSON, for the figure's command to be whole.
  std::optional<std::string> notation_value(const JsonNode& node, const Place& place) {
    if (node.kind == Kind::object) {
      std::vector<NotationMistake> mistakes;
      Notation notation = notation_in(node, mistakes);
      for (const NotationMistake& mistake : mistakes)
        complain({mistake.line, way(place.path, mistake.way)}, mistake.what);
      return mistakes.empty() ? std::optional(std::move(notation.name)) : std::nullopt;
    }
    if (node.kind != Kind::text) {
      complain(place, "a text or an object", node);
      return std::nullopt;
    }
    try {
      return read_notation(node.text, file_.find).name;
    } catch (const UsageError& error) {
      complain(place, std::string(error.what()).substr(std::string_view("--notation: ").size()));
      return std::nullopt;
    }
  }

  void read_labels(const JsonNode& node, const Place& place, Settings& settings) {
    if (!is_object(node, place, "an object of symbols and their names like {\"p\": \"d\"}")) return;
    for (const JsonMember& member : node.members) {
      const Place here{member.line, way(place.path, member.key)};
      if (trimmed(member.key).empty() || member.key.find('=') != std::string::npos) {
        complain(here, fmt::format("expected a symbol, found {}", shown(member.key)));
      } else if (const auto text = line_of_text(member.value, here)) {
        settings.labels[member.key] = {*text, here};
      }
    }
  }

  // --- Figures

  void read_figures(const JsonNode& root, const Settings& defaults) {
    const JsonMember* figures = root.member("figures");
    if (!figures) return;
    if (figures->value.kind != Kind::list || figures->value.elements.empty()) {
      return complain({figures->line, "figures"}, "a list of at least one figure", figures->value);
    }
    for (std::size_t i = 0; i < figures->value.elements.size(); ++i) {
      read_figure(figures->value.elements[i], fmt::format("figures[{}]", i), defaults);
    }
  }

  void read_figure(const JsonNode& node, const std::string& path, Settings settings) {
    LectureFigure figure;
    figure.place = {node.line, path};
    if (!is_object(node, figure.place, "an object with the keys \"topic\" and \"input\"")) return;
    const std::size_t problems = lecture_.problems.size();
    figure.request.command = &*std::ranges::find(commands(), "figure", &Command::name);
    figure.request.topic = topic_of(node, path);
    if (figure.request.topic) topics_.insert(figure.request.topic);
    check_keys(node, path, &LectureKey::of_figure, figure.request.topic);
    read_settings(node, path, &LectureKey::of_figure, settings);
    if (figure.request.topic) require_symbols(node, path, {figure.request.topic});
    read_own(node, path, figure);
    take(settings, figure);
    read_request(figure);
    // A default that is wrong is noted once; the figures after the first are not whole either
    const bool whole = figure.spec.topic && lecture_.problems.size() == problems;
    if (whole) lecture_.figures.push_back(std::move(figure));
  }

  const TopicEntry* topic_of(const JsonNode& node, const std::string& path) {
    const JsonMember* topic = node.member("topic");
    if (!topic) {
      complain({node.line, path}, "expected the key \"topic\", found none");
      return nullptr;
    }
    const Place place{topic->line, path + ".topic"};
    const auto name = text_of(topic->value, place);
    if (!name) return nullptr;
    Texts names;
    for (const TopicEntry* known : catalogue()) names.push_back(known->name);
    const auto which = whole_name(*name, names, place);
    return which ? catalogue()[*which] : nullptr;
  }

  using ReadText = std::optional<std::string> (LectureReader::*)(const JsonNode&, const Place&);

  /// The value of a key of this part, its place noted; nothing where there is none, or a wrong one.
  std::optional<std::string> own(const JsonNode& node, LecturePart& part, const char* key, ReadText reader) {
    const JsonMember* member = node.member(key);
    if (!member) return std::nullopt;
    const Place place{member->line, way(part.place.path, key)};
    part.places[key] = place;
    return (this->*reader)(member->value, place);
  }

  /// What a figure has for itself: inputs, method, name, caption.
  void read_own(const JsonNode& node, const std::string& path, LectureFigure& figure) {
    if (const JsonMember* input = node.member("input")) {
      read_input(input->value, {input->line, path + ".input"}, figure);
    } else {
      complain({node.line, path}, "expected the key \"input\" ({} for the topic's defaults), found none");
    }
    const auto method = own(node, figure, "method", &LectureReader::text_of);
    if (method && figure.request.topic) {
      Texts names;
      for (const Method& known : figure.request.topic->methods) names.push_back(known.name);
      if (whole_name(*method, names, figure.places["method"])) figure.request.arguments["method"] = *method;
    }
    figure.name = own(node, figure, "name", &LectureReader::safe_name).value_or("");
  }

  void read_input(const JsonNode& node, const Place& place, LectureFigure& figure) {
    if (!is_object(node, place, "an object of the topic's inputs like {\"from\": \"0,0\"}")) return;
    if (!figure.request.topic) return;
    const std::vector<Parameter>& parameters = figure.request.topic->parameters;
    Texts names;
    for (const Parameter& parameter : parameters) names.push_back(parameter.name);
    for (const JsonMember& member : node.members) {
      const Place here{member.line, way(place.path, member.key)};
      const auto parameter = std::ranges::find(parameters, member.key, &Parameter::name);
      if (parameter == parameters.end()) {
        const bool beside =
            std::ranges::find(lecture_keys(), member.key, &LectureKey::name) != lecture_keys().end();
        refuse_key(member, place.path, names,
                   beside ? " (it belongs beside \"input\", not into it)" : suggestion(member.key, names));
        continue;
      }
      figure.places[parameter->name] = here;
      if (const auto text = input_value(*parameter, member.value, here)) {
        figure.request.arguments[parameter->name] = *text;
      }
    }
  }

  static bool is_default(const Given& label) { return label.place.path.starts_with("labels"); }

  /// From what the lecture says to a request, as a command line would have made it.
  void take(const Settings& settings, LectureFigure& figure) {
    figure.outputs = settings.outputs;
    for (const auto& [name, given] : settings.flags) {
      figure.request.flags[name] = given.text;
      figure.places[folded(name)] = given.place;
      if (name == "caption") figure.caption = given.text;
    }
    for (const auto& [name, text] : instead_) figure.request.flags[name] = text;
    for (const auto& [symbol, given] : settings.labels) {
      // The lecture's own labels are for those topics that have the symbol
      if (is_default(given) && !has_symbol(figure.request.topic, symbol)) continue;
      figure.request.labels.push_back(symbol + "=" + given.text);
      figure.places["label"] = {given.place.line, given.place.path.substr(0, given.place.path.rfind('.'))};
    }
  }

  /// Values are read by the functions that read the command line's.
  void read_request(LectureFigure& figure) {
    Request& request = figure.request;
    Inputs inputs;
    bool fine = request.topic && read_all(figure, request.arguments, [&] {
                  inputs = read_inputs(*request.topic, opened(request), file_.find);
                });
    FigureSpec spec;
    fine = read_all(figure, request.flags, [&] { spec = read_spec(request, inputs.arguments); }) && fine;
    if (!fine) return;
    figure.spec = std::move(spec);
    figure.files = std::move(inputs.files);
    figure.remarks = std::move(inputs.remarks);
    figure.copies = needed_of(figure.files, figure.spec.arguments);
  }

  /// The files whose contents do not stand in the command.
  static Texts needed_of(const Texts& files, const Arguments& arguments) {
    Texts needed;
    for (const std::string& file : files) {
      const std::string name = base_of(file);
      const bool is_needed = std::ranges::any_of(arguments.entries(), [&](const Arguments::Entry& entry) {
        const auto names_it = [&](const auto& library) { return library_base(library.first) == name; };
        return !entry.hash.empty() && (entry.text == name || std::ranges::any_of(entry.libraries, names_it));
      });
      if (is_needed) needed.push_back(file);
    }
    return needed;
  }

  static std::string base_of(const std::string& path) { return fs::path(path).filename().string(); }
  static std::string library_base(std::string name) {
    std::ranges::replace(name, '\\', '/');  // written on Windows
    return base_of(name);
  }

  // --- Renders

  void read_renders(const JsonNode& root) {
    const JsonMember* renders = root.member("renders");
    if (!renders) return;
    if (renders->value.kind != Kind::list || renders->value.elements.empty()) {
      return complain({renders->line, "renders"}, "a list of at least one render", renders->value);
    }
    for (std::size_t i = 0; i < renders->value.elements.size(); ++i) {
      read_render(renders->value.elements[i], fmt::format("renders[{}]", i));
    }
  }

  void read_render(const JsonNode& node, const std::string& path) {
    LectureRender render;
    render.place = {node.line, path};
    if (!is_object(node, render.place, "an object with the key \"model\"")) return;
    const std::size_t problems = lecture_.problems.size();
    Texts allowed;
    for (const LectureKey& key : render_keys()) allowed.push_back(key.name);
    check_keys(node, path, allowed);
    render.request.command = &*std::ranges::find(commands(), "render", &Command::name);
    if (!node.member("model")) complain(render.place, "expected the key \"model\", found none");
    const auto model = own(node, render, "model", &LectureReader::file_name);
    render.name = own(node, render, "name", &LectureReader::safe_name).value_or("");
    render.title = own(node, render, "title", &LectureReader::line_of_text).value_or("");
    render.caption = own(node, render, "caption", &LectureReader::line_of_text).value_or("");
    for (const Flag& flag : render.request.command->flags) read_render_flag(node, flag, render);
    if (!model) return;
    render.request.operands = {*model};
    read_all(render, render.request.flags, [&] { render.brief = render_brief(render.request, file_.find); });
    render.files = render.copies = render.brief.files;
    if (lecture_.problems.size() == problems) lecture_.renders.push_back(std::move(render));
  }

  void read_render_flag(const JsonNode& node, const Flag& flag, LectureRender& render) {
    const auto key = std::ranges::find(render_keys(), folded(flag.name), &LectureKey::name);
    const JsonMember* member = key == render_keys().end() ? nullptr : node.member(key->name);
    if (!member) return;
    const Place place{member->line, way(render.place.path, key->name)};
    render.places[key->name] = place;
    if (const auto text = flag_value(*key, member->value, place)) render.request.flags[flag.name] = *text;
  }

  // --- Values

  /// Calls `read` until it is content, each time without the value that it complained of. Whether the first
  /// time was the last.
  bool read_all(const LecturePart& part, std::map<std::string, std::string>& values,
                const std::function<void()>& read) {
    for (bool fine = true;; fine = false) {
      try {
        read();
        return fine;
      } catch (const std::exception& error) {
        if (!is_about_input(error)) throw;
        note(problem_of(lecture_, part, error));
        const std::string flag = flag_in(message_of(error));
        if (values.erase(flag) + values.erase(folded(flag)) == 0) return false;
      }
    }
  }

  // --- Names

  /// Copies of input files lie beside the part's own files, which begin with its name.
  std::string input_called(const std::string& name, const LecturePart& part) const {
    for (const std::string& path : part.copies) {
      const std::string file = base_of(path), stem = lowered(fs::path(path).stem().string());
      const auto format = format_by_ending(file);
      if (format && may_make(part, *format) &&
          (stem == lowered(name) || stem.starts_with(lowered(name) + "-"))) {
        return file;
      }
    }
    return "";
  }

  /// Models are made by figures that ask for them alone.
  bool may_make(const LecturePart& part, Format format) const {
    const auto figure = std::ranges::find(lecture_.figures, &part,
                                          [](const LectureFigure& f) -> const LecturePart* { return &f; });
    return !is_model(format) ||
           (figure != lecture_.figures.end() && std::ranges::count(figure->outputs, format) > 0);
  }

  using Owners = std::map<std::string, const LecturePart*>;  ///< by name, in lower case

  /// A name that the lecture gives must be nobody else's.
  void check_name(const LecturePart& part, Owners& owners) {
    if (part.name.empty()) return;
    const auto [owner, is_new] = owners.emplace(lowered(part.name), &part);
    const Place& place = part.places.at("name");
    if (!is_new) {
      complain(place, fmt::format("expected another name than that of {} (line {}), found {}",
                                  owner->second->place.path, owner->second->places.at("name").line,
                                  shown(part.name)));
    }
    if (const std::string input = input_called(part.name, part); !input.empty()) {
      complain(place, fmt::format("expected another name than that of the input file {}, found {}",
                                  shown(input), shown(part.name)));
    }
  }

  void name_parts() {
    Owners owners;
    for (const AnyPart& any : lecture_.parts()) check_name(part_of(any), owners);
    std::map<std::string, int> tried;  // by base: the numbers that are nobody's any more
    const auto give = [&](LecturePart& part, const std::string& base) {
      if (part.name.empty()) part.name = free_name(part, base, owners, tried[lowered(base)]);
      owners.emplace(lowered(part.name), &part);
    };
    for (LectureFigure& figure : lecture_.figures) give(figure, figure.spec.topic->name);
    for (LectureRender& render : lecture_.renders) give(render, base_name(render));
  }

  /// A render's name where the lecture gives none: its model's, when that is one.
  static std::string base_name(const LectureRender& render) {
    const std::string stem = fs::path(render.files.front()).stem().string();
    return is_name(stem) && lowered(stem) != pages_folder && stem.size() <= 70 ? stem : "render";
  }

  /// `base`, then with "_2", "_3", …; `taken`: up to this number each has an owner.
  std::string free_name(const LecturePart& part, const std::string& base, const Owners& owners,
                        int& taken) const {
    for (int number = taken + 1;; ++number) {
      std::string name = number == 1 ? base : fmt::format("{}_{}", base, number);
      const bool is_taken = owners.contains(lowered(name));
      if (is_taken && number == taken + 1) taken = number;
      if (!is_taken && input_called(name, part).empty()) return name;
    }
  }

  const LectureFile& file_;
  const std::map<std::string, std::string>& instead_;  ///< flags
  std::set<const TopicEntry*> topics_;                 ///< of all figures, also those that are not whole
};

}  // namespace

Lecture read_lecture(const LectureFile& file, const std::map<std::string, std::string>& instead) {
  return LectureReader(file, instead).read();
}

}  // namespace gradus::cli
