// `gradus render`: a picture of a model or a scene, by the textbook chain.

#include "cli/render.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <utility>

#include "cairo/image_file.hpp"
#include "cli/errors.hpp"
#include "cli/explain.hpp"
#include "cli/files.hpp"
#include "cli/names.hpp"
#include "cli/picture_page.hpp"
#include "cli/progress.hpp"
#include "cli/render_choices.hpp"
#include "cli/render_input.hpp"
#include "cli/why.hpp"
#include "core/colour.hpp"
#include "pipeline.hpp"
#include "plan/planned.hpp"
#include "scene/framing.hpp"
#include "scene/scene_file.hpp"
#include "scene/view.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

namespace fs = std::filesystem;

// --- The flags ---------------------------------------------------------------------------------------------

constexpr std::int64_t most_pixels_a_side = 8192, most_pixels = 1 << 25;
constexpr double least_degrees = 0.001, most_degrees = 179.999;
constexpr double largest_coordinate = 1e30;  // as in models
constexpr std::int64_t most_samples = 256;

/// What the flags say.
struct Wish {
  pipeline::Size size;
  pipeline::View view;
  std::optional<dvec3> light;
  std::optional<dvec2> depths;  ///< of the near and the far plane
  std::optional<Rgba8> background;
  bool transparent = false;
  DrawnSurfaces surfaces;
  std::optional<pipeline::TextureFilter> filter =
      pipeline::TextureFilter::mip_mapped;  ///< nothing: no textures
  pipeline::Antialiasing antialiasing = pipeline::default_antialiasing;
  int samples = pipeline::default_samples;
  PlanWish plan;
  std::string said;  ///< the flags in their canonical spelling, " --size 640x480"
};

std::optional<Number> number_in(std::string_view text) {
  const Read<Number> read = read_number(text);
  const Number* number = std::get_if<Number>(&read);
  return number ? std::optional(*number) : std::nullopt;
}

/// "3,2,4" or "(3, 2, 4)".
std::optional<std::array<Number, 3>> triple_in(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('(') && text.ends_with(')')) text = text.substr(1, text.size() - 2);
  const std::size_t first = text.find(','), second = text.find(',', std::min(first, text.size() - 1) + 1);
  if (second == std::string_view::npos || first == second) return std::nullopt;
  const auto x = number_in(text.substr(0, first)), y = number_in(text.substr(first + 1, second - first - 1)),
             z = number_in(text.substr(second + 1));
  if (!x || !y || !z) return std::nullopt;
  return std::array{*x, *y, *z};
}

/// Reads the flags one after the other, and writes down what they say.
class WishReader {
 public:
  explicit WishReader(const std::map<std::string, std::string>& flags) : flags_(flags) {}
  /// Flags that change what a scene's file says: each counts, also where it says what is the default
  /// elsewhere.
  WishReader(const std::map<std::string, std::string>& flags, Wish of_file)
      : flags_(flags), over_file_(true), wish_(std::move(of_file)) {}

  Wish read() {
    read_size();
    read_vector("eye", wish_.view.eye);
    read_vector("target", wish_.view.target);
    read_vector("up", wish_.view.up);
    if (wish_.view.up == dvec3{0}) refuse_flag("up", "a direction like 0,1,0", "0,0,0");
    const SayFlag note = [this](auto flag, auto value, bool is_default) { say(flag, value, is_default); };
    read_projection(flags_, note, wish_.view);
    read_fov();
    read_vector("light", wish_.light);
    read_background();
    read_surfaces(flags_, note, wish_.surfaces);
    read_filter();
    read_antialiasing();
    read_samples();
    return std::move(wish_);
  }

 private:
  const std::string* given(const std::string& flag) const { return cli::given(flags_, flag); }

  void say(std::string_view flag, std::string_view value, bool is_default = false) {
    if (over_file_ || !is_default) wish_.said += fmt::format(" --{} {}", flag, shell_quoted(value));
  }

  void read_size() {
    const std::string* text = given("size");
    if (!text) return;
    const std::string word = folded(trimmed(*text));
    const std::size_t cross = std::min(word.find('x'), word.size());
    const auto width = whole_number(word.substr(0, cross)),
               height = whole_number(word.substr(std::min(cross + 1, word.size())));
    const auto fits = [](const auto& side) { return side && 1 <= *side && *side <= most_pixels_a_side; };
    if (!fits(width) || !fits(height)) {
      refuse_flag("size",
                  fmt::format("a width and a height like 800x600, of 1 to {} pixels", most_pixels_a_side),
                  shown(*text));
    }
    if (*width * *height > most_pixels) {
      refuse_flag("size", fmt::format("at most {} pixels in all", most_pixels),
                  fmt::format("{} with {}", shown(*text), *width * *height));
    }
    wish_.size = {static_cast<int>(*width), static_cast<int>(*height)};
    const std::string canonical = fmt::format("{}x{}", *width, *height);
    say("size", canonical, canonical == "800x600");
  }

