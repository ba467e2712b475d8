// Projection, hidden surfaces, culling and shading of `gradus render`.

#include "cli/render/render_choices.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <span>
#include <variant>

#include "cli/command_line/errors.hpp"
#include "core/arithmetic/elementary.hpp"
#include "core/shown.hpp"
#include "request/names.hpp"
#include "stories/point_text.hpp"

namespace gradus::cli {
namespace {

/// One of the names, which have the order of the enum.
template <class Enum>
void read_choice(const Flags& flags, const std::string& flag, std::span<const std::string_view> names,
                 const SayFlag& say, Enum& into) {
  const std::string* text = given(flags, flag);
  if (!text) return;
  const std::string word = folded(trimmed(*text));
  const auto found = std::ranges::find(names, word);
  if (found == names.end()) refuse_flag(flag, fmt::format("one of {}", fmt::join(names, ", ")), shown(*text));
  const auto choice = static_cast<Enum>(found - names.begin());
  say(flag, word, choice == into);
  into = choice;
}

/// A number from least to most.
struct Range {
  double least, most;
  std::string_view expected;
};

std::optional<double> read_number_in(const Flags& flags, const std::string& flag, const Range& range,
                                     const SayFlag& say, std::optional<double> standard) {
  const std::string* text = given(flags, flag);
  if (!text) return std::nullopt;
  const Read<Number> read = read_number(*text);
  const Number* number = std::get_if<Number>(&read);
  if (!number || !(range.least <= number->value && number->value <= range.most))
    refuse_flag(flag, std::string(range.expected), shown(*text));
  say(flag, number->text, standard == number->value);
  return number->value;
}

}  // namespace

const std::string* given(const Flags& flags, const std::string& flag) {
  const auto found = flags.find(flag);
  return found == flags.end() ? nullptr : &found->second;
}

void read_projection(const Flags& flags, const SayFlag& say, pipeline::View& view) {
  read_choice(flags, "projection", pipeline::projection_names, say, view.projection);
  constexpr Range heights{1e-30, 1e30, "how much is seen from the lower to the upper edge, 1e-30 to 1e30"};
  constexpr Range angles{-360, 360, "the angle at which depth is drawn, -360 to 360 degrees"};
  constexpr Range factors{0, 100, "how long a unit of depth is drawn, 0 to 100"};
  if (const auto height = read_number_in(flags, "height", heights, say, {})) view.height = height;
  if (const auto degrees = read_number_in(flags, "receding", angles, say, 45))
    view.receding_radians = radians_from_degrees(*degrees);
  if (const auto factor = read_number_in(flags, "foreshortening", factors, say, 0.5))
    view.foreshortening = *factor;
}

void read_surfaces(const Flags& flags, const SayFlag& say, DrawnSurfaces& surfaces) {
  read_choice(flags, "hidden-surfaces", pipeline::hidden_surface_names, say, surfaces.hidden);
  read_choice(flags, "culling", pipeline::culling_names, say, surfaces.culling);
  read_choice(flags, "shading", pipeline::shading_names, say, surfaces.shading);
  read_choice(flags, "engine", drawn_by_names, say, surfaces.by);
}

void check_projection(const Flags& flags, pipeline::Projection3d projection) {
  const auto only = [&](const std::string& flag, bool has) {
    const std::string* text = given(flags, flag);
    if (!text || has) return;
    const auto name = pipeline::projection_names[static_cast<std::size_t>(projection)];
    refuse_flag(flag, fmt::format("no value beside the projection {}", name), shown(*text));
  };
  only("fov", has_eye(projection));
  only("height", !has_eye(projection));
  only("receding", leans(projection));
  only("foreshortening", leans(projection));
}

}  // namespace gradus::cli
