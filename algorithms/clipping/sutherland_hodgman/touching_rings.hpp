#pragma once
// Rings that touch themselves or each other. Where they do, the ways that meet there can be joined in several
// manners, all of which bound the same area. Here they are joined so that every ring goes round one connected
// part of the inside; and when all is cut, such a ring comes apart into an outline and the holes that touch
// it.

#include <algorithm>
#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "clipping/sutherland_hodgman/convex_window.hpp"

namespace gradus::sutherland_hodgman {

/// A closed chain of vertices; the area lies left of it.
template <class T>
using Ring = std::vector<Vertex<T>>;

/// Whether a point comes before another in a sweep: it lies farther left or, at the same x, lower.
template <class T>
constexpr bool comes_first(const glm::vec<2, T>& a, const glm::vec<2, T>& b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/// Whether a vertex lies on an edge that neither begins nor ends with it, or where another vertex does: so
/// that rings touch. Exact. Cost: O(n^2), 1 or 2 ns each: for few vertices that is faster than to sweep.
template <class T>
bool any_touch(const Outline<T>& polygon) {
  const int n = static_cast<int>(polygon.points.size());
  for (int i = 0; i < n; ++i) {
    const int next = polygon.after(i);
    const glm::vec<2, T>&p = polygon[i], &q = polygon[next];
    const glm::vec<2, T> low{std::min(p.x, q.x), std::min(p.y, q.y)};
    const glm::vec<2, T> high{std::max(p.x, q.x), std::max(p.y, q.y)};
    if (next == i || polygon.after(next) == i) return true;
    for (int k = 0; k < n; ++k) {
      const glm::vec<2, T>& v = polygon[k];
      if (v.x < low.x || v.x > high.x || v.y < low.y || v.y > high.y || k == i || k == next) continue;
      if (v == p || v == q || side(Line<T>{p, q}, v) == 0) return true;
    }
  }
  return false;
}

/// The rings of a polygon, joined anew where they touch.
///
/// A line sweeps over the plane and stops at every place where vertices lie. It knows the edges that it
/// crosses, from the lowest up, and so which of them end at the place, pass it and begin there. After
/// M. I. Shamos, D. Hoey, Geometric intersection problems, FOCS 1976, 208-215.
///
/// polygon: must outlive this.
///
/// Domain: finite coordinates. Rings that cross are joined, too, in some manner that bounds the same area,
///   counted as often as they go round it.
/// Accuracy: exact.
/// Cost: O(n log n) for n vertices of rings that don't cross, and 4 bytes moved for each edge above a place.
template <class T>
class TouchingRings {
 public:
  explicit TouchingRings(const Outline<T>& polygon) : polygon_(polygon) {
    const std::size_t n = polygon.points.size();
    std::vector<Corner> corners(n);
    edges_.reserve(n);
    for (int i = 0; i < static_cast<int>(n); ++i) {
      const glm::vec<2, T>&p = polygon[i], &q = polygon[polygon.after(i)];
      const bool forward = comes_first(p, q);
      edges_.push_back({forward ? Line<T>{p, q} : Line<T>{q, p}, forward});
      corners[index(i)].at = p;
      corners[index(i)].vertex = i;
      corners[index(polygon.after(i))].edge_before = i;
    }
    std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
      return comes_first(a.at, b.at) || (a.vertex < b.vertex && a.at == b.at);
    });
    stretches_.reserve(n);
    meeting_.reserve(2 * n);
    places_.reserve(n);
    // Stop at every place, with the edges from and to its vertices
    std::vector<int> there;
    for (std::size_t i = 0; i < n;) {
      const Corner& here = corners[i];
      there.clear();
      for (; i < n && corners[i].at == here.at; ++i) {
        there.push_back(corners[i].vertex);
        there.push_back(corners[i].edge_before);
      }
      stop(here.vertex, there);
    }
  }

  /// Whether rings touch at all, or repeat a vertex. If not, joined() gives them as they are.
  bool touch() const { return touch_; }

