// The promises of a topic, each kept: its traps, and seeded cases of each kind. Part of every program
// promises_T.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "stress/attack.hpp"
#include "support/seed.hpp"
#include "support/share.hpp"
#include "support/stress.hpp"

namespace gradus::stress {
namespace {

struct Promise {
  std::string topic;
  const Property* property;
};

/// What ctest calls it.
void PrintTo(const Promise& promise, std::ostream* out) { *out << promise.property->name; }

std::vector<Promise> promises() {
  std::vector<Promise> all;
  for (const Domain& domain : domains()) {
    for (const Property& property : domain.properties) all.push_back({domain.topic, &property});
  }
  return all;
}

/// A tenth in an ordinary run, but no fewer than shares can be told of.
std::int64_t least_cases(std::int64_t all) { return std::max(all / 10, std::min<std::int64_t>(all, 200)); }

/// Fewer than so many are fewer by chance, too: in an ordinary run by up to three standard deviations.
constexpr double few = 20;

class Promises : public ::testing::TestWithParam<Promise> {};

TEST_P(Promises, AreKept) {
  const auto& [topic, property] = GetParam();
  const std::int64_t ordinary = test::whole_run() ? property->cases : least_cases(property->cases);
  const auto wanted = static_cast<std::uint64_t>(test::cases(ordinary, 100 * property->cases));
  const Finding finding = attack(*property, test::seed(), [&](std::uint64_t i) { return i < wanted; });
  EXPECT_LE(finding.worst, property->bound)
      << finding.origin << ", GRADUS_SEED=" << test::seed() << ": gradus stress " << topic << " --replay '"
      << property->name << ":" << text_of(finding.input) << "'";
  if (finding.broken()) return;
  EXPECT_EQ(finding.cases, wanted + property->traps.size());
  EXPECT_EQ(finding.by_kind.size(), property->kinds.size());
  for (std::size_t i = 0; i < property->shares.size(); ++i) {
    double least = property->shares[i].least * static_cast<double>(wanted);
    if (least < few && !test::whole_run()) least -= 3 * std::sqrt(least);
    EXPECT_GE(static_cast<double>(finding.by_share[i]), least) << property->shares[i].of;
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Promises, ::testing::ValuesIn(promises()),
                         [](const auto& of) { return of.param.property->name; });

}  // namespace
}  // namespace gradus::stress
