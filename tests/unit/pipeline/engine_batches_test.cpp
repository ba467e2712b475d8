// The engine's batches beside what they stand for, on every kind of machine that this one can be: vertices
// one after the other, pieces by their exact coverage, a z-buffer, and one picture for all.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "antialiasing/adaptive/pixel_survey.hpp"
#include "antialiasing/adaptive/sample_places.hpp"
#include "core/arithmetic/elementary.hpp"
#include "core/colour.hpp"
#include "engine/casts.hpp"
#include "engine/engine.hpp"
#include "engine/geometry.hpp"
#include "engine/mip_maps.hpp"
#include "engine/pieces_batch.hpp"
#include "engine/samples_batch.hpp"
#include "engine/shading_batch.hpp"
#include "engine/shown_batch.hpp"
#include "engine/tiles.hpp"
#include "engine/vertices_batch.hpp"
#include "engine/visibility_batch.hpp"
#include "projection/viewing/viewing.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"
#include "stages/4_back_faces.hpp"
#include "stages/5_clipping.hpp"
#include "stages/6_rasterization.hpp"
#include "support/every_target.hpp"
#include "support/random_scenes.hpp"
#include "support/sanitized.hpp"
#include "support/seed.hpp"

namespace gradus::pipeline::engine::engine_batches_test {
namespace {

/// So many scenes; a third of them under a sanitizer.
int rounds(std::size_t count) { return static_cast<int>(test::thinned(count, 3)); }

constexpr Size size{200, 150};

// --- Vertices ------------------------------------------------------------------------------------

/// Where a vertex comes to lie, stage by stage.
struct Placed {
  ivec2 grid;
  double depth;
};
Placed placed(const VertexPath& path, const glm::dmat4& placement, dvec3 position) {
  const dvec3 world = affine_3d::transform(placement, position);
  const glm::dvec4 clip = transform(path.lens, viewing::to_view(path.camera.frame, world));
  int outside = 0, bit = 0;
  for (const auto& plane : guard_volume(path.size)) {
    const double along = plane.axis == 0 ? clip.x : plane.axis == 1 ? clip.y : clip.z;
    outside |= !(plane.bound * clip.w + plane.sign * along >= 0) << bit++;
  }
  if (outside != 0) return {{beyond, outside}, clip.z / clip.w};
  const double x = (1 + clip.x / clip.w) * (path.size.width / 2.0),
               y = (1 - clip.y / clip.w) * (path.size.height / 2.0);
  return {triangle_coverage::snap({x, y}), clip.z / clip.w};
}

TEST(EngineBatches, PlaceVerticesAsTheStagesDo) {
  Random random(test::seed());
  for (int round = 0; round < 40; ++round) {
    Scene scene = test::random_scene(random, 1);
    if (round % 3 == 0) {
      const double a = random.uniform(-1, 1), b = random.uniform(-1, 1);
      scene.camera.rays = ParallelRays{4, {a, b}, 3, -1, 9};
    }
    const VertexPath path{scene.camera, lens_of(scene.camera, static_cast<double>(size.width) / size.height),
                          size};
    const glm::dmat4& placement = scene.objects[0].placement;
    // Also fewer than fill a register
    std::vector<dvec3> positions(static_cast<std::size_t>(random.uniform_int(0, 70)));
    for (dvec3& position : positions) position = test::random_point(random, round % 2 == 0 ? 3 : 40);
    const int targets = test::on_every_target([&] {
      std::vector<ivec2> grid(positions.size());
      std::vector<double> depths(positions.size());
      place_vertices(path, placement, positions, grid, depths);
      for (std::size_t i = 0; i < positions.size(); ++i) {
        const Placed expected = placed(path, placement, positions[i]);
        ASSERT_EQ(grid[i], expected.grid) << "vertex " << i << " of round " << round;
        ASSERT_EQ(std::bit_cast<std::uint64_t>(depths[i]), std::bit_cast<std::uint64_t>(expected.depth));
      }
    });
    EXPECT_GE(targets, 1);
  }
}

// --- Pieces --------------------------------------------------------------------------------------

TEST(EngineBatches, LeaveOutNoPieceThatCoversSomething) {
  Random random(test::seed());
  const Window window{{0, 0}, {63, 63}};
  for (int round = 0; round < 200; ++round) {
    // Of sizes from a part of a pixel to more than a picture, some beyond planes
    const int reach = 1 << random.uniform_int(3, 16);
    std::vector<ivec2> grid;
    std::vector<PieceVertices> pieces(static_cast<std::size_t>(random.uniform_int(1, 50)));
    for (PieceVertices& piece : pieces) {
      const auto place = [&] { return static_cast<int>(random.uniform_int(-4096, 64 * 256 + 4096)); };
      const int x = place(), y = place();
      for (std::int32_t& vertex : piece) {
        vertex = static_cast<std::int32_t>(grid.size());
        const auto off = [&] { return static_cast<int>(random.uniform_int(-reach, reach)); };
        const int dx = off(), dy = off();
        grid.push_back(random.unit() < 0.03 ? ivec2{beyond, 1 << random.uniform_int(0, 5)}
                                            : ivec2{x + dx, y + dy});
      }
    }
    const PieceChoice choice{window, static_cast<int>(random.uniform_int(0, 1)), random.unit() < 0.5,
                             random.unit() < 0.5};
    std::optional<std::vector<std::uint32_t>> first;
    test::on_every_target([&] {
      std::vector<Left> left(pieces.size());
      const PieceCount count = choose_pieces(choice, pieces, grid.data(), 100, left);
      left.resize(static_cast<std::size_t>(count.left));
      ASSERT_EQ(
          count.left + count.beyond_plane + count.turned_away + count.without_area + count.without_pixel,
          std::ssize(pieces));
      std::vector<std::uint32_t> all;
      for (const Left& l : left) all.push_back(l.number_and_seen);
      if (!first) first = all;
      ASSERT_EQ(all, *first) << "the same on every machine";
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        const auto number = static_cast<std::int32_t>(100 + i);
        const auto found = std::ranges::find(left, number, &Left::number);
        const auto& [p, q, r] = pieces[i];
        const auto at = [&](std::int32_t vertex) { return grid[static_cast<std::size_t>(vertex)]; };
        const triangle_coverage::Triangle t{at(p), choice.mirrored ? at(r) : at(q),
                                            choice.mirrored ? at(q) : at(r)};
        const auto outside = std::ranges::count_if(t, [](ivec2 v) { return v.x == beyond; });
        if (outside > 0) {
          const bool all_out = outside == 3 && (t[0].y & t[1].y & t[2].y) != 0;
          ASSERT_EQ(found == left.end(), all_out);
          if (!all_out) ASSERT_EQ(found->seen(), Seen::unsure);
          continue;
        }
        const std::int64_t area = triangle_coverage::doubled_area(t);
        const bool asked = choice.margin == 0 ? !triangle_coverage::centres(t, window).empty()
                                              : !touched(t, window, Touch::neighbours).empty();
        std::int64_t covered = 0;
        triangle_coverage::cover(t, window, [&](ivec2, const auto&) { ++covered; });
        if (found == left.end()) {
          ASSERT_TRUE(area == 0 || !asked || (choice.margin == 0 && covered == 0) ||
                      (area > 0 && !choice.two_sided))
              << "round " << round << ", piece " << i;
        } else {
          ASSERT_TRUE(asked);
          if (found->seen() != Seen::unsure) ASSERT_EQ(found->seen() == Seen::behind, area > 0);
        }
      }
    });
  }
}

// --- What is nearest -----------------------------------------------------------------------------

/// The nearest triangle at every pixel of a tile, one triangle and one pixel after the other.
void expect_nearest(const Frame& frame, int tile, const Window& pixels, const TileBuffer& buffer) {
  struct Nearest {
    double depth;
    PieceId piece;
    std::int32_t id;
  };
  std::vector<std::optional<Nearest>> nearest(TileBuffer::cells);
  visit_tile(frame, tile, [&](std::int32_t id) {
    const FrameTriangle& t = frame.triangle(id);
    const FrameObject& object = frame.object_of(t);
    const auto& of_faces = object.pieces->of_faces;
    const PieceId piece = t.cut ? frame.cut_triangle(id).id
                                : PieceId{object.number, of_faces[static_cast<std::size_t>(t.piece)].face,
                                          of_faces[static_cast<std::size_t>(t.piece)].piece};
    const triangle_coverage::Depth depth = depth_of(frame, t);
    triangle_coverage::cover(t.grid, pixels, [&](ivec2 pixel, const triangle_coverage::Weights& w) {
      auto& best = nearest[TileBuffer::cell(pixel - pixels.lower)];
      const Nearest mine{depth.at(triangle_coverage::centre_of(pixel), w), piece, id};
      const auto before = [](const Nearest& a, const Nearest& b) {
        return std::tie(a.depth, a.piece, a.id) < std::tie(b.depth, b.piece, b.id);
      };
      if (!best || before(mine, *best)) best = mine;
    });
  });
  for (std::size_t cell = 0; cell < TileBuffer::cells; ++cell)
    ASSERT_EQ(buffer.ids[cell], nearest[cell] ? nearest[cell]->id : no_triangle) << "cell " << cell;
}

void expect_nearest_everywhere(Frame& frame, const Window& window) {
  const TileGrid grid(window);
  bin(frame, grid, Touch::centres);
  const auto buffer = std::make_unique<TileBuffer>();
  for (int tile = 0; tile < grid.count(); ++tile) {
    find_nearest(frame, tile, grid.tile(tile), *buffer);
    expect_nearest(frame, tile, grid.tile(tile), *buffer);
  }
}

TEST(EngineBatches, FindWhatIsNearestAsAZBufferDoes) {
  const std::uint64_t seed = test::seed();
  for (int round = 0; round < rounds(25); ++round) {
    Random random(seed, static_cast<std::uint64_t>(round));
    Scene scene = round % 2 == 0 ? test::random_scene(random, 8) : test::random_screened_scene(random, 8);
    // The same a second time: equally deep
    scene.objects.push_back(scene.objects.front());
    const Buffers buffers = buffers_of(scene);
    const Plan plan = plan_of(scene, size);
    test::on_every_target([&] {
      Frame frame;
      make_frame(scene, buffers, plan, Touch::centres, frame);
      expect_nearest_everywhere(frame, plan.window);
    });
  }
}

/// A scene round the eye: triangles from a part of a pixel to what reaches from behind it far away, so that
/// the near plane makes sides of more than 2^15 pixels.
Scene scene_of_all_sizes(Random& random) {
  Scene scene = test::random_scene(random, 3);
  Mesh mesh;
  mesh.materials = {test::random_material(random)};
  for (int i = 0; i < 300; ++i) {
    const double reach = std::pow(10.0, random.uniform(-3, 3));
    const dvec3 middle = scene.camera.frame.eye + test::random_point(random, 6);
    const int first = static_cast<int>(mesh.positions.size());
    for (int k = 0; k < 3; ++k) mesh.positions.push_back(middle + test::random_point(random, reach));
    test::add_face(mesh, {first, first + 1, first + 2});
  }
  scene.objects.push_back(object_of(std::move(mesh)));
  scene.objects.push_back(scene.objects.back());
  scene.culling = Culling::none;
  scene.camera.lens.near = 1e-4;
  return scene;
}

/// The longer side of a triangle's box, in 1/256 pixel.
std::int64_t side_of_box(const triangle_coverage::Triangle& t) {
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
  return std::max(std::int64_t{right} - left, std::int64_t{bottom} - top);
}

TEST(EngineBatches, FindWhatIsNearestAmongTrianglesOfAllSizes) {
  const std::uint64_t seed = test::seed();
  std::int64_t small = 0, long_ones = 0;
  for (int round = 0; round < rounds(6); ++round) {
    Random random(seed, static_cast<std::uint64_t>(round));
    const Scene scene = scene_of_all_sizes(random);
    const Buffers buffers = buffers_of(scene);
    const Plan plan = plan_of(scene, size);
    test::on_every_target([&] {
      Frame frame;
      make_frame(scene, buffers, plan, Touch::centres, frame);
      for (const Batch& batch : frame.batches) {
        for (const FrameTriangle& t : batch.triangles) {
          small += side_of_box(t.grid) < 16 * 256;
          long_ones += side_of_box(t.grid) > 1 << 23;
        }
      }
      expect_nearest_everywhere(frame, plan.window);
    });
  }
  EXPECT_GT(small, 0);
  EXPECT_GT(long_ones, 0);
}

// --- What samples show ---------------------------------------------------------------------------

/// The nearest triangle at a place of the picture, one after the other.
std::int32_t nearest_at(const Frame& frame, const std::vector<std::int32_t>& ids, ivec2 place) {
  std::optional<std::tuple<double, PieceId, std::int32_t>> best;
  for (const std::int32_t id : ids) {
    const FrameTriangle& t = frame.triangle(id);
    const auto edges = triangle_coverage::edges_of(t.grid);
    const auto weights = weights_at_place(edges, place);
    if (!holds(edges, weights)) continue;
    const std::tuple mine(depth_of(frame, t).at(place, weights), piece_of(frame, t, id), id);
    if (!best || mine < *best) best = mine;
  }
  return best ? std::get<2>(*best) : no_triangle;
}

/// How many samples of a pixel show each triangle.
using SampleCounts = std::map<std::int32_t, std::int32_t>;

/// Those of the pixels of a tile, by cell, one sample after the other.
std::vector<SampleCounts> samples_one_by_one(const Frame& frame, int tile, const Window& pixels,
                                             std::span<const ivec2> places) {
  std::vector<std::int32_t> ids;
  visit_tile(frame, tile, [&](std::int32_t id) { ids.push_back(id); });
  std::vector<SampleCounts> counts(SampleBuffer::cells);
  for (int y = pixels.lower.y; y <= pixels.upper.y; ++y) {
    for (int x = pixels.lower.x; x <= pixels.upper.x; ++x) {
      for (const ivec2 place : places) {
        const std::int32_t id = nearest_at(frame, ids, ivec2{x, y} * triangle_coverage::subpixels + place);
        if (id != no_triangle) ++counts[TileBuffer::cell(ivec2{x, y} - pixels.lower)][id];
      }
    }
  }
  return counts;
}

/// The same as the batch has them.
std::vector<SampleCounts> samples_of_batch(const Frame& frame, int tile, const Window& pixels,
                                           std::span<const ivec2> places) {
  const auto buffer = std::make_unique<SampleBuffer>();
  find_samples(frame, tile, pixels, places, *buffer);
  std::vector<ShownTriangle> shown;
  find_shown(frame, pixels, places, *buffer, shown);
  std::vector<SampleCounts> counts(SampleBuffer::cells);
  for (const ShownTriangle& s : shown) {
    EXPECT_TRUE(counts[s.cell].emplace(s.id, s.samples).second) << "once per pixel";
    const auto edges = triangle_coverage::edges_of(frame.triangle(s.id).grid);
    EXPECT_EQ(s.place, adaptive::colour_place(edges, pixels.lower + TileBuffer::place(s.cell), places));
  }
  for (std::size_t cell = 0; cell < SampleBuffer::cells; ++cell)
    if (buffer->sampled[cell] < 0 && buffer->whole[cell] != no_triangle)
      counts[cell].emplace(buffer->whole[cell], static_cast<std::int32_t>(places.size()));
  return counts;
}

TEST(EngineBatches, FindWhatSamplesShowAsAZBufferDoes) {
  const std::uint64_t seed = test::seed();
  constexpr Size small_size{90, 70};
  for (int round = 0; round < rounds(10); ++round) {
    Random random(seed, static_cast<std::uint64_t>(round));
    Scene scene = round % 2 == 0 ? scene_of_all_sizes(random) : test::random_scene(random, 8);
    scene.objects.push_back(scene.objects.front());
    const Buffers buffers = buffers_of(scene);
    const Plan plan = plan_of(scene, small_size);
    std::vector<ivec2> places = adaptive::n_rooks(static_cast<int>(random.uniform_int(1, 16)));
    std::ranges::stable_sort(places, {}, [](ivec2 place) {
      const ivec2 way = place - pixel_middle;
      return way.x * way.x + way.y * way.y;
    });
    Frame frame;
    make_frame(scene, buffers, plan, Touch::neighbours, frame);
    const TileGrid grid(plan.window);
    bin(frame, grid, Touch::neighbours);
    for (int tile = 0; tile < grid.count(); ++tile) {
      const auto expected = samples_one_by_one(frame, tile, grid.tile(tile), places);
      test::on_every_target([&] {
        const auto found = samples_of_batch(frame, tile, grid.tile(tile), places);
        for (std::size_t cell = 0; cell < SampleBuffer::cells; ++cell)
          ASSERT_EQ(found[cell], expected[cell]) << "round " << round << ", cell " << cell;
      });
    }
  }
}

// --- Textures ------------------------------------------------------------------------------------

TEST(EngineBatches, MakeMipMapsAsTheTextbookDoes) {
  Random random(test::seed());
  for (int round = 0; round < 60; ++round) {
    // Also such as several threads share
    Image texels = test::random_texture(random);
    if (round % 10 == 0) {
      const auto columns = static_cast<int>(random.uniform_int(200, 600)), rows = round % 20 == 0 ? 256 : 301;
      texels = Image(round % 20 == 0 ? 512 : columns, rows);
      for (Rgba8& texel : texels.cells()) {
        const auto value = static_cast<std::uint8_t>(random.uniform_int(0, 255));
        texel = {value, static_cast<std::uint8_t>(255 - value), static_cast<std::uint8_t>(value / 3), 255};
      }
    }
    const LinearTexture texture = linear_texture(texels), expected(texels);
    ASSERT_EQ(texture.size(), expected.size());
    ASSERT_TRUE(std::ranges::equal(texture.texels(), expected.texels(),
                                   [](const auto& a, const auto& b) {
                                     return std::bit_cast<std::array<std::uint32_t, 3>>(a) ==
                                            std::bit_cast<std::array<std::uint32_t, 3>>(b);
                                   }))
        << texels.width() << " x " << texels.height();
  }
}

// --- Light ---------------------------------------------------------------------------------------

/// 255 times sRGB's curve, in double precision.
double steps_of(float light) {
  const double x = std::clamp(static_cast<double>(light), 0.0, 1.0);
  return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * gradus::pow(x, 1 / 2.4) - 0.055);
}

