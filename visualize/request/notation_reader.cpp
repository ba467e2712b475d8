#include "request/notation_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "figure/text/metrics.hpp"
#include "figure/text/wording.hpp"
#include "request/complaint.hpp"
#include "request/names.hpp"
#include "request/words.hpp"
#include "stories/notations.hpp"
#include "stories/point_text.hpp"
#include "stories/topic.hpp"

namespace gradus {
namespace {

using Kind = JsonNode::Kind;
using NotationTexts = std::vector<std::string>;

class NotationReader {
 public:
  explicit NotationReader(std::vector<NotationMistake>& mistakes) : mistakes_(mistakes) {}

  Notation read(const JsonNode& node) {
    if (node.kind != Kind::object) {
      complain(node, "", "an object like {\"symbols\": {\"p\": \"d\"}}", described(node));
      return {};
    }
    notation_.name = json_on_one_line(node);
    for (const JsonMember& member : node.members) {
      const auto known = std::ranges::find(keys, member.key, &Key::name);
      if (known != std::end(keys)) {
        (this->*known->read)(member.value, member.key);
        continue;
      }
      NotationTexts names;
      for (const Key& key : keys) names.emplace_back(key.name);
      complain(member.value, member.key, fmt::format("one of {}", fmt::join(names, ", ")),
               shown(member.key) + suggestion(member.key, names));
    }
    return notation_;
  }

 private:
  struct Key {
    std::string_view name;
    void (NotationReader::*read)(const JsonNode& node, const std::string& way);
  };
  static const Key keys[7];

  void complain(const JsonNode& node, const std::string& way, const std::string& expected,
                const std::string& found) {
    mistakes_.push_back({node.line, way, fmt::format("expected {}, found {}", expected, found)});
  }

  // --- Symbols

  void read_symbols(const JsonNode& node, const std::string& way) {
    if (node.kind != Kind::object)
      return complain(node, way, "an object of symbols and their names like {\"p\": \"d\"}", described(node));
    // What is said of one topic goes before what is said of all
    for (const JsonMember& member : node.members) {
      if (member.value.kind == Kind::object) read_topic(member, way + "." + member.key);
    }
    for (const JsonMember& member : node.members) {
      if (member.value.kind != Kind::object) read_symbol_of_all(member, way + "." + member.key);
    }
  }

  void read_topic(const JsonMember& member, const std::string& way) {
    NotationTexts topics;
    for (const TopicEntry* topic : catalogue()) topics.push_back(topic->name);
    if (std::ranges::find(topics, member.key) == topics.end()) {
      return complain(member.value, way, "the name of a topic",
                      shown(member.key) + suggestion(member.key, topics));
    }
    const NotationTexts symbols = topic_symbols(member.key);
    for (const JsonMember& label : member.value.members) {
      const std::string here = way + "." + label.key;
      if (std::ranges::find(symbols, label.key) == symbols.end()) {
        complain(label.value, here, expected_symbol(member.key),
                 shown(label.key) + suggestion(label.key, symbols));
      } else if (is_drawable(label.value, here)) {
        add(member.key, {label.key, label.value.text});
      }
    }
  }

  void read_symbol_of_all(const JsonMember& member, const std::string& way) {
    if (!is_drawable(member.value, way)) return;
    bool used = false;
    for (const TopicEntry* topic : catalogue()) {
      const NotationTexts symbols = topic_symbols(topic->name);
      if (std::ranges::find(symbols, member.key) == symbols.end()) continue;
      add(topic->name, {member.key, member.value.text});
      used = true;
    }
    if (!used) complain(member.value, way, "a symbol of one of the topics, or a topic", shown(member.key));
  }

  void add(const std::string& topic, SymbolLabel label) {
    std::vector<SymbolLabel>& labels = notation_.symbols[topic];
    if (std::ranges::find(labels, label.symbol, &SymbolLabel::symbol) == labels.end())
      labels.push_back(std::move(label));
  }

  bool is_drawable(const JsonNode& node, const std::string& way) {
    if (node.kind != Kind::text || trimmed(node.text).empty() || node.text.find('\n') != std::string::npos) {
      complain(node, way, "a text on one line", described(node));
      return false;
    }
    if (letters_in(node.text) > longest_text) {
      complain(node, way, expected_length(), found_length(node.text));
      return false;
    }
    const auto missing = missing_glyph(node.text, Face::bold);
    if (missing) {
      complain(node, way, fmt::format("letters that can be drawn ({})", explained(*missing)),
               shown(node.text));
    }
    return !missing;
  }

