#pragma once
// The drawing: the picture on the left, with which pixels take all samples; one pixel, large, on the right,
// with its samples. What lies behind is dashed in both.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "stories/antialiasing/adaptive/subject.hpp"
#include "stories/paper.hpp"

namespace gradus::adaptive {

/// Cells of the drawing: a large pixel has as many as it takes to give rows of 4, 8 or 16 samples as many
/// each.
class Paper {
 public:
  explicit Paper(const Subject& subject)
      : subject_(subject),
        side_(48),
        zoom_(side_ / 8),
        height_(std::max(side_, zoom_ * subject.size.y)),
        map_{1, 2 * zoom_ + (height_ - zoom_ * subject.size.y) / 2},
        large_{map_.x + zoom_ * subject.size.x + 2 * zoom_, 2 * zoom_ + (height_ - side_) / 2} {}

  void set(Narrator& narrator) const {
    narrator.whole_grid({{0, 0}, {large_.x + side_, 2 * zoom_ + height_}});
  }

  void put_frames(View& view, const std::string& title) const {
    view.plane = true;
    const dvec2 size(zoom_ * subject_.size);
    view.add({"a picture", Role::past, rectangle(dvec2(map_) - 0.5, size)});
    view.add(
        {"a picture name", Role::guide, Text{dvec2(map_) - 0.5 + dvec2{0.5 * size.x, -0.7 * zoom_}, title}});
    put_triangles(view, "b", {0, 0}, dvec2(subject_.size), [&](dvec2 p) { return on_map(p); });
  }
  /// The corners that the picture shows, on the grid of 1/256 pixel.
  void let_drag(Narrator& narrator) const {
    const Extent picture{{0, 0}, dvec2(subject_.size)};
    const auto at = [&](dvec3 p) -> std::optional<dvec2> {
      const dvec2 corner = dvec2(triangle_coverage::snap(dvec2(p))) / double{subpixels};
      return picture.holds(corner) ? std::optional(on_map(corner)) : std::nullopt;
    };
    narrator.handles("faces", at, 1);
  }
  /// Which pixel stands on the right, by its upper left corner.
  void let_drag_pixel(Narrator& narrator) const {
    narrator.handles("pixel", [&](dvec2 pixel) { return on_map(pixel); });
  }
  /// Which pixel stands on the right, and the triangles through it.
  void put_large(View& view, const Words& words, ivec2 pixel) const {
    view.add({"c pixel", Role::boundary, square_on_map(pixel)});
    view.add({"c large", Role::boundary, rectangle(dvec2(large_) - 0.5, dvec2(side_))});
    view.add({"c large name", Role::guide,
              Text{dvec2(large_) - 0.5 + dvec2{0.5 * side_, -0.7 * zoom_},
                   words.say("large", {{"pixel", pixel}})}});
    put_triangles(view, "d", dvec2(pixel), dvec2(pixel) + 1.0,
                  [&](dvec2 p) { return in_large(p - dvec2(pixel)); });
    put_pierced(view, pixel);
  }
  /// What is seen in the pixel, pale: samples are to find it out.
  void put_seen(View& view, ivec2 pixel) const {
    for (ivec2 at{0, 0}; at.y < side_; ++at.y) {
      for (at.x = 0; at.x < side_; ++at.x) {
        const int face = seen_at(dvec2(pixel) + (dvec2(at) + 0.5) / double(side_));
        if (face == nobody) continue;
        view.cells.insert_or_assign({large_.y + at.y, large_.x + at.x},
                                    CellLook{Role::result, "", tone_on_paper(subject_.color(face), 0.3)});
      }
    }
  }
  /// The rings of samples that show nothing yet.
  void put_samples(View& view) const {
    for (std::size_t s = 0; s < subject_.places.size(); ++s)
      view.add({fmt::format("s {:02}", s), Role::past, Dot{sample(s), true}});
  }
  /// The cells of a sample take a colour.
  void put_sample(View& view, std::size_t s, Rgba8 color) const {
    const int cells = side_ / subject_.count;
    const ivec2 at = large_ + subject_.places[s] * subject_.count / subpixels * cells;
    for (int y = 0; y < cells; ++y)
      for (int x = 0; x < cells; ++x)
        view.cells.insert_or_assign({at.y + y, at.x + x}, CellLook{Role::result, "", color});
    view.marks.erase(fmt::format("s {:02}", s));
  }
  void mark_sample(View& view, std::size_t s, Role role) const {
    const double cells = static_cast<double>(side_) / subject_.count;
    view.add({"z sample", role, rectangle(sample(s) - 0.5 * cells, dvec2(cells))});
    // Above it, in the upper row below
    const double beside = 0.5 * cells + 2;
    const bool upper = sample(s).y < large_.y + cells;
    view.add({"z sample name", role,
              Text{sample(s) + dvec2{0, upper ? beside : -beside}, fmt::format("{}", s + 1)}});
  }
  void mark_place(View& view, ivec2 place) const {
    view.add({"z place", Role::current, Dot{in_large(dvec2(place) / double{subpixels})}});
  }

