#pragma once
// Methods that make some numbers of each of many inputs, compared with the same numbers in 100 digits: what
// the benchmarks of transformations and projections share.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "benchmark/subject.hpp"
#include "core/random.hpp"

namespace gradus::bench::answers {

using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<340, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

inline std::array<double, 2> numbers_of(const glm::dvec2& v) { return {v.x, v.y}; }
inline std::array<double, 3> numbers_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
inline std::array<double, 9> numbers_of(const glm::dmat3& m) {
  return {m[0].x, m[0].y, m[0].z, m[1].x, m[1].y, m[1].z, m[2].x, m[2].y, m[2].z};
}

/// Inputs, and what is right of each.
template <class In, std::size_t n>
struct Set {
  std::vector<In> inputs;
  std::vector<std::array<Wide, n>> right;
};

/// So many inputs of a workload, made once: `make(random)` gives one, `right_of(input)` what is right of it.
template <class In, std::size_t n, class Key, class Make, class Right>
const Set<In, n>& made_once(const Key& key, std::size_t count, Make make, Right right_of) {
  static std::map<std::pair<Key, std::size_t>, Set<In, n>> made;
  const auto [place, added] = made.try_emplace({key, count});
  Set<In, n>& set = place->second;
  if (!added) return set;
  Random random(1);
  for (std::size_t i = 0; i < count; ++i) {
    set.inputs.push_back(make(random));
    set.right.push_back(right_of(set.inputs.back()));
  }
  return set;
}

/// The worst of each answer's numbers, in the last place of its largest one, but not of one below 1.
template <class Out, std::size_t n>
Error error_of(const std::vector<Out>& found, const std::vector<std::array<Wide, n>>& right) {
  Error::Sum sum;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::array<double, n> numbers = numbers_of(found[i]);
    double size = 1, off = 0;
    for (const Wide& x : right[i]) size = std::max(size, std::abs(x.template convert_to<double>()));
    for (std::size_t k = 0; k < n; ++k) {
      const Wide miss = Wide(numbers[k]) - right[i][k];
      off = std::max(off, std::abs(miss.template convert_to<double>()));
    }
    sum.add(off / (std::nextafter(size, 1e300) - size));
  }
  return sum.error();
}

/// A method that takes all inputs: `all(inputs, outputs)`.
template <class Out, class In, std::size_t n, class All>
Case case_of(std::string name, Standing standing, const Set<In, n>& set, All all, Workload workload) {
  const auto found = std::make_shared<std::vector<Out>>(set.inputs.size());
  all(set.inputs, *found);
  return {.method = std::move(name),
          .standing = standing,
          .workload = std::move(workload),
          .items = static_cast<std::int64_t>(set.inputs.size()),
          .run = [all, found, &set] { all(set.inputs, *found); },
          .error = error_of(*found, set.right)};
}

/// A method that takes one input after the other.
template <class One>
auto each(One one) {
  return [one](const auto& inputs, auto& outputs) {
    for (std::size_t i = 0; i < inputs.size(); ++i) outputs[i] = one(inputs[i]);
  };
}

}  // namespace gradus::bench::answers
