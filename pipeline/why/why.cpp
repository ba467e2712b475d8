#include "why/why.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "core/contract.hpp"
#include "plan/planned.hpp"
#include "stages/arrangement.hpp"

namespace gradus::pipeline {
namespace {

/// Which triangle of which object.
using Key = std::tuple<int, int, int>;
Key key_of(PieceId id) { return {id.object, id.face, id.piece}; }

/// Keeps what is told of some pieces, and nothing else.
class PieceWatcher {
 public:
  explicit PieceWatcher(std::map<Key, FragmentStory>& stories) : stories_(stories) {
    for (const auto& [key, story] : stories) faces_.insert({{std::get<0>(key), std::get<1>(key)}, {}});
  }

  void operator()(const FaceRead& step) {
    const auto face = faces_.find({step.object, step.face});
    if (face != faces_.end()) face->second = step;
  }
  void operator()(const Placed& step) { placed_.insert({step.id, step}); }
  void operator()(const Projected& step) { projected_.insert({step.id, step}); }
  void operator()(const Turned& step) {
    tell(step.id, [&](FragmentStory& s) { s.mirrored = step.mirrored; });
  }
  void operator()(const Faced& step) {
    tell(step.id, [&](FragmentStory& s) { s.faced = step; });
  }
  void operator()(const Clipped& step) {
    tell(step.id, [&](FragmentStory& s) { s.clipped = step; });
  }
  template <class Step>
  void operator()(const Step&) {}

  /// Gives each story its face, and its corners the vertices they are.
  void finish(const Model<ClipPoint>& model) {
    for (const Piece& piece : model.pieces) {
      tell(piece.id, [&](FragmentStory& story) {
        story.face = faces_.at({piece.id.object, piece.id.face});
        for (std::size_t i = 0; i < 3; ++i) {
          const VertexId id = model.vertices[static_cast<std::size_t>(piece.corners[i].vertex)].id;
          story.corners[i] = {placed_.at(id), projected_.at(id)};
        }
      });
    }
  }

 private:
  template <class Tell>
  void tell(PieceId id, const Tell& what) {
    const auto story = stories_.find(key_of(id));
    if (story != stories_.end()) what(story->second);
  }

  std::map<Key, FragmentStory>& stories_;
  std::map<std::pair<int, int>, FaceRead> faces_;
  std::map<VertexId, Placed> placed_;
  std::map<VertexId, Projected> projected_;
};

/// Stages 1 to 5 for an object, watched or not. geometry: told of what stage 4 is given.
template <class Watcher, class Told>
Triangles stages_of(const Scene& scene, int number, Size size, Watcher&& watcher, const Told& told) {
  Model<ObjectPoint> model;
  bring_in(*object_at(scene, number).mesh, number, model, watcher);
  const auto world = to_world(scene, std::move(model), watcher);
  const auto seen = to_clip(scene.camera, static_cast<double>(size.width) / size.height, world, watcher);
  told(seen);
  const auto facing = remove_back_faces(scene, seen, watcher);
  Triangles triangles = clip(world, facing, size, watcher);
  return scene.shading == Shading::wireframe ? outlines(facing, size) : triangles;
}

/// What stages 6 and 7 tell of one pixel.
class PixelWatcher {
 public:
  explicit PixelWatcher(ivec2 pixel) : pixel_(pixel) {}

  void operator()(const Snapped& step) { last_ = step; }
  void operator()(const Covered& step) {
    if (step.fragment.pixel == pixel_) snapped.insert({step.fragment.triangle, *last_});
  }
  void operator()(const DepthTested& step) { tests.push_back(step); }

  std::map<int, Snapped> snapped{};  ///< by triangle
  std::vector<DepthTested> tests{};

 private:
  ivec2 pixel_;
  std::optional<Snapped> last_{};
};

/// Keeps what each lamp adds.
class LampWatcher {
 public:
  LampWatcher(std::vector<LampStory>& lamps, const Surface& surface) : lamps_(lamps), surface_(surface) {}

  void operator()(const illumination::LightAdded<double>& step) {
    lamps_.push_back({surface_.place, surface_.normal, step});
  }
  template <class Step>
  void operator()(const Step&) {}

