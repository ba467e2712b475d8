// The nearest of many points of space, by trees and by brute force, beside nanoflann where it is there.

#include "modeling/kd_tree/kd_tree.hpp"

#include <fmt/format.h>

#include <memory>

#include "benchmark/subject.hpp"
#include "core/random.hpp"
#include "modeling/kd_tree/kd_tree_batch.hpp"
#include "modeling/kd_tree/kd_tree_notes.hpp"

#ifdef GRADUS_HAS_NANOFLANN
#include <nanoflann.hpp>
#endif

namespace gradus::bench {
namespace {

using namespace kd_tree;
using Place = Point<3, float>;
using Cloud = std::vector<Place>;
using Found = Neighbours<float>;

Cloud evenly_spread(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  Cloud cloud(count);
  for (Place& p : cloud) p = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  return cloud;
}

/// What all methods search, and for what.
struct Task {
  Cloud points, queries;
  std::size_t k;
};
using Search = std::function<Found(const Place&)>;

/// Those of the first searches that are others than by brute force.
Error of_searches(const Task& task, const Search& search) {
  constexpr std::size_t judged = 100;
  Error::Sum sum;
  for (std::size_t i = 0; i < std::min(judged, task.queries.size()); ++i) {
    const Found right = brute_force<3, float>(task.points, task.queries[i], task.k);
    const Found found = search(task.queries[i]);
    sum.add(static_cast<double>(found.back().distance - right.back().distance));
    if (found != right) sum.wrong_decision();
  }
  return sum.error();
}

std::string named(std::size_t count) { return fmt::format("{} points", count); }

/// A run is one search, each for the next place.
Case searching(const char* method, Standing standing, const std::shared_ptr<Task>& task,
               const Search& search) {
  const bool of_series = task->k == 8;
  const auto next = std::make_shared<std::size_t>(0);
  return {
      .method = method,
      .standing = standing,
      .workload = {of_series ? named(task->points.size()) : named(task->points.size()) + ", the nearest one",
                   of_series ? static_cast<double>(task->points.size()) : 0},
      .run = [task, next, search] { search(task->queries[++* next %= task->queries.size()]); },
      .error = of_searches(*task, search)};
}
Case building(const char* method, Standing standing, const std::shared_ptr<Task>& task,
              const std::function<void()>& build) {
  return {.method = method,
          .standing = standing,
          .workload = {named(task->points.size()) + ", the tree"},
          .items = std::ssize(task->points),
          .run = build};
}

#ifdef GRADUS_HAS_NANOFLANN
/// Points as nanoflann asks for them.
struct Theirs {
  const Cloud& cloud;
  std::size_t kdtree_get_point_count() const { return cloud.size(); }
  float kdtree_get_pt(std::size_t i, std::size_t axis) const { return cloud[i][static_cast<int>(axis)]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};
using TheirTree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Theirs>, Theirs, 3, Index>;

struct TheirSearch {
  explicit TheirSearch(const std::shared_ptr<Task>& its_task) : task(its_task), tree(3, points) {
    tree.buildIndex();
  }
  Found operator()(const Place& q) {
    std::array<Index, 8> indices;
    std::array<float, 8> squares;
    const std::size_t count = tree.knnSearch(&q[0], task->k, indices.data(), squares.data());
    Found found(count);
    for (std::size_t i = 0; i < count; ++i) found[i] = {squares[i], indices[i]};
    return found;
  }
  std::shared_ptr<Task> task;
  Theirs points{task->points};
  TheirTree tree;
};
#endif

void add_searches(std::vector<Case>& all, const std::shared_ptr<Task>& task) {
  const auto tree = std::make_shared<Tree<3, float>>(build<3, float>(task->points));
  const auto buckets = std::make_shared<Buckets<3, float>>(task->points);
  all.push_back(searching("nearest", Standing::taught, task,
                          [task, tree](const Place& q) { return nearest<3, float>(*tree, q, task->k); }));
  all.push_back(searching("Buckets", Standing::batch, task, [task, buckets](const Place& q) {
    Found found(task->k);
    buckets->nearest(q, found);
    return found;
  }));
  all.push_back(searching("brute_force", Standing::robust, task, [task](const Place& q) {
    return brute_force<3, float>(task->points, q, task->k);
  }));
  all.push_back(searching("no_turning_back", Standing::faulty, task, [task, tree](const Place& q) {
    return no_turning_back<3, float>(*tree, q, task->k);
  }));
  all.push_back(searching("not_squared", Standing::faulty, task,
                          [task, tree](const Place& q) { return not_squared<3, float>(*tree, q, task->k); }));
#ifdef GRADUS_HAS_NANOFLANN
  const auto theirs = std::make_shared<TheirSearch>(task);
  all.push_back(
      searching("nanoflann", Standing::peer, task, [theirs](const Place& q) { return (*theirs)(q); }));
#endif
}
void add_builds(std::vector<Case>& all, const std::shared_ptr<Task>& task) {
  all.push_back(building("nearest", Standing::taught, task, [task] { build<3, float>(task->points); }));
  all.push_back(building("Buckets", Standing::batch, task, [task] { Buckets<3, float>{task->points}; }));
#ifdef GRADUS_HAS_NANOFLANN
  all.push_back(building("nanoflann", Standing::peer, task, [task] { TheirSearch{task}; }));
#endif
}

std::vector<Case> cases() {
  std::vector<Case> all;
  const Cloud queries = evenly_spread(1000, 2);
  for (const std::size_t count : {100u, 1'000u, 10'000u, 100'000u, 1'000'000u}) {
    const auto task = std::make_shared<Task>(Task{evenly_spread(count, 1), queries, 8});
    add_searches(all, task);
    if (count < 1'000'000) continue;
    add_searches(all, std::make_shared<Task>(Task{task->points, queries, 1}));
    add_builds(all, task);
  }
  return all;
}

}  // namespace

Subject kd_tree() {
  return {.topic = "kd_tree",
          .title = "The nearest eight of many points",
          .item = "search",
          .unit = "squares of a unit",
          .measure = "points",
          .telling = "100000 points",
          .cases = cases,
          .choice = {"Buckets", "the same neighbours, from eight distances at once"}};
}

}  // namespace gradus::bench
