// The promises of trees over points: searches find what brute force finds, whatever is equal or rounds to
// equal distances, and nothing that is farther away than roundings allow.

#include "modeling/kd_tree/kd_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "modeling/kd_tree/kd_tree_batch.hpp"
#include "stress/exactly.hpp"
#include "stress/scales.hpp"

namespace gradus::stress {
namespace {

using namespace kd_tree;

/// More than a bucket of the batch takes.
constexpr std::size_t points = 12;
template <int N>
constexpr std::size_t coordinates = N * (points + 1);

/// The coordinates of the points and of q, then k.
template <int N>
Input shape(Kind kind, Random& random) {
  Input input = numbers_of(kind, random, coordinates<N> + 1);
  const auto any = [&] { return static_cast<std::size_t>(random.uniform_int(0, points - 1)); };
  if (kind == Kind::near_degenerate) {
    // Some points in a few places, and others in one plane, but for the last places
    for (std::size_t i = 0; i < points; ++i) {
      const std::size_t like = any();
      for (std::size_t axis = 0; axis < N; ++axis) {
        double& x = input[N * i + axis];
        if (i % 3 == 0) x = input[N * like + axis];
        if (i % 3 == 1 && axis == 0) x = nudged(input[0], random);
      }
    }
  } else if (kind == Kind::grazing) {
    // On spheres and cubes round q, but for the last places: distances that are nearly or just equal
    for (std::size_t i = 1; i < points; ++i) {
      const std::size_t turn = static_cast<std::size_t>(random.uniform_int(0, N - 1));
      for (std::size_t axis = 0; axis < N; ++axis) {
        const double q = input[N * points + axis],
                     off = input[(axis + turn) % N] - input[N * points + (axis + turn) % N];
        const double x = q + (random.unit() < 0.5 ? off : -off);
        input[N * i + axis] = random.unit() < 0.5 ? x : nudged(x, random);
      }
    }
  }
  input.back() = static_cast<double>(random.uniform_int(1, points + 1));
  return input;
}
template <int N>
Generator generate() {
  std::vector<std::size_t> lengths(coordinates<N>);
  std::iota(lengths.begin(), lengths.end(), std::size_t{0});
  return at_every_scale(shape<N>, lengths);
}

template <int N, class T>
struct Given {
  std::vector<Point<N, T>> cloud;
  Point<N, T> q;
  std::size_t k;
  bool taken;  ///< whether it lies in the domain

