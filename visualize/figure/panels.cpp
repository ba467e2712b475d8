#include "figure/panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "core/contract.hpp"
#include "figure/aside.hpp"
#include "figure/layout/layout.hpp"

namespace gradus {
namespace {

using namespace layout;

constexpr double heading_room = 34, panel_heading = 24;  ///< units: of the line above a panel
constexpr double counts_room = 28, count_gap = 28;       ///< of the line of counts below it
constexpr double panel_gap = 12, panel_air = 8;          ///< between panels, and inside their frames
constexpr int most_sentence_lines = 5;
constexpr double unequal_rows = 1000;  ///< what they cost: more than any cell is large

/// Captions as wide as this have no say in how large a drawing among several is: they give way.
constexpr double wide_text = 240;

/// Among so many drawings none has room for scales, and tints are cut a little beside the marks.
constexpr std::size_t many = 3;
constexpr double least_of_many = 5;        ///< units: how small the cells of a whole grid may be among many
constexpr double worth_the_numbers = 1.1;  ///< so much larger must cells be without the numbers beside them
constexpr double little = 0.85;            ///< of the cells without the lines of text: how large they stay
constexpr double rim = 0.1;                ///< beside the marks, in parts of their longer side

/// The lines of text on a paper, beside another drawing.
enum class Lines { kept, left_out };
Stage beside_another(Stage stage, Content& content, Lines lines) {
  return stage.content && stage.lines > 0 && lines == Lines::left_out ? bare(stage, content) : stage;
}

/// What all runs have to show, so that they share axes and scale. `content` keeps what stands on their
/// papers.
Stage common_stage(std::span<const Trace* const> runs, const Look& look, Content& content, Lines lines) {
  Content front, others;
  Stage all = beside_another(stage_of(*runs.front(), look), front, lines);
  dvec2 upper = all.lower + all.size;
  for (const Trace* run : runs) {
    const Stage other = beside_another(stage_of(*run, look), others, lines);
    upper = glm::max(upper, other.lower + other.size);
    all.cells = {glm::min(all.cells.lower, other.cells.lower), glm::max(all.cells.upper, other.cells.upper)};
    all.lower = glm::min(all.lower, other.lower);
    all.core = glm::max(all.core, other.core);
    all.numbers = std::max(all.numbers, other.numbers);
    if (!other.content) continue;
    content.core.add(other.content->core.lower);
    content.core.add(other.content->core.upper);
    std::ranges::copy_if(other.content->texts, std::back_inserter(content.texts),
                         [](const Content::TextRoom& text) { return text.left + text.right < wide_text; });
  }
  all.size = upper - all.lower;
  content.all = {all.lower, upper};
  if (all.content) all.content = &content;
  return all;
}

/// Rows and columns of panels, and what each has for itself; in units.
struct Tiling {
  std::size_t columns = 1;
  double width = 0, height = 0;  ///< of a drawing with its frame
  double sentence = 0;           ///< height of a panel's own sentence
  int sentence_lines = 0;
  double heading = heading_room;  ///< of all that stands above a drawing
  dvec2 pitch() const {
    const double below = sentence > 0 ? sentence + panel_gap : 0;
    return {width + panel_gap, heading + height + below + panel_gap};
  }
};

int lines_of_own(std::span<const std::string> sentences, double width) {
  std::size_t most = 1;
  for (const std::string& sentence : sentences) {
    most = std::max(most, sentence_lines(sentence, sentence_size, width - 40, most_sentence_lines).size());
  }
  return static_cast<int>(most);
}

/// `sentences`: of the panels' own; none: they lack them.
Tiling tiling_of(std::size_t runs, const PanelBand& band, std::span<const std::string> sentences,
                 std::size_t columns, const Box& area) {
  const auto count = static_cast<double>(columns);
  const auto rows = static_cast<double>((runs + columns - 1) / columns);
  Tiling tiling{.columns = columns};
  if (band.counted) tiling.heading += counts_room;
  tiling.width = (area.width + panel_gap) / count - panel_gap;
  if (!sentences.empty()) {
    tiling.sentence_lines = lines_of_own(sentences, tiling.width);
    tiling.sentence = (tiling.sentence_lines == 1 ? 24 : 14) + tiling.sentence_lines * sentence_line;
  }
  tiling.height = (area.height + panel_gap) / rows - (tiling.pitch().y - tiling.height);
  return tiling;
}

std::optional<Fit> fit_in(const Stage& stage, const Tiling& tiling) {
  return fit(stage, tiling.width - 2 * panel_air, tiling.height - 2 * panel_air);
}

/// How well a stage is shown: all of it in cells of any size before a part of it.
double worth_of(const Fit& shown) {
  return shown.follows ? -1 / static_cast<double>(shown.columns * shown.rows) : shown.cell;
}

/// The tiling whose drawings show most, in the largest cells; nothing: there is no room for them.
std::optional<Tiling> best_tiling(std::size_t runs, const PanelBand& band,
                                  std::span<const std::string> sentences, const Stage& stage,
                                  const Box& area) {
  std::optional<Tiling> best;
  double most = 0;  // set with the first
  for (std::size_t columns = runs; columns > 0; --columns) {
    const Tiling tiling = tiling_of(runs, band, sentences, columns, area);
    const auto shown = fit_in(stage, tiling);
    if (!shown) continue;
    // Rows as equal as can be: two and two rather than three and one, and no place empty that need not be
    const std::size_t rows = (runs + columns - 1) / columns;
    const bool equal = (runs + rows - 1) / rows == columns;
    const double filled = static_cast<double>(runs) / static_cast<double>(rows * columns);
    const double worth = worth_of(*shown) * filled * filled + (equal ? unequal_rows : 0);
    if (best && worth <= most + 1e-9) continue;
    best = tiling;
    most = worth;
  }
  return best;
}

/// Of many papers what the marks fill with a rim round it, and what else of the papers a panel has room for.
Stage cut_for(Stage stage, const Content& content, Content& cut, std::size_t runs) {
  if (!stage.content || runs < many || content.core.empty()) return stage;
  const double air = rim * std::max(content.core.size().x, content.core.size().y);
  stage.lower = glm::max(content.core.lower - air, content.all.lower);
  stage.size = glm::min(content.core.upper + air, content.all.upper) - stage.lower;
  const auto shown = [&](const Content::TextRoom& text) {
    return text.at == glm::clamp(text.at, stage.lower, stage.lower + stage.size);
  };
  cut = content;
  std::erase_if(cut.texts, [&](const Content::TextRoom& text) { return text.aside || !shown(text); });
  stage.content = &cut;
  return stage;
}

/// What is said below all panels, or below each.
struct Plan {
  std::vector<std::string> sentences{};  ///< of the panels' own; none: one for all
  Page page{};
  Stage stage{};
  std::optional<Tiling> tiling{};
  double worth = 0;
};

/// Listing and table have no place here, and sentences of the panels' own stand in the middle.
Look bands_of(Look look, bool own_sentences) {
  expects(look.slots.contains(Slot::drawing), "expected the slot drawing for several drawings, found none");
  look.slots.erase(Slot::listing);
  look.slots.erase(Slot::table);
  if (own_sentences) look.slots.erase(Slot::sentence);
  return look;
}

Plan plan_of(const Stage& stage, std::size_t runs, const PanelBand& band, const Look& look,
             std::vector<std::string> sentences) {
  Plan plan{std::move(sentences), {}, stage};
  plan.page = page_of(band.banner, bands_of(look, !plan.sentences.empty()));
  plan.tiling = best_tiling(runs, band, plan.sentences, stage, plan.page.middle);
  if (plan.tiling) plan.worth = worth_of(*fit_in(stage, *plan.tiling));
  return plan;
}

/// Among many a grid stands without the shelf beside it, which would make its cells small.
void leave_shelf_out(Stage& stage) {
  stage.cells = intersection(stage.cells, stage.own);
  stage.lower = dvec2(stage.cells.lower) - 0.5;
  stage.size = dvec2{static_cast<double>(stage.cells.width()), static_cast<double>(stage.cells.height())};
  stage.core = glm::min(stage.core, stage.size);
}

/// A grid among many is shown whole rather than a part of it, and without the numbers beside it where they
/// take more room than they are worth. Below each panel stands what it tells, where it tells more than the
/// sentence for all and takes nothing of the drawings.
Plan best_plan(Stage stage, std::size_t runs, const PanelBand& band, const Look& look) {
  const std::vector<std::string> none, own = look.slots.contains(Slot::sentence) ? band.own_sentences : none,
                                       first = band.sentence.empty() ? own : none;
  const bool grid_among_many = stage.axes && runs >= many;
  if (grid_among_many) leave_shelf_out(stage);
  if (grid_among_many && !stage.fixed) stage.least_cell = std::min(stage.least_cell, least_of_many);
  Plan best = plan_of(stage, runs, band, look, first);
  if (grid_among_many) {
    stage.axes = nullptr;
    Plan without = plan_of(stage, runs, band, look, first);
    if (without.worth > worth_the_numbers * best.worth) best = std::move(without);
  }
  if (own.size() == first.size()) return best;
  Plan told = plan_of(best.stage, runs, band, look, own);
  const bool whole = told.tiling && std::ranges::all_of(own, [&](const std::string& sentence) {
                       const double room = told.tiling->width - 40;
                       return sentence_lines(sentence, sentence_size, room, 99).size() <= most_sentence_lines;
                     });
  return whole && told.worth >= 0.999 * best.worth ? told : best;
}

/// More of the papers where a panel is wider or higher than what is shown.
Stage spread(Stage stage, const Content& content, const Tiling& tiling) {
  const double width = tiling.width - 2 * panel_air, height = tiling.height - 2 * panel_air;
  const std::optional<Fit> shown = fit_in(stage, tiling);
  if (!stage.content || !shown || shown->follows) return stage;
  const Margins& m = shown->margins;
  const dvec2 room = dvec2{width - m.left - m.right, height - m.above - m.below} / shown->cell;
  const dvec2 all = content.all.size(), size = glm::clamp(room, stage.size, glm::max(all, stage.size));
  const dvec2 lower = stage.lower - (size - stage.size) * 0.5;
  stage.lower = glm::clamp(lower, content.all.lower, content.all.upper - size);
  stage.size = size;
  return stage;
}

/// No frame is higher than its drawing, and all stand in the middle of the room that there was.
void hug(Tiling& tiling, Box& area, const Stage& stage, std::size_t runs) {
  const std::optional<Fit> shown = fit_in(stage, tiling);
  if (!shown || shown->follows) return;
  const Margins& m = shown->margins;
  const double height = stage.size.y * shown->cell + m.above + m.below + 2 * panel_air;
  const double spare = std::max(0.0, tiling.height - height);
  const auto rows = static_cast<double>((runs + tiling.columns - 1) / tiling.columns);
  tiling.height -= spare;
  area.y += rows * spare / 2;
}

/// As much of a note as has room: its first parts, else its first words.
std::string fitted_note(std::string note, double size, double room) {
  const auto fits = [&](const std::string& text) { return text_width(text, Face::sans, size) <= room; };
  for (const std::string_view end : {", ", " "}) {
    std::string shorter = note;
    for (std::size_t at = shorter.size(); at != shorter.npos; at = shorter.rfind(end)) {
      shorter.resize(at);
      if (fits(shorter)) return shorter;
    }
    if (note.find(" = ") != note.npos || note.find(": ") != note.npos) break;  // no name without its number
  }
  return elided(note, Face::sans, size, room);
}

void lay_out_panel_heading(Pen& pen, const SheetPanel& panel, const Box& box) {
  const double s = pen.scale(), baseline = box.bottom() - 9 * s;
  const std::string heading = elided(panel.heading, Face::bold, panel_heading * s, box.width - 8 * s);
  const double left = box.x + 4 * s, right = box.right() - 2 * s;
  const double room = right - left - text_width(heading, Face::bold, panel_heading * s) - 16 * s;
  pen.text("heading", {{left, baseline},
                       heading,
                       Face::bold,
                       panel_heading * s,
                       Align::left,
                       panel.faulty ? Paint::text(Role::measure) : Paint::text(Role::result)});
  if (panel.note.empty() || room < 60 * s) return;
  pen.text("note", {{right, baseline},
                    fitted_note(panel.note, text_size * s, room),
                    Face::sans,
                    text_size * s,
                    Align::right,
                    panel.parts ? Paint::text(Role::measure) : Paint::of(Tone::muted)});
}

/// What each run took, name and number, as many as have room: "cuts 4   divisions 4".
void lay_out_counts(Pen& pen, const SheetPanel& panel, const Box& box) {
  const double s = pen.scale(), size = text_size * s, baseline = box.bottom() - 8 * s;
  double x = box.x + 4 * s;
  for (std::size_t i = 0; i < panel.counts.size(); ++i) {
    const auto& [name, value] = panel.counts[i];
    const double to_value = text_width(name + " ", Face::sans, size),
                 width = to_value + text_width(value, Face::bold, size);
    if (x + width > box.right()) return;
    const std::string id = fmt::format("count {}", i + 1);
    pen.text(id, {{x, baseline}, name, Face::sans, size, Align::left, Paint::of(Tone::muted)});
    pen.text(id + " value",
             {{x + to_value, baseline}, value, Face::bold, size, Align::left, Paint::of(Tone::ink)});
    x += width + count_gap * s;
  }
}

/// Whether a scene shows anything of a mark that a legend tells of.
bool shows(const Scene& scene, const Mark& mark) {
  if ((scene.among_many || scene.bare) && stands_aside(mark)) return false;
  const Frame& frame = scene.frame;
  Content::Part reach;
  const auto add = [&](dvec2 p) { reach.add(frame.point(p)); };
  if (const Stroke* stroke = std::get_if<Stroke>(&mark.shape)) {
    add(stroke->a);
    add(stroke->b);
  } else if (const Path* path = std::get_if<Path>(&mark.shape)) {
    std::ranges::for_each(path->points, add);
  } else if (const Dot* dot = std::get_if<Dot>(&mark.shape)) {
    add(dot->at);
  } else if (const Area* area = std::get_if<Area>(&mark.shape)) {
    for (const auto& ring : area->rings) std::ranges::for_each(ring, add);
  } else {
    return true;
  }
  const Box& box = frame.box;
  return reach.upper.x >= box.x && reach.lower.x <= box.right() && reach.upper.y >= box.y &&
         reach.lower.y <= box.bottom();
}

/// What of a figure a frame shows, for the legend: a panel may be cut. Copied only where something is
/// missing.
class SeenPart {
 public:
  SeenPart(const Figure& figure, const Scene& scene) : figure_(figure) {
    const auto unseen = [&](const Mark& mark) { return !shows(scene, mark); };
    if (std::ranges::any_of(figure.trace->backdrop, unseen)) {
      trace_ = *figure.trace;
      std::erase_if(trace_->backdrop, unseen);
    }
    Delta delta;
    for (const auto& [id, mark] : figure.canvas->marks()) {
      if (unseen(mark)) delta.removed.push_back(id);
    }
    if (delta.removed.empty()) return;
    canvas_ = *figure.canvas;
    canvas_->apply(delta);
  }
  const Trace& trace() const { return trace_ ? *trace_ : *figure_.trace; }
  const Canvas& canvas() const { return canvas_ ? *canvas_ : *figure_.canvas; }

