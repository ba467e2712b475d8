// `gradus render`: a picture of a model, by the textbook chain.

#include "cli/render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <utility>

#include "cairo/image_file.hpp"
#include "cli/errors.hpp"
#include "cli/files.hpp"
#include "cli/names.hpp"
#include "core/colour.hpp"
#include "pipeline.hpp"
#include "scene/files.hpp"
#include "scene/framing.hpp"
#include "scene/obj.hpp"
#include "scene/textures.hpp"
#include "scene/view.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

namespace fs = std::filesystem;

// --- The flags ---------------------------------------------------------------------------------------------

constexpr std::int64_t most_pixels_a_side = 8192, most_pixels = 1 << 25;
constexpr double least_degrees = 0.001, most_degrees = 179.999;
constexpr double largest_coordinate = 1e30;  // as in models

/// What the flags say.
struct Wish {
  pipeline::Size size;
  pipeline::View view;
  std::optional<dvec3> light;
  std::optional<Rgba8> background;
  bool transparent = false;
  pipeline::Shading shading = pipeline::Shading::phong;
  std::optional<pipeline::TextureFilter> filter =
      pipeline::TextureFilter::mip_mapped;  ///< nothing: no textures
  std::string said;                         ///< the flags in their canonical spelling, " --size 640x480"
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

  Wish read() {
    read_size();
    wish_.view.eye = vector("eye");
    wish_.view.target = vector("target");
    wish_.view.up = vector("up");
    if (wish_.view.up == dvec3{0}) refuse_flag("up", "a direction like 0,1,0", "0,0,0");
    read_fov();
    wish_.light = vector("light");
    read_background();
    read_shading();
    read_filter();
    return std::move(wish_);
  }

 private:
  const std::string* given(const std::string& flag) const {
    const auto found = flags_.find(flag);
    return found == flags_.end() ? nullptr : &found->second;
  }

  void say(std::string_view flag, std::string_view value) {
    wish_.said += fmt::format(" --{} {}", flag, shell_quoted(value));
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
    if (canonical != "800x600") say("size", canonical);
  }

  std::optional<dvec3> vector(const std::string& flag) {
    const std::string* text = given(flag);
    if (!text) return std::nullopt;
    const auto numbers = triple_in(*text);
    const auto fits = [](const Number& n) { return std::abs(n.value) <= largest_coordinate; };
    if (!numbers || !std::ranges::all_of(*numbers, fits)) {
      refuse_flag(flag, "three numbers like 3,2,4, none larger than 1e30", shown(*text));
    }
    const auto& [x, y, z] = *numbers;
    say(flag, fmt::format("{},{},{}", x.text, y.text, z.text));
    return dvec3{x.value, y.value, z.value};
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
    if (degrees->value == 40) return;
    wish_.view.vertical_radians = degrees->value * 3.141592653589793 / 180;
    say("fov", degrees->text);
  }

  void read_background() {
    const std::string* text = given("background");
    if (!text) return;
    wish_.transparent = folded(trimmed(*text)) == "none";
    if (wish_.transparent) return say("background", "none");
    const Parameter parameter{"background", ParameterType::color, "", "", ""};
    const Arguments::Entry read = read_argument(parameter, *text);
    wish_.background = std::get<Rgba8>(read.value);
    if (wish_.background != Rgba8{255, 255, 255}) say("background", read.text);
  }

  void read_shading() {
    const std::string* text = given("shading");
    if (!text) return;
    const std::string word = folded(trimmed(*text));
    constexpr std::array<std::string_view, 3> names{"flat", "gouraud", "phong"};
    const auto found = std::ranges::find(names, word);
    if (found == names.end()) refuse_flag("shading", "one of flat, gouraud, phong", shown(*text));
    wish_.shading = static_cast<pipeline::Shading>(found - names.begin());
    if (wish_.shading != pipeline::Shading::phong) say("shading", word);
  }

