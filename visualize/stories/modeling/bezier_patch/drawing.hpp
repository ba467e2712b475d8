#pragma once
// A patch with its net in space, and beside it the square of its parameters.

#include "stories/modeling/bezier_patch/subject.hpp"
#include "stories/rendered_surface.hpp"

namespace gradus::bezier_patch {

class PatchDrawing {
 public:
  /// at_hand: the place that is looked at, with tangents and normal; uv: where.
  PatchDrawing(const Words& words, const Net& net, const faces_subject::Reader& reader,
               const Frame<double>& at_hand, dvec2 uv)
      : reader_(reader), panel_(space, {}), size_(size_of(net.points)) {
    Extent extent;
    for (const dvec3 p : net.points) extent.add(reader.flat(p));
    for (const dvec3 way : {at_hand.along_u, at_hand.along_v, at_hand.normal})
      extent.add(reader.flat(at_hand.point + arrow(way)));
    panel_ = Panel(space, extent);
    add_surface(net);
    add_net(net);
    add_rows(words, net, uv.x);
    add_ways(words, net, uv);
    add_square(words);
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
  static constexpr int pieces = 32, step = 8;

  void add_surface(const Net& net) {
    const auto [points, faces] = on_grid(net, pieces, pieces);
    Extent shown;
    for (const dvec3 p : points) shown.add(reader_.flat(p));
    shown = widened(shown, 0.01);
    const dvec2 size = shown.size();
    constexpr double longer_side = 640;  // in pixels
    const std::vector<dvec3> normals = normals_on_grid(net, pieces);
    const auto picture = rendered_surface(
        points, faces,
        {.right = reader_.right,
         .up = reader_.up,
         .towards = reader_.towards,
         .shown = shown,
         .width = std::max(1, static_cast<int>(longer_side * std::min(1.0, size.x / size.y))),
         .normals = normals,
         .columns = pieces,
         .every = step});
    background_.add(
        {"a surface", Role::past, Picture{panel_.at(shown.lower), panel_.at(shown.upper), picture}});
  }
  /// Its lines; where the surface hides them, dashed.
  void add_net(const Net& net) {
    const auto [points, faces] = on_grid(net, pieces, pieces);
    std::vector<std::vector<dvec3>> rings;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto ring = faces[f];
      for (const std::size_t i : {1u, 2u}) {
        const std::vector<dvec3> part{points[static_cast<Index>(ring[0])],
                                      points[static_cast<Index>(ring[i])],
                                      points[static_cast<Index>(ring[i + 1])]};
        if (length_of(area_vector(part)) > 1e-9 * size_ * size_) rings.push_back(part);
      }
    }
    const HiddenLines hidden(rings, distant_viewer(reader_.towards), size_);
    const auto add = [&](const std::string& id, dvec3 a, dvec3 b) {
      if (a == b) return;
      int number = 0;
      for (const auto& [from, to, behind] : hidden.pieces(a, b))
        background_.add({fmt::format("n {} {}", id, number++), Role::input,
                         Stroke{at(a + from * (b - a)), at(a + to * (b - a)), false, behind, true}});
    };
    for (Index j = 0; j < net.rows(); ++j) {
      for (Index i = 0; i < net.columns; ++i) {
        if (i + 1 < net.columns) add(fmt::format("u {} {}", j, i), net(j, i), net(j, i + 1));
        if (j + 1 < net.rows()) add(fmt::format("v {} {}", j, i), net(j, i), net(j + 1, i));
        background_.add({fmt::format("o {} {}", j, i), Role::input, Dot{at(net(j, i)), true}});
      }
    }
  }
  /// Names of the rows, at their ends that lie further from the points that they leave.
  void add_rows(const Words& words, const Net& net, double u) {
    for (Index j = 0; j < net.rows(); ++j)
      background_.add({fmt::format("o name {}", j), Role::input,
                       Label{at(net(j, u < 0.5 ? net.columns - 1 : 0)), words.say("row", {{"row", j}})}});
  }
  /// Which way u and v go, beside the borders where the other one is 0; off the place at hand.
  void add_ways(const Words& words, const Net& net, dvec2 uv) {
    const dvec2 middle = at(de_casteljau(net, 0.5, 0.5).point);
    for (const int axis : {0, 1}) {
      const double from = uv[axis] < 0.5 ? 0.55 : 0.1;
      const auto border = [&](double t) {
        return at((axis == 0 ? de_casteljau(net, t, 0.0) : de_casteljau(net, 0.0, t)).point);
      };
      const dvec2 a = border(from), b = border(from + 0.35);
      const double length = length_between(a, b);
      if (length < 1) continue;
      const dvec2 way = (b - a) / length;
      dvec2 aside{-way.y, way.x};
      if (glm::dot(aside, middle - a) > 0) aside = -aside;
      const std::string name = words.symbol(axis == 0 ? "u" : "v");
      background_.add({"p way " + name, Role::guide, Stroke{a + 0.7 * aside, b + 0.7 * aside, true}});
      background_.add({"p way name " + name, Role::guide, Text{(a + b) * 0.5 + 1.6 * aside, name}});
    }
  }
  void add_square(const Words& words) {
    for (int k = 0; k <= pieces; k += step) {
      const double t = static_cast<double>(k) / pieces;
      background_.add({fmt::format("aside p u {}", k), Role::past,
                       Stroke{in_square({t, 0}), in_square({t, 1}), false, false, true}});
      background_.add({fmt::format("aside p v {}", k), Role::past,
                       Stroke{in_square({0, t}), in_square({1, t}), false, false, true}});
    }
    background_.add(
        {"aside p name u", Role::guide, Text{in_square({1, 0}) + dvec2{0.1, -1.1}, words.symbol("u")}});
    background_.add(
        {"aside p name v", Role::guide, Text{in_square({0, 1}) + dvec2{-0.9, 0}, words.symbol("v")}});
  }

  const faces_subject::Reader& reader_;
  Panel panel_;
  double size_;
  View background_{};
};

}  // namespace gradus::bezier_patch
