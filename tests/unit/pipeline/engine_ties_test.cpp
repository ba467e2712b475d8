// Triangles of one plane in the engine: which is seen is found for many places at once, and is what the depth
// of the chain says at each.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "antialiasing/adaptive/sample_places.hpp"
#include "engine/geometry.hpp"
#include "engine/samples_batch.hpp"
#include "engine/shown_batch.hpp"
#include "engine/ties.hpp"
#include "engine/tiles.hpp"
#include "engine/visibility_batch.hpp"
#include "projection/viewing/viewing.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"
#include "support/every_target.hpp"
#include "support/random_scenes.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"

namespace gradus::pipeline::engine::engine_ties_test {
namespace {

constexpr Size size{150, 100};

/// What the chain compares: the depth at a place, then the face and its piece, then what came first.
struct ChainDepth {
  double depth;
  PieceId piece;
  std::int32_t id;

  bool operator<(const ChainDepth& b) const {
    return std::tie(depth, piece, id) < std::tie(b.depth, b.piece, b.id);
  }
};
ChainDepth chain_depth(const Scene& scene, const Frame& frame, std::int32_t id, ivec2 place) {
  const FrameTriangle& t = frame.triangle(id);
  const auto weights = weights_at_place(triangle_coverage::edges_of(t.grid), place);
  return {depth_of(frame, t).at(place, weights), whole_triangle(scene, frame, id).id, id};
}

/// Triangles that lie over one another in three planes, their corners small whole numbers; sizes from a part
/// of a pixel to all of the picture, some beyond the near plane.
Scene layered_scene(Random& random) {
  Scene scene;
  Mesh mesh;
  mesh.materials = {test::random_material(random)};
  for (int plane = 0; plane < 3; ++plane) {
    const auto whole = [&](int most) { return static_cast<double>(random.uniform_int(-most, most)); };
    const double right = whole(2), up = whole(2), height = whole(3);
    for (int i = 0; i < 12; ++i) {
      const int most = i % 3 == 0 ? 1 : 8, first = static_cast<int>(mesh.positions.size());
      const dvec2 middle{whole(4), whole(4)};
      for (int k = 0; k < 3; ++k) {
        const dvec2 at = middle + dvec2{whole(most), whole(most)};
        mesh.positions.push_back({at.x, at.y, height + right * at.x + up * at.y});
      }
      test::add_face(mesh, {first, first + 1, first + 2});
    }
  }
  scene.objects.push_back(object_of(std::move(mesh)));
  scene.culling = Culling::none;
  const dvec3 eye = test::random_point(random, 6) + dvec3{0, 0, 9};
  scene.camera.frame = viewing::look_at(eye, test::random_point(random, 2), dvec3{0.01, 1, 0.02});
  return scene;
}

/// Triangles of a slanted plane with an edge along a row of pixels' centres but for less than half a step of
/// the grid: snapping takes the plane's depth there beyond that of the corners.
Scene rounded_scene(Random& random) {
  Scene scene;
  Mesh mesh;
  mesh.materials = {test::random_material(random)};
  const double slope = random.uniform_int(0, 1) == 0 ? -1 : 2;
  for (int i = 0; i < 24; ++i) {
    // From the picture's middle, a pixel per unit
    const auto along = [&](int side) {
      const std::int64_t pixel = random.uniform_int(-side / 2, side / 2 - 1);
      return static_cast<double>(pixel) + 0.5 + random.uniform(-0.5, 0.5) / triangle_coverage::subpixels;
    };
    const int first = static_cast<int>(mesh.positions.size());
    const double edge = along(size.height), third = along(size.height);
    for (const double y : {edge, edge, third}) mesh.positions.push_back({along(size.width), y, slope * y});
    test::add_face(mesh, {first, first + 1, first + 2});
  }
  scene.objects.push_back(object_of(std::move(mesh)));
  scene.culling = Culling::none;
  scene.camera.frame = viewing::look_at(dvec3{0, 0, 200}, dvec3{0}, dvec3{0, 1, 0});
  scene.camera.rays = ParallelRays{.height = double{size.height}, .near = 1, .far = 400};
  return scene;
}

/// Triangles of one plane whose corners are places of the grid, each an object of its own: their depths
/// differ by rounding alone.
Scene scene_on_grid(Random& random) {
  Scene scene = rounded_scene(random);
  const Mesh& all = *scene.objects.front().mesh;
  std::vector<Object> objects;
  for (std::size_t i = 0; i + 2 < all.positions.size(); i += 3) {
    Mesh mesh;
    mesh.materials = all.materials;
    for (std::size_t k = i; k < i + 3; ++k) {
      const auto placed = [](double at) { return std::floor(at * 256) / 256; };
      const dvec2 at{placed(all.positions[k].x), placed(all.positions[k].y)};
      mesh.positions.push_back({at.x, at.y, 0.3 * at.x - 0.7 * at.y});
    }
    test::add_face(mesh, {0, 1, 2});
    objects.push_back(object_of(std::move(mesh)));
  }
  scene.objects = std::move(objects);
  return scene;
}

/// Lies like another object, or its corners are off by some last digits: as deep, or in doubt to single
/// precision alone.
void add_twins(Scene& scene, Random& random) {
  scene.objects.push_back(scene.objects.front());
  Mesh mesh = *scene.objects.front().mesh;
  for (dvec3& corner : mesh.positions) corner += test::random_point(random, 1e-7);
  scene.objects.push_back(object_of(std::move(mesh)));
}

/// Under a sanitizer one scene in so many is drawn.
constexpr std::size_t one_scene_in = 3;

/// check(scene, frame, random) for many of these.
template <class Check>
void for_layered_scenes(std::size_t count, Touch touch, const Check& check) {
  for (std::uint64_t round = 0; round < test::thinned(count, one_scene_in); ++round) {
    Random random(test::seed(), round);
    Scene scene = round % 3 == 0   ? rounded_scene(random)
                  : round % 3 == 1 ? scene_on_grid(random)
                                   : layered_scene(random);
    if (round % 3 != 1) add_twins(scene, random);
    const Buffers buffers = buffers_of(scene);
    Frame frame;
    make_frame(scene, buffers, plan_of(scene, size), touch, frame);
    check(scene, frame, random);
    if (testing::Test::HasFatalFailure()) return;
  }
}

std::vector<std::int32_t> ids_of(const Frame& frame) {
  std::vector<std::int32_t> ids;
  for (std::size_t batch = 0; batch < frame.batches.size(); ++batch)
    for (std::size_t i = 0; i < frame.batches[batch].triangles.size(); ++i)
      ids.push_back(static_cast<std::int32_t>(batch * batch_triangles + i));
  return ids;
}

TEST(EngineTies, AreDecidedAtAPlaceAndInASquareAsByTheDepthsOfTheChain) {
  using Order = TileTies::Order;
  std::map<Order, int> planes, others;
  for_layered_scenes(40, Touch::centres, [&](const Scene& scene, const Frame& frame, Random& random) {
    const std::vector<std::int32_t> ids = ids_of(frame);
    const ivec2 tile{64, 0};
    TileTies ties(frame, tile);
    for (int i = 0; i < 4000; ++i) {
      const auto any = [&] {
        return ids[static_cast<std::size_t>(random.uniform_int(0, std::ssize(ids) - 1))];
      };
      const std::int32_t one = any(), two = any();
      if (one == two) continue;
      const auto along = [&](int most) { return static_cast<int>(random.uniform_int(0, most)); };
      const int pixels = i % 2 == 0 ? 4 : 1;  // a block, or the samples of a pixel
      const ivec2 square{along(64 / pixels - 1), along(64 / pixels - 1)};
      const Places places{(tile + pixels * square) * triangle_coverage::subpixels,
                          pixels * triangle_coverage::subpixels};
      const Order order = ties.order(one, two, places);
      const FrameTriangle &a = frame.triangle(one), &b = frame.triangle(two);
      ++(a.plane != no_plane && a.plane == b.plane ? planes : others)[order];
      for (int k = 0; k < 8; ++k) {
        ivec2 within{along(places.side), along(places.side)};
        if (k < 4) within = places.side * ivec2{k / 2, k % 2};
        const ivec2 place = places.first + within;
        const bool before = chain_depth(scene, frame, one, place) < chain_depth(scene, frame, two, place);
        ASSERT_EQ(ties.is_before(one, two, place), before) << one << ", " << two;
        if (order == Order::open) continue;
        ASSERT_EQ(order == Order::before, before) << one << ", " << two;
      }
    }
  });
  const auto least = static_cast<int>(test::thinned(1000, one_scene_in));
  for (const Order order : {Order::before, Order::after, Order::open}) {
    EXPECT_GT(planes[order], least);
    EXPECT_GT(others[order], least);
  }
}

/// The triangle that is nearest at a place, one after the other.
std::int32_t nearest_at(const Scene& scene, const Frame& frame, ivec2 place) {
  std::optional<ChainDepth> best;
  for (const std::int32_t id : ids_of(frame)) {
    const auto edges = triangle_coverage::edges_of(frame.triangle(id).grid);
    if (!holds(edges, weights_at_place(edges, place))) continue;
    const ChainDepth mine = chain_depth(scene, frame, id, place);
    if (!best || mine < *best) best = mine;
  }
  return best ? best->id : no_triangle;
}

TEST(EngineTies, OfPixelsAreThoseOfAZBuffer) {
  for_layered_scenes(6, Touch::centres, [&](const Scene& scene, Frame& frame, Random&) {
    const TileGrid grid({{0, 0}, {size.width - 1, size.height - 1}});
    bin(frame, grid, Touch::centres);
    std::vector<std::int32_t> expected;
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x)
        expected.push_back(nearest_at(scene, frame, triangle_coverage::centre_of({x, y})));
    const auto buffer = std::make_unique<TileBuffer>();
    test::on_every_target([&] {
      for (int tile = 0; tile < grid.count(); ++tile) {
        const Window pixels = grid.tile(tile);
        find_nearest(frame, tile, pixels, *buffer);
        for (int y = pixels.lower.y; y <= pixels.upper.y; ++y)
          for (int x = pixels.lower.x; x <= pixels.upper.x; ++x)
            ASSERT_EQ(buffer->ids[TileBuffer::cell(ivec2{x, y} - pixels.lower)],
                      expected[static_cast<std::size_t>(y * size.width + x)])
                << x << ", " << y;
      }
    });
  });
}

TEST(EngineTies, OfSamplesAreThoseOfAZBuffer) {
  const std::vector<ivec2> places = adaptive::n_rooks(5);
  using Counts = std::map<std::int32_t, std::int32_t>;
  for_layered_scenes(6, Touch::neighbours, [&](const Scene& scene, Frame& frame, Random&) {
    const TileGrid grid({{0, 0}, {63, 63}});
    bin(frame, grid, Touch::neighbours);
    std::vector<Counts> expected(SampleBuffer::cells);
    for (std::size_t cell = 0; cell < SampleBuffer::cells; ++cell) {
      for (const ivec2 sample : places) {
        const ivec2 place = TileBuffer::place(cell) * triangle_coverage::subpixels + sample;
        if (const std::int32_t id = nearest_at(scene, frame, place); id != no_triangle) ++expected[cell][id];
      }
    }
    const auto buffer = std::make_unique<SampleBuffer>();
    test::on_every_target([&] {
      find_samples(frame, 0, grid.tile(0), places, *buffer);
      std::vector<ShownTriangle> shown;
      find_shown(frame, grid.tile(0), places, *buffer, shown);
      std::vector<Counts> found(SampleBuffer::cells);
      for (const ShownTriangle& s : shown) found[s.cell][s.id] += s.samples;
      for (std::size_t cell = 0; cell < SampleBuffer::cells; ++cell) {
        if (buffer->sampled[cell] < 0 && buffer->whole[cell] != no_triangle)
          found[cell][buffer->whole[cell]] = static_cast<std::int32_t>(places.size());
        ASSERT_EQ(found[cell], expected[cell]) << "cell " << cell;
      }
    });
  });
}

/// A wall with a decal in its plane, or that far before it; the first in the file is to be seen.
Scene decal(double before, bool decal_first) {
  Scene scene;
  Mesh mesh;
  mesh.materials = {Material{}};
  const auto add_square = [&](double side, double z) {
    const int first = static_cast<int>(mesh.positions.size());
    for (const dvec2 at : {dvec2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      const dvec2 corner = side * at;
      mesh.positions.push_back({corner.x, corner.y, z});
    }
    test::add_face(mesh, {first, first + 1, first + 2, first + 3});
  };
  if (decal_first) add_square(1.5, before);
  add_square(2, 0);
  if (!decal_first) add_square(1.5, before);
  scene.objects.push_back(object_of(std::move(mesh)));
  scene.camera.frame = viewing::look_at(dvec3{0.4, 0.7, 3}, dvec3{0}, dvec3{0, 1, 0});
  return scene;
}

/// Pixels of a tile in the middle of the picture whose samples are looked at.
std::size_t sampled_pixels(const Scene& scene) {
  const std::vector<ivec2> places = adaptive::n_rooks(16);
  const Buffers buffers = buffers_of(scene);
  Frame frame;
  make_frame(scene, buffers, plan_of(scene, {192, 192}), Touch::neighbours, frame);
  const TileGrid grid({{0, 0}, {191, 191}});
  bin(frame, grid, Touch::neighbours);
  const auto buffer = std::make_unique<SampleBuffer>();
  find_samples(frame, 4, grid.tile(4), places, *buffer);
  return buffer->sampled_cells.size();
}

/// A triangle, maybe beside an object that lies as it does, its corners numbered the other way.
Scene triangle(bool twice) {
  Scene scene = decal(0, false);
  const auto turned = [&](std::initializer_list<int> corners) {
    Mesh mesh;
    mesh.materials = {Material{}};
    mesh.positions = {{-2, -2, 0.3}, {2, -2, 0.1}, {0.1, 2, 0.2}};
    test::add_face(mesh, corners);
    return object_of(std::move(mesh));
  };
  scene.objects = {turned({0, 1, 2})};
  if (twice) scene.objects.push_back(turned({2, 1, 0}));
  scene.culling = Culling::none;
  return scene;
}

TEST(EngineTies, ATwinHasNoSamplesLookedAtWhereItIsHidden) {
  EXPECT_LE(sampled_pixels(triangle(true)), sampled_pixels(triangle(false)));
}

TEST(EngineTies, ADecalHasSamplesLookedAtWhereItHasThemLiftedOff) {
  for (const bool decal_first : {false, true}) {
    const std::size_t lifted = sampled_pixels(decal(0.01, decal_first));
    EXPECT_GT(lifted, 0U);  // along a diagonal
    EXPECT_LE(sampled_pixels(decal(0, decal_first)), 2 * lifted);
  }
}

}  // namespace
}  // namespace gradus::pipeline::engine::engine_ties_test
