// The buffer against one pass with as many samples, known blurs of time and lens, the step grammar, refusals.

#include "antialiasing/accumulation_buffer/accumulation_buffer.hpp"

#include <gtest/gtest.h>

#include <climits>
#include <cmath>
#include <set>
#include <vector>

#include "antialiasing/accumulation_buffer/accumulation_buffer_notes.hpp"
#include "core/arithmetic/exact_scalar.hpp"
#include "core/random.hpp"
#include "core/record.hpp"

namespace gradus::accumulation_buffer {
namespace {

constexpr ivec2 size{5, 4};

/// A picture that no sum of which is exact: tilted bands in thirds.
double colour(dvec2 place) { return std::floor(1.7 * place.x + 0.9 * place.y) / 3; }

/// Draws a picture by the colour at one place of every pixel.
template <class Colour>
auto renderer(ivec2 picture, Colour its_colour) {
  return [=](dvec2 place, const auto& plot) {
    for (int y = 0; y < picture.y; ++y) {
      for (int x = 0; x < picture.x; ++x) plot({x, y}, its_colour(dvec2(x, y) + place));
    }
  };
}

template <class Value>
std::vector<Value> accumulated(ivec2 grid) {
  std::vector<Value> values(20);
  accumulate(grid, renderer(size, [](dvec2 p) { return static_cast<Value>(colour(p)); }),
             Sums<Value>(values, size));
  return values;
}

/// Pixel by pixel: all its samples, then the next. Shares no code with accumulate.
template <class Value>
std::vector<Value> supersampled(ivec2 grid) {
  std::vector<Value> values;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      Value sum = 0;
      for (int j = 0; j < grid.y; ++j) {
        for (int i = 0; i < grid.x; ++i) {
          const dvec2 place{(i + 0.5) / grid.x, (j + 0.5) / grid.y};
          sum += static_cast<Value>(colour(dvec2(x, y) + place));
        }
      }
      values.push_back(sum / static_cast<Value>(grid.x * grid.y));
    }
  }
  return values;
}

TEST(AccumulationBuffer, EqualsOnePassOfAsManySamplesBitForBit) {
  // R001-162
  int pictures = 0;
  for (const int a : {1, 2, 3, 4, 7, 16}) {
    for (const int b : {1, 2, 3, 5, 16}) {
      EXPECT_EQ(accumulated<double>({a, b}), supersampled<double>({a, b})) << a << " x " << b;
      EXPECT_EQ(accumulated<float>({a, b}), supersampled<float>({a, b})) << a << " x " << b;
      ++pictures;
    }
  }
  EXPECT_EQ(pictures, 30);
  EXPECT_NE(accumulated<double>({4, 4}), accumulated<double>({1, 1}));
}

TEST(AccumulationBuffer, FourPassesOf200Are200) {
  // G001-112, what it should be
  std::vector<double> sum(1);
  accumulate({2, 2}, renderer({1, 1}, [](dvec2) { return 200.0; }), Sums<double>(sum, {1, 1}));
  EXPECT_EQ(sum[0], 200);
}

TEST(AccumulationBuffer, ColoursAreSummedPartByPart) {
  std::vector<dvec3> sums(1);
  const auto colours = [](dvec2 p) { return p.x < 0.5 ? dvec3{1, 0, 0.5} : dvec3{0, 0.25, 0.5}; };
  accumulate({4, 1}, renderer({1, 1}, colours), Sums<dvec3>(sums, {1, 1}));
  EXPECT_EQ(sums[0], (dvec3{0.5, 0.125, 0.5}));
}

TEST(AccumulationBuffer, RationalsAreAddedWithoutError) {
  const ExactScope scope;
  std::vector<Exact> sums(1, Exact(7));
  int k = 0;
  const auto render = [&](double, const Sums<Exact>& plot) { plot({0, 0}, Exact(1, ++k)); };
  motion_blur(4, {0, 1}, render, Sums<Exact>(sums, {1, 1}));
  EXPECT_TRUE(sums[0] == Exact(25, 48));  // a quarter of 1 + 1/2 + 1/3 + 1/4
}

