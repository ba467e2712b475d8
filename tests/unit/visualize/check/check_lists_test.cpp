// Lists of answers, each by the rule that its topic states. Oracles: what is plotted, which sample points an
// outline has inside, what a pile of painted faces looks like, places computed by hand.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "check/judge.hpp"
#include "live/files.hpp"
#include "request/inputs.hpp"

namespace gradus::check::lists_test {
namespace {

using List = std::vector<Element>;
using Texts = std::map<std::string, std::string>;

Arguments arguments_of_run(const TopicEntry& topic, const Texts& given) {
  live::OpenedFiles none;
  return read_inputs(topic, given, none).arguments;
}

std::string json_of(const Value& value) {
  if (const auto* cell = std::get_if<ivec2>(&value)) return fmt::format("[{}, {}]", cell->x, cell->y);
  if (const auto* text = std::get_if<std::string>(&value)) return fmt::format("\"{}\"", *text);
  if (const auto* real = std::get_if<double>(&value)) return fmt::format("{:.17g}", *real);
  return fmt::format("{}", std::get<std::int64_t>(value));
}
std::string json_of(const List& list) {
  std::vector<std::string> elements;
  for (const Element& element : list) {
    std::vector<std::string> values;
    for (const Value& value : element) values.push_back(json_of(value));
    const std::string all = fmt::format("{}", fmt::join(values, ", "));
    elements.push_back(element.size() == 1 ? all : "[" + all + "]");
  }
  return fmt::format("[{}]", fmt::join(elements, ", "));
}

double real(const Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  return std::get<double>(value);
}
dvec2 point(const Element& element) { return {real(element[0]), real(element[1])}; }
bool near(dvec2 a, dvec2 b) { return std::abs(a.x - b.x) < 1e-9 && std::abs(a.y - b.y) < 1e-9; }

/// Even-odd: whether a way to the right crosses the outline an odd number of times.
bool inside(const std::vector<dvec2>& ring, dvec2 p) {
  bool odd = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) odd = !odd;
  }
  return odd;
}

// --- Oracles: whether a list is as good an answer as ours -------------------------------------------------

/// The pixels that are plotted, however often.
bool plots_the_same(const List& ours, const List& theirs) {
  const auto picture = [](const List& list) {
    std::set<std::pair<int, int>> pixels;
    for (const Element& element : list) pixels.emplace(cell_of(element).x, cell_of(element).y);
    return pixels;
  };
  return picture(ours) == picture(theirs);
}

/// The things that are named, however often.
bool names_the_same(const List& ours, const List& theirs) {
  const auto names = [](const List& list) {
    std::set<std::string> all;
    for (const Element& element : list) all.insert(json_of(List{element}));
    return all;
  };
  return names(ours) == names(theirs);
}

/// Each in its place.
bool is_in_order(const List& ours, const List& theirs) { return json_of(ours) == json_of(theirs); }

/// The places inside, by 41 x 41 of them between the corners' bounds.
bool encloses_the_same(const List& ours, const List& theirs) {
  std::vector<dvec2> a, b;
  for (const Element& corner : ours) a.push_back(point(corner));
  for (const Element& corner : theirs) b.push_back(point(corner));
  for (int i = 0; i <= 40; ++i) {
    for (int k = 0; k <= 40; ++k) {
      const dvec2 p{-1.013 + i * 0.3017, -1.027 + k * 0.3011};
      if (inside(a, p) != inside(b, p)) return false;
    }
  }
  return true;
}

/// One segment from (x0, y0) to (x1, y1), or the other way, however often.
bool is_segment(const std::vector<double>& ends, const List& theirs) {
  const std::size_t half = ends.size() / 2;
  return !theirs.empty() && std::ranges::all_of(theirs, [&](const Element& element) {
    bool same = true, turned = true;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      same = same && std::abs(real(element[i]) - ends[i]) < 1e-9;
      turned = turned && std::abs(real(element[i]) - ends[(i + half) % ends.size()]) < 1e-9;
    }
    return same || turned;
  });
}

