#include "check/changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "stories/face_text.hpp"
#include "stories/outline.hpp"
#include "stories/point_text.hpp"

namespace gradus::check {
namespace {

bool is_digit(char c) { return '0' <= c && c <= '9'; }

/// The text with every number of it changed: the i-th, as it was, becomes what change(i, number) says.
template <class Change>
std::string with_numbers(std::string_view text, const Change& change) {
  std::string all;
  for (std::size_t at = 0, i = 0; at < text.size();) {
    const char c = text[at];
    const bool sign =
        (c == '-' || c == '+') && at + 1 < text.size() && (is_digit(text[at + 1]) || text[at + 1] == '.');
    const bool begins = is_digit(c) || sign || (c == '.' && at + 1 < text.size() && is_digit(text[at + 1]));
    if (!begins) {
      all += c;
      ++at;
      continue;
    }
    std::size_t end = at + 1;
    while (end < text.size() &&
           (is_digit(text[end]) || text[end] == '.' || text[end] == '/' || text[end] == 'e'))
      ++end;
    const auto read = read_number(text.substr(at, end - at));
    const Number* number = std::get_if<Number>(&read);
    all += number ? change(i++, number->value) : std::string(text.substr(at, end - at));
    at = end;
  }
  return all;
}

std::string text_of_number(double value) { return fmt::format("{}", value + 0.0); }
Number number_of(double value) { return std::get<Number>(read_number(text_of_number(value))); }

bool is_whole(ParameterType type) {
  return type == ParameterType::cell || type == ParameterType::window || type == ParameterType::integer;
}
bool is_window(ParameterType type) { return type == ParameterType::window || type == ParameterType::bounds; }
/// Whether its points are the corners of outlines, in the plane or with a w each.
bool is_outline(const Parameter& p) {
  const bool encloses = p.least >= 3 || p.name.find("polygon") != std::string::npos;
  const bool points = (p.type == ParameterType::points || p.type == ParameterType::rings) && encloses;
  return points && p.parts.size() >= 2 && p.parts[0] == "x" && p.parts[1] == "y" &&
         (p.parts.size() == 2 || (p.parts.size() == 3 && p.parts[2] == "w"));
}
/// Whether the last of its numbers is a circle's radius.
bool is_circle(const Parameter& p) { return !p.parts.empty() && p.parts.back() == "r"; }

using Outlines = std::vector<std::vector<Tuple>>;
Outlines outlines_in(const Parameter& p, const std::string& text) {
  if (p.type == ParameterType::rings) return std::get<Outlines>(read_rings(text, p.parts));
  return {std::get<std::vector<Tuple>>(read_tuples(text, p.parts))};
}
std::string text_of_outlines(const Parameter& p, const Outlines& all) {
  return p.type == ParameterType::rings ? text_of(all) : text_of(all.front());
}
std::vector<dvec2> places_of(const std::vector<Tuple>& outline) {
  std::vector<dvec2> places;
  for (const Tuple& corner : outline) places.emplace_back(corner[0].value, corner[1].value);
  return places;
}
bool all_simple(const Outlines& all) {
  return std::ranges::all_of(all, [](const auto& outline) { return is_simple(places_of(outline)); });
}

/// Corners of a convex polygon, in whole steps along two ways.
std::vector<ivec2> convex_pattern(std::size_t corners) {
  if (corners == 3) return {{0, 0}, {1, 0}, {0, 1}};
  if (corners == 4) return {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  std::vector<ivec2> pattern;  // on a parabola
  const int last = static_cast<int>(corners) - 1;
  for (int i = 0; i <= last; ++i) pattern.emplace_back(i, i * (last - i));
  return pattern;
}

std::vector<dvec3> corners_of(const FaceText& face) {
  std::vector<dvec3> corners;
  for (const Tuple& p : face.points) corners.emplace_back(p[0].value, p[1].value, p[2].value);
  return corners;
}

/// Each coordinate through a change of its own kind.
template <class Change>
std::vector<dvec3> each(std::vector<dvec3> corners, const Change& change) {
  for (dvec3& corner : corners) corner = change(corner);
  return corners;
}

}  // namespace

bool can_be_changed(ParameterType type) {
  using enum ParameterType;
  switch (type) {
    case cell:
    case window:
    case integer:
    case number:
    case numbers:
    case bounds:
    case points:
    case rings:
    case factors:
    case faces:
    case maze:
      return true;
    default:
      return false;
  }
}

Changes::Changes(CaseKind kind, Random random)
    : kind_(kind), random_(random), way_(static_cast<int>(random_.uniform_int(0, 7))) {
  constant_ = random_.uniform_int(-3, 6);
}

std::string Changes::of(const Parameter& p) {
  const std::string& usual = p.default_value;
  if (p.type == ParameterType::maze) return maze(usual);
  if (p.type == ParameterType::faces) return faces(usual);
  if (is_window(p.type)) return window(numbers(p));
  return is_outline(p) && kind_ != CaseKind::nasty ? outlines(p) : numbers(p);
}

// --- Numbers -----------------------------------------------------------------------------------------------

std::string Changes::numbers(const Parameter& p) {
  last_ = 0;
  return with_numbers(p.default_value, [&](std::size_t i, double usual) {
    double value = number(i, usual, is_whole(p.type));
    if (p.type == ParameterType::number || p.type == ParameterType::integer)
      value = std::clamp(value, static_cast<double>(p.least), static_cast<double>(p.most));
    const bool radius = is_circle(p) && i + 1 == p.parts.size() && kind_ != CaseKind::nasty;
    if (radius && value <= 0) value = small(1, 8);
    last_ = value;
    return text_of_number(value);
  });
}

double Changes::number(std::size_t i, double usual, bool whole) {
  switch (kind_) {
    case CaseKind::easy:
      return small(0, 8);
    case CaseKind::typical: {
      const double moved = usual + small(-5, 5) * (whole ? 1 : std::max(0.1, std::abs(usual) / 10));
      return whole ? std::round(moved) : std::round(moved * 10) / 10;
    }
    case CaseKind::ties:
      return way_ % 2 == 0 ? usual + small(-2, 2) : way_ % 3 == 0 ? 2 * small(-4, 4) : small(-6, 6);
    case CaseKind::nasty:
      break;
  }
  return nasty(i, usual, whole);
}

double Changes::nasty(std::size_t i, double usual, bool whole) {
  switch (way_) {
    case 0:  // all in one place
      return static_cast<double>(constant_);
    case 1:  // the other side of the origin
      return -usual;
    case 2:  // along an axis, or a diagonal
      return i < 2 ? small(-9, 9) : picks(0.6) ? last_ : small(-9, 9);
    case 3:  // large
      return usual * small(10, 40) + small(-9, 9);
    case 4:  // nearly the same
      return whole ? static_cast<double>(constant_) + small(0, 1) : usual + small(-1, 1) * 1e-9;
    case 5:  // steep, backwards
      return small(-60, 60);
    case 6:  // thirds and sevenths, or ones
      return whole ? small(-1, 1) : small(-20, 20) / (picks(0.5) ? 3 : 7);
    default:  // on axes
      return i == 0 || picks(0.5) ? 0 : usual;
  }
}

/// Lower bounds before upper ones, and but for nasty ones some room between them.
std::string Changes::window(const std::string& text) {
  std::vector<double> bounds;
  with_numbers(text, [&](std::size_t, double value) {
    bounds.push_back(value);
    return std::string();
  });
  const std::size_t half = bounds.size() / 2;
  std::string all;
  for (std::size_t i = 0; i < half; ++i) {
    double &lower = bounds[i], &upper = bounds[half + i];
    if (lower > upper) std::swap(lower, upper);
    if (kind_ == CaseKind::nasty || upper - lower >= 1) continue;
    lower = std::floor(lower) - (lower >= 7 ? 2 : 0);
    upper = lower + 2;
  }
  for (const double bound : bounds) all += (all.empty() ? "" : ",") + text_of_number(bound);
  return all;
}

// --- Outlines ----------------------------------------------------------------------------------------------

/// An outline without crossings where the usual one is.
std::string Changes::outlines(const Parameter& p) {
  constexpr int most_tries = 40;
  const bool simple = all_simple(outlines_in(p, p.default_value));
  for (int i = 0; i < most_tries; ++i) {
    const std::string text = kind_ == CaseKind::easy ? easy_outlines(p) : numbers(p);
    if (!simple || all_simple(outlines_in(p, text))) return text;
  }
  return p.default_value;
}

/// Whole corners in the order in which they are seen from amidst them.
std::string Changes::easy_outlines(const Parameter& p) {
  Outlines all = outlines_in(p, numbers(p));
  for (std::vector<Tuple>& outline : all) {
    dvec2 middle{0};
    for (const dvec2 place : places_of(outline)) middle += place / static_cast<double>(outline.size());
    std::ranges::stable_sort(outline, {}, [middle](const Tuple& corner) {
      const double x = corner[0].value - middle.x, y = corner[1].value - middle.y;
      const double length = std::abs(x) + std::abs(y);
      // Grows with the angle, from -2 to 2
      const double along = length == 0 ? 0 : x / length;
      return y < 0 ? along - 1 : 1 - along;
    });
  }
  return text_of_outlines(p, all);
}

// --- Faces -------------------------------------------------------------------------------------------------

std::string Changes::faces(const std::string& text) {
  auto faces = std::get<std::vector<FaceText>>(read_faces(text));
  const auto count = static_cast<int>(faces.size());
  const int axis = static_cast<int>(random_.uniform_int(0, 2));
  std::optional<Corners> twin;
  for (int i = 0; i < count; ++i) {
    FaceText& face = faces[static_cast<std::size_t>(i)];
    const Corners usual = corners_of(face);
    Corners corners;
    if (kind_ == CaseKind::easy) {
      // Each in a slice of its own of the room from 0 to 8
      dvec3 lower{0}, upper{8};
      lower[axis] = std::floor(9.0 * i / count);
      upper[axis] = std::max(lower[axis], std::floor(9.0 * (i + 1) / count) - 1);
      corners = face_in(lower, upper, usual);
    } else {
      corners = moved_face(usual);
    }
    const bool all_in_one = kind_ == CaseKind::nasty && way_ == 0;
    if (all_in_one && twin && twin->size() == corners.size()) corners = *twin;
    if (all_in_one && !twin) twin = corners;
    face.points.clear();
    for (const dvec3 c : corners) face.points.push_back({number_of(c.x), number_of(c.y), number_of(c.z)});
  }
  return text_of(faces);
}

dvec3 Changes::small_way(int least, int most) {
  const double x = small(least, most), y = small(least, most), z = small(least, most);
  return {x, y, z};
}

/// A flat convex face of as many whole corners in a box.
Changes::Corners Changes::face_in(dvec3 lower, dvec3 upper, const Corners& usual) {
  constexpr int most_tries = 400;
  const auto pattern = convex_pattern(usual.size());
  const auto between = [this](double a, double b) { return small(static_cast<int>(a), static_cast<int>(b)); };
  for (int i = 0; i < most_tries; ++i) {
    const dvec3 room = upper - lower;
    const double x = between(lower.x, upper.x), y = between(lower.y, upper.y), z = between(lower.z, upper.z);
    dvec3 ways[2];
    for (dvec3& way : ways) {
      for (int axis = 0; axis < 3; ++axis) way[axis] = between(-room[axis], room[axis]);
    }
    Corners corners;
    for (const ivec2 steps : pattern)
      corners.push_back(dvec3{x, y, z} + double(steps.x) * ways[0] + double(steps.y) * ways[1]);
    const bool fits = std::ranges::all_of(corners, [&](dvec3 c) {
      return glm::all(glm::lessThanEqual(lower, c)) && glm::all(glm::lessThanEqual(c, upper));
    });
    if (fits && glm::cross(ways[0], ways[1]) != dvec3{0}) return corners;
  }
  // Across the narrowest way, in one corner of the box
  const dvec3 room = upper - lower;
  const int narrow = room.x <= room.y && room.x <= room.z ? 0 : room.y <= room.z ? 1 : 2;
  Corners corners(pattern.size(), lower);
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    corners[i][(narrow + 1) % 3] += pattern[i].x;
    corners[i][(narrow + 2) % 3] += pattern[i].y;
  }
  return corners;
}

/// Moved, turned or drawn anew as a whole: it stays flat.
Changes::Corners Changes::moved_face(const Corners& usual) {
  const auto moved_by = [&](dvec3 way) { return each(usual, [way](dvec3 c) { return c + way; }); };
  // Sums like 0.1 + 0.2 get their short form back
  const auto short_ones = [](const Corners& corners) {
    return each(corners, [](dvec3 c) { return glm::round(c * 1e9) / 1e9; });
  };
  switch (kind_) {
    case CaseKind::easy:
      break;
    case CaseKind::typical:
      return short_ones(moved_by(0.1 * small_way(-5, 5)));
    case CaseKind::ties:
      if (way_ % 2 == 0) return short_ones(moved_by(small_way(-2, 2)));
      if (way_ % 3 != 0) return face_in(dvec3{-6}, dvec3{6}, usual);
      return each(face_in(dvec3{-4}, dvec3{4}, usual), [](dvec3 c) { return 2.0 * c; });
    case CaseKind::nasty:
      return nasty_face(usual);
  }
  return usual;
}

Changes::Corners Changes::nasty_face(const Corners& usual) {
  switch (way_) {
    case 0:  // all in one
      return face_in(dvec3{-3}, dvec3{6}, usual);
    case 1:  // the other side of the origin
      return each(usual, [](dvec3 c) { return -c; });
    case 2: {  // along axes
      const int axis = static_cast<int>(random_.uniform_int(0, 2));
      dvec3 lower{-9}, upper{9};
      lower[axis] = upper[axis] = small(-9, 9);
      return face_in(lower, upper, usual);
    }
    case 3: {  // large
      const double factor = small(10, 40);
      const dvec3 way = small_way(-9, 9);
      return each(usual, [=](dvec3 c) { return glm::round((factor * c + way) * 1e6) / 1e6; });
    }
    case 4: {  // nearly the same
      const dvec3 way = 1e-9 * small_way(-1, 1);
      return each(usual, [=](dvec3 c) { return glm::round((c + way) * 1e9) / 1e9; });
    }
    case 5:  // steep, backwards
      return face_in(dvec3{-60}, dvec3{60}, usual);
    case 6: {  // thirds and sevenths
      const double by = picks(0.5) ? 3 : 7;
      return each(face_in(dvec3{-20}, dvec3{20}, usual), [by](dvec3 c) { return c / by; });
    }
    default: {  // in a plane through the origin
      const int axis = static_cast<int>(random_.uniform_int(0, 2));
      return each(usual, [axis](dvec3 c) {
        c[axis] = 0;
        return c;
      });
    }
  }
}

// --- Mazes -------------------------------------------------------------------------------------------------

/// Some walls more, some fewer, the border as it is.
std::string Changes::maze(std::string rows) {
  const std::size_t width = rows.find('/');
  if (width == std::string::npos) return rows;
  const double share = kind_ == CaseKind::easy ? 0.05 : kind_ == CaseKind::nasty ? 0.5 : 0.15;
  for (std::size_t i = width + 1; i + width + 1 < rows.size(); ++i) {
    const std::size_t column = i % (width + 1);
    if (rows[i] == '/' || column == 0 || column + 1 == width || !picks(share)) continue;
    rows[i] = rows[i] == '#' ? '.' : '#';
  }
  return rows;
}

}  // namespace gradus::check