 private:
  const Figure& figure_;
  std::optional<Trace> trace_;
  std::optional<Canvas> canvas_;
};

/// The sheet while its panels are drawn.
class PanelSheet {
 public:
  PanelSheet(std::span<const Trace* const> runs, const PanelBand& band, const Look& look)
      : band_(band),
        look_(look),
        runs_(runs.size()),
        plan_(plan_for(runs)),
        tiling_(tiling_of_plan()),
        stage_(runs_ < many ? plan_.stage : spread(plan_.stage, content_, tiling_)),
        sheet_{look.width, look.height, {}, unit_of(look)} {
    hug(tiling_, plan_.page.middle, stage_, runs_);
  }

  void draw(std::size_t number, const SheetPanel& panel, bool last) {
    const std::size_t first = sheet_.shapes.size();
    const Box heading = box_of(number, 0, heading_room);
    const Box frame = box_of(number, tiling_.heading, tiling_.height);
    const double air = panel_air * sheet_.unit;
    Pen pen(sheet_, Slot::drawing, sheet_.unit);
    Scene scene =
        scene_of(panel.figure, look_, stage_,
                 {frame.x + air, frame.y + air, frame.width - 2 * air, frame.height - 2 * air}, sheet_.unit);
    scene.among_many = runs_ >= many;
    scene.ring = panel.ring;
    pen.rect("frame",
             {frame, {}, Paint::of(Tone::rule), 1.5 * sheet_.unit, 6 * sheet_.unit, false, Hatch::none, {}});
    lay_out_drawing(pen, panel.figure, scene);
    lay_out_panel_heading(pen, panel, heading);
    lay_out_counts(pen, panel, box_of(number, heading_room, tiling_.heading - heading_room));
    if (!plan_.sentences.empty()) {
      Pen below(sheet_, Slot::sentence, sheet_.unit);
      const Box box = box_of(number, tiling_.heading + tiling_.height + panel_gap, tiling_.sentence);
      lay_out_sentence(below, panel.figure, box, tiling_.sentence_lines);
    }
    name_shapes_from(first, fmt::format("panel {} ", number + 1));
    drawn_ = number == 0 ? frame : around(drawn_, frame);
    keep_legend(panel.figure, scene);
    if (last) draw_bands(panel.figure);
  }

