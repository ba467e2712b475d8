#include "stories/pipeline/textbook_chain/solid_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "figure/tone_of.hpp"

namespace gradus::textbook_chain {

SolidCells::SolidCells(const Panel& panel, const Extent& frame)
    : panel_(panel),
      lower_(glm::ceil(frame.lower)),
      size_(ivec2(glm::ceil(frame.upper)) - lower_),
      nearest_(static_cast<std::size_t>(size_.x * size_.y)) {}

void SolidCells::add(const std::vector<dvec3>& ring, dvec3 colour) {
  for (std::size_t i = 2; i < ring.size(); ++i) add_triangle({ring[0], ring[i - 1], ring[i]}, colour);
}

void SolidCells::add_triangle(const std::array<dvec3, 3>& corners, dvec3 colour) {
  std::array<dvec2, 3> p{};  // in cells
  for (std::size_t i = 0; i < 3; ++i) p[i] = panel_.at(dvec2(corners[i])) - dvec2(lower_);
  const auto area = [](dvec2 a, dvec2 b, dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  const double whole = area(p[0], p[1], p[2]);
  // Clamped before they become whole numbers: what is divided by next to nothing flies off
  const dvec2 most(size_ - 1), least = glm::clamp(glm::min(glm::min(p[0], p[1]), p[2]), dvec2(0), most),
                               last = glm::clamp(glm::max(glm::max(p[0], p[1]), p[2]), dvec2(-1), most);
  if (!(std::abs(whole) > 0)) return;
  for (int y = static_cast<int>(std::ceil(least.y)); y <= last.y; ++y) {
    for (int x = static_cast<int>(std::ceil(least.x)); x <= last.x; ++x) {
      const dvec2 at(x, y);
      const dvec3 shares = dvec3{area(p[1], p[2], at), area(p[2], p[0], at), area(p[0], p[1], at)} / whole;
      if (!(std::min({shares.x, shares.y, shares.z}) >= 0)) continue;
      const double towards = shares.x * corners[0].z + shares.y * corners[1].z + shares.z * corners[2].z;
      std::optional<Nearest>& nearest = nearest_[static_cast<std::size_t>(y * size_.x + x)];
      if (!nearest || nearest->towards < towards) nearest = Nearest{towards, tone_of(colour)};
    }
  }
}

void SolidCells::put(View& view) const {
  for (int y = 0; y < size_.y; ++y) {
    for (int x = 0; x < size_.x; ++x) {
      const auto& nearest = nearest_[static_cast<std::size_t>(y * size_.x + x)];
      if (nearest)
        view.cells.insert_or_assign({lower_.y + y, lower_.x + x}, CellLook{Role::past, "", nearest->tone});
    }
  }
}

}  // namespace gradus::textbook_chain