TEST(AccumulationBuffer, WhatNoPassDrawsIs0) {
  std::vector<double> sums{9, 9};
  const auto left_only = [](dvec2, const Sums<double>& plot) { plot({0, 0}, 1); };
  accumulate({3, 3}, left_only, Sums<double>(sums, {2, 1}));
  EXPECT_EQ(sums, (std::vector<double>{1, 0}));
  std::vector<double> none;
  accumulate({3, 3}, [](dvec2, const auto&) {}, Sums<double>(none, {0, 0}));
}

TEST(AccumulationBuffer, PlacesAreTheMiddlesOfEqualParts) {
  EXPECT_EQ(place_of(0, 0, {1, 1}), (dvec2{0.5, 0.5}));
  EXPECT_EQ(place_of(3, 1, {4, 2}), (dvec2{0.875, 0.75}));
  EXPECT_EQ(middle(1, 3), 0.5);
  for (const int n : {1, 2, 3, 10, 49, 1 << 20}) {
    EXPECT_GT(middle(0, n), 0);
    EXPECT_LT(middle(n - 1, n), 1);
    // Rounded once: (2k + 1) / 2n times 2n is 2k + 1 but for half an ulp
    for (int k = 0; k < n; k += 1 + n / 100) {
      const ExactScope scope;
      const Exact off = Exact(middle(k, n)) - Exact(2 * k + 1, 2 * n);
      EXPECT_LE(std::abs(to_double(off)), 0x1p-53 * middle(k, n));
    }
  }
}

// --- Time

/// How much of a bar from x to x + 3, which moves with this speed, the centres of a row show at a moment.
std::vector<double> blurred_bar(int passes, const Shutter& shutter, double speed) {
  std::vector<double> row(32);
  const auto render = [&](double moment, const Sums<double>& plot) {
    const double left = 4 + speed * moment;
    for (int x = 0; x < 32; ++x) plot({x, 0}, left <= x + 0.5 && x + 0.5 < left + 3 ? 1 : 0);
  };
  motion_blur(passes, shutter, render, Sums<double>(row, {32, 1}));
  return row;
}

TEST(AccumulationBuffer, BlurIsAsLongAsSpeedTimesShutter) {
  // R001-163: an edge that moves 8 pixels becomes a ramp of 8 pixels, 1/8 per pixel
  std::vector<double> row(16);
  const auto edge = [](double moment, const Sums<double>& plot) {
    for (int x = 0; x < 16; ++x) plot({x, 0}, x + 0.5 < 4 + 16 * moment ? 1 : 0);
  };
  motion_blur(64, {0, 0.5}, edge, Sums<double>(row, {16, 1}));
  for (int x = 0; x < 16; ++x) {
    const double right = std::clamp((12 - (x + 0.5)) / 8, 0.0, 1.0);
    EXPECT_EQ(row[static_cast<std::size_t>(x)], right) << x;
  }
}

TEST(AccumulationBuffer, EveryPassStandsForItsPartOfTheWay) {
  // n places v length / n apart are v length together, without any rounding
  const ExactScope scope;
  int shutters = 0;
  for (const int n : {1, 2, 3, 7, 64}) {
    for (const Exact& speed : {Exact(12), Exact(-5, 3)}) {
      for (const Exact& length : {Exact(1, 2), Exact(1, 48), Exact(0)}) {
        const auto place = [&](int k) { return speed * length * Exact(2 * k + 1, 2 * n); };
        // Of the first and the last half a part sticks out
        const Exact part = speed * length / Exact(n);
        EXPECT_TRUE(place(n - 1) - place(0) + part == speed * length);
        ++shutters;
      }
    }
  }
  EXPECT_EQ(shutters, 30);
}

TEST(AccumulationBuffer, ABlurredBarKeepsItsLight) {
  for (const int passes : {1, 4, 16}) {
    double light = 0;
    for (const double value : blurred_bar(passes, {0, 1}, 8)) light += value;
    EXPECT_EQ(light, 3) << passes;
  }
  // A shutter that is open for no time sees one moment
  EXPECT_EQ(blurred_bar(16, {0.25, 0.25}, 8), blurred_bar(1, {0.25, 0.25}, 8));
}

