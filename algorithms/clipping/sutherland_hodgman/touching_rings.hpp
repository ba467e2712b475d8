#pragma once
// Rings that touch themselves or each other. Where they do, the ways that meet there can be joined in several
// manners, all of which bound the same area. Here they are joined so that every ring goes round one connected
// part of the inside; and when all is cut, such a ring comes apart into an outline and the holes that touch
// it.

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
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

// --- Whether they do ---------------------------------------------

/// A point's mirror image beside a line. Accuracy: a few ulp.
template <std::floating_point T>
glm::vec<2, T> mirrored(const glm::vec<2, T>& point, const Segment<2, T>& line) {
  const glm::vec<2, T> way = line.b - line.a, across{-way.y, way.x};
  return point - 2 * (glm::dot(across, point - line.a) / glm::dot(across, across)) * across;
}

/// Whether there is a point from which a ring is seen to run once round it, counter-clockwise, and turns back
/// nowhere: then it can't touch itself. So do convex polygons, and stars. It is looked for from the middle of
/// the vertices on: where an edge is seen from its outer side, the point moves over to the other one.
/// T. S. Motzkin, I. J. Schoenberg, The relaxation method for linear inequalities, Canadian Journal of
/// Mathematics 6, 1954, 393-404.
///
/// Domain: finite coordinates, one ring. Accuracy: true is proved exactly; false may be said of a ring that
///   has such a point. Cost: about 5 ns per vertex and round, of which there are 8 at most; an end after as
///   many moves as a quarter of the vertices, at most 2000.
template <std::floating_point T>
bool goes_round_a_point(const Outline<T>& ring) {
  const int n = static_cast<int>(ring.points.size());
  glm::vec<2, T> centre(0);
  for (const glm::vec<2, T>& p : ring.points) centre += p / static_cast<T>(n);
  int moves_left = std::min(n / 4, 2000);
  for (int round = 0; round < 8; ++round) {
    bool moved = false;
    int upwards_right = 0;  // edges that pass there: as often as the ring goes round
    for (int i = 0; i < n; ++i) {
      const Segment<2, T> edge{ring[i], ring[ring.after(i)]};
      if (side(edge, centre) > 0) {
        upwards_right += edge.a.y <= centre.y && centre.y < edge.b.y;
        continue;
      }
      centre = mirrored(centre, edge);
      moved = true;
      if (moves_left-- == 0 || !is_finite(centre)) return false;
    }
    if (!moved) return upwards_right == 1;
  }
  return false;
}

/// Looks whether a vertex lies on an edge that neither begins nor ends with it, or where another vertex does:
/// so that rings touch. Boxes stand round runs of a few edges, round two such runs, and so on; where boxes
/// lie apart nothing touches.
///
/// polygon: must outlive this.
///
/// Domain: finite coordinates.
/// Accuracy: exact.
/// Cost: O(n) for n vertices, 50 to 100 ns each, where few boxes overlap, as those of runs that are short
///   beside the whole ring. Boxes of long edges side by side and aslant do overlap: after 3 n meetings the
///   search ends without an answer, so that it costs at most 0.3 us per vertex.
template <class T>
class TouchSearch {
 public:
  explicit TouchSearch(const Outline<T>& polygon) : polygon_(polygon), left_(3 * polygon.points.size()) {}

  /// Whether rings touch; nothing where the boxes don't tell.
  std::optional<bool> answer() {
    const bool found = any_short_ring() || (size() <= 2 * run ? on_edges(all(), all()) : among_boxes());
    if (!found && left_ == 0) return std::nullopt;
    return found;
  }

 private:
  static constexpr std::size_t run = 4;  // edges in the smallest boxes
  using Box = AxisBox<2, T>;
  /// The edges from these vertices on.
  struct Run {
    std::size_t begin, end;
  };

  std::size_t size() const { return polygon_.points.size(); }
  Run all() const { return {0, size()}; }
  Run run_of(std::size_t i) const { return {i * run, std::min(size(), (i + 1) * run)}; }
  int after(std::size_t i) const { return polygon_.after(static_cast<int>(i)); }

  /// Rings of one vertex or two run over themselves.
  bool any_short_ring() const {
    for (std::size_t i = 0; i < size(); ++i) {
      if (polygon_.after(after(i)) == static_cast<int>(i)) return true;
    }
    return false;
  }

  static Box box_round(const glm::vec<2, T>& p, const glm::vec<2, T>& q) {
    return {{std::min(p.x, q.x), std::min(p.y, q.y)}, {std::max(p.x, q.x), std::max(p.y, q.y)}};
  }
  static Box box_round(const Box& a, const Box& b) {
    return {{std::min(a.lower.x, b.lower.x), std::min(a.lower.y, b.lower.y)},
            {std::max(a.upper.x, b.upper.x), std::max(a.upper.y, b.upper.y)}};
  }
  // Which of the four comparisons fails can't be foretold: all are cheaper than a wrong guess
  static bool holds(const Box& box, const glm::vec<2, T>& p) {
    return (box.lower.x <= p.x) + (p.x <= box.upper.x) + (box.lower.y <= p.y) + (p.y <= box.upper.y) == 4;
  }
  static bool meet(const Box& a, const Box& b) {
    return (a.lower.x <= b.upper.x) + (b.lower.x <= a.upper.x) + (a.lower.y <= b.upper.y) +
               (b.lower.y <= a.upper.y) ==
           4;
  }

