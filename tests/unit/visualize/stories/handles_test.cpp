// What of an input can be dragged: in every topic, by every method and example, each handle stands on
// something of the first drawing, names numbers that are there, and moves with them.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <regex>
#include <set>

#include "stories/handles.hpp"
#include "stories/topic.hpp"
#include "support/example_arguments.hpp"
#include "support/sanitized.hpp"

namespace gradus {
namespace {

// --- The numbers of a text, counted as the page does (visualize/web/workbench/numbers.js)

struct Written {
  std::size_t at, length;
  double value;
};

std::vector<Written> numbers_in(const std::string& text) {
  static const std::regex number(R"([-+]?(?:\d+/\d+|(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)(?![\w.]|[^;]*:))",
                                 std::regex::icase);
  std::vector<Written> numbers;
  for (std::size_t from = 0; from < text.size();) {
    const char before = from == 0 ? ' ' : text[from - 1];
    std::smatch found;
    const auto begin = text.cbegin() + static_cast<std::ptrdiff_t>(from);
    const bool free = std::isalnum(static_cast<unsigned char>(before)) == 0 && before != '_' &&
                      before != '#' && before != '.';
    if (!free ||
        !std::regex_search(begin, text.cend(), found, number, std::regex_constants::match_continuous)) {
      ++from;
      continue;
    }
    const std::string written = found.str();
    const std::size_t slash = written.find('/');
    double value = std::stod(written);
    if (slash != std::string::npos) value /= std::stod(written.substr(slash + 1));
    numbers.push_back({from, written.size(), value});
    from += written.size();
  }
  return numbers;
}

std::string with_number(const std::string& text, int number, double by) {
  const Written old = numbers_in(text).at(static_cast<std::size_t>(number));
  return text.substr(0, old.at) + fmt::format("{}", old.value + by) + text.substr(old.at + old.length);
}

TEST(NumbersOfAText, AreCountedAsThePageCountsThem) {
  const auto values = [](const std::string& text) {
    std::vector<double> list;
    for (const Written& w : numbers_in(text)) list.push_back(w.value);
    return list;
  };
  EXPECT_EQ(values("0,-1.5 1e3,1/4"), (std::vector<double>{0, -1.5, 1000, 0.25}));
  EXPECT_EQ(values("2: 0,0,1 1,0,1 1,1,1"), (std::vector<double>{0, 0, 1, 1, 0, 1, 1, 1, 1}));
  EXPECT_EQ(values("2 left #009e73: 7,8,9; A1: 3,4,5"), (std::vector<double>{7, 8, 9, 3, 4, 5}));
}

// --- What stands where

class Drawing {
 public:
  explicit Drawing(const Trace& trace) : grid_(trace.grid), canvas_(Playhead(trace).at(0)) {
    for (const Mark& mark : trace.backdrop) add(mark);
    for (const auto& [id, mark] : canvas_.marks()) add(mark);
  }

  /// A dot, a corner of a path or an area, the end of a stroke; or a cell that shows something.
  bool has_something_at(dvec2 place) const {
    const double near = 1e-6 * std::max(size().x, size().y);
    return std::ranges::any_of(points_, [&](dvec2 p) { return glm::distance(p, place) <= near; }) ||
           is_in_a_cell(place);
  }
  /// A cell of the grid, whatever it shows.
  bool has_cell_at(dvec2 place) const {
    return !canvas_.plane() && glm::round(place) == place && grid_.own().contains(ivec2(place));
  }
  dvec2 size() const { return dvec2(grid_.cells.upper) - dvec2(grid_.cells.lower) + 1.0; }

 private:
  void add(const Mark& mark) {
    if (const auto* dot = std::get_if<Dot>(&mark.shape)) points_.push_back(dot->at);
    if (const auto* stroke = std::get_if<Stroke>(&mark.shape))
      points_.insert(points_.end(), {stroke->a, stroke->b});
    if (const auto* path = std::get_if<Path>(&mark.shape))
      points_.insert(points_.end(), path->points.begin(), path->points.end());
    if (const auto* area = std::get_if<Area>(&mark.shape)) {
      for (const auto& ring : area->rings) points_.insert(points_.end(), ring.begin(), ring.end());
    }
  }
  /// The cells' borders belong to them.
  bool is_in_a_cell(dvec2 place) const {
    for (const dvec2 aside : {dvec2{-0.25, -0.25}, {0.25, -0.25}, {-0.25, 0.25}, {0.25, 0.25}}) {
      const ivec2 cell(glm::round(place + aside));
      const dvec2 off = glm::abs(place - dvec2(cell));
      if (std::max(off.x, off.y) <= 0.5 + 1e-9 && !canvas_.plane() && canvas_.at(cell)) return true;
    }
    return false;
  }

  Grid grid_;
  Canvas canvas_;
  std::vector<dvec2> points_;
};

// --- The runs

struct Drag {
  const TopicEntry* topic;
  std::vector<Argument> given;

