#include "stories/pipeline/textbook_chain/run.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <type_traits>

#include "core/arithmetic/exact_scalar.hpp"
#include "projection/viewing/viewing.hpp"
#include "scene/camera/framing.hpp"
#include "stories/given_model.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::textbook_chain {
namespace {

using namespace pipeline;

constexpr double radians_a_degree = 3.141592653589793 / 180;

/// Whether the project's own model is shown, named or not.
bool shows_own_model(const Arguments& arguments) {
  return !names_a_model(arguments) || arguments.entry("model").content == shipped_model(own_model);
}

/// The camera that is placed for the model, or the one that looks where the arguments say.
struct Sight {
  std::optional<dvec3> eye, target;
};

/// Along the roof of the project's own model, which begins behind the near plane: it is cut outside the
/// picture.
constexpr Sight along_the_roof{dvec3{-2.5, 6.2, 5.4}, dvec3{2, 0.9, -0.7}};
constexpr double near_the_roof = 4.3;

/// Over the lawn beside the house, which begins behind the eye.
constexpr Sight beside_the_house{dvec3{-2, 2.8, 3}, dvec3{2.5, 1.4, 0.4}};

/// Before the front: in the default picture the upright edges beside the window run through pixel centres.
constexpr Sight before_the_front{dvec3{0, 1.5, 12.5899}, dvec3{0, 1.5, 0}};

/// From where the house shows most of the run.
Sight sight_of_the_house(Fault fault) {
  if (fault == Fault::closed_half_planes) return before_the_front;
  return fault == Fault::cull_after_division ? beside_the_house : along_the_roof;
}

/// From beside the model past its front, so near that parts of it lie behind the eye.
Sight near_sight(const Scene& scene) {
  const Bounds bounds = bounds_of(scene);
  const double r = bounds.radius();
  return {bounds.centre() + r * dvec3{-0.8, -0.03, 0.46}, bounds.centre() + r * dvec3{-0.4, -0.56, 0}};
}

Camera camera_of(const Scene& scene, const Arguments& arguments, double aspect, Fault fault) {
  const Object& object = scene.objects[0];
  std::vector<dvec3> points;
  for (const Corner& corner : object.mesh->corners) {
    points.push_back(affine_3d::transform(object.placement, position_of(*object.mesh, corner)));
  }
  const double fov = arguments.number("fov").value_or(40) * radians_a_degree;
  Camera camera = framed(std::span<const dvec3>(points), aspect, viewing_side(object), fov);
  Sight sight{arguments.place("eye"), arguments.place("target")};
  const bool placed = !sight.eye && !sight.target, own = shows_own_model(arguments);
  if (own) {
    const Sight shown = sight_of_the_house(fault);
    sight = {sight.eye ? sight.eye : shown.eye, sight.target ? sight.target : shown.target};
  } else if (fault == Fault::cull_after_division && placed) {
    sight = near_sight(scene);
  }
  const auto& [eye, target] = sight;
  if (eye || target) {
    const Bounds bounds = bounds_of(scene);
    const dvec3 from = eye.value_or(camera.frame.eye), to = target.value_or(bounds.centre());
    if (from == to)
      refuse(arguments, {"eye", "target"}, "expected an eye apart from the target, found both in one place");
    const bool upright = length_of(glm::cross(unit_vector(to - from), dvec3{0, 1, 0})) < 1e-6;
    camera.frame = viewing::look_at(from, to, upright ? dvec3{0, 0, -1} : dvec3{0, 1, 0});
    camera = with_depths(camera, bounds);
  }
  if (sight.eye == along_the_roof.eye && placed && own) camera.lens.near = near_the_roof;
  const auto near = arguments.number("near");
  if (near && !(0 < *near && *near < camera.lens.far)) {
    refuse("near", "expected a depth above 0 and before the far plane at {:.4g}, found {}", camera.lens.far,
           arguments.text("near"));
  }
  if (near) camera.lens.near = *near;
  return camera;
}

/// The side of every piece, exactly.
std::vector<back_face_culling::Facing> exact_facing(const Run& run) {
  std::vector<back_face_culling::Facing> sides;
  const auto at = [&](const PieceCorner& corner) {
    return run.clip[static_cast<std::size_t>(corner.vertex)].clip.at;
  };
  for (const Piece& piece : run.pieces) {
    const auto& [a, b, c] = piece.corners;
    sides.push_back(back_face_culling::facing(at(a), at(b), at(c)));
  }
  return sides;
}

/// What the run covers wrongly, triangle by triangle, and what it leaves out.
std::vector<Misjudged> misjudged_in(const Run& run) {
  std::vector<Misjudged> found;
  const auto before = [](ivec2 a, ivec2 b) { return a.y < b.y || (a.y == b.y && a.x < b.x); };
  for (const Snapped& triangle : run.snapped) {
    if (!triangle.drawn) continue;
    std::vector<ivec2> right, covered, differ;  // row by row
    triangle_coverage::cover(on_grid(triangle.corners), picture_window(run.size),
                             [&](ivec2 p, const auto&) { right.push_back(p); });
    for (const Fragment& f : run.covered) {
      if (f.triangle == triangle.triangle) covered.push_back(f.pixel);
    }
    std::ranges::set_symmetric_difference(right, covered, std::back_inserter(differ), before);
    for (const ivec2 p : differ) {
      const bool extra = std::ranges::binary_search(covered, p, before);
      found.push_back({triangle.id, triangle.triangle, p, extra});
    }
  }
  return found;
}

/// The line of a test that `call` makes with an observer.
template <class Step, class Call>
int line_of(const Call& call) {
  int reported = 0;
  call([&]<class S>(const S&, int line = __builtin_LINE(), const char* = nullptr) {
    if constexpr (std::is_same_v<S, Step>) reported = line;
  });
  return reported;
}

/// The line of the faulty stage's own test, where the stage tells its steps.
void set_faulty_line(Run& run) {
  namespace coverage = triangle_coverage;
  const coverage::Triangle triangle{ivec2{0, 0}, {0, 512}, {512, 0}};
  const Window window{{0, 0}, {0, 0}};
  const auto drop = [](ivec2, const coverage::Weights&) {};
  switch (run.fault) {
    case Fault::none:
      return;
    case Fault::cull_after_division:
      run.lines["Faced"] = line_of<back_face_culling::Tested<double>>([](auto&& observer) {
        back_face_culling::facing_after_division(glm::dvec4{1}, glm::dvec4{1}, glm::dvec4{1}, observer);
      });
      return;
    case Fault::closed_half_planes:
      run.lines["Covered"] = line_of<coverage::Tested>(
          [&](auto&& observer) { coverage::closed_half_planes(triangle, window, drop, observer); });
      return;
    case Fault::expanded_edges:
      run.lines["Covered"] = line_of<coverage::Tested>(
          [&](auto&& observer) { coverage::expanded_edges(triangle, {0, 0}, window, drop, observer); });
      return;
  }
}

/// How good a piece is to follow: clipped and seen, nearer than others where it is seen, much seen, much
/// covered.
struct Worth {
  bool cut_and_seen = false;
  std::size_t nearer = 0, seen = 0, covered = 0;
  auto operator<=>(const Worth&) const = default;
};

/// By piece.
std::vector<Worth> worths_of(const Run& run) {
  std::vector<Worth> worths(run.pieces.size());
  std::map<PieceId, std::size_t> places;
  for (std::size_t i = 0; i < run.pieces.size(); ++i) places.emplace(run.pieces[i].id, i);
  const auto worth_of = [&](PieceId id) -> Worth& { return worths[places.at(id)]; };
  for (const Fragment& f : run.covered) ++worth_of(f.id).covered;
  for (const Shaded& s : run.shaded) ++worth_of(s.fragment.id).seen;
  for (const DepthTested& t : run.tests) {
    const Shaded* shown = run.shaded_at(t.fragment.pixel);
    worth_of(t.fragment.id).nearer += t.before && t.nearer && shown && shown->fragment.id == t.fragment.id;
  }
  for (const Clipped& c : run.clipped) worth_of(c.id).cut_and_seen = c.changed && worth_of(c.id).seen > 0;
  return worths;
}

std::size_t piece_to_follow(const Run& run, std::optional<std::int64_t> face) {
  std::size_t best = run.pieces.size();
  for (std::size_t i = 0; i < run.pieces.size(); ++i) {
    if (face && run.pieces[i].id.face != *face) continue;
    if (run.wrongly_faced(i)) return i;
    if (!run.misjudged.empty() && run.misjudged[0].id == run.pieces[i].id) return i;
  }
  const std::vector<Worth> worths = worths_of(run);
  for (std::size_t i = 0; i < run.pieces.size(); ++i) {
    if (face && run.pieces[i].id.face != *face) continue;
    if (best == run.pieces.size() || worths[i] > worths[best]) best = i;
  }
  return best;
}

/// The piece's pixel where most fragments meet; among several one where it is seen, then the one in their
/// middle.
ivec2 pixel_to_follow(const Run& run, PieceId id) {
  const auto wrong = std::ranges::find(run.misjudged, id, &Misjudged::id);
  if (wrong != run.misjudged.end()) return wrong->pixel;
  std::vector<ivec2> own;
  for (const Fragment& f : run.covered) {
    if (f.id == id) own.push_back(f.pixel);
  }
  if (own.empty()) return {run.size.width / 2, run.size.height / 2};
  const auto meetings = [&](ivec2 pixel) {
    const Shaded* shaded = run.shaded_at(pixel);
    const auto met =
        std::ranges::count_if(run.tests, [&](const DepthTested& t) { return t.fragment.pixel == pixel; });
    return std::pair{shaded && shaded->fragment.id == id, met};
  };
  std::pair<bool, std::ptrdiff_t> most{};
  std::vector<ivec2> best;
  for (const ivec2 pixel : own) {
    const auto met = meetings(pixel);
    if (best.empty() || met > most) best.clear();
    if (best.empty()) most = met;
    if (met == most) best.push_back(pixel);
  }
  ivec2 sum{0};
  for (const ivec2 pixel : best) sum += pixel;
  const int count = static_cast<int>(best.size());
  return *std::ranges::min_element(best, {}, [&](ivec2 pixel) {
    const ivec2 off = pixel * count - sum;
    return std::int64_t{off.x} * off.x + std::int64_t{off.y} * off.y;
  });
}

}  // namespace

