// The story of a pixel's samples: where each is put, what it sees of the scene's edge, and how near their
// mean comes to the exact area.

#include "antialiasing/jittered/jittered.hpp"

#include "antialiasing/jittered/jittered_notes.hpp"
#include "stories/antialiasing/jittered/faulty_story.hpp"
#include "stories/antialiasing/jittered/pictures.hpp"
#include "stories/parameters.hpp"

namespace gradus::jittered {
namespace {

/// Boxes of one sample's area, so many across and down.
struct BoxesCounted {
  ivec2 boxes;
};

class PixelStory {
 public:
  static constexpr int width = 34, height = 24;

  static Square square() { return {{1, 23}, 22}; }

  PixelStory(const Words& words, Pattern pattern, const Edge& edge, int asked)
      : words_(words), pattern_(pattern), edge_(edge), area_(edge.area()), asked_(asked) {}

  /// The step that tells most: the last sample whose cell the edge goes through, so that its place decides.
  StepNumber telling() const { return {telling_, 0}; }
  double mean() const { return mean_; }
  double area() const { return area_; }
  std::int64_t taken() const { return std::ssize(samples_); }

  void show(Board& board, const Cut& c) {
    grid_ = c.grid;
    put(board);
  }
  Event say(const Cut& c) const {
    Event event{.text = "cut",
                .facts = {{"columns", c.grid.x}, {"rows", c.grid.y}},
                .words = {{"area", area_}},
                .count = asked_};
    event.begins = true;
    if (pattern_ == Pattern::uniform) event.text = "cut.uniform";
    if (pattern_ == Pattern::n_rooks) event.text = "cut.rooks";
    if (pattern_ == Pattern::sobol) event.text = "cut.sobol";
    if (pattern_ == Pattern::correlated_multi_jittered) event.text = "cut.correlated";
    return event;
  }

  void show(Board& board, const Swapped& s) {
    if (rooks_.empty()) {
      for (int i = 0; i < grid_.x; ++i) rooks_.push_back(i);
    }
    before_ = {rook(s.rook.x), rook(s.other.x)};
    rooks_[static_cast<std::size_t>(s.rook.x)] = s.rook.y;
    rooks_[static_cast<std::size_t>(s.other.x)] = s.other.y;
    swapped_ = s;
    put(board);
    swapped_.reset();
  }
  Event say(const Swapped& s) const {
    Event event{.text = s.rook == s.other ? "kept" : "swapped",
                .facts = {{"column", s.rook.x}, {"other", s.other.x}},
                .words = {{"row", s.rook.y}},
                .row = {"", s.rook, "", "", ""},
                .key = figure_number(s.rook.x)};
    if (s.rook != s.other) {
      event.words.push_back({"other", s.other.x});
      event.words.push_back({"other_row", s.other.y});
    }
    return event;
  }

  void show(Board& board, const Scrambled& s) {
    scrambled_ = s;
    const Square pixel = square();
    put_detail(board, [&](View& view) {
      const auto box = [&](ivec2 cell) {
        return pixel.box(dvec2(cell) / dvec2(grid_), dvec2(cell + 1) / dvec2(grid_));
      };
      view.add({"c plain", Role::candidate, Path{box(s.plain), true}});
      view.add({"c turned", Role::current, Path{box(s.turned), true}});
      const dvec2 half = 0.5 / dvec2(grid_);
      if (s.plain != s.turned)
        view.add({"c way", Role::measure,
                  Stroke{pixel.at(dvec2(s.plain) / dvec2(grid_) + half),
                         pixel.at(dvec2(s.turned) / dvec2(grid_) + half), true}});
    });
  }
  Event say(const Scrambled& s) const {
    return {.text = "scrambled",
            .facts = {{"index", s.index}, {"plain", s.plain}, {"turned", s.turned}},
            .words = {{"k", s.index + 1}},
            .key = figure_number(s.index + 1)};
  }