TEST(AccumulationBuffer, MomentsAreTheMiddlesOfTheShuttersParts) {
  Recorder<Started, MomentAdded, Averaged> seen;
  double value = 0;
  motion_blur(4, {1, 3}, [](double, const auto&) {}, Sums<double>({&value, 1}, {1, 1}), seen);
  std::vector<double> moments;
  for (const MomentAdded& m : all<MomentAdded>(seen)) moments.push_back(m.moment);
  EXPECT_EQ(moments, (std::vector<double>{1.25, 1.75, 2.25, 2.75}));
}

// --- Lens

TEST(AccumulationBuffer, WhatIsInFocusStaysAtItsPlaceFromEveryEye) {
  // R001-163: with rationals, and bit for bit as doubles and floats
  Random random(1);
  int places = 0;
  for (int k = 0; k < 500; ++k) {
    const ExactScope scope;
    const double focus = random.uniform(0.1, 50);
    const dvec3 point{random.uniform(-9, 9), random.uniform(-9, 9), focus};
    const dvec2 eye{random.uniform(-2, 2), random.uniform(-2, 2)};
    EXPECT_EQ(seen(point, eye, focus), seen(point, dvec2{0, 0}, focus));
    const glm::vec3 near_point(point);
    EXPECT_EQ(seen(near_point, glm::vec2(eye), near_point.z), seen(near_point, glm::vec2(0), near_point.z));
    const Exact f(focus);
    const glm::vec<3, Exact> p{Exact(point.x), Exact(point.y), f};
    const auto q = seen(p, {Exact(eye.x), Exact(eye.y)}, f);
    EXPECT_TRUE(q.x == p.x / f && q.y == p.y / f);
    ++places;
  }
  EXPECT_EQ(places, 500);
}

TEST(AccumulationBuffer, TheRayOfEveryEyeMeetsThePointOnThePlaneOfFocus) {
  // Independent of the formula: the ray from the eye to the point, cut with the plane of focus, seen from the
  // middle of the lens
  Random random(2);
  for (int k = 0; k < 500; ++k) {
    const ExactScope scope;
    const auto number = [&](double least, double most) { return Exact(random.uniform(least, most)); };
    const Exact focus = number(1, 20), z = number(1, 20);
    const glm::vec<3, Exact> point{number(-5, 5), number(-5, 5), z};
    const glm::vec<2, Exact> eye{number(-1, 1), number(-1, 1)};
    const Exact t = focus / z;
    const Exact x = eye.x + t * (point.x - eye.x), y = eye.y + t * (point.y - eye.y);
    const auto found = seen(point, eye, focus);
    ASSERT_TRUE(found.x == x / focus && found.y == y / focus);
  }
}

TEST(AccumulationBuffer, CircleOfConfusionIsAsTheFormulaSays) {
  // aperture |z - f| / (z f), and as wide as the places of opposite eyes are apart
  Random random(3);
  for (int k = 0; k < 500; ++k) {
    const ExactScope scope;
    const Exact focus(random.uniform(1, 20)), z(random.uniform(1, 20)), radius(random.uniform(0, 1));
    const Exact off = z < focus ? focus - z : z - focus;
    const Exact width = circle_of_confusion(radius, focus, z);
    ASSERT_TRUE(width == Exact(2) * radius * off / (z * focus));
    const glm::vec<3, Exact> point{Exact(1), Exact(2), z};
    const Exact apart =
        seen(point, {radius, Exact(0)}, focus).x - seen(point, {Exact(0) - radius, Exact(0)}, focus).x;
    ASSERT_TRUE((apart < Exact(0) ? Exact(0) - apart : apart) == width);
  }
  EXPECT_EQ(circle_of_confusion(0.5, 4.0, 4.0), 0);
  EXPECT_EQ(circle_of_confusion(0.5, 4.0, 2.0), 0.25);
}