  /// The rings, each round one connected part of the inside, which lies left of it; it passes a point as
  /// often as the part has it on its border. Edges that rings run both ways bound nothing and are gone.
  std::vector<Ring<T>> joined() {
    std::size_t begin = 0;
    for (const Place& place : places_) {
      join(place.vertex, std::span<const int>(meeting_).subspan(begin, place.end - begin));
      begin = place.end;
    }
    // Rings begin with the first of their edges, as they did
    std::vector<int> order;
    for (std::size_t i = 0; i < stretches_.size(); ++i) {
      if (!stretches_[i].gone) order.push_back(static_cast<int>(i));
    }
    std::stable_sort(order.begin(), order.end(),
                     [this](int a, int b) { return stretch(a).edge < stretch(b).edge; });
    std::vector<Ring<T>> rings;
    std::vector<bool> used(stretches_.size());
    for (const int start : order) {
      Ring<T> ring;
      for (int now = start; !used[index(now)]; now = stretch(now).next) {
        used[index(now)] = true;
        ring.push_back(vertex_at_start(now));
      }
      if (ring.size() >= 3) rings.push_back(std::move(ring));
    }
    return rings;
  }

 private:
  /// A vertex with the edges to it and, named as it is, from it.
  struct Corner {
    glm::vec<2, T> at;
    int vertex, edge_before;
  };
  /// What the sweep knows of an edge.
  struct Edge {
    Line<T> line;      ///< from the end that comes first
    bool forward;      ///< whether the ring runs it that way
    int stretch = -1;  ///< the last one of it so far
  };
  /// A part of an edge between two neighbouring places on it.
  struct Stretch {
    int edge;       ///< by the vertex that it begins at
    int first;      ///< a vertex at the end that comes first
    int last = -1;  ///< one at the other end; -1: the line has not come there
    int next = -1;  ///< the stretch that follows in the ring
    bool gone{};    ///< another one runs it the other way
  };
  struct Place {
    int vertex;
    std::size_t end;  ///< of the stretches that meet there
  };

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  Stretch& stretch(int i) { return stretches_[index(i)]; }
  const Edge& edge_of(int i) const { return edges_[index(stretches_[index(i)].edge)]; }

