#pragma once
// The drawing of texture mapping: the picture on the left, the texture, or one of its levels, on the right.

#include "stories/paper.hpp"
#include "stories/shading/texture_mapping/subject.hpp"

namespace gradus::texture_mapping {

inline Path rectangle(dvec2 corner, dvec2 size) {
  return {{corner, corner + dvec2{size.x, 0}, corner + size, corner + dvec2{0, size.y}}, true};
}

/// Cells of the drawing are pixels; a texel has several of them.
class Paper {
 public:
  explicit Paper(const Subject& subject)
      : subject_(subject),
        unit_(std::max(1.0, subject.size.y / 12.0)),
        texel_(std::max(1, (subject.size.y + subject.texels / 2) / subject.texels)),
        side_(texel_ * subject.texels),
        texture_(origin().x + subject.size.x + many(4),
                 origin().y + std::max(0, (subject.size.y - side_) / 2)) {}

  void set(Narrator& narrator) const {
    const int width = texture_.x + side_ + 1;
    const int height = std::max(origin().y + subject_.size.y, texture_.y + side_) + many(2);
    narrator.whole_grid({{0, 0}, {width - 1, height - 1}});
    const gradus::Extent picture{{0, 0}, dvec2(subject_.size)};
    narrator.handles("corners", [&](dvec3 corner) -> std::optional<dvec2> {
      if (!picture.holds(dvec2(corner))) return std::nullopt;
      return on_paper(dvec2(corner));
    });
  }

  // What stays

  void put_frames(View& view, const Words& words) const {
    const dvec2 picture = dvec2(origin()) - 0.5, size(subject_.size);
    view.add({"a picture", Role::past, rectangle(picture, size)});
    for (std::size_t k = 0; k < 4; ++k)
      put_side(view, fmt::format("a side {}", k),
               Stroke{dvec2(subject_.corners[k]), dvec2(subject_.corners[(k + 1) % 4])});
    put_side(view, "a diagonal",
             Stroke{dvec2(subject_.corners[0]), dvec2(subject_.corners[2]), false, true, true});
    view.add({"a picture name", Role::guide,
              Text{{picture.x + 0.5 * size.x, picture.y - 0.8 * unit_}, words.say("picture")}});
    const dvec2 lower = place({0, 0}), upper = place({1, 1});
    const dvec2 down{0, 0.6 * unit_}, left{0.6 * unit_, 0};
    view.add({"a u", Role::guide, Stroke{lower + down, dvec2{upper.x, lower.y} + down, true}});
    view.add({"a v", Role::guide, Stroke{lower - left, dvec2{lower.x, upper.y} - left, true}});
    view.add({"a u name", Role::guide,
              Text{dvec2{upper.x, lower.y} + down + 0.8 * left, words.symbol("u"), Align::left}});
    view.add({"a v name", Role::guide,
              Text{dvec2{lower.x, upper.y} - left - 0.7 * dvec2{0, unit_}, words.symbol("v")}});
    names_ = {words.say("texture")};
    for (int k = 1; k < levels_of(subject_.texture.size); ++k)
      names_.push_back(words.say("level", {{"k", k}}));
  }
  /// The texture, or a level of it, as large as the texture.
  void put_level(View& view, int level) const {
    const MipChain<double> chain = subject_.chain();
    const auto texel = chain.level(level);
    const int count = chain.size(level).x;
    for (int y = 0; y < side_; ++y) {
      for (int x = 0; x < side_; ++x) {
        const double grey = texel({x * count / side_, y * count / side_});
        view.cells.insert_or_assign({y + texture_.y, x + texture_.x},
                                    CellLook{Role::result, "", tone_of(grey)});
      }
    }
    const dvec2 above = 0.5 * (place({0, 1}) + place({1, 1})) - dvec2{0, 0.8 * unit_};
    view.add({"a texture name", Role::guide, Text{above, names_[static_cast<std::size_t>(level)]}});
  }
  void put_pixel(View& view, ivec2 pixel, Rgba8 color) const {
    const ivec2 at = pixel + origin();
    view.cells.insert_or_assign({at.y, at.x}, CellLook{Role::result, "", color});
  }
  /// How the texture's other diagonal, from lower right to upper left, runs through the picture.
  void put_diagonal(View& view, bool bent) const {
    const auto& c = subject_.corners;
    Path path{{on_paper(dvec2(c[1])), on_paper(dvec2(c[3]))}, false};
    // The exhibit has its middle in the middle of the edge that both triangles share
    if (bent) path.points.insert(path.points.begin() + 1, on_paper(dvec2(0.5 * (c[0] + c[2]))));
    view.add({"z diagonal", Role::measure, path});
    view.add({"z texture diagonal", Role::measure, Path{{place({1, 0}), place({0, 1})}, false}});
  }