  void show(Board& board, const Placed& p) {
    placed_ = p;
    samples_.push_back({p.place, edge_.holds(p.place)});
    inside_ += samples_.back().inside;
    mean_ = double(inside_) / double(taken());
    note_telling();
    put(board);
  }
  Event say(const Placed& p) const {
    const bool inside = samples_.back().inside;
    Event event{.text = key_of_placed(),
                .facts = {{"index", p.index},
                          {"cell", p.cell},
                          {"u", p.u.x},
                          {"v", p.u.y},
                          {"x", p.place.x},
                          {"y", p.place.y},
                          {"inside", inside},
                          {"mean", mean_}},
                .words = {{"k", p.index + 1},
                          {"place", p.place},
                          {"side", words_.say(inside ? "side.inside" : "side.outside")},
                          {"hits", inside_},
                          {"taken", taken()}},
                .row = {p.index + 1, p.cell, p.place, words_.shared("words", inside ? "yes" : "no"), mean_},
                .key = figure_number(p.index + 1)};
    if (pattern_ == Pattern::correlated_multi_jittered) {
      const int slots = p.grid.x / grid_.x;
      event.words.push_back({"column", p.cell.x / slots});
      event.words.push_back({"strip", p.cell.y / grid_.x});
      event.words.push_back({"row", p.cell.y});
      event.words.push_back({"fine", p.cell.x});
    }
    event.decides = yes_or_no(words_, "question", {{"place", p.place}}, inside, "inside", "outside");
    return event;
  }

  void show(Board& board, const BoxesCounted& b) {
    placed_.reset();
    boxes_ = b.boxes;
    put(board);
    boxes_.reset();
  }
  Event say(const BoxesCounted& b) const {
    return {.text = "boxes",
            .facts = {{"columns", b.boxes.x}, {"rows", b.boxes.y}},
            .count = taken(),
            .key = fmt::format("{}x{}", b.boxes.x, b.boxes.y)};
  }

  void show(Board& board, const Finished&) {
    placed_.reset();
    finished_ = true;
    put(board);
  }
  Event say(const Finished&) const {
    return {.text = "finished",
            .facts = {{"samples", taken()}, {"inside", inside_}, {"mean", mean_}, {"area", area_}},
            .words = {{"hits", inside_}, {"off", std::abs(mean_ - area_)}},
            .count = taken()};
  }

 private:
  ivec2 rook(int column) const { return {column, rooks_[static_cast<std::size_t>(column)]}; }
  /// Fine grids have cells too small for arrows: rows and columns are lit instead.
  bool fine() const { return pattern_ >= Pattern::n_rooks; }

  std::string_view key_of_placed() const {
    switch (pattern_) {
      case Pattern::regular:
        return "placed.regular";
      case Pattern::uniform:
        return "placed.uniform";
      case Pattern::n_rooks:
        return "placed.rooks";
      case Pattern::correlated_multi_jittered:
        return "placed.correlated";
      case Pattern::sobol:
        return "placed.sobol";
      case Pattern::jittered:
        break;
    }
    return "placed";
  }

  void note_telling() {
    const dvec2 lower = dvec2(placed_->cell) / dvec2(placed_->grid),
                upper = dvec2(placed_->cell + 1) / dvec2(placed_->grid);
    const bool decides = edge_.crosses(lower, upper);
    if (decides || telling_ == 0) telling_ = milestones_ + 1;
  }