  void read_vector(const std::string& flag, std::optional<dvec3>& into) {
    const std::string* text = given(flag);
    if (!text) return;
    const auto numbers = triple_in(*text);
    const auto fits = [](const Number& n) { return std::abs(n.value) <= largest_coordinate; };
    if (!numbers || !std::ranges::all_of(*numbers, fits)) {
      refuse_flag(flag, "three numbers like 3,2,4, none larger than 1e30", shown(*text));
    }
    const auto& [x, y, z] = *numbers;
    say(flag, fmt::format("{},{},{}", x.text, y.text, z.text));
    into = dvec3{x.value, y.value, z.value};
  }

  void read_fov() {
    const std::string* text = given("fov");
    if (!text) return;
    const auto degrees = number_in(*text);
    if (!degrees || !(least_degrees <= degrees->value && degrees->value <= most_degrees)) {
      refuse_flag("fov",
                  fmt::format("the vertical angle of view, {} to {} degrees", least_degrees, most_degrees),
                  shown(*text));
    }
    wish_.view.vertical_radians =
        degrees->value == 40 ? pipeline::View{}.vertical_radians : degrees->value * 3.141592653589793 / 180;
    say("fov", degrees->text, degrees->value == 40);
  }

  void read_background() {
    const std::string* text = given("background");
    if (!text) return;
    wish_.transparent = folded(trimmed(*text)) == "none";
    if (wish_.transparent) return say("background", "none");
    const Parameter parameter{"background", ParameterType::color, "", "", ""};
    const Arguments::Entry read = read_argument(parameter, *text);
    wish_.background = std::get<Rgba8>(read.value);
    say("background", read.text, wish_.background == Rgba8{255, 255, 255});
  }

  void read_filter() {
    const std::string* text = given("filter");
    if (!text) return;
    const std::string word = folded(trimmed(*text));
    constexpr std::array<std::string_view, 4> names{"nearest", "bilinear", "mipmapped", "none"};
    const auto found = std::ranges::find(names, word);
    if (found == names.end())
      refuse_flag("filter", "one of nearest, bilinear, mipmapped, none", shown(*text));
    say("filter", word, word == "mipmapped");
    if (word == "none") {
      wish_.filter = std::nullopt;
    } else {
      wish_.filter = static_cast<pipeline::TextureFilter>(found - names.begin());
    }
  }

  void read_antialiasing() {
    const std::string* text = given("aa");
    if (!text) return;
    const std::string word = folded(trimmed(*text));
    const auto& names = pipeline::antialiasing_names;
    const auto found = std::ranges::find(names, word);
    if (found == names.end())
      refuse_flag("aa", fmt::format("one of {}", fmt::join(names, ", ")), shown(*text));
    wish_.antialiasing = static_cast<pipeline::Antialiasing>(found - names.begin());
    say("aa", word, wish_.antialiasing == pipeline::default_antialiasing);
  }

  void read_samples() {
    const std::string* text = given("samples");
    if (!text) return;
    const pipeline::Antialiasing method = wish_.antialiasing;
    if (!takes_samples(method)) {
      refuse_flag("samples", fmt::format("no number beside --aa {}, which has its own", name_of(method)),
                  shown(*text));
    }
    const auto count = whole_number(folded(trimmed(*text)));
    if (!count || *count < 1 || *count > most_samples)
      refuse_flag("samples", fmt::format("1 to {} samples a pixel", most_samples), shown(*text));
    if (takes_squares(method) && pipeline::grid_side(static_cast<int>(*count)) == 0)
      refuse_flag("samples", "a square like 4, 9 or 16, for they stand in cells", shown(*text));
    wish_.samples = static_cast<int>(*count);
    say("samples", fmt::format("{}", wish_.samples), wish_.samples == pipeline::default_samples);
  }

  const std::map<std::string, std::string>& flags_;
  bool over_file_ = false;
  Wish wish_;
};

