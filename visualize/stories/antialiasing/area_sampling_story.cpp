// The story of exact areas: a polygon cut at the borders of pixels, what is seen in one pixel, and a thin
// triangle that does not vanish.

#include "antialiasing/area_sampling/area_sampling.hpp"

#include "antialiasing/area_sampling/area_sampling_notes.hpp"
#include "stories/antialiasing/area_sampling/moving_story.hpp"
#include "stories/antialiasing/area_sampling/pixel_story.hpp"
#include "stories/antialiasing/area_sampling/subject.hpp"
#include "stories/antialiasing/area_sampling/tones_story.hpp"
#include "stories/casing.hpp"

namespace gradus::area_sampling {
namespace {

/// The areas of one polygon, pixel by pixel.
class Story {
 public:
  Story(const Words& words, const Window& window) : words_(words), window_(window) {}

  /// The pixel in which the polygon has most corners, the last of several.
  std::optional<StepNumber> telling() const { return telling_; }
  double sum() const { return to_double(sum_); }

  void show(Board& board, const Started& s) { next(board, s.box.lower); }
  Event say(const Started& s) const {
    return {.text = "started",
            .facts = {{"corners", std::ssize(s.corners)}},
            .words = {{"columns", std::max<std::int64_t>(0, s.box.width())},
                      {"rows", std::max<std::int64_t>(0, s.box.height())}},
            .key = "polygon"};
  }

  void show(Board& board, const BorderCut& b) {
    const bool of_row = b.border.axis == 1;
    number_ = (b.border.at - (b.border.above ? 0 : subpixels)) / subpixels;
    if (of_row && !b.border.above) {
      row_ = number_;
      next(board, {window_.lower.x, row_});
    } else {
      board.detail(of_row ? ivec2{window_.lower.x, number_} : ivec2{number_, row_});
    }
    board.mark("left", Role::candidate, Area{{on_grid(b.left)}, 2});
    board.mark("left border", Role::candidate, Path{on_grid(b.left), true});
    board.mark("border", Role::boundary, border(b.border));
  }
  Event say(const BorderCut& b) const {
    const bool of_row = b.border.axis == 1;
    constexpr std::array<std::string_view, 4> texts{"cut.left", "cut.right", "cut.top", "cut.bottom"};
    return {.text = texts[(of_row ? 2U : 0U) + (b.border.above ? 0U : 1U)],
            .facts = {{"corners", std::ssize(b.left)}},
            .words = {{"number", number_}, {"n", b.left.size()}},
            .key = figure_number(number_),
            .phase = words_.say("phase.row", {{"row", of_row ? number_ : row_}})};
  }

  void show(Board& board, const AreaTaken<Exact>& a) {
    next(board, a.pixel);
    sum_ = sum_ + a.area;
    const bool large = window_.width() <= 8 && window_.height() <= 8;
    board.put(a.pixel, Role::result, large ? area_text(a.area) : "", tone_of(a));
    board.mark("piece", Role::current, Path{on_grid(a.piece), true});
    if (a.piece.size() < most_corners_) return;
    most_corners_ = a.piece.size();
    telling_ = {milestones_, 0};
  }
  Event say(const AreaTaken<Exact>& a) const {
    const int tone = tone_of(a).r;
    return {.text = a.area == Exact(1) ? "taken.whole" : "taken.piece",
            .facts = {{"pixel", a.pixel}, {"corners", std::ssize(a.piece)}, {"area", to_double(a.area)}},
            .words = {{"area", area_text(a.area)},
                      {"light", area_text(Exact(1) - a.area)},
                      {"tone", tone},
                      {"sum", area_text(sum_)},
                      {"n", a.piece.size()}},
            .row = {a.pixel.x, a.pixel.y, a.piece.size(), area_text(a.area), tone},
            .key = pixel_key(a.pixel),
            .phase = words_.say("phase.row", {{"row", row_}})};
  }

  void show(Board& board, const Finished&) { next(board, window_.lower); }
  Event say(const Finished& f) const {
    return {.text = "finished",
            .facts = {{"clipped", f.clipped}, {"covered", f.covered}},
            .words = {{"sum", area_text(sum_)}},
            .count = f.covered};
  }

 private:
  static Ring2 on_grid(const Polygon& polygon) {
    return mapped(ring_of(polygon), [](dvec2 p) { return p - 0.5; });
  }
  /// Ink on white paper.
  static Rgba8 tone_of(const AreaTaken<Exact>& a) { return tone_on_paper({0, 0, 0, 255}, to_double(a.area)); }
  /// A border of the pixels, across the window.
  Stroke border(const Border& b) const {
    const double at = static_cast<double>(b.at) / subpixels - 0.5;
    const dvec2 lower = dvec2(window_.lower) - 0.5, upper = dvec2(window_.upper) + 0.5;
    return b.axis == 1 ? Stroke{{lower.x, at}, {upper.x, at}} : Stroke{{at, row_ - 0.5}, {at, row_ + 0.5}};
  }
  void next(Board& board, ivec2 focus) {
    board.milestone(focus);
    ++milestones_;
  }

