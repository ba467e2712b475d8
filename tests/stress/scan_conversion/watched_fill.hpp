#pragma once
// The observer of a fill that knows what every step must hold.

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "scan_conversion/flood_fill/flood_fill.hpp"
#include "stress/scan_conversion/areas.hpp"

namespace gradus::stress {

/// Watches a fill of an area: cells are painted once, beside one that is painted already; an answer is
/// whether a cell belongs to the area and is not painted.
struct Watch {
  const Mask& area;
  ivec2 seed;
  flood_fill::Connectivity connectivity;
  Mask painted{area.width(), area.height()};
  std::int64_t count = 0;
  std::size_t waiting = 0;  ///< on the stack or in the queue
  bool right = true;
  bool finished = false;

  void want(bool holds) { right = right && holds; }
  bool neighbours(ivec2 p, ivec2 q) const {
    const ivec2 d = glm::abs(p - q);
    return connectivity == flood_fill::Connectivity::four ? d.x + d.y == 1 : std::max(d.x, d.y) == 1;
  }
  bool touches(ivec2 p) const {
    return p == seed ||
           std::ranges::any_of(flood_fill::ways(connectivity), [&](ivec2 d) { return has(painted, p + d); });
  }
  void paint(ivec2 p) {
    want(has(area, p) && !painted[p]);
    if (area.contains(p)) painted[p] = 1;
    ++count;
  }
  void all_painted(const flood_fill::Span& s) {
    want(s.left <= s.right);
    for (int x = s.left; x <= s.right; ++x) want(has(painted, {x, s.row}));
  }

  void operator()(const flood_fill::Started& s) { want(s.seed == seed && s.inside == has(area, seed)); }
  void operator()(const flood_fill::Painted& p) {
    want(touches(p.pixel) && (p.pixel == seed || has(painted, p.from)) && p.waiting == ++waiting);
    paint(p.pixel);
  }
  void operator()(const flood_fill::Examined& e) {
    want(has(painted, e.from) && neighbours(e.pixel, e.from));
    want(e.inside == (has(area, e.pixel) && !painted[e.pixel]));
  }
  void operator()(const flood_fill::SpanFilled& filled) {
    const flood_fill::Span& s = filled.span;
    bool joined = false;
    for (int x = s.left; x <= s.right; ++x) joined = joined || touches({x, s.row});
    want(joined && filled.found.y == s.row && s.left <= filled.found.x && filled.found.x <= s.right);
    for (int x = s.left; x <= s.right; ++x) paint({x, s.row});
    // Both ends are stopped
    for (const ivec2 end : {ivec2{s.left - 1, s.row}, ivec2{s.right + 1, s.row}}) {
      want(!has(area, end) || painted[end]);
    }
  }
  void operator()(const flood_fill::SpanQueued& q) {
    all_painted(q.span);
    want(q.waiting == ++waiting);
  }
  void operator()(const flood_fill::SpanTaken& t) {
    all_painted(t.span);
    want(t.waiting == --waiting);
  }
  void operator()(const flood_fill::Dequeued& d) { want(has(painted, d.pixel) && d.waiting == --waiting); }
  void operator()(const flood_fill::Retreated& r) { want(has(painted, r.pixel) && r.waiting == --waiting); }
  void operator()(const flood_fill::Finished& f) {
    want(!finished && waiting == 0 && f.filled.painted == count && painted == area);
    finished = true;
  }
};

}  // namespace gradus::stress
