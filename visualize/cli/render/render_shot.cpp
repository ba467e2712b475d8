#include "cli/render/render_shot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "cli/command_line/errors.hpp"
#include "cli/render/render_input.hpp"
#include "core/colour.hpp"
#include "engine/engine.hpp"
#include "pipeline.hpp"
#include "plan/levels.hpp"
#include "plan/planned.hpp"
#include "request/names.hpp"
#include "scene/camera/framing.hpp"
#include "scene/camera/turntable.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

std::string text_of(dvec3 v) { return fmt::format("{:.4g},{:.4g},{:.4g}", v.x, v.y, v.z); }

double aspect_of(const Wish& wish) { return static_cast<double>(wish.size.width) / wish.size.height; }

// --- The camera --------------------------------------------------------------------------------------------

/// Throws UsageError for flags that leave the picture undetermined.
void check_aim(const pipeline::Aim& aim, const pipeline::View& view) {
  if (!leads_somewhere(aim)) {
    if (view.target)
      refuse_flag("target", "another point than the eye " + text_of(aim.eye), text_of(aim.target));
    if (view.eye)
      refuse_flag("eye", "another point than the target, the middle of the model", text_of(aim.eye));
    throw UsageError(
        fmt::format("MODEL: expected points that are told apart from an eye beside them, found all near {}",
                    text_of(aim.target)));
  }
  if (!tells_upright(aim)) {
    refuse_flag("up",
                fmt::format("a direction that is not along the view from {} to {}", text_of(aim.eye),
                            text_of(aim.target)),
                text_of(aim.up));
  }
}

/// The same for a frame of a path.
void check_aim(const pipeline::Aim& aim, int frame) {
  if (!leads_somewhere(aim)) {
    refuse_flag("frames", "another point than the eye as the target of every frame",
                fmt::format("{} as both in frame {}", text_of(aim.eye), frame));
  }
  if (!tells_upright(aim)) {
    refuse_flag("frames", "a direction that is not along the view as what is up in every frame",
                fmt::format("{} in frame {}, which looks from {} to {}", text_of(aim.up), frame,
                            text_of(aim.eye), text_of(aim.target)));
  }
}

/// The path round what turns; where rays do not meet all its frames show as much.
void set_turning(const std::vector<pipeline::Object>& objects, Wish& wish) {
  const double aspect = aspect_of(wish);
  const pipeline::Aim aim = aim_of(objects, wish.view, aspect);
  check_aim(aim, wish.view);
  wish.path = turntable(objects, wish.view, aspect, *wish.turntable);
  if (has_eye(wish.view.projection) || wish.view.height) return;
  double height = 0;
  constexpr int most = 64;  // between so many frames the outline changes by less than the margin
  for (int frame = 0; frame <= wish.path->last; frame += 1 + wish.path->last / most) {
    const pipeline::View view = view_at(*wish.path, wish.view, frame);
    height = std::max(height, camera_of(aim_of(objects, view, aspect), view, objects, aspect).rays->height);
  }
  wish.view.height = height;
}

/// A view whose target is told, so that no frame has to look for the middle of all.
void tell_target(const std::vector<pipeline::Object>& objects, Wish& wish) {
  if (!wish.path || !wish.path->target.empty()) return;
  wish.view.target =
      aim_of(objects, view_at(*wish.path, wish.view, wish.path->first), aspect_of(wish)).target;
}

// --- The scene ---------------------------------------------------------------------------------------------

/// Without a camera and, unless they are told, without lights.
pipeline::Scene scene_for(pipeline::Scene scene, const Wish& wish) {
  if (wish.light) {
    Light lamp;
    lamp.position = *wish.light;
    lamp.intensity = LinearRgb{0.85f};
    scene.lights = {lamp};
  }
  if (wish.background) scene.background = linear_from_srgb8(*wish.background);
  scene.hidden_surfaces = wish.surfaces.hidden;
  scene.culling = wish.surfaces.culling;
  scene.shading = wish.surfaces.shading;
  if (wish.filter) scene.filter = *wish.filter;
  scene.antialiasing = wish.antialiasing;
  scene.samples = wish.samples;
  return scene;
}