/// Light of all sizes, and what lies about the places where the nearest byte is another one.
std::vector<float> light_about_steps(Random& random) {
  std::vector<float> light{0, -1, 1, 2, 1e30f, -0.0f, 0.0031308f, std::nextafter(1.0f, 0.0f)};
  for (int step = 0; step < 255; ++step) {
    const double curve = (step + 0.5) / 255;
    const auto at =
        static_cast<float>(curve <= 0.04045 ? curve / 12.92 : gradus::pow((curve + 0.055) / 1.055, 2.4));
    for (int off = -40; off <= 40; ++off)
      light.push_back(std::bit_cast<float>(std::bit_cast<std::int32_t>(at) + 64 * off));
  }
  for (int i = 0; i < 20000; ++i)
    light.push_back(static_cast<float>(gradus::pow(2.0, random.uniform(-20, 0.1))));
  while (light.size() % block_cells != 0) light.push_back(0);
  return light;
}

TEST(EngineBatches, GiveLightTheNearestByte) {
  Random random(test::seed());
  const std::vector<float> light = light_about_steps(random);
  const std::size_t count = light.size();
  // Each colour has the same numbers in another order
  std::vector<float> three = light;
  three.insert(three.end(), light.rbegin(), light.rend());
  three.insert(three.end(), light.begin(), light.end());
  std::optional<std::vector<std::uint32_t>> first;
  test::on_every_target([&] {
    std::vector<std::uint32_t> colours(count);
    pack(three, colours);
    if (!first) first = colours;
    ASSERT_EQ(colours, *first) << "the same on every machine";
    for (std::size_t i = 0; i < count; ++i) {
      const auto [r, g, b, a] = std::bit_cast<Rgba8>(colours[i]);
      const double error = std::abs(r - steps_of(light[i]));
      ASSERT_LE(error, 0.5 + 1.0 / 400) << light[i] << " gives " << int{r};
      ASSERT_LE(std::abs(g - steps_of(light[count - 1 - i])), 0.5 + 1.0 / 400);
      ASSERT_EQ(b, r);
      ASSERT_EQ(a, 255);
    }
  });
}

