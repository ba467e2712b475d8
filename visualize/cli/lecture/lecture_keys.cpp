// The keys of a lecture, and its JSON Schema.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "cli/command_line/choices.hpp"
#include "cli/lecture/lecture.hpp"
#include "request/names.hpp"
#include "request/written_json.hpp"

namespace gradus::cli {
namespace {

using Texts = std::vector<std::string>;

/// Flags that say where to and in which format: a lecture has keys of its own for that, or none.
bool is_about_output(const Flag& flag) {
  constexpr std::array names{"output",  "format", "force",  "snippet",   "report", "part",  "why",
                             "without", "array",  "frames", "turntable", "jobs",   "engine"};
  return std::ranges::find(names, flag.name) != names.end();
}

KeyKind kind_of(const Flag& flag) {
  if (flag.value.empty()) return KeyKind::toggle;
  if (flag.name == "label") return KeyKind::labels;
  if (flag.name == "notation") return KeyKind::notation;
  for (const char* value : {"N", "DEGREES", "UNITS", "FACTOR"})
    if (flag.value == value) return KeyKind::number;
  if (flag.value == "X,Y,Z") return KeyKind::place;
  return flag.value == "LIST" || flag.value.find(',') != std::string::npos ? KeyKind::list : KeyKind::text;
}

LectureKey key_of(const Flag& flag) {
  const bool of_one_figure = flag.name == "title" || flag.name == "caption";
  std::string name = flag.name == "label" ? "labels" : folded(flag.name);
  return {std::move(name), kind_of(flag), !of_one_figure, true, flag.help};
}

std::vector<LectureKey> all_keys() {
  std::vector<LectureKey> keys{
      {"$schema", KeyKind::text, true, false, "ignored: tells editors where this schema is"},
      {"topic", KeyKind::topic, false, true, "what the figure is about: a name that `gradus list` shows"},
      {"input", KeyKind::input, false, true,
       "the topic's inputs, by name; those left out have their defaults"},
      {"method", KeyKind::method, false, true, "one of the topic's methods"},
      {"name", KeyKind::text, false, true,
       "name of the figure's folder and files: letters a-z, digits, _ and -; default: the topic's, numbered"},
      {"caption", KeyKind::text, false, true, "a sentence under the figure, on its card"},
      {"outputs", KeyKind::outputs, true, true, "the files to make; default: svg, png, pdf, html, csv, json"},
  };
  const Command& figure = *std::ranges::find(commands(), "figure", &Command::name);
  for (const Flag& flag : figure.flags) {
    const LectureKey key = key_of(flag);
    if (is_about_output(flag) || std::ranges::find(keys, key.name, &LectureKey::name) != keys.end()) continue;
    keys.push_back(key);
  }
  // The same word, once for the whole and once for a figure
  const auto title = std::ranges::find(keys, "title", &LectureKey::name);
  if (title == keys.end()) {
    keys.insert(keys.begin() + 1, {"title", KeyKind::text, true, false, "heads the page of all figures"});
  } else {
    title->of_lecture = true;
    title->help = "of the lecture: heads the page of all figures; of a figure: " + title->help;
  }
  keys.push_back({"figures", KeyKind::figures, true, false, "the figures, in the order of the page"});
  keys.push_back({"renders", KeyKind::renders, true, false, "rendered models, after the figures"});
  return keys;
}

std::vector<LectureKey> all_render_keys() {
  std::vector<LectureKey> keys{
      {"model", KeyKind::text, false, false,
       "the model: an OBJ file, with the materials that lie beside it, or a scene of several: a JSON file"},
      {"name", KeyKind::text, false, false,
       "name of the render's folder and files: letters a-z, digits, _ and -; default: the model's, numbered"},
      {"title", KeyKind::text, false, false, "heads its card"},
      {"caption", KeyKind::text, false, false, "a sentence under the picture, on its card"},
  };
  const Command& render = *std::ranges::find(commands(), "render", &Command::name);
  for (const Flag& flag : render.flags) {
    if (!is_about_output(flag)) keys.push_back({folded(flag.name), kind_of(flag), false, false, flag.help});
  }
  return keys;
}

// --- Schema ------------------------------------------------------------------------------------------------

JsonNode type(const Texts& names) { return names.size() == 1 ? json_text(names[0]) : json_texts(names); }

JsonNode list_of(JsonNode items) {
  return json_object(
      {{"type", 0, json_text("array")}, {"items", 0, std::move(items)}, {"minItems", 0, json_number("1")}});
}

/// So many of these types.
JsonNode tuple_of(std::size_t count, const Texts& types) {
  const JsonNode size = json_number(std::to_string(count));
  return json_object({{"type", 0, json_text("array")},
                      {"items", 0, json_object({{"type", 0, type(types)}})},
                      {"minItems", 0, size},
                      {"maxItems", 0, size}});
}

JsonNode either(std::vector<JsonNode> schemas) {
  return json_object({{"anyOf", 0, json_list(std::move(schemas))}});
}

JsonNode of_type(const Texts& names) { return json_object({{"type", 0, type(names)}}); }

JsonNode one_of(const Texts& names) { return json_object({{"enum", 0, json_texts(names)}}); }

Texts topic_names() {
  Texts names;
  for (const TopicEntry* topic : catalogue()) names.push_back(topic->name);
  return names;
}

Texts output_names() {
  const auto names = format_names();
  return {names.begin(), names.end()};
}

/// A notation of one's own: see notation_in.
JsonNode notation_schema() {
  const JsonNode names = of_type({"string"});
  const JsonNode by_topic =
      json_object({{"type", 0, json_text("object")}, {"additionalProperties", 0, names}});
  const JsonNode symbols =
      json_object({{"type", 0, json_text("object")}, {"additionalProperties", 0, either({names, by_topic})}});
  return json_object({{"type", 0, json_text("object")},
                      {"properties", 0,
                       json_object({{"symbols", 0, symbols},
                                    {"bits", 0, names},
                                    {"bits_in_space", 0, names},
                                    {"vectors", 0, one_of({"columns", "rows"})},
                                    {"handedness", 0, one_of({"left", "right"})},
                                    {"axes", 0, tuple_of(3, {"string"})},
                                    {"depth", 0, tuple_of(2, {"number"})}})},
                      {"additionalProperties", 0, json_truth(false)}});
}

JsonNode schema_of(const LectureKey& key) {
  switch (key.kind) {
    case KeyKind::text: {
      const Texts choices = choices_of(key.name);
      if (key.name == "name") {
        return json_object({{"type", 0, json_text("string")},
                            {"pattern", 0, json_text("^[A-Za-z0-9_][A-Za-z0-9_-]{0,79}$")}});
      }
      return choices.empty() ? of_type({"string"}) : one_of(choices);
    }
    case KeyKind::number:
      return of_type({"number", "string"});
    case KeyKind::toggle:
      return of_type({"boolean"});
    case KeyKind::list:
      return either({of_type({"string", "number"}), list_of(of_type({"string", "number"}))});
    case KeyKind::place:
      return either({of_type({"string"}), tuple_of(3, {"string", "number"})});
    case KeyKind::labels:
      return json_object(
          {{"type", 0, json_text("object")}, {"additionalProperties", 0, of_type({"string"})}});
    case KeyKind::notation:
      return either({of_type({"string"}), notation_schema()});
    case KeyKind::topic:
      return one_of(topic_names());
    case KeyKind::method:
      return of_type({"string"});
    case KeyKind::input:
      return of_type({"object"});
    case KeyKind::outputs:
      return either({one_of(output_names()), list_of(one_of(output_names()))});
    case KeyKind::figures:
      return list_of(json_object({{"$ref", 0, json_text("#/$defs/figure")}}));
    case KeyKind::renders:
      return list_of(json_object({{"$ref", 0, json_text("#/$defs/render")}}));
  }
  return of_type({"string"});
}

JsonNode with_description(JsonNode schema, const std::string& text) {
  schema.members.insert(schema.members.begin(), {"description", 0, json_text(text)});
  return schema;
}

/// A face in space as an object.
JsonNode face_schema() {
  return json_object({{"type", 0, json_text("object")},
                      {"properties", 0,
                       json_object({{"name", 0, of_type({"string"})},
                                    {"color", 0, of_type({"string"})},
                                    {"points", 0, list_of(tuple_of(3, {"number"}))}})},
                      {"required", 0, json_texts({"points"})},
                      {"additionalProperties", 0, json_truth(false)}});
}

JsonNode schema_of(const Parameter& parameter) {
  switch (parameter.type) {
    case ParameterType::cell:
      return either({of_type({"string"}), tuple_of(2, {"integer"})});
    case ParameterType::window:
      return either({of_type({"string"}), tuple_of(4, {"integer"})});
    case ParameterType::integer:
      return either(
          {of_type({"string"}), json_object({{"type", 0, json_text("integer")},
                                             {"minimum", 0, json_number(std::to_string(parameter.least))},
                                             {"maximum", 0, json_number(std::to_string(parameter.most))}})});
    case ParameterType::number:
      return of_type({"string", "number"});
    case ParameterType::numbers:
    case ParameterType::bounds:
      return either({of_type({"string"}), tuple_of(parameter.parts.size(), {"number"})});
    case ParameterType::points:
      return either({of_type({"string"}), list_of(tuple_of(parameter.parts.size(), {"number"}))});
    case ParameterType::rings: {
      const JsonNode ring = list_of(tuple_of(parameter.parts.size(), {"number"}));
      return either({of_type({"string"}), ring, list_of(ring)});
    }
    case ParameterType::faces:
      return either({of_type({"string"}), list_of(face_schema())});
    case ParameterType::order: {
      const JsonNode names = list_of(one_of(parameter.choices));
      if (!parameter.numbered) return either({of_type({"string"}), names});
      return either({of_type({"string"}), names, list_of(of_type({"integer"}))});
    }
    case ParameterType::choice: {
      std::vector<JsonNode> names;
      for (const std::string& choice : parameter.choices) {
        names.push_back(json_text(choice));
        if (choice.find_first_not_of("0123456789") == std::string::npos) names.push_back(json_number(choice));
      }
      return json_object({{"enum", 0, json_list(std::move(names))}});
    }
    case ParameterType::flag:
      return of_type({"boolean"});
    case ParameterType::maze:
      return either({of_type({"string"}), list_of(of_type({"string"}))});
    default:
      return of_type({"string"});
  }
}

/// If the figure is about this topic, its inputs and methods are these.
JsonNode rule_of(const TopicEntry& topic) {
  std::vector<JsonMember> inputs;
  for (const Parameter& parameter : topic.parameters) {
    inputs.push_back({parameter.name, 0, with_description(schema_of(parameter), parameter.help)});
  }
  Texts methods;
  for (const Method& method : topic.methods) methods.push_back(method.name);
  const JsonNode is_this = json_object(
      {{"properties", 0, json_object({{"topic", 0, json_object({{"const", 0, json_text(topic.name)}})}})}});
  const JsonNode input = json_object(
      {{"properties", 0, json_object(std::move(inputs))}, {"additionalProperties", 0, json_truth(false)}});
  return json_object({{"if", 0, is_this},
                      {"then", 0,
                       json_object({{"properties", 0,
                                     json_object({{"input", 0, input}, {"method", 0, one_of(methods)}})}})}});
}

JsonMember property(const LectureKey& key) {
  return {key.name, 0, with_description(schema_of(key), key.help)};
}

/// The keys of a lecture, or of a figure.
JsonNode properties(bool LectureKey::* where) {
  std::vector<JsonMember> members;
  for (const LectureKey& key : lecture_keys()) {
    if (key.*where) members.push_back(property(key));
  }
  return json_object(std::move(members));
}

JsonNode render_schema() {
  std::vector<JsonMember> members;
  for (const LectureKey& key : render_keys()) members.push_back(property(key));
  return json_object({{"type", 0, json_text("object")},
                      {"properties", 0, json_object(std::move(members))},
                      {"required", 0, json_texts({"model"})},
                      {"additionalProperties", 0, json_truth(false)}});
}

}  // namespace

std::span<const LectureKey> lecture_keys() {
  static const std::vector<LectureKey> keys = all_keys();
  return keys;
}

std::span<const LectureKey> render_keys() {
  static const std::vector<LectureKey> keys = all_render_keys();
  return keys;
}

std::string lecture_schema() {
  std::vector<JsonNode> rules;
  for (const TopicEntry* topic : catalogue()) rules.push_back(rule_of(*topic));
  const JsonNode figure = json_object({{"type", 0, json_text("object")},
                                       {"properties", 0, properties(&LectureKey::of_figure)},
                                       {"required", 0, json_texts({"topic", "input"})},
                                       {"additionalProperties", 0, json_truth(false)},
                                       {"allOf", 0, json_list(std::move(rules))}});
  return write_json(json_object(
      {{"$schema", 0, json_text("https://json-schema.org/draft/2020-12/schema")},
       {"title", 0, json_text("A lecture for `gradus figures`")},
       {"description", 0,
        json_text("Which figures to make, with which inputs and in which look, and which models to render. "
                  "Keys beside \"figures\" are defaults that each figure can override.")},
       {"type", 0, json_text("object")},
       {"properties", 0, properties(&LectureKey::of_lecture)},
       {"anyOf", 0,
        json_list({json_object({{"required", 0, json_texts({"figures"})}}),
                   json_object({{"required", 0, json_texts({"renders"})}})})},
       {"additionalProperties", 0, json_truth(false)},
       {"$defs", 0, json_object({{"figure", 0, figure}, {"render", 0, render_schema()}})}}));
}

}  // namespace gradus::cli
