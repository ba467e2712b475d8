// Normals of points on a ball, which are known: from few and from more neighbours, found in a tree or among
// all.

#include "modeling/point_cloud/point_cloud.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "benchmark/subject.hpp"
#include "core/random.hpp"
#include "modeling/point_cloud/point_cloud_notes.hpp"

namespace gradus::bench {
namespace {

using namespace point_cloud;

/// Random points of a ball that is not in the origin, and the eye beside it.
struct Scan {
  std::vector<dvec3> points{}, right{};
  Tree<double> tree{};
};
constexpr dvec3 centre{20, 0, 0}, eye{20, 0, 30};

std::shared_ptr<const Scan> scan_of(std::size_t count) {
  const auto scan = std::make_shared<Scan>();
  Random random(1);
  while (scan->points.size() < count) {
    const dvec3 p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const double square = glm::dot(p, p);
    if (square > 1 || square < 0.01) continue;
    scan->right.push_back(unit_vector(p));
    scan->points.push_back(centre + scan->right.back());
  }
  scan->tree = kd_tree::build<3, double>(scan->points);
  return scan;
}

using Find = std::function<Normal<double>(const Scan&, Index)>;

/// The sine of the angle to the right one; another side than the eye's is a wrong decision.
Error of_normals(const Scan& scan, const Find& find) {
  Error::Sum sum;
  const std::size_t step = std::max<std::size_t>(1, scan.points.size() / 500);
  for (std::size_t i = 0; i < scan.points.size(); i += step) {
    const auto n = find(scan, static_cast<Index>(i));
    sum.add(length_of(glm::cross(n.way, scan.right[i])));
    if (!(glm::dot(n.way, eye - scan.points[i]) >= 0)) sum.wrong_decision();
  }
  return sum.error();
}

/// By the distances of all points.
Normal<double> by_brute_force(const Scan& scan, Index i, std::size_t k) {
  const dvec3 p = scan.points[i];
  const auto D = offsets(scan.tree, kd_tree::brute_force<3, double>(scan.points, p, k), p);
  const auto [variance, ways, shape] = axes(covariance(D, mean(D)));
  return {shape, glm::dot(ways[0], eye - p) < 0 ? -ways[0] : ways[0], variance};
}

Case case_of(const char* method, Standing standing, const std::shared_ptr<const Scan>& scan, std::size_t k,
             const Find& find) {
  const auto next = std::make_shared<std::size_t>(0);
  const std::size_t count = scan->points.size();
  const bool of_series = k == 10;
  return {.method = method,
          .standing = standing,
          .workload = {of_series ? fmt::format("{} points", count)
                                 : fmt::format("{} points, {} neighbours", count, k),
                       of_series ? static_cast<double>(count) : 0},
          .run = [scan, find, next] { find(*scan, static_cast<Index>(++* next %= scan->points.size())); },
          .error = of_normals(*scan, find)};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  const auto add = [&](const auto& scan, std::size_t k) {
    all.push_back(case_of("normal", Standing::taught, scan, k,
                          [k](const Scan& s, Index i) { return normal(s.tree, i, k, eye); }));
    all.push_back(case_of("brute_force", Standing::robust, scan, k,
                          [k](const Scan& s, Index i) { return by_brute_force(s, i, k); }));
    all.push_back(case_of("uncentred", Standing::faulty, scan, k,
                          [k](const Scan& s, Index i) { return uncentred(s.tree, i, k, eye); }));
    all.push_back(case_of("unturned", Standing::faulty, scan, k,
                          [k](const Scan& s, Index i) { return unturned(s.tree, i, k, eye); }));
  };
  for (const std::size_t count : {100u, 1'000u, 10'000u, 100'000u}) {
    const auto scan = scan_of(count);
    add(scan, 10);
    if (count != 10'000) continue;
    for (const std::size_t k : {5u, 30u}) add(scan, k);
  }
  return all;
}

}  // namespace

Subject point_cloud() {
  return {.topic = "point_cloud",
          .title = "Normals of points on a ball, from ten neighbours",
          .item = "normal",
          .unit = "sine of the angle",
          .measure = "points",
          .telling = "10000 points",
          .cases = cases,
          .choice = {"normal", "the same normals as by brute force, without the distances of all points"}};
}

}  // namespace gradus::bench
