// Cases are what their kind says. Oracles: whole-number geometry of this file, read from the texts of the
// cases.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "check/cases.hpp"
#include "check/expected.hpp"
#include "live/files.hpp"
#include "request/inputs.hpp"

namespace gradus::check::cases_test {
namespace {

using Numbers = std::vector<double>;
using Points = std::vector<Numbers>;

Arguments arguments_of_case(const TopicEntry& topic, const GivenTexts& given) {
  live::OpenedFiles none;
  return read_inputs(topic, given, none).arguments;
}

// --- Texts ------------------------------------------------------------------------------------------------

std::vector<std::string> split(const std::string& text, const std::string& separators) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (separators.find(c) == std::string::npos)
      parts.back() += c;
    else if (!parts.back().empty())
      parts.emplace_back();
  }
  if (parts.back().empty()) parts.pop_back();
  return parts;
}
Numbers numbers_in(const std::string& text) {
  Numbers numbers;
  for (const std::string& word : split(text, ", ;")) {
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (end != word.c_str()) numbers.push_back(value);
  }
  return numbers;
}
/// "0,0 4,0; 1,1 2,2": the points of each list; of faces without their names.
std::vector<Points> lists_in(const std::string& text) {
  std::vector<Points> lists;
  for (const std::string& list : split(text, ";")) {
    lists.emplace_back();
    for (const std::string& point : split(list.substr(std::min(list.find(':') + 1, list.size())), " "))
      lists.back().push_back(numbers_in(point));
  }
  return lists;
}

// --- Geometry ---------------------------------------------------------------------------------------------

struct Place {
  double x, y, z;
};
Place minus(Place a, Place b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Place times(Place a, Place b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(Place a, Place b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double length(Place a) { return std::sqrt(dot(a, a)); }
std::vector<Place> places_of(const Points& points) {
  std::vector<Place> places;
  for (const Numbers& p : points) places.push_back({p.at(0), p.at(1), p.at(2)});
  return places;
}

/// How far corners lie off the plane of the three of them that span most, in parts of the size.
double bend(const std::vector<Place>& face) {
  double size = 0, best = 0;
  Place normal{0, 0, 0};
  for (const Place& a : face) {
    for (const Place& b : face) {
      size = std::max(size, length(minus(a, b)));
      const Place n = times(minus(a, face[0]), minus(b, face[0]));
      if (length(n) <= best) continue;
      best = length(n);
      normal = n;
    }
  }
  if (best == 0) return 0;  // a line
  double thick = 0;
  for (const Place& p : face) thick = std::max(thick, std::abs(dot(normal, minus(p, face[0]))) / best);
  return thick / size;
}

/// Whether a plane across an axis parts all pairs.
bool lie_apart(const std::vector<std::vector<Place>>& faces) {
  const auto range = [](const std::vector<Place>& face, int axis) {
    std::array<double, 2> bounds{INFINITY, -INFINITY};
    for (const Place& p : face) {
      const double at = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
      bounds = {std::min(bounds[0], at), std::max(bounds[1], at)};
    }
    return bounds;
  };
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      bool apart = false;
      for (int axis = 0; axis < 3; ++axis) {
        const auto a = range(faces[i], axis), b = range(faces[k], axis);
        apart = apart || a[1] < b[0] || b[1] < a[0];
      }
      if (!apart) return false;
    }
  }
  return true;
}

using Whole = std::int64_t;
Whole turn(const Numbers& a, const Numbers& b, const Numbers& c) {
  const auto w = [](double v) { return static_cast<Whole>(v); };
  return (w(b[0]) - w(a[0])) * (w(c[1]) - w(a[1])) - (w(b[1]) - w(a[1])) * (w(c[0]) - w(a[0]));
}
/// Of whole corners: no two edges have a point in common but neighbours their corner. Points of a segment are
/// found by the boxes and the signs of turns.
bool crosses_nowhere(const Points& ring) {
  const std::size_t n = ring.size();
  const auto sign = [](Whole w) { return (w > 0) - (w < 0); };
  const auto holds = [&](std::size_t i, const Numbers& p) {
    const Numbers &a = ring[i], &b = ring[(i + 1) % n];
    return turn(a, b, p) == 0 && std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) &&
           std::min(a[1], b[1]) <= p[1] && p[1] <= std::max(a[1], b[1]);
  };
  for (std::size_t i = 0; i < n; ++i) {
    // A corner belongs to its own two edges alone
    for (std::size_t k = 0; k < n; ++k) {
      if (k != i && k != (i + n - 1) % n && holds(k, ring[i])) return false;
    }
    for (std::size_t k = i + 2; k < n; ++k) {
      const Numbers &a = ring[i], &b = ring[(i + 1) % n], &c = ring[k], &d = ring[(k + 1) % n];
      if (sign(turn(a, b, c)) * sign(turn(a, b, d)) < 0 && sign(turn(c, d, a)) * sign(turn(c, d, b)) < 0)
        return false;
    }
  }
  return n >= 3;
}