struct Sheet {
  std::string name;
  std::vector<dvec3> corners;
};
std::string text_of_sheets(const std::vector<Sheet>& sheets) {
  std::vector<std::string> texts;
  for (const auto& [name, corners] : sheets) {
    std::string text = name + ":";
    for (const dvec3 c : corners) text += fmt::format(" {},{},{}", c.x, c.y, c.z);
    texts.push_back(text);
  }
  return fmt::format("{}", fmt::join(texts, "; "));
}

/// Whether each sheet is painted once, and what is painted last on any way of sight is nearest.
bool paints_rightly(const std::vector<Sheet>& sheets, dvec3 towards, const List& theirs) {
  std::vector<std::size_t> order;
  for (const Element& element : theirs) {
    const auto found = std::ranges::find(sheets, std::get<std::string>(element[0]), &Sheet::name);
    order.push_back(static_cast<std::size_t>(found - sheets.begin()));
  }
  std::vector<std::size_t> once = order;
  std::ranges::sort(once);
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    if (once.size() != sheets.size() || once[i] != i) return false;
  }
  for (int i = 0; i <= 60; ++i) {
    for (int k = 0; k <= 60; ++k) {
      const dvec3 from{-15.03 + i * 0.5, -15.07 + k * 0.5, -20};
      double nearest = -1, painted = -1;
      for (const std::size_t number : order) {
        const auto& corners = sheets[number].corners;
        const dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double way = glm::dot(normal, corners[0] - from) / glm::dot(normal, towards);
        std::vector<dvec2> flat;
        for (const dvec3 c : corners) flat.emplace_back(c);
        if (!inside(flat, dvec2(from + way * towards))) continue;
        painted = way;
        nearest = std::max(nearest, way);
      }
      if (painted < nearest) return false;
    }
  }
  return true;
}

// --- The table --------------------------------------------------------------------------------------------

const std::vector<Sheet> crossing{{"A", {{-6, -3, -5}, {6, -3, 3}, {6, 0, 3}, {-6, 0, -5}}},
                                  {"B", {{-5, -5, -1}, {-1, -5, -1}, {-1, 3, -1}, {-5, 3, -1}}},
                                  {"C", {{2, -5, -4}, {5, -5, -4}, {5, 4, -4}, {2, 4, -4}}},
                                  {"D", {{-6, -10, -13}, {7, -10, -13}, {7, 5, -13}, {-6, 5, -13}}}};
const std::vector<Sheet> pile{{"low", {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}}},
                              {"top", {{2, 1, 6}, {7, 1, 6}, {7, 8, 6}, {2, 8, 6}}},
                              {"mid", {{1, 2, 3}, {8, 2, 3}, {8, 7, 3}, {1, 7, 3}}}};

struct Row {
  std::string topic, list;
  Texts given;
  std::function<bool(const List& ours, const List& theirs)> as_good;
};

std::function<bool(const List&, const List&)> segment(std::vector<double> ends) {
  return [ends = std::move(ends)](const List&, const List& theirs) { return is_segment(ends, theirs); };
}
std::function<bool(const List&, const List&)> painting(std::vector<Sheet> sheets, dvec3 towards) {
  return [sheets = std::move(sheets), towards](const List&, const List& theirs) {
    return paints_rightly(sheets, towards, theirs);
  };
}
/// The i-th place is the image of the i-th corner.
bool is_moved_and_doubled(const List&, const List& theirs) {
  const std::vector<dvec2> corners{{0, 0}, {3, 0}, {3, 2}, {1, 3}};
  bool same = theirs.size() == corners.size();
  for (std::size_t i = 0; same && i < corners.size(); ++i)
    same = near(point(theirs[i]), 2.0 * (corners[i] + dvec2{2, 1}));
  return same;
}
/// Points in a window of 8 x 8, a pixel per unit, the third one outside.
bool are_floors(const List&, const List& theirs) {
  const std::vector<ivec2> pixels{{1, 2}, {6, 0}, {3, 7}};
  bool same = theirs.size() == pixels.size();
  for (std::size_t i = 0; same && i < pixels.size(); ++i) same = cell_of(theirs[i]) == pixels[i];
  return same;
}
/// A cube from (2, 1.8, 2.9): three faces turn towards the eye, each with a sign, none with two.
bool are_the_signs_of_a_cube(const List&, const List& theirs) {
  std::map<std::string, std::set<std::int64_t>> signs;
  for (const Element& element : theirs)
    signs[std::get<std::string>(element[0])].insert(static_cast<std::int64_t>(real(element[1])));
  bool right = signs.size() == 6;
  for (const auto& [face, all] : signs) {
    const bool towards = face[0] == '+';
    right = right && all == std::set<std::int64_t>{towards ? 1 : -1};
  }
  return right;
}

