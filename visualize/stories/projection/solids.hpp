#pragma once
// The convex solids that the stories of projections show, and how they are drawn: in space with the picture
// plane, seen from the viewer's right, and beside it in the picture.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "core/geometry.hpp"
#include "figure/text/wording.hpp"
#include "stories/space_drawing.hpp"
#include "stories/topic.hpp"

namespace gradus::solids {

/// An edge between two corners, and the faces on its two sides.
struct Edge {
  std::size_t a, b;
  std::size_t left, right;
};

/// A convex body in view space.
struct Solid {
  std::vector<dvec3> corners;
  std::vector<std::vector<std::size_t>> faces;
  std::vector<Edge> edges;
};

inline dvec3 centre_of(const std::vector<dvec3>& points) {
  dvec3 sum{0};
  for (const dvec3 p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

/// The normal of a face, outwards: away from the solid's middle, whichever way its corners run.
inline dvec3 outward(const Solid& solid, std::size_t face) {
  const std::vector<std::size_t>& corners = solid.faces[face];
  const dvec3 a = solid.corners[corners[0]];
  const dvec3 normal = glm::cross(solid.corners[corners[1]] - a, solid.corners[corners[2]] - a);
  return glm::dot(normal, a - centre_of(solid.corners)) < 0 ? -normal : normal;
}

inline Solid with_edges(Solid solid) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> sides;
  for (std::size_t face = 0; face < solid.faces.size(); ++face) {
    const std::vector<std::size_t>& corners = solid.faces[face];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto [a, b] = std::minmax(corners[i], corners[(i + 1) % corners.size()]);
      sides[{a, b}].push_back(face);
    }
  }
  for (const auto& [ends, faces] : sides)
    solid.edges.push_back({ends.first, ends.second, faces[0], faces[1]});
  return solid;
}

/// 3 deep, its middle at the origin: the front's corners, then the back's. Faces: these two, then the sides.
inline Solid prism(const std::vector<dvec2>& outline) {
  Solid solid;
  for (const double z : {-1.5, 1.5}) {
    for (const dvec2 p : outline) solid.corners.emplace_back(p, z);
  }
  const std::size_t n = outline.size();
  solid.faces.resize(2);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    solid.faces[0].push_back(i);
    solid.faces[1].push_back(n + i);
    solid.faces.push_back({i, next, n + next, n + i});
  }
  return with_edges(std::move(solid));
}

/// 2 wide, 2 high, 3 deep, its middle at the origin. Corners 0 to 3 are the front's, 4 to 7 the back's.
inline Solid box() { return prism({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}); }

/// The same with a roof: corners 0 to 4 are the front's, counter-clockwise from the lower left, 5 to 9 the
/// back's.
inline Solid house() { return prism({{-1, -1}, {1, -1}, {1, 0.2}, {0, 1}, {-1, 0.2}}); }

/// The directions of a solid's own x, y and z after a turn round the upright, then one round x, in degrees.
/// Accuracy: multiples of 90 degrees are exact, and the turn round the upright leaves y exactly alone.
inline std::array<dvec3, 3> turned_axes(double yaw, double pitch) {
  const auto [sy, cy] = sin_cos_degrees(yaw);
  const auto [sp, cp] = sin_cos_degrees(pitch);
  const auto turned = [&](dvec3 p) {
    const dvec3 q{cy * p.x + sy * p.z, p.y, cy * p.z - sy * p.x};
    return dvec3{q.x, cp * q.y - sp * q.z, sp * q.y + cp * q.z};
  };
  return {turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1})};
}

/// Turned, then its middle moved to `at`.
inline Solid placed(Solid solid, const std::array<dvec3, 3>& axes, dvec3 at) {
  for (dvec3& p : solid.corners) p = at + p.x * axes[0] + p.y * axes[1] + p.z * axes[2];
  return solid;
}

/// What a viewer sees of a solid. It is convex, so an edge is hidden that lies between two faces
/// which look away.
struct Facing {
  std::vector<bool> seen;    ///< of its faces
  std::vector<bool> hidden;  ///< of its edges
};
/// looks(normal, corner): whether the face does that has this normal outwards, and one of its corners here.
template <class Looks>
Facing facing(const Solid& solid, Looks looks) {
  Facing facing;
  for (std::size_t i = 0; i < solid.faces.size(); ++i) {
    facing.seen.push_back(looks(outward(solid, i), solid.corners[solid.faces[i][0]]));
  }
  for (const Edge& edge : solid.edges)
    facing.hidden.push_back(!facing.seen[edge.left] && !facing.seen[edge.right]);
  return facing;
}
/// For parallel projectors that run on from the viewer in this direction.
inline Facing facing_along(const Solid& solid, dvec3 direction) {
  return facing(solid, [&](dvec3 normal, dvec3) { return glm::dot(normal, direction) < -1e-12; });
}
/// For an eye at the origin.
inline Facing facing_origin(const Solid& solid) {
  return facing(solid, [](dvec3 normal, dvec3 at) { return glm::dot(normal, at) < -1e-12; });
}