TEST(AccumulationBuffer, SquaresBecomeDiscsOfTheirArea) {
  // Rings of squares become circles; cells keep their share of the area: as many of a fine grid's places in
  // each quarter, half radius by half radius
  EXPECT_EQ(concentric({0, 0}), (dvec2{0, 0}));
  EXPECT_EQ(concentric({1, 0}), (dvec2{1, 0}));
  EXPECT_EQ(concentric({0, -1}), (dvec2{0, -1}));
  Random random(4);
  int inner = 0;
  for (int k = 0; k < 10'000; ++k) {
    const dvec2 square{random.uniform(-1, 1), random.uniform(-1, 1)}, disc = concentric(square);
    const double ring = std::max(std::abs(square.x), std::abs(square.y));
    ASSERT_NEAR(std::hypot(disc.x, disc.y), ring, 1e-15);
    ASSERT_EQ(concentric({-square.x, square.y}), (dvec2{-disc.x, disc.y}));
    ASSERT_EQ(concentric({square.x, -square.y}), (dvec2{disc.x, -disc.y}));
    ASSERT_EQ(concentric({square.y, square.x}), (dvec2{disc.y, disc.x}));
    // The derivative's determinant is pi/4 everywhere, away from the diagonals where two rules meet
    if (std::abs(std::abs(square.x) - std::abs(square.y)) < 1e-3 || ring < 0.05) continue;
    const double h = 1e-6;
    const dvec2 along = (concentric(square + dvec2{h, 0}) - concentric(square - dvec2{h, 0})) / (2 * h);
    const dvec2 up = (concentric(square + dvec2{0, h}) - concentric(square - dvec2{0, h})) / (2 * h);
    ASSERT_NEAR(along.x * up.y - along.y * up.x, 0.78539816339744831, 1e-8);
    ++inner;
  }
  EXPECT_GT(inner, 9'000);
}

TEST(AccumulationBuffer, EyesFillTheLensEvenly) {
  const Lens lens{2, 5};
  for (const int n : {1, 2, 3, 4, 8}) {
    dvec2 sum{0};
    std::set<std::pair<double, double>> eyes;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const dvec2 eye = lens.eye(i, j, n);
        EXPECT_LT(std::hypot(eye.x, eye.y), lens.radius);
        sum += eye;
        eyes.insert({eye.x, eye.y});
      }
    }
    EXPECT_EQ(std::ssize(eyes), n * n);
    EXPECT_NEAR(sum.x, 0, 1e-14);
    EXPECT_NEAR(sum.y, 0, 1e-14);
  }
}

TEST(AccumulationBuffer, APointOutOfFocusIsSpreadOverItsCircle) {
  // A point at depth 2 through a lens sharp at 4: as wide as the circle of confusion, 16 cells per unit
  const Lens lens{1, 4};
  const ivec2 picture{32, 32};
  std::vector<double> sums(32 * 32);
  const auto render = [&](dvec2 eye, const Sums<double>& plot) {
    const dvec2 at = 16.0 + 16.0 * seen(dvec3{0, 0, 2}, eye, lens.focus);
    plot(ivec2(glm::floor(at)), 1);
  };
  depth_of_field(64, lens, render, Sums<double>(sums, picture));
  const double radius = 16 * circle_of_confusion(lens.radius, lens.focus, 2.0) / 2;
  EXPECT_EQ(radius, 4);
  double light = 0;
  int inside = 0;
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      const double value = sums[static_cast<std::size_t>(32 * y + x)];
      const double from_middle = std::hypot(x + 0.5 - 16, y + 0.5 - 16);
      light += value;
      if (from_middle > radius + 0.75) EXPECT_EQ(value, 0);
      if (from_middle < radius - 0.75) {
        // A pixel's share of the disc's area
        EXPECT_NEAR(value, 1 / (3.14159265358979 * radius * radius), 0.002);
        ++inside;
      }
    }
  }
  EXPECT_EQ(light, 1);
  EXPECT_EQ(inside, 32);
}

// --- Steps