/// What a scene's file wishes before any flag.
Wish wish_of(const pipeline::SceneFile& file) {
  Wish wish;
  if (file.size) wish.size = {file.size->x, file.size->y};
  wish.view = file.view;
  wish.depths = file.depths;
  wish.surfaces = {file.scene.hidden_surfaces, file.scene.culling, file.scene.shading};
  wish.filter = file.scene.filter;
  wish.antialiasing = file.scene.antialiasing;
  wish.samples = file.scene.samples;
  return wish;
}

// --- The scene ---------------------------------------------------------------------------------------------

std::string text_of(dvec3 v) { return fmt::format("{:.4g},{:.4g},{:.4g}", v.x, v.y, v.z); }

/// Throws UsageError for flags that leave the picture undetermined.
pipeline::SceneCamera camera_for(const std::vector<pipeline::Object>& objects, const Wish& wish) {
  const pipeline::View& view = wish.view;
  const double aspect = static_cast<double>(wish.size.width) / wish.size.height;
  const pipeline::Aim aim = pipeline::aim_of(objects, view, aspect);
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
  pipeline::SceneCamera camera = camera_of(aim, view, objects, aspect);
  if (!wish.depths) return camera;
  camera.lens.near = wish.depths->x, camera.lens.far = wish.depths->y;
  if (camera.rays) camera.rays->near = wish.depths->x, camera.rays->far = wish.depths->y;
  return camera;
}

pipeline::Scene scene_for(pipeline::SceneFile file, const Wish& wish) {
  pipeline::Scene scene = std::move(file.scene);
  scene.camera = camera_for(scene.objects, wish);
  if (!file.lights_told) scene.lights = pipeline::default_lights(scene.camera);
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

// --- The picture -------------------------------------------------------------------------------------------

/// The picture, and how many of its pixels show the model.
struct Picture {
  Image image;
  std::int64_t covered = 0;
};

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// ledger: gets what was done, and what the plan left out.
Picture picture_of(const pipeline::Scene& scene, const Wish& wish, pipeline::Ledger& ledger) {
  pipeline::Plan plan = pipeline::timed(seconds_now, ledger.planning, [&] {
    return pipeline::plan_of(scene, wish.size, wish.plan.rules, wish.plan.part);
  });
  const pipeline::LightPicture light =
      antialiased_by_plan(scene, plan, ledger, seconds_now, Working::reached);
  Working::reached(0);  // what comes is no part of it
  const auto shows_model = [](const pipeline::PixelLight& pixel) { return pixel.share > 0; };
  Image image = pipeline::timed(seconds_now, ledger.writing, [&] {
    return wish.transparent ? with_alpha(light) : pipeline::output(over_background(light, scene.background));
  });
  return {std::move(image), std::ranges::count_if(light.cells(), shows_model)};
}

/// The size of the picture, or of the part of it that is asked for.
pipeline::Size shown_size(const Wish& wish) {
  if (!wish.plan.part) return wish.size;
  return {static_cast<int>(wish.plan.part->width()), static_cast<int>(wish.plan.part->height())};
}

/// "spot.obj: 5856 faces, 11712 triangles", of a scene with its objects.
std::string contents_of(const std::string& name, const pipeline::Scene& scene, bool is_scene) {
  std::int64_t faces = 0, triangles = 0;
  for (const pipeline::Object& object : scene.objects) {
    faces += std::ssize(object.mesh->faces);
    triangles += triangle_count(*object.mesh);
  }
  return fmt::format("{}: {}{}, {}", name,
                     is_scene ? counted(std::ssize(scene.objects), "object") + ", " : "",
                     counted(faces, "face"), counted(triangles, "triangle"));
}

Colophon colophon_of(const RenderInput& input, const pipeline::Scene& scene, const Wish& wish) {
  const std::string name = input.name == dash ? input.is_scene ? "a scene" : "a model" : input.name;
  const auto [width, height] = shown_size(wish);
  return {fmt::format("{}, rendered", name),
          fmt::format("{}, seen from {}, {} x {} pixels.", contents_of(name, scene, input.is_scene),
                      text_of(scene.camera.frame.eye), width, height),
          fmt::format("gradus render {}{}", shell_quoted(input.name), wish.said), input.hashes};
}

/// Why there is nothing to be seen.
std::string empty_remark(const pipeline::Scene& scene) {
  return lies_behind(scene)
             ? "render: the whole model lies behind the eye: the picture shows the background alone"
             : "render: no pixel shows the model: the picture shows the background alone";
}

/// What a method of antialiasing can't draw.
std::optional<std::string> opacity_remark(const pipeline::Scene& scene) {
  const bool drawn = draws_opacity(scene) || scene.shading == pipeline::Shading::wireframe;
  if (drawn || !std::ranges::any_of(scene.objects, &pipeline::Object::see_through)) return std::nullopt;
  return "render: what lets light through is drawn opaque; --aa a_buffer draws it by its opacity";
}

/// All that a request asks for, read and ready to be rendered.
struct Shot {
  Wish wish;
  pipeline::Scene scene;
  RenderBrief brief;
};

Shot shot_of(const Request& request, const FindFile& find) {
  Shot shot;
  shot.wish = WishReader(request.flags).read();
  RenderInput input = read_render_input(request.operands.at(0), find, shot.wish.filter.has_value());
  // The first reading has found what is wrong with the flags alone
  if (input.is_scene) shot.wish = WishReader(request.flags, wish_of(input.scene)).read();
  shot.wish.plan = plan_wish(request.flags, shot.wish.size);
  shot.wish.said += shot.wish.plan.said;
  check_projection(request.flags, shot.wish.view.projection);
  const std::vector<std::string> remarks = first_notes(input.scene.notes);
  const auto [width, height] = shown_size(shot.wish);
  shot.brief = {{}, input.files, input.quotable, remarks, width, height};
  shot.scene = scene_for(std::move(input.scene), shot.wish);
  if (const auto remark = opacity_remark(shot.scene)) shot.brief.remarks.push_back(*remark);
  shot.brief.colophon = colophon_of(input, shot.scene, shot.wish);
  return shot;
}

}  // namespace