  View scene() const {
    View view;
    const Square pixel = square();
    pixel.put_scene(view, "a", edge_);
    const std::optional<ivec2> lines = boxes_ ? boxes_ : std::optional(grid_);
    pixel.put_grid(view, "b grid", boxes_ ? Role::candidate : Role::guide, *lines, false);
    if (pattern_ == Pattern::correlated_multi_jittered && !finished_ && asked_ <= 25)
      pixel.put_grid(view, "b fine", Role::guide, {grid_.x * grid_.y, asked_}, true);
    put_rooks(view);
    pixel.put_samples(view, "d sample", samples_);
    std::optional<double> mean;
    if (!samples_.empty()) mean = mean_;
    put_scale(view, words_, {25.6, 1}, 22, area_, mean);
    return view;
  }
  void put_rooks(View& view) const {
    const Square pixel = square();
    const auto centre = [&](ivec2 cell) { return pixel.at((dvec2(cell) + 0.5) / dvec2(grid_)); };
    for (std::size_t i = samples_.size(); i < rooks_.size(); ++i) {
      const ivec2 cell = rook(static_cast<int>(i));
      const bool moved = swapped_ && (cell == swapped_->rook || cell == swapped_->other);
      view.add({fmt::format("c rook {:02}", i), moved ? Role::current : Role::candidate,
                Path{pixel.box(dvec2(cell) / dvec2(grid_), dvec2(cell + 1) / dvec2(grid_)), true}});
    }
    if (!swapped_ || swapped_->rook == swapped_->other) return;
    view.add({"c way 1", Role::measure, Stroke{centre(before_[0]), centre(swapped_->rook), true}});
    view.add({"c way 2", Role::measure, Stroke{centre(before_[1]), centre(swapped_->other), true}});
  }
  void put_placed(View& view) const {
    const Square pixel = square();
    const Placed& p = *placed_;
    const dvec2 grid(p.grid), lower = dvec2(p.cell) / grid, upper = dvec2(p.cell + 1) / grid;
    if (fine()) {
      view.add({"b row", Role::candidate, Area{{pixel.box({0, lower.y}, {1, upper.y})}, 3}});
      view.add({"b column", Role::candidate, Area{{pixel.box({lower.x, 0}, {upper.x, 1})}, 3}});
    }
    if (pattern_ == Pattern::correlated_multi_jittered) {
      const ivec2 coarse{p.cell.x / (p.grid.x / grid_.x), p.cell.y / grid_.x};
      const double high = double{1} * grid_.x / p.grid.y;
      view.add({"c cell", Role::current,
                Path{pixel.box({double(coarse.x) / grid_.x, coarse.y * high},
                               {double(coarse.x + 1) / grid_.x, std::min(1.0, (coarse.y + 1) * high)}),
                     true}});
    } else if (pattern_ != Pattern::uniform) {
      view.add({"c cell", Role::current, Path{pixel.box(lower, upper), true}});
    }
    put_offsets(view, lower, upper);
    const dvec2 at = pixel.at(p.place);
    view.add({"e now", Role::current, Dot{at, !samples_.back().inside}});
  }
  /// How the two random numbers lead from the cell's corner to the sample.
  void put_offsets(View& view, dvec2 lower, dvec2 upper) const {
    const Square pixel = square();
    if (pattern_ == Pattern::regular || (upper.x - lower.x) * pixel.side < 4) return;
    if ((upper.y - lower.y) * pixel.side < 3) return;
    const dvec2 place = placed_->place, turn{place.x, lower.y};
    view.add({"c u", Role::measure, Stroke{pixel.at(lower), pixel.at(turn), true}});
    view.add({"c v", Role::measure, Stroke{pixel.at(turn), pixel.at(place), true}});
    view.add({"c u name", Role::measure,
              Label{pixel.at(0.5 * (lower + turn)), figure_real(rounded(placed_->u.x))}});
    view.add({"c v name", Role::measure,
              Label{pixel.at(0.5 * (turn + place)), figure_real(rounded(placed_->u.y))}});
  }
  static double rounded(double x) { return std::round(100 * x) / 100; }

  void put(Board& board) {
    ++milestones_;
    View view = scene();
    if (placed_) put_placed(view);
    board.milestone(std::move(view));
  }
  template <class More>
  void put_detail(Board& board, const More& more) {
    placed_.reset();
    View view = scene();
    more(view);
    board.detail(std::move(view));
  }

