#include "engine/engine.hpp"

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "antialiasing/adaptive/sample_places.hpp"
#include "engine/account.hpp"
#include "engine/cores.hpp"
#include "engine/geometry.hpp"
#include "engine/light_bytes.hpp"
#include "engine/pixel_colours.hpp"
#include "engine/samples_batch.hpp"
#include "engine/shading.hpp"
#include "engine/surfaces.hpp"
#include "engine/tile_shader.hpp"
#include "engine/tiles.hpp"
#include "engine/visibility_batch.hpp"
#include "plan/planned.hpp"
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

/// Sums up what tiles have done, on any thread.
class Done {
 public:
  Done(int tiles, const EngineWatch& watch) : tiles_(tiles), watch_(watch) {}

  void tile() {
    const int done = ++done_;
    if (watch_.reached) watch_.reached(static_cast<double>(done) / tiles_);
  }
  void add(const ShadingCount& count) {
    const std::scoped_lock lock(mutex_);
    count_.add(count);
  }
  const ShadingCount& count() const { return count_; }

 private:
  int tiles_;
  const EngineWatch& watch_;
  std::atomic<int> done_ = 0;
  std::mutex mutex_;
  ShadingCount count_{};
};

// --- From the centres of pixels ------------------------------------------------------------------

void draw_centres(const TileWork& work, int tile, const Window& pixels, LightPicture& picture, Done& done) {
  const auto buffer = std::make_unique<TileBuffer>();
  find_nearest(work.frame, tile, pixels, *buffer);
  Surfaces surfaces(work.scene, work.buffers, work.plan, work.frame);
  for (int y = pixels.lower.y; y <= pixels.upper.y; ++y) {
    for (int x = pixels.lower.x; x <= pixels.upper.x; ++x) {
      const std::int32_t id = buffer->ids[TileBuffer::cell(ivec2{x, y} - pixels.lower)];
      if (id == no_triangle) continue;
      picture[ivec2{x, y} - work.plan.window.lower] = {dvec3(surfaces.colour(id, {x, y})), 1};
    }
  }
  done.add(surfaces.count());
}

// --- Antialiased ---------------------------------------------------------------------------------

/// The triangles that may touch a tile, in the order of stage 5.
std::vector<std::int32_t> in_order_of_scene(const Frame& frame, int tile) {
  std::vector<std::int32_t> ids;
  visit_tile(frame, tile, [&](std::int32_t id) { ids.push_back(id); });
  std::ranges::stable_sort(ids, {},
                           [&](std::int32_t id) { return frame.object_of(frame.triangle(id)).number; });
  return ids;
}

/// The triangles of a tile as a picture of their own, by the textbook's method.
void draw_antialiased(const TileWork& work, int tile, const Window& pixels, LightPicture& picture,
                      Done& done) {
  Triangles triangles;
  for (const std::int32_t id : in_order_of_scene(work.frame, tile))
    triangles.push_back(whole_triangle(work.scene, work.frame, id));
  const auto& [scene, buffers, plan, frame, pattern] = work;
  Shot shot{screen_triangles(triangles, plan.size),
            picture_window(plan.size),
            pixels,
            {scene, triangles, plan.size, &plan, &buffers.textures, PixelColours()},
            scene.samples,
            scene.background,
            nullptr};
  const LightPicture part = by_method(shot, scene.antialiasing, pattern);
  done.add(shot.colour.count());
  for (int y = 0; y < part.height(); ++y)
    for (int x = 0; x < part.width(); ++x)
      picture[pixels.lower - work.plan.window.lower + ivec2{x, y}] = part[{x, y}];
}

// --- In single precision -------------------------------------------------------------------------

/// Draws tiles on one thread.
class Artist {
 public:
  explicit Artist(const FrameShading& shading)
      : frame_(shading.frame()),
        buffer_(std::make_unique<TileBuffer>()),
        shader_(std::make_unique<TileShader>(shading)) {}