RenderBrief render_brief(const Request& request, const FindFile& find) {
  return shot_of(request, find).brief;
}

std::string scene_name(const RenderBrief& brief) {
  const std::string& file = brief.files.front();
  return file == dash ? "standard input" : fs::path(file).filename().string();
}

RenderJob render_job(const Request& request, const FindFile& find) {
  Shot shot = shot_of(request, find);
  return {std::move(shot.scene), shot.wish.size, std::move(shot.wish.plan), std::move(shot.brief)};
}

Rendered rendered(const Request& request, const FindFile& find,
                  const std::function<void(const RenderBrief&)>& on_read) {
  Shot shot = shot_of(request, find);
  if (on_read) on_read(shot.brief);
  Rendered result{std::move(shot.brief), "", {}};
  const Picture picture = picture_of(shot.scene, shot.wish, result.ledger);
  if (picture.covered == 0) result.remarks.push_back(empty_remark(shot.scene));
  result.png = png_of(picture.image, result.colophon);
  return result;
}

void check_rendered_output(const Request& request, const std::string& output) {
  check_output(output, {}, Replace::anything);
  if (request.has("why")) return check_why_output(output);
  if (output == dash && is_terminal(Stream::out)) {
    throw UsageError("-o: expected a file or a pipe for png, found a terminal");
  }
  if (output != dash && !is_page(output) && folded(fs::path(output).extension().string()) != ".png")
    throw UsageError(fmt::format("-o: expected a name that ends in .png or .html, found {}", shown(output)));
}

void make_rendered(const Request& request, const Output& output, const FindFile& find,
                   const std::function<void(const RenderBrief&)>& on_read) {
  if (request.has("why")) return draw_why(request, output, find, on_read);
  if (is_page(output.path)) return write_picture_page(request, output, find, on_read);
  const Rendered picture = rendered(request, find, on_read);
  write_output(output.path, picture.png, output.replace);
  if (!output.quiet) {
    for (const std::string& remark : picture.remarks) note(remark);
    if (output.path != dash) note(shown_name(output.path));
  }
  if (!request.has("report")) return;
  const Stream stream = output.path == dash ? Stream::err : Stream::out;
  write_stream(stream, ledger_text(scene_name(picture), picture.ledger));
}

int render(const Request& request) {
  const auto wanted = request.flags.find("output");
  if (wanted == request.flags.end()) {
    if (request.has("why")) {
      print_why(request);
      return 0;
    }
    throw UsageError("-o: expected a file like model.png, or - for standard output, found none");
  }
  const Output output{wanted->second, replaces(request.has("force")), request.quiet()};
  check_rendered_output(request, output.path);
  make_rendered(request, output, as_named, [&output](const RenderBrief& brief) {
    check_output(output.path, brief.files, output.replace);
  });
  return 0;
}

}  // namespace gradus::cli
