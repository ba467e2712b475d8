#pragma once
// What a batch of polygons is clipped by: some hundred corners at a time, all of them between left and right,
// then between bottom and top. Each loop does one thing to all corners, so that few branches are left that a
// machine can't foresee, and compilers make several corners' arithmetic of one instruction.

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "clipping/sutherland_hodgman/convex_window.hpp"
#include "clipping/sutherland_hodgman/nearest_cuts.hpp"

namespace gradus::sutherland_hodgman {

/// Polygons one after the other in one array.
template <std::floating_point T = double>
struct Polygons {
  std::vector<glm::vec<2, T>> points;
  std::vector<std::uint32_t> ends;  ///< of each polygon: how many points it and those before it have

  std::size_t size() const { return ends.size(); }
  std::span<const glm::vec<2, T>> operator[](std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends[i - 1];
    return std::span(points).subspan(begin, ends[i] - begin);
  }
  void add(std::span<const glm::vec<2, T>> polygon) {
    points.insert(points.end(), polygon.begin(), polygon.end());
    ends.push_back(static_cast<std::uint32_t>(points.size()));
  }
};

namespace detail {

// --- Where a polygon lies ----------------------------------------

/// 16 bytes of coordinates: x and y in turns.
template <class T>
struct LanesOf;
template <>
struct LanesOf<float> {
  using Type [[gnu::vector_size(16)]] = float;
};
template <>
struct LanesOf<double> {
  using Type [[gnu::vector_size(16)]] = double;
};

/// The smallest rectangle round some points, and whether all of them are finite.
template <class T>
struct Reach {
  glm::vec<2, T> lower, upper;
  bool finite;
};

/// Copies the points on the way. Domain: at least two.
template <class T>
Reach<T> reach_of(std::span<const glm::vec<2, T>> points, glm::vec<2, T>* copy) {
  using Lanes = typename LanesOf<T>::Type;
  constexpr std::size_t lanes = 16 / sizeof(T), step = lanes / 2;
  const std::size_t last = points.size() - step;
  const auto at = [&](std::size_t i) {
    Lanes x;
    std::memcpy(&x, points.data() + i, sizeof(x));
    std::memcpy(copy + i, &x, sizeof(x));
    return x;
  };
  // The last ones may come twice
  Lanes x = at(last), lower = x, upper = x, check = x * T(0);
  for (std::size_t i = 0; i < last; i += step) {
    x = at(i);
    lower = x < lower ? x : lower;
    upper = x > upper ? x : upper;
    check += x * T(0);
  }
  Reach<T> reach{{lower[0], lower[1]}, {upper[0], upper[1]}, check[0] + check[1] == 0};
  for (std::size_t k = 2; k < lanes; k += 2) {
    reach.lower = {std::min(reach.lower.x, lower[k]), std::min(reach.lower.y, lower[k + 1])};
    reach.upper = {std::max(reach.upper.x, upper[k]), std::max(reach.upper.y, upper[k + 1])};
    reach.finite = reach.finite && check[k] + check[k + 1] == 0;
  }
  return reach;
}

// --- What an edge leaves -----------------------------------------

/// Where a number lies between two borders: 0 below, 1 on the lower one, 2 between, 3 on the upper, 4 above.
template <class T>
std::uint8_t place_between(T x, T lower, T upper) {
  return static_cast<std::uint8_t>((x >= lower) + (x > lower) + (x >= upper) + (x > upper));
}
constexpr bool on_border(std::uint8_t place) { return place % 2 == 1; }

/// What a corner was made of, in one number: 8 times the place of a corner that came, and what of that.
namespace source {
inline constexpr std::uint32_t itself = 0, entry = 2, exit = 4, itself_along = 6;  ///< of the edge after it
inline constexpr std::uint32_t upper = 1;  ///< at the upper border, or along it
constexpr bool is_cut(std::uint32_t name) { return (name & 7) - entry < 4; }
/// Whether the edge that follows is the border.
constexpr bool along(std::uint32_t name) { return (name & 4) != 0; }
}  // namespace source

constexpr std::uint64_t pair_of(std::uint32_t first, std::uint32_t second) {
  return std::bit_cast<std::uint64_t>(std::array{first, second});
}

/// What is left of an edge between two borders, without its first end: by the places of both, 8 * first +
/// second.
struct Remains {
  static constexpr std::size_t size = 8 * 5;
  std::array<std::uint64_t, size> names;       ///< of up to two corners; the first end is counted as 0
  std::array<std::uint8_t, size> count, cuts;  ///< of them, cuts first
  std::array<std::uint8_t, size> along;  ///< of the first end: what its name gains where a border follows
};
inline constexpr Remains remains_of_edges = [] {
  Remains remains{};
  for (std::uint32_t was = 0; was < 5; ++was) {
    for (std::uint32_t is = 0; is < 5; ++is) {
      std::array<std::uint32_t, 2> names{};
      std::uint8_t count = 0;
      const std::size_t i = 8 * was + is;
      if (was == 0 && is > 1) names[count++] = source::entry;
      if (was == 4 && is < 3) names[count++] = source::entry + source::upper;
      if (is == 0 && was > 1) names[count++] = source::exit;
      if (is == 4 && was < 3) names[count++] = source::exit + source::upper;
      remains.cuts[i] = count;
      if (0 < is && is < 4) names[count++] = 8 + source::itself;
      remains.count[i] = count;
      remains.names[i] = pair_of(names[0], names[1]);
      // Two in a row on the border, or one that its edge leaves for the outside
      if (was == 1 && is <= 1) remains.along[i] = source::itself_along;
      if (was == 3 && is >= 3) remains.along[i] = source::itself_along + source::upper;
    }
  }
  return remains;
}();

// --- Some polygons -----------------------------------------------

/// Corners of several polygons, one after the other, each polygon's last one before its first, too.
template <class T>
struct Corners {
  std::vector<glm::vec<2, T>> at;
  std::vector<std::uint32_t> names;  ///< none of those that are given
  std::size_t size = 0;