/// View space as one sees it from the viewer's right: depth to the right, x towards the reader.
inline dvec2 from_right(dvec3 p) { return oblique(dvec3{p.z, p.y, p.x}); }
/// Where that looks, in view space.
inline constexpr dvec3 looking_from_right{-1, -0.3, -0.42};
/// The corner nearest to such a viewer: the handle of a solid.
inline dvec3 nearest_corner(const Solid& solid) {
  return *std::ranges::min_element(solid.corners, {},
                                   [](dvec3 p) { return glm::dot(p, looking_from_right); });
}
/// A direction of view space as the viewer has it: right, up, towards him.
inline dvec3 seen_by_viewer(dvec3 p) { return {p.x, p.y, -p.z}; }

/// The picture plane in space, with the directions that are right and up in the picture.
struct Sheet {
  dvec3 origin{0}, right{1, 0, 0}, up{0, 1, 0};
  dvec2 picture(dvec3 p) const { return {glm::dot(p - origin, right), glm::dot(p - origin, up)}; }
  dvec3 place(dvec2 p) const { return origin + p.x * right + p.y * up; }
};

/// Of numbers beside a solid of size 2: what figures can show.
inline constexpr Sizes modest_sizes{1e-6, 1e6};

/// The three numbers of an argument.
inline dvec3 vector_of(const Arguments& arguments, std::string_view name) {
  return arguments.place(name).value();
}

/// A number as these stories show it: what is but a rounding error of the figure is 0.
inline std::string real(double value) { return figure_real(value, 1e-9); }
/// The same with two decimals, for tables.
inline std::string short_real(double value) {
  return real(static_cast<double>(std::llround(std::clamp(value, -1e12, 1e12) * 100)) / 100);
}
template <int N>
std::string place_text(const glm::vec<N, double>& p) {
  return figure_place(p, short_real);
}
/// With as many decimals as other numbers, for sums that a reader may check.
inline std::string full_place_text(dvec3 p) { return figure_place(p, real); }

constexpr int paper_width = 36, paper_height = 24;

/// Where space and the picture are drawn; with an eye space again, from the side.
struct Places {
  Extent space, picture, side{};
};
inline constexpr Places places_with_eye{
    {{0.8, 11.8}, {20, 22.2}}, {{22, 0.8}, {35.2, 22.2}}, {{2.2, 4.2}, {20, 9.2}}};
inline Places places_for(dvec2 space, dvec2 picture) {
  constexpr double left = 0.8, right = 35.2, bottom = 0.8, top = 22.2, gap = 1.6;
  const auto aspect = [](dvec2 size) { return size.y > 0 ? std::clamp(size.x / size.y, 0.2, 5.0) : 1.0; };
  const double of_space = aspect(space), of_picture = aspect(picture);
  const double height = std::min(top - bottom, (right - left - gap) / (of_space + of_picture));
  const double upper = std::min(0.56 * (top - bottom - gap), (right - left) / of_space);
  const double lower = std::min(top - bottom - gap - upper, (right - left) / of_picture);
  if (height * height >= upper * lower) {
    const double spare = right - left - gap - height * (of_space + of_picture);
    const double middle = left + height * of_space + spare / 2;
    return {{{left, bottom}, {middle, top}}, {{middle + gap, bottom}, {right, top}}};
  }
  return {{{left, top - upper}, {right, top}}, {{left, bottom}, {right, bottom + lower}}};
}

/// The drawing of a solid, a projector and the picture.
class Scenery {
 public:
  using Images = std::vector<std::optional<dvec3>>;