  // What a step points at

  void mark_pixel(View& view, ivec2 pixel) const {
    view.add({"p pixel", Role::current, rectangle(dvec2(origin() + pixel) - 0.5, dvec2(1))});
  }
  void mark_sample(View& view, dvec2 uv) const {
    view.add({"s sample", Role::current, Dot{place(one_tile(uv))}});
  }
  /// The same with u and v at the axes.
  void mark_place(View& view, dvec2 uv) const {
    mark_sample(view, uv);
    const dvec2 at = place(one_tile(uv)), corner = place({0, 0});
    const dvec2 below{at.x, corner.y + 0.6 * unit_}, beside{corner.x - 0.6 * unit_, at.y};
    const auto number = [](double x) { return figure_real(std::round(1000 * x) / 1000); };
    view.add({"s u", Role::current, Stroke{at, below, false, true, true}});
    view.add({"s v", Role::current, Stroke{at, beside, false, true, true}});
    // At the right border it would ask for more room than all else
    const dvec2 under{std::min(below.x, place({1, 0}).x - 1.2 * unit_), below.y + 0.9 * unit_};
    view.add({"s u number", Role::current, Text{under, number(uv.x)}});
    view.add({"s v number", Role::current, Text{beside - dvec2{0.4 * unit_, 0}, number(uv.y), Align::right}});
  }
  /// Where another way would have looked.
  void mark_other(View& view, dvec2 uv) const {
    view.add({"r other", Role::rejected, Dot{place(one_tile(uv)), true}});
  }
  void mark_texel(View& view, ivec2 texel) const {
    view.add(
        {"t texel", Role::accepted, rectangle(dvec2(texture_) + dvec2(texel * texel_) - 0.5, dvec2(texel_))});
  }
  /// One of four texels, by its middle and its weight.
  void mark_weight(View& view, std::size_t k, ivec2 texel, int level, const std::string& weight) const {
    const double size = static_cast<double>(side_) / size_of_level(subject_.texture.size, level).x;
    const dvec2 corner = dvec2(texture_) + size * dvec2(texel) - 0.5;
    const std::string id = fmt::format("w {}", k);
    view.add({id, Role::candidate, rectangle(corner, dvec2(size))});
    view.add({id + " weight", Role::candidate, Label{corner + 0.5 * size, weight}});
  }
  /// What the pixel covers, as a parallelogram round its place; nothing where that is no part of the texture.
  void mark_footprint(View& view, dvec2 uv, const Footprint<double>& footprint, Role role) const {
    const dvec2 x = 0.5 * footprint.along_x, y = 0.5 * footprint.along_y, at = one_tile(uv);
    Path path{{place(at - x - y), place(at + x - y), place(at + x + y), place(at - x + y)}, true};
    for (dvec2& p : path.points) {
      const dvec2 off = glm::abs(p - place(dvec2(0.5)));
      if (std::max(off.x, off.y) > 0.5 * side_ + 1) return;
      p = glm::clamp(p, place({0, 1}), place({1, 0}));  // beyond its border is another tile
    }
    view.add({"f footprint", role, path});
  }

 private:
  /// So many times the height of a line, in cells.
  int many(double lines) const { return static_cast<int>(std::ceil(lines * unit_)); }
  /// The cell of pixel (0, 0).
  ivec2 origin() const { return {1, many(1.5)}; }
  dvec2 on_paper(dvec2 place) const { return dvec2(origin()) + place - 0.5; }
  /// What of a line between places of the picture lies in the picture.
  void put_side(View& view, const std::string& id, Stroke side) const {
    const auto part = shown_part({{0, 0}, dvec2(subject_.size)}, side.a, side.b);
    if (!part) return;
    side.a = on_paper(part->a);
    side.b = on_paper(part->b);
    view.add({id, Role::input, side});
  }
  static dvec2 one_tile(dvec2 uv) {
    const auto fraction = [](double x) { return x == 1 ? 1 : x - std::floor(x); };
    return {fraction(uv.x), fraction(uv.y)};
  }
  dvec2 place(dvec2 uv) const {
    return dvec2(texture_) - 0.5 + static_cast<double>(side_) * dvec2{uv.x, 1 - uv.y};
  }

  const Subject& subject_;
  double unit_;  ///< a line's height, in cells
  int texel_, side_;
  ivec2 texture_;
  mutable std::vector<std::string> names_{};
};

}  // namespace gradus::texture_mapping
