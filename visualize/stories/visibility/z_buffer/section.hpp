#pragma once
// The section along one row of a z-buffer: each face's depth over the columns, what the row keeps, and the
// two depths that are compared.

#include "stories/visibility/z_buffer/judge.hpp"

namespace gradus::z_buffer {

/// About the height of a line of text, in pixels of the picture.
inline double text_unit(const Subject& subject) {
  return 0.05 * std::max({subject.size.x, subject.size.y, 4});
}

/// The lines between pixels, and the numbers of columns and rows.
inline void add_pixel_grid(Narrator& narrator, const Subject& subject) {
  const double unit = text_unit(subject);
  const dvec2 lower{-0.5, -0.5}, upper = dvec2(subject.size) - 0.5;
  for (int x = 0; x <= subject.size.x; ++x)
    narrator.backdrop(fmt::format("line column {:02}", x), Role::guide,
                      Stroke{{x - 0.5, lower.y}, {x - 0.5, upper.y}, false, false, true});
  for (int y = 0; y <= subject.size.y; ++y)
    narrator.backdrop(fmt::format("line row {:02}", y), Role::guide,
                      Stroke{{lower.x, y - 0.5}, {upper.x, y - 0.5}, false, false, true});
  const double below = upper.y + unit, left = lower.x - 0.4 * unit;
  for (int x = 0; x < subject.size.x; ++x)
    narrator.backdrop(fmt::format("number column {:02}", x), Role::guide, Text{{x, below}, figure_number(x)});
  for (int y = 0; y < subject.size.y; ++y)
    narrator.backdrop(fmt::format("number row {:02}", y), Role::guide,
                      Text{{left, y}, figure_number(y), Align::right});
  const Words& words = narrator.words();
  narrator.backdrop("name x", Role::guide,
                    Text{{upper.x + unit, below}, words.symbol("x"), Align::centre, true});
  narrator.backdrop("name y", Role::guide,
                    Text{{left, lower.y - 0.8 * unit}, words.symbol("y") + "\u00a0↓", Align::right, true});
}

class Section {
 public:
  Section(const Subject& subject, const Words& words)
      : subject_(subject), unit_(text_unit(subject)), z_(words.symbol("z")), eye_(words.say("section.eye")) {
    Extent depths;
    for (const Face& face : subject.faces) {
      const auto plane = plane_of(face);
      if (!plane) continue;
      const double rise = 0.5 * std::abs(plane->right);
      const Outline outline(face, subject.picture());
      for (const ivec2 pixel : outline.pixels()) {
        depths.add({0, plane->at(pixel) - rise});
        depths.add({subject.size.x, plane->at(pixel) + rise});
      }
    }
    is_empty_ = subject.size.x > most_columns || depths.lower.y > depths.upper.y;
    if (is_empty_) return;
    const double height = depths.size().y, spare = height > 0 ? 0.08 * height : 1;
    place_ = place_of(subject);
    panel_ = Panel(place_, {{0, depths.lower.y - spare}, {subject.size.x, depths.upper.y + spare}},
                   Panel::Fit::stretched, false);
  }
  /// Beside the picture.
  static Extent place_of(const Subject& subject) {
    const dvec2 size(subject.size);
    if (subject.size.x > most_columns) return {size, size};
    const double left = size.x - 0.5 + 2.6 * text_unit(subject);
    return {{left, -0.5 + 1.6 * text_unit(subject)},
            {left + std::clamp(0.7 * size.x, 4.0, 6.0), std::max(size.y - 0.5, 4.0)}};
  }

  /// What a row holds, and the faces in the order of drawing up to one, whose line is strong; without one
  /// none.
  void add_to(View& view, int row, std::optional<Id> last, const Owners& holder,
              const std::string& caption) const {
    if (is_empty_) return;
    add_frame(view, caption);
    for (const Face& face : subject_.faces) {
      if (!last) break;
      add_line(view, face, row, face.id == *last ? Role::input : Role::past);
      if (face.id == *last) break;
    }
    for (int x = 0; x < subject_.size.x; ++x) {
      const auto held = holder.find({x, row});
      const auto depth = held == holder.end() ? std::nullopt : depth_at(held->second, {x, row});
      if (depth)
        add_path(view, fmt::format("z kept {:02}", x), Role::accepted, {{x, *depth}, {x + 1, *depth}});
    }
  }
  /// A face's depth at a pixel and the one of the face that is shown there.
  void add_comparison(View& view, ivec2 pixel, Id id, std::optional<Id> shown, Role role) const {
    if (is_empty_ || !shown) return;
    const auto now = depth_at(id, pixel), before = depth_at(*shown, pixel);
    if (now && before) add_path(view, "z way", role, {{pixel.x + 0.5, *before}, {pixel.x + 0.5, *now}});
  }

