// The story of sampling: a sine and what its samples tell, the curve that comes back, a wheel on film, and
// patterns that too few samples spoil.

#include "antialiasing/sampling_theorem/sampling_theorem.hpp"

#include "stories/antialiasing/sampling_theorem/kernel_story.hpp"
#include "stories/antialiasing/sampling_theorem/pattern_story.hpp"
#include "stories/antialiasing/sampling_theorem/sine_story.hpp"
#include "stories/antialiasing/sampling_theorem/wheel_story.hpp"
#include "stories/parameters.hpp"
#include "stories/telling.hpp"

namespace gradus::sampling_theorem {
namespace {

using Names = std::vector<std::string>;

/// All parameters but these: what a method takes no notice of.
Names all_but(const Names& read) {
  Names unread;
  for (const char* name : {"frequency", "rate", "phase", "samples", "place", "revolutions", "frames",
                           "spokes", "shown", "pixels", "distance", "square"}) {
    if (std::ranges::find(read, name) == read.end()) unread.emplace_back(name);
  }
  return unread;
}

Parameter whole(std::string name, std::string value, std::string example, std::string help, int least,
                int most) {
  Parameter parameter{std::move(name), ParameterType::integer, std::move(value), std::move(example),
                      std::move(help)};
  parameter.least = least;
  parameter.most = most;
  return parameter;
}

std::vector<Parameter> parameters_of_all() {
  using parameters::number;
  const Sizes rates{1e-3, 1e4};
  return {
      number("frequency", "9", "3", "cycles a second of the sine", rates),
      number("rate", "10", "20", "samples a second", rates),
      number("phase", "0", "45", "where in its cycle the sine begins, in degrees", {1e-3, 360}),
      whole("samples", "10", "16", "how many samples are taken", 2, 24),
      number("place", "2.5", "4.5", "where the kernels are added, in samples from the first on", {1e-3, 1e3}),
      number("revolutions", "2", "30", "revolutions of the wheel a second; below 0 backwards", rates),
      number("frames", "24", "30", "frames a second of the film", rates),
      whole("spokes", "8", "1", "spokes of the wheel, all alike", 1, 24),
      whole("shown", "6", "3", "how many frames follow the first one", 1, 12),
      whole("pixels", "48", "64", "columns and rows of the pictures", 16, 64),
      number("distance", "18", "4", "how far from the centre the rings have one cycle per pixel, in pixels",
             {0.25, 1e3}),
      number("square", "0.25", "0.5", "side of a square of the ground, in heights of the eye", {0.05, 50})};
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic = completed<entry>(
      {.name = "sampling_theorem",
       .chapter = "antialiasing",
       .aliases = {"nyquist", "aliasing", "alias", "undersampling", "wagon wheel", "zone plate", "moire"},
       .summary = "what samples tell of a signal: aliases, curves that come back, wheels that turn backwards",
       .methods = {{.name = "sine",
                    .standing = Standing::taught,
                    .tell = tell_sine,
                    .function = "sample",
                    .unread = all_but({"frequency", "rate", "phase", "samples"})},
                   {.name = "reconstruction",
                    .tell = tell_reconstruction,
                    .function = "reconstruct",
                    .unread = all_but({"frequency", "rate", "phase", "samples", "place"})},
                   {.name = "wagon_wheel",
                    .tell = tell_wagon_wheel,
                    .function = "film_wheel",
                    .unread = all_but({"revolutions", "frames", "spokes", "shown"})},
                   {.name = "zone_plate",
                    .tell = tell_zone_plate,
                    .function = "pixel_of",
                    .file = "test_patterns.hpp",
                    .unread = all_but({"pixels", "distance"})},
                   {.name = "chequerboard",
                    .tell = tell_chequerboard,
                    .function = "pixel_of",
                    .file = "test_patterns.hpp",
                    .unread = all_but({"pixels", "square"})},
                   {.name = "artefacts",
                    .tell = tell_artefacts,
                    .function = "pixel_of",
                    .file = "test_patterns.hpp",
                    .unread = all_but({})},
                   {.name = "at_least_twice",
                    .standing = Standing::faulty,
                    .tell = tell_at_least_twice,
                    .unread = all_but({"frequency", "phase", "samples"})},
                   {.name = "half_frame_rate",
                    .standing = Standing::faulty,
                    .tell = tell_half_frame_rate,
                    .unread = all_but({"revolutions", "frames", "spokes", "shown"})}},
       .columns = {{"k"}, {"t"}, {"value"}},
       .parameters = parameters_of_all(),
       .examples = {"--frequency 9 --rate 10", "--method reconstruction --frequency 3",
                    "--method wagon_wheel --revolutions 30 --spokes 1"}});
  return topic;
}

}  // namespace gradus::sampling_theorem
