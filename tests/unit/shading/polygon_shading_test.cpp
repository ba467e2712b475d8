// Flat, Gouraud and Phong shading: the notes' numbers, what each misses, and how often each asks for light.

#include "shading/polygon_shading/polygon_shading.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "core/arithmetic/exact_scalar.hpp"
#include "core/random.hpp"
#include "core/record.hpp"
#include "core/surface.hpp"
#include "shading/illumination/illumination.hpp"
#include "shading/polygon_shading/polygon_shading_notes.hpp"
#include "shading/polygon_shading/vertex_normals.hpp"

namespace gradus::polygon_shading {
namespace {

using Lit = Corner<double, double>;
using Plain = Corner<double, Surface<double>>;
using Pixels = std::map<std::pair<int, int>, double>;

constexpr Window picture{{-64, -64}, {63, 63}};
/// Of the pixel (0, 0).
constexpr dvec2 centre{0.5};

auto into(Pixels& pixels) {
  return [&pixels](ivec2 p, double colour) {
    EXPECT_TRUE(pixels.emplace(std::pair{p.x, p.y}, colour).second) << "plotted twice: " << p.x << "," << p.y;
  };
}

Pixels gouraud_of(const std::vector<Lit>& polygon) {
  Pixels pixels;
  gouraud(std::span<const Lit>(polygon), picture, into(pixels));
  return pixels;
}

/// Phong's model, for a grey surface and a lamp.
struct Lamp {
  dvec3 light, eye;
  double ks = 0.2, shininess = 10;

