#include "figure/layout/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figure/text/typesetting.hpp"

namespace gradus::layout {

void lay_out_title(Pen& pen, const Heading& heading, const Box& box) {
  const double s = pen.scale();
  const Paint muted = Paint::of(Tone::muted);
  double y = box.y + heading.first_baseline * s;
  for (std::size_t i = 0; i < heading.title.size(); ++i, y += 40 * s) {
    pen.text(i == 0 ? "title" : fmt::format("title {}", i + 1),
             {{box.x, y}, heading.title[i], Face::bold, title_size * s, Align::left, Paint::of(Tone::ink)});
  }
  y -= 40 * s;
  pen.text("input", {{box.x, y + 28 * s}, heading.input, Face::sans, text_size * s, Align::left, muted});
  // At the right end beside something else, at the left where it has the line to itself
  const bool beside = heading.method_line < 2;
  pen.text("method", {{beside ? box.right() : box.x, y + heading.method_line * 28 * s},
                      heading.method,
                      Face::sans,
                      text_size * s,
                      beside ? Align::right : Align::left,
                      muted});
  y += std::max(1, heading.method_line) * 28 * s;
  for (std::size_t i = 0; i < heading.fault.size(); ++i) {
    y += 26 * s;
    pen.text(
        i == 0 ? "faulty" : fmt::format("faulty {}", i + 1),
        {{box.x, y}, heading.fault[i], Face::bold, text_size * s, Align::left, Paint::text(Role::measure)});
  }
}

void lay_out_sentence(Pen& pen, const Figure& figure, const Box& box, int most) {
  const double s = pen.scale(), size = sentence_size * s;
  pen.rect("panel", {box, Paint::of(Tone::panel), {}, 0, 4 * s, false, Hatch::none, {}});
  pen.rect(
      "bar",
      {{box.x, box.y, 7 * s, box.height}, Paint::of(Tone::accent), {}, 0, 3.5 * s, false, Hatch::none, {}});
  const std::vector<std::string> lines = sentence_lines(figure.sentence, size, box.width - 40 * s, most);
  const double below_first = sentence_line * s * (static_cast<double>(lines.size()) - 1);
  double baseline = box.y + (box.height - below_first) / 2 + (lines.size() < 2 ? 9 : 10.5) * s;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    pen.text(fmt::format("sentence {}", i + 1), {{box.x + 24 * s, baseline},
                                                 lines[i],
                                                 Face::sans,
                                                 size,
                                                 Align::left,
                                                 Paint::of(Tone::ink),
                                                 false,
                                                 Paint::of(Tone::panel)});
    baseline += sentence_line * s;
  }
}

Box crop_box(const Places& at, const Box& drawing, const Look& look, double s) {
  Box all = drawing;
  const auto add = [&all](const Box& slot) {
    if (slot.width > 0) all = all.width > 0 ? around(all, slot) : slot;
  };
  for (const Box& slot : {at.listing, at.table, at.sentence}) add(scaled(slot, s));
  // Title and footer reach to the sheet's edge: only their letters count
  Box letters = at.title;
  letters.y += at.heading.first_baseline - title_size;
  letters.height = at.title.bottom() - letters.y;
  if (at.title.width > 0) add(scaled(letters, s));
  letters = at.footer;
  letters.height -= 12;
  if (at.footer.width > 0) add(scaled(letters, s));
  const double margin = 16 * s;
  const double x = std::max(0.0, std::floor(all.x - margin)), y = std::max(0.0, std::floor(all.y - margin));
  return {x, y, std::min(look.width, std::ceil(all.right() + margin)) - x,
          std::min(look.height, std::ceil(all.bottom() + margin)) - y};
}

Window visible_cells(const Figure& figure, const Look& look) {
  Stage stage = stage_of(*figure.trace, look);
  const Places at = places_of(*figure.trace, look, stage);
  Content content;
  if (at.bare) stage = bare(stage, content);
  const double s = unit_of(look);
  return scene_of(figure, look, stage, scaled(at.drawing, s), s).frame.view;
}

}  // namespace gradus::layout

namespace gradus {
namespace {

/// What the step read and what it made: the table's last two rows.
std::vector<Row> last_rows(const Figure& figure) {
  std::vector<Row> rows;
  const std::size_t count = figure.rows.size();
  for (std::size_t i = count - std::min<std::size_t>(count, 2); i < count; ++i)
    rows.push_back(figure.rows[i].cells);
  return rows;
}

}  // namespace

Sheet lay_out(const Figure& figure, const Look& look) {
  using namespace layout;
  const double s = unit_of(look);
  Stage stage = stage_of(*figure.trace, look);
  const layout::Places at = places_of(*figure.trace, look, stage);
  Content content;
  if (at.bare) stage = bare(stage, content);
  Sheet sheet{look.width, look.height, {}, s};
  Scene scene;
  // A slot that was given a place gets its shapes, in this order
  const auto lay_out_slot = [&](Slot slot, const Box& box, auto draw) {
    if (box.width <= 0) return;
    Pen pen(sheet, slot, s);
    draw(pen, scaled(box, s));
  };
  lay_out_slot(Slot::drawing, at.drawing, [&](Pen& pen, const Box& box) {
    scene = scene_of(figure, look, stage, box, s);
    lay_out_drawing(pen, figure, scene);
  });
  lay_out_slot(Slot::title, at.title, [&](Pen& pen, const Box& box) { lay_out_title(pen, at.heading, box); });
  lay_out_slot(Slot::listing, at.listing, [&](Pen& pen, const Box& box) {
    lay_out_listing(pen, figure, look, box, at.lines, at.spacing);
  });
  lay_out_slot(Slot::table, at.table,
               [&](Pen& pen, const Box& box) { lay_out_table(pen, figure, box, at.rows, at.spacing); });
  lay_out_slot(Slot::sentence, at.sentence,
               [&](Pen& pen, const Box& box) { lay_out_sentence(pen, figure, box, at.sentence_lines); });
  lay_out_slot(Slot::footer, at.footer, [&](Pen& pen, const Box& box) {
    lay_out_footer(pen, figure, box, shown_legend(figure, scene.frame.view), at.footer_lines);
  });
  typeset(sheet, *figure.trace, last_rows(figure));
  if (look.crop) return cropped(std::move(sheet), crop_box(at, scene.settled, look, s));
  return sheet;
}

}  // namespace gradus
