#pragma once
// What was done and what was left out, stage by stage: at every stage the two add up to all there is.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace gradus::pipeline {

/// Why it was left out, and how much of it.
struct Skipped {
  std::string_view why;
  std::int64_t count = 0;
};

/// What one stage did. done + skipped = total.
struct LedgerRow {
  int stage;
  std::string_view name, unit;
  std::int64_t total = 0, done = 0;
  std::vector<Skipped> skipped{};

  void skip(std::string_view why, std::int64_t count = 1) {
    if (count == 0) return;
    const auto known = std::ranges::find(skipped, why, &Skipped::why);
    if (known == skipped.end())
      skipped.push_back({why, count});
    else
      known->count += count;
  }
  std::int64_t skipped_in_all() const {
    std::int64_t sum = 0;
    for (const Skipped& part : skipped) sum += part.count;
    return sum;
  }
};

/// Tells the time in seconds, from any beginning. Without one no time is taken.
using Clock = std::function<double()>;

/// The rows of a run, and how long its parts took in seconds.
struct Ledger {
  LedgerRow input{1, "input model", "faces"};
  LedgerRow world{2, "world transformation", "vertices"};
  LedgerRow perspective{3, "perspective transformation", "vertices"};
  LedgerRow facing{4, "back-face removal", "triangles"};
  LedgerRow clipping{5, "clipping", "triangles"};
  LedgerRow rasterization{6, "rasterization", "triangles"};
  LedgerRow lamps{7, "shading", "lamps at places"};
  LedgerRow highlights{7, "highlights", "lamps at places"};
  LedgerRow texels{7, "textures", "places"};
  LedgerRow output{8, "output", "pixels"};

  /// Reading files; mip maps and buffers; planning with the search for what is hidden; stages 1 to 5; 6 and
  /// 7, which alternate; 8; making the file.
  double reading = 0, preparing = 0, planning = 0, geometry = 0, pixels = 0, writing = 0, encoding = 0;

  std::vector<const LedgerRow*> rows() const { return rows_of<const LedgerRow>(*this); }
  std::vector<LedgerRow*> rows() { return rows_of<LedgerRow>(*this); }

 private:
  template <class Row, class Self>
  static std::vector<Row*> rows_of(Self& ledger) {
    return {&ledger.input,         &ledger.world, &ledger.perspective, &ledger.facing, &ledger.clipping,
            &ledger.rasterization, &ledger.lamps, &ledger.highlights,  &ledger.texels, &ledger.output};
  }
};

/// Adds to `seconds` how long something took, and returns what it returned.
template <class Work>
auto timed(const Clock& clock, double& seconds, const Work& work) {
  const double before = clock ? clock() : 0;
  auto result = work();
  seconds += clock ? clock() - before : 0;
  return result;
}

}  // namespace gradus::pipeline