  void make_room(std::size_t more) {
    if (at.size() >= size + more) return;
    at.resize(2 * (size + more));
    names.resize(2 * (size + more));
  }
};

/// Polygons of a batch on their way through the borders.
template <class T>
class Part {
 public:
  using Point = glm::vec<2, T>;

  /// How many corners it takes before it is full: more would leave the nearest cache.
  static constexpr std::size_t enough = 256;

  void start(const Rectangle<T>& window) {
    for (std::size_t i = 0; i < 4; ++i) borders_[i] = coordinate_of(window, static_cast<int>(i));
    polygons_.clear();
    // The lines of left and right are edges from corners 0 and 2 on, like those of polygons
    given_.size = 0;
    given_.make_room(lines);
    for (const T x : {borders_[0], borders_[1]}) {
      for (const T y : {T(0), T(1)}) given_.at[given_.size++] = {x, y};
    }
  }
  bool full() const { return given_.size > enough; }

  /// Where the points of the next polygon go, before it is added.
  Point* room_for(std::size_t points) {
    given_.make_room(points + 2);
    return given_.at.data() + given_.size + 1;
  }
  void add(std::size_t points, bool crosses_x, bool crosses_y) {
    Point* const at = given_.at.data() + given_.size + 1;
    at[-1] = at[points - 1];
    at[points] = at[0];
    polygons_.push_back({given_.size, points, crosses_x, crosses_y});
    given_.size += points + 2;
  }

