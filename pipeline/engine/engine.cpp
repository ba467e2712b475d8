#include "engine/engine.hpp"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <memory>

#include "engine/geometry.hpp"
#include "engine/tiles.hpp"
#include "stages/8_output.hpp"
#include "stages/antialiasing.hpp"

namespace gradus::pipeline::engine {
namespace {

/// What every tile is given.
struct TileWork {
  const Scene& scene;
  const Buffers& buffers;
  const Plan& plan;
  const Frame& frame;
  Pattern pattern;  ///< of the scene's antialiasing
};

// --- From the centres of pixels ------------------------------------------------------------------

/// The surface of one triangle after the other.
class Surfaces {
 public:
  explicit Surfaces(const TileWork& work)
      : work_(work), light_(work.scene, work.plan.size, &work.plan, &work.buffers.textures) {}

  LinearRgb colour(std::int32_t id, ivec2 pixel) {
    if (id != id_) turn_to(id);
    const auto w = weights_at_place(edges_, triangle_coverage::centre_of(pixel));
    return shaded(light_, {triangle_.id, id, pixel, 0, shares_of(w, over_w_)}, triangle_).colour;
  }

 private:
  void turn_to(std::int32_t id) {
    id_ = id;
    triangle_ = whole_triangle(work_.scene, work_.frame, id);
    edges_ = triangle_coverage::edges_of(work_.frame.triangle(id).grid);
    over_w_ = over_w_of(triangle_);
  }

  const TileWork& work_;
  SceneLight light_;
  std::int32_t id_ = no_triangle;
  Triangle triangle_;
  triangle_coverage::Edges edges_;
  dvec3 over_w_{0};
};

void draw_centres(const TileWork& work, int tile, const Window& pixels, LightPicture& picture) {
  const auto buffer = std::make_unique<TileBuffer>(pixels);
  visit_tile(work.frame, tile, [&](std::int32_t id) { buffer->draw(work.frame.triangle(id), id); });
  Surfaces surfaces(work);
  for (int y = pixels.lower.y; y <= pixels.upper.y; ++y) {
    for (int x = pixels.lower.x; x <= pixels.upper.x; ++x) {
      const std::int32_t id = buffer->winner({x, y});
      if (id == no_triangle) continue;
      picture[ivec2{x, y} - work.plan.window.lower] = {dvec3(surfaces.colour(id, {x, y})), 1};
    }
  }
}

// --- Antialiased ---------------------------------------------------------------------------------

/// The triangles of a tile as a picture of their own, by the textbook's method.
void draw_antialiased(const TileWork& work, int tile, const Window& pixels, LightPicture& picture) {
  Triangles triangles;
  visit_tile(work.frame, tile,
             [&](std::int32_t id) { triangles.push_back(whole_triangle(work.scene, work.frame, id)); });
  const auto& [scene, buffers, plan, frame, pattern] = work;
  Shot shot{screen_triangles(triangles, plan.size),
            picture_window(plan.size),
            pixels,
            {scene, triangles, plan.size, &plan, &buffers.textures},
            scene.samples,
            scene.background,
            nullptr};
  const LightPicture part = by_method(shot, scene.antialiasing, pattern);
  for (int y = 0; y < part.height(); ++y)
    for (int x = 0; x < part.width(); ++x)
      picture[pixels.lower - work.plan.window.lower + ivec2{x, y}] = part[{x, y}];
}

}  // namespace

bool draws(const Scene& scene) {
  return scene.shading != Shading::wireframe && scene.hidden_surfaces == HiddenSurfaces::z_buffer;
}

LightPicture light_of(const Scene& scene, const Buffers& buffers, const Plan& plan, int threads) {
  expects(draws(scene), "the engine draws surfaces by the z-buffer alone");
  expects(threads >= 0, "so many threads work at once, or 0 for all, not {}", threads);
  check_samples(scene);
  LightPicture picture = empty_picture(plan.window);
  const int workers = threads == 0 ? tbb::this_task_arena::max_concurrency() : threads;
  // Also more than there are cores, where that is asked for
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(workers));
  tbb::task_arena arena(workers);
  arena.execute([&] {
    Frame frame = frame_of(scene, buffers, plan);
    const TileGrid grid(plan.window);
    bin(frame, grid, scene.antialiasing == Antialiasing::none ? Touch::centres : Touch::neighbours);
    const TileWork work{scene, buffers, plan, frame, pattern_of(scene.antialiasing, scene.samples)};
    tbb::parallel_for(0, grid.count(), [&](int tile) {
      const auto draw = scene.antialiasing == Antialiasing::none ? draw_centres : draw_antialiased;
      draw(work, tile, grid.tile(tile), picture);
    });
  });
  return picture;
}

Image render(const Scene& scene, Size size, int threads) {
  Scene centres = scene;
  centres.antialiasing = Antialiasing::none;
  const Plan plan = plan_of(centres, size);
  return output(over_background(light_of(centres, buffers_of(centres), plan, threads), scene.background));
}

}  // namespace gradus::pipeline::engine
