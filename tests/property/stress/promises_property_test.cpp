// Every promise that gradus stress attacks, attacked here as well: its traps, and some seeded cases of each
// kind.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "stress/attack.hpp"
#include "support/seed.hpp"
#include "support/stress.hpp"

namespace gradus::stress {
namespace {

struct Promise {
  std::string topic;
  const Property* property;
};

std::vector<Promise> promises() {
  std::vector<Promise> all;
  for (const Domain& domain : domains()) {
    for (const Property& property : domain.properties) all.push_back({domain.topic, &property});
  }
  return all;
}

class Promises : public ::testing::TestWithParam<Promise> {};

TEST_P(Promises, AreKept) {
  const auto& [topic, property] = GetParam();
  const auto wanted = static_cast<std::uint64_t>(test::cases(450, 45'000));
  const Finding finding = attack(*property, test::seed(), [&](std::uint64_t i) { return i < wanted; });
  EXPECT_LE(finding.worst, property->bound)
      << finding.origin << ", GRADUS_SEED=" << test::seed() << ": gradus stress " << topic << " --replay '"
      << property->name << ":" << text_of(finding.input) << "'";
  if (finding.broken()) return;
  EXPECT_EQ(finding.cases, wanted + property->traps.size());
  EXPECT_EQ(finding.by_kind.size(), property->kinds.size());
}

INSTANTIATE_TEST_SUITE_P(Of, Promises, ::testing::ValuesIn(promises()),
                         [](const auto& of) { return of.param.topic + "_" + of.param.property->name; });

}  // namespace
}  // namespace gradus::stress