  /// places: of the samples of a pixel; none: their centres.
  std::int64_t draw(const TileGrid& grid, int tile, std::span<const ivec2> places, Image& image) {
    const Window pixels = grid.tile(tile);
    if (is_empty(frame_, tile)) {
      clear(grid, tile, image);
      return 0;
    }
    if (places.empty()) {
      find_nearest(frame_, tile, pixels, *buffer_);
      return shader_->colour(pixels, *buffer_, image);
    }
    if (!samples_) samples_ = std::make_unique<SampleBuffer>();
    find_samples(frame_, tile, pixels, places, *samples_);
    return shader_->mix(pixels, *samples_, places, image);
  }
  ShadingCount count() const { return shader_->count(); }

 private:
  /// Empty tiles side by side are cleared at once, with the first of them: long rows come sooner from memory.
  void clear(const TileGrid& grid, int tile, Image& image) const {
    const int column = tile % grid.columns(), row_end = tile - column + grid.columns();
    if (column > 0 && is_empty(frame_, tile - 1)) return;
    int last = tile;
    while (last + 1 < row_end && is_empty(frame_, last + 1)) ++last;
    shader_->clear({grid.tile(tile).lower, grid.tile(last).upper}, image);
  }

  const Frame& frame_;
  std::unique_ptr<TileBuffer> buffer_;
  std::unique_ptr<SampleBuffer> samples_;
  std::unique_ptr<TileShader> shader_;
};

/// The samples of `adaptive`, those nearest to the pixel's centre first, of equals in their order.
std::vector<ivec2> places_of(int samples) {
  const std::vector<ivec2> places = adaptive::n_rooks(samples);
  std::vector<std::pair<int, std::size_t>> order;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const ivec2 from_centre = places[i] - triangle_coverage::subpixels / 2;
    order.emplace_back(from_centre.x * from_centre.x + from_centre.y * from_centre.y, i);
  }
  std::ranges::sort(order);
  std::vector<ivec2> sorted;
  for (const auto& [square, i] : order) sorted.push_back(places[i]);
  return sorted;
}

// --- Both ----------------------------------------------------------------------------------------

void check(const Scene& scene, int threads) {
  expects(draws(scene), "the engine draws surfaces by the z-buffer alone");
  expects(threads >= 0, "so many threads work at once, or 0 for all, not {}", threads);
  check_samples(scene);
}

/// Stage 8 row by row, on the threads of the arena that it is called in.
Picture output_on_threads(const LightPicture& light, const LinearRgb& background) {
  static const LightBytes bytes;
  Picture picture{Image(light.width(), light.height()), 0};
  std::atomic<std::int64_t> covered = 0;
  for_each_of(light.height(), [&](int y) {
    std::int64_t shown = 0;
    for (int x = 0; x < light.width(); ++x) {
      const PixelLight& pixel = light[ivec2{x, y}];
      picture.image[ivec2{x, y}] = bytes(over(pixel, background));
      shown += pixel.share > 0;
    }
    covered += shown;
  });
  picture.covered = covered;
  return picture;
}

/// An image of a window's size, whose pixels may be any.
void make_room(Image& image, const Window& window) {
  const auto width = static_cast<int>(window.width()), height = static_cast<int>(window.height());
  if (image.width() != width || image.height() != height) image = Image(width, height);
}

/// Everything but the pixels.
TileGrid make_tiles(const Scene& scene, const Buffers& buffers, const Plan& plan, Touch touch, Frame& frame) {
  make_frame(scene, buffers, plan, touch, frame);
  const TileGrid grid(plan.window);
  bin(frame, grid, touch);
  return grid;
}