  /// The corners of the large pixel where an edge function is least and greatest.
  void mark_range(View& view, const Edge& edge, const Range& range) const {
    const ivec2 way = edge.to - edge.from;
    const dvec2 most{way.y < 0 ? 1 : 0, way.x > 0 ? 1 : 0}, least = dvec2(1) - most;
    const auto value = [](std::int64_t area) {
      return figure_real(static_cast<double>(area) / (double{subpixels} * subpixels));
    };
    const auto put = [&](const std::string& id, dvec2 corner, std::int64_t area) {
      const dvec2 at = 0.92 * corner + 0.04;
      const bool left = corner.x == 0;
      view.add({id, Role::current, Dot{in_large(at)}});
      view.add({id + " value", Role::current,
                Text{in_large(at + dvec2{left ? 0.05 : -0.05, 0}), value(area),
                     left ? Align::left : Align::right}});
    };
    put("k least", least, range.least);
    put("k most", most, range.most);
  }

  void put_pixel(View& view, ivec2 pixel, Rgba8 color) const {
    const ivec2 at = map_ + zoom_ * pixel;
    for (int y = 0; y < zoom_; ++y)
      for (int x = 0; x < zoom_; ++x)
        view.cells.insert_or_assign({at.y + y, at.x + x}, CellLook{Role::result, "", color});
  }
  /// How many samples the pixel takes.
  void put_number(View& view, ivec2 pixel, int number) const {
    view.add({number_id(pixel), Role::guide, Text{on_map(dvec2(pixel) + 0.5), fmt::format("{}", number)}});
  }
  /// It takes all of them.
  void put_tint(View& view, ivec2 pixel) const {
    view.add({"m" + number_id(pixel), Role::measure, Area{{square_on_map(pixel).points}, 3}});
    view.marks.erase(number_id(pixel));
  }
  /// Its colour is to be seen.
  void clear_number(View& view, ivec2 pixel) const {
    view.marks.erase("m" + number_id(pixel));
    view.marks.erase(number_id(pixel));
  }
  void mark_pixel(View& view, ivec2 pixel, Role role) const {
    view.add({"z pixel", role, square_on_map(pixel)});
  }

