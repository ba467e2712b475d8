#pragma once
// The section at z = 0 with the ray in it, and below, one under the other, where the ray is in each node:
// what lies above each other lies at the same t.

#include "core/arithmetic/elementary.hpp"
#include "stories/modeling/csg_tree/picture.hpp"
#include "stories/past.hpp"

namespace gradus::csg_tree {

constexpr int paper_width = 36, paper_height = 27;

using Ring2 = std::vector<dvec2>;

// --- Regions

/// What a node fills of a frame, found by rays along x: rings, each between two neighbouring ends of rows,
/// and its outline, which goes along their sides and where one row is inside and the next is not.
class Region {
 public:
  explicit Region(const Extent& frame) : frame_(frame) {}

  /// Where a row is inside.
  void add_row(double y, const DEnds& ends) {
    if (ends.size() != open_.size() * 2) {
      close();
      add_caps(y, merged(Op::subtract, before_, ends));
      add_caps(y, merged(Op::subtract, ends, before_));
    }
    before_ = ends;
    open_.resize(ends.size() / 2);
    for (Index k = 0; k < open_.size(); ++k) {
      open_[k].left.push_back({ends[2 * k], y});
      open_[k].right.push_back({ends[2 * k + 1], y});
    }
  }
  void close() {
    for (auto& [left, right] : open_) {
      add_side(left, frame_.lower.x);
      add_side(right, frame_.upper.x);
      left.insert(left.end(), right.rbegin(), right.rend());
      rings_.push_back(without_straight(left));
    }
    open_.clear();
  }
  const std::vector<Ring2>& rings() const { return rings_; }
  const std::vector<Ring2>& outline() const { return outline_; }

 private:
  struct Sides {
    Ring2 left{}, right{};
  };
  /// Where the frame ends the region goes on.
  void add_side(const Ring2& side, double border) {
    const Ring2 line = without_straight(side);
    if (std::ranges::any_of(line, [&](dvec2 p) { return p.x != border; })) outline_.push_back(line);
  }
  void add_caps(double y, const DEnds& ends) {
    for (Index k = 0; k < ends.size() && y > frame_.lower.y; k += 2) {
      if (ends[k + 1] - ends[k] > 1e-6 * frame_.size().x)
        outline_.push_back({{ends[k], y}, {ends[k + 1], y}});
    }
  }
  /// Its ends and its corners alone.
  static Ring2 without_straight(const Ring2& line) {
    Ring2 kept;
    for (Index i = 0; i < line.size(); ++i) {
      const bool is_end = i == 0 || i + 1 == line.size();
      const dvec2 p = is_end ? dvec2(0) : line[i] - kept.back(),
                  q = is_end ? dvec2(0) : line[i + 1] - line[i];
      if (is_end || std::abs(p.x * q.y - p.y * q.x) > 1e-9 * length_of(p) * length_of(q))
        kept.push_back(line[i]);
    }
    return kept;
  }

  Extent frame_;
  DEnds before_{};
  std::vector<Sides> open_{};
  std::vector<Ring2> rings_{}, outline_{};
};

/// Of each node what it fills of a frame in the plane z = 0. along(tree, ray): the ends of all nodes.
template <class Along>
std::vector<Region> regions_of(const DNodes& tree, const Extent& frame, const Along& along) {
  std::vector<double> heights;
  constexpr int rows = 96;
  for (int k = 0; k <= rows; ++k) heights.push_back(frame.lower.y + (frame.size().y * k) / rows);
  const double beside = 1e-9 * frame.size().y;
  const auto add = [&](double y) { heights.insert(heights.end(), {y - beside, y + beside}); };
  for (const Node<double>& node : tree) {
    if (const auto* box = std::get_if<Box<double>>(&node.solid)) add(box->lower.y), add(box->upper.y);
    const auto* c = std::get_if<Cylinder<double>>(&node.solid);
    const auto* b = std::get_if<Ball<double>>(&node.solid);
    if (!c && !b) continue;
    add((c ? c->centre.y : b->centre.y) - (c ? c->radius : b->radius));
    add((c ? c->centre.y : b->centre.y) + (c ? c->radius : b->radius));
  }
  std::ranges::sort(heights);
  std::vector<Region> regions(tree.size(), Region(frame));
  for (const double y : heights) {
    if (y < frame.lower.y || frame.upper.y < y) continue;
    std::vector<DEnds> on = along(tree, {{frame.lower.x, y, 0}, {1, 0, 0}, frame.size().x});
    for (Index i = 0; i < tree.size(); ++i) {
      for (double& t : on[i]) t += frame.lower.x;
      regions[i].add_row(y, on[i]);
    }
  }
  for (Region& region : regions) region.close();
  return regions;
}

// --- The section

class Section {
 public:
  template <class Along>
  Section(const Subject& subject, const Extent& world, const Extent& place, const Along& along)
      : subject_(subject),
        panel_(tight_panel(place, widened(world, 0.02))),
        regions_(regions_of(subject.tree, panel_.shown(), along)) {}