std::vector<Row> table() {
  const Texts square{{"polygon", "0,0 4,0 4,4 0,4"}, {"window", "1,1,9,9"}};
  return {
      {"bresenham_line", "pixels", {{"to", "5,2"}}, plots_the_same},
      {"bresenham_circle", "pixels", {{"radius", "2"}}, plots_the_same},
      {"flood_fill", "pixels", {{"maze", "####/#..#/#.##/####"}, {"at", "1,1"}}, plots_the_same},
      {"triangle_coverage", "covered", {{"triangles", "0,0 5.1,0.2 0.3,3.4"}}, plots_the_same},
      {"viewport",
       "pixels",
       {{"points", "1.5,2.25 6.75,0.5 9,9 3.5,7.5"},
        {"window", "0,0,8,8"},
        {"resolution", "8,8"},
        {"row_zero", "bottom"}},
       are_floors},
      {"affine_2d",
       "corners",
       {{"factors", "translate 2,1; scale 2"}, {"polygon", "0,0 3,0 3,2 1,3"}},
       is_moved_and_doubled},
      {"cohen_sutherland_2d",
       "segment",
       {{"line", "-2,2,4,8"}, {"window", "0,0,10,6"}},
       segment({0, 4, 2, 6})},
      {"liang_barsky", "segment", {{"line", "-2,2,4,8"}, {"window", "0,0,10,6"}}, segment({0, 4, 2, 6})},
      {"cohen_sutherland_3d",
       "segment",
       {{"line", "-2,2,1,4,8,4"}, {"box", "0,0,0,10,6,9"}},
       segment({0, 4, 2, 2, 6, 3})},
      {"sutherland_hodgman", "corners", square, encloses_the_same},
      {"sutherland_hodgman",
       "corners",
       {{"polygon", "-2,1 6,1.5 8,7 2,3"}, {"window", "0,0,7,9"}},
       encloses_the_same},
      {"ear_clipping", "ears", {{"polygon", "0,0 8,0 4,3 8,6 0,6"}}, is_in_order},
      {"ear_clipping", "triangles", {{"polygon", "0,0 8,0 4,3 8,6 0,6"}}, names_the_same},
      {"mesh_structures", "faces", {}, names_the_same},
      {"mesh_structures", "half_edges", {{"query", "face"}}, is_in_order},
      {"bezier_curve", "points", {}, is_in_order},
      {"subdivision_surface", "face_points", {{"shape", "cube"}}, names_the_same},
      {"subdivision_surface", "edge_points", {{"shape", "pencil"}, {"vertex", "11"}}, names_the_same},
      {"subdivision_surface", "vertex_point", {{"method", "loop"}}, names_the_same},
      {"bezier_patch", "points", {}, is_in_order},
      {"b_spline", "points", {}, is_in_order},
      {"parametric_surface", "by_s", {}, is_in_order},
      {"parametric_surface", "by_t", {{"angles", "200,-45"}}, is_in_order},
      {"parametric_surface", "normal", {{"angles", "60,90"}}, is_in_order},
      {"parametric_surface", "normal", {{"method", "lookup"}}, is_in_order},
      {"parametric_surface", "rows", {{"method", "patches"}}, is_in_order},
      {"kd_tree", "points", {{"query", "6,9"}}, is_in_order},
      {"kd_tree", "middles", {{"method", "build"}}, is_in_order},
      {"point_cloud", "points", {{"method", "back_project"}}, is_in_order},
      {"csg_tree", "lengths", {}, is_in_order},
      {"csg_tree", "sides", {{"method", "membership"}}, is_in_order},
      {"fractal_curve", "tips", {}, is_in_order},
      {"fractal_curve", "segments", {{"shape", "curve"}}, is_in_order},
      {"iterated_functions", "pieces", {{"level", "2"}}, is_in_order},
      {"iterated_functions", "images", {{"level", "2"}}, names_the_same},
      {"iterated_functions", "pieces", {{"system", "koch"}}, is_in_order},
      {"back_face_culling", "signs", {}, are_the_signs_of_a_cube},
      {"painter",
       "order",
       {{"faces", text_of_sheets(crossing)}, {"towards", "0.3,0.4,1"}},
       painting(crossing, {0.3, 0.4, 1})},
      {"painter",
       "order",
       {{"faces", text_of_sheets(pile)}, {"towards", "0,0,1"}},
       painting(pile, {0, 0, 1})},
      {"bsp_tree",
       "order",
       {{"method", "back_to_front"}, {"faces", text_of_sheets(pile)}, {"towards", "0,0,1"}},
       painting(pile, {0, 0, 1})},
  };
}