  const Words& words_;
  const Pattern pattern_;
  const Edge edge_;
  const double area_;
  const int asked_;
  ivec2 grid_{1, 1};
  std::vector<Dropped> samples_;
  std::vector<int> rooks_;  ///< the row of each column's rook
  std::array<ivec2, 2> before_{};
  std::optional<Swapped> swapped_;
  std::optional<Scrambled> scrambled_;
  std::optional<Placed> placed_;
  std::optional<ivec2> boxes_;
  bool finished_ = false;
  std::int64_t inside_ = 0, milestones_ = -1, telling_ = 0;
  double mean_ = 0;
};

// --- The exhibits

// --- The methods

void set_pixel(Narrator& narrator, int count) {
  const Arguments& given = narrator.arguments();
  narrator.paper(PixelStory::width, PixelStory::height);
  narrator.trace().subtitle = narrator.words().count(
      "subtitle", count, {{"seed", given.integer("seed")}, {"pixel", given.cell("pixel")}});
  if (narrator.method().name == "regular")
    narrator.trace().subtitle = narrator.words().count("subtitle_regular", count);
}

template <Pattern pattern, class Put>
void tell_pattern(Narrator& narrator, const Put& put_samples) {
  const Arguments& given = narrator.arguments();
  const Edge edge = edge_of(given);
  const int count = count_of(given, pattern);
  set_pixel(narrator, count);
  narrator.columns({{"k"}, {"cell", false}, {"place", false}, {"inside", false}, {"mean"}});
  narrator.legend({{Role::input, "scene"},
                   {Role::current, "now"},
                   {Role::measure, "offset"},
                   {Role::candidate, pattern == Pattern::sobol     ? "box"
                                     : pattern == Pattern::n_rooks ? "rook"
                                                                   : "row"},
                   {Role::result, "inside"},
                   {Role::past, "outside"}});
  PixelStory story(narrator.words(), pattern, edge, count);
  PixelStory::square().let_drag(narrator, edge);
  const auto watch = narrator.watcher(story);
  std::vector<dvec2> samples(static_cast<std::size_t>(count));
  put_samples(std::span(samples), numbers_of(given), watch);
  narrator.telling(story.telling());
  narrator.result({{"mean", story.mean()}, {"area", story.area()}, {"samples", story.taken()}});
}

void tell_regular(Narrator& narrator) {
  tell_pattern<Pattern::regular>(narrator,
                                 [](auto samples, const Random&, auto& watch) { regular(samples, watch); });
}
void tell_uniform(Narrator& narrator) {
  tell_pattern<Pattern::uniform>(
      narrator, [](auto samples, const Random& random, auto& watch) { uniform(samples, random, watch); });
}
void tell_jittered(Narrator& narrator) {
  tell_pattern<Pattern::jittered>(
      narrator, [](auto samples, const Random& random, auto& watch) { jittered(samples, random, watch); });
}
void tell_rooks(Narrator& narrator) {
  tell_pattern<Pattern::n_rooks>(
      narrator, [](auto samples, const Random& random, auto& watch) { n_rooks(samples, random, watch); });
}
void tell_correlated(Narrator& narrator) {
  tell_pattern<Pattern::correlated_multi_jittered>(narrator,
                                                   [](auto samples, const Random& random, auto& watch) {
                                                     correlated_multi_jittered(samples, random, watch);
                                                   });
}
void tell_sobol(Narrator& narrator) {
  tell_pattern<Pattern::sobol>(narrator, [](auto samples, const Random& random, auto& watch) {
    // Before the end, each way to cut the pixel into boxes
    const auto with_boxes = [&]<class Step>(const Step& step, int line = __builtin_LINE(),
                                            const char* = nullptr) {
      if constexpr (std::same_as<Step, Finished>) {
        for (int columns = step.samples; columns >= 1; columns /= 2)
          watch(BoxesCounted{{columns, step.samples / columns}}, 0);
      }
      watch(step, line);
    };
    sobol(samples, random, with_boxes);
  });
}

template <class Run>
void tell_faulty(Narrator& narrator, bool whole, const Run& run) {
  const Arguments& given = narrator.arguments();
  const Edge edge = edge_of(given);
  const int asked = static_cast<int>(given.integer("samples"));
  set_pixel(narrator, asked);
  narrator.columns({{"k"}, {"cell", false}, {"place", false}, {"inside", false}, {"mean"}});
  narrator.legend(
      {{Role::input, "scene"}, {Role::current, "now"}, {Role::result, "inside"}, {Role::past, "outside"}});
  if (whole) narrator.add_to_legend(Role::rejected, "whole");
  FaultyStory story(narrator.words(), edge, asked, whole);
  FaultyStory::pixel.let_drag(narrator, edge);
  run(edge, asked, narrator.watcher(story));
  narrator.telling(story.telling());
  narrator.result({{"mean", story.mean()}, {"area", story.area()}});
}

void tell_whole_coordinates(Narrator& narrator) {
  const ivec2 pixel = narrator.arguments().cell("pixel");
  if (pixel.x < 0 || pixel.y < 0) refuse("pixel", "expected a column and a row of 0 or more");
  tell_faulty(narrator, true, [&](const Edge& edge, int asked, const auto& watch) {
    const auto finished = [&](ivec2) { return edge.holds({0.5, 0.5}) ? 1.0 : 0.0; };
    whole_coordinates(pixel, asked, numbers_of(narrator.arguments()), finished, watch);
  });
}
void tell_divided_by_asked(Narrator& narrator) {
  tell_faulty(narrator, false, [&](const Edge& edge, int asked, const auto& watch) {
    const auto scene = [&](dvec2 place) { return edge.holds(place) ? 1.0 : 0.0; };
    divided_by_asked({0, 0}, asked, numbers_of(narrator.arguments()), scene, watch);
  });
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  static const TopicEntry topic = completed<entry>(
      {.name = "jittered",
       .chapter = "antialiasing",
       .aliases = {"jitter", "stochastic sampling", "stratified sampling", "n rooks", "multi-jittered",
                   "sobol", "owen scrambling", "sampling patterns"},
       .summary = "a pixel's samples: one anywhere in each cell, and better patterns still",
       .methods =
           {{.name = "jittered", .standing = Standing::taught, .tell = tell_jittered, .unread = {"scene"}},
            {.name = "regular", .tell = tell_regular, .unread = {"scene", "seed", "pixel"}},
            {.name = "uniform", .tell = tell_uniform, .unread = {"scene"}},
            {.name = "n_rooks", .tell = tell_rooks, .unread = {"scene"}},
            {.name = "correlated_multi_jittered", .tell = tell_correlated, .unread = {"scene"}},
            {.name = "sobol", .tell = tell_sobol, .unread = {"scene"}},
            {.name = "all_patterns",
             .tell = tell_all_patterns,
             .function = "sample_pixel",
             .unread = {"scene"}},
            {.name = "pictures",
             .tell = tell_pictures,
             .function = "sample_picture",
             .unread = {"edge", "pixel"}},
            {.name = "whole_coordinates",
             .standing = Standing::faulty,
             .tell = tell_whole_coordinates,
             .unread = {"scene"}},
            {.name = "divided_by_asked",
             .standing = Standing::faulty,
             .tell = tell_divided_by_asked,
             .unread = {"scene"}}},
       .default_method = "jittered",
       .columns = {{"k"}, {"cell", false}, {"place", false}, {"inside", false}, {"mean"}},
       .parameters = {integer(1, 64, "samples", "16", "9", "how many samples a pixel has"),
                      integer(0, INT32_MAX, "seed", "42", "7", "of the random numbers"),
                      {"pixel", ParameterType::cell, "0,0", "3,2",
                       "which pixel of the picture: each has random numbers of its own"},
                      points(2, 2, "edge", "0.1,1.1 0.8,-0.1", "0.2,1 0.6,0",
                             "two places of the scene's edge, in the pixel from 0 to 1, y down; the scene "
                             "lies on the right of the way",
                             xy, {1e-6, 1000}),
                      choice("scene", {"plane", "grating", "zone_plate"}, "plane", "zone_plate",
                             "what the pictures show")},
       .examples = {"--samples 9 --seed 7", "--method correlated_multi_jittered", "--method all_patterns",
                    "--method pictures --samples 4 --scene zone_plate"}});
  return topic;
}

}  // namespace gradus::jittered
