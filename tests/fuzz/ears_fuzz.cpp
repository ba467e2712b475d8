// Cutting ears: any polygon gives its triangles, and a simple one is covered once, by exact areas.

#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <span>
#include <vector>

#include "clipping/polygon_circle/crossings.hpp"
#include "modeling/ear_clipping/ear_clipping.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using gradus::test::require;
using Rational = boost::multiprecision::cpp_rational;

namespace {

Rational doubled_area(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  const Rational ax(a.x), ay(a.y);
  return (Rational(b.x) - ax) * (Rational(c.y) - ay) - (Rational(b.y) - ay) * (Rational(c.x) - ax);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  test::FuzzInput input(data, size);
  const int reach = input.coin() ? 5 : 400;
  std::vector<glm::dvec2> polygon(static_cast<std::size_t>(3 + input.below(12)));
  for (glm::dvec2& p : polygon) p = input.point(-reach, reach);
  Rational whole = 0, sum = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    whole += doubled_area(polygon[0], polygon[i - 1], polygon[i]);
  const bool simple = !polygon_circle::meeting_edges(polygon);
  std::size_t count = 0;
  bool turned = false;
  ear_clipping::triangulate(std::span<const glm::dvec2>(polygon), [&](const ear_clipping::Triangle& t) {
    for (const int corner : t)
      require(0 <= corner && corner < static_cast<int>(polygon.size()), "corners exist");
    const auto at = [&](std::size_t i) { return polygon[static_cast<std::size_t>(t[i])]; };
    const Rational area = doubled_area(at(0), at(1), at(2));
    turned = turned || area < 0;
    sum += area;
    ++count;
  });
  require(count == polygon.size() - 2, "n corners make n - 2 triangles");
  require(sum == whole, "the areas add up");
  if (simple && whole > 0) require(!turned, "a simple polygon is covered once");
  return 0;
}
