// A scalar that counts: each kind of operation, through GLM, and nothing else.

#include "core/arithmetic/counted.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <thread>

namespace gradus {
namespace {

using Vec = glm::vec<3, Counted>;

TEST(Counted, TellsAdditionsProductsAndDivisionsApart) {
  Counted a = 3;
  const Operations operations = operations_of([&] {
    a += 1;      // 4
    a = a - 2;   // 2
    a *= a;      // 4
    a /= 8;      // 0.5
    a = -a * a;  // -0.25
  });
  EXPECT_EQ(operations, (Operations{2, 2, 1}));
  EXPECT_EQ(operations.all(), 5);
  EXPECT_EQ(a.value(), -0.25);
}

TEST(Counted, CountsNoComparisonAndNoCopy) {
  const Counted a = 1, b = 2;
  bool less = false;
  EXPECT_EQ(operations_of([&] {
              const Counted copy = a;
              less = copy < b && !(copy == b) && copy > Counted{};
            }),
            Operations{});
  EXPECT_TRUE(less);
}

TEST(Counted, CountsWhatGlmCalculates) {
  const Vec a{1, 2, 3}, b{4, 5, 6};
  EXPECT_EQ(operations_of([&] { EXPECT_EQ(glm::dot(a, b).value(), 32); }), (Operations{2, 3, 0}));
  EXPECT_EQ(operations_of([&] { EXPECT_EQ(glm::cross(a, b).y.value(), 6); }), (Operations{3, 6, 0}));
}

TEST(Counted, IsOfItsThread) {
  const Counted a = 1;
  EXPECT_EQ(operations_of([&] { std::thread([&] { static_cast<void>(a + a); }).join(); }), Operations{});
}

}  // namespace
}  // namespace gradus