/// The list begun elsewhere, backwards, with elements again, closed, without one, with two exchanged, in all
/// orders where they are few.
std::vector<std::pair<std::string, List>> changed(const List& right) {
  std::vector<std::pair<std::string, List>> all{{"right", right}};
  const auto place = [](const List& list, std::size_t i) {
    return list.begin() + static_cast<std::ptrdiff_t>(i);
  };
  const auto add = [&](std::string how, const auto& change) {
    List list = right;
    change(list);
    all.emplace_back(std::move(how), std::move(list));
  };
  for (std::size_t i = 0; i < right.size(); ++i) {
    add(fmt::format("from {} on", i),
        [&](List& l) { std::ranges::rotate(l, l.begin() + static_cast<std::ptrdiff_t>(i)); });
    add(fmt::format("{} again", i), [&](List& l) { l.insert(place(l, i), right[i]); });
    add(fmt::format("{} again, one later", i),
        [&](List& l) { l.insert(place(l, std::min(i + 2, l.size())), right[i]); });
    add(fmt::format("without {}", i), [&](List& l) { l.erase(place(l, i)); });
    for (std::size_t k = 0; k < i; ++k)
      add(fmt::format("{} and {} exchanged", k, i), [&](List& l) { std::swap(l[i], l[k]); });
  }
  add("backwards", [](List& l) { std::ranges::reverse(l); });
  add("closed", [](List& l) { l.push_back(l.front()); });
  add("closed backwards", [](List& l) {
    l.push_back(l.front());
    std::ranges::reverse(l);
  });
  if (right.size() > 5) return all;
  std::vector<std::size_t> order(right.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  do {
    List list;
    for (const std::size_t i : order) list.push_back(right[i]);
    all.emplace_back(fmt::format("in order {}", fmt::join(order, " ")), std::move(list));
  } while (std::ranges::next_permutation(order).found);
  return all;
}

/// The same with other elements: ends of segments, numbers and cells exchanged or moved.
void add_other_elements(const List& right, std::vector<std::pair<std::string, List>>& all) {
  const Element& first = right.front();
  const std::size_t half = first.size() / 2;
  if (half > 0) {
    List turned = right;
    std::ranges::rotate(turned.front(), turned.front().begin() + static_cast<std::ptrdiff_t>(half));
    all.emplace_back("the first element turned round", std::move(turned));
  }
  if (half > 1) {
    List mixed = right;
    std::swap(mixed.front()[0], mixed.front()[half]);
    all.emplace_back("half of the first element turned round", std::move(mixed));
  }
  List moved = right;
  if (auto* number = std::get_if<double>(&moved.back().back())) *number += 0.5;
  if (auto* whole = std::get_if<std::int64_t>(&moved.back().back())) *whole = -*whole;
  if (auto* cell = std::get_if<ivec2>(&moved.back().back())) cell->x += 7;
  all.emplace_back("the last element moved", std::move(moved));
}

TEST(CheckListsTest, EveryListIsJudgedByWhatItMeans) {
  for (const auto& [name, list_name, given, as_good] : table()) {
    const TopicEntry& topic = *find_entry(name);
    const Arguments arguments = arguments_of_run(topic, given);
    const Trace ours = topic.run(arguments, {});
    const Expected expected = expected_of(topic, ours);
    const auto list = std::ranges::find(expected.lists, list_name, &ExpectedList::name);
    ASSERT_NE(list, expected.lists.end()) << name;
    List right;
    for (const ExpectedElement& element : list->elements) right.push_back(element.values);
    ASSERT_FALSE(right.empty()) << name;
    auto answers = changed(right);
    if (!std::holds_alternative<std::string>(right[0].back())) add_other_elements(right, answers);
    if (right[0].size() > 1 && std::holds_alternative<std::string>(right[0][0]))
      std::erase_if(answers, [](const auto& a) { return a.first == "the first element turned round"; });
    std::size_t good = 0;
    for (const auto& [how, answer] : answers) {
      const std::string file = fmt::format(
          R"({{"answers": [{{"arguments": {{}}, "result": {{"{}": {}}}}}]}})", list_name, json_of(answer));
      const OwnAnswers read = read_answers(topic, file, "results.json");
      const Judgement judgement = judge({topic, arguments, ours, {}}, read, read.answers.front());
      EXPECT_EQ(judgement.verdict != Verdict::wrong, as_good(right, answer))
          << name << " " << list_name << " " << how << ": " << name_of(judgement.verdict) << " "
          << judgement.what << " " << json_of(answer);
      good += judgement.verdict != Verdict::wrong;
    }
    EXPECT_GE(good, 1U) << name;
    EXPECT_LT(good, answers.size()) << name;
  }
}

TEST(CheckListsTest, EveryListOfEveryTopicIsInTheTable) {
  const auto rows = table();
  const auto has_row = [&](const TopicEntry& topic, const std::string& list) {
    return std::ranges::any_of(rows,
                               [&](const Row& row) { return row.topic == topic.name && row.list == list; });
  };
  for (const TopicEntry* topic : catalogue()) {
    if (topic->checking) {
      for (const Asked& asked : topic->checking->asked)
        EXPECT_TRUE(has_row(*topic, asked.name)) << topic->name << " " << asked.name;
    }
    for (const Method& method : topic->methods) {
      const Trace ours = topic->run(arguments_of_run(*topic, {{"method", method.name}}), {});
      if (ours.pixels.empty()) continue;
      EXPECT_TRUE(has_row(*topic, "pixels")) << topic->name << " " << method.name << " plots pixels";
      EXPECT_FALSE(expected_of(*topic, ours).lists.empty()) << topic->name << " " << method.name;
    }
  }
}

TEST(CheckListsTest, TheBowTieIsNotTheSquareAndTheClosedRingIs) {
  const TopicEntry& topic = *find_entry("sutherland_hodgman");
  const Arguments arguments =
      arguments_of_run(topic, {{"polygon", "0,0 4,0 4,4 0,4"}, {"window", "1,1,9,9"}});
  const Trace ours = topic.run(arguments, {});
  const auto verdict = [&](std::string_view corners) {
    const std::string file =
        fmt::format(R"({{"answers": [{{"arguments": {{}}, "result": {{"corners": {}}}}}]}})", corners);
    const OwnAnswers read = read_answers(topic, file, "results.json");
    const Judgement judgement = judge({topic, arguments, ours, {}}, read, read.answers.front());
    return fmt::format("{}: {}", name_of(judgement.verdict), judgement.what);
  };
  EXPECT_EQ(verdict("[[1, 4], [4, 1], [1, 1], [1, 1], [4, 4]]").substr(0, 6), "wrong:");
  EXPECT_EQ(verdict("[[1, 4], [1, 1], [4, 1], [4, 4], [1, 4]]"),
            "right in another order: corners from another one on, closed by the first one");
  EXPECT_EQ(verdict("[[4, 1], [1, 1], [1, 4], [1, 4], [4, 4]]"),
            "right in another order: corners from another one on, backwards, 1 of them again");
}

}  // namespace
}  // namespace gradus::check::lists_test