std::string contents_of(const pipeline::Scene& scene, bool is_scene) {
  std::int64_t faces = 0, triangles = 0;
  for (const pipeline::Object& object : scene.objects) {
    faces += std::ssize(object.mesh->faces);
    triangles += triangle_count(*object.mesh);
  }
  return fmt::format("{}{}, {}", is_scene ? counted(std::ssize(scene.objects), "object") + ", " : "",
                     counted(faces, "face"), counted(triangles, "triangle"));
}

/// The first method of antialiasing that draws opacities.
std::string_view method_for_opacity() {
  const auto draws = [](std::string_view name) {
    const auto at = std::ranges::find(pipeline::antialiasing_names, name);
    pipeline::Scene scene;
    scene.antialiasing = static_cast<pipeline::Antialiasing>(at - pipeline::antialiasing_names.begin());
    return draws_opacity(scene);
  };
  return *std::ranges::find_if(pipeline::antialiasing_names, draws);
}

/// What a method of antialiasing can't draw.
std::optional<std::string> opacity_remark(const pipeline::Scene& scene) {
  const bool drawn = draws_opacity(scene) || scene.shading == pipeline::Shading::wireframe;
  if (drawn || !std::ranges::any_of(scene.objects, &pipeline::Object::see_through)) return std::nullopt;
  return fmt::format("render: what lets light through is drawn opaque; --aa {} draws it by its opacity",
                     method_for_opacity());
}

}  // namespace

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

pipeline::View view_of_frame(const Shot& shot, int frame) {
  pipeline::View view = view_at(*shot.wish.path, shot.wish.view, frame);
  check_aim(aim_of(shot.scene.objects, view, aspect_of(shot.wish)), frame);
  return view;
}

pipeline::SceneCamera camera_of(const Shot& shot, const pipeline::View& view) {
  const auto& depths = shot.wish.depths;
  const double aspect = aspect_of(shot.wish);
  const pipeline::Aim aim = aim_of(shot.scene.objects, view, aspect);
  pipeline::SceneCamera camera = camera_of(aim, view, shot.scene.objects, aspect);
  if (!depths) return camera;
  camera.lens.near = depths->x, camera.lens.far = depths->y;
  if (camera.rays) camera.rays->near = depths->x, camera.rays->far = depths->y;
  return camera;
}

Colophon colophon_of(const Shot& shot, const std::optional<FrameRange>& frames, dvec3 eye) {
  const std::string what = !frames            ? "rendered"
                           : frames->is_one() ? "frame " + text_of(*frames)
                                              : "frames " + text_of(*frames);
  const auto [width, height] = shown_size(shot.wish);
  return {fmt::format("{}, {}", shot.name, what),
          fmt::format("{}: {}, seen from {}, {} x {} pixels.", shot.name, shot.contents, text_of(eye), width,
                      height),
          fmt::format("gradus render {}{}{}{}", shell_quoted(shot.operand), shot.wish.said,
                      frames ? " --frames " + text_of(*frames) : "", shot.wish.plan.said),
          shot.brief.colophon.input_hash};
}

namespace {

/// Subdivides control meshes as finely as the nearest of the shot's pictures needs it.
template <class SeenAt>
void subdivide_for(Shot& shot, const SeenAt& seen_at) {
  const auto is_control_mesh = [](const pipeline::Object& object) { return object.subdivision.has_value(); };
  if (!std::ranges::any_of(shot.scene.objects, is_control_mesh)) return;
  std::vector<pipeline::SceneCamera> cameras{shot.scene.camera};
  if (shot.wish.frames) {
    for (int frame = shot.wish.frames->first; frame <= shot.wish.frames->last; ++frame)
      cameras.push_back(camera_of(shot, seen_at(frame)));
  }
  pipeline::subdivide(shot.scene, cameras, shot.wish.size);
}

}  // namespace