bool Run::wrongly_faced(std::size_t piece) const {
  return !right_facing.empty() && right_facing[piece] != faced[piece].facing;
}

const Clipped* Run::clipped_of(PieceId id) const {
  const auto found = std::ranges::find(clipped, id, &Clipped::id);
  return found == clipped.end() ? nullptr : &*found;
}

const Shaded* Run::shaded_at(ivec2 pixel) const {
  const auto found = shaded_places.find(key_of(pixel));
  return found == shaded_places.end() ? nullptr : &shaded[found->second];
}

Scene scene_of(const Arguments& arguments, Fault fault) {
  Mesh mesh = given_model(arguments, own_model);
  if (const std::int64_t count = triangle_count(mesh); count > most_triangles) {
    refuse("model",
           "expected a small model of at most {} triangles, for each is drawn "
           "at every stage, found {} (`gradus render` draws large ones)",
           most_triangles, count);
  }
  const double aspect =
      static_cast<double>(arguments.integer("columns")) / static_cast<double>(arguments.integer("rows"));
  Scene scene = pipeline::scene_of(std::move(mesh), aspect);
  const auto turn = static_cast<double>(arguments.integer("turn"));
  if (turn != 0) scene.objects[0].placement = affine_3d::rotation({0, 1, 0}, turn * radians_a_degree);
  scene.camera = camera_of(scene, arguments, aspect, fault);
  scene.lights = default_lights(scene.camera);
  return scene;
}

