#include "cli/render/render_wish.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "cli/command_line/errors.hpp"
#include "request/names.hpp"
#include "scene/camera/turntable.hpp"
#include "stories/point_text.hpp"
#include "stories/topic.hpp"

namespace gradus::cli {
namespace {

constexpr std::int64_t most_pixels_a_side = 8192, most_pixels = 1 << 25;
constexpr double largest_coordinate = 1e30;  // as in models
constexpr std::int64_t most_samples = 256;

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
  explicit WishReader(const Flags& flags) : flags_(flags) {}
  /// Flags over what a scene's file says.
  WishReader(const Flags& flags, Wish of_file) : flags_(flags), over_file_(true), wish_(std::move(of_file)) {}

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
    read_turntable();
    wish_.frames = read_frames(flags_);
    if (wish_.path) hold_still(*wish_.path);
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

  /// Takes from the path what flags tell once for all its frames.
  void hold_still(pipeline::CameraPath& path) const {
    if (given("eye")) path.eye.clear();
    if (given("target")) path.target.clear();
    if (given("up")) path.up.clear();
    if (given("fov")) path.vertical_radians.clear();
  }

  void read_fov() {
    const std::string* text = given("fov");
    if (!text) return;
    const auto degrees = number_in(*text);
    if (!degrees ||
        !(pipeline::least_degrees <= degrees->value && degrees->value <= pipeline::most_degrees)) {
      refuse_flag("fov",
                  fmt::format("the vertical angle of view, {} to {} degrees", pipeline::least_degrees,
                              pipeline::most_degrees),
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
      refuse_flag("samples", fmt::format("1 to {} samples per pixel", most_samples), shown(*text));
    if (takes_squares(method) && pipeline::grid_side(static_cast<int>(*count)) == 0)
      refuse_flag("samples", "a square like 4, 9 or 16, for they stand in cells", shown(*text));
    wish_.samples = static_cast<int>(*count);
    say("samples", fmt::format("{}", wish_.samples), wish_.samples == pipeline::default_samples);
  }

  void read_turntable() {
    const std::string* text = given("turntable");
    if (!text) return;
    const auto frames = whole_number(folded(trimmed(*text)));
    if (!frames || *frames < 1 || *frames > pipeline::most_turntable_frames)
      refuse_flag("turntable", fmt::format("1 to {} frames", pipeline::most_turntable_frames), shown(*text));
    wish_.turntable = static_cast<int>(*frames);
    say("turntable", fmt::format("{}", *frames));
  }

  const Flags& flags_;
  bool over_file_ = false;
  Wish wish_;
};

/// What a scene's file wishes before any flag.
Wish wish_of(const pipeline::SceneFile& file) {
  Wish wish;
  if (file.size) wish.size = {file.size->x, file.size->y};
  wish.view = file.view;
  wish.path = file.path;
  wish.depths = file.depths;
  wish.surfaces = {file.scene.hidden_surfaces, file.scene.culling, file.scene.shading};
  wish.filter = file.scene.filter;
  wish.antialiasing = file.scene.antialiasing;
  wish.samples = file.scene.samples;
  return wish;
}

}  // namespace

Wish read_wish(const Flags& flags) { return WishReader(flags).read(); }

Wish read_wish(const Flags& flags, const pipeline::SceneFile& file) {
  return WishReader(flags, wish_of(file)).read();
}

pipeline::Size shown_size(const Wish& wish) {
  if (!wish.plan.part) return wish.size;
  return {static_cast<int>(wish.plan.part->width()), static_cast<int>(wish.plan.part->height())};
}

}  // namespace gradus::cli