bool is_outline_of(const Parameter& p) {
  const bool polygon = p.least >= 3 || p.name == "polygon";
  return (p.type == ParameterType::points || p.type == ParameterType::rings) && polygon &&
         p.parts.size() <= 3 && p.parts[0] == "x" && p.parts[1] == "y" && p.parts.back() != "z";
}

using DrawnCases = std::vector<std::pair<const TopicEntry*, Case>>;
const DrawnCases& cases_of_all(CaseKind kind) {
  static std::map<CaseKind, DrawnCases> drawn;  // once for all tests
  auto& all = drawn[kind];
  for (const TopicEntry* topic : all.empty() ? catalogue() : std::span<const TopicEntry* const>()) {
    Cases cases(*topic, {}, 1, [topic](const GivenTexts& given) { return arguments_of_case(*topic, given); });
    for (Case& one : cases.of_kind(kind, 4)) all.emplace_back(topic, std::move(one));
  }
  return all;
}

template <class See>
void for_each_case(CaseKind kind, See see) {
  for (const auto& [topic, one] : cases_of_all(kind)) {
    SCOPED_TRACE(topic->name + " " + one.id);
    see(*topic, one);
  }
}
const Parameter& parameter_of(const TopicEntry& topic, const std::string& name) {
  return *std::ranges::find(topic.parameters, name, &Parameter::name);
}

// --- Tests ------------------------------------------------------------------------------------------------

TEST(CasesTest, FacesAreFlat) {
  std::size_t count = 0;
  for (const CaseKind kind : {CaseKind::easy, CaseKind::ties, CaseKind::nasty}) {
    for_each_case(kind, [&](const TopicEntry& topic, const Case& one) {
      for (const auto& [name, text] : one.arguments) {
        if (name == "method" || parameter_of(topic, name).type != ParameterType::faces) continue;
        for (const Points& face : lists_in(text)) {
          EXPECT_LE(bend(places_of(face)), kind == CaseKind::easy ? 0 : 2e-9) << text;
          ++count;
        }
      }
    });
  }
  EXPECT_GT(count, 100U);
}

TEST(CasesTest, EasyOnesAreOfSmallWholeNumbers) {
  for_each_case(CaseKind::easy, [](const TopicEntry& topic, const Case& one) {
    for (const auto& [name, text] : one.arguments) {
      const Parameter& p = parameter_of(topic, name);
      if (p.type == ParameterType::maze || p.type == ParameterType::factors) continue;
      const bool scalar = p.type == ParameterType::number || p.type == ParameterType::integer;
      const double least = scalar ? std::max(0.0, static_cast<double>(p.least)) : 0;
      const double most = scalar ? std::max(8.0, static_cast<double>(p.least)) : 9;
      Numbers all;
      for (const Points& list : lists_in(text)) {
        for (const Numbers& point : list) all.insert(all.end(), point.begin(), point.end());
      }
      for (const double n : all) {
        EXPECT_EQ(n, std::round(n)) << name << " " << text;
        EXPECT_TRUE(least <= n && n <= most) << name << " " << text;
      }
    }
  });
}