Shot read_shot(const Request& request, const FindFile& find) {
  Shot shot;
  shot.wish = read_wish(request.flags);
  RenderInput input = pipeline::timed(seconds_now, shot.reading, [&] {
    return read_render_input(request.operands.at(0), find, shot.wish.filter.has_value());
  });
  // The first reading has found what is wrong with the flags alone
  if (input.is_scene) shot.wish = read_wish(request.flags, input.scene);
  Wish& wish = shot.wish;
  wish.plan = plan_wish(request.flags, wish.size);
  check_projection(request.flags, wish.view.projection);
  if (wish.turntable) set_turning(input.scene.scene.objects, wish);
  if (wish.frames) check_frames(*wish.frames, wish.path, input.name);
  shot.operand = input.name;
  shot.name = input.name == dash ? input.is_scene ? "a scene" : "a model" : input.name;
  shot.contents = contents_of(input.scene.scene, input.is_scene);
  const auto [width, height] = shown_size(wish);
  shot.brief = {{}, input.files, input.quotable, first_notes(input.scene.notes), width, height};
  shot.brief.colophon.input_hash = input.hashes;
  shot.scene = scene_for(std::move(input.scene.scene), wish);
  if (const auto remark = opacity_remark(shot.scene)) shot.brief.remarks.push_back(*remark);
  tell_target(shot.scene.objects, wish);
  if (!wish.path) check_aim(aim_of(shot.scene.objects, wish.view, aspect_of(wish)), wish.view);
  const auto seen_at = [&](int frame) { return wish.path ? view_of_frame(shot, frame) : wish.view; };
  const int first = wish.path ? wish.path->first : 0, shown = wish.frames ? wish.frames->first : first;
  if (!input.scene.lights_told && !wish.light) {
    shot.lights_go_along = wish.turntable.has_value();
    const int lit = shot.lights_go_along ? shown : first;
    shot.scene.lights = pipeline::default_lights(camera_of(shot, seen_at(lit)));
  }
  shot.scene.camera = camera_of(shot, seen_at(shown));
  subdivide_for(shot, seen_at);
  shot.brief.colophon = colophon_of(shot, wish.frames, shot.scene.camera.frame.eye);
  return shot;
}

ShotArtist::ShotArtist(const Shot& shot, std::size_t threads)
    : shot_(shot), threads_(static_cast<int>(threads)) {
  if (shot.wish.surfaces.by == DrawnBy::fast && pipeline::engine::draws(shot.scene))
    buffers_ =
        pipeline::timed(seconds_now, preparing_, [&] { return pipeline::engine::buffers_of(shot.scene); });
}

std::string_view ShotArtist::drawn_by() const {
  if (!buffers_) return "the textbook chain";
  const bool single = !shot_.wish.transparent && pipeline::engine::draws_in_single_precision(shot_.scene);
  return single ? "the engine, in single precision" : "the engine, in double precision";
}

Picture ShotArtist::paint(const pipeline::Scene& scene, pipeline::Ledger& ledger,
                          const std::function<void(double)>& reached) const {
  const Wish& wish = shot_.wish;
  pipeline::Plan plan = pipeline::timed(seconds_now, ledger.planning, [&] {
    return pipeline::plan_of(scene, wish.size, wish.plan.rules, wish.plan.part);
  });
  const pipeline::engine::EngineWatch watch{&ledger, seconds_now, reached};
  if (buffers_ && !wish.transparent) {
    pipeline::engine::Workspace workspace;
    auto [image, covered] = pipeline::engine::picture_of(scene, *buffers_, plan, workspace, threads_, watch);
    return {std::move(image), covered};
  }
  const pipeline::LightPicture light =
      buffers_ ? pipeline::engine::light_of(scene, *buffers_, plan, threads_, watch)
               : antialiased_by_plan(scene, plan, ledger, seconds_now, reached);
  const auto shows_model = [](const pipeline::PixelLight& pixel) { return pixel.share > 0; };
  Image image = pipeline::timed(seconds_now, ledger.writing, [&] {
    return wish.transparent ? with_alpha(light) : pipeline::output(over_background(light, scene.background));
  });
  return {std::move(image), std::ranges::count_if(light.cells(), shows_model)};
}

}  // namespace gradus::cli
