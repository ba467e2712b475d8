#include "check/expected.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "stories/point_text.hpp"

namespace gradus::check {
namespace {

std::uint64_t key_of(ivec2 cell) {
  return std::uint64_t{static_cast<std::uint32_t>(cell.x)} << 32 | static_cast<std::uint32_t>(cell.y);
}

/// The step in which each cell is first drawn as one that was taken.
std::unordered_map<std::uint64_t, std::int64_t> steps_of_cells(const Trace& trace) {
  std::unordered_map<std::uint64_t, std::int64_t> steps;
  for (const TraceStep& step : trace.steps) {
    for (const CellChange& change : step.delta.cells) {
      const bool taken =
          change.look && change.look->role != Role::candidate && change.look->role != Role::rejected;
      if (taken) steps.try_emplace(key_of(change.at), step.number.step);
    }
  }
  return steps;
}

void add_pixels(ExpectedList& list, const Trace& trace) {
  const auto steps = steps_of_cells(trace);
  for (const ivec2 pixel : trace.pixels) {
    const auto step = steps.find(key_of(pixel));
    list.elements.push_back({{pixel}, step == steps.end() ? trace.last : step->second});
  }
}

/// "x" of "A.x".
std::string_view behind_the_point(std::string_view name) {
  const std::size_t point = name.rfind('.');
  return point == std::string_view::npos ? std::string_view() : name.substr(point + 1);
}

/// Those of the result.
void add_places(ExpectedList& list, const Trace& trace) {
  Element element;
  for (const Field& field : trace.result) {
    if (behind_the_point(field.name) != list.fields[element.size()]) continue;
    element.push_back(field.value);
    if (element.size() < list.fields.size()) continue;
    list.elements.push_back({std::move(element), trace.last});
    element.clear();
  }
}

ExpectedList list_of(const Asked& asked, const Trace& trace) {
  ExpectedList list{.name = asked.name, .same = asked.same, .fields = asked.fields};
  if (asked.type == plotted) {
    add_pixels(list, trace);
    return list;
  }
  if (asked.type.empty()) {
    add_places(list, trace);
    return list;
  }
  for (const TraceStep& step : trace.steps) {
    if (step.type != asked.type) continue;
    const Values values = values_of(step);
    if (!asked.where.empty() && value_as<bool>(values, asked.where) != true) continue;
    Element element;
    for (const std::string& field : asked.fields) {
      const Value* value = value_of(values, field);
      if (field == "key")
        element.emplace_back(step.key);
      else if (value)
        element.push_back(*value);
    }
    if (element.size() == asked.fields.size())
      list.elements.push_back({std::move(element), step.number.step});
  }
  return list;
}

std::optional<ivec2> cell_in(std::string_view key) {
  const auto pair = pair_in(key);
  const auto x = pair ? whole_number(pair->x) : std::nullopt, y = pair ? whole_number(pair->y) : std::nullopt;
  const auto fits = [](std::int64_t n) { return INT32_MIN <= n && n <= INT32_MAX; };
  if (!x || !y || !fits(*x) || !fits(*y)) return std::nullopt;
  return ivec2(static_cast<int>(*x), static_cast<int>(*y));
}

}  // namespace

Values values_of(const TraceStep& step) {
  Values values = step.fields;
  const Value* own = value_of(values, "pixel");
  const auto cell =
      own ? std::get_if<ivec2>(own) ? std::optional(std::get<ivec2>(*own)) : std::nullopt : cell_in(step.key);
  if (!cell) return values;
  const auto add = [&](const char* name, Value value) {
    if (!value_of(values, name)) values.push_back({name, std::move(value)});
  };
  add("pixel", *cell);
  add("x", std::int64_t{cell->x});
  add("y", std::int64_t{cell->y});
  return values;
}

Expected expected_of(const TopicEntry& topic, const Trace& trace) {
  Expected expected{.values = trace.result, .lists = {}, .steps = {}};
  if (topic.checking) {
    for (const Asked& asked : topic.checking->asked) {
      if (asked.method.empty() || asked.method == trace.method)
        expected.lists.push_back(list_of(asked, trace));
    }
  }
  for (const TraceStep& step : trace.steps) {
    if (step.number.fine == 0) expected.steps.push_back(&step);
  }
  return expected;
}

bool agree(const Value& a, const Value& b, double tolerance) {
  const auto real = [](const Value& v) -> std::optional<double> {
    if (const auto* whole = std::get_if<std::int64_t>(&v)) return static_cast<double>(*whole);
    if (const auto* number = std::get_if<double>(&v)) return *number;
    return std::nullopt;
  };
  if (a.index() == b.index() && !std::holds_alternative<double>(a)) return a == b;
  const auto x = real(a), y = real(b);
  if (!x || !y) return false;
  return *x == *y || std::abs(*x - *y) <= tolerance || (std::isnan(*x) && std::isnan(*y));
}

bool agree(const Element& a, const Element& b, double tolerance) {
  return std::ranges::equal(a, b, [&](const Value& x, const Value& y) { return agree(x, y, tolerance); });
}

std::string text_of(const Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *whole);
  if (const auto* real = std::get_if<double>(&value)) return fmt::format("{:.10g}", *real);
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  if (const auto* cell = std::get_if<ivec2>(&value)) return fmt::format("({}, {})", cell->x, cell->y);
  return shown(std::get<std::string>(value));
}

std::string text_of(const Element& element) {
  std::string all;
  for (const Value& value : element) all += (all.empty() ? "" : ", ") + text_of(value);
  return element.size() == 1 ? all : "(" + all + ")";
}

}  // namespace gradus::check
