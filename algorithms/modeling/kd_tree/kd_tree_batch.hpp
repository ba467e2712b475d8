#pragma once
// Many searches, fast: the tree ends in buckets of up to eight points, which lie side by side in memory and
// whose distances are computed at once. Branches need no pointers: below branch i stand 2 i and 2 i + 1, and
// which points a bucket holds follows from its number.

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "modeling/kd_tree/kd_tree.hpp"

namespace gradus::kd_tree {

/// A tree for searches alone. It takes copies of the points.
///
/// Domain: as build; float or double.
/// Accuracy: finds what nearest and brute_force find, in the same order: distances are rounded alike, and
///   those of parts that are left out are of a place on their border, taken alike.
/// Cost: n log n comparisons to build.
/// Errors: ContractViolation outside the domain.
template <int N, std::floating_point T>
class Buckets {
 public:
  explicit Buckets(Points<N, T> points) : count_(points.size()), box_(box_around<N, T>(points)) {
    expect_points<N, T>(points);
    while (count_ > room << depth_) ++depth_;
    branches_.resize(bucket_count());
    buckets_.resize(bucket_count());
    std::vector<Item> items;
    items.reserve(count_);
    for (std::size_t i = 0; i < count_; ++i) items.push_back({points[i], static_cast<Index>(i)});
    part(items, 1, 0, bucket_count());
  }

  std::size_t size() const { return count_; }
  std::size_t bytes() const { return branches_.size() * sizeof(Branch) + buckets_.size() * sizeof(Bucket); }

  /// The nearest ones to a place, as many as there is room for.
  ///
  /// Domain: q as the points of build; room for at least one, and for no more than there are.
  /// Errors: ContractViolation outside the domain.
  void nearest(const Point<N, T>& q, std::span<Neighbour<T>> found) const {
    expect_query<N, T>(q, found.size());
    expects(found.size() <= count_, "there are {} points, not {}", count_, found.size());
    std::ranges::fill(found, Neighbour<T>{std::numeric_limits<T>::infinity(), none});
    if (found.size() == 1)
      search(q, [found](const Neighbour<T>& next) { return found[0] = next; });
    else
      search(q, [found](const Neighbour<T>& next) { return insert(found, next); });
  }

 private:
  static constexpr std::size_t room = 8;

  struct Item {
    Point<N, T> point;
    Index index;
  };
  /// Nothing below lies above the split along the axis, and nothing above below it.
  struct Branch {
    T split;
    int axis;
  };
  /// In places that no point takes one is infinitely far away.
  struct alignas(64) Bucket {
    std::array<std::array<T, room>, static_cast<std::size_t>(N)> along;
    std::array<Index, room> indices;
  };
  /// What is left to search, and how far it lies away: the squares along the axes, and their sum.
  struct Waiting {
    std::size_t branch;
    Point<N, T> squares;
    T distance;
  };

  std::size_t bucket_count() const { return std::size_t{1} << depth_; }
  /// The first point of a bucket.
  std::size_t first_of(std::size_t bucket) const { return bucket * count_ >> depth_; }

  void part(std::span<Item> items, std::size_t branch, std::size_t first, std::size_t last) {
    if (last - first == 1) return fill(items, buckets_[first]);
    const std::size_t middle = first + (last - first) / 2;
    const std::size_t rank = first_of(middle) - first_of(first);
    AxisBox<N, T> box{items[0].point, items[0].point};
    for (const Item& item : items) box = {glm::min(box.lower, item.point), glm::max(box.upper, item.point)};
    const int axis = longest_side<N, T>(box);
    const auto less = [axis](const Item& a, const Item& b) { return a.point[axis] < b.point[axis]; };
    std::ranges::nth_element(items, items.begin() + static_cast<std::ptrdiff_t>(rank), less);
    branches_[branch] = {items[rank].point[axis], axis};
    part(items.first(rank), 2 * branch, first, middle);
    part(items.subspan(rank), 2 * branch + 1, middle, last);
  }
  static void fill(std::span<const Item> items, Bucket& bucket) {
    for (auto& along : bucket.along) along.fill(std::numeric_limits<T>::infinity());
    bucket.indices.fill(none);
    for (std::size_t i = 0; i < items.size(); ++i) {
      for (int axis = 0; axis < N; ++axis)
        bucket.along[static_cast<std::size_t>(axis)][i] = items[i].point[axis];
      bucket.indices[i] = items[i].index;
    }
  }

  /// Puts one in its place among those found, the last of which goes; which is the last one now.
  static Neighbour<T> insert(std::span<Neighbour<T>> found, const Neighbour<T>& next) {
    std::size_t at = found.size() - 1;
    for (; at > 0 && next < found[at - 1]; --at) found[at] = found[at - 1];
    found[at] = next;
    return found.back();
  }
  static T sum_of(const Point<N, T>& squares) {
    T sum = squares[0];
    for (int axis = 1; axis < N; ++axis) sum += squares[axis];
    return sum;
  }
  template <class Keep>
  static void look_into(const Bucket& bucket, const Point<N, T>& q, Neighbour<T>& worst, const Keep& keep) {
    std::array<T, room> distances;
    for (std::size_t i = 0; i < room; ++i) {
      T sum = unfused((bucket.along[0][i] - q[0]) * (bucket.along[0][i] - q[0]));
      for (int axis = 1; axis < N; ++axis) {
        const T off = bucket.along[static_cast<std::size_t>(axis)][i] - q[axis];
        sum += unfused(off * off);
      }
      distances[i] = sum;
    }
    for (std::size_t i = 0; i < room; ++i) {
      if (distances[i] > worst.distance) continue;
      const Neighbour<T> next{distances[i], bucket.indices[i]};
      if (next < worst) worst = keep(next);
    }
  }
  /// keep(one that is nearer than the worst) gives the worst that is left.
  template <class Keep>
  void search(const Point<N, T>& q, const Keep& keep) const {
    std::array<Waiting, 32> waiting;
    std::size_t count = 0;
    Neighbour<T> worst{std::numeric_limits<T>::infinity(), none};
    Point<N, T> squares(T(0));
    for (int axis = 0; axis < N; ++axis) {
      const T off = std::clamp(q[axis], box_.lower[axis], box_.upper[axis]) - q[axis];
      squares[axis] = unfused(off * off);
    }
    for (std::size_t branch = 1;;) {
      while (branch < bucket_count()) {
        const auto [split, axis] = branches_[branch];
        const T off = q[axis] - split;
        const std::size_t near = 2 * branch + (off < T(0) ? 0 : 1);
        Waiting& far = waiting[count];
        far = {near ^ 1, squares, T(0)};
        far.squares[axis] = unfused(off * off);
        far.distance = sum_of(far.squares);
        count += far.distance > worst.distance ? 0 : 1;
        branch = near;
      }
      look_into(buckets_[branch - bucket_count()], q, worst, keep);
      do {
        if (count == 0) return;
        --count;
      } while (waiting[count].distance > worst.distance);
      branch = waiting[count].branch;
      squares = waiting[count].squares;
    }
  }

  std::size_t count_ = 0;
  unsigned depth_ = 0;
  AxisBox<N, T> box_;
  std::vector<Branch> branches_{};
  std::vector<Bucket> buckets_{};
};

}  // namespace gradus::kd_tree