 private:
  std::vector<LampStory>& lamps_;
  Surface surface_;
};

std::vector<LampStory> lamps_of(const Scene& scene, const SceneLight& light, const Fragment& f,
                                const Triangle& t, const Surface& here) {
  std::vector<LampStory> lamps;
  for (const Surface& surface : light.surfaces_lit(f, t, here)) {
    illumination::phong(surface.place, surface.normal, viewer_of(scene.camera, surface.place),
                        light.material(f), std::span<const Light>(scene.lights), scene.ambient,
                        illumination::AllSeen{}, LampWatcher(lamps, surface));
  }
  return lamps;
}

/// The pixel of the antialiased picture.
Rgba8 in_the_picture(const Scene& scene, Size size, ivec2 pixel) {
  Plan plan = plan_of(scene, size, Rules::all(), Window{pixel, pixel});
  Ledger ledger;
  return output(over_background(antialiased_by_plan(scene, plan, ledger), scene.background))[{0, 0}];
}

/// The objects whose boxes may cover the pixel; all of them where triangles have a drawing order.
std::vector<int> objects_near(const Scene& scene, Size size, ivec2 pixel) {
  const bool ordered = scene.hidden_surfaces != HiddenSurfaces::z_buffer;
  const Rules rules =
      ordered ? Rules::none() : Rules::none().with(Rule::outside).with(Rule::area_of_interest);
  const Plan plan = plan_of(scene, size, rules, Window{pixel, pixel});
  std::vector<int> numbers;
  for (int number = 0; number < std::ssize(scene.objects); ++number)
    if (plan.draws(number)) numbers.push_back(number);
  return numbers;
}

}  // namespace

PixelStory why(const Scene& scene, Size size, ivec2 pixel) {
  expects(picture_window(size).contains(pixel), "a pixel of {} x {}, not ({}, {})", size.width, size.height,
          pixel.x, pixel.y);
  const std::vector<int> objects = objects_near(scene, size, pixel);
  Triangles triangles;
  for (int number : objects)
    append(triangles, stages_of(scene, number, size, Unobserved{}, [](const auto&) {}));
  if (scene.shading != Shading::wireframe) arrange(scene, {}, size, triangles);

  // Who covers the pixel?
  PixelWatcher watcher(pixel);
  Visible kept(size.width, size.height);
  const auto emit = [&](const Fragment& f) {
    if (f.pixel == pixel) keep_nearest(f, kept, watcher);
  };
  rasterize(triangles, size, emit, watcher);

  // How did they come there?
  std::map<Key, FragmentStory> stories;
  for (const DepthTested& test : watcher.tests) stories[key_of(test.fragment.id)];
  for (int number : objects) {
    PieceWatcher pieces(stories);
    stages_of(scene, number, size, pieces, [&](const Model<ClipPoint>& model) { pieces.finish(model); });
  }

  PixelStory story;
  story.pixel = pixel;
  for (const DepthTested& test : watcher.tests) {
    FragmentStory fragment = stories[key_of(test.fragment.id)];
    fragment.snapped = watcher.snapped.at(test.fragment.triangle);
    fragment.tested = test;
    story.fragments.push_back(std::move(fragment));
  }
  LinearRgb colour = scene.background;
  if (const auto seen = held(kept[pixel])) {
    SceneLight light(scene, size);
    const Triangle& t = triangle_of(*seen, triangles);
    story.shaded = shaded(light, *seen, t);
    story.lamps = lamps_of(scene, light, *seen, t, {story.shaded->place.at, story.shaded->normal});
    colour = story.shaded->colour;
  }
  story.written = {pixel, colour, srgb8_from_linear(colour), too_bright(colour)};
  story.picture = in_the_picture(scene, size, pixel);
  return story;
}

std::string file_of(const Scene& scene, const FaceRead& face) {
  const Mesh& mesh = *object_at(scene, face.object).mesh;
  return face.file < 0 ? "" : mesh.files[static_cast<std::size_t>(face.file)];
}

}  // namespace gradus::pipeline