TEST(CasesTest, WindowsHaveAnInsideAndCirclesARadius) {
  for (const CaseKind kind : {CaseKind::easy, CaseKind::ties}) {
    for_each_case(kind, [](const TopicEntry& topic, const Case& one) {
      for (const auto& [name, text] : one.arguments) {
        if (name == "method") continue;
        const Parameter& p = parameter_of(topic, name);
        const Numbers bounds = numbers_in(text);
        if (p.type == ParameterType::window || p.type == ParameterType::bounds) {
          for (std::size_t i = 0; i < bounds.size() / 2; ++i)
            EXPECT_LT(bounds[i], bounds[bounds.size() / 2 + i]) << name << " " << text;
        }
        if (!p.parts.empty() && p.parts.back() == "r") EXPECT_GT(bounds.back(), 0) << name << " " << text;
      }
    });
  }
}

TEST(CasesTest, OutlinesOfEasyOnesAndTiesAreSimple) {
  std::map<std::string, std::size_t> seen;
  for (const CaseKind kind : {CaseKind::easy, CaseKind::ties}) {
    for_each_case(kind, [&](const TopicEntry& topic, const Case& one) {
      for (const auto& [name, text] : one.arguments) {
        if (name == "method" || !is_outline_of(parameter_of(topic, name))) continue;
        for (Points ring : lists_in(text)) {
          // Ties are near the defaults, of which some have tenths
          for (Numbers& p : ring) p = {std::round(1000 * p[0]), std::round(1000 * p[1])};
          EXPECT_TRUE(crosses_nowhere(ring)) << name << " " << text;
          ++seen[topic.name];
        }
      }
    });
  }
  for (const char* topic : {"sutherland_hodgman", "polygon_circle", "triangle_coverage", "affine_2d",
                            "area_sampling", "a_buffer", "texture_mapping"})
    EXPECT_GT(seen[topic], 1U) << topic;
}

// --- Ties
// ---------------------------------------------------------------------------------------------------

Numbers given_or_default(const TopicEntry& topic, const Case& one, const std::string& name) {
  const auto given = one.arguments.find(name);
  const std::string text =
      given == one.arguments.end() ? parameter_of(topic, name).default_value : given->second;
  Numbers all;
  for (const Points& list : lists_in(text)) {
    for (const Numbers& point : list) all.insert(all.end(), point.begin(), point.end());
  }
  return all;
}

/// In some column (of steep lines row) the line passes midway between two pixels.
bool passes_midway(const TopicEntry& topic, const Case& one) {
  const Numbers from = given_or_default(topic, one, "from"), to = given_or_default(topic, one, "to");
  const auto dx = static_cast<Whole>(std::abs(to[0] - from[0])),
             dy = static_cast<Whole>(std::abs(to[1] - from[1]));
  const Whole length = std::max(dx, dy), aside = std::min(dx, dy);
  for (Whole k = 1; k <= length; ++k) {
    if (2 * k * aside % (2 * length) == length) return true;
  }
  return false;
}

/// A centre of a pixel on an edge. Coordinates are doubled to be whole.
bool has_a_centre_on_an_edge(const TopicEntry& topic, const Case& one) {
  const Numbers corners = given_or_default(topic, one, "triangles");
  for (std::size_t t = 0; t + 5 < corners.size(); t += 6) {
    Points triangle;
    for (std::size_t i = 0; i < 3; ++i)
      triangle.push_back({2 * corners[t + 2 * i], 2 * corners[t + 2 * i + 1]});
    for (double y = -41; y <= 41; y += 2) {
      for (double x = -41; x <= 41; x += 2) {
        for (std::size_t i = 0; i < 3; ++i) {
          const Numbers &a = triangle[i], &b = triangle[(i + 1) % 3], p{x, y};
          const bool within = std::min(a[0], b[0]) <= x && x <= std::max(a[0], b[0]) &&
                              std::min(a[1], b[1]) <= y && y <= std::max(a[1], b[1]);
          if (within && turn(a, b, p) == 0) return true;
        }
      }
    }
  }
  return false;
}

