#include "check/conventions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "request/complaint.hpp"
#include "stories/point_text.hpp"

namespace gradus::check {
namespace {

/// Row + y of a cell counted from the other end.
std::int64_t sum_of_rows(const Trace& ours, const std::optional<std::int64_t>& height) {
  const Window& cells = ours.grid.cells;
  if (!ours.grid.axes && !height) {
    refuse_flag("conventions.y",
                fmt::format("a topic that draws cells, or conventions.height, for {}", ours.topic),
                "neither");
  }
  return height ? *height - 1 : std::int64_t{cells.lower.y} + cells.upper.y;
}

/// The places of our digits in another order of the same letters. Throws UsageError.
std::vector<int> places_of_digits(const std::string& ours, const std::string& theirs) {
  const bool same = std::is_permutation(ours.begin(), ours.end(), theirs.begin(), theirs.end());
  if (ours.empty() || !same) {
    refuse_flag("conventions.bits",
                ours.empty() ? "a topic with region codes" : fmt::format("the letters {} in any order", ours),
                shown(theirs));
  }
  std::vector<int> places;
  for (auto letter = ours.rbegin(); letter != ours.rend(); ++letter)
    places.push_back(static_cast<int>(theirs.size() - 1 - theirs.find(*letter)));
  return places;
}

}  // namespace

Translation::Translation(const TopicEntry& topic, const Trace& ours, const Conventions& conventions)
    : checking_(topic.checking) {
  if (conventions.y_down && *conventions.y_down == ours.grid.y_up)
    sum_ = sum_of_rows(ours, conventions.height);
  if (!conventions.bits.empty()) {
    const std::string bits = checking_ ? checking_->bits : "";
    if (conventions.bits != bits) digits_ = places_of_digits(bits, conventions.bits);
  }
  if (!conventions.rows) return;
  if (!checking_ || checking_->matrix.empty())
    refuse_flag("conventions.vectors", "a topic with a matrix for vectors as rows", shown(topic.name));
  transposed_ = true;
}

ivec2 Translation::cell(ivec2 theirs) const {
  if (!sum_) return theirs;
  const std::int64_t y = *sum_ - theirs.y;
  return {theirs.x, static_cast<int>(std::clamp<std::int64_t>(y, INT32_MIN, INT32_MAX))};
}

void Translation::turn(Values& values) const {
  const Values before = values;
  for (Field& field : values) {
    if (ivec2* place = std::get_if<ivec2>(&field.value)) *place = cell(*place);
    if (sum_ && field.name == "y") {
      if (auto* y = std::get_if<std::int64_t>(&field.value)) *y = *sum_ - *y;
    }
    if (!checking_) continue;
    auto* code = std::get_if<std::int64_t>(&field.value);
    if (code && !digits_.empty() &&
        std::ranges::find(checking_->codes, field.name) != checking_->codes.end()) {
      std::int64_t ours = 0;
      for (std::size_t i = 0; i < digits_.size(); ++i) ours |= ((*code >> digits_[i]) & 1) << i;
      *code = ours;
    }
    if (!transposed_) continue;
    const auto place = std::ranges::find(checking_->matrix, field.name);
    if (place == checking_->matrix.end()) continue;
    // The elements that are not in a square, a translation, are called by what they move and stay
    const std::size_t n = checking_->matrix_columns,
                      i = static_cast<std::size_t>(place - checking_->matrix.begin());
    const std::size_t mirrored = i % n * n + i / n;
    if (mirrored >= checking_->matrix.size()) continue;
    if (const Value* other = value_of(before, checking_->matrix[mirrored])) field.value = *other;
  }
}

}  // namespace gradus::check