  // --- Codes

  void read_bits(const JsonNode& node, const std::string& way) {
    take_bits(node, way, notation_.bits, "TBRL");
  }
  void read_bits_in_space(const JsonNode& node, const std::string& way) {
    take_bits(node, way, notation_.bits_in_space, "FNTBRL");
  }
  /// Each of these letters once, in any order.
  void take_bits(const JsonNode& node, const std::string& way, std::string& bits, std::string_view usual) {
    if (node.kind == Kind::text && std::ranges::is_permutation(node.text, usual)) {
      bits = node.text;
      return;
    }
    complain(node, way,
             fmt::format("an order of the borders like \"{}\", the first digit to the left", usual),
             described(node));
  }

  // --- Vectors and space

  /// The second of two names rather than the first.
  bool second_of(const JsonNode& node, const std::string& way, std::string_view first,
                 std::string_view second) {
    const bool known = node.kind == Kind::text && (node.text == first || node.text == second);
    if (!known) complain(node, way, fmt::format("{} or {}", first, second), described(node));
    return known && node.text == second;
  }
  void read_vectors(const JsonNode& node, const std::string& way) {
    notation_.rows = second_of(node, way, "columns", "rows");
  }
  void read_handedness(const JsonNode& node, const std::string& way) {
    notation_.handedness = second_of(node, way, "left", "right") ? Handedness::right : Handedness::left;
  }

  void read_axes(const JsonNode& node, const std::string& way) {
    if (node.kind != Kind::list || node.elements.size() != 3) {
      return complain(node, way, "names of the three axes of view space like [\"u\", \"v\", \"n\"]",
                      described(node));
    }
    std::vector<std::string> axes;
    for (const JsonNode& element : node.elements) {
      if (is_drawable(element, way)) axes.push_back(element.text);
    }
    if (axes.size() == 3) notation_.axes = axes;
  }

  void read_depth(const JsonNode& node, const std::string& way) {
    std::vector<double> planes;
    for (const JsonNode& element : node.elements) {
      const Read<Number> number = read_number(element.text);
      const Number* value = std::get_if<Number>(&number);
      if (element.kind == Kind::number && value && std::abs(value->value) <= 1000)
        planes.push_back(value->value);
    }
    if (node.kind != Kind::list || node.elements.size() != 2 || planes.size() != 2 ||
        planes[0] == planes[1]) {
      return complain(node, way, "two different numbers of at most 1000, at the near and at the far plane",
                      described(node));
    }
    notation_.depth = {planes[0], planes[1]};
  }

  std::vector<NotationMistake>& mistakes_;
  Notation notation_{};
};

const NotationReader::Key NotationReader::keys[7] = {{"symbols", &NotationReader::read_symbols},
                                                     {"bits", &NotationReader::read_bits},
                                                     {"bits_in_space", &NotationReader::read_bits_in_space},
                                                     {"vectors", &NotationReader::read_vectors},
                                                     {"handedness", &NotationReader::read_handedness},
                                                     {"axes", &NotationReader::read_axes},
                                                     {"depth", &NotationReader::read_depth}};

}  // namespace

std::vector<std::string> notation_names() {
  NotationTexts names;
  for (const Notation& notation : notations()) names.push_back(notation.name);
  return names;
}

Notation notation_in(const JsonNode& node, std::vector<NotationMistake>& mistakes) {
  return NotationReader(mistakes).read(node);
}

Notation notation_in_text(std::string_view text, const std::string& called) {
  std::vector<NotationMistake> mistakes;
  Notation notation = notation_in(read_json(text, "--notation: " + called), mistakes);
  if (mistakes.empty()) return notation;
  const NotationMistake& first = mistakes.front();
  refuse_usage(fmt::format("--notation: {}:{}: {}{}{}", called, first.line, shown_name(first.way),
                           first.way.empty() ? "" : ": ", first.what));
}

bool is_notation_file(std::string_view text) {
  const std::string_view word = trimmed(text);
  return !word.starts_with('{') && lowered(word).ends_with(".json");
}

Notation read_notation(std::string_view text) {
  const std::string_view word = trimmed(text);
  if (word.starts_with('{')) return notation_in_text(word, "notation");
  const NotationTexts names = notation_names();
  const auto found = matching_names(word, names);
  if (found.size() == 1 && !word.empty()) return notations()[found.front()];
  refuse_flag("notation", fmt::format("one of {}, or {}", fmt::join(names, ", "), own_notation),
              shown(word) + suggestion(word, names));
}

}  // namespace gradus