Run run_of(Scene scene, Size size, Fault fault) {
  Recorder<VertexRead, FaceRead, Placed, Turned, Projected, Faced, Clipped, Snapped, Covered, DepthTested,
           Shaded, Written>
  record(std::size_t{10'000'000});
  Run run;
  run.fault = fault;
  run.image = render_with(fault, scene, size, record);
  run.scene = std::move(scene);
  run.size = size;
  run.read = all<VertexRead>(record);
  run.faces = all<FaceRead>(record);
  for (const FaceRead& face : run.faces)
    run.pieces.insert(run.pieces.end(), face.pieces.begin(), face.pieces.end());
  run.placed = all<Placed>(record);
  run.clip = all<Projected>(record);
  run.faced = all<Faced>(record);
  run.clipped = all<Clipped>(record);
  run.snapped = all<Snapped>(record);
  const double radius = bounds_of(run.scene).radius(), away = length_of(run.scene.camera.frame.eye);
  run.noise = 1e-9 * std::max(radius, away);
  for (const Covered& covered : all<Covered>(record)) run.covered.push_back(covered.fragment);
  run.tests = all<DepthTested>(record);
  run.shaded = all<Shaded>(record);
  for (std::size_t i = 0; i < run.shaded.size(); ++i)
    run.shaded_places.emplace(key_of(run.shaded[i].fragment.pixel), i);
  run.written = all<Written>(record);
  constexpr std::array types{"VertexRead", "FaceRead", "Placed",  "Turned",      "Projected", "Faced",
                             "Clipped",    "Snapped",  "Covered", "DepthTested", "Shaded",    "Written"};
  for (const auto& event : record.events()) run.lines.emplace(types[event.step.index()], event.line);
  set_faulty_line(run);
  if (fault == Fault::cull_after_division) run.right_facing = exact_facing(run);
  if (fault == Fault::closed_half_planes || fault == Fault::expanded_edges) run.misjudged = misjudged_in(run);
  return run;
}

