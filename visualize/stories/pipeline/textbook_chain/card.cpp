#include "stories/pipeline/textbook_chain/card.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "figure/text/metrics.hpp"
#include "figure/text/number_text.hpp"

namespace gradus::textbook_chain {
namespace {

/// Of the letters in a drawing, and what a unit of the paper has at least of it on a slide.
constexpr double letter_size = 20, least_unit = 16.5;
constexpr double column_gap = 0.8, text_gap = 0.45, fence_width = 0.3;

}  // namespace

double Card::width_of(const std::string& text) {
  return text_width(without_notes(text), Face::sans, letter_size) / least_unit;
}

void Card::put(dvec2 at, const std::string& text, Role role, Align align) {
  view_.add({fmt::format("k {} {:03}", name_, number_++), role, Text{at, text, align, true}});
}

Card& Card::say(const std::string& text, Role role) {
  put(middle(), text, role, Align::left);
  at_.x += (width_of(text) + text_gap) * unit_;
  return *this;
}

double Card::fence(Fence fence, std::size_t rows, bool opens) {
  if (fence == Fence::none) return 0;
  const dvec2 at = middle();
  const double half = 0.5 * row_height * static_cast<double>(rows) * unit_;
  const double inwards = fence == Fence::bars ? 0 : (opens ? fence_width : -fence_width) * unit_;
  const double x = at.x + (opens ? 0 : fence_width * unit_);
  view_.add(
      {fmt::format("k {} fence {:03}", name_, number_++), Role::guide,
       Path{{{x + inwards, at.y - half}, {x, at.y - half}, {x, at.y + half}, {x + inwards, at.y + half}},
            false,
            false,
            true}});
  return 1.5 * fence_width * unit_;
}

Card& Card::block(const Texts& rows, Fence fenced, Role role, std::size_t names) {
  at_.x += fence(fenced, rows.size(), true);
  const dvec2 corner = middle();
  const double half = 0.5 * static_cast<double>(rows.size());
  double x = corner.x;
  for (std::size_t c = 0; c < rows.front().size(); ++c) {
    double width = 0;
    for (const auto& row : rows) width = std::max(width, width_of(row[c]));
    const bool flush_left = c < names;
    const double at = flush_left ? x : x + width * unit_;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (rows[r][c].empty()) continue;
      const double y = corner.y + (static_cast<double>(r) + 0.5 - half) * row_height * unit_;
      put({at, y}, rows[r][c], role, flush_left ? Align::left : Align::right);
    }
    x += (width + (c + 1 < rows.front().size() ? column_gap : 0)) * unit_;
  }
  at_.x = x + (fenced == Fence::none ? 0 : 0.5 * fence_width * unit_);
  at_.x += fence(fenced, rows.size(), false) + text_gap * unit_;
  return *this;
}

Card& Card::space(double units) {
  at_.x += units * unit_;
  return *this;
}

Card& Card::down(double units) {
  at_.y += units * unit_;
  return *this;
}

Card& Card::high(std::size_t rows) {
  height_ = std::max(line_height, row_height * static_cast<double>(rows) + 0.1);
  return *this;
}

Card& Card::line() {
  at_ = {left_, at_.y + height_ * unit_};
  height_ = line_height;
  return *this;
}

}  // namespace gradus::textbook_chain
