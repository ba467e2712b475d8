// Stepping back is the same as never having stepped on: for every topic and method, over random walks.

#include <gtest/gtest.h>

#include <random>

#include "support/example_traces.hpp"
#include "support/seed.hpp"

namespace gradus {
namespace {

using test::seed;

TEST(PlayheadProperty, AnyWalkEndsWhereAFreshRunEnds) {
  const std::uint64_t start = seed();
  SCOPED_TRACE("GRADUS_SEED=" + std::to_string(start));
  RecordProperty("seed", std::to_string(start));
  std::mt19937_64 random(start);
  std::size_t walks = 0, backward = 0;
  for (const Trace& trace : test::telling_traces()) {
    // The oracle: every state by applying all deltas from the start
    std::vector<Canvas> states;
    Canvas canvas = trace.before;
    const std::size_t count = std::min<std::size_t>(trace.steps.size(), 300);
    for (std::size_t i = 0; i < count; ++i) {
      canvas.apply(trace.steps[i].delta);
      if (trace.grid.cells.width() > 100 && i % 7 != 0) {
        states.emplace_back();  // large pictures: every seventh state is kept
      } else {
        states.push_back(canvas);
      }
    }
    Playhead playhead(trace);
    std::size_t at = 0;
    for (int i = 0; i < 120; ++i) {
      const std::size_t next = random() % 3 == 0 ? random() % count
                               : random() % 2    ? std::min(at + 1, count - 1)
                                                 : at - std::min<std::size_t>(at, 1);
      if (next < at) ++backward;
      at = next;
      const Canvas& here = playhead.at(at);
      if (trace.grid.cells.width() > 100 && at % 7 != 0) continue;
      ASSERT_EQ(here, states[at]) << trace.topic << " " << trace.method << " index " << at;
      ++walks;
    }
  }
  EXPECT_GT(walks, 1500u);
  EXPECT_GT(backward, 500u);
}

TEST(PlayheadProperty, DenseAndSparseCanvasesAgree) {
  const std::uint64_t start = seed();
  SCOPED_TRACE("GRADUS_SEED=" + std::to_string(start));
  std::mt19937_64 random(start);
  Canvas dense(Window{{-20, -20}, {20, 20}}), sparse(Window{{INT32_MIN, INT32_MIN}, {INT32_MAX, INT32_MAX}});
  const auto cell = [&] { return ivec2{int(random() % 41) - 20, int(random() % 41) - 20}; };
  for (int i = 0; i < 5000; ++i) {
    Delta delta;
    const ivec2 p = cell();
    if (random() % 4 == 0) {
      delta.cells.push_back({p, std::nullopt});
    } else {
      delta.cells.push_back({p, CellLook{all_roles[random() % all_roles.size()], random() % 3 ? "" : "7"}});
    }
    dense.apply(delta);
    sparse.apply(delta);
    const ivec2 asked = cell();
    ASSERT_EQ(dense.at(asked), sparse.at(asked));
  }
}

}  // namespace
}  // namespace gradus
