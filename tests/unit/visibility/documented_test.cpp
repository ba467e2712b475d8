// The numbers that the pages of visibility claim, measured again.

#include <gtest/gtest.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/geometry.hpp"
#include "core/random.hpp"
#include "support/documented.hpp"
#include "support/fraction.hpp"
#include "visibility/z_buffer/z_buffer.hpp"

namespace gradus {
namespace {

TEST(DocumentedVisibility, SliversThatTheDivisionTurnsRound) {
  // Triangles of (x, y, w) in whose planes the eye lies but for the last places; sides by fractions
  using test::Fraction;
  Random random(20240611);
  int turned = 0;
  for (int i = 0; i < 1024; ++i) {
    const auto corner = [&] {
      return dvec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(1, 4)};
    };
    const dvec3 a = corner(), b = corner();
    const double s = random.uniform(0.2, 1), t = random.uniform(0.2, 1);
    dvec3 c = s * a + t * b;
    for (int k = 0; k < 3; ++k) c[k] *= 1 + static_cast<double>(random.uniform_int(-3, 3)) * 0x1p-52;
    const auto of = [](double x) { return Fraction(x); };
    const Fraction det = of(a.x) * (of(b.y) * of(c.z) - of(b.z) * of(c.y)) -
                         of(a.y) * (of(b.x) * of(c.z) - of(b.z) * of(c.x)) +
                         of(a.z) * (of(b.x) * of(c.y) - of(b.y) * of(c.x));
    // The same of the rounded places, exactly: the division alone is to blame
    const dvec2 p = dvec2(a) / a.z, q = dvec2(b) / b.z, r = dvec2(c) / c.z;
    const Fraction area =
        (of(q.x) - of(p.x)) * (of(r.y) - of(p.y)) - (of(r.x) - of(p.x)) * (of(q.y) - of(p.y));
    turned += det.sign() != area.sign();
  }
  EXPECT_TRUE(test::states("docs/topics/visibility/back_face_culling.md",
                           "of 1024 slivers the division by w turns {} round", {double(turned)}));
}

TEST(DocumentedVisibility, DepthsThatFloatsTellApart) {
  // Floats below 1 are 2^-24 apart, nearer 0 less: what is farther apart than that is told apart
  const z_buffer::AsFloat stored{{0, 1}};
  constexpr double apart = 0x1p-24;
  Random random(20240611);
  int alike = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double z = random.uniform(0, 1 - 2 * apart);
    EXPECT_LT(stored(z), stored(z + 1.001 * apart)) << z;
    alike += stored(z) == stored(z + 0.5 * apart);
  }
  EXPECT_GT(alike, 1000);
}

}  // namespace
}  // namespace gradus