  /// The side of a stretch that the line crosses on which the place is: 1 above, 0 on it, -1 below.
  int side_of(int i, const glm::vec<2, T>& p) const {
    const Line<T>& line = edge_of(i).line;
    return line.q == p ? 0 : side(line, p);
  }
  /// Where the stretches that pass below a point end, among those that the line crosses.
  std::size_t first_not_below(const glm::vec<2, T>& p) const {
    std::size_t low = 0, high = crossed_.size();
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (side_of(crossed_[middle], p) > 0) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /// The line stops at the place of a vertex. `there`: the edges from and to all vertices that lie there.
  void stop(int here, std::span<const int> there) {
    const glm::vec<2, T>& p = polygon_[here];
    // The stretches that come here lie together
    std::size_t low = first_not_below(p), high = low;
    while (high < crossed_.size() && side_of(crossed_[high], p) == 0) ++high;
    arriving_.assign(crossed_.begin() + offset(low), crossed_.begin() + offset(high));
    for (const int i : arriving_) stretch(i).last = here;
    // Where rings cross the order may be lost: then look for those that end here
    for (const int edge : there) {
      const Edge& e = edges_[index(edge)];
      if (e.line.q != p || e.line.p == p || stretch(e.stretch).last >= 0) continue;
      stretch(e.stretch).last = here;
      arriving_.push_back(e.stretch);
      const auto found = std::find(crossed_.begin(), crossed_.end(), e.stretch);
      if (found < crossed_.begin() + offset(low)) --low, --high;
      crossed_.erase(found);
    }
    // Edges that pass go on, others begin
    leaving_.clear();
    for (const int i : arriving_) {
      if (edge_of(i).line.q != p) leave(here, stretch(i).edge);
    }
    for (const int edge : there) {
      const Line<T>& line = edges_[index(edge)].line;
      if (line.p == p && line.q != p) leave(here, edge);
    }
    std::sort(leaving_.begin(), leaving_.end(),
              [this](int a, int b) { return heading(edge_of(a).line, edge_of(b).line) > 0; });
    // They take the place of those that came
    const std::size_t both = std::min(high - low, leaving_.size());
    const auto after = std::copy_n(leaving_.begin(), both, crossed_.begin() + offset(low));
    const auto rest = crossed_.erase(after, crossed_.begin() + offset(high));
    crossed_.insert(rest, leaving_.begin() + offset(both), leaving_.end());
    touch_ = touch_ || there.size() != 2 || arriving_.size() + leaving_.size() != 2;
    leave_out_both_ways();
    // Counter-clockwise from straight down
    meeting_.insert(meeting_.end(), leaving_.begin(), leaving_.end());
    meeting_.insert(meeting_.end(), arriving_.rbegin(), arriving_.rend());
    places_.push_back({here, meeting_.size()});
  }
  void leave(int here, int edge) {
    edges_[index(edge)].stretch = static_cast<int>(stretches_.size());
    leaving_.push_back(edges_[index(edge)].stretch);
    stretches_.push_back({edge, here});
  }
  static std::ptrdiff_t offset(std::size_t i) { return static_cast<std::ptrdiff_t>(i); }

  /// Of the stretches that arrive, those that come from one place lie side by side: two that rings run in
  /// opposite ways bound nothing.
  void leave_out_both_ways() {
    if (arriving_.size() < 2) return;
    std::vector<int> open;
    for (const int i : arriving_) {
      if (!open.empty() && stretch(open.back()).first == stretch(i).first &&
          edge_of(open.back()).forward != edge_of(i).forward) {
        stretch(open.back()).gone = stretch(i).gone = touch_ = true;
        open.pop_back();
      } else {
        open.push_back(i);
      }
    }
  }

  /// Joins the stretches that meet at a place, counter-clockwise: the inside lies left of one that comes, up
  /// to the one before it, which goes.
  void join(int place, std::span<const int> meeting) {
    std::vector<int> going;
    for (const bool again : {false, true}) {
      for (const int i : meeting) {
        const bool goes = edge_of(i).forward == (stretch(i).first == place);
        if (stretch(i).gone) continue;
        if (goes) {
          if (!again) going.push_back(i);
        } else if (stretch(i).next < 0 && !going.empty()) {
          stretch(i).next = going.back();
          going.pop_back();
        }
      }
    }
  }

  Vertex<T> vertex_at_start(int i) {
    const Stretch& s = stretch(i);
    const int there = edge_of(i).forward ? s.first : s.last;
    // The edge's own, or one that touches it
    const int number = polygon_[s.edge] == polygon_[there] ? s.edge : there;
    return {polygon_[number], number, {}, {}, EdgeName::polygon(s.edge)};
  }

  const Outline<T> polygon_;
  std::vector<Edge> edges_;
  std::vector<Stretch> stretches_;
  std::vector<int> crossed_;             // the stretches that the line crosses, from the lowest up
  std::vector<int> arriving_, leaving_;  // at the place where it is, from the lowest up
  std::vector<int> meeting_;             // at all places
  std::vector<Place> places_;
  bool touch_ = false;
};

/// Takes out the input's vertices at which a ring stays on one edge: others touched it there.
template <class T>
void leave_out_straight(Ring<T>& ring) {
  if (ring.empty()) return;
  std::size_t kept = 0;
  EdgeName last = ring.back().after;
  for (const Vertex<T>& v : ring) {
    const bool straight = !v.made() && v.after == last;
    last = v.after;
    if (!straight) ring[kept++] = v;
  }
  ring.resize(kept);
}

/// The simple rings of one that passes points more than once: each time it comes back to a point, what came
/// since is one of them. The ring is left as it is if it passes none twice.
/// Domain: the points passed twice are vertices of the input. Cost: O(n log n).
template <class T>
std::vector<Ring<T>> simple_rings(const Ring<T>& ring) {
  const auto before = [](const glm::vec<2, T>& a, const glm::vec<2, T>& b) { return comes_first(a, b); };
  std::map<glm::vec<2, T>, std::size_t, decltype(before)> visited(before);
  std::vector<Ring<T>> rings;
  Ring<T> open;
  for (const Vertex<T>& vertex : ring) {
    const auto last = vertex.made() ? visited.end() : visited.find(vertex.at);
    if (last != visited.end()) {
      const auto begin = open.begin() + static_cast<std::ptrdiff_t>(last->second);
      rings.emplace_back(begin, open.end());
      open.erase(begin, open.end());
      for (const Vertex<T>& v : rings.back()) {
        if (!v.made()) visited.erase(v.at);
      }
    }
    if (!vertex.made()) visited[vertex.at] = open.size();
    open.push_back(vertex);
  }
  rings.push_back(std::move(open));
  for (Ring<T>& simple : rings) leave_out_straight(simple);
  std::erase_if(rings, [](const Ring<T>& simple) { return simple.size() < 3; });
  return rings;
}

}  // namespace gradus::sutherland_hodgman