 private:
  static Path rectangle(dvec2 corner, dvec2 size) {
    return {{corner, corner + dvec2{size.x, 0}, corner + size, corner + dvec2{0, size.y}}, true};
  }
  static std::string number_id(ivec2 pixel) { return fmt::format("n {:02} {:02}", pixel.y, pixel.x); }
  dvec2 on_map(dvec2 place) const { return dvec2(map_) - 0.5 + static_cast<double>(zoom_) * place; }
  dvec2 in_large(dvec2 place) const { return dvec2(large_) - 0.5 + static_cast<double>(side_) * place; }
  dvec2 sample(std::size_t s) const { return in_large(dvec2(subject_.places[s]) / double{subpixels}); }
  Path square_on_map(ivec2 pixel) const { return rectangle(on_map(dvec2(pixel)), dvec2(zoom_)); }
  template <class Place>
  void put_triangles(View& view, const std::string& id, dvec2 lower, dvec2 upper, const Place& place) const {
    for (int i = 0; i < static_cast<int>(subject_.triangles.size()); ++i) {
      const std::vector<dvec2> ring = subject_.ring(i), seen = within(lower, upper, ring);
      if (seen.size() < 3) continue;
      // Sides alone, not where the frame cuts the triangle off
      for (std::size_t k = 0; k < 3; ++k) {
        std::vector<dvec2> side{ring[k], ring[(k + 1) % 3]};
        const auto part = shown_part({lower, upper}, side[0], side[1]);
        if (!part || part->a == part->b) continue;
        put_side(view, fmt::format("{} {} {}", id, i, k), i, *part, place);
      }
      if (id == "d")
        view.add(
            {fmt::format("t name {}", i), Role::input, Text{place(free_place(i, lower)), subject_.name(i)}});
    }
  }
  /// A part of a triangle's side, dashed where another triangle lies before it.
  template <class Place>
  void put_side(View& view, const std::string& id, int i, const Stroke& part, const Place& place) const {
    constexpr int pieces = 48;
    const auto along = [&](double k) { return part.a + k / pieces * (part.b - part.a); };
    const auto behind = [&](int k) { return is_behind(i, along(k + 0.5)); };
    for (int from = 0, to = 0; from < pieces; from = to) {
      const bool hidden = behind(from);
      while (++to < pieces && behind(to) == hidden) {
      }
      view.add({fmt::format("{} {:02}", id, from), Role::input,
                Stroke{place(along(from)), place(along(to)), false, hidden, hidden}});
    }
  }
  bool covers(int i, dvec2 p) const {
    const Edges edges = triangle_coverage::edges_of(subject_.triangle(i).corners);
    return std::ranges::all_of(edges, [&](const Edge& e) { return at(e, p) > 0; });
  }
  bool is_behind(int i, dvec2 p) const {
    for (int k = 0; k < static_cast<int>(subject_.triangles.size()); ++k) {
      if (k != i && covers(k, p) && depth(k, p) < depth(i, p) - 1e-9) return true;
    }
    return false;
  }
  /// The nearest triangle there, or nobody.
  int seen_at(dvec2 p) const {
    int seen = nobody;
    for (int i = 0; i < static_cast<int>(subject_.triangles.size()); ++i) {
      if (covers(i, p) && (seen == nobody || depth(i, p) < depth(seen, p))) seen = i;
    }
    return seen;
  }
  struct Side {
    Edge edge;
    double length;  ///< in pixels
  };
  using Sides = std::array<Side, 3>;
  std::vector<Sides> sides() const {
    std::vector<Sides> all;
    for (int i = 0; i < static_cast<int>(subject_.triangles.size()); ++i) {
      Sides& sides = all.emplace_back();
      for (std::size_t k = 0; const Edge& e : triangle_coverage::edges_of(subject_.triangle(i).corners)) {
        const dvec2 way = dvec2(e.to - e.from) / double{subpixels};
        sides[k++] = {e, std::max(1e-9, length_between({0, 0}, way))};
      }
    }
    return all;
  }
  /// A place for a triangle's name in a pixel: where it is seen, far from edges and samples.
  dvec2 free_place(int triangle, dvec2 pixel) const {
    constexpr int steps = 24;
    const std::vector<Sides> all = sides();
    dvec2 best = pixel + 0.5;
    double farthest = -1;
    for (int k = 0; k < steps * steps; ++k) {
      const dvec2 part = (dvec2(k % steps, k / steps) + 0.5) / double{steps}, p = pixel + part;
      double far = std::min({part.x, part.y, 1 - part.x, 1 - part.y});
      for (int i = 0; i < static_cast<int>(all.size()); ++i) {
        double least = 1e9;
        for (const auto& [edge, length] : all[static_cast<std::size_t>(i)])
          least = std::min(least, at(edge, p) / length);
        if (i == triangle && least < 0) far = -1;
        far = std::min(far, std::abs(least));
      }
      for (const ivec2 s : subject_.places) {
        const dvec2 way = part - dvec2(s) / double{subpixels};
        // Lengths take long, and most samples are farther by far
        if (std::max(std::abs(way.x), std::abs(way.y)) < 1.001 * far) far = std::min(far, length_of(way));
      }
      if (far > 0.06 && far + 1 > farthest && seen_at(p) == triangle) far += 1;
      if (far <= farthest) continue;
      farthest = far;
      best = p;
    }
    return best;
  }
  /// Where two triangles pierce each other in the pixel.
  void put_pierced(View& view, ivec2 pixel) const {
    const int n = static_cast<int>(subject_.triangles.size());
    for (int i = 0; i < n; ++i) {
      for (int j = i + 1; j < n; ++j) {
        std::vector<dvec2> both = within(dvec2(pixel), dvec2(pixel) + 1.0, subject_.ring(i));
        const Edges edges = triangle_coverage::edges_of(subject_.triangle(j).corners);
        for (const Edge& e : edges) both = above_0(both, [&](dvec2 p) { return at(e, p); });
        const auto apart = [&](dvec2 p) { return depth(i, p) - depth(j, p); };
        std::vector<dvec2> ends;
        for (std::size_t k = 0; k < both.size(); ++k) {
          const dvec2 a = both[k], b = both[(k + 1) % both.size()];
          const double at_a = apart(a), at_b = apart(b);
          if ((at_a < 0) != (at_b < 0)) ends.push_back(a + at_a / (at_a - at_b) * (b - a));
        }
        if (ends.size() != 2) continue;
        const dvec2 p(pixel);
        view.add({fmt::format("e {} {}", i, j), Role::candidate,
                  Stroke{in_large(ends[0] - p), in_large(ends[1] - p), false, true}});
      }
    }
  }
  static double at(const Edge& e, dvec2 p) {
    const dvec2 from = dvec2(e.from) / double{subpixels}, to = dvec2(e.to) / double{subpixels};
    return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
  }
  double depth(int i, dvec2 p) const {
    const ScreenTriangle& triangle = subject_.triangle(i);
    const Edges edges = triangle_coverage::edges_of(triangle.corners);
    const dvec3& z = triangle.depth;
    const dvec3 w{at(edges[0], p), at(edges[1], p), at(edges[2], p)};
    return (w.x * z.x + w.y * z.y + w.z * z.z) / (w.x + w.y + w.z);
  }

  const Subject& subject_;
  int side_, zoom_, height_;
  ivec2 map_, large_;
};

}  // namespace gradus::adaptive
