// The drawing is the hero: how far its marks reach on every slide of the gallery, and that nothing lies on
// anything else in any step, at the sizes that slides have, in every language.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "cli/lecture/lecture.hpp"
#include "figure/layout/layout.hpp"
#include "figure/which_steps.hpp"
#include "support/sanitized.hpp"
#include "support/share.hpp"
#include "support/sheets.hpp"
#include "theme/theme.hpp"

namespace gradus {
namespace {

using test::extent_of;
using test::overlap;
using test::texts_of;

struct GalleryFigure {
  std::string name;
  cli::FigureSpec spec;
};

const std::vector<GalleryFigure>& gallery() {
  static const std::vector<GalleryFigure> figures = [] {
    std::vector<GalleryFigure> all;
    int next = 0;
    for (const cli::LectureFigure& figure : cli::read_lecture(cli::gallery_lecture()).figures)
      if (!test::sanitized || next++ % 4 == 0) all.push_back({figure.name, figure.spec});
    return all;
  }();
  return figures;
}

Trace trace_of(const GalleryFigure& figure, const Language& language) {
  return figure.spec.topic->run(figure.spec.arguments, {.wording = Wording(language)});
}

Look sized(double width, double height) {
  Look look;
  look.width = width;
  look.height = height;
  return look;
}

/// The step that the gallery shows: the story may know a better one than telling_step does.
StepNumber shown_step(const GalleryFigure& figure, const Trace& trace) {
  const StepNumber step = figure.spec.step.value_or(trace.telling);
  return has_step(trace, step) ? step : trace.steps.back().number;  // --step last
}

/// Whole steps, and of long runs 300: as many of each phase, spread over it.
std::vector<StepNumber> steps_of(const Trace& trace, std::size_t most) {
  std::map<std::string, std::vector<StepNumber>> phases;
  for (const TraceStep& step : trace.steps) phases[step.phase].push_back(step.number);
  std::vector<StepNumber> chosen;
  for (const auto& [phase, numbers] : phases) {
    const std::size_t share = std::max<std::size_t>(1, most / phases.size());
    const std::size_t stride =
        trace.steps.size() <= most ? 1 : std::max<std::size_t>(1, numbers.size() / share);
    for (std::size_t i = 0; i < numbers.size(); i += stride) chosen.push_back(numbers[i]);
  }
  std::ranges::sort(chosen);
  return chosen;
}

// --- How far the marks reach ------------------------------------------------------------------------------

TEST(Hero, MarksOfTheGalleryReachFar) {
  // Those that a drawing of their own keeps smaller: what is laid out can't make them larger
  const std::map<std::string, double> smaller{{"bresenham_line_window", 0.93},
                                              {"bresenham_line_dda", 0.91},
                                              {"bresenham_line_exact", 0.91},
                                              {"bresenham_line_first_octant", 0.94},
                                              {"bresenham_line_right_and_first_octant", 0.95},
                                              {"bresenham_circle_window", 0.68},
                                              {"flood_fill_image", 0.78},
                                              {"affine_2d_about_centre", 0.98},
                                              {"affine_3d_vectors", 0.86},
                                              {"viewing_minus_position", 0.69},
                                              {"perspective_keep_z", 0.97},
                                              {"perspective_depth_precision", 0.82},
                                              {"viewport", 0.91},
                                              {"viewport_row_zero_bottom", 0.87},
                                              {"viewport_letterbox", 0.92},
                                              {"viewport_half_up", 0.88},
                                              {"viewport_clamped", 0.93},
                                              {"cohen_sutherland_2d_codes_only", 0.89},
                                              {"cohen_sutherland_3d", 0.99},
                                              {"cohen_sutherland_3d_missed", 0.98},
                                              {"liang_barsky_circle_line", 0.98},
                                              {"liang_barsky_circle_cancellation", 0.85},
                                              {"sutherland_hodgman_pieces", 0.98},
                                              {"sutherland_hodgman_entering", 0.98},
                                              {"sutherland_hodgman_homogeneous", 0.99},
                                              {"perspective_frustum", 0.92},
                                              {"viewport_origins", 0.91},
                                              {"viewing_block", 0.4},
                                              {"back_face_culling_screen", 0.97},
                                              {"back_face_culling_inside", 0.94},
                                              {"back_face_culling_one", 0.91},
                                              {"back_face_culling_result", 0.96},
                                              {"back_face_culling", 0.96},
                                              {"cohen_sutherland_2d_outside", 0.98},
                                              {"cohen_sutherland_2d_and_liang_barsky", 0.89},
                                              {"cohen_sutherland_2d_rounds", 0.89},
                                              {"cohen_sutherland_2d", 0.89},
                                              {"perspective_behind_plane", 0.99},
                                              {"perspective_box", 0.96},
                                              {"perspective_projection", 0.93},
                                              {"bresenham_circle_right_and_late_update", 0.91},
                                              {"bresenham_circle", 0.96},
                                              {"polygon_shading_normals", 0.79},
                                              {"polygon_shading_normals_angle", 0.79},
                                              {"texture_mapping_chain", 0.8},
                                              {"illumination_spot", 0.94},
                                              {"back_face_culling_concave", 0.76},
                                              {"back_face_culling_concave_near", 0.81},
                                              {"poisson_disc_tile", 0.97},
                                              {"poisson_disc_best_candidate", 0.94},
                                              {"a_buffer", 0.95},
                                              {"a_buffer_glass", 0.96},
                                              {"subdivision_surface_loop", 0.95},
                                              {"bezier_curve_compensated", 0.92}};
  for (const GalleryFigure& figure : gallery()) {
    SCOPED_TRACE(figure.name);
    const Trace trace = trace_of(figure, languages().front());
    Playhead playhead(trace);
    const double reach =
        test::reach_of(figure_of(trace, playhead, shown_step(figure, trace)), figure.spec.look);
    const auto known = smaller.find(figure.name);
    if (known == smaller.end()) {
      EXPECT_GE(reach, 1) << figure.name;
    } else {
      EXPECT_GE(reach, known->second) << figure.name;
      EXPECT_LT(reach, 1) << figure.name << " reaches far: take it off the list";
    }
  }
}

// --- Nothing lies on anything else -------------------------------------------------------------------------

bool on_leader(const LineShape& leader, const Box& box) {
  return layout::clipped(leader.points[0], leader.points[1], box).has_value();
}

/// A leader leads to its own point only: over no text, no dot, no other leader.
void leaders_lead_over_nothing(const Sheet& sheet) {
  std::vector<LineShape> leaders;
  for (const Shape& shape : sheet.shapes) {
    if (shape.slot != Slot::drawing || !shape.id.starts_with("leader ")) continue;
    leaders.push_back(std::get<LineShape>(shape.what));
  }
  for (const LineShape& leader : leaders) {
    for (const TextShape* text : texts_of(sheet)) {
      const bool own = layout::inside(leader.points[0], layout::grown(text->box(), 4 * sheet.unit));
      if (!own && on_leader(leader, text->box())) ADD_FAILURE() << "a leader strikes through " << text->text;
    }
  }
  // Next to its point a leader may meet what lies there, too
  std::vector<dvec2> points;
  for (LineShape& leader : leaders) {
    points.push_back(leader.points[1]);
    const dvec2 way = leader.points[0] - leader.points[1];
    const double length = std::hypot(way.x, way.y);
    leader.points[1] += way * (std::min(10 * sheet.unit, 0.95 * length) / std::max(length, 1e-9));
  }
  for (std::size_t i = 0; i < leaders.size(); ++i) {
    for (const Shape& shape : sheet.shapes) {
      const bool dot = shape.slot == Slot::drawing && std::holds_alternative<DiscShape>(shape.what);
      if (dot && !layout::inside(points[i], extent_of(shape)) &&
          on_leader(leaders[i], layout::grown(extent_of(shape), -2 * sheet.unit)))
        ADD_FAILURE() << "a leader crosses " << shape.id;
    }
    for (std::size_t k = 0; k < i; ++k) {
      const auto segment = [](const LineShape& line) {
        return Segment<2, double>{line.points[0], line.points[1]};
      };
      EXPECT_FALSE(layout::cross(segment(leaders[i]), segment(leaders[k])));
    }
  }
}

/// The letters of a text: its box without what is above capitals and, but for tails, below the line.
Box letters_of(const TextShape& text) {
  const Box box = text.box();
  return {box.x, box.y + 0.22 * text.size, box.width, box.height - 0.44 * text.size};
}

/// What a dot covers can't be read, and what covers a dot seems to be its name.
void no_text_lies_over_a_dot(const Sheet& sheet) {
  for (const Shape& shape : sheet.shapes) {
    const DiscShape* dot = std::get_if<DiscShape>(&shape.what);
    if (!dot || shape.slot != Slot::drawing || shape.id.starts_with("ring")) continue;
    for (const Shape& other : sheet.shapes) {
      const TextShape* text = std::get_if<TextShape>(&other.what);
      if (!text || text->is_rim() || other.slot != Slot::drawing) continue;
      const Box letters = letters_of(*text);
      const dvec2 nearest =
          glm::clamp(dot->centre, {letters.x, letters.y}, {letters.right(), letters.bottom()});
      EXPECT_GE(glm::distance(dot->centre, nearest), dot->radius - 0.5 * sheet.unit)
          << text->text << " (" << other.id << ") over " << shape.id;
    }
  }
}

void all_is_apart_and_whole(const Sheet& sheet) {
  test::expect_texts_apart(sheet);
  std::map<Slot, Box> slots;
  for (const Shape& shape : sheet.shapes) {
    const Box box = extent_of(shape);
    if (box.x < 0 || box.y < 0 || box.right() > sheet.width || box.bottom() > sheet.height)
      ADD_FAILURE() << shape.id << " is cut";
    const auto [at, added] = slots.emplace(shape.slot, box);
    if (!added) at->second = test::united(at->second, box);
  }
  for (const auto& [a, box_a] : slots) {
    for (const auto& [b, box_b] : slots) {
      if (a < b) EXPECT_FALSE(overlap(box_a, box_b)) << name_of(a) << " and " << name_of(b);
    }
  }
  leaders_lead_over_nothing(sheet);
}

TEST(Gallery, EveryStepIsApartAndWholeAtEverySize) {
  std::size_t sheets = 0, seen = 0, told = 0;
  const std::vector<Look> looks{sized(1280, 720), sized(960, 720), sized(720, 720), sized(720, 960),
                                sized(1080, 720)};
  for (const GalleryFigure& figure : gallery()) {
    for (const Language& language : languages()) {
      if (!test::in_share(told++, 3)) continue;  // the number of languages is prime to it
      const Trace trace = trace_of(figure, language);
      Playhead playhead(trace);
      // The other languages where slides are shown
      const std::size_t sizes = &language == &languages().front() ? looks.size() : 2;
      for (const StepNumber step : steps_of(trace, test::thinned(300, 30))) {
        const Figure shown = figure_of(trace, playhead, step);
        for (std::size_t i = 0; i < sizes; ++i) {
          if (!test::in_share(seen++, 2)) continue;
          SCOPED_TRACE(fmt::format("{} step {} {} {}x{}", figure.name, text_of(step), language.code(),
                                   looks[i].width, looks[i].height));
          all_is_apart_and_whole(lay_out(shown, looks[i]));
          ++sheets;
        }
      }
    }
  }
  EXPECT_GT(sheets, test::share_of(test::thinned(5000, 40), 6));
}

TEST(Gallery, NoTextOfAFigureLiesOverADot) {
  std::size_t next = 0;
  for (const GalleryFigure& figure : gallery()) {
    for (const Language& language : languages()) {
      if (!test::in_share(next++, 3)) continue;
      const Trace trace = trace_of(figure, language);
      Playhead playhead(trace);
      for (const Look& look : {sized(1280, 720), sized(960, 720)}) {
        SCOPED_TRACE(fmt::format("{} {} {}x{}", figure.name, language.code(), look.width, look.height));
        no_text_lies_over_a_dot(lay_out(figure_of(trace, playhead, shown_step(figure, trace)), look));
      }
    }
  }
}

// --- Numbers, legends ------------------------------------------------------------------------------------

TEST(Gallery, NoNumberOfATableIsShortened) {
  if (test::sanitized) return;
  std::size_t cells = 0, next = 0;
  for (const GalleryFigure& figure : gallery()) {
    if (!test::in_share(next++, 2)) continue;
    const Trace trace = trace_of(figure, languages().front());
    Playhead playhead(trace);
    for (const Look& look : {sized(1280, 720), sized(960, 720), sized(720, 720)}) {
      for (const StepNumber step : steps_of(trace, 20)) {
        const Figure shown = figure_of(trace, playhead, step);
        for (const Shape& shape : lay_out(shown, look).shapes) {
          const TextShape* text = std::get_if<TextShape>(&shape.what);
          if (!text || shape.slot != Slot::table || !shape.id.starts_with("cell ")) continue;
          ++cells;
          const bool said = std::ranges::any_of(shown.rows, [&](const Figure::TableRow& row) {
            return std::ranges::find(row.cells, text->text) != row.cells.end();
          });
          EXPECT_TRUE(said) << figure.name << " step " << text_of(step) << ": " << text->text;
        }
      }
    }
  }
  EXPECT_GT(cells, test::share_of(1000, 2));
}

/// What of a shape the eye sees apart from its place and size.
std::string look_of(const Shape& shape) {
  const Theme& theme = themes().front();
  const auto ink = [&](Paint paint) {
    return paint.part == Paint::Part::none ? std::string("-")
                                           : fmt::format("{:06x}", color_of(paint, theme).hex);
  };
  struct Seen {
    const decltype(ink)& color;
    std::string operator()(const RectShape& s) const {
      return fmt::format("cell {} {} {} {}", color(s.fill), color(s.stroke), s.dashed,
                         static_cast<int>(s.hatch));
    }
    std::string operator()(const AreaShape& s) const {
      return fmt::format("area {} {}", color(s.fill), static_cast<int>(s.hatch));
    }
    std::string operator()(const LineShape& s) const {
      return fmt::format("line {} {} {} {} {}", color(s.stroke), s.width, s.dashed, s.closed, s.arrow);
    }
    std::string operator()(const StrokesShape& s) const { return fmt::format("strokes {}", color(s.stroke)); }
    std::string operator()(const DiscShape& s) const {
      return fmt::format("dot {} {} {}", color(s.fill), color(s.stroke), s.radius);
    }
    std::string operator()(const TextShape&) const { return "text"; }
    std::string operator()(const ImageShape&) const { return "image"; }
  };
  return std::visit(Seen{ink}, shape.what);
}

TEST(Legend, TwoEntriesNeverShareALook) {
  if (test::sanitized) return;
  std::size_t entries = 0;
  for (const GalleryFigure& figure : gallery()) {
    const Trace trace = trace_of(figure, languages().front());
    Playhead playhead(trace);
    for (const StepNumber step : steps_of(trace, 20)) {
      std::map<std::string, std::string> looks;
      for (const Shape& shape : lay_out(figure_of(trace, playhead, step), figure.spec.look).shapes) {
        if (shape.slot == Slot::footer && shape.id.starts_with("legend ") &&
            !shape.id.starts_with("legend text"))
          looks[shape.id] += look_of(shape) + "; ";
      }
      std::set<std::string> different;
      for (const auto& [id, look] : looks) {
        ++entries;
        EXPECT_TRUE(different.insert(look).second)
            << figure.name << " step " << text_of(step) << ": " << id << ", " << look;
      }
    }
  }
  EXPECT_GT(entries, 500u);
}

TEST(Legend, HasEveryEntryThatIsDrawn) {
  if (test::sanitized) return;
  std::size_t entries = 0, next = 0;
  for (const GalleryFigure& figure : gallery()) {
    if (!test::in_share(next++, 3)) continue;
    for (const auto& language : languages()) {
      const Trace trace = trace_of(figure, language);
      Playhead playhead(trace);
      for (const double width : {1280.0, 960.0, 720.0}) {
        Look look = figure.spec.look;
        look.width = width;
        look.height = 720;
        if (look.view) continue;
        for (const StepNumber step : steps_of(trace, 5)) {
          const Figure shown = figure_of(trace, playhead, step);
          const Window view = layout::visible_cells(shown, look);
          const auto drawn = std::ranges::count_if(trace.legend, [&](const LegendEntry& entry) {
            return layout::legend_mark(shown, view, entry).has_value();
          });
          const Sheet sheet = lay_out(shown, look);
          const auto listed = std::ranges::count_if(
              sheet.shapes, [](const Shape& shape) { return shape.id.starts_with("legend text "); });
          entries += static_cast<std::size_t>(listed);
          EXPECT_EQ(listed, drawn) << figure.name << " step " << text_of(step) << " at " << width;
        }
      }
    }
  }
  EXPECT_GT(entries, test::share_of(3000, 3));
}

TEST(Legend, AnEntryOfALineLooksAsInTheDrawing) {
  if (test::sanitized) return;
  std::size_t lines = 0;
  for (const GalleryFigure& figure : gallery()) {
    const Trace trace = trace_of(figure, languages().front());
    Playhead playhead(trace);
    for (const StepNumber step : steps_of(trace, 10)) {
      const Sheet sheet = lay_out(figure_of(trace, playhead, step), figure.spec.look);
      for (const Shape& entry : sheet.shapes) {
        const LineShape* line = std::get_if<LineShape>(&entry.what);
        if (!line || entry.slot != Slot::footer) continue;
        ++lines;
        const bool drawn = std::ranges::any_of(sheet.shapes, [&](const Shape& shape) {
          const LineShape* mark = std::get_if<LineShape>(&shape.what);
          return mark && shape.slot == Slot::drawing && mark->stroke == line->stroke &&
                 mark->width == line->width && mark->dashed == line->dashed;
        });
        const bool cell =
            entry.id.starts_with("legend ") && std::ranges::any_of(sheet.shapes, [&](const Shape& shape) {
              return shape.slot == Slot::footer && shape.id == entry.id &&
                     std::holds_alternative<RectShape>(shape.what);
            });
        EXPECT_TRUE(drawn || cell) << figure.name << " step " << text_of(step) << ": " << entry.id;
      }
    }
  }
  EXPECT_GT(lines, 200u);
}

}  // namespace
}  // namespace gradus