  Sheet finish() {
    if (!look_.crop) return std::move(sheet_);
    return cropped(std::move(sheet_), crop_box(plan_.page.at, drawn_, look_, sheet_.unit));
  }

 private:
  /// Two drawings keep the lines of text on their papers, where these can be read and take little of them.
  Plan plan_for(std::span<const Trace* const> runs) {
    const Stage stage = common_stage(runs, look_, content_, Lines::left_out);
    const Plan without = best_plan(cut_for(stage, content_, cut_, runs_), runs_, band_, look_);
    if (runs_ >= many || runs.front()->grid.lines <= 0) return without;
    const Plan with = best_plan(common_stage(runs, look_, lines_, Lines::kept), runs_, band_, look_);
    const bool fit = with.tiling && with.worth >= std::max(with.stage.lines, little * without.worth);
    return fit ? with : without;
  }
  Tiling tiling_of_plan() const {
    const Box& area = plan_.page.middle;
    expects(plan_.tiling.has_value(),
            "expected a size with room for {} drawings, found {:.0f} x {:.0f} units for them", runs_,
            area.width, area.height);
    return *plan_.tiling;
  }

  /// Of the number-th panel the part of this height, `below` its top; pixels.
  Box box_of(std::size_t number, double below, double height) const {
    const auto column = static_cast<double>(number % tiling_.columns);
    const auto row = static_cast<double>(number / tiling_.columns);
    const dvec2 corner =
        dvec2(plan_.page.middle.x, plan_.page.middle.y) + dvec2(column, row) * tiling_.pitch();
    return scaled({corner.x, corner.y + below, tiling_.width, height}, sheet_.unit);
  }

