// The story of the textbook chain: a small model's data before and after each stage, and one triangle and one
// pixel followed through all eight.

#include "stories/given_model.hpp"
#include "stories/parameters.hpp"
#include "stories/pipeline/textbook_chain/run.hpp"
#include "stories/pipeline/textbook_chain/tour.hpp"
#include "stories/telling.hpp"

namespace gradus::textbook_chain {
namespace {

using namespace pipeline;

/// The stages that exhibits exchange, and the one that cuts.
constexpr std::size_t facing_stage = 4, clipping_stage = 5, raster_stage = 6;

/// The choice of `stage` that stands for the whole chain.
constexpr std::string_view whole_chain = "all";

/// The stage's number from 1; 0 for the whole chain.
std::size_t number_of(std::string_view stage) {
  const auto found = std::ranges::find(stages, stage, &Stage::name);
  return found == stages.end() ? 0 : static_cast<std::size_t>(found - stages.begin()) + 1;
}

std::vector<std::string> stage_names() {
  std::vector<std::string> names;
  for (const Stage& stage : stages) names.emplace_back(stage.name);
  names.emplace_back(whole_chain);
  return names;
}

/// An exhibit: the stage that is exchanged, and where its tour ends when all stages are asked for.
struct Exchanged {
  Fault fault = Fault::none;
  std::size_t stage = 0;  ///< 0: none
  std::size_t end = stages.size();
};

/// Lists a stage's own functions. The chain's eight calls, and what an exhibit exchanges, are listed already.
void list(Narrator& narrator, std::size_t number, const Exchanged& exchanged) {
  if (number == 0 || number == exchanged.stage) return;
  const Stage& stage = stages[number - 1];
  narrator.list(stage.function, fmt::format("pipeline/stages/{}.hpp", stage.file));
  if (!stage.function_below.empty()) narrator.list_below(stage.function_below);
}

void tell_tour(Narrator& narrator, const Exchanged& exchanged) {
  const Arguments& arguments = narrator.arguments();
  const Size size{static_cast<int>(arguments.integer("columns")),
                  static_cast<int>(arguments.integer("rows"))};
  const Run run = run_of(scene_of(arguments, exchanged.fault), size, exchanged.fault);
  const Followed followed = followed_in(run, arguments);
  const std::size_t asked = number_of(arguments.text("stage"));
  const std::size_t listed = asked == 0 ? exchanged.stage : asked;
  const std::size_t last = asked == 0 ? exchanged.end : asked;
  list(narrator, listed, exchanged);
  narrator.subtitle(
      "subtitle",
      {{"model", name_of_model(arguments, own_model)}, {"width", size.width}, {"height", size.height}});
  Grid& grid = narrator.trace().grid;
  const ChainPaper paper(size);
  // A pixel by its upper left corner in the picture that comes out
  if (asked == 0) narrator.handles("pixel", [&](dvec2 p) { return paper.in_picture(p - 0.5); });
  grid.cells = paper.cells();
  grid.lines = paper.least_cell();
  grid.y_up = false;
  grid.whole = true;
  grid.axes = false;
  grid.x_name = narrator.words().symbol("x");
  grid.y_name = narrator.words().symbol("y");
  narrator.shows_depths(true);
  const bool raster = exchanged.stage == raster_stage;
  narrator.legend({Role::current,
                   Role::accepted,
                   {Role::rejected, raster ? "misjudged" : "rejected"},
                   Role::boundary,
                   Role::candidate,
                   Role::input});
  Tour(narrator, run, followed, listed, last, exchanged.stage).tell();
  // The whole tour's figure is the stage that cuts the followed triangle, if it does
  const Clipped* clipped = run.clipped_of(run.pieces[followed.piece].id);
  const bool cut = asked == 0 && clipped && clipped->changed;
  if (exchanged.stage == 0) narrator.telling({static_cast<std::int64_t>(cut ? clipping_stage : last), 0});
  const Rgba8 colour = run.image[followed.pixel];
  const bool chosen = arguments.has("face") && !arguments.text("face").empty();
  std::vector<Field> result{{"pixel", followed.pixel},
                            {"colour", fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b)}};
  if (followed.seen || chosen) result.push_back({"face", run.pieces[followed.piece].id.face});
  result.push_back(followed.seen ? Field{"seen", std::int64_t{*followed.seen}}
                                 : Field{"seen", std::string("nothing")});
  narrator.result(std::move(result));
}

void tell_z_buffer(Narrator& narrator) { tell_tour(narrator, {}); }

/// To the end: there the picture has holes.
void tell_cull_after_division(Narrator& narrator) {
  tell_tour(narrator, {Fault::cull_after_division, facing_stage});
}
void tell_closed_half_planes(Narrator& narrator) {
  tell_tour(narrator, {Fault::closed_half_planes, raster_stage, raster_stage});
}
void tell_expanded_edges(Narrator& narrator) {
  tell_tour(narrator, {Fault::expanded_edges, raster_stage, raster_stage});
}

/// Of lengths: what the chain can project, and what its determinants hold.
constexpr Sizes length_sizes{1e-30, 1e30};

}  // namespace