  std::string name() const {
    std::string name = topic->name;
    for (const Argument& a : given) name += fmt::format(" --{} '{}'", a.name, a.value);
    return name;
  }
  ParameterType type_of(std::string_view parameter) const {
    return std::ranges::find(topic->parameters, parameter, &Parameter::name)->type;
  }
  /// Its first step alone.
  Trace trace() const { return topic->run(arguments_of(*topic, given), {0, 1, {}}); }
  Drag with(const std::string& parameter, const std::string& text) const {
    Drag other = *this;
    std::erase_if(other.given, [&](const Argument& a) { return a.name == parameter; });
    other.given.push_back({parameter, text});
    return other;
  }
};

bool reads_a_file(const Drag& run) {
  return std::ranges::any_of(run.given,
                             [](const Argument& a) { return a.name == "image" || a.name == "model"; });
}

/// Whole pictures and curves: they take long, and draw nothing of an argument's points.
bool is_long(const Drag& run) {
  static const std::set<std::string> pictures{"accumulation_buffer passes_side_by_side",
                                              "illumination lights_side_by_side",
                                              "jittered pictures",
                                              "perspective depth_precision",
                                              "sampling_theorem artefacts",
                                              "sampling_theorem chequerboard",
                                              "sampling_theorem reconstruction",
                                              "sampling_theorem zone_plate",
                                              "supersampling blurred_channels",
                                              "supersampling filters",
                                              "supersampling large_picture",
                                              "supersampling more_samples",
                                              "supersampling rays",
                                              "supersampling upsampled_image"};
  return std::ranges::any_of(run.given, [&](const Argument& a) {
    return a.name == "method" && pictures.contains(run.topic->name + " " + a.value);
  });
}

/// Each once: every method as it is, and the examples.
std::vector<Drag> all_cases() {
  std::vector<Drag> cases;
  std::set<std::string> known;
  const auto add = [&](Drag run) {
    if (!reads_a_file(run) && !is_long(run) && known.insert(run.name()).second)
      cases.push_back(std::move(run));
  };
  for (const TopicEntry* topic : catalogue()) {
    for (const Method& method : topic->methods) add({topic, {{"method", method.name}}});
    for (const std::string& example : topic->examples) add({topic, test::arguments_in(*topic, example)});
  }
  return cases;
}

/// The text of an argument, which the run has as it was given, or says what it took where none was.
std::string text_in(const Trace& trace, const Drag& run, const std::string& parameter) {
  const std::string given = arguments_of(*run.topic, run.given).text(parameter);
  const auto told = std::ranges::find(trace.arguments, parameter, &Argument::name);
  if (told == trace.arguments.end()) return given;
  if (!given.empty()) EXPECT_EQ(told->value, given) << parameter;
  return told->value;
}

void expect_well_formed(const Trace& trace, const Drag& run) {
  std::set<std::pair<std::string, std::vector<int>>> known;
  for (const Handle& handle : trace.handles) {
    const std::size_t count = numbers_in(text_in(trace, run, handle.parameter)).size();
    EXPECT_TRUE(known.insert({handle.parameter, handle.numbers}).second) << handle.parameter << " twice";
    EXPECT_EQ(std::set<int>(handle.numbers.begin(), handle.numbers.end()).size(), handle.numbers.size());
    for (const int number : handle.numbers) {
      EXPECT_TRUE(0 <= number && static_cast<std::size_t>(number) < count) << handle.parameter << number;
    }
    ASSERT_EQ(handle.along.size(), handle.numbers.size()) << handle.parameter;
    double most = 0;
    for (const dvec2 way : handle.along) {
      EXPECT_TRUE(std::isfinite(way.x) && std::isfinite(way.y)) << handle.parameter;
      most = std::max({most, std::abs(way.x), std::abs(way.y)});
    }
    EXPECT_GT(most, 0) << handle.parameter << " " << handle.numbers[0] << " stays where it is";
  }
}

void expect_to_stand_on_something(const Trace& trace, const Drag& run) {
  const Drawing drawing(trace);
  for (const Handle& handle : trace.handles) {
    const bool window = run.type_of(handle.parameter) == ParameterType::window;
    EXPECT_TRUE(drawing.has_something_at(handle.at) || (window && drawing.has_cell_at(handle.at)))
        << "nothing at (" << handle.at.x << ", " << handle.at.y << "), the handle of " << handle.parameter
        << " " << handle.numbers[0];
  }
}

// --- Dragging

bool is_whole(ParameterType type) {
  return type == ParameterType::cell || type == ParameterType::window || type == ParameterType::integer;
}

struct Nudged {
  double by;
  Drag run;
  Trace trace;
};

/// The run with one number changed a little, up or, where it refuses that, down; nothing where it refuses
/// both.
std::optional<Nudged> nudged(const Trace& before, const Drag& run, const Handle& handle, std::size_t which) {
  const double by = is_whole(run.type_of(handle.parameter)) ? 1 : 0.015625;
  const std::string text = text_in(before, run, handle.parameter);
  for (const double step : {by, -by}) {
    try {
      Drag other = run.with(handle.parameter, with_number(text, handle.numbers[which], step));
      Trace trace = other.trace();
      return Nudged{step, std::move(other), std::move(trace)};
    } catch (const ArgumentError&) {
      continue;
    }
  }
  return std::nullopt;
}

const Handle* find(const Trace& trace, const Handle& like) {
  const auto found = std::ranges::find_if(trace.handles, [&](const Handle& h) {
    return h.parameter == like.parameter && h.numbers == like.numbers;
  });
  return found == trace.handles.end() ? nullptr : &*found;
}

/// Whether all handles but those of this argument stay: then the drawing has not been fitted anew.
bool is_still(const Trace& before, const Trace& after, const Handle& moved) {
  int still = 0;
  for (const Handle& handle : before.handles) {
    if (std::ranges::any_of(handle.numbers, [&](int n) {
          return handle.parameter == moved.parameter &&
                 std::ranges::find(moved.numbers, n) != moved.numbers.end();
        }))
      continue;
    const Handle* const there = find(after, handle);
    if (!there || glm::distance(there->at, handle.at) > 1e-9) return false;
    ++still;
  }
  return still >= 2;
}

/// Changes a number of each argument that this method has not had changed yet. Returns how many handles went
/// as their `along` says.
int expect_to_move(const Trace& before, const Drag& run, std::set<std::string>& done) {
  int foretold = 0;
  for (const Handle& handle : before.handles) {
    if (!done.insert(fmt::format("{} {} {}", before.topic, before.method, handle.parameter)).second) continue;
    const std::size_t which = done.size() % handle.numbers.size();
    const auto other = nudged(before, run, handle, which);
    if (!other) continue;
    SCOPED_TRACE(other->run.name());
    const Trace& after = other->trace;
    expect_to_stand_on_something(after, other->run);
    const Handle* const there = find(after, handle);
    if (!there || !is_still(before, after, handle)) continue;
    const dvec2 way = other->by * handle.along[which], gone = there->at - handle.at;
    EXPECT_LE(glm::distance(way, gone), 0.05 * glm::length(way) + 1e-5 * Drawing(after).size().x)
        << handle.parameter << " went (" << gone.x << ", " << gone.y << "), not (" << way.x << ", " << way.y
        << ")";
    ++foretold;
  }
  return foretold;
}

TEST(Handles, StandOnWhatIsDrawnAndMoveWithTheirNumbers) {
  if (test::sanitized) return;  // all of this is run by golden/trace_hash
  int foretold = 0;
  std::set<std::string> moved;
  for (const Drag& run : all_cases()) {
    SCOPED_TRACE(run.name());
    const Trace trace = run.trace();
    expect_well_formed(trace, run);
    expect_to_stand_on_something(trace, run);
    foretold += expect_to_move(trace, run, moved);
  }
  EXPECT_GT(foretold, 50) << "handles in drawings that were not fitted anew";
}

/// By default they follow from control points and degree: the trace says what they are, and each has a
/// handle; below its weights a basis has those inside alone, for the others lie on each other.
TEST(Handles, KnotsThatAreNotGivenCanBeDragged) {
  for (const std::string method : {"de_boor", "basis", "insert_knot", "bezier_pieces"}) {
    const Drag run{find_entry("b_spline"), {{"method", method}}};
    const Trace trace = run.trace();
    EXPECT_EQ(text_in(trace, run, "knots"), "0 0 0 0 1 2 3 3 3 3");
    EXPECT_EQ(std::ranges::count(trace.handles, "knots", &Handle::parameter), method == "basis" ? 2 : 10)
        << method;
    const Trace same = run.with("knots", text_in(trace, run, "knots")).trace();
    EXPECT_EQ(same.arguments.size(), trace.arguments.size());
    EXPECT_EQ(same.handles.size(), trace.handles.size());
  }
}

TEST(Handles, CountTheNumbersBehindNamesWithDigits) {
  const Drag run{find_entry("polygon_shading"),
                 {{"method", "flat"}, {"faces", "2 left: 0,0,0 10,0,0 5,10,0; A1: 10,0,0 11,9,0 5,10,0"}}};
  const Trace trace = run.trace();
  expect_well_formed(trace, run);
  std::set<std::string> moved;
  EXPECT_EQ(expect_to_move(trace, run, moved), 1);
  const std::vector<Written> numbers = numbers_in(arguments_of(*run.topic, run.given).text("faces"));
  ASSERT_EQ(trace.handles.size(), 6u);
  EXPECT_EQ(numbers.at(static_cast<std::size_t>(trace.handles[4].numbers[0])).value, 11);
  EXPECT_EQ(numbers.at(static_cast<std::size_t>(trace.handles[4].numbers[1])).value, 9);
}

}  // namespace
}  // namespace gradus
