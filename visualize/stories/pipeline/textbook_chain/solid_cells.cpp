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
      samples_(static_cast<std::size_t>(size_.x * size_.y * samples * samples)) {}

void SolidCells::add(const std::vector<dvec3>& ring, dvec3 colour) {
  for (std::size_t i = 2; i < ring.size(); ++i) add_triangle({ring[0], ring[i - 1], ring[i]}, colour);
}

void SolidCells::add_triangle(const std::array<dvec3, 3>& corners, dvec3 colour) {
  std::array<dvec2, 3> p{};  // in samples
  for (std::size_t i = 0; i < 3; ++i)
    p[i] = (panel_.at(dvec2(corners[i])) + 0.5 - dvec2(lower_)) * double(samples) - 0.5;
  const auto area = [](dvec2 a, dvec2 b, dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  const double whole = area(p[0], p[1], p[2]);
  const ivec2 size = size_ * samples;
  // Clamped before they become whole numbers: what is divided by next to nothing flies off
  const dvec2 most(size - 1), least = glm::clamp(glm::min(glm::min(p[0], p[1]), p[2]), dvec2(0), most),
                              last = glm::clamp(glm::max(glm::max(p[0], p[1]), p[2]), dvec2(-1), most);
  if (!(std::abs(whole) > 0)) return;
  for (int y = static_cast<int>(std::ceil(least.y)); y <= last.y; ++y) {
    for (int x = static_cast<int>(std::ceil(least.x)); x <= last.x; ++x) {
      const dvec2 at(x, y);
      const dvec3 shares = dvec3{area(p[1], p[2], at), area(p[2], p[0], at), area(p[0], p[1], at)} / whole;
      if (!(std::min({shares.x, shares.y, shares.z}) >= 0)) continue;
      const double towards = shares.x * corners[0].z + shares.y * corners[1].z + shares.z * corners[2].z;
      Sample& sample = samples_[static_cast<std::size_t>(y * size.x + x)];
      if (sample.covered && sample.towards >= towards) continue;
      sample = {towards, colour, true};
    }
  }
}

void SolidCells::put(View& view) const {
  for (int y = 0; y < size_.y; ++y) {
    for (int x = 0; x < size_.x; ++x) {
      dvec3 sum{0};
      int covered = 0;
      for (int k = 0; k < samples * samples; ++k) {
        const ivec2 at = ivec2{x, y} * samples + ivec2{k % samples, k / samples};
        const Sample& sample = samples_[static_cast<std::size_t>(at.y * size_.x * samples + at.x)];
        covered += sample.covered;
        sum += sample.colour;
      }
      if (2 * covered < samples * samples) continue;
      view.cells.insert_or_assign({lower_.y + y, lower_.x + x},
                                  CellLook{Role::past, "", tone_of(sum / double(covered))});
    }
  }
}

}  // namespace gradus::textbook_chain