  /// Clips all that were added, appends what is left of each, and is empty again.
  void finish(Polygons<T>& result) {
    if (polygons_.empty()) return;
    find_places<0>(given_, lines);
    pass<0>(given_, strip_);
    for (const Polygon& polygon : polygons_) {
      const std::size_t first = polygon.begin, last = first + polygon.size;
      strip_.at[first] = strip_.at[last];
      strip_.names[first] = strip_.names[last];
    }
    find_places<1>(strip_, 0);
    mend_places();
    pass<1>(strip_, left_);
    append(result);
    polygons_.clear();
    given_.size = lines;
  }

 private:
  /// The ends of two lines come before the corners that are given.
  static constexpr std::size_t lines = 4;

  struct Polygon {
    std::size_t begin, size;  ///< of its corners, without the one that comes first, too
    bool crosses_x, crosses_y;
  };

  /// What the bytes of a polygon's corners have, all together. Eight at a time: some may be the next
  /// polygon's.
  static std::uint8_t any_of(const std::vector<std::uint8_t>& bytes, const Polygon& polygon) {
    std::uint64_t any = 0;
    for (std::size_t i = 0; i <= polygon.size; i += sizeof(any)) {
      std::uint64_t eight;
      std::memcpy(&eight, bytes.data() + polygon.begin + i, sizeof(eight));
      any |= eight;
    }
    any |= any >> 32;
    any |= any >> 16;
    return static_cast<std::uint8_t>(any | any >> 8);
  }

  template <int axis>
  void find_places(const Corners<T>& corners, std::size_t begin) {
    if (places_.size() < corners.size + 8) places_.resize(2 * corners.size + 8);
    const T lower = borders_[2 * axis], upper = borders_[2 * axis + 1];
    const Point* const at = corners.at.data();
    std::uint8_t* const places = places_.data();
    const std::size_t size = corners.size;
    unsigned any = 0;
    for (std::size_t i = begin; i < size; ++i) {
      places[i] = place_between(at[i][axis], lower, upper);
      any |= places[i];
    }
    on_borders_ = any % 2 == 1;
  }
  /// Rounding keeps the order, so that where a corner is says on which side the exact point lies, unless that
  /// is on the border.
  void mend_places() {
    if (on_borders_) mend_places_of_cuts();
    for (const Polygon& polygon : polygons_) places_[polygon.begin] = places_[polygon.begin + polygon.size];
  }
  void mend_places_of_cuts() {
    for (const std::uint32_t cut : std::span(cuts_).first(cut_count_)) {
      if (!on_border(places_[cut])) continue;
      const Point *const line = given_.at.data() + (strip_.names[cut] >> 3), p = strip_.at[cut];
      const auto order = compare_at_cut(Segment<2, T>{line[0], line[1]}, 0, p.x, 1, p.y, p.y);
      places_[cut] = static_cast<std::uint8_t>(places_[cut] + (order > 0) - (order < 0));
    }
  }