  void name_shapes_from(std::size_t first, const std::string& prefix) {
    for (std::size_t i = first; i < sheet_.shapes.size(); ++i) sheet_.shapes[i].id.insert(0, prefix);
  }

  /// One legend for all: an entry that any of them shows, with the look that it has where it has most looks.
  void keep_legend(Figure figure, const Scene& scene) {
    const Figure whole = figure;
    const SeenPart seen(whole, scene);
    figure.trace = &seen.trace();
    figure.canvas = &seen.canvas();
    for (auto& [entry, mark] : shown_legend(figure, scene.frame.view)) {
      const auto same = [&](const auto& known) { return known.first.text == entry.text; };
      const auto known = std::ranges::find_if(legend_, same);
      if (known == legend_.end())
        legend_.emplace_back(std::move(entry), std::move(mark));
      else if (known->second.dots.size() < mark.dots.size())
        known->second = std::move(mark);
    }
  }
  /// In the order of the banner's.
  ShownLegend legend() const {
    ShownLegend sorted;
    for (const LegendEntry& entry : band_.banner.legend) {
      for (const auto& shown : legend_) {
        if (shown.first.text == entry.text) sorted.push_back(shown);
      }
    }
    return sorted;
  }

  void draw_bands(Figure figure) {
    figure.sentence = band_.sentence;
    figure.position = band_.position;
    figure.phase.clear();
    const auto draw_slot = [&](Slot slot, const Box& box, auto draw) {
      if (box.width <= 0) return;
      Pen pen(sheet_, slot, sheet_.unit);
      draw(pen, scaled(box, sheet_.unit));
    };
    const Places& at = plan_.page.at;
    draw_slot(Slot::title, at.title, [&](Pen& pen, const Box& box) { lay_out_title(pen, at.heading, box); });
    draw_slot(Slot::sentence, at.sentence,
              [&](Pen& pen, const Box& box) { lay_out_sentence(pen, figure, box, at.sentence_lines); });
    draw_slot(Slot::footer, at.footer,
              [&](Pen& pen, const Box& box) { lay_out_footer(pen, figure, box, legend(), at.footer_lines); });
  }

  const PanelBand& band_;
  const Look& look_;
  const std::size_t runs_;
  Content content_, cut_, lines_;
  Plan plan_;
  Tiling tiling_;
  const Stage stage_;
  Sheet sheet_;
  Box drawn_;
  ShownLegend legend_;
};

}  // namespace

Sheet lay_out_panels(std::span<const Trace* const> runs, const PanelBand& band, const Look& look,
                     const std::function<SheetPanel(std::size_t)>& panel) {
  PanelSheet sheet(runs, band, look);
  for (std::size_t i = 0; i < runs.size(); ++i) sheet.draw(i, panel(i), i + 1 == runs.size());
  return sheet.finish();
}

}  // namespace gradus
