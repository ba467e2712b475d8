// From boxes in space to a picture in perspective: by the z-buffer, whole or row by row, by a BSP tree and by
// the painter's orders, each with and without back faces, and the share of pixels on which it shows a wrong
// face.

#include <fmt/format.h>

#include <functional>
#include <memory>

#include "benchmark/subject.hpp"
#include "support/hidden_surfaces.hpp"
#include "visibility/painter/painter_notes.hpp"

namespace gradus::bench {
namespace {

using namespace test;

constexpr Camera camera{256, true};
/// Snapping moves edges by less: what lies closer to one is not judged.
constexpr long double margin = 1.0L / 64;

/// The workload of the chart of time against error.
constexpr const char* telling = "cyclic";

using Draw = std::function<Picture(const Polygons&)>;
using Tree = bsp_tree::Tree<double>;

/// The share of the covered pixels that show a wrong face, and their number.
Error error_of(const Raster<Verdict>& right, const Picture& shown) {
  std::int64_t covered = 0, wrong = 0;
  for (std::size_t i = 0; i < right.cells().size(); ++i) {
    const Verdict& verdict = right.cells()[i];
    covered += verdict.face != nobody;
    wrong += verdict.sure && shown.cells()[i] != verdict.face;
  }
  const double share = static_cast<double>(wrong) / static_cast<double>(covered);
  return {share, share, wrong};
}

Picture walked(const Tree& tree, bool culled) {
  Picture picture(camera.size, camera.size, nobody);
  bsp_tree::back_to_front(tree, camera.eye(), [&](const auto& part) {
    if (!culled || bsp_tree::side_of_eye(part.plane, camera.eye()) > 0) paint(picture, part, camera);
  });
  return picture;
}

/// Painted in the order in which a method gives the faces.
template <class Method>
Draw in_order(Method method) {
  return [method](const Polygons& scene) {
    Picture picture(camera.size, camera.size, nobody);
    method(scene, [&](const auto& face) { paint(picture, face, camera); });
    return picture;
  };
}

/// The same of the faces that show their front.
Draw culled(Draw draw) {
  return [draw = std::move(draw)](const Polygons& scene) { return draw(fronts(scene, camera)); };
}

void add_cases(std::vector<Case>& all, const Workload& workload, const Polygons& boxes) {
  const auto scene = std::make_shared<const Polygons>(boxes);
  const auto right = by_rays(boxes, camera, margin);
  const auto add = [&](const char* name, Standing standing, Draw draw) {
    const auto picture = std::make_shared<Picture>(draw(*scene));
    all.push_back({.method = name,
                   .standing = standing,
                   .workload = workload,
                   .items = std::ssize(*scene),
                   .run = [=] { *picture = draw(*scene); },
                   .error = error_of(right, *picture)});
  };
  const Draw z_buffer = [](const Polygons& faces) { return by_z_buffer(faces, camera); };
  const Draw rows = [](const Polygons& faces) { return by_scanline(faces, camera); };
  const Draw build = [](const Polygons& faces) { return walked(bsp_tree::build(faces), false); };
  const auto view = camera.view();
  const Draw newell = in_order([=](const auto& faces, auto draw) { painter::newell(faces, view, draw); });
  const Draw farthest =
      in_order([=](const auto& faces, auto draw) { painter::farthest_vertex(faces, view, draw); });
  const Draw centroid = in_order([=](const auto& faces, auto draw) { painter::centroid(faces, view, draw); });
  const auto tree = std::make_shared<const Tree>(bsp_tree::build(boxes));
  add("z_buffer", Standing::taught, z_buffer);
  add("z_buffer, culled", Standing::robust, culled(z_buffer));
  add("z_buffer by rows", Standing::robust, rows);
  add("bsp_tree built and walked", Standing::robust, build);
  add("bsp_tree walk", Standing::taught, [tree](const Polygons&) { return walked(*tree, false); });
  add("bsp_tree walk, culled", Standing::robust, [tree](const Polygons&) { return walked(*tree, true); });
  add("newell", Standing::taught, newell);
  add("newell, culled", Standing::robust, culled(newell));
  add("farthest_vertex", Standing::faulty, farthest);
  add("centroid", Standing::faulty, centroid);
  if (workload.name == telling) return;  // the chart has no room for more exhibits
  add("farthest_vertex, culled", Standing::faulty, culled(farthest));
  add("centroid, culled", Standing::faulty, culled(centroid));
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Kind kind : kinds) add_cases(all, {name_of(kind)}, boxes(kind));
  for (const int count : {6, 24, 96})
    add_cases(all, {fmt::format("{} faces", 6 * count), 6.0 * count}, small_boxes(count));
  return all;
}

}  // namespace

Subject hidden_surfaces() {
  return {.topic = "hidden_surfaces",
          .title = "Boxes without their hidden surfaces",
          .item = "face",
          .unit = "parts of the picture",
          .measure = "faces",
          .telling = telling,
          .cases = cases,
          .choice = {"z_buffer, culled", "no wrong pixel, nothing sorted and nothing cut"}};
}

}  // namespace gradus::bench