  bool touches(std::size_t edge, std::size_t vertex) const {
    const int next = after(edge);
    const glm::vec<2, T>&p = polygon_.points[edge], &q = polygon_[next], &v = polygon_.points[vertex];
    if (!holds(box_round(p, q), v) || vertex == edge || static_cast<int>(vertex) == next) return false;
    return v == p || v == q || side(Segment<2, T>{p, q}, v) == 0;
  }
  bool on_edges(Run vertices, Run edges) const {
    for (std::size_t edge = edges.begin; edge < edges.end; ++edge) {
      for (std::size_t vertex = vertices.begin; vertex < vertices.end; ++vertex) {
        if (touches(edge, vertex)) return true;
      }
    }
    return false;
  }
  /// Whether a vertex of run i lies on an edge of run j.
  bool on_edges(std::size_t i, std::size_t j) {
    const Run vertices = run_of(i);
    for (std::size_t v = vertices.begin; v < vertices.end; ++v) {
      if (!holds(boxes_[j], polygon_.points[v])) continue;
      if (left_ > 0) --left_;
      if (on_edges({v, v + 1}, run_of(j))) return true;
    }
    return false;
  }

  /// Makes the boxes, level by level, up to one round all, and goes down again.
  bool among_boxes() {
    for (std::size_t i = 0; i * run < size(); ++i) {
      const Run edges = run_of(i);
      Box box = box_round(polygon_.points[edges.begin], polygon_[after(edges.begin)]);
      for (std::size_t k = edges.begin + 1; k < edges.end; ++k) {
        box = box_round(box, box_round(polygon_.points[k], polygon_[after(k)]));
      }
      boxes_.push_back(box);
    }
    std::size_t begin = 0;
    while (begin_.push_back(begin), boxes_.size() - begin > 1) {
      const std::size_t end = boxes_.size();
      for (std::size_t i = begin; i < end; i += 2) {
        boxes_.push_back(i + 1 < end ? box_round(boxes_[i], boxes_[i + 1]) : boxes_[i]);
      }
      begin = end;
    }
    begin_.push_back(boxes_.size());
    return within(begin_.size() - 2, 0);
  }
  std::size_t boxes_at(std::size_t level) const { return begin_[level + 1] - begin_[level]; }
  const Box& box(std::size_t level, std::size_t i) const { return boxes_[begin_[level] + i]; }

  /// Whether edges of one box touch, and those of two.
  bool within(std::size_t level, std::size_t i) {
    if (level == 0) return on_edges(run_of(i), run_of(i));
    const std::size_t first = 2 * i, second = 2 * i + 1;
    if (within(level - 1, first)) return true;
    if (second == boxes_at(level - 1)) return false;
    return within(level - 1, second) || between(level - 1, first, second);
  }
  bool between(std::size_t level, std::size_t i, std::size_t j) {
    if (!meet(box(level, i), box(level, j)) || left_ == 0) return false;
    --left_;
    if (level == 0) return on_edges(i, j) || on_edges(j, i);
    const std::size_t count = boxes_at(level - 1);
    for (std::size_t a = 2 * i; a < std::min(2 * i + 2, count); ++a) {
      for (std::size_t b = 2 * j; b < std::min(2 * j + 2, count); ++b) {
        if (between(level - 1, a, b)) return true;
      }
    }
    return false;
  }

  const Outline<T> polygon_;
  std::vector<Box> boxes_;          // of all levels, from the smallest on
  std::vector<std::size_t> begin_;  // where each level begins in them
  std::size_t left_;                // meetings of boxes, and of vertices with one, that may still be had
};

// --- How they are joined then ------------------------------------

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
/// Cost: O(n log n) for n vertices of rings that don't cross, 0.15 to 0.5 us each up to some 10,000 of them;
///   and 4 bytes moved for each edge above a place: O(n^2) bytes where a vertical line crosses most edges.
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
      edges_.push_back({forward ? Segment<2, T>{p, q} : Segment<2, T>{q, p}, forward});
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
    Segment<2, T> line;  ///< from the end that comes first
    bool forward;        ///< whether the ring runs it that way
    int stretch = -1;    ///< the last one of it so far
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
    const Segment<2, T>& line = edge_of(i).line;
    return line.b == p ? 0 : side(line, p);
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
      if (e.line.b != p || e.line.a == p || stretch(e.stretch).last >= 0) continue;
      stretch(e.stretch).last = here;
      arriving_.push_back(e.stretch);
      const auto found = std::find(crossed_.begin(), crossed_.end(), e.stretch);
      if (found < crossed_.begin() + offset(low)) --low, --high;
      crossed_.erase(found);
    }
    // Edges that pass go on, others begin
    leaving_.clear();
    for (const int i : arriving_) {
      if (edge_of(i).line.b != p) leave(here, stretch(i).edge);
    }
    for (const int edge : there) {
      const Segment<2, T>& line = edges_[index(edge)].line;
      if (line.a == p && line.b != p) leave(here, edge);
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
