#include "figure/drawing.hpp"

namespace gradus {
namespace {

constexpr std::int64_t most_dense_cells = std::int64_t{1} << 26;

bool fits_dense(const Window& cells) {
  return !cells.empty() && cells.width() <= most_dense_cells && cells.height() <= most_dense_cells &&
         cells.width() * cells.height() <= most_dense_cells;
}

std::size_t index_in(const Window& cells, ivec2 p) {
  const std::int64_t column = std::int64_t{p.x} - cells.lower.x;
  const std::int64_t row = std::int64_t{p.y} - cells.lower.y;
  return static_cast<std::size_t>(row * cells.width() + column);
}

}  // namespace

Canvas::Canvas(const Window& cells) : window_(cells) {
  if (fits_dense(cells)) dense_.assign(static_cast<std::size_t>(cells.width() * cells.height()), bare);
}

void Canvas::put(ivec2 p, std::uint8_t role) {
  if (!dense_.empty()) {
    if (window_.contains(p)) dense_[index_in(window_, p)] = role;
  } else if (role == bare) {
    sparse_.erase(key_of(p));
  } else {
    sparse_[key_of(p)] = role;
  }
}

void Canvas::apply(const Delta& delta) {
  plane_ = delta.plane.value_or(plane_);
  for (const std::string& id : delta.removed) marks_.erase(id);
  for (const CellChange& change : delta.cells) {
    put(change.at, change.look ? static_cast<std::uint8_t>(change.look->role) : bare);
    if (change.look && !change.look->text.empty()) {
      texts_[key_of(change.at)] = change.look->text;
    } else {
      texts_.erase(key_of(change.at));
    }
    if (change.look && change.look->color) {
      colors_[key_of(change.at)] = *change.look->color;
    } else {
      colors_.erase(key_of(change.at));
    }
  }
  for (const Mark& mark : delta.set) marks_.insert_or_assign(mark.id, mark);
}

std::optional<CellLook> Canvas::at(ivec2 p) const {
  std::uint8_t role = bare;
  if (!dense_.empty()) {
    if (window_.contains(p)) role = dense_[index_in(window_, p)];
  } else if (const auto found = sparse_.find(key_of(p)); found != sparse_.end()) {
    role = found->second;
  }
  if (role == bare) return std::nullopt;
  const auto text = texts_.find(key_of(p));
  const auto color = colors_.find(key_of(p));
  return CellLook{static_cast<Role>(role), text == texts_.end() ? std::string() : text->second,
                  color == colors_.end() ? std::nullopt : std::optional(color->second)};
}

std::size_t Canvas::size() const {
  return dense_.size() / 16 + sparse_.size() + texts_.size() + colors_.size() + marks_.size() + 1;
}

bool operator==(const Canvas& a, const Canvas& b) {
  return a.window_ == b.window_ && a.dense_ == b.dense_ && a.sparse_ == b.sparse_ && a.texts_ == b.texts_ &&
         a.colors_ == b.colors_ && a.plane_ == b.plane_ && a.marks_ == b.marks_;
}

}  // namespace gradus
