// Random rectangles of several sizes and numbers through the z-buffer: depths as doubles, floats, 24-bit
// codes and reversed floats, face by face and row by row.

#include "visibility/z_buffer/z_buffer.hpp"

#include <fmt/format.h>

#include <memory>

#include "benchmark/subject.hpp"
#include "core/random.hpp"

namespace gradus::bench {
namespace {

using namespace z_buffer;

constexpr int width = 256;
/// Far enough for formats to differ: 24 bits are 0.06 apart.
constexpr Range range{-100, 1e6};

/// So many rectangles of a side of about `side` pixels.
struct Workload {
  const char* name;
  int count, side;
};
constexpr Workload workloads[]{{"few large", 16, 200}, {"many small", 2048, 6}, {"heavy overdraw", 256, 160}};

struct Scene {
  std::vector<std::array<dvec3, 4>> corners;
  std::vector<Face> faces;
  Raster<Cell<double, Id>> right{width, width};
  std::int64_t covered = 0;

  explicit Scene(const Workload& work) : corners(static_cast<std::size_t>(work.count)) {
    Random random(7);
    for (auto& c : corners) {
      const double x = random.uniform(0, width - work.side), y = random.uniform(0, width - work.side);
      const double z = random.uniform(1, 900), slope = random.uniform(-0.2, 0.2), side = work.side;
      c = {dvec3{x, y, z},
           {x + side, y, z + side * slope},
           {x + side, y + side, z + side * slope},
           {x, y + side, z}};
      faces.push_back({c, {0, static_cast<int>(faces.size())}});
    }
    const auto count = [this]<class Step>(const Step& step) {
      if constexpr (std::same_as<Step, Finished>) covered = step.compared;
    };
    per_polygon<double>(faces, right, Exactly{}, count);
  }
};

/// The case of a walk that leaves the face of each pixel; wrong decisions are pixels of another face than
/// with depths as they are.
template <class Draw>
Case case_of(const Workload& work, const std::shared_ptr<Scene>& scene, std::string name, Standing standing,
             Draw draw) {
  const auto ids = std::make_shared<Raster<Id>>(width, width);
  const auto run = [=] { draw(*scene, *ids); };
  run();
  Error::Sum sum;
  for (int y = 0; y < width; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto& cell = scene->right[{x, y}];
      if (!cell.taken) continue;
      const Id shown = (*ids)[{x, y}];
      const auto plane = plane_of(scene->faces[static_cast<std::size_t>(shown.face)]);
      sum.add(plane->at({x, y}) - cell.depth);
      if (cell.key != shown) sum.wrong_decision();
    }
  }
  return {.method = std::move(name),
          .standing = standing,
          .workload = {work.name, static_cast<double>(scene->covered)},
          .items = scene->covered,
          .run = run,
          .error = sum.error()};
}

template <class T>
auto walk(auto store) {
  return [store](const Scene& scene, Raster<Id>& ids) {
    Raster<Cell<T, Id>> buffer(width, width);
    per_polygon<T>(scene.faces, buffer, store);
    for (std::size_t i = 0; i < buffer.cells().size(); ++i) ids.cells()[i] = buffer.cells()[i].key;
  };
}
void rows(const Scene& scene, Raster<Id>& ids) {
  std::vector<Cell<double, Id>> line(width);
  scanline<double>(scene.faces, ids.window(), std::span(line), Exactly{},
                   [&](ivec2 p, Id id) { ids[p] = id; });
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Workload& work : workloads) {
    const auto scene = std::make_shared<Scene>(work);
    all.push_back(case_of(work, scene, "per_polygon", Standing::taught, walk<double>(Exactly{})));
    all.push_back(case_of(work, scene, "float", Standing::robust, walk<float>(AsFloat{range})));
    all.push_back(case_of(work, scene, "fixed24", Standing::robust, walk<std::int32_t>(AsFixed24{range})));
    all.push_back(
        case_of(work, scene, "reversed_float", Standing::robust, walk<float>(AsReversedFloat{range})));
    all.push_back(case_of(work, scene, "scanline", Standing::robust, rows));
  }
  return all;
}

}  // namespace

Subject z_buffer() {
  return {.topic = "z_buffer",
          .title = "Faces through the z-buffer",
          .item = "covered pixel",
          .unit = "units of depth",
          .measure = "covered pixels",
          .telling = "heavy overdraw",
          .cases = cases,
          .choice = {"per_polygon", "no wrong pixel; scanline has its picture with one row of depths"}};
}

}  // namespace gradus::bench
