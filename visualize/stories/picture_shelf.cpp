// Pictures of one size beside each other: where each has its place, and the steps that show one after the
// other.

#include "stories/picture_shelf.hpp"

#include <utility>

namespace gradus {
namespace {

Path rectangle(dvec2 from, dvec2 size) { return {Extent{from, from + size}.corners(), true}; }

}  // namespace

PictureShelf::PictureShelf(Narrator& narrator, Look look) : narrator_(narrator), look_(std::move(look)) {
  const auto across = static_cast<int>(columns()), down = static_cast<int>(rows());
  const ivec2 upper{across * (width() + look_.gap) - look_.gap + 1,
                    down * (look_.heading + height()) + (look_.y_up ? 0 : 1)};
  narrator.whole_grid({{0, 0}, upper}, look_.y_up);
  narrator.trace().grid.lines = 0.5;  // several pictures may be as fine as on a screen
  view_.plane = true;
  for (std::size_t k = 0; k < look_.names.size(); ++k) add_name(k);
}

std::size_t PictureShelf::columns() const {
  return look_.row == 0 ? look_.names.size() : static_cast<std::size_t>(look_.row);
}
std::size_t PictureShelf::rows() const { return (look_.names.size() + columns() - 1) / columns(); }
int PictureShelf::width() const {
  return look_.left +
         (look_.part ? std::max(look_.size.x, look_.part->size.x * look_.part->magnified) : look_.size.x);
}
int PictureShelf::height() const {
  return look_.size.y + look_.plot +
         (look_.part ? look_.gap + look_.part->size.y * look_.part->magnified : 0);
}

ivec2 PictureShelf::corner(std::size_t k) const {
  const auto column = static_cast<int>(k % columns());
  const std::size_t row = k / columns(), from_below = rows() - 1 - row;
  const int step = look_.heading + height();
  return {1 + look_.left + column * (width() + look_.gap) + (width() - look_.left - look_.size.x) / 2,
          look_.y_up ? 1 + look_.plot + static_cast<int>(from_below) * step
                     : look_.heading + static_cast<int>(row) * step};
}
ivec2 PictureShelf::below(std::size_t k) const {
  const int side = (look_.size.x - look_.part->size.x * look_.part->magnified) / 2;
  return corner(k) + ivec2{side, look_.size.y + look_.gap};
}

std::optional<dvec2> PictureShelf::shown_at(dvec2 place) const {
  const bool shown = Extent{{0, 0}, dvec2(look_.size)}.holds(place);
  return shown ? std::optional(on_paper(0, place)) : std::nullopt;
}

void PictureShelf::add_name(std::size_t k) {
  const double above = 0.45 * look_.heading;
  const dvec2 at{0.5 * look_.size.x, look_.y_up ? look_.size.y + above : -above};
  view_.add({fmt::format("t {}", k), Role::guide, Text{on_paper(k, at), look_.names[k]}});
}

void PictureShelf::wait(std::size_t k, Role role, const std::vector<dvec2>& ring) {
  Path path{{}, true};
  for (const dvec2 p : ring) path.points.push_back(on_paper(k, p));
  view_.add({fmt::format("o {} {:03}", k, view_.marks.size()), role, std::move(path)});
}
void PictureShelf::wait(std::size_t k, Role role) {
  wait(k, role, rectangle({0, 0}, dvec2(look_.size)).points);
}
void PictureShelf::frame(Role role) {
  for (std::size_t k = 0; k < look_.names.size(); ++k)
    view_.add({fmt::format("a {}", k), role, rectangle(on_paper(k, {0, 0}), dvec2(look_.size))});
}

void PictureShelf::start(const Event& event) { step("Started", 0, event); }

void PictureShelf::show(std::string_view type, int line,
                        const std::function<std::optional<Rgba8>(ivec2)>& tone, const Event& event) {
  const std::size_t k = shown_++;
  // What waited gives way to the picture
  const std::string waiting = fmt::format("o {} ", k);
  std::erase_if(view_.marks, [&](const auto& mark) { return mark.first.starts_with(waiting); });
  if (look_.fine > 1) {
    view_.add({fmt::format("b {}", k), Role::result, picture(k, tone)});
  } else {
    for (ivec2 p{0, 0}; p.y < look_.size.y; ++p.y) {
      for (p.x = 0; p.x < look_.size.x; ++p.x) put(corner(k) + p, tone(p));
    }
  }
  if (const auto& part = look_.part) {
    const ivec2 size = part->size * part->magnified;
    for (ivec2 p{0, 0}; p.y < size.y; ++p.y) {
      for (p.x = 0; p.x < size.x; ++p.x) put(below(k) + p, tone(part->at + p / part->magnified));
    }
    view_.add(
        {fmt::format("u {}", k), Role::current, rectangle(on_paper(k, dvec2(part->at)), dvec2(part->size))});
    view_.add({fmt::format("v {}", k), Role::current, rectangle(dvec2(below(k)) - 0.5, dvec2(size))});
  }
  step(type, line, event);
}
void PictureShelf::put(ivec2 cell, const std::optional<Rgba8>& tone) {
  if (tone) view_.cells.insert_or_assign({cell.y, cell.x}, CellLook{Role::result, "", *tone});
}

Picture PictureShelf::picture(std::size_t k, const ToneAt& tone) const {
  const ivec2 size = look_.fine * look_.size;
  Image image(size.x, size.y, {0, 0, 0, 0});
  for (ivec2 p{0, 0}; p.y < size.y; ++p.y) {
    for (p.x = 0; p.x < size.x; ++p.x) {
      if (const auto found = tone(p)) image[{p.x, look_.y_up ? size.y - 1 - p.y : p.y}] = *found;
    }
  }
  return {on_paper(k, {0, 0}), on_paper(k, dvec2(look_.size)),
          std::make_shared<const Image>(std::move(image))};
}

void PictureShelf::finish(const Event& event) {
  step("Finished", 0, event);
  narrator_.telling({static_cast<std::int64_t>(shown_), 0});
}

void PictureShelf::step(std::string_view type, int line, const Event& event) {
  narrator_.board().milestone(View(view_));
  narrator_.tell(type, line, [&] { return event; });
}

}  // namespace gradus