  /// eye: the point that all projectors run to, or nothing where they are parallel. images: of all corners,
  /// as they will be; other: what else the picture has to have room for.
  Scenery(const Wording& words, Solid solid, Sheet sheet, Facing facing, std::optional<dvec3> eye,
          const Images& images, const std::vector<dvec3>& other = {})
      : words_(words),
        solid_(std::move(solid)),
        sheet_(sheet),
        facing_(std::move(facing)),
        eye_(eye),
        images_(images) {
    Extent picture;
    for (const std::optional<dvec3>& p : images) {
      if (p) picture.add(sheet_.picture(*p));
    }
    for (const dvec3 p : other) picture.add(sheet_.picture(p));
    if (picture.lower.x > picture.upper.x) picture = {{-1, -1}, {1, 1}};
    patch_ = widened(picture, 0.15);
    Extent space;
    for (const dvec3 p : solid_.corners) space.add(from_right(p));
    for (const dvec3 p : outline()) space.add(from_right(p));
    if (eye_) space.add(from_right(*eye_));
    const Places places = eye_ ? places_with_eye : places_for(space.size(), patch_.size());
    space_ = Panel(places.space, space);
    picture_ = Panel(places.picture, patch_);
    space_top_ = space_.at(space.upper).y;
    picture_top_ = picture_.at(patch_.upper).y;
    if (!eye_) return;
    Extent side{dvec2{0}, dvec2{0}};
    for (const dvec3 p : solid_.corners) side.add({p.z, p.y});
    for (const dvec3 p : outline()) side.add({p.z, p.y});
    side_ = Panel(places.side, side);
    side_extent_ = side;
  }

  /// The same with the picture alone, as large as the paper.
  Scenery picture_alone() const {
    Scenery alone = *this;
    alone.picture_ = Panel({{0.8, 0.8}, {paper_width - 0.8, paper_height - 0.8}}, patch_);
    return alone;
  }

  const Sheet& sheet() const { return sheet_; }
  dvec2 in_space(dvec3 p) const { return space_.at(from_right(p)); }
  dvec2 in_picture(dvec3 p) const { return picture_.at(sheet_.picture(p)); }
  /// Where the solid is drawn, if it moves from `from` to `to`.
  dvec2 moved_in_space(dvec3 from, dvec3 to) const { return in_space(nearest_corner(solid_) + (to - from)); }
  /// The lower left corner of the plane as far as it is drawn, or of such a part of another plane; the upper
  /// right one.
  dvec3 lower_corner(const Sheet& sheet) const { return sheet.place(patch_.lower); }
  dvec3 upper_corner(const Sheet& sheet) const { return sheet.place(patch_.upper); }

  /// Space as the reader sees it, from the viewer's right.
  SpaceDrawing space() const {
    return SpaceDrawing({.viewer = distant_viewer(-looking_from_right),
                         .at = [this](dvec3 p) { return std::optional(in_space(p)); },
                         .right = {0, 0, 1},
                         .towards = {1, 0, 0}});
  }

  /// Space, plane and solid alone.
  void add_scene(View& view, SpaceDrawing& space) const {
    const auto caption = [&](std::string id, const Panel& panel, double top, std::string_view text) {
      view.add({std::move(id), Role::guide, Text{{panel.place().centre().x, top + 1.3}, words_.say(text)}});
    };
    // Side by side they stand in one line
    const bool beside = !eye_ && space_.place().upper.y == picture_.place().upper.y;
    const double highest = std::max(space_top_, picture_top_);
    caption("caption space", space_, beside ? highest : space_top_, "projection.space");
    caption("caption picture", picture_, beside ? highest : picture_top_, "projection.picture");
    add_frame(view);
    add_plane(space);
    add_solid(space);
    if (!eye_) return;
    view.add_named("e eye", "f eye name", Role::input, in_space(*eye_), words_.say("projection.eye"));
    caption("caption side", side_, side_.at(side_extent_.upper).y, "projection.side");
    add_side(view);
  }

  void add_frame(View& view) const {
    std::vector<dvec2> frame;
    for (const dvec3 p : outline()) frame.push_back(in_picture(p));
    view.add({"a picture glass", Role::boundary, Area{{frame}, 2}});
    view.add({"a picture frame", Role::boundary, Path{frame, true}});
  }

  /// The edges between corners that have their images; `faces`: with its faces.
  void add_images(View& view, SpaceDrawing& space, const Images& images, Role role, bool faces) const {
    for (std::size_t i = 0; i < solid_.edges.size(); ++i) {
      const auto [a, b, left, right] = solid_.edges[i];
      if (!images[a] || !images[b]) continue;
      const bool hidden = facing_.hidden[i], faint = role == Role::guide;
      const std::string id = fmt::format("{}{} {:02}", faint ? "b " : "", hidden ? "behind" : "edge", i);
      space.add(SpaceEdge{.id = "d image " + id,
                          .role = role,
                          .a = *images[a],
                          .b = *images[b],
                          .dashed = hidden,
                          .thin = hidden,
                          .behind = !faint});
      Stroke stroke{in_picture(*images[a]), in_picture(*images[b]), false, hidden};
      stroke.thin = hidden;
      view.add({"d picture " + id, role, stroke});
    }
    for (std::size_t i = 0; faces && i < solid_.faces.size(); ++i) {
      if (facing_.seen[i]) add_image_face(view, space, images, role, i);
    }
  }