/// Grey light is computed once for its three colours.
TEST(EngineBatches, LightGreyAsTheRedOfColours) {
  for (int round = 0; round < rounds(24); ++round) {
    Random random(test::seed(), static_cast<std::uint64_t>(round));
    Scene grey = test::random_scene(random, 6);
    grey.shading = static_cast<Shading>(round % 3);
    grey.antialiasing = round % 2 == 0 ? Antialiasing::none : Antialiasing::adaptive;
    grey.background = LinearRgb{0.3f};
    Scene coloured = grey;
    for (std::size_t i = 0; i < grey.objects.size(); ++i) {
      Mesh mesh = *grey.objects[i].mesh;
      if (i == 0 && round % 4 == 3) mesh = test::textured(std::move(mesh), random);
      Material& material = mesh.materials[0];
      material.diffuse = LinearRgb{material.diffuse.r};
      grey.objects[i].mesh = std::make_shared<const Mesh>(mesh);
      material.diffuse.g /= 2;
      coloured.objects[i].mesh = std::make_shared<const Mesh>(std::move(mesh));
    }
    const auto picture = [](const Scene& scene) {
      Workspace workspace;
      return picture_of(scene, buffers_of(scene), plan_of(scene, size), workspace, 1).image;
    };
    test::on_every_target([&] {
      const Image a = picture(grey), b = picture(coloured);
      for (std::size_t i = 0; i < a.cells().size(); ++i) {
        const Rgba8 p = a.cells()[i];
        ASSERT_EQ(p.r, b.cells()[i].r) << "seed " << test::seed() << ", round " << round;
        ASSERT_TRUE(round % 4 == 3 || (p.g == p.r && p.b == p.r)) << "round " << round;
      }
    });
  }
}

TEST(EngineBatches, MakeTheSamePictureOnEveryMachine) {
  const std::uint64_t seed = test::seed();
  for (int round = 0; round < rounds(30); ++round) {
    Random random(seed, static_cast<std::uint64_t>(round));
    Scene scene = test::random_scene(random, 8);
    for (std::size_t i = 0; i < scene.objects.size(); i += 2) {
      Object& object = scene.objects[i];
      object.mesh = std::make_shared<const Mesh>(test::textured(*object.mesh, random));
    }
    scene.filter = round % 5 == 0 ? TextureFilter::bilinear : TextureFilter::mip_mapped;
    scene.shading = static_cast<Shading>(round % 3);
    scene.antialiasing = round % 2 == 0 ? Antialiasing::none : Antialiasing::adaptive;
    const Buffers buffers = buffers_of(scene);
    const Plan plan = plan_of(scene, size);
    Workspace workspace;
    std::optional<Image> first;
    test::on_every_target([&] {
      const Image image = picture_of(scene, buffers, plan, workspace, 1).image;
      if (!first) first = image;
      ASSERT_TRUE(image == *first) << "seed " << seed << ", round " << round;
    });
  }
}

}  // namespace
}  // namespace gradus::pipeline::engine::engine_batches_test
