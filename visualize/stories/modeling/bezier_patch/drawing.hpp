#pragma once
// A patch with its net in space, and beside it the square of its parameters.

#include "stories/modeling/bezier_patch/subject.hpp"

namespace gradus::bezier_patch {

class PatchDrawing {
 public:
  /// at_hand: the place that is looked at, with tangents and normal.
  PatchDrawing(const Net& net, const faces_subject::Reader& reader, const Frame<double>& at_hand)
      : reader_(reader), panel_(space, {}), size_(size_of(net.points)) {
    Extent extent;
    for (const dvec3 p : net.points) extent.add(reader.flat(p));
    for (const dvec3 way : {at_hand.along_u, at_hand.along_v, at_hand.normal})
      extent.add(reader.flat(at_hand.point + arrow(way)));
    panel_ = Panel(space, extent);
    SpaceDrawing drawing(reader_.look(panel_));
    add_surface(drawing, net);
    add_net(drawing, net);
    drawing.add_to(background_, "a");
    // A net may pass through its surface: not worth lines
    std::erase_if(background_.marks, [](const auto& mark) { return mark.first.starts_with("s meets "); });
    for (std::size_t i = 0; i < net.points.size(); ++i)
      background_.add({fmt::format("n point {:02}", i), Role::input, Dot{at(net.points[i]), true}});
    add_square();
  }

  const View& background() const { return background_; }
  const Panel& panel() const { return panel_; }
  dvec2 at(dvec3 p) const { return panel_.at(reader_.flat(p)); }
  Path path(const Points<double>& points, bool dashed = false) const {
    return {mapped(points, [&](dvec3 p) { return at(p); }), false, dashed};
  }
  /// Where (u, v) lies in the square.
  static dvec2 in_square(dvec2 uv) { return square.lower + uv * square.size(); }
  /// A direction as an arrow so long that it is seen; none where there is no direction.
  dvec3 arrow(dvec3 way) const { return 0.28 * size_ * unit_vector(way); }
  /// The largest side of the net.
  double size() const { return size_; }

 private:
  static constexpr Extent space{{0.3, 0.6}, {25.6, 26.4}}, square{{27.4, 2.6}, {34.6, 9.8}};
  /// Faces along each side, and from line to line.
  static constexpr int pieces = 24, step = 6;

  void add_surface(SpaceDrawing& drawing, const Net& net) const {
    const auto [points, faces] = on_grid(net, pieces, pieces);
    const auto point = [&](int k, int i) { return points[static_cast<Index>(k * (pieces + 1) + i)]; };
    const SpaceLook look = reader_.look(panel_);
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto corners = faces[f];
      std::vector<dvec3> ring;
      for (const auto v : corners) ring.push_back(points[static_cast<Index>(v)]);
      // Bent: as two triangles in one shade
      const int shade = shade_of(look.turned(area_vector(ring)));
      for (const std::size_t i : {1u, 2u}) {
        const std::vector<dvec3> part{ring[0], ring[i], ring[i + 1]};
        if (length_of(area_vector(part)) > 1e-9 * size_ * size_)
          drawing.add(
              SpaceFace{.id = "s", .role = Role::past, .ring = part, .one_sided = false, .shade = shade});
      }
    }
    for (int k = 0; k <= pieces; k += step) {
      for (int i = 0; i < pieces; ++i) {
        add_line(drawing, fmt::format("g {} {}", k, i), point(k, i), point(k, i + 1));
        add_line(drawing, fmt::format("h {} {}", k, i), point(i, k), point(i + 1, k));
      }
    }
  }
  static void add_line(SpaceDrawing& drawing, const std::string& id, dvec3 a, dvec3 b) {
    if (a != b) drawing.add(SpaceEdge{.id = id, .role = Role::past, .a = a, .b = b, .thin = true});
  }
  static void add_net(SpaceDrawing& drawing, const Net& net) {
    const auto add = [&](std::string_view way, Index j, Index i, dvec3 to) {
      const dvec3 from = net(j, i);
      if (from != to)
        drawing.add(SpaceEdge{.id = fmt::format("n {} {} {}", way, j, i),
                              .role = Role::input,
                              .a = from,
                              .b = to,
                              .thin = true});
    };
    for (Index j = 0; j < net.rows(); ++j) {
      for (Index i = 0; i < net.columns; ++i) {
        if (i + 1 < net.columns) add("u", j, i, net(j, i + 1));
        if (j + 1 < net.rows()) add("v", j, i, net(j + 1, i));
      }
    }
  }
  void add_square() {
    for (int k = 0; k <= pieces; k += step) {
      const double t = static_cast<double>(k) / pieces;
      background_.add({fmt::format("p u {}", k), Role::past,
                       Stroke{in_square({t, 0}), in_square({t, 1}), false, false, true}});
      background_.add({fmt::format("p v {}", k), Role::past,
                       Stroke{in_square({0, t}), in_square({1, t}), false, false, true}});
    }
    background_.add({"p name u", Role::guide, Text{in_square({1, 0}) + dvec2{0.1, -1.1}, "u"}});
    background_.add({"p name v", Role::guide, Text{in_square({0, 1}) + dvec2{-0.9, 0}, "v"}});
  }

  const faces_subject::Reader& reader_;
  Panel panel_;
  double size_;
  View background_{};
};

}  // namespace gradus::bezier_patch