  const Panel& panel() const { return panel_; }
  dvec2 at(dvec2 p) const { return panel_.at(p); }
  dvec2 at_t(double t) const {
    const DRay ray = subject_.ray();
    return at(dvec2(ray.from + t * ray.way));
  }

  void add_region(View& view, const std::string& id, Role role, Index node) const {
    const Region& region = regions_[node];
    for (std::size_t k = 0; k < region.outline().size(); ++k)
      view.add({fmt::format("{} outline {:02}", id, k), role, Path{panel_.at(region.outline()[k])}});
    std::vector<Ring2> rings;
    for (const Ring2& ring : region.rings()) rings.push_back(panel_.at(ring));
    if (!rings.empty()) view.add({id, role, Area{std::move(rings)}});
  }
  void add_leaves(View& view) const {
    for (const Index i : subject_.leaves()) add_leaf(view, fmt::format("b leaf {}", i), Role::input, i);
  }
  void add_leaf(View& view, const std::string& id, Role role, Index node) const {
    const dvec2 beside = add_outline(view, id, role, node, false);
    view.add({id + " name", role, Label{at(beside), name_of(subject_.tree, node)}});
  }
  /// Its outline, as far as it is shown; where its name may stand.
  dvec2 add_outline(View& view, const std::string& id, Role role, Index node, bool dashed) const {
    const Solid<double>& solid = subject_.tree[node].solid;
    if (const auto* box = std::get_if<Box<double>>(&solid)) {
      view.add({id, role, Path{panel_.at(Extent{box->lower, box->upper}.corners()), true, dashed}});
      return {box->lower.x, box->upper.y};
    }
    if (const auto* half = std::get_if<HalfSpace<double>>(&solid))
      return add_line(view, id, role, half->on, {-half->normal.y, half->normal.x}, dashed);
    const auto* c = std::get_if<Cylinder<double>>(&solid);
    const auto* b = std::get_if<Ball<double>>(&solid);
    const dvec2 centre = c ? c->centre : b->centre;
    const double radius = c ? c->radius : b->radius;
    if (c && c->axis < 2) return add_band(view, id, role, centre, radius, c->axis, dashed);
    return add_circle(view, id, role, centre, radius, dashed);
  }

  void add_ray(View& view, const std::string& symbol) const {
    view.add({"d ray", Role::measure, Stroke{at(subject_.from), at(subject_.to), true}});
    view.add({"d ray name", Role::measure, Label{at(subject_.to), symbol}});
    view.add({"d ray begin", Role::measure, Dot{at(subject_.from)}});
  }
  /// Where the ray is inside, with the t of its ends.
  void add_inside(View& view, Role role, const DEnds& ends) const {
    for (Index k = 0; k < ends.size(); ++k) {
      if (k % 2 == 0)
        view.add({fmt::format("e inside {}", k), role, Stroke{at_t(ends[k]), at_t(ends[k + 1])}});
      const std::string id = fmt::format("f end {}", k);
      if (has_room(ends, k))
        view.add_named(id, role, at_t(ends[k]), figure_real(ends[k]));
      else
        view.add({id, role, Dot{at_t(ends[k])}});
    }
  }

 private:
  /// Whether an end's number has room between its neighbours.
  bool has_room(const DEnds& ends, Index k) const {
    constexpr double least = 2;  // on paper
    const auto apart = [&](Index i, Index j) { return length_between(at_t(ends[i]), at_t(ends[j])); };
    return (k == 0 || apart(k - 1, k) >= least) && (k + 1 == ends.size() || apart(k, k + 1) >= least);
  }
  dvec2 add_line(View& view, const std::string& id, Role role, dvec2 on, dvec2 way, bool dashed) const {
    const Extent frame = panel_.shown();
    const auto [first, last] = span_in(frame, on, way, -1e9, 1e9);
    if (!(first < last)) return on;
    view.add({id, role, Stroke{at(on + first * way), at(on + last * way), false, dashed}});
    return on + last * way;
  }
  dvec2 add_band(View& view, const std::string& id, Role role, dvec2 centre, double radius, int axis,
                 bool dashed) const {
    const dvec2 way(axis == 0, axis == 1), aside(axis == 1, axis == 0);
    add_line(view, id + " low", role, centre - radius * aside, way, dashed);
    return add_line(view, id, role, centre + radius * aside, way, dashed);
  }
  dvec2 add_circle(View& view, const std::string& id, Role role, dvec2 centre, double radius,
                   bool dashed) const {
    constexpr int corners = 64;
    Ring2 circle;
    for (int k = 0; k < corners; ++k) {
      const double turn = 2 * 3.14159265358979 * k / corners;
      circle.push_back(at(centre + radius * dvec2{gradus::cos(turn), gradus::sin(turn)}));
    }
    view.add({id, role, Path{circle, true, dashed}});
    return centre + radius * dvec2{0.6, 0.8};
  }

