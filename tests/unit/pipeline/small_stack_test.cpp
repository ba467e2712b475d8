// Methods that walk trees, on a stack of 256 KiB: trees that are lists, as faces one behind another make
// them, end no program. A walk that called itself once per node would need some hundred bytes for each.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <pthread.h>

#include <concepts>
#include <cstddef>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "modeling/ear_clipping/many_corners.hpp"
#include "pipeline.hpp"
#include "scene/camera/framing.hpp"
#include "scene/models/obj.hpp"
#include "support/sanitized.hpp"
#include "visibility/bsp_tree/bsp_tree.hpp"
#include "visibility/octree_order/octree_order.hpp"
#include "visibility/painter/painter.hpp"

namespace gradus::pipeline::small_stack_test {
namespace {

/// Sanitizers make every call larger.
constexpr std::size_t stack = test::sanitized ? std::size_t{2} << 20 : std::size_t{256} << 10;

/// Runs on a thread with a small stack.
void run_on_small_stack(std::function<void()> run) {
  pthread_attr_t attributes;
  ASSERT_EQ(pthread_attr_init(&attributes), 0);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, stack), 0);
  const auto call = [](void* what) -> void* {
    (*static_cast<std::function<void()>*>(what))();
    return nullptr;
  };
  pthread_t thread;
  ASSERT_EQ(pthread_create(&thread, &attributes, call, &run), 0);
  ASSERT_EQ(pthread_join(thread, nullptr), 0);
  pthread_attr_destroy(&attributes);
}

constexpr std::size_t many = test::sanitized ? 200 : 1500;

/// Squares one behind another, each smaller than the one before it.
std::vector<WorldPolygon> nested_squares() {
  std::vector<WorldPolygon> squares;
  for (std::size_t i = 0; i < many; ++i) {
    const double size = 2 - 1e-4 * static_cast<double>(i), z = -5 - 1e-3 * static_cast<double>(i);
    squares.push_back({{{-size, -size, z}, {size, -size, z}, {size, size, z}, {-size, size, z}}, i});
  }
  return squares;
}

TEST(SmallStack, ATreeThatIsAListIsBuiltAndWalked) {
  run_on_small_stack([] {
    const auto tree = bsp_tree::build(nested_squares());
    ASSERT_EQ(tree.size(), many);
    for (const double side : {-9.0, 9.0}) {
      std::size_t drawn = 0;
      bsp_tree::back_to_front(tree, bsp_tree::Eye<double>{0, 0, side, 1}, [&](const WorldPolygon& p) {
        EXPECT_EQ(p.face, side > 0 ? many - 1 - drawn : drawn);
        ++drawn;
      });
      EXPECT_EQ(drawn, many);
    }
  });
}

TEST(SmallStack, AListOfVeryManyNodesIsWalked) {
  const std::size_t nodes = test::sanitized ? 50'000 : 300'000;
  bsp_tree::Tree<double> tree(nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    tree[i].plane = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    if (i + 1 < nodes) (i % 2 == 0 ? tree[i].in_front : tree[i].behind) = i + 1;
  }
  run_on_small_stack([&] {
    std::size_t visited = 0;
    const auto count = [&]<class Step>(const Step&) { visited += std::same_as<Step, bsp_tree::Visited>; };
    bsp_tree::back_to_front(tree, bsp_tree::Eye<double>{0, 0, 1, 1}, [](const auto&) {}, count);
    EXPECT_EQ(visited, nodes);
  });
}

TEST(SmallStack, ThePainterDrawsALongList) {
  run_on_small_stack([] {
    const auto view = painter::view_along({0, 0, 9, 1}, dvec3{0, 0, -1}, dvec3{0, 1, 0});
    const auto squares = nested_squares();
    std::size_t drawn = 0;
    const auto draw = [&](const WorldPolygon& p) { EXPECT_EQ(p.face, many - ++drawn); };
    painter::newell(squares, view, draw);
    EXPECT_EQ(drawn, many);
    // By planes alone
    drawn = 0;
    auto list = painter::pieces_of(squares, view);
    painter::draw_rest(list, view, draw, Unobserved{});
    EXPECT_EQ(drawn, many);
  });
}

TEST(SmallStack, AnOctreeIsCutToItsDeepestCells) {
  run_on_small_stack([] {
    const octree_order::Cell<double> root{{0, 0, 0}, 1};
    std::size_t leaves = 0;
    const auto about_zero = [](const auto& cell) { return cell.lower == dvec3(0); };
    for (const double w : {0.0, 1.0}) {
      const octree_order::Eye<double> eye{3, 2, 1, w};
      octree_order::front_to_back(root, eye, about_zero, [&](const auto&) { ++leaves; });
      octree_order::back_to_front(root, eye, about_zero, [&](const auto&) { ++leaves; });
    }
    EXPECT_EQ(leaves, 4U * (7 * octree_order::deepest + 1));
  });
}

TEST(SmallStack, ACombOfManyCornersIsCut) {
  std::vector<dvec2> comb{{0, -1}, {static_cast<double>(many), -1}};
  for (std::size_t i = many; i > 0; --i) {
    comb.emplace_back(static_cast<double>(i), 9);
    comb.emplace_back(static_cast<double>(i) - 0.5, 0);
  }
  run_on_small_stack([&] {
    std::size_t triangles = 0;
    ear_clipping::triangulate_many(std::span<const dvec2>(comb), [&](const auto&) { ++triangles; });
    EXPECT_EQ(triangles, comb.size() - 2);
  });
}

TEST(SmallStack, WholePicturesAreDrawn) {
  std::string model;
  for (int i = 0; i < 300; ++i) {
    const double z = 1e-3 * i;
    model += fmt::format("v -1 -1 {0}\nv 1 -1 {0}\nv 0 1 {0}\nf -3 -2 -1\n", z);
  }
  Scene scene = scene_of(parse_obj(model, "m.obj", [](const std::string&) { return std::nullopt; }).mesh, 1);
  scene.culling = Culling::none;
  const Image right = render(scene, {8, 8});
  for (const auto method : {HiddenSurfaces::painter, HiddenSurfaces::bsp_tree}) {
    scene.hidden_surfaces = method;
    run_on_small_stack([&] { EXPECT_EQ(render(scene, {8, 8}), right); });
  }
  scene.hidden_surfaces = HiddenSurfaces::z_buffer;
  scene.samples = 4;
  for (const auto method : {Antialiasing::area_sampling, Antialiasing::a_buffer, Antialiasing::adaptive,
                            Antialiasing::supersampling}) {
    scene.antialiasing = method;
    const Image there = render_antialiased(scene, {8, 8});
    run_on_small_stack([&] { EXPECT_EQ(render_antialiased(scene, {8, 8}), there); });
  }
}

}  // namespace
}  // namespace gradus::pipeline::small_stack_test