  const Words& words_;
  const Window window_;
  int number_ = 0, row_ = 0;
  Exact sum_ = 0;
  std::size_t most_corners_ = 0;
  std::int64_t milestones_ = -1;
  std::optional<StepNumber> telling_{};
};

// --- The methods

void tell_pixel_areas(Narrator& narrator) {
  const ExactScope scope;
  const Words& words = narrator.words();
  const std::vector<ivec2> corners = corners_of(narrator.arguments());
  const Window window = window_of(narrator.arguments());
  narrator.subtitle("subtitle", {{"n", corners.size()}});
  narrator.handles("polygon", [&](dvec2 corner) { return shown_at(window, corner); }, 1);
  narrator.handles("window", as_it_is_in(window));
  Grid& grid = narrator.trace().grid;
  grid.cells = window;
  grid.y_up = false;
  grid.x_name = words.symbol("x");
  grid.y_name = words.symbol("y");
  grid.whole = true;
  narrator.legend({{Role::input, "polygon"},
                   {Role::boundary, "border"},
                   {Role::candidate, "left"},
                   {Role::current, "piece"}});
  const Ring2 outline = mapped(corners, [](ivec2 p) { return in_pixels(dvec2(p)) - 0.5; });
  add_casing(narrator, sides_of(outline));
  narrator.backdrop("polygon", Role::input, Path{outline, true});
  Story story(words, window);
  pixel_areas<Exact>(corners, window, [](ivec2, Exact) {}, narrator.watcher(story));
  if (story.telling()) narrator.telling(*story.telling());
  narrator.result({{"sum", story.sum()}});
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  static const TopicEntry topic = completed<entry>(
      {.name = "area_sampling",
       .chapter = "antialiasing",
       .aliases = {"catmull", "exact coverage", "pixel coverage", "unweighted area sampling"},
       .summary = "each pixel takes of each polygon as much as its exact visible area there",
       .methods = {{.name = "pixel_areas",
                    .standing = Standing::taught,
                    .tell = tell_pixel_areas,
                    .function = "clip_to_pixels",
                    .unread = {"triangles", "thin"}},
                   {.name = "visible_areas",
                    .tell = tell_in_pixel<false>,
                    .file = "visible_areas.hpp",
                    .unread = {"polygon", "window", "thin"}},
                   {.name = "moving",
                    .tell = tell_moving,
                    .function = "clip_to_pixels",
                    .unread = {"polygon", "window", "triangles"}},
                   {.name = "areas_without_visibility",
                    .standing = Standing::faulty,
                    .tell = tell_in_pixel<true>,
                    .unread = {"polygon", "window", "thin"}},
                   {.name = "area_as_tone",
                    .standing = Standing::faulty,
                    .tell = tell_area_as_tone,
                    .unread = {"triangles", "thin"}}},
       .columns = {{"x"}, {"y"}, {"corners"}, {"area"}, {"shown"}},
       .parameters =
           {points(3, 50, "polygon", "1,3 4,1 2,5", "0.5,0.5 3.5,0.5 3.5,2.5 2,1.5 0.5,2.5",
                   "the corners of a polygon, x right and y down in pixels; pixel (0, 0) goes from 0 to 1",
                   xy, {1e-6, 1e6}),
            {.name = "window",
             .type = ParameterType::window,
             .default_value = "0,0,4,4",
             .example = "0,0,7,7",
             .help = "the pixels that are asked for: xmin,ymin,xmax,ymax, both corners included; of more "
                     "than 16 columns or rows the first 16"},
            faces(18, "triangles",
                  "A: 0.12,-0.3,0.3 1.3,0.35,0.3 0.15,0.68,0.3; B: -0.3,0.5,0.1 1.4,0.2,0.5 0.9,1.3,0.4; "
                  "C: -0.9,-0.3,0.8 1.9,-0.3,0.8 1.9,2.5,0.8",
                  "A: 0,0,1 1,0,1 0,1,1; B: 0,0,0 1,0,2 1,1,2",
                  "triangles over the pixel from 0,0 to 1,1, with the depths of their corners; smaller is "
                  "nearer",
                  {1e-6, 1e6}),
            points(3, 3, "thin", "0.4,1 9.6,1.7 0.4,1.4", "0.2,0.2 7.8,0.2 0.2,0.6",
                   "method moving: the triangle that is moved down by quarters of a pixel", xy,
                   {1e-6, 1000})},
       .examples = {"--polygon '1,3 4,1 2,5'", "--method visible_areas", "--method moving"}});
  return topic;
}

}  // namespace gradus::area_sampling