  /// cut_at_border for the two borders across an axis.
  template <int axis>
  void pass(const Corners<T>& from, Corners<T>& to) {
    to.size = 0;
    to.make_room(2 * from.size + 2);
    if (cuts_.size() < to.at.size()) cuts_.resize(to.at.size());
    cut_count_ = 0;
    for (Polygon& polygon : polygons_) {
      const std::size_t begin = to.size;
      // The next pass wants the last corner before the first one
      if (axis == 0) ++to.size;
      if (axis == 0 ? polygon.crosses_x : polygon.crosses_y) {
        keep_inside(from.at.data(), polygon, to);
        if (axis == 0 && on_borders_ && on_border(any_of(places_, polygon)))
          find_along(polygon, begin + 1, to);
      } else {
        keep_all(from.at.data(), polygon, to);
      }
      polygon.size = to.size - begin - (axis == 0 ? 1 : 0);
      polygon.begin = begin;
    }
    make_cuts<axis>(to);
  }
  static void keep_all(const Point* from, const Polygon& polygon, Corners<T>& to) {
    for (std::size_t i = polygon.begin + 1; i <= polygon.begin + polygon.size; ++i) {
      to.at[to.size] = from[i];
      to.names[to.size++] = static_cast<std::uint32_t>(8 * i + source::itself);
    }
  }
  void keep_inside(const Point* from, const Polygon& polygon, Corners<T>& to) {
    constexpr std::size_t row = 8;
    constexpr std::uint64_t next = pair_of(8, 8);
    const std::uint8_t* const places = places_.data();
    Point* const at = to.at.data();
    std::uint32_t *const names = to.names.data(), *const cuts = cuts_.data();
    std::size_t size = to.size, cut_count = cut_count_, i = polygon.begin, was = places[i];
    std::uint64_t number = next * i;
    const auto go_on_to = [&](std::size_t end) {
      for (; i < end; ++i, number += next) {
        const std::size_t is = places[i + 1], edge = 8 * was + is, made = remains_of_edges.cuts[edge];
        // Where nothing is left the next one writes over it
        const std::uint64_t two_names = number + remains_of_edges.names[edge];
        std::memcpy(names + size, &two_names, sizeof(two_names));
        cuts[cut_count] = static_cast<std::uint32_t>(size);
        cuts[cut_count + 1] = static_cast<std::uint32_t>(size + 1);
        at[size + made] = from[i + 1];
        size += remains_of_edges.count[edge];
        cut_count += made;
        was = is;
      }
    };
    const std::size_t end = i + polygon.size;
    // Long ones have many in a row on one side
    if (polygon.size >= 4 * row) {
      while (i + row <= end) {
        if (std::memcmp(places + i, places + i + 1, row) != 0) {
          go_on_to(i + row);
          continue;
        }
        if (0 < was && was < 4) {
          for (std::size_t k = 0; k < row; ++k) {
            at[size + k] = from[i + k + 1];
            names[size + k] = static_cast<std::uint32_t>(8 * (i + k + 1));
          }
          size += row;
        }
        i += row;
        number += row * next;
      }
    }
    go_on_to(end);
    to.size = size;
    cut_count_ = cut_count;
  }

  /// Which corners from `begin` on a border follows.
  void find_along(const Polygon& polygon, std::size_t begin, Corners<T>& to) const {
    const std::uint8_t* const places = places_.data();
    for (std::size_t k = begin; k < to.size; ++k) {
      const std::size_t i = to.names[k] >> 3;
      if (!on_border(places[i]) || source::is_cut(to.names[k])) continue;
      const std::size_t next = i < polygon.begin + polygon.size ? i + 1 : polygon.begin + 1;
      to.names[k] |= remains_of_edges.along[8 * std::size_t{places[i]} + places[next]];
    }
  }

  /// The line that a corner lies on, as the first of two points that are given.
  template <int axis>
  const Point* line_of(std::uint32_t name) const {
    std::size_t from = name >> 3;
    if (axis == 1) {
      const std::uint32_t start = strip_.names[from];
      from = source::along(start) ? 2 * (start & source::upper) : start >> 3;
    }
    return given_.at.data() + from;
  }
  /// Scene::cut, for all of a pass.
  template <int axis>
  void make_cuts(Corners<T>& corners) {
    constexpr int other = 1 - axis;
    const T borders[2] = {borders_[2 * axis], borders_[2 * axis + 1]};
    Point* const at = corners.at.data();
    const std::uint32_t* const names = corners.names.data();
    Cuts<T> cuts;
    std::array<T, Cuts<T>::most> found, doubts;
    for (std::size_t begin = 0; begin < cut_count_; begin += Cuts<T>::most) {
      const std::uint32_t* const places = cuts_.data() + begin;
      const std::size_t count = std::min(Cuts<T>::most, cut_count_ - begin);
      for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t name = names[places[i]];
        const Point* const line = line_of<axis>(name);
        cuts.a_axis[i] = line[0][axis], cuts.b_axis[i] = line[1][axis];
        cuts.a_other[i] = line[0][other], cuts.b_other[i] = line[1][other];
        cuts.c[i] = borders[name & source::upper];
      }
      find_quickly(cuts, count, found.data(), doubts.data());
      for (std::size_t i = 0; i < count; ++i) {
        if (doubts[i] != 0) found[i] = cuts.exact(i);
        at[places[i]][axis] = cuts.c[i];
        at[places[i]][other] = found[i];
      }
    }
  }