/// The part of the segment's line between the borders left and right, then below, then above, is a point; or
/// it runs along a border. Parts are fractions of whole numbers.
bool touches_or_runs_along(const TopicEntry& topic, const Case& one) {
  const Numbers line = given_or_default(topic, one, "line"), window = given_or_default(topic, one, "window");
  struct Fraction {
    Whole over, under;
    bool operator<(const Fraction& other) const { return over * other.under < other.over * under; }
    bool operator==(const Fraction& other) const { return over * other.under == other.over * under; }
  };
  Fraction enter{0, 1}, leave{1, 1};
  for (const int border : {0, 2, 1, 3}) {
    const int axis = border % 2;
    const auto at = static_cast<std::size_t>(axis);
    const auto way = static_cast<Whole>(line[at + 2] - line[at]);
    const auto room = static_cast<Whole>(window[static_cast<std::size_t>(border)] - line[at]);
    if (way == 0 && room == 0) return true;
    if (way == 0) continue;
    const Fraction t{way < 0 ? -room : room, std::abs(way)};
    const bool comes_in = (border < 2) == (way > 0);
    if (comes_in && enter < t) enter = t;
    if (!comes_in && t < leave) leave = t;
    if (enter == leave) return true;
  }
  return false;
}

/// At one of the borders in turn a corner lies on it.
bool has_a_corner_on_a_border(const TopicEntry& topic, const Case& one) {
  const Numbers flat = given_or_default(topic, one, "polygon"),
                window = given_or_default(topic, one, "window");
  Points ring;
  for (std::size_t i = 0; i + 1 < flat.size(); i += 2) ring.push_back({flat[i], flat[i + 1]});
  for (const std::size_t border : {0U, 2U, 1U, 3U}) {
    const std::size_t axis = border % 2;
    const double sign = border < 2 ? 1 : -1;
    const auto depth = [&](const Numbers& p) { return sign * (p[axis] - window[border]); };
    Points kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Numbers &a = ring[i], &b = ring[(i + 1) % ring.size()];
      const double da = depth(a), db = depth(b);
      if (std::abs(da) < 1e-12) return true;
      if (da > 0) kept.push_back(a);
      if (da * db < 0) {
        const double t = da / (da - db);
        Numbers cut{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
        cut[axis] = window[border];
        kept.push_back(cut);
      }
    }
    ring = kept;
  }
  return false;
}

/// The eye lies in the plane of a face.
bool sees_a_face_from_its_edge(const TopicEntry& topic, const Case& one) {
  const bool distant = one.arguments.contains("towards");
  const Numbers eye = given_or_default(topic, one, distant ? "towards" : "eye");
  const auto given = one.arguments.find("faces");
  const std::string text =
      given == one.arguments.end() ? parameter_of(topic, "faces").default_value : given->second;
  for (const Points& list : lists_in(text)) {
    const auto face = places_of(list);
    const Place normal = times(minus(face[1], face[0]), minus(face[2], face[0]));
    const Place at{eye[0], eye[1], eye[2]};
    if (std::abs(dot(normal, distant ? at : minus(at, face[0]))) < 1e-9 * length(normal)) return true;
  }
  return false;
}