  void read_filter() {
    const std::string* text = given("filter");
    if (!text) return;
    const std::string word = folded(trimmed(*text));
    constexpr std::array<std::string_view, 4> names{"nearest", "bilinear", "mipmapped", "none"};
    const auto found = std::ranges::find(names, word);
    if (found == names.end())
      refuse_flag("filter", "one of nearest, bilinear, mipmapped, none", shown(*text));
    if (word != "mipmapped") say("filter", word);
    if (word == "none") {
      wish_.filter = std::nullopt;
    } else {
      wish_.filter = static_cast<pipeline::TextureFilter>(found - names.begin());
    }
  }

  const std::map<std::string, std::string>& flags_;
  Wish wish_;
};

// --- The model ---------------------------------------------------------------------------------------------

struct Input {
  pipeline::ModelFile model;
  std::string name;    ///< without folders
  std::string hashes;  ///< of the model and its libraries, in the order in which they were read
  std::vector<std::string> files;
  bool quotable = true;  ///< the model's file
};

/// Takes PNG files alone.
Image picture_in(const std::string& bytes, const std::string& name, std::int64_t most) {
  return decode_png({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, name, most);
}

/// textures: whether the pictures are read that materials name.
Input read_model(const std::string& operand, const FindFile& find, bool textures) {
  Input input;
  const bool from_stdin = operand == dash;
  const FoundFile file = from_stdin ? FoundFile(operand) : find(operand, "MODEL");
  const auto take = [&input](const std::string& path, const std::string& bytes) {
    input.hashes += (input.hashes.empty() ? "" : " ") + fingerprint(bytes);
    input.files.push_back(path);
  };
  const std::string text = read_input(file.path, "MODEL");
  take(file.path, text);
  input.name = from_stdin ? operand : fs::path(operand).filename().string();
  input.quotable = file.quotable;
  const auto took = [&](const std::string&, const std::string& path, const pipeline::LibraryText& library) {
    take(path, library.text);
  };
  const std::string called = from_stdin ? "standard input" : file.path;
  const auto beside = pipeline::libraries_beside(from_stdin ? "" : file.path, took);
  input.model = pipeline::parse_obj(text, {called, file.quotable}, beside);
  if (textures) pipeline::load_textures(input.model.mesh, beside, picture_in, called);
  return input;
}

// --- The scene ---------------------------------------------------------------------------------------------

std::string text_of(dvec3 v) { return fmt::format("{:.4g},{:.4g},{:.4g}", v.x, v.y, v.z); }

/// Throws UsageError for flags that leave the picture undetermined.
Camera camera_for(const pipeline::Object& object, const pipeline::View& view, double aspect) {
  const pipeline::Aim aim = pipeline::aim_of(object, view, aspect);
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
  return camera_of(aim, view.vertical_radians, object);
}

pipeline::Scene scene_for(Mesh mesh, const std::string& name, const Wish& wish) {
  pipeline::Scene scene;
  scene.objects.push_back(pipeline::object_of(std::move(mesh), name));
  scene.camera =
      camera_for(scene.objects[0], wish.view, static_cast<double>(wish.size.width) / wish.size.height);
  scene.lights = pipeline::default_lights(scene.camera);
  if (wish.light) {
    Light lamp;
    lamp.position = *wish.light;
    lamp.intensity = LinearRgb{0.85f};
    scene.lights = {lamp};
  }
  if (wish.background) scene.background = linear_from_srgb8(*wish.background);
  scene.shading = wish.shading;
  if (wish.filter) scene.filter = *wish.filter;
  return scene;
}

// --- The picture -------------------------------------------------------------------------------------------

/// The picture, and how many of its pixels show the model.
struct Picture {
  Image image;
  std::int64_t covered = 0;
};

Picture picture_of(const pipeline::Scene& scene, const Wish& wish) {
  Raster<std::uint8_t> shows_model(wish.size.width, wish.size.height, 0);
  Picture picture;
  auto mark = [&](const pipeline::Shaded& pixel) {
    shows_model[pixel.fragment.pixel] = 1;
    ++picture.covered;
  };
  picture.image = pipeline::render(scene, wish.size, only<pipeline::Shaded>(mark));
  for (int y = 0; wish.transparent && y < wish.size.height; ++y) {
    for (int x = 0; x < wish.size.width; ++x) {
      if (!shows_model[{x, y}]) picture.image[{x, y}] = {0, 0, 0, 0};
    }
  }
  return picture;
}

std::string counted(std::int64_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

Colophon colophon_of(const Input& input, const pipeline::Scene& scene, const Wish& wish) {
  const std::string name = input.name == dash ? "a model" : input.name;
  const Mesh& mesh = scene.objects[0].mesh;
  return {fmt::format("{}, rendered", name),
          fmt::format("{}: {}, {}, seen from {}, {} x {} pixels.", name,
                      counted(static_cast<std::int64_t>(mesh.faces.size()), "face"),
                      counted(triangle_count(mesh), "triangle"), text_of(scene.camera.frame.eye),
                      wish.size.width, wish.size.height),
          fmt::format("gradus render {}{}", shell_quoted(input.name), wish.said), input.hashes};
}

/// What the reader of the model left out; of much the beginning.
std::vector<std::string> remarks_on(const Input& input) { return first_notes(input.model.notes); }

/// Why there is nothing to be seen.
std::string empty_remark(const pipeline::Scene& scene) {
  const Mesh& mesh = scene.objects[0].mesh;
  const bool behind = std::ranges::all_of(mesh.corners, [&](const Corner& corner) {
    const Frame<double>& frame = scene.camera.frame;
    return glm::dot(frame.forward, position_of(mesh, corner) - frame.eye) <= 0;
  });
  return behind ? "render: the whole model lies behind the eye: the picture shows the background alone"
                : "render: no pixel shows the model: the picture shows the background alone";
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
  Input input = read_model(request.operands.at(0), find, shot.wish.filter.has_value());
  shot.brief = {
      {}, input.files, input.quotable, remarks_on(input), shot.wish.size.width, shot.wish.size.height};
  shot.scene = scene_for(std::move(input.model.mesh), input.name, shot.wish);
  shot.brief.colophon = colophon_of(input, shot.scene, shot.wish);
  return shot;
}

}  // namespace

RenderBrief render_brief(const Request& request, const FindFile& find) {
  return shot_of(request, find).brief;
}

Rendered rendered(const Request& request, const FindFile& find,
                  const std::function<void(const RenderBrief&)>& on_read) {
  Shot shot = shot_of(request, find);
  if (on_read) on_read(shot.brief);
  Rendered result{std::move(shot.brief), ""};
  const Picture picture = picture_of(shot.scene, shot.wish);
  if (picture.covered == 0) result.remarks.push_back(empty_remark(shot.scene));
  result.png = png_of(picture.image, result.colophon);
  return result;
}

void check_picture_output(const std::string& output) {
  check_output(output, {}, Replace::anything);
  if (output == dash && is_terminal(Stream::out)) {
    throw UsageError("-o: expected a file or a pipe for png, found a terminal");
  }
  if (output != dash && folded(fs::path(output).extension().string()) != ".png") {
    throw UsageError(fmt::format("-o: expected a name that ends in .png, found {}", shown(output)));
  }
}

void write_rendered(const Rendered& picture, const Output& output) {
  write_output(output.path, picture.png, output.replace);
  if (output.quiet) return;
  for (const std::string& remark : picture.remarks) note(remark);
  if (output.path != dash) note(shown_name(output.path));
}

int render(const Request& request) {
  const auto wanted = request.flags.find("output");
  if (wanted == request.flags.end()) {
    throw UsageError("-o: expected a file like model.png, or - for standard output, found none");
  }
  const Output output{wanted->second, replaces(request.has("force")), request.quiet()};
  check_picture_output(output.path);
  const auto check = [&output](const RenderBrief& brief) {
    check_output(output.path, brief.files, output.replace);
  };
  write_rendered(rendered(request, as_named, check), output);
  return 0;
}

}  // namespace gradus::cli
