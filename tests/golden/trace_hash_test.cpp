// Traces are the same on every compiler: their hashes are committed, and this runs in every build.
// GRADUS_UPDATE_GOLDEN=1 writes the file anew.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <string>

#include "figure/figure.hpp"
#include "figure/layout/layout.hpp"
#include "support/example_traces.hpp"
#include "support/sanitized.hpp"

namespace gradus {
namespace {

std::string text_of_value(const Value& value) {
  return std::visit(
      [](const auto& v) {
        if constexpr (std::same_as<std::decay_t<decltype(v)>, ivec2>) {
          return fmt::format("({},{})", v.x, v.y);
        } else {
          return fmt::format("{}", v);
        }
      },
      value);
}

std::string text_of_pixels(const Image& image) {
  std::string text;
  for (const Rgba8& c : image.cells()) text += fmt::format("{:02x}{:02x}{:02x}{:02x}", c.r, c.g, c.b, c.a);
  return text;
}

std::string text_of_shape(const Mark& mark) {
  std::string text;
  const auto point = [&text](dvec2 p) { text += fmt::format(" {} {}", p.x, p.y); };
  const auto points = [&](const std::vector<dvec2>& all) {
    for (const dvec2 p : all) point(p);
    text += ";";
  };
  const auto flag = [&text](bool set, std::string_view name) { text += set ? name : ""; };
  if (const Dot* dot = std::get_if<Dot>(&mark.shape)) {
    point(dot->at);
    flag(dot->ring, " ring");
  } else if (const Stroke* stroke = std::get_if<Stroke>(&mark.shape)) {
    points({stroke->a, stroke->b});
    flag(stroke->arrow, " arrow");
    flag(stroke->dashed, " dashed");
    flag(stroke->thin, " thin");
  } else if (const Path* path = std::get_if<Path>(&mark.shape)) {
    points(path->points);
    flag(path->closed, " closed");
    flag(path->dashed, " dashed");
  } else if (const Area* area = std::get_if<Area>(&mark.shape)) {
    for (const auto& ring : area->rings) points(ring);
    if (area->shade > 0) text += fmt::format(" shade {}", area->shade);
  } else if (const Text* words = std::get_if<Text>(&mark.shape)) {
    point(words->at);
    text += fmt::format(" {} {}", words->text, static_cast<int>(words->align));
    if (words->line != 0) text += fmt::format(" line {}", words->line);
  } else if (const Label* label = std::get_if<Label>(&mark.shape)) {
    point(label->at);
    text += " " + label->text;
  } else if (const Picture* picture = std::get_if<Picture>(&mark.shape)) {
    points({picture->lower, picture->upper});
    text += text_of_pixels(*picture->image);
  }
  return text;
}

/// A mark stands in the order of its id, and where two texts meet the first one stays.
std::string text_of_mark(const Mark& mark) {
  const std::string quantity = mark.quantity.empty() ? "" : "|" + mark.quantity;
  return fmt::format("{}|{}|{}{}{}", mark.id, name_of(mark.role), mark.shape.index(), text_of_shape(mark),
                     quantity);
}

std::string text_of_cell(ivec2 at, const CellLook& look) {
  std::string text = fmt::format("{},{} {} {}", at.x, at.y, name_of(look.role), look.text);
  if (look.color) {
    text +=
        fmt::format("#{:02x}{:02x}{:02x}{:02x}", look.color->r, look.color->g, look.color->b, look.color->a);
  }
  return text;
}

std::uint64_t fnv1a(std::string_view text) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return hash;
}

/// The whole drawing after each step, whatever deltas it came from: the sum of what is in it, so that a step
/// costs what it changes.
class DrawingHash {
 public:
  explicit DrawingHash(const Trace& trace) : canvas_(trace.before) {
    for (const auto& [id, mark] : canvas_.marks()) sum_ += fnv1a(text_of_mark(mark));
    const Window& cells = trace.grid.cells;
    const auto size = [&](int axis) { return double{1} * cells.upper[axis] - cells.lower[axis] + 1; };
    if (size(0) * size(1) > 1e6) return;
    for (int y = cells.lower.y; y <= cells.upper.y; ++y) {
      for (int x = cells.lower.x; x <= cells.upper.x; ++x) sum_ += hash_of(ivec2{x, y});
    }
  }
  std::uint64_t after(const Delta& delta) {
    std::set<std::pair<int, int>> cells;
    std::set<std::string> ids(delta.removed.begin(), delta.removed.end());
    for (const CellChange& change : delta.cells) cells.insert({change.at.x, change.at.y});
    for (const Mark& mark : delta.set) ids.insert(mark.id);
    const auto touched = [&] {
      std::uint64_t sum = 0;
      for (const auto& [x, y] : cells) sum += hash_of(ivec2{x, y});
      for (const std::string& id : ids) sum += hash_of(id);
      return sum;
    };
    sum_ -= touched();
    canvas_.apply(delta);
    sum_ += touched();
    return sum_ + (canvas_.plane() ? 1 : 0);
  }