  const Subject& subject_;
  Panel panel_;
  std::vector<Region> regions_;
};

// --- The nodes' bars

/// One row per node, operands above what is made of them.
class Rows {
 public:
  explicit Rows(const DNodes& tree) : tree_(tree), depth_(tree.size()) {
    for (Index i = tree.size(); i-- > 0;) {
      if (!is_leaf(tree[i])) depth_[tree[i].a] = depth_[tree[i].b] = depth_[i] + 1;
    }
    height_ = std::min(2.4, 14.7 / static_cast<double>(tree.size()));
  }
  double top() const { return y_of(0) + 0.5 * height_; }
  double y_of(Index node) const { return foot + height_ * (static_cast<double>(tree_.size() - node) - 0.5); }

  /// The node's name, and lines to its operands.
  void add_name(View& view, Index i, Role role, const std::string& text) const {
    const double x = x_of(i), y = y_of(i);
    view.add({fmt::format("t name {:02}", i), role, Text{{x, y}, text, Align::left}});
    if (is_leaf(tree_[i])) return;
    const double trunk = x + 0.45, far = y_of(tree_[i].a);
    for (const Index operand : {tree_[i].a, tree_[i].b})
      view.add({fmt::format("s branch {:02}", operand), Role::guide,
                Stroke{{trunk, y_of(operand)}, {x_of(operand) - 0.25, y_of(operand)}, false, false, true}});
    view.add({fmt::format("s trunk {:02}", i), Role::guide,
              Stroke{{trunk, far}, {trunk, y + 0.42 * height_}, false, false, true}});
  }
  /// x(t): where t is shown.
  template <class At>
  void add_bar(View& view, const std::string& id, Index i, Role role, const DEnds& ends, const At& x) const {
    const double y = y_of(i), half = 0.3 * height_;
    if (ends.empty()) view.add({fmt::format("{} {:02}", id, i), role, Text{{bars + 1.4, y}, "∅"}});
    for (Index k = 0; k + 1 < ends.size(); k += 2) {
      const Ring2 bar = Extent{
          {std::min(x(ends[k]), x(ends[k + 1])), y - half},
          {std::max(x(ends[k]), x(ends[k + 1])),
           y + half}}.corners();
      const std::string its = fmt::format("{} {:02} {}", id, i, k);
      view.add({its, role, Area{{bar}, role == Role::current || role == Role::result ? 2 : 0}});
      view.add({its + " outline", role, Path{bar, true}});
    }
  }

  static constexpr double foot = 3.1, bars = 9.6;

 private:
  double x_of(Index i) const { return 0.2 + 0.9 * static_cast<double>(depth_[i]); }

  const DNodes& tree_;
  std::vector<Index> depth_;
  double height_;
};

/// Both, and the scale of t below. Rays to the right have their t where they run; of others it has a scale of
/// its own.
class RayDrawing {
 public:
  /// made: the tree of the solid that comes out.
  template <class Along>
  RayDrawing(const Subject& subject, const DNodes& made, const Extent& world, const Along& along)
      : rows_(subject.tree),
        section_(subject, world, {{Rows::bars, rows_.top() + 0.9}, {paper_width - 0.4, paper_height - 0.4}},
                 along),
        picture_(subject, made, picture_place()),
        last_(subject.ray().last),
        aligned_(subject.ray().way.x >= 0.5) {}

  const Section& section() const { return section_; }
  const Rows& rows() const { return rows_; }
  void add_picture(View& view) const {
    view.add(
        {"x solid", Role::guide, Picture{picture_.place.lower, picture_.place.upper, picture_.image, true}});
  }
  double x_of(double t) const {
    if (aligned_) return section_.at_t(t).x;
    return Rows::bars + 0.4 + t / last_ * (paper_width - 2 - Rows::bars);
  }
  void add_scale(View& view, const std::string& symbol) const {
    constexpr double y = Rows::foot - 0.5;
    NumberLine({x_of(0), y}, {x_of(last_), y}, 0, last_).add_to(view, "w t", symbol, 6);
  }
  void add_bar(View& view, Index node, Role role, const DEnds& ends) const {
    rows_.add_bar(view, "u bar", node, role, ends, [&](double t) { return x_of(t); });
  }
  /// From the ray down to a node's bar.
  void add_drops(View& view, Index node, Role role, const DEnds& ends) const {
    if (!aligned_) return;
    for (Index k = 0; k < ends.size(); ++k)
      view.add({fmt::format("c drop {}", k), role,
                Stroke{section_.at_t(ends[k]), {x_of(ends[k]), rows_.y_of(node)}, false, true, true}});
  }

 private:
  /// Beside the section.
  Extent picture_place() const {
    const Extent& its = section_.panel().place();
    return {{0.6, its.lower.y + 0.4}, {Rows::bars - 1, std::max(its.upper.y - 0.4, its.lower.y + 6)}};
  }

  Rows rows_;
  Section section_;
  SolidPicture picture_;
  double last_;
  bool aligned_;
};

}  // namespace gradus::csg_tree