Followed followed_in(const Run& run, const Arguments& arguments) {
  const auto given = [&](const char* name) { return arguments.has(name) && !arguments.text(name).empty(); };
  std::optional<std::int64_t> face;
  if (given("face")) face = arguments.integer("face");
  if (face && *face >= std::ssize(run.faces)) {
    refuse("face", "expected a face from 0 to {}, found {}", run.faces.size() - 1, *face);
  }
  std::optional<ivec2> pixel;
  if (given("pixel")) pixel = arguments.cell("pixel");
  if (pixel && !run.image.contains(*pixel)) {
    refuse("pixel", "expected a pixel inside the {} × {} picture, found {}", run.size.width, run.size.height,
           arguments.text("pixel"));
  }
  Followed followed;
  const Shaded* shown = pixel && !face ? run.shaded_at(*pixel) : nullptr;
  followed.piece =
      shown ? static_cast<std::size_t>(std::ranges::find(run.pieces, shown->fragment.id, &Piece::id) -
                                       run.pieces.begin())
            : piece_to_follow(run, face);
  if (followed.piece == run.pieces.size()) {
    refuse("face", "expected a face with an area, found {}", *face);
  }
  followed.pixel = pixel ? *pixel : pixel_to_follow(run, run.pieces[followed.piece].id);
  if (const Shaded* seen = run.shaded_at(followed.pixel)) followed.seen = seen->fragment.id.face;
  return followed;
}

double exact_determinant(const std::array<glm::dvec4, 3>& corners) {
  const ExactScope scope;
  std::array<glm::vec<3, Exact>, 3> c;
  for (std::size_t i = 0; i < 3; ++i) c[i] = {Exact(corners[i].x), Exact(corners[i].y), Exact(corners[i].w)};
  return to_double(glm::dot(c[0], glm::cross(c[1], c[2])));
}

}  // namespace gradus::textbook_chain