 private:
  std::uint64_t hash_of(ivec2 at) const {
    const auto look = canvas_.at(at);
    return look ? fnv1a(text_of_cell(at, *look)) : 0;
  }
  std::uint64_t hash_of(const std::string& id) const {
    const auto found = canvas_.marks().find(id);
    return found == canvas_.marks().end() ? 0 : fnv1a(text_of_mark(found->second));
  }

  Canvas canvas_;
  std::uint64_t sum_ = 0;
};

std::string text_of_grid(const Grid& grid) {
  const Window& cells = grid.cells;
  std::string text = fmt::format("{} {} {} {}|{}{}{}|{}|{}", cells.lower.x, cells.lower.y, cells.upper.x,
                                 cells.upper.y, grid.y_up, grid.whole, grid.axes, grid.x_name, grid.y_name);
  if (grid.picture) text += text_of_pixels(*grid.picture);
  return text;
}

/// A file of the project is the same file wherever the project lies.
std::string without_place(std::string value) {
  const std::string place = std::string(GRADUS_SOURCE_DIR) + "/";
  return value.starts_with(place) ? value.substr(place.size()) : value;
}

/// All that is shown around the steps.
std::string text_of_head(const Trace& trace) {
  std::string text =
      fmt::format("{}|{}|{}|{}|{}|{}|{}|{}\n", trace.topic, trace.title, trace.subtitle, trace.method,
                  trace.method_title, trace.faulty, trace.goal, trace.input_hash);
  for (const Argument& argument : trace.arguments)
    text += argument.name + "=" + without_place(argument.value) + "\n";
  for (const Column& column : trace.columns)
    text += fmt::format("{}|{}|{}\n", column.id, column.numeric, column.name);
  for (const LegendEntry& entry : trace.legend)
    text += fmt::format("{}|{}\n", name_of(entry.role), entry.text);
  for (const Mark& mark : trace.backdrop) text += text_of_mark(mark) + "\n";
  for (const std::string& cell : trace.widest) text += cell + "|";
  text += text_of_grid(trace.grid) + "\n" + trace.longest_sentence + "\n";
  text += fmt::format("{} {}\n", trace.last, text_of(trace.telling));
  for (const ivec2 p : trace.pixels) text += fmt::format("{},{} ", p.x, p.y);
  for (const Field& field : trace.result) text += field.name + "=" + text_of_value(field.value) + "\n";
  return text;
}

/// Everything a trace shows, but for source lines: editing a comment changes no trace.
std::string whole_text(const Trace& trace) {
  std::string text = text_of_head(trace);
  DrawingHash drawing(trace);
  for (const TraceStep& step : trace.steps) {
    text += fmt::format("{} {} {} {} {} {} {},{}\n", text_of(step.number), static_cast<int>(step.level),
                        step.type, step.phase, step.key, step.sentence, step.focus.x, step.focus.y);
    for (const Field& field : step.fields) text += field.name + "=" + text_of_value(field.value) + ";";
    for (const std::string& cell : step.read) text += cell + "|";
    text += "/";
    for (const std::string& cell : step.row) text += cell + "|";
    text += fmt::format("{:x}\n", drawing.after(step.delta));
  }
  return text;
}

/// The lines of the committed file.
std::vector<std::string> golden_lines(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

/// Its first, its telling and its last step as figures: under a sanitizer, where no test of the visualizer
/// runs.
void is_laid_out(const Trace& trace) {
  Playhead playhead(trace);
  for (const StepNumber step : {trace.steps.front().number, trace.telling, trace.steps.back().number})
    EXPECT_FALSE(lay_out(figure_of(trace, playhead, step), Look{}).shapes.empty()) << trace.topic;
}

// A line per run: its hash in English, in German, and what it is. A build with sanitizers may have a part of
// the topics; it compares the English ones.
TEST(TraceHash, IsTheCommittedOneOnThisCompiler) {
  const std::string path = std::string(GRADUS_SOURCE_DIR) + "/tests/golden/trace_hashes.txt";
  const bool update = !test::sanitized && std::getenv("GRADUS_UPDATE_GOLDEN");
  const std::vector<std::string> golden = golden_lines(path);
  std::set<std::string> in_english;
  for (const std::string& line : golden) in_english.insert(line.substr(0, 17) + line.substr(34));
  const Wording german(*find_language("de"));
  const auto runs = test::telling_runs();
  EXPECT_GT(runs.size(), 20u);
  if (!update && !test::sanitized) ASSERT_EQ(runs.size(), golden.size());
  std::string hashes;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Trace trace = runs[i].trace();
    const std::uint64_t english = fnv1a(whole_text(trace));
    const std::string name = fmt::format("{} {}, {}", trace.topic, trace.method, trace.subtitle);
    if (test::sanitized) {
      is_laid_out(trace);
      EXPECT_TRUE(in_english.contains(fmt::format("{:016x} {}", english, name))) << name;
      continue;
    }
    const std::string line =
        fmt::format("{:016x} {:016x} {}", english, fnv1a(whole_text(runs[i].trace(german))), name);
    if (update)
      hashes += line + "\n";
    else
      EXPECT_EQ(line, golden[i]);
  }
  if (update) std::ofstream(path, std::ios::binary) << hashes;
}

TEST(TraceHash, SeesEveryPart) {
  const Trace right = test::trace_of("bresenham_line");
  const std::uint64_t before = fnv1a(whole_text(right));
  const auto sees = [&](const char* part, auto change) {
    Trace trace = right;
    change(trace);
    EXPECT_NE(fnv1a(whole_text(trace)), before) << part;
  };
  const auto sees_in_drawing = [&](const char* part, Mark mark) {
    sees(part, [&](Trace& trace) { trace.steps[3].delta.set.push_back(mark); });
  };
  sees("sentence", [](Trace& t) { t.steps[3].sentence += "."; });
  sees("focus", [](Trace& t) { ++t.steps[3].focus.x; });
  sees("level", [](Trace& t) { t.steps[3].level = Level::idea; });
  sees("key", [](Trace& t) { t.steps[3].key += "0"; });
  sees("row", [](Trace& t) { t.steps[3].row.push_back(""); });
  sees("column", [](Trace& t) { t.columns[0].name += "x"; });
  sees("legend", [](Trace& t) { t.legend[0].text += "x"; });
  sees("grid", [](Trace& t) { t.grid.y_up = !t.grid.y_up; });
  sees("goal", [](Trace& t) { t.goal += "x"; });
  sees("cell", [](Trace& t) { t.steps[3].delta.cells.push_back({{5, 2}, CellLook{Role::current, "7"}}); });
  sees("bare cell", [](Trace& t) { t.steps.back().delta.cells.push_back({{0, 0}, std::nullopt}); });
  sees("plane", [](Trace& t) { t.steps[3].delta.plane = true; });
  sees("telling", [](Trace& t) { ++t.telling.step; });
  sees_in_drawing("text", {"a", Role::input, Text{{1, 2}, "x"}});
  sees_in_drawing("area", {"a", Role::input, Area{{{{1, 2}}}}});
  sees_in_drawing("dashes", {"a", Role::input, Stroke{{1, 2}, {3, 4}, false, true}});
}

TEST(TraceHash, IsOfTheDrawingWhateverDeltasItCameFrom) {
  const Trace right = test::trace_of("bresenham_line");
  Trace other = right;
  other.steps[2].delta.removed.push_back("never there");
  other.steps[2].delta.set.insert(other.steps[2].delta.set.begin(), other.steps[2].delta.set.begin(),
                                  other.steps[2].delta.set.end());
  EXPECT_EQ(fnv1a(whole_text(other)), fnv1a(whole_text(right)));
}

}  // namespace
}  // namespace gradus
