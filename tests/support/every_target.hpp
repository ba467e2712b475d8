#pragma once
// Batches on every kind of machine that this one can be.

#include <hwy/targets.h>

#include <cstdint>

namespace gradus::test {

/// Runs a test once for each. Returns for how many.
template <class Test>
int on_every_target(Test test) {
  int targets = 0;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    test();
    ++targets;
  }
  hwy::SetSupportedTargetsForTest(0);
  return targets;
}

}  // namespace gradus::test
