#include "json/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>

#include "figure/seen_cells.hpp"
#include "figure/text/markup.hpp"
#include "figure/text/metrics.hpp"
#include "figure/text/typesetting.hpp"
#include "json/drawing_json.hpp"
#include "json/script_safe.hpp"

namespace gradus {
namespace {

using json::Json;
using json::mark_json;

// -- Text -----------------------------------------------------------------------------------------

/// One line. A byte that is no UTF-8 becomes U+FFFD; a number that JSON lacks (nan, inf) becomes null.
std::string text_of(const Json& json) {
  return script_safe(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// An object as lines, one per member; the members given last as a list of lines, one per element.
class Lines {
 public:
  explicit Lines(bool indented) : indent_(indented ? "  " : "") {}

  void member(std::string_view name, const Json& value) { begin(name) += text_of(value); }
  template <class List, class ToJson>
  void list(std::string_view name, const List& list, ToJson to_json) {
    begin(name) += "[";
    const char* separator = "\n";
    for (const auto& element : list) {
      text_ += separator + indent_ + indent_ + text_of(to_json(element));
      separator = ",\n";
    }
    text_ += list.empty() ? "]" : "\n" + indent_ + "]";
  }
  std::string finish() && { return std::move(text_) + "\n}\n"; }

 private:
  std::string& begin(std::string_view name) {
    text_ += text_.empty() ? "{\n" : ",\n";
    return text_ += indent_ + json_quoted(name) + (indent_.empty() ? ":" : ": ");
  }
  std::string indent_, text_;
};

// -- Values ---------------------------------------------------------------------------------------

Json point(ivec2 p) { return Json::array({p.x, p.y}); }

Json value_json(const Value& value) {
  return std::visit(
      [](const auto& v) -> Json {
        if constexpr (std::same_as<std::remove_cvref_t<decltype(v)>, ivec2>) {
          return point(v);
        } else {
          return v;
        }
      },
      value);
}

/// Adds fields to an object; a field that is called like a member which stands already gets a "_" after its
/// name.
void put_fields(Json& object, const std::vector<Field>& fields) {
  for (const Field& field : fields) {
    std::string name = field.name;
    while (object.contains(name)) name += '_';
    object[name] = value_json(field.value);
  }
}

Json fields_json(const std::vector<Field>& fields) {
  Json object = Json::object();
  put_fields(object, fields);
  return object;
}

std::string_view name_of(Level level) {
  constexpr std::array<std::string_view, 3> names{"idea", "step", "arithmetic"};
  return names[static_cast<std::size_t>(level)];
}

std::string_view name_of(ParameterType type) {
  constexpr std::array<std::string_view, 18> names{
      "cell",    "window", "integer", "choice", "color", "paint",   "picture", "maze",  "number",
      "numbers", "bounds", "points",  "rings",  "order", "factors", "faces",   "model", "flag"};
  return names[static_cast<std::size_t>(type)];
}

std::string_view name_of(Standing standing) {
  constexpr std::array<std::string_view, 4> names{"plain", "taught", "fast", "faulty"};
  return names[static_cast<std::size_t>(standing)];
}

// -- The drawing ----------------------------------------------------------------------------------

/// A list's elements, each as `to_json` has it.
Json list_of(const auto& list, const auto& to_json) {
  Json out = Json::array();
  for (const auto& element : list) out.push_back(to_json(element));
  return out;
}

template <class Marks>
Json marks_json(const Marks& marks) {
  return list_of(marks, mark_json);
}

/// Cells as runs of one look.
class Runs {
 public:
  void add(ivec2 at, const std::optional<CellLook>& look) {
    if (count_ > 0 && at.y == start_.y && at.x == start_.x + count_ && look == look_) {
      ++count_;
      return;
    }
    flush();
    start_ = at;
    look_ = look;
    count_ = 1;
  }
  Json finish() && {
    flush();
    return std::move(out_);
  }

 private:
  void flush() {
    if (count_ == 0) return;
    out_.push_back(json::run_json(start_, count_, look_));
  }
  ivec2 start_{0, 0};
  std::int64_t count_ = 0;
  std::optional<CellLook> look_;
  Json out_ = Json::array();
};

/// The drawing before the first recorded step, where the recording doesn't start with the run.
Json before_json(const Trace& trace) {
  Runs runs;
  for (const Window& window : windows_to_look_in(trace)) {
    for (std::int64_t y = window.lower.y; y <= window.upper.y; ++y) {
      for (std::int64_t x = window.lower.x; x <= window.upper.x; ++x) {
        const ivec2 p{static_cast<int>(x), static_cast<int>(y)};
        if (const auto look = trace.before.at(p)) runs.add(p, look);
      }
    }
  }
  const auto named_mark_json = [](const auto& named) { return mark_json(named.second); };
  Json out{{"cells", std::move(runs).finish()}, {"set", list_of(trace.before.marks(), named_mark_json)}};
  if (trace.before.plane()) out["plane"] = true;
  return out;
}

Json grid_json(const Grid& grid) {
  const auto [lower, upper] = grid.cells;
  Json out{{"lower", point(lower)}, {"upper", point(upper)}, {"y_up", grid.y_up}};
  out.update({{"x_name", grid.x_name}, {"y_name", grid.y_name}});
  if (grid.whole) out["whole"] = true;
  if (!grid.axes) out["axes"] = false;
  if (grid.on_lines) out["on_lines"] = true;
  if (grid.part) out["part"] = {{"lower", point(grid.part->lower)}, {"upper", point(grid.part->upper)}};
  if (grid.lines > 0) out["lines"] = grid.lines;
  if (grid.shelf > 0) out["shelf"] = grid.shelf;
  if (grid.picture) out["picture"] = json::picture_json(*grid.picture);
  return out;
}

// -- Steps ----------------------------------------------------------------------------------------

/// What a step asks, all answers and which one it gives, and its kind of branch where it has one.
Json decision_json(const Decision& decision) {
  Json out{{"question", decision.question}, {"answers", decision.answers}, {"answer", decision.answer}};
  if (!decision.branch.empty()) out["branch"] = decision.branch;
  return out;
}

/// Parts that a step doesn't have are left out, and those that no slot shows. The fields repeat the table's
/// values: they go with it.
Json step_json(const TraceStep& step, const std::set<Slot>& slots) {
  Json out{{"number", text_of(step.number)}};
  const auto put = [&](Slot slot, const char* name, Json value) {
    if (slots.contains(slot) && !value.empty()) out[name] = std::move(value);
  };
  const auto put_text = [&](Slot slot, const char* name, const std::string& text) {
    if (slots.contains(slot) && !text.empty()) out[name] = text;
  };
  out["level"] = name_of(step.level);
  put_text(Slot::listing, "type", step.type);
  put_text(Slot::footer, "phase", step.phase);
  put_text(Slot::drawing, "key", step.key);
  if (slots.contains(Slot::listing) && step.line != 0) out["line"] = step.line;
  put(Slot::table, "fields", fields_json(step.fields));
  put_text(Slot::sentence, "sentence", step.sentence);
  if (step.decision) put(Slot::sentence, "decision", decision_json(*step.decision));
  put(Slot::table, "read", step.read);
  put(Slot::table, "row", step.row);
  if (!slots.contains(Slot::drawing)) return out;
  if (step.delta.plane) out["plane"] = *step.delta.plane;
  put(Slot::drawing, "removed", step.delta.removed);
  Runs runs;
  for (const CellChange& change : step.delta.cells) runs.add(change.at, change.look);
  put(Slot::drawing, "cells", std::move(runs).finish());
  put(Slot::drawing, "set", marks_json(step.delta.set));
  out["focus"] = point(step.focus);
  return out;
}

/// number, type, line, then the step's fields. `number` is always a whole number; what is step 4.2 elsewhere
/// has "number": 4, "fine": 2, since as JSON numbers 4.1 and 4.10 would be one. A step of no line has "line":
/// null.
Json run_step_json(const TraceStep& step) {
  Json out{{"number", step.number.step}};
  if (step.number.fine != 0) out["fine"] = step.number.fine;
  out["type"] = step.type;
  out["line"] = step.line == 0 ? Json() : Json(step.line);
  put_fields(out, step.fields);
  return out;
}

Json input_json(const Trace& trace) {
  Json input = Json::object();
  for (const Argument& argument : trace.arguments) {
    if (argument.name != "method") input[argument.name] = argument.value;
  }
  return input;
}

Json recorded_json(const Trace& trace) {
  Json out{{"from", Json()}, {"to", Json()}, {"of", trace.last}};
  if (!trace.steps.empty()) {
    out["from"] = trace.steps.front().number.step;
    out["to"] = trace.steps.back().number.step;
  }
  return out;
}

Json points_json(const std::vector<ivec2>& points) {
  return list_of(points, [](ivec2 p) { return point(p); });
}
Json slots_json(const std::set<Slot>& slots) {
  return list_of(slots, [](Slot slot) { return name_of(slot); });
}
Json lines_json(const std::vector<SourceLine>& lines) {
  return list_of(lines, [](const SourceLine& l) { return Json::array({l.number, l.text}); });
}

void put_title(Lines& out, const Trace& trace) {
  out.member("title", trace.title);
  out.member("subtitle", trace.subtitle);
  out.member("method_title", trace.method_title);
}

void put_listing(Lines& out, const Trace& trace) {
  out.member("source_file", trace.source_file);
  out.member("listing", lines_json(trace.listing));
  // What a fault changes; who does not know it shows the listing that ran
  Json added = Json::array();
  for (const SourceLine& l : trace.listing)
    if (l.change == Change::added) added.push_back(l.number);
  if (trace.struck.empty() && added.empty()) return;
  out.member("difference", Json{{"struck", lines_json(trace.struck)}, {"added", added}});
}

Json columns_json(const Trace& trace) {
  Json columns = Json::array();
  for (std::size_t c = 0; c < trace.columns.size(); ++c) {
    columns.push_back({{"id", trace.columns[c].id},
                       {"name", trace.columns[c].name},
                       {"numeric", trace.columns[c].numeric},
                       {"widest", c < trace.widest.size() ? trace.widest[c] : ""}});
    if (!trace.columns[c].quantity.empty()) columns.back()["quantity"] = trace.columns[c].quantity;
  }
  return columns;
}

/// What is set in italics, and what has a colour of its own: by its symbol in the code and the reader's name.
Json names_json(const Trace& trace) {
  Json quantities = Json::array();
  for (std::size_t i = 0; i < std::min<std::size_t>(trace.quantities.size(), quantity_colors); ++i) {
    const std::string& symbol = trace.quantities[i];
    quantities.push_back({{"symbol", symbol}, {"name", trace.wording.symbol(symbol)}});
  }
  return {{"variables", variables_of(trace)}, {"quantities", quantities}};
}

/// [parameter, [its numbers], [x, y], [dx, dy for each number]] each
Json handles_json(const std::vector<Handle>& handles) {
  return list_of(handles, [](const Handle& h) {
    return Json::array({h.parameter, h.numbers, Json::array({h.at.x, h.at.y}), json::points_json(h.along)});
  });
}

void put_drawing(Lines& out, const Trace& trace, bool with_legend) {
  Json roles = Json::array(), legend = Json::array();
  for (const Role role : all_roles) roles.push_back(name_of(role));
  for (const LegendEntry& e : trace.legend) {
    Json entry = Json::array({static_cast<int>(e.role), e.text});
    if (e.color) entry.push_back(json::hex(*e.color));
    legend.push_back(std::move(entry));
  }
  out.member("roles", roles);
  if (with_legend) out.member("legend", legend);
  out.member("grid", grid_json(trace.grid));
  out.member("backdrop", marks_json(trace.backdrop));
  if (!trace.handles.empty()) out.member("handles", handles_json(trace.handles));
  const bool from_the_start = trace.steps.empty() || trace.steps.front().number == StepNumber{};
  if (!from_the_start) out.member("before", before_json(trace));
}

/// `ignores`: parameters that it lacks, or takes no notice of.
Json method_json(const TopicEntry& topic, const Method& method) {
  Json out{{"name", method.name},
           {"title", method.title},
           {"standing", name_of(method.standing)},
           {"note", method.note}};
  std::vector<std::string> ignores = method.without;
  ignores.insert(ignores.end(), method.unread.begin(), method.unread.end());
  const auto& all = topic.parameters;
  if (!method.exact && std::ranges::count(all, "exact", &Parameter::name) > 0) ignores.push_back("exact");
  if (!ignores.empty()) out["ignores"] = ignores;
  return out;
}

}  // namespace

std::string json_quoted(std::string_view text) { return text_of(Json(text)); }

std::string trace_json(const Trace& trace, const std::set<Slot>& slots) {
  const auto shows = [&slots](Slot slot) { return slots.contains(slot); };
  Lines out(false);
  out.member("schema", trace_schema);
  if (slots.size() < all_slots.size()) out.member("slots", slots_json(slots));
  out.member("topic", trace.topic);
  out.member("method", trace.method);
  if (shows(Slot::title)) put_title(out, trace);
  if (!trace.faulty.empty()) out.member("faulty", trace.faulty);
  if (shows(Slot::sentence)) out.member("goal", trace.goal);
  const auto pair_of = [](const Argument& a) { return Json::array({a.name, a.value}); };
  out.member("arguments", list_of(trace.arguments, pair_of));
  if (!trace.input_hash.empty()) out.member("input_hash", trace.input_hash);
  out.member("names", names_json(trace));
  if (shows(Slot::listing)) put_listing(out, trace);
  if (shows(Slot::table)) out.member("columns", columns_json(trace));
  if (shows(Slot::drawing)) put_drawing(out, trace, shows(Slot::footer));
  out.member("last", trace.last);
  out.member("telling", text_of(trace.telling));
  out.list("steps", trace.steps, [&slots](const TraceStep& step) { return step_json(step, slots); });
  if (shows(Slot::table)) out.member("result", fields_json(trace.result));
  return std::move(out).finish();
}

std::string alignment_json(const Alignment& alignment) {
  Json pairs = Json::array();
  for (const StepPair& pair : alignment.pairs) pairs.push_back({text_of(pair.a), text_of(pair.b)});
  const Json parting = alignment.parting ? Json(text_of(alignment.pairs[*alignment.parting].a)) : Json();
  return text_of(Json{{"pairs", pairs}, {"parting", parting}});
}

std::string run_json(const Trace& trace) {
  Lines out(true);
  out.member("topic", trace.topic);
  out.member("method", trace.method);
  if (!trace.faulty.empty()) out.member("faulty", trace.faulty);
  out.member("input", input_json(trace));
  if (!trace.input_hash.empty()) out.member("input_hash", trace.input_hash);
  if (!trace.whole()) out.member("recorded", recorded_json(trace));
  out.list("steps", trace.steps, run_step_json);
  Json result = Json::object();
  result["pixels"] = points_json(trace.pixels);
  put_fields(result, trace.result);
  out.member("result", result);
  return std::move(out).finish();
}

std::string list_json(std::span<const TopicEntry* const> topics) {
  Lines out(true);
  out.member("schema", trace_schema);
  out.list("topics", topics, [](const TopicEntry* topic) {
    const Json methods = list_of(topic->methods, [&](const Method& m) { return method_json(*topic, m); });
    Json parameters = Json::array();
    for (const Parameter& p : topic->parameters) {
      Json parameter{{"name", p.name},
                     {"type", name_of(p.type)},
                     {"default", p.default_value},
                     {"example", p.example},
                     {"help", p.help}};
      if (p.type == ParameterType::integer || p.type == ParameterType::cell ||
          p.type == ParameterType::number) {
        parameter["least"] = p.least;
        parameter["most"] = p.most;
      }
      if (p.sizes.limited()) parameter["sizes"] = {p.sizes.least, p.sizes.most};
      if (!p.choices.empty()) parameter["choices"] = p.choices;
      if (!p.parts.empty()) parameter["parts"] = p.parts;
      if (!p.instead_of.empty()) parameter["instead_of"] = p.instead_of;
      parameters.push_back(std::move(parameter));
    }
    return Json{{"name", topic->name},
                {"title", topic->title},
                {"chapter", topic->chapter},
                {"aliases", topic->aliases},
                {"summary", topic->summary},
                {"methods", methods},
                {"default_method", topic->default_method},
                {"parameters", parameters},
                {"examples", topic->examples}};
  });
  return std::move(out).finish();
}

}  // namespace gradus
