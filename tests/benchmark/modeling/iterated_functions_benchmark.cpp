// FILL IN: what is measured. Until then: walks of growing length.

#include "modeling/iterated_functions/iterated_functions.hpp"

#include <fmt/format.h>

#include <memory>

#include "benchmark/subject.hpp"

namespace gradus::bench {
namespace {

/// FILL IN: a case for each method and input, the same inputs for all; errors against an oracle.
std::vector<Case> cases() {
  std::vector<Case> all;
  for (const int length : {16, 256, 4096}) {
    const auto pixels = std::make_shared<std::vector<ivec2>>();
    const auto run = [pixels, length] {
      pixels->clear();
      const auto keep = [&](ivec2 p) { pixels->push_back(p); };
      iterated_functions::walk({0, 0}, {length, length}, keep);
    };
    run();
    Error::Sum sum;
    if (pixels->size() != 2 * static_cast<std::size_t>(length) + 1) sum.wrong_decision();
    all.push_back({.method = "walk",
                   .standing = Standing::taught,
                   .workload = {fmt::format("{} columns", length), static_cast<double>(length)},
                   .items = 2 * length + 1,
                   .run = run,
                   .error = sum.error()});
  }
  return all;
}

}  // namespace

Subject iterated_functions() {
  return {.topic = "iterated_functions",
          .title = "FILL IN: what is done",
          .item = "pixel",
          .unit = "pixels",
          .measure = "columns, and as many rows",
          .telling = "256 columns",
          .cases = cases,
          .choice = {"walk", "FILL IN: why a reader should take it"}};
}

}  // namespace gradus::bench
