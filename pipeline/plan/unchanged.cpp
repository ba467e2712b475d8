#include "plan/unchanged.hpp"

#include <bit>
#include <cstdint>
#include <optional>

#include "plan/rules.hpp"

namespace gradus::pipeline {
namespace {

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool same_bits(dvec3 a, dvec3 b) { return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z); }
template <class Value>
bool same_bits(const std::optional<Value>& a, const std::optional<Value>& b) {
  return a && b ? same_bits(*a, *b) : !a && !b;
}

}  // namespace

bool same_view(const View& before, const View& now) {
  return same_bits(before.eye, now.eye) && same_bits(before.target, now.target) &&
         same_bits(before.up, now.up) && same_bits(before.vertical_radians, now.vertical_radians) &&
         before.projection == now.projection && same_bits(before.height, now.height) &&
         same_bits(before.receding_radians, now.receding_radians) &&
         same_bits(before.foreshortening, now.foreshortening);
}

std::vector<std::size_t> pictures_of(std::span<const View> views) {
  std::vector<std::size_t> pictures;
  for (std::size_t i = 0; i < views.size(); ++i)
    pictures.push_back(i > 0 && same_view(views[i - 1], views[i]) ? pictures.back() : i);
  return pictures;
}

void add(const Ledger& frame, Ledger& sum) {
  const auto rows = frame.rows();
  const auto sums = sum.rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    sums[i]->total += rows[i]->total;
    sums[i]->done += rows[i]->done;
    for (const Skipped& part : rows[i]->skipped) sums[i]->skip(part.why, part.count);
  }
  for (double Ledger::* part : {&Ledger::reading, &Ledger::preparing, &Ledger::planning, &Ledger::geometry,
                                &Ledger::pixels, &Ledger::writing, &Ledger::encoding})
    sum.*part += frame.*part;
}

void add_unchanged(const Ledger& frame, Ledger& sum) {
  const auto rows = frame.rows();
  const auto sums = sum.rows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    sums[i]->total += rows[i]->total;
    sums[i]->skip(name_of(Rule::unchanged), rows[i]->total);
  }
}

}  // namespace gradus::pipeline