  /// Whether a corner of what is left is a cut of this pass or of the one before.
  bool made(std::size_t i) const {
    const std::uint32_t name = left_.names[i];
    return source::is_cut(name) || source::is_cut(strip_.names[name >> 3]);
  }
  /// What is left, as leave_out_repeated leaves it.
  void append(Polygons<T>& result) {
    Point* const at = left_.at.data();
    const bool repeats = find_repeats();
    std::size_t size = 0;
    for (const Polygon& polygon : polygons_) {
      if (!repeats) {
        size += polygon.size;
      } else if (may_repeat(polygon)) {
        size = without_repeats(polygon, size);
      } else {
        for (std::size_t i = 0; i < polygon.size; ++i) at[size++] = at[polygon.begin + i];
      }
      result.ends.push_back(static_cast<std::uint32_t>(result.points.size() + size));
    }
    result.points.insert(result.points.end(), at, at + size);
  }
  /// Marks the corners that are where the next one is. Whether there are any, in a polygon's order.
  bool find_repeats() {
    const std::size_t size = left_.size;
    repeats_.resize(std::max(repeats_.size(), size + sizeof(std::uint64_t)));
    const Point* const at = left_.at.data();
    std::uint8_t* const repeats = repeats_.data();
    unsigned any = 0;
    for (std::size_t i = 0; i < size; ++i) {
      repeats[i] = (at[i].x == at[i + 1].x) & (at[i].y == at[i + 1].y);
      any |= repeats[i];
    }
    for (const Polygon& polygon : polygons_) {
      if (polygon.size > 0)
        any |= polygon.size < 3 || at[polygon.begin] == at[polygon.begin + polygon.size - 1];
    }
    return any != 0;
  }
  bool may_repeat(const Polygon& polygon) const {
    const std::size_t begin = polygon.begin, end = begin + polygon.size;
    if (polygon.size < 3 || left_.at[begin] == left_.at[end - 1]) return true;
    return any_of(repeats_, polygon) != 0;
  }
  /// Moves a polygon to `begin`, where it isn't further behind. Returns its new end.
  std::size_t without_repeats(const Polygon& polygon, std::size_t begin) {
    Point* const at = left_.at.data();
    std::size_t end = begin;
    for (std::size_t i = polygon.begin; i < polygon.begin + polygon.size; ++i) {
      const Point last = at[end > begin ? end - 1 : i], now = at[i];
      if ((last.x == now.x) & (last.y == now.y) & (end > begin)) {
        if (made(i)) continue;
        if (made(end - 1)) --end;
      }
      at[end] = at[i];
      left_.names[end++] = left_.names[i];
    }
    std::size_t first = begin;
    while (end - first > 1 && at[end - 1] == at[first] && (made(end - 1) || made(first))) {
      made(end - 1) ? --end : ++first;
    }
    if (end - first < 3) return begin;
    if (first > begin) std::copy(at + first, at + end, at + begin);
    return begin + (end - first);
  }

  std::array<T, 4> borders_{};
  std::vector<Polygon> polygons_;
  Corners<T> given_, strip_, left_;   // strip_: between left and right
  std::vector<std::uint8_t> places_;  // of the corners that come to a pass: place_between its borders
  std::vector<std::uint32_t> cuts_;   // where it left room for them
  std::vector<std::uint8_t> repeats_;
  std::size_t cut_count_ = 0;
  bool on_borders_ = false;
};

}  // namespace detail
}  // namespace gradus::sutherland_hodgman
