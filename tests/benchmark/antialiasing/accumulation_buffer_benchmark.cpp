// Straight edges across pixels with 1, 4, 16, 64 and 256 passes, as doubles, floats and the notes' bytes; the
// error is that of the covered share against the exact area.

#include "antialiasing/accumulation_buffer/accumulation_buffer.hpp"

#include <fmt/format.h>

#include <memory>

#include "antialiasing/accumulation_buffer/accumulation_buffer_notes.hpp"
#include "benchmark/subject.hpp"
#include "support/random_edges.hpp"

namespace gradus::bench {
namespace {

using namespace accumulation_buffer;

/// A picture whose every pixel an edge of its own crosses.
constexpr ivec2 size{128, 64};
constexpr std::size_t pixels = 128 * 64;

struct Edges {
  std::vector<test::StraightEdge> all;

  Edges() {
    Random random(8);
    for (std::size_t k = 0; k < pixels; ++k) all.push_back(test::random_edge(random));
  }
  template <class Value, class Plot>
  void draw(dvec2 place, Value inside, const Plot& plot) const {
    std::size_t k = 0;
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x) plot({x, y}, all[k++].holds(place) ? inside : Value(0));
    }
  }
};

/// run(sums) fills a picture of means, in which `white` is full coverage.
template <class Value, class Run>
Case case_of(int side, const std::shared_ptr<Edges>& edges, const char* method, Standing standing,
             double white, Run accumulate_into) {
  const auto sums = std::make_shared<std::vector<Value>>(pixels);
  const auto run = [=] { accumulate_into(*edges, *sums); };
  run();
  Error::Sum sum;
  for (std::size_t k = 0; k < pixels; ++k)
    sum.add(std::abs(static_cast<double>((*sums)[k]) / white - edges->all[k].area()));
  return {.method = method,
          .standing = standing,
          .workload = {side == 1 ? "1 pass" : fmt::format("{} passes", side * side),
                       static_cast<double>(side * side)},
          .items = static_cast<std::int64_t>(pixels),
          .run = run,
          .error = sum.error()};
}

template <class Value>
Case wide_case(int side, const std::shared_ptr<Edges>& edges, const char* method, Standing standing) {
  return case_of<Value>(side, edges, method, standing, 1, [side](const Edges& all, std::vector<Value>& sums) {
    const auto render = [&](dvec2 place, const Sums<Value>& plot) { all.draw(place, Value(1), plot); };
    accumulate({side, side}, render, Sums<Value>(sums, size));
  });
}

std::vector<Case> cases() {
  const auto edges = std::make_shared<Edges>();
  std::vector<Case> all;
  for (const int side : {1, 2, 4, 8, 16}) {
    all.push_back(wide_case<double>(side, edges, "accumulate", Standing::taught));
    all.push_back(wide_case<float>(side, edges, "accumulate in float", Standing::robust));
    all.push_back(case_of<std::uint8_t>(side, edges, "eight_bits", Standing::faulty, 200,
                                        [side](const Edges& scene, std::vector<std::uint8_t>& sums) {
                                          const auto render = [&](dvec2 place, const ByteSums& plot) {
                                            scene.draw(place, 200, plot);
                                          };
                                          eight_bits({side, side}, render, ByteSums{sums, size});
                                        }));
  }
  return all;
}

}  // namespace

Subject accumulation_buffer() {
  return {.topic = "accumulation_buffer",
          .title = "Edges in the accumulation buffer",
          .item = "pixel",
          .unit = "parts of a pixel",
          .measure = "passes",
          .telling = "16 passes",
          .cases = cases,
          .refined = true,
          .choice = {"accumulate", "off by what its passes are, however many there are"}};
}

}  // namespace gradus::bench
