// The story of supersampling: one pixel and the places where its scene is asked, the larger picture, and
// pictures beside each other.

#include "antialiasing/supersampling/supersampling.hpp"

#include "stories/antialiasing/supersampling/large_story.hpp"
#include "stories/antialiasing/supersampling/pictures.hpp"
#include "stories/antialiasing/supersampling/pixel_story.hpp"
#include "stories/antialiasing/supersampling/rays_story.hpp"
#include "stories/parameters.hpp"

namespace gradus::supersampling {

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  static const TopicEntry topic = completed<entry>(
      {.name = "supersampling",
       .chapter = "antialiasing",
       .aliases = {"SSAA", "oversampling", "full-scene antialiasing", "box filter", "tent filter",
                   "Gaussian filter", "super-sampling"},
       .summary = "n x n samples of the scene per pixel, weighed by a filter into one value",
       .methods = {{.name = "supersample",
                    .standing = Standing::taught,
                    .tell = tell_supersample,
                    .function = "draw",
                    .unread = {"columns", "rows", "light"}},
                   {.name = "large_picture", .tell = tell_large_picture, .unread = {"pixel"}},
                   {.name = "more_samples",
                    .tell = tell_more_samples,
                    .function = "draw",
                    .unread = {"samples", "filter", "corners", "pixel", "columns", "rows", "light"}},
                   {.name = "filters",
                    .tell = tell_filters,
                    .function = "draw",
                    .unread = {"filter", "corners", "pixel", "columns", "rows", "light"}},
                   {.name = "rays",
                    .tell = tell_rays,
                    .function = "draw",
                    .within = {{"samples", 8}},
                    .unread = {"filter", "corners", "pixel", "columns", "rows", "light"}},
                   {.name = "upsampled_image",
                    .standing = Standing::faulty,
                    .tell = tell_upsampled_image,
                    .file = "supersampling_notes.hpp",
                    .unread = {"filter", "pixel"}},
                   {.name = "blurred_channels",
                    .standing = Standing::faulty,
                    .tell = tell_blurred_channels,
                    .file = "supersampling_notes.hpp",
                    .unread = {"filter", "pixel", "light"}}},
       .columns = {{"k"}, {"x"}, {"y"}, {"value"}, {"weight"}, {"sum"}},
       .parameters = {integer(1, 12, "samples", "4", "2", "samples per pixel along each axis"),
                      choice("filter", {"box", "tent", "gaussian"}, "box", "tent", "how samples are weighed"),
                      points(3, 3, "corners", "1,6.6 5.2,0.8 9.2,5.4", "0,0 12,3 12,3.4",
                             "the triangle, in pixels: x to the right, y down", {"x", "y"}, {1e-3, 4096}),
                      {.name = "pixel",
                       .type = ParameterType::cell,
                       .default_value = "3,3",
                       .example = "4,1",
                       .help = "the pixel that is drawn large: column and row"},
                      integer(2, 16, "columns", "10", "12", "how many pixels the picture is wide"),
                      integer(2, 16, "rows", "8", "9", "how many pixels it is high"),
                      choice("light", {"white", "red"}, "white", "red", "the triangle's light")},
       .examples = {"--samples 2 --filter tent", "--method more_samples", "--method filters --samples 4",
                    "--method upsampled_image"}});
  return topic;
}

}  // namespace gradus::supersampling