  /// Faint, what comes: all projectors, and the picture. It leaves no gaps in what is drawn otherwise.
  void add_background(View& view) const {
    SpaceDrawing space = this->space();
    View whole;
    add_solid(space);
    for (std::size_t i = 0; i < images_.size(); ++i)
      if (images_[i]) add_projector(space, Role::guide, i);
    add_images(whole, space, images_, Role::guide, false);
    space.add_to(whole, "c solid");
    for (const auto& [id, mark] : whole.marks)
      if (mark.role == Role::guide) view.add(mark);
  }

  /// The corner at hand with its projector, and its image once that is known.
  void point_at(View& view, SpaceDrawing& space, std::size_t corner, std::optional<dvec3> image) const {
    const dvec3 p = solid_.corners[corner];
    const std::string name = fmt::format("{}", corner + 1);
    view.add_named("g corner", "h corner name", Role::current, in_space(p), name);
    if (images_[corner]) add_projector(space, Role::current, corner);
    if (eye_ && images_[corner]) add_triangles(view, p, *images_[corner]);
    if (!image) return;
    view.add({"g image", Role::current, Dot{in_space(*image)}});
    view.add_named("g picture", "h picture name", Role::current, in_picture(*image), name + "′");
  }

  const Solid& solid() const { return solid_; }

 private:
  std::vector<dvec3> outline() const {
    std::vector<dvec3> corners;
    for (const dvec2 p : patch_.corners()) corners.push_back(sheet_.place(p));
    return corners;
  }

  /// The picture plane in space, as far as the picture goes.
  void add_plane(SpaceDrawing& space) const {
    const std::vector<dvec3> border = outline();
    space.add(SpaceFace{.id = "plane",
                        .role = Role::boundary,
                        .ring = border,
                        .one_sided = false,
                        .glass = true,
                        .shade = 2});
    for (std::size_t i = 0; i < border.size(); ++i) {
      space.add(SpaceEdge{.id = fmt::format("a plane {}", i),
                          .role = Role::boundary,
                          .a = border[i],
                          .b = border[(i + 1) % border.size()],
                          .behind = false});
    }
  }

  void add_solid(SpaceDrawing& space) const {
    for (std::size_t i = 0; i < solid_.faces.size(); ++i) {
      SpaceFace face{.id = fmt::format("face {}", i), .role = Role::input, .ring = {}};
      for (const std::size_t corner : solid_.faces[i]) face.ring.push_back(solid_.corners[corner]);
      if (glm::dot(area_vector(face.ring), outward(solid_, i)) < 0) std::ranges::reverse(face.ring);
      space.add(std::move(face));
    }
    for (std::size_t i = 0; i < solid_.edges.size(); ++i) {
      space.add(SpaceEdge{.id = fmt::format("c solid edge {:02}", i),
                          .role = Role::input,
                          .a = solid_.corners[solid_.edges[i].a],
                          .b = solid_.corners[solid_.edges[i].b]});
    }
  }

  /// A face's image on the plane in space, and in the picture.
  void add_image_face(View& view, SpaceDrawing& space, const Images& images, Role role,
                      std::size_t face) const {
    std::vector<dvec3> ring;
    std::vector<dvec2> picture;
    for (const std::size_t corner : solid_.faces[face]) {
      if (!images[corner]) return;
      ring.push_back(*images[corner]);
      picture.push_back(in_picture(*images[corner]));
    }
    const int shade = shade_of(seen_by_viewer(outward(solid_, face)));
    view.add({fmt::format("d picture face {}", face), role, Area{{picture}, shade}});
    space.add(SpaceFace{.id = fmt::format("image {}", face),
                        .role = role,
                        .ring = std::move(ring),
                        .one_sided = false,
                        .glass = true,
                        .shade = shade});
  }

  /// A corner's projector: to its image, or from the eye, through whichever is farther.
  void add_projector(SpaceDrawing& space, Role role, std::size_t corner) const {
    const dvec3 p = solid_.corners[corner], image = *images_[corner];
    const dvec3 from = eye_ ? *eye_ : p, to = eye_ && p.z > image.z ? p : image;
    const bool now = role == Role::current;
    space.add(SpaceEdge{.id = fmt::format("{} projector {:02}", now ? "e" : "b", corner),
                        .role = role,
                        .a = from,
                        .b = to,
                        .thin = eye_.has_value(),
                        .behind = now});
  }