TEST(CasesTest, TiesMightGoTheOtherWay) {
  const std::map<std::string, bool (*)(const TopicEntry&, const Case&)> is_tie{
      {"bresenham_line", passes_midway},
      {"triangle_coverage", has_a_centre_on_an_edge},
      {"liang_barsky", touches_or_runs_along},
      {"sutherland_hodgman", has_a_corner_on_a_border},
      {"back_face_culling", sees_a_face_from_its_edge}};
  std::map<std::string, std::size_t> seen;
  for_each_case(CaseKind::ties, [&](const TopicEntry& topic, const Case& one) {
    const auto oracle = is_tie.find(topic.name);
    ASSERT_NE(oracle, is_tie.end()) << "no oracle knows its ties";
    EXPECT_TRUE(oracle->second(topic, one)) << fmt::format("{}", one.arguments.begin()->second);
    ++seen[topic.name];
  });
  for (const auto& [topic, oracle] : is_tie) EXPECT_GT(seen[topic], 0U) << topic;
}

// --- Nasty ones
// ---------------------------------------------------------------------------------------------

/// Numbers that are repeated, 0, below 0, large, nearly whole, thirds or sevenths.
TEST(CasesTest, NastyOnesHaveNastyNumbers) {
  for_each_case(CaseKind::nasty, [](const TopicEntry& topic, const Case& one) {
    bool nasty = false;
    for (const auto& [name, text] : one.arguments) {
      if (name == "method") continue;
      if (parameter_of(topic, name).type == ParameterType::maze)
        nasty = true;  // half of its walls are others
      Numbers all = given_or_default(topic, one, name);
      if (parameter_of(topic, name).type == ParameterType::factors) {
        all.clear();
        for (const std::string& word : split(text, " ")) {
          for (const double n : numbers_in(word)) all.push_back(n);
        }
      }
      std::set<double> different(all.begin(), all.end());
      nasty = nasty || different.size() < all.size();
      for (const double n : all) {
        const bool thirds = n != std::round(n) && std::abs(21 * n - std::round(21 * n)) < 1e-9;
        const double tenths = 1000 * n;
        const bool nearly = tenths != std::round(tenths) && std::abs(tenths - std::round(tenths)) < 1e-5;
        const Parameter& p = parameter_of(topic, name);
        const bool scalar = p.type == ParameterType::number || p.type == ParameterType::integer;
        const bool at_an_end =
            scalar && (n == static_cast<double>(p.least) || n == static_cast<double>(p.most));
        nasty = nasty || n <= 0 || n >= 20 || thirds || nearly || at_an_end;
      }
    }
    std::string all;
    for (const auto& [name, text] : one.arguments) all += " " + name + " " + text;
    // Of cells side by side
    Numbers numbers;
    for (const auto& [name, text] : one.arguments) {
      if (name != "method")
        for (const double n : given_or_default(topic, one, name)) numbers.push_back(n);
    }
    ASSERT_FALSE(numbers.empty() && !nasty) << all;
    nasty = nasty || *std::ranges::max_element(numbers) - *std::ranges::min_element(numbers) <= 1;
    EXPECT_TRUE(nasty) << all;
  });
}

/// What is drawn is then named as it is given, for none is cut.
TEST(CasesTest, EasyFacesLieApartAndKeepTheirNames) {
  std::size_t orders = 0;
  for_each_case(CaseKind::easy, [&](const TopicEntry& topic, const Case& one) {
    const auto given = one.arguments.find("faces");
    if (given == one.arguments.end()) return;
    std::vector<std::vector<Place>> faces;
    for (const Points& face : lists_in(given->second)) faces.push_back(places_of(face));
    EXPECT_TRUE(lie_apart(faces)) << given->second;
    const Trace trace = topic.run(arguments_of_case(topic, one.arguments), {});
    for (const ExpectedList& list : expected_of(topic, trace).lists) {
      if (list.name != "order") continue;
      std::multiset<std::string> drawn, named;
      for (const ExpectedElement& element : list.elements)
        drawn.insert(std::get<std::string>(element.values.front()));
      for (const std::string& face : split(given->second, ";")) {
        const std::string name = face.substr(0, face.find(':'));
        named.insert(name.substr(name.find_first_not_of(' ')));
      }
      EXPECT_EQ(drawn, named);
      ++orders;
    }
  });
  EXPECT_GE(orders, 3U);
}

}  // namespace
}  // namespace gradus::check::cases_test