  explicit Given(const std::vector<T>& numbers) : cloud(points) {
    taken = std::ranges::all_of(numbers, [](T x) { return std::abs(x) <= most_coordinate<T>; });
    for (std::size_t i = 0; i < coordinates<N>; ++i) {
      auto& place = i < N * points ? cloud[i / N] : q;
      place[static_cast<int>(i % N)] = numbers[i];
    }
    const double wanted = static_cast<double>(numbers.back());
    k = static_cast<std::size_t>(wanted >= 1 && wanted < 99 ? wanted : 1);
  }
};

/// What was found against the sorted distances of all, which share nothing with a search but their rounding.
template <int N, class T>
double found_error(const std::vector<T>& numbers) {
  if (!std::isfinite(numbers.back())) return 0;
  const Given<N, T> given(numbers);
  const auto& [cloud, q, k, taken] = given;
  const auto found = accepted([&] { return nearest<N, T>(build<N, T>(cloud), q, k); });
  const auto fast = accepted([&] {
    Neighbours<T> room(std::min(k, points));
    Buckets<N, T>(cloud).nearest(q, room);
    return room;
  });
  if (found.has_value() != taken || fast.has_value() != taken) return wrong;
  if (!taken) return 0;
  Neighbours<T> all;
  for (std::size_t i = 0; i < points; ++i) {
    const Point<N, T> off = cloud[i] - q;
    T sum = unfused(off[0] * off[0]);
    for (int axis = 1; axis < N; ++axis) sum += unfused(off[axis] * off[axis]);
    all.push_back({sum, static_cast<Index>(i)});
  }
  std::ranges::sort(all, std::less<>{});
  all.resize(std::min(k, points));
  return *found == all && *fast == all && brute_force<N, T>(cloud, q, k) == all ? 0 : wrong;
}

/// The exact square of each that was found, beside that of the same rank: what it is farther by, in parts of
/// 11 u of it and of three of the smallest subnormal numbers.
template <class T>
double near_error(const std::vector<T>& numbers) {
  if (!all_finite(numbers)) return 0;
  const Given<3, T> given(numbers);
  if (!given.taken) return 0;
  std::vector<Exact> squares;
  for (const auto& p : given.cloud) {
    Exact sum(0);
    for (int axis = 0; axis < 3; ++axis) {
      const Exact off = Exact(p[axis]) - Exact(given.q[axis]);
      sum = sum + off * off;
    }
    squares.push_back(sum);
  }
  std::vector<Exact> sorted = squares;
  std::ranges::sort(sorted);
  const auto found = nearest<3, T>(build<3, T>(given.cloud), given.q, given.k);
  const Exact u(std::numeric_limits<T>::epsilon() / 2), least(std::numeric_limits<T>::denorm_min());
  double most = 0;
  for (std::size_t rank = 0; rank < found.size(); ++rank) {
    const Exact bound = Exact(11) * u * sorted[rank] + Exact(3) * least;
    most = std::max(most, in_bounds(squares[found[rank].point] - sorted[rank], bound));
  }
  return most;
}

/// What the figures take: small enough to be drawn.
std::vector<std::pair<std::string, std::string>> figure_of(const Input& i) {
  std::string cloud;
  for (std::size_t k = 0; k < 2 * points; k += 2) {
    for (const double x : {i[k], i[k + 1]}) {
      if (x != 0 && !(1e-3 <= std::abs(x) && std::abs(x) <= 1e4)) return {};
    }
    cloud += fmt::format("{}{},{}", k > 0 ? " " : "", i[k], i[k + 1]);
  }
  for (const double x : {i[2 * points], i[2 * points + 1]}) {
    if (x != 0 && !(1e-3 <= std::abs(x) && std::abs(x) <= 1e4)) return {};
  }
  if (!(1 <= i.back() && i.back() <= 8)) return {};
  return {{"points", cloud},
          {"query", fmt::format("{},{}", i[2 * points], i[2 * points + 1])},
          {"k", fmt::format("{}", static_cast<int>(i.back()))}};
}

/// A cloud of one value, q of another.
template <int N>
Input all_at(double cloud, double q, double k) {
  Input input(coordinates<N> + 1, cloud);
  std::fill(input.end() - N - 1, input.end() - 1, q);
  input.back() = k;
  return input;
}

}  // namespace

Domain kd_tree() {
  const auto with = [](Input input, std::size_t i, double x) {
    input[i] = x;
    return input;
  };
  return {
      "kd_tree",
      {{.name = "plane",
        .states = "in the plane both searches find what sorting all rounded distances finds, ties by index",
        .unit = "decisions",
        .bound = 0,
        .numbers = coordinates<2> + 1,
        .generate = generate<2>(),
        .error = in_both([](const auto& numbers) { return found_error<2>(numbers); }),
        .arguments = figure_of,
        .traps = {{"all points one", all_at<2>(1, 1, 5)},
                  {"all points one, elsewhere", all_at<2>(1, -3, 12)},
                  {"the largest numbers", all_at<2>(0x1p509, -0x1p509, 3)},
                  {"beyond them", all_at<2>(0x1p510, 0, 1)},
                  {"the smallest numbers", with(all_at<2>(5e-324, 0, 3), 4, 1e-323)},
                  {"a point that is no number", with(all_at<2>(1, 0, 1), 7, std::nan(""))},
                  {"as near, as rounded", with(all_at<2>(1, 0, 12), 9, 1 + 0x1p-52)}}},
       {.name = "space",
        .states = "in space both searches find what sorting all rounded distances finds, ties by index",
        .unit = "decisions",
        .bound = 0,
        .numbers = coordinates<3> + 1,
        .generate = generate<3>(),
        .error = in_both([](const auto& numbers) { return found_error<3>(numbers); }),
        .traps = {{"all points one", all_at<3>(1, 1, 5)},
                  {"the largest numbers", all_at<3>(0x1p509, -0x1p509, 13)}}},
       {.name = "near",
        .states = "the square of each found is within 11 u of that of its rank, at every size",
        .unit = "of the bound",
        .bound = 1,
        .numbers = coordinates<3> + 1,
        .generate = generate<3>(),
        .error = in_both([](const auto& numbers) { return near_error(numbers); }),
        .cases = 1'000}}};
}

}  // namespace gradus::stress
