#include "why/why.hpp"

#include <algorithm>
#include <utility>

#include "core/contract.hpp"
#include "plan/planned.hpp"
#include "stages/arrangement.hpp"

namespace gradus::pipeline {
namespace {

/// Keeps what is told of some pieces, and nothing else.
class PieceWatcher {
 public:
  explicit PieceWatcher(std::map<PieceId, FragmentStory>& stories) : stories_(stories) {
    for (const auto& [id, story] : stories) faces_.insert({{id.object, id.face}, {}});
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
    const auto story = stories_.find(id);
    if (story != stories_.end()) what(story->second);
  }

  std::map<PieceId, FragmentStory>& stories_;
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
  const auto seen = to_clip(scene, size, world, watcher);
  told(seen);
  const auto facing = cull(scene, seen, watcher);
  Triangles triangles = clip(world, facing, size, watcher);
  return scene.shading == Shading::wireframe ? outlines(facing, size) : triangles;
}

/// Keeps where triangles stand in the picture.
struct SnapWatcher {
  std::vector<Snapped>& snapped;

  void operator()(const Snapped& step) { snapped.push_back(step); }
  void operator()(const Covered&) {}
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

/// The objects whose boxes may cover a window; all of them where triangles have a drawing order.
std::vector<int> objects_near(const Scene& scene, Size size, const Window& window) {
  const bool ordered = scene.hidden_surfaces != HiddenSurfaces::z_buffer;
  const Rules rules =
      ordered ? Rules::none() : Rules::none().with(Rule::outside).with(Rule::area_of_interest);
  const Plan plan = plan_of(scene, size, rules, window);
  std::vector<int> numbers;
  for (int number = 0; number < std::ssize(scene.objects); ++number)
    if (plan.draws(number)) numbers.push_back(number);
  return numbers;
}

/// A window of the antialiased picture.
Image in_the_picture(const Scene& scene, Size size, const Window& window,
                     const std::function<void(double)>& reached) {
  Plan plan = plan_of(scene, size, Rules::all(), window);
  Ledger ledger;
  return output(over_background(antialiased_by_plan(scene, plan, ledger, {}, reached), scene.background));
}

/// The triangles of some objects, as stage 6 gets them.
Triangles triangles_of(const Scene& scene, Size size, const std::vector<int>& objects) {
  Triangles triangles;
  for (int number : objects)
    append(triangles, stages_of(scene, number, size, Unobserved{}, [](const auto&) {}));
  if (scene.shading != Shading::wireframe) arrange(scene, {}, size, triangles);
  return triangles;
}

}  // namespace

PixelStories::PixelStories(const Scene& scene, Size size, const Window& window,
                           const std::function<void(double)>& reached)
    : scene_(scene), size_(size), window_(window), light_(scene, size) {
  expects(!window.empty() && picture_window(size).contains(window.lower) &&
              picture_window(size).contains(window.upper),
          "pixels of {} x {}, not those from ({}, {}) to ({}, {})", size.width, size.height, window.lower.x,
          window.lower.y, window.upper.x, window.upper.y);
  const std::vector<int> objects = objects_near(scene, size, window);
  triangles_ = triangles_of(scene, size, objects);
  find_fragments();
  find_pieces(objects);
  picture_ = in_the_picture(scene, size, window, reached);
}

/// Who covers the pixels?
void PixelStories::find_fragments() {
  fragments_ =
      Raster<std::vector<Fragment>>(static_cast<int>(window_.width()), static_cast<int>(window_.height()));
  const auto keep = [&](const Fragment& f) {
    if (window_.contains(f.pixel)) fragments_[f.pixel - window_.lower].push_back(f);
  };
  rasterize(triangles_, size_, keep, SnapWatcher{snapped_});
}

/// How did they come there?
void PixelStories::find_pieces(const std::vector<int>& objects) {
  for (const std::vector<Fragment>& fragments : fragments_.cells())
    for (const Fragment& f : fragments) pieces_[f.id];
  for (int number : objects) {
    PieceWatcher watcher(pieces_);
    stages_of(scene_, number, size_, watcher, [&](const Model<ClipPoint>& model) { watcher.finish(model); });
  }
}

/// The surfaces that are seen at a pixel's centre: peeled off with the z-buffer of one pixel, as long as they
/// let light through.
std::vector<Layer> PixelStories::layers_of(ivec2 pixel) {
  std::vector<Layer> layers;
  std::vector<Fragment> left = fragments_[pixel - window_.lower];
  double through = 1;
  while (through > 0 && !left.empty()) {
    Visible kept(1, 1);
    for (Fragment f : left) {
      f.pixel = {0, 0};
      keep_nearest(f, kept);
    }
    Fragment seen = kept[{0, 0}].key.fragment;
    seen.pixel = pixel;
    std::erase_if(left, [&](const Fragment& f) { return f.triangle == seen.triangle; });
    const Triangle& t = triangle_of(seen, triangles_);
    Layer layer{shaded(light_, seen, t), {}};
    layer.lamps = lamps_of(scene_, light_, seen, t, {layer.shaded.place.at, layer.shaded.normal});
    if (draws_opacity(scene_)) layer.opacity = double{light_.material(seen).opacity};
    layer.share = through * layer.opacity;
    through *= 1 - layer.opacity;
    layers.push_back(std::move(layer));
  }
  return layers;
}

PixelStory PixelStories::of(ivec2 pixel) {
  expects(window_.contains(pixel), "a pixel from ({}, {}) to ({}, {}), not ({}, {})", window_.lower.x,
          window_.lower.y, window_.upper.x, window_.upper.y, pixel.x, pixel.y);
  PixelStory story;
  story.pixel = pixel;
  // The z-buffer of one pixel
  Visible kept(1, 1);
  for (Fragment f : fragments_[pixel - window_.lower]) {
    FragmentStory fragment = pieces_.at(f.id);
    fragment.snapped = snapped_[static_cast<std::size_t>(f.triangle)];
    f.pixel = {0, 0};
    keep_nearest(f, kept, [&](const DepthTested& step) { fragment.tested = step; });
    fragment.tested.fragment.pixel = pixel;
    if (fragment.tested.before) fragment.tested.before->pixel = pixel;
    story.fragments.push_back(std::move(fragment));
  }
  story.layers = layers_of(pixel);
  dvec3 light{0};
  for (const Layer& layer : story.layers) {
    light += layer.share * dvec3(layer.shaded.colour);
    story.background *= 1 - layer.opacity;
    for (FragmentStory& fragment : story.fragments)
      if (fragment.tested.fragment.triangle == layer.shaded.fragment.triangle) fragment.share = layer.share;
  }
  if (story.background > 0) light += story.background * dvec3(scene_.background);
  const LinearRgb colour(light);
  story.written = {pixel, colour, srgb8_from_linear(colour), too_bright(colour)};
  story.picture = picture_[pixel - window_.lower];
  return story;
}

const FragmentStory& fragment_of(const PixelStory& story, const Layer& layer) {
  return *std::ranges::find_if(story.fragments, [&](const FragmentStory& fragment) {
    return fragment.tested.fragment.triangle == layer.shaded.fragment.triangle;
  });
}

PixelStory why(const Scene& scene, Size size, ivec2 pixel) {
  return PixelStories(scene, size, {pixel, pixel}).of(pixel);
}

std::int64_t lamps_told(const Scene& scene) {
  if (scene.shading == Shading::wireframe) return 0;
  std::int64_t lamps = 0;
  for (const Light& light : scene.lights) lamps += illumination::lamps(light);
  return lamps * (scene.shading == Shading::gouraud ? 3 : 1);
}

std::string file_of(const Scene& scene, const FaceRead& face) {
  const Mesh& mesh = *object_at(scene, face.object).mesh;
  return face.file < 0 ? "" : mesh.files[static_cast<std::size_t>(face.file)];
}

}  // namespace gradus::pipeline