TEST(AccumulationBuffer, StepsFollowTheGrammar) {
  Recorder<Started, PassAdded, Averaged> recorded;
  std::vector<double> sums(20);
  const auto render = renderer(size, colour);
  accumulate({3, 2}, render, Sums<double>(sums, size), recorded);
  ASSERT_EQ(recorded.events().size(), 8u);
  EXPECT_EQ(std::get<Started>(recorded.events().front().step).passes, 6);
  EXPECT_EQ(std::get<Averaged>(recorded.events().back().step).passes, 6);
  std::int64_t k = 0;
  EXPECT_TRUE(every<PassAdded>(recorded, [&](const PassAdded& p) {
    const bool right = p.pass == k && p.place == place_of(static_cast<int>(k) % 3, k < 3 ? 0 : 1, {3, 2});
    ++k;
    return right;
  }));

  Recorder<Started, EyeAdded, Averaged> eyes;
  const Lens lens{1, 4};
  depth_of_field(2, lens, render, Sums<double>(sums, size), eyes);
  ASSERT_EQ(eyes.events().size(), 6u);
  EXPECT_EQ(std::get<EyeAdded>(eyes.events()[3].step).eye, lens.eye(0, 1, 2));
}

TEST(AccumulationBuffer, SumsGrowByAPictureAPass) {
  std::vector<double> sums(20), before(20, 0);
  const auto render = renderer(size, colour);
  const auto watch = [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, PassAdded>) {
      std::vector<double> pass(20, 0);
      render(step.place, Sums<double>(pass, size));
      for (std::size_t i = 0; i < 20; ++i) ASSERT_EQ(sums[i], before[i] + pass[i]);
      before = sums;
    }
  };
  accumulate({4, 4}, render, Sums<double>(sums, size), watch);
  EXPECT_EQ(sums, accumulated<double>({4, 4}));
}

TEST(AccumulationBuffer, Refusals) {
  std::vector<double> sums(20);
  const Sums<double> buffer(sums, size);
  const auto nothing = [](const auto&, const auto&) {};
  EXPECT_THROW(accumulate({0, 4}, nothing, buffer), ContractViolation);
  EXPECT_THROW(accumulate({4, -1}, nothing, buffer), ContractViolation);
  EXPECT_THROW(accumulate({1 << 10, (1 << 10) + 1}, nothing, buffer), ContractViolation);
  EXPECT_THROW(accumulate({INT_MAX, INT_MAX}, nothing, buffer), ContractViolation);
  EXPECT_THROW(motion_blur(0, {0, 1}, nothing, buffer), ContractViolation);
  EXPECT_THROW(motion_blur(4, {1, 0}, nothing, buffer), ContractViolation);
  EXPECT_THROW(depth_of_field(0, {1, 1}, nothing, buffer), ContractViolation);
  EXPECT_THROW(depth_of_field(4, {-1, 1}, nothing, buffer), ContractViolation);
  EXPECT_THROW(depth_of_field(4, {1, 0}, nothing, buffer), ContractViolation);
  EXPECT_THROW(Sums<double>(sums, {4, 4}), ContractViolation);
  EXPECT_THROW(Sums<double>(sums, {-4, -5}), ContractViolation);
}

// --- The exhibit

TEST(AccumulationBufferNotes, EightBitsShow8Of200) {
  // G001-112, E001-54: 200, 400, 600, 800 mod 256, and a quarter of the last
  std::uint8_t sum = 0;
  std::vector<int> sums;
  const auto watch = [&]<class Step>(const Step&) { sums.push_back(sum); };
  eight_bits({2, 2}, renderer({1, 1}, [](dvec2) { return 200; }), ByteSums{{&sum, 1}, {1, 1}}, watch);
  EXPECT_EQ(sums, (std::vector<int>{0, 200, 144, 88, 32, 8}));
}

TEST(AccumulationBufferNotes, EightBitsAreRightBelow256) {
  for (const int value : {0, 1, 63, 64, 255}) {
    std::uint8_t sum = 0;
    eight_bits({2, 2}, renderer({1, 1}, [=](dvec2) { return value; }), ByteSums{{&sum, 1}, {1, 1}});
    EXPECT_EQ(sum == value, 4 * value < 256) << value;
  }
}

}  // namespace
}  // namespace gradus::accumulation_buffer
