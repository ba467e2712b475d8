#include "figure/legend.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <unordered_map>

namespace gradus {
namespace {

/// Texts and pictures have no look that a legend could tell.
bool shows_its_role(const Mark& mark) {
  return !std::holds_alternative<Text>(mark.shape) && !std::holds_alternative<Label>(mark.shape) &&
         !std::holds_alternative<Picture>(mark.shape);
}

/// What a legend can tell of the drawing while steps change it.
class LegendWatch {
 public:
  void set(const Mark& mark) {
    remove(mark.id);
    if (!shows_its_role(mark)) return;
    roles_.emplace(mark.id, mark.role);
    ++seen_[Seen{mark.role, std::nullopt}];
  }
  void apply(const Delta& delta) {
    for (const std::string& id : delta.removed) remove(id);
    for (const CellChange& change : delta.cells) put(change);
    for (const Mark& mark : delta.set) set(mark);
  }
  LegendEntries shown(const std::vector<LegendEntry>& legend) const {
    LegendEntries entries = 0;
    for (std::size_t i = 0; i < legend.size(); ++i) {
      const auto found = seen_.find({legend[i].role, legend[i].color});
      if (found != seen_.end() && found->second > 0) entries |= LegendEntries{1} << i;
    }
    return entries;
  }

 private:
  /// A role, and of a cell with a colour of its own that.
  struct Seen {
    Role role;
    std::optional<Rgba8> color;
    friend bool operator<(const Seen& a, const Seen& b) { return key(a) < key(b); }
    static std::tuple<Role, bool, std::uint32_t> key(const Seen& s) {
      const Rgba8 c = s.color.value_or(Rgba8{});
      const auto code = static_cast<std::uint32_t>((c.r << 16) | (c.g << 8) | c.b);
      return {s.role, s.color.has_value(), code};
    }
  };

  void remove(const std::string& id) {
    const auto found = roles_.find(id);
    if (found == roles_.end()) return;
    --seen_[Seen{found->second, std::nullopt}];
    roles_.erase(found);
  }
  void put(const CellChange& change) {
    const std::uint64_t key = key_of(change.at);
    if (const auto found = cells_.find(key); found != cells_.end()) {
      --seen_[found->second];
      cells_.erase(found);
    }
    if (!change.look) return;
    const Seen now{change.look->role, change.look->color};
    cells_.emplace(key, now);
    ++seen_[now];
  }

  std::unordered_map<std::string, Role> roles_;  ///< of marks, by id
  std::unordered_map<std::uint64_t, Seen> cells_;
  std::map<Seen, std::int64_t> seen_;
};

/// Tells of each recorded step which entries it shows. False: it is not known.
template <class Told>
bool watch_legend(const Trace& trace, Told told) {
  const bool from_the_start = !trace.steps.empty() && trace.steps.front().number == StepNumber{};
  if (!from_the_start || trace.legend.size() > 64) return false;
  LegendWatch watch;
  for (const Mark& mark : trace.backdrop) watch.set(mark);
  for (const TraceStep& step : trace.steps) {
    watch.apply(step.delta);
    told(step.number, watch);
  }
  return true;
}
}  // namespace

std::vector<LegendEntries> legends_of(const Trace& trace) {
  std::set<LegendEntries> seen;
  watch_legend(trace, [&](StepNumber, const LegendWatch& watch) { seen.insert(watch.shown(trace.legend)); });
  return {seen.begin(), seen.end()};
}

std::vector<LegendEntry> legend_at(const Trace& trace, std::span<const StepNumber> steps) {
  LegendEntries shown = 0;
  const bool known = watch_legend(trace, [&](StepNumber number, const LegendWatch& watch) {
    if (std::ranges::find(steps, number) != steps.end()) shown |= watch.shown(trace.legend);
  });
  std::vector<LegendEntry> entries;
  for (std::size_t i = 0; i < trace.legend.size(); ++i) {
    if (!known || (shown >> i & 1) != 0) entries.push_back(trace.legend[i]);
  }
  return entries;
}

}  // namespace gradus
