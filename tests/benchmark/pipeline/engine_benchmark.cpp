// The engine beside Mesa's llvmpipe: the same meshes, camera, light and shader, each from static buffers into
// a picture of its own.

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "benchmark/pipeline/engine_scenes.hpp"
#include "benchmark/pipeline/llvmpipe.hpp"
#include "benchmark/subject.hpp"
#include "engine/engine.hpp"

namespace gradus::bench {
namespace {

using namespace pipeline;
using engine_scenes::light;
using engine_scenes::SceneMaker;
using engine_scenes::workloads;

// --- Measuring -----------------------------------------------------------------------------------

constexpr Size sizes[]{{512, 512}, {1920, 1080}};
constexpr Shading shadings[]{Shading::gouraud, Shading::phong};
constexpr int thread_counts[]{1, 2};

/// Milliseconds per call: the median of the repetitions.
template <class Run>
double milliseconds(const Effort& effort, const Run& run) {
  using Clock = std::chrono::steady_clock;
  run();
  std::vector<double> times;
  for (int i = 0; i < effort.repetitions; ++i) {
    int calls = 0;
    const auto start = Clock::now();
    double seconds = 0;
    do {
      run();
      ++calls;
      seconds = std::chrono::duration<double>(Clock::now() - start).count();
    } while (seconds < effort.seconds);
    times.push_back(1000 * seconds / calls);
  }
  std::ranges::sort(times);
  return times[times.size() / 2];
}

struct Drawn {
  double ms = 0;
  Image image{};
  std::string by{};
};

Drawn by_engine(const Scene& scene, Size size, int threads, const Effort& effort) {
  const engine::Buffers buffers = engine::buffers_of(scene);
  const Plan plan = plan_of(scene, size);
  engine::Workspace workspace;
  engine::Picture picture;
  const double ms =
      milliseconds(effort, [&] { engine::draw_into(picture, scene, buffers, plan, workspace, threads); });
  return {ms, std::move(picture.image)};
}

#ifdef GRADUS_HAS_OSMESA
void write_all(int to, const void* from, std::size_t bytes) {
  for (const auto* at = static_cast<const char*>(from); bytes > 0;) {
    const ssize_t written = write(to, at, bytes);
    if (written <= 0) _exit(1);
    at += written;
    bytes -= static_cast<std::size_t>(written);
  }
}
bool read_all(int from, void* to, std::size_t bytes) {
  for (auto* at = static_cast<char*>(to); bytes > 0;) {
    const ssize_t got = read(from, at, bytes);
    if (got <= 0) return false;
    at += got;
    bytes -= static_cast<std::size_t>(got);
  }
  return true;
}

/// In a process of its own: llvmpipe counts its threads once in each. threads: LP_NUM_THREADS.
std::optional<Drawn> by_llvmpipe(const Scene& scene, Size size, int threads, const Effort& effort) {
  int ends[2];
  if (pipe(ends) != 0) return std::nullopt;
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    try {
      peers::Llvmpipe peer(scene, size, threads);
      const double ms = milliseconds(effort, [&] { peer.draw(); });
      std::array<char, 128> by{};
      peers::Llvmpipe::renderer().copy(by.data(), by.size() - 1);
      const Image image = peer.picture();
      write_all(ends[1], &ms, sizeof ms);
      write_all(ends[1], by.data(), by.size());
      write_all(ends[1], image.cells().data(), image.cells().size_bytes());
    } catch (...) {
      _exit(1);
    }
    _exit(0);
  }
  close(ends[1]);
  Drawn drawn{0, Image(size.width, size.height)};
  std::array<char, 128> by{};
  const bool whole = read_all(ends[0], &drawn.ms, sizeof drawn.ms) &&
                     read_all(ends[0], by.data(), by.size()) &&
                     read_all(ends[0], drawn.image.cells().data(), drawn.image.cells().size_bytes());
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  drawn.by = by.data();
  return whole && status == 0 ? std::optional(std::move(drawn)) : std::nullopt;
}

/// At its best: one thread that does it all; or as many that fill pixels beside the one that asks, or one
/// less.
std::optional<Drawn> by_peer(const Scene& scene, Size size, int threads, const Effort& effort) {
  if (threads == 1) return by_llvmpipe(scene, size, 0, effort);
  auto drawn = by_llvmpipe(scene, size, threads, effort);
  auto with_less = by_llvmpipe(scene, size, threads - 1, effort);
  return drawn && with_less && with_less->ms < drawn->ms ? std::move(with_less) : std::move(drawn);
}
#else
std::optional<Drawn> by_peer(const Scene&, Size, int, const Effort&) { return std::nullopt; }
#endif

void compare(const Image& a, const Image& b, Duel& duel) {
  for (std::size_t i = 0; i < a.cells().size(); ++i) {
    const Rgba8 p = a.cells()[i], q = b.cells()[i];
    const int off = std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
    duel.max_pixel_difference = std::max(duel.max_pixel_difference, off);
    duel.pixels_off += off > 1;
  }
}

std::vector<Duel> duels(const Effort& effort, const std::function<void()>& told, std::string& peer) {
  std::vector<Duel> all;
  for (const SceneMaker& workload : workloads()) {
    for (const Size size : sizes) {
      Scene scene = workload.scene(static_cast<double>(size.width) / size.height);
      scene.antialiasing = Antialiasing::none;
      light(scene);
      for (const Shading shading : shadings) {
        scene.shading = shading;
        for (const int threads : thread_counts) {
          const Drawn own = by_engine(scene, size, threads, effort);
          Duel duel{fmt::format("{}, {}, {} x {}, {} thread{}", workload.name,
                                shading_names[static_cast<std::size_t>(shading)], size.width, size.height,
                                threads, threads == 1 ? "" : "s"),
                    own.ms};
          if (const auto drawn = by_peer(scene, size, threads, effort)) {
            duel.peer_ms = drawn->ms;
            peer = drawn->by;
            compare(own.image, drawn->image, duel);
          }
          all.push_back(std::move(duel));
          told();
        }
      }
    }
  }
  return all;
}

}  // namespace

Subject engine() {
  return {
      .topic = "engine",
      .title = "A picture",
      .item = "picture",
      .duels = duels,
      .duel_count = std::size(sizes) * std::size(shadings) * std::size(thread_counts) * workloads().size(),
#ifdef GRADUS_HAS_OSMESA
      .peer_is_built = true
#endif
  };
}

}  // namespace gradus::bench