  double operator()(dvec3 place, dvec3 normal) const {
    Material material;
    material.ambient = LinearRgb{0.1f};
    material.diffuse = LinearRgb{0.7f};
    material.specular = LinearRgb{static_cast<float>(ks)};
    material.shininess = static_cast<float>(shininess);
    Light lamp;
    lamp.position = light;
    const std::vector<Light> lights{lamp};
    return illumination::phong(place, normal, eye, material, std::span<const Light>(lights), LinearRgb{1})
        .sum()
        .x;
  }
};

/// A square of side 10 in the plane z = 0, its middle the centre of pixel (0, 0), seen from above.
std::vector<Plain> square() {
  std::vector<Plain> corners;
  for (const dvec2 p : {dvec2{-5, -5}, {5, -5}, {5, 5}, {-5, 5}})
    corners.push_back({p + centre, {dvec3(p, 0), {0, 0, 1}}});
  return corners;
}

std::vector<Lit> lit_of(const std::vector<Plain>& polygon, const Lamp& lamp) {
  std::vector<Lit> lit;
  for (const Plain& corner : polygon)
    lit.push_back({corner.at, lamp(corner.value.place, corner.value.normal)});
  return lit;
}

// --- Gouraud

TEST(PolygonShading, InExactArithmeticGouraudIsTheBarycentricMean) {
  const ExactScope scope;
  using Vec = glm::vec<2, Exact>;
  const std::vector<Corner<Exact, Exact>> triangle{{Vec{Exact(1, 3), Exact(1, 7)}, Exact(1, 5)},
                                                   {Vec{Exact(32, 3), Exact(2)}, Exact(7, 9)},
                                                   {Vec{Exact(4), Exact(29, 3)}, Exact(1)}};
  const auto area = [](Vec a, Vec b, Vec c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); };
  const auto &a = triangle[0], &b = triangle[1], &c = triangle[2];
  int pixels = 0;
  gouraud(std::span<const Corner<Exact, Exact>>(triangle), picture, [&](ivec2 pixel, Exact colour) {
    const Vec p{Exact(2 * pixel.x + 1, 2), Exact(2 * pixel.y + 1, 2)};
    const Exact mean =
        area(p, b.at, c.at) * a.value + area(a.at, p, c.at) * b.value + area(a.at, b.at, p) * c.value;
    EXPECT_EQ(colour, mean / area(a.at, b.at, c.at));
    ++pixels;
  });
  EXPECT_GT(pixels, 30);
}

TEST(PolygonShading, GouraudGoldenSample) {
  // G001-85: A (0, 0), B (5, 10), C (10, 0), here moved to pixels' centres
  const std::vector<Lit> triangle{
      {dvec2{0, 0} + centre, 0}, {dvec2{5, 10} + centre, 1}, {dvec2{10, 0} + centre, 0.5}};
  bool row = false, pixel = false;
  const auto watch = [&]<class Step>(const Step& s) {
    if constexpr (std::same_as<Step, RowBegun<double, double>>) {
      if (s.row != 4) return;
      row = true;
      EXPECT_NEAR(s.left.part, 0.4, 1e-12);
      EXPECT_NEAR(s.right.part, 0.4, 1e-12);
      EXPECT_NEAR(s.at_left, 0.4, 1e-12);
      EXPECT_NEAR(s.at_right, 0.7, 1e-12);
    }
    if constexpr (std::same_as<Step, Shaded<double, double, double>>) {
      if (s.pixel != ivec2{5, 4}) return;
      pixel = true;
      EXPECT_NEAR(s.gamma, 0.5, 1e-12);
      EXPECT_NEAR(s.colour, 0.55, 1e-12);
    }
  };
  gouraud(std::span<const Lit>(triangle), picture, [](ivec2, double) {}, watch);
  EXPECT_TRUE(row && pixel);
}

/// The golden's square with the values 1, 0, 1, 0, turned about its middle.
std::vector<Lit> turned_square(double degrees) {
  std::vector<Lit> corners;
  for (int i = 0; i < 4; ++i) {
    const auto [s, c] = sin_cos_degrees(225 + 90 * i + degrees);
    corners.push_back({centre + 8.0 * dvec2{c, s}, i % 2 == 0 ? 1.0 : 0.0});
  }
  return corners;
}

TEST(PolygonShading, AQuadTurnsItsColours) {
  // G001-86
  for (const auto& [degrees, value] : {std::pair{0.0, 0.5}, {30, 0.2113248654051871}, {45, 0}, {135, 1}}) {
    const Pixels pixels = gouraud_of(turned_square(degrees));
    EXPECT_NEAR(pixels.at({0, 0}), value, 1e-6) << degrees;
  }
}

TEST(PolygonShading, VertexShadesAreTheIlluminationModel) {
  const Lamp lamp{{3, 4, 5}, {0, 0, 9}};
  std::vector<Surface<double>> vertices;
  for (const Plain& corner : square()) vertices.push_back(corner.value);
  std::vector<double> lit(vertices.size());
  Recorder<VertexLit<double>> record;
  light_vertices(std::span<const Surface<double>>(vertices), lamp, std::span(lit), record);
  ASSERT_EQ(record.events().size(), 4u);
  for (std::size_t i = 0; i < lit.size(); ++i) EXPECT_EQ(lit[i], lamp(vertices[i].place, vertices[i].normal));
}

/// The golden's lamp and eye at one place above the surface, all in doubles: the light comes back along V.
struct LampAtTheEye {
  double operator()(dvec3 place, dvec3 normal) const {
    const double cosine = std::max(0.0, glm::dot(normal, glm::normalize(dvec3{0, 0, 2} - place)));
    return 0.1 + 0.7 * cosine + 0.2 * std::pow(std::max(0.0, 2 * cosine * cosine - 1), 10);
  }
};

TEST(PolygonShading, GouraudMissesTheHighlight) {
  // G001-87
  const std::vector<Plain> polygon = square();
  std::vector<Lit> lit;
  for (const Plain& corner : polygon)
    lit.push_back({corner.at, LampAtTheEye{}(corner.value.place, corner.value.normal)});
  const Pixels dull = gouraud_of(lit);
  Pixels bright;
  phong(std::span<const Plain>(polygon), picture, LampAtTheEye{}, into(bright));
  EXPECT_NEAR(bright.at({0, 0}), 1, 1e-12);
  for (const auto& [at, colour] : dull) EXPECT_NEAR(colour, 0.2905158688831361, 1e-12);
  // The brightest of all lies inside the face
  for (const auto& [at, colour] : bright) EXPECT_LE(colour, bright.at({0, 0}));
}

// --- Phong

TEST(PolygonShading, NormalsHaveLengthOneAtEveryPixel) {
  std::vector<Plain> polygon = square();
  for (Plain& corner : polygon)
    corner.value.normal = glm::normalize(dvec3(corner.value.place.x, corner.value.place.y, 4));
  double shortest = 1;
  const auto watch = [&]<class Step>(const Step& s) {
    if constexpr (std::same_as<Step, Shaded<double, Surface<double>, double>>) {
      EXPECT_NEAR(glm::length(s.between.normal), 1, 1e-15);
      shortest = std::min(shortest, s.length);
    }
  };
  phong(std::span<const Plain>(polygon), picture, Lamp{{0, 0, 9}, {0, 0, 9}}, [](ivec2, double) {}, watch);
  // In the middle the mean of four that lean outwards: their common part
  EXPECT_NEAR(shortest, 4 / std::sqrt(25 + 25 + 16.0), 1e-12);
}

TEST(PolygonShading, LightIsAskedForPerPolygonPerVertexAndPerPixel) {
  const std::vector<Plain> polygon = square();
  int asked = 0;
  const auto light = [&](dvec3, dvec3) { return static_cast<double>(++asked); };
  const auto drop = [](ivec2, double) {};
  Finished done{};
  const auto watch = [&]<class Step>(const Step& s) {
    if constexpr (std::same_as<Step, Finished>) done = s;
  };
  flat(std::span<const Plain>(polygon), picture, light, drop, watch);
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(done.lights, 1);
  EXPECT_EQ(done.pixels, 100);
  phong(std::span<const Plain>(polygon), picture, light, drop, watch);
  EXPECT_EQ(asked, 101);
  EXPECT_EQ(done.lights, 100);
  std::vector<Surface<double>> vertices;
  for (const Plain& corner : polygon) vertices.push_back(corner.value);
  std::vector<double> lit(4);
  light_vertices(std::span<const Surface<double>>(vertices), light, std::span(lit));
  EXPECT_EQ(asked, 105);
  gouraud(std::span<const Lit>(std::vector<Lit>{{{0, 0}, 0}, {{9, 0}, 1}, {{0, 9}, 0}}), picture, drop,
          watch);
  EXPECT_EQ(asked, 105);
  EXPECT_EQ(done.lights, 0);
}

// --- Flat

/// The roof of two squares that meet in the line x = 0, a pixel column apart from the middle.
std::vector<Plain> roof_side(double from, double to, double slope) {
  std::vector<Plain> corners;
  const dvec3 normal = glm::normalize(dvec3{-slope, 0, 1});
  for (const dvec2 p : {dvec2{from, -4}, {to, -4}, {to, 4}, {from, 4}})
    corners.push_back({p, {dvec3(p, slope * p.x), normal}});
  return corners;
}

TEST(PolygonShading, FlatGivesEachFaceOneColourAndAStepBetween) {
  const Lamp lamp{{-100, 0, 100}, {0, 0, 100}};
  Pixels pixels;
  for (const auto& side : {roof_side(-8, 0, 0.5), roof_side(0, 8, -0.5)})
    flat(std::span<const Plain>(side), picture, lamp, into(pixels));
  EXPECT_EQ(pixels.size(), 128u);
  for (const auto& [at, colour] : pixels) EXPECT_EQ(colour, pixels.at({at.first < 0 ? -1 : 0, 0}));
  EXPECT_GT(pixels.at({-1, 0}), pixels.at({0, 0}) + 0.3);
}

TEST(PolygonShading, FlatIsGoodFromFarAway) {
  // The largest difference between flat and Phong shading falls as lamp and eye go away
  double before = 1;
  for (const double distance : {5.0, 10.0, 20.0, 40.0, 80.0, 1e4}) {
    const Lamp lamp{{0, 0, distance}, {0, 0, distance}};
    Pixels once, each;
    const std::vector<Plain> polygon = square();
    flat(std::span<const Plain>(polygon), picture, lamp, into(once));
    phong(std::span<const Plain>(polygon), picture, lamp, into(each));
    double largest = 0;
    for (const auto& [at, colour] : each) largest = std::max(largest, std::abs(colour - once.at(at)));
    EXPECT_LT(largest, 0.8 * before) << distance;
    before = largest;
  }
  EXPECT_LT(before, 1e-5);
}

TEST(PolygonShading, AFaceNormalOfVertexNormalsLeans) {
  // G002-10, E002-14: three corners of a face of a cube whose vertex normals are smooth
  const double third = 1 / std::sqrt(3.0);
  std::vector<Plain> half;
  for (const dvec3 p : {dvec3{1, 1, 1}, {-1, 1, 1}, {-1, -1, 1}}) half.push_back({dvec2(p), {p, third * p}});
  const std::span<const Plain> polygon(half);
  EXPECT_NEAR(glm::distance(middle_of(polygon).normal, dvec3{0, 0, 1}), 0, 1e-15);
  const dvec3 tilted = leaning(polygon).normal;
  const dvec3 golden{-0.30151134457776363, 0.30151134457776363, 0.9045340337332909};
  EXPECT_NEAR(glm::distance(tilted, golden), 0, 1e-12);
  EXPECT_NEAR(std::acos(tilted.z) * 180 / std::numbers::pi, 25.239401820678907, 1e-9);
}

// --- Which pixels; that they are those inside, each in one of several polygons, is a promise

TEST(PolygonShading, OnlyPixelsOfThePictureArePlotted) {
  const std::vector<Lit> large{{{-1e6, -1e6}, 0}, {{1e6, -1e6}, 1}, {{0, 1e6}, 1}};
  Pixels pixels;
  gouraud(std::span<const Lit>(large), Window{{2, 3}, {5, 9}}, into(pixels));
  EXPECT_EQ(pixels.size(), 28u);
  EXPECT_EQ(pixels.begin()->first, (std::pair{2, 3}));
}

TEST(PolygonShading, WhatHasNoAreaPlotsNothing) {
  EXPECT_TRUE(gouraud_of({{{0, 0}, 0}, {{9, 9}, 1}, {{4, 4}, 1}}).empty());
  EXPECT_TRUE(gouraud_of({{{0, 0.5}, 0}, {{9, 0.5}, 1}, {{4, 0.5}, 1}}).empty());
  EXPECT_TRUE(gouraud_of({{{1, 1}, 0}, {{1, 1}, 1}, {{1, 1}, 1}}).empty());
  EXPECT_TRUE(gouraud_of({{{4, 2}, 0}, {{3.5, 0.5}, 1}, {{6, 8}, 1}}).empty()) << "through pixel (5, 6)";
  for (std::uint64_t i = 0; i < 20000; ++i) {
    Random random(20240611, i);
    const auto some = [&](int most) { return static_cast<double>(random.uniform_int(-most, most)) / 2; };
    const dvec2 start{some(40), some(40)}, way{some(12), some(12)};
    const auto corner = [&] { return Lit{start + 2 * some(6) * way, 1}; };
    EXPECT_TRUE(gouraud_of({corner(), corner(), corner()}).empty()) << "case " << i;
  }
}

TEST(PolygonShading, RefusesWhatIsNoPolygon) {
  const std::vector<Lit> two{{{0, 0}, 0}, {{9, 9}, 1}}, far{{{0, 0}, 0}, {{1e9, 9}, 1}, {{3, 9}, 0}};
  const std::vector<Lit> nowhere{{{0, 0}, 0}, {{std::nan(""), 9}, 1}, {{3, 9}, 0}};
  for (const auto& polygon : {two, far, nowhere}) EXPECT_THROW(gouraud_of(polygon), ContractViolation);
  std::vector<double> short_of_one(3);
  std::vector<Surface<double>> vertices(4);
  EXPECT_THROW(light_vertices(std::span<const Surface<double>>(vertices), Lamp{}, std::span(short_of_one)),
               ContractViolation);
}

// --- Steps

TEST(PolygonShading, StepsFollowTheGrammar) {
  const std::vector<Plain> polygon = square();
  std::string grammar;
  std::int64_t pixels = 0;
  const auto watch = [&]<class Step>(const Step& s) {
    if constexpr (std::same_as<Step, PolygonLit<double, double>>) grammar += 'L';
    if constexpr (std::same_as<Step, RowBegun<double, double>> ||
                  std::same_as<Step, RowBegun<double, Surface<double>>>)
      grammar += 'r';
    if constexpr (requires { s.gamma; }) {
      ++pixels;
      EXPECT_GE(s.gamma, 0);
      EXPECT_LE(s.gamma, 1);
    }
    if constexpr (std::same_as<Step, Finished>) {
      grammar += 'F';
      EXPECT_EQ(s.pixels, pixels);
    }
  };
  const Lamp lamp{{0, 0, 2}, {0, 0, 2}};
  const auto drop = [](ivec2, double) {};
  flat(std::span<const Plain>(polygon), picture, lamp, drop, watch);
  EXPECT_EQ(std::exchange(grammar, ""), "LrrrrrrrrrrF");
  EXPECT_EQ(std::exchange(pixels, 0), 100);
  flat_by_vertex_normals(std::span<const Plain>(polygon), picture, lamp, drop, watch);
  EXPECT_EQ(std::exchange(grammar, ""), "LrrrrrrrrrrF");
  pixels = 0;
  phong(std::span<const Plain>(polygon), picture, lamp, drop, watch);
  EXPECT_EQ(std::exchange(grammar, ""), "rrrrrrrrrrF");
  pixels = 0;
  const auto lit = lit_of(polygon, lamp);
  gouraud(std::span<const Lit>(lit), picture, drop, watch);
  EXPECT_EQ(grammar, "rrrrrrrrrrF");
}

TEST(PolygonShading, ObservedAndUnobservedPlotTheSame) {
  const Lamp lamp{{3, 1, 4}, {-2, 5, 9}};
  const std::vector<Plain> polygon = square();
  const auto watch = [](const auto&) {};
  Pixels a, b;
  phong(std::span<const Plain>(polygon), picture, lamp, into(a));
  phong(std::span<const Plain>(polygon), picture, lamp, into(b), watch);
  EXPECT_EQ(a, b);
  a.clear(), b.clear();
  flat(std::span<const Plain>(polygon), picture, lamp, into(a));
  flat(std::span<const Plain>(polygon), picture, lamp, into(b), watch);
  EXPECT_EQ(a, b);
  const auto lit = lit_of(polygon, lamp);
  Pixels c;
  gouraud(std::span<const Lit>(lit), picture, into(c), watch);
  EXPECT_EQ(gouraud_of(lit), c);
}

// --- Vertex normals

using Faces = std::vector<std::vector<int>>;

dvec3 normal_at_corner(const Faces& faces, Weighting weighting) {
  // Corner i of the unit cube lies at its bits
  std::vector<dvec3> places, normals(8);
  for (int i = 0; i < 8; ++i) places.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
  vertex_normals(std::span<const dvec3>(places), faces, weighting, std::span(normals));
  return normals[7];
}

/// The three sides that meet at corner 7, whole, or cut in two through it (x) or past it (y, z).
const Faces whole{{7, 5, 1, 3}, {7, 3, 2, 6}, {7, 6, 4, 5}};
const Faces cut{{7, 5, 1}, {7, 1, 3}, {7, 3, 6}, {3, 2, 6}, {7, 6, 5}, {6, 4, 5}};

TEST(VertexNormals, ACubesCornerHasTheMeanOfItsSides) {
  for (const Weighting weighting : {Weighting::plain, Weighting::area, Weighting::angle}) {
    const dvec3 normal = normal_at_corner(whole, weighting);
    EXPECT_NEAR(glm::distance(normal, dvec3{1 / std::sqrt(3.0)}), 0, 1e-15);
  }
}

TEST(VertexNormals, ThePlainMeanDependsOnTheTriangulation) {
  // G001-88: two triangles of one side meet there, one of each other side
  const dvec3 plain = normal_at_corner(cut, Weighting::plain);
  EXPECT_NEAR(glm::distance(plain, dvec3{0.8164965809277261, 0.4082482904638631, 0.4082482904638631}), 0,
              1e-9);
  const double cosine = glm::dot(plain, dvec3{1 / std::sqrt(3.0)});
  EXPECT_NEAR(std::acos(cosine) * 180 / std::numbers::pi, 19.471220634490695, 1e-9);
  // Angles add up to the side's however it is cut; of areas the corner has halves of two sides only
  EXPECT_NEAR(glm::distance(normal_at_corner(cut, Weighting::angle), dvec3{1 / std::sqrt(3.0)}), 0, 1e-15);
  const dvec3 area = normal_at_corner(cut, Weighting::area);
  EXPECT_NEAR(glm::distance(area, plain), 0, 1e-15);
}

TEST(VertexNormals, AreasIgnoreHowOftenAFanIsCut) {
  // A side cut into slivers at the corner, of the same area in all
  const std::vector<dvec3> places{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                  {0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 0.5, 0}};
  const Faces once{{0, 3, 2, 1}, {0, 4, 5, 3}, {0, 1, 6, 4}};
  const Faces often{{0, 7, 1}, {0, 2, 7}, {0, 3, 2}, {0, 4, 5, 3}, {0, 1, 6, 4}};
  for (const Weighting weighting : {Weighting::area, Weighting::angle}) {
    std::vector<dvec3> a(8), b(8);
    vertex_normals(std::span<const dvec3>(places), once, weighting, std::span(a));
    vertex_normals(std::span<const dvec3>(places), often, weighting, std::span(b));
    EXPECT_NEAR(glm::distance(a[0], b[0]), 0, 1e-15);
  }
}

TEST(VertexNormals, StepsNameEveryCornerThenEveryVertex) {
  std::vector<dvec3> places, normals(8);
  for (int i = 0; i < 8; ++i) places.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
  int added = 0, done = 0;
  std::vector<dvec3> sums(8, dvec3{0});
  const auto watch = [&]<class Step>(const Step& s) {
    if constexpr (std::same_as<Step, NormalAdded<double>>) {
      EXPECT_EQ(done, 0);
      EXPECT_NEAR(glm::length(s.normal), 1, 1e-15);
      sums[s.vertex] += s.weight * s.normal;
      ++added;
    }
    if constexpr (std::same_as<Step, VertexDone<double>>) {
      EXPECT_EQ(s.sum, sums[s.vertex]);
      ++done;
    }
  };
  vertex_normals(std::span<const dvec3>(places), cut, Weighting::area, std::span(normals), watch);
  EXPECT_EQ(added, 18);
  EXPECT_EQ(done, 8);
  std::vector<dvec3> fewer(7);
  EXPECT_THROW(vertex_normals(std::span<const dvec3>(places), cut, Weighting::area, std::span(fewer)),
               ContractViolation);
}

}  // namespace
}  // namespace gradus::polygon_shading