/// Makes the tiles of a picture, and draws each: draw(grid).
template <class Draw>
void draw_picture(const Scene& scene, const Buffers& buffers, const Plan& plan, Touch touch, Frame& frame,
                  const EngineWatch& watch, const Draw& draw) {
  Ledger none;
  Ledger& ledger = watch.ledger ? *watch.ledger : none;
  const TileGrid grid =
      timed(watch.clock, ledger.geometry, [&] { return make_tiles(scene, buffers, plan, touch, frame); });
  Done done(grid.count(), watch);
  timed(watch.clock, ledger.pixels, [&] {
    draw(grid, done);
    return 0;
  });
  if (!watch.ledger) return;
  count_geometry(scene, plan, frame, ledger);
  count_pixels(done.count(), plan, ledger);
}

}  // namespace

bool draws(const Scene& scene) {
  return scene.shading != Shading::wireframe && scene.hidden_surfaces == HiddenSurfaces::z_buffer;
}

bool draws_in_single_precision(const Scene& scene) {
  const bool method =
      scene.antialiasing == Antialiasing::none ||
      (scene.antialiasing == Antialiasing::adaptive && scene.samples <= static_cast<int>(most_samples));
  return method && suits_single_precision(scene);
}

LightPicture light_of(const Scene& scene, const Buffers& buffers, const Plan& plan, int threads,
                      const EngineWatch& watch) {
  check(scene, threads);
  LightPicture picture = empty_picture(plan.window);
  Frame frame;
  on_threads(threads, [&] {
    const bool centres = scene.antialiasing == Antialiasing::none;
    const TileWork work{scene, buffers, plan, frame, pattern_of(scene.antialiasing, scene.samples)};
    const Touch touch = centres ? Touch::centres : Touch::neighbours;
    draw_picture(scene, buffers, plan, touch, frame, watch, [&](const TileGrid& grid, Done& done) {
      for_each_of(grid.count(), [&](int tile) {
        (centres ? draw_centres : draw_antialiased)(work, tile, grid.tile(tile), picture, done);
        done.tile();
      });
    });
  });
  return picture;
}

Workspace::Workspace() : frame_(std::make_unique<Frame>()) {}
Workspace::~Workspace() = default;
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace& Workspace::operator=(Workspace&&) noexcept = default;

void draw_into(Picture& picture, const Scene& scene, const Buffers& buffers, const Plan& plan,
               Workspace& workspace, int threads, const EngineWatch& watch) {
  if (!draws_in_single_precision(scene)) {
    const LightPicture light = light_of(scene, buffers, plan, threads, watch);
    on_threads(threads, [&] { picture = output_on_threads(light, scene.background); });
    return;
  }
  check(scene, threads);
  make_room(picture.image, plan.window);
  std::atomic<std::int64_t> covered = 0;
  Frame& frame = workspace.frame();
  const bool samples = scene.antialiasing == Antialiasing::adaptive;
  const std::vector<ivec2> places = samples ? places_of(scene.samples) : std::vector<ivec2>{};
  const Touch touch = samples ? Touch::neighbours : Touch::centres;
  on_threads(threads, [&] {
    draw_picture(scene, buffers, plan, touch, frame, watch, [&](const TileGrid& grid, Done& done) {
      const FrameShading shading(scene, buffers, plan, frame);
      OfEachThread<Artist> artists([&] { return Artist(shading); });
      for_each_of(grid.count(), [&](int tile) {
        covered += artists.local().draw(grid, tile, places, picture.image);
        done.tile();
      });
      for (const Artist& artist : artists) done.add(artist.count());
    });
  });
  picture.covered = covered;
}

Picture picture_of(const Scene& scene, const Buffers& buffers, const Plan& plan, Workspace& workspace,
                   int threads, const EngineWatch& watch) {
  Picture picture;
  draw_into(picture, scene, buffers, plan, workspace, threads, watch);
  return picture;
}

Image render(const Scene& scene, Size size, int threads) {
  Scene centres = scene;
  centres.antialiasing = Antialiasing::none;
  Workspace workspace;
  return picture_of(centres, buffers_of(centres), plan_of(centres, size), workspace, threads).image;
}

}  // namespace gradus::pipeline::engine