  /// Eye, plane and solid straight from the side: depth to the right, y up.
  void add_side(View& view) const {
    for (std::size_t i = 0; i < solid_.faces.size(); ++i) {
      std::vector<dvec2> ring;
      for (const std::size_t corner : solid_.faces[i]) ring.push_back(in_side(solid_.corners[corner]));
      view.add({fmt::format("a side face {}", i), Role::input, Area{{ring}, 1}});
      view.add({fmt::format("a side outline {}", i), Role::guide, Path{ring, true}});
    }
    const dvec3 top = sheet_.place(patch_.upper), foot = sheet_.place(patch_.lower);
    view.add({"b side axis", Role::guide, Stroke{in_side(*eye_), in_side({0, 0, side_extent_.upper.x})}});
    view.add({"b side plane", Role::boundary, Stroke{in_side(foot), in_side(top)}});
    view.add({"e side eye", Role::input, Dot{in_side(*eye_)}});
  }

  /// What is similar there: y′ to d as y to z.
  void add_triangles(View& view, dvec3 p, dvec3 image) const {
    const auto upright = [&](const std::string& name, dvec3 at) {
      const dvec2 foot = in_side({0, 0, at.z}), tip = in_side(at);
      view.add({"f side " + name, Role::measure, Stroke{foot, tip}});
      view.add({"h side " + name, Role::measure, Label{(foot + tip) * 0.5, name}});
    };
    const auto along = [&](const std::string& name, double depth, double y) {
      const dvec2 from{in_side(*eye_).x, y}, to{in_side({0, 0, depth}).x, y};
      view.add({"f side " + name, Role::measure, Stroke{from, to, true}});
      view.add({"h side " + name, Role::measure, Text{(from + to) * 0.5 + dvec2{0, 0.8}, name}});
    };
    view.add({"e side ray", Role::current, Stroke{in_side(*eye_), in_side(p.z > image.z ? p : image)}});
    upright(words_.symbol("y"), p);
    upright(words_.symbol("y′"), image);
    along(words_.symbol("d"), image.z, 2.4);
    along(words_.symbol("z"), p.z, 0.4);
    view.add({"g side corner", Role::current, Dot{in_side(p)}});
    view.add({"g side image", Role::current, Dot{in_side(image)}});
  }
  dvec2 in_side(dvec3 p) const { return side_.at({p.z, p.y}); }

  const Wording& words_;
  Solid solid_;
  Sheet sheet_;
  Facing facing_;
  std::optional<dvec3> eye_;
  Images images_;  ///< of all corners, as they will be
  Extent patch_{}, side_extent_{};
  Panel space_{{{0, 0}, {1, 1}}, {{0, 0}, {1, 1}}}, picture_ = space_, side_ = space_;
  double space_top_ = 0, picture_top_ = 0;  ///< of what is drawn there
};

/// How far a solid's corners, one after the other, have got their images.
class Progress {
 public:
  explicit Progress(Scenery scenery)
      : scenery_(std::move(scenery)), images_(scenery_.solid().corners.size()) {}
  void turn_to(std::size_t corner) { corner_ = corner; }
  void arrive(dvec3 image) { images_[corner_] = image; }
  const Scenery& scenery() const { return scenery_; }
  const Scenery::Images& images() const { return images_; }
  std::size_t corner() const { return corner_; }
  /// Of the corner at hand, counted from 1.
  std::int64_t number() const { return static_cast<std::int64_t>(corner_) + 1; }
  std::string key() const { return fmt::format("{}", corner_); }
  std::string_view phase() const {
    return 2 * corner_ < images_.size() ? "projection.front" : "projection.back";
  }
  /// whole: the picture is complete, and its faces are shown.
  View drawing(bool whole) const { return drawing(whole, false); }
  View with_corner() const { return drawing(false, true); }
  /// The complete picture and nothing else.
  View picture() const {
    View view;
    const Scenery alone = scenery_.picture_alone();
    SpaceDrawing unseen = alone.space();
    alone.add_frame(view);
    alone.add_images(view, unseen, images_, Role::result, true);
    return view;
  }

 private:
  View drawing(bool whole, bool pointed) const {
    View view;
    SpaceDrawing space = scenery_.space();
    scenery_.add_scene(view, space);
    scenery_.add_background(view);
    scenery_.add_images(view, space, images_, Role::result, whole);
    if (pointed) scenery_.point_at(view, space, corner_, images_[corner_]);
    space.add_to(view, "c solid");
    return view;
  }

  Scenery scenery_;
  Scenery::Images images_;
  std::size_t corner_ = 0;
};

}  // namespace gradus::solids