 private:
  /// Where a face is at a pixel.
  std::optional<double> depth_at(Id id, ivec2 pixel) const {
    const auto plane = plane_of(*std::ranges::find(subject_.faces, id, &Face::id));
    return plane ? std::optional(plane->at(pixel)) : std::nullopt;
  }
  void add_path(View& view, std::string id, Role role, const Ring2& places, bool closed = false) const {
    view.add({std::move(id), role, Path{panel_.at(places), closed, false, true}});
  }
  void add_text(View& view, std::string id, Role role, dvec2 at, std::string text,
                Align align = Align::centre) const {
    view.add({std::move(id), role, Text{at, std::move(text), align, true}});
  }
  void add_frame(View& view, const std::string& caption) const {
    const dvec2 middle = place_.centre();
    view.add({"z frame", Role::past, Path{place_.corners(), true, false, true}});
    add_text(view, "z caption", Role::guide, {middle.x, place_.lower.y - 0.9 * unit_}, caption);
    const int step = subject_.size.x > 8 ? 2 : 1;
    for (int x = 0; x < subject_.size.x; x += step)
      add_text(view, fmt::format("z column {:02}", x), Role::guide,
               {panel_.at({x + 0.5, 0}).x, place_.upper.y + unit_}, figure_number(x));
    add_text(view, "z eye", Role::guide, {middle.x, place_.upper.y + 2.4 * unit_}, eye_);
    if (subject_.sight.eye) return;
    const Extent shown = panel_.shown();
    const double distance = tick_distance(shown.size().y, 4);
    for (double k = std::ceil(shown.lower.y / distance); k * distance <= shown.upper.y; ++k) {
      const double y = panel_.at({0, k * distance}).y;
      // Longer ones would lie on the pixels beside
      if (const std::string text = figure_real(k * distance); text.size() <= 3)
        add_text(view, fmt::format("z tick {:+}", k), Role::guide, {place_.lower.x - 0.4 * unit_, y}, text,
                 Align::right);
    }
    add_text(view, "z name", Role::guide, {place_.lower.x - 0.4 * unit_, place_.lower.y - 0.9 * unit_},
             z_ + "\u00a0↑", Align::right);
  }
  /// A face's depth along the middle of a row, with the face's name near its right end.
  void add_line(View& view, const Face& face, int row, Role role) const {
    const auto plane = plane_of(face);
    if (!plane) return;
    const double y = row + 0.5;
    double from = subject_.size.x, to = 0;
    for (const auto& [a, b] : sides_of(subject_.corners(face.id))) {
      if ((a.y < y) == (b.y < y)) continue;
      const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
      from = std::min(from, x);
      to = std::max(to, x);
    }
    from = std::max(from, 0.0);
    to = std::min(to, static_cast<double>(subject_.size.x));
    if (!(from < to)) return;
    const auto depth = [&](double x) {
      return plane->corner.z + plane->right * (x - plane->corner.x) + plane->down * (y - plane->corner.y);
    };
    const std::string& name = subject_.name(face.id);
    add_path(view, "z line " + name, role, {{from, depth(from)}, {to, depth(to)}});
    // Off its line, within the frame
    const double at = std::max(from, to - 0.3), end = depth(at);
    const bool rises = end > depth(from);
    const dvec2 aside = rises ? dvec2{-1, -0.4} : dvec2{0, -0.9};
    add_text(view, "z name " + name, role, panel_.at({at, end}) + unit_ * aside, name);
  }

  /// Beside more of them a section would leave pixels no room for their depths.
  static constexpr int most_columns = 12;

  const Subject& subject_;
  double unit_;
  std::string z_, eye_;
  bool is_empty_ = true;
  Extent place_{};
  Panel panel_{{{0, 0}, {1, 1}}, {{0, 0}, {1, 1}}};
};

}  // namespace gradus::z_buffer
