#pragma once
// The solid itself, cut open at z = 0: of each pixel a ray, whose first end inside says what is seen there.

#include <memory>

#include "core/image.hpp"
#include "modeling/csg_tree/skipping.hpp"
#include "stories/modeling/csg_tree/subject.hpp"

namespace gradus::csg_tree {

/// The extent of all leaves that have one, and of the ray.
inline Extent extent_of(const Subject& subject) {
  Extent extent;
  for (const Node<double>& node : subject.tree) {
    if (const auto* box = std::get_if<Box<double>>(&node.solid)) {
      extent.add(box->lower);
      extent.add(box->upper);
    } else if (const auto* ball = std::get_if<Ball<double>>(&node.solid)) {
      extent.add(dvec2(ball->centre) - ball->radius);
      extent.add(dvec2(ball->centre) + ball->radius);
    } else if (const auto* c = std::get_if<Cylinder<double>>(&node.solid); c && c->axis == 2) {
      extent.add(dvec2(c->centre) - c->radius);
      extent.add(dvec2(c->centre) + c->radius);
    }
  }
  extent.add(subject.from);
  extent.add(subject.to);
  return extent;
}

inline Extent with(Extent extent, dvec2 p) {
  extent.add(p);
  return extent;
}

/// Out of a leaf, where its surface is passed.
inline dvec3 normal_at(const Solid<double>& solid, dvec3 x) {
  if (const auto* half = std::get_if<HalfSpace<double>>(&solid)) return unit_vector(half->normal);
  if (const auto* ball = std::get_if<Ball<double>>(&solid)) return unit_vector(x - ball->centre);
  if (const auto* c = std::get_if<Cylinder<double>>(&solid)) {
    dvec3 off = x - c->centre;
    off[c->axis] = 0;
    return unit_vector(off);
  }
  // A box: of the nearest face
  const auto& box = std::get<Box<double>>(solid);
  dvec3 normal(0);
  double nearest = 1e300;
  for (int i = 0; i < 3; ++i) {
    for (const bool upper : {false, true}) {
      const double off = std::abs(x[i] - (upper ? box.upper : box.lower)[i]);
      if (off >= nearest) continue;
      nearest = off;
      normal = dvec3(0);
      normal[i] = upper ? 1 : -1;
    }
  }
  return normal;
}

class SolidPicture {
 public:
  SolidPicture(const Subject& subject, DNodes tree, const Extent& its_place) {
    // What lies behind the section, as far as it reaches
    const Extent extent = extent_of(subject);
    const Index root = subject.root();
    const Box<double> behind{dvec3(extent.lower, -6), dvec3(extent.upper, 0)};
    add_leaf<double>(tree, behind);
    add_node(tree, Op::intersect, root, root + 1);
    const Boxes<double> boxes = boxes_of<double>(tree);
    const Box<double>& box = boxes.back();
    Extent seen;
    for (int corner = 0; corner < 8 && box.lower.x < box.upper.x; ++corner) {
      const dvec3 p{(corner & 1 ? box.upper : box.lower).x, (corner & 2 ? box.upper : box.lower).y,
                    (corner & 4 ? box.upper : box.lower).z};
      seen.add({glm::dot(p, right), glm::dot(p, up)});
    }
    if (!(seen.lower.x < seen.upper.x && seen.lower.y < seen.upper.y)) return;
    const double scale = std::min(its_place.size().x / seen.size().x, its_place.size().y / seen.size().y);
    const dvec2 half = 0.5 * scale * seen.size();
    place = {its_place.centre() - half, its_place.centre() + half};
    const ivec2 size = glm::max(ivec2(dvec2(pixels_per_unit) * place.size()), ivec2(1));
    const auto made = std::make_shared<Image>(size.x, size.y);
    for (int row = 0; row < size.y; ++row) {
      for (int column = 0; column < size.x; ++column) {
        const dvec2 part{(column + 0.5) / size.x, (row + 0.5) / size.y};
        const double x = seen.lower.x + part.x * seen.size().x, y = seen.upper.y - part.y * seen.size().y;
        (*made)[{column, row}] =
            seen_along(tree, boxes, {x * right + y * up + far * towards, -towards, 2 * far});
      }
    }
    image = made;
  }

  Extent place{};
  std::shared_ptr<const Image> image{};

 private:
  static constexpr double pixels_per_unit = 18, far = 100;
  const dvec3 towards = unit_vector(dvec3(0.5, 0.55, 1)), light = unit_vector(dvec3(0.2, 0.9, 0.45));
  const dvec3 right = unit_vector(glm::cross(dvec3(0, 1, 0), towards)), up = glm::cross(towards, right);

  /// The leaf whose end is the first one has it bit for bit.
  Rgba8 seen_along(const DNodes& tree, const Boxes<double>& boxes, const DRay& ray) const {
    const DEnds ends = skipping<double>(tree, boxes, ray);
    if (ends.empty()) return {0, 0, 0, 0};
    for (Index i = 0; i < tree.size(); ++i) {
      if (!is_leaf(tree[i])) continue;
      const DEnds its = ends_in(tree[i].solid, ray);
      if (std::ranges::find(its, ends.front()) == its.end()) continue;
      dvec3 normal = normal_at(tree[i].solid, ray.from + ends.front() * ray.way);
      if (glm::dot(normal, towards) < 0) normal = -normal;
      const double lit = std::max(0.0, glm::dot(normal, light));
      const bool is_cut = i + 2 == tree.size();
      const dvec3 colour = is_cut ? dvec3(134, 188, 226) : (0.35 + 0.65 * lit) * dvec3(196, 190, 176);
      return {static_cast<std::uint8_t>(colour.x), static_cast<std::uint8_t>(colour.y),
              static_cast<std::uint8_t>(colour.z), 255};
    }
    return {0, 0, 0, 0};
  }
};

}  // namespace gradus::csg_tree