const TopicEntry& entry() {  // the catalogue asks for it by this name
  using namespace parameters;
  static const TopicEntry topic = completed<entry>(
      {.name = "pipeline",
       .chapter = "pipeline",
       .aliases = {"textbook chain", "rendering pipeline", "graphics pipeline", "tour"},
       .summary = "a small model through the eight stages of the textbook chain",
       .methods = {{.name = "z_buffer",
                    .standing = Standing::taught,
                    .tell = tell_z_buffer,
                    .function = "render",
                    .file = "pipeline/pipeline.hpp"},
                   {.name = "cull_after_division",
                    .standing = Standing::faulty,
                    .tell = tell_cull_after_division,
                    .function = "facing_after_division",
                    .file = "algorithms/visibility/back_face_culling/back_face_culling_notes.hpp"},
                   {.name = "closed_half_planes",
                    .standing = Standing::faulty,
                    .tell = tell_closed_half_planes,
                    .file = "algorithms/scan_conversion/triangle_coverage/triangle_coverage_notes.hpp"},
                   {.name = "expanded_edges",
                    .standing = Standing::faulty,
                    .tell = tell_expanded_edges,
                    .file = "algorithms/scan_conversion/triangle_coverage/triangle_coverage_notes.hpp"}},
       .columns = {{"point", false}, {"stage"}, {"x"}, {"y"}, {"z"}, {"w"}},
       .parameters =
           {{"model", ParameterType::model, "", "MODEL.obj",
             "a small model; a house with a tree if not given"},
            choice("stage", stage_names(), std::string(whole_chain), "clipping",
                   "the tour ends with this stage and lists its source; all lists the chain"),
            integer(8, 64, "columns", "50", "32", "the picture's width in pixels"),
            integer(8, 64, "rows", "35", "20", "the picture's height in pixels"),
            integer(0, INT32_MAX, "face", "", "3",
                    "the face that is followed, counted from 0; a telling one if not given"),
            {"pixel", ParameterType::cell, "", "12,7",
             "the pixel that is followed: column,row from the top left; one of the face's if not given", 0,
             63},
            numbers("eye", "", "1,1,3", "where the viewer stands: x,y,z; placed for the model if not given",
                    xyz, length_sizes),
            numbers("target", "", "0,0.5,0",
                    "what the viewer looks at: x,y,z; the model's middle if not given", xyz, length_sizes),
            {"fov", ParameterType::number, "40", "60", "the vertical angle of view in degrees", 1, 170},
            {.name = "near",
             .type = ParameterType::number,
             .default_value = "",
             .example = "0.5",
             .help = "the depth of the near plane; before the model if not given",
             .least = 0,
             .sizes = length_sizes},
            integer(-360, 360, "turn", "0", "30",
                    "degrees by which the model is turned round the y axis, stage 2")},
       .examples = {"--stage clipping", "--model letter_f.obj --eye 1,1,3",
                    "--turn 30 --face 0 --pixel 12,7"}});
  return topic;
}

}  // namespace gradus::textbook_chain
