// Points of the fern: how far its parts are from the nearest one, and what that takes by pieces and by a
// game.

#include "modeling/iterated_functions/iterated_functions.hpp"

#include <fmt/format.h>

#include <limits>
#include <memory>

#include "benchmark/subject.hpp"

namespace gradus::bench {
namespace {

using namespace iterated_functions;
using Points = std::vector<dvec2>;

Points by_pieces(int level) {
  Points points;
  for (const DMap& p : deterministic(Maps<double>(fern), level)) points.push_back({p.e, p.f});
  return points;
}

Points by_game(int level) {
  static const std::vector<double> shares = shares_by_area(Maps<double>(fern));
  Points points;
  const Game<double> game{{0, 0}, 0, Whole{1} << 2 * level, 1};
  chaos_game(Maps<double>(fern), shares, game, [&](dvec2 p) { points.push_back(p); });
  return points;
}

/// How far points of the fern lie from the nearest one that was drawn, in thousandths of its height.
Error off_the_fern(const Points& drawn) {
  constexpr Whole asked = 500;
  constexpr std::uint64_t other_seed = 99;
  Error::Sum sum;
  chaos_game(Maps<double>(fern), shares_by_area(Maps<double>(fern)),
             Game<double>{{0, 0}, 0, asked, other_seed}, [&](dvec2 p) {
               double least = std::numeric_limits<double>::max();
               for (const dvec2 q : drawn) least = std::min(least, length_of(p - q));
               sum.add(1000 * least);
             });
  return sum.error();
}

Case case_of(const char* method, Standing standing, int level, Points (*make)(int)) {
  const auto points = std::make_shared<Points>(make(level));
  const Whole count = Whole{1} << 2 * level;
  return {.method = method,
          .standing = standing,
          .workload = {fmt::format("{} points", count), static_cast<double>(count)},
          .items = count,
          .run = [points, make, level] { *points = make(level); },
          .error = off_the_fern(*points)};
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int level : {3, 4, 5, 6}) {
    all.push_back(case_of("deterministic", Standing::taught, level, by_pieces));
    all.push_back(case_of("chaos_game", Standing::robust, level, by_game));
  }
  return all;
}

}  // namespace

Subject iterated_functions() {
  return {.topic = "iterated_functions",
          .title = "Points of Barnsley's fern",
          .item = "point",
          .unit = "1/1000 of its height",
          .measure = "points",
          .telling = "4096 points",
          .cases = cases,
          .refined = true,
          .choice = {"chaos_game", "its points lie where the figure is large"}};
}

}  // namespace gradus::bench
