#include "figure/handout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/contract.hpp"
#include "figure/layout/layout.hpp"
#include "figure/text/metrics.hpp"

namespace gradus {
namespace {

using namespace layout;

constexpr std::array<Paper, 2> all_papers{{{"a4", 210 / 25.4 * 96, 297 / 25.4 * 96}, {"letter", 816, 1056}}};

// CSS pixels; 4/3 of one is a point
constexpr double least_letters = 7.0 * 4 / 3;
constexpr double page_margin = 48, header = 40, footer = 26, gap = 16;
constexpr double heading_letters = 17, small_letters = 10;

void require_possible(const PageGrid& grid) {
  expects(grid.columns >= 1 && grid.rows >= 1 && grid.columns <= PageGrid::most_columns &&
              grid.rows <= PageGrid::most_rows,
          "expected 1x1 to {}x{} figures on a page, found {}x{}", PageGrid::most_columns, PageGrid::most_rows,
          grid.columns, grid.rows);
}

/// Where the i-th figure of a page stands, caption included.
Box box_of(const Handout& handout, std::size_t i) {
  const auto columns = static_cast<std::size_t>(handout.grid.columns);
  const double across = handout.paper.width - 2 * page_margin;
  const double down = handout.paper.height - 2 * page_margin - header - footer;
  const double width = (across - gap * (handout.grid.columns - 1)) / handout.grid.columns;
  const double height = (down - gap * (handout.grid.rows - 1)) / handout.grid.rows;
  return {page_margin + static_cast<double>(i % columns) * (width + gap),
          page_margin + header + static_cast<double>(i / columns) * (height + gap), width, height};
}

/// How a figure is laid out in its box: without what stands elsewhere on the page.
Look look_in(const Handout& handout, double width, double height) {
  Look look = handout.look;
  look.width = width;
  look.height = height;
  look.layout = Layout::handout;
  look.crop = false;
  look.least_text = least_letters;
  for (const Slot slot : {Slot::title, Slot::sentence, Slot::footer}) look.slots.erase(slot);
  return look;
}

/// What stands beneath a figure: the step's number, and the sentence where it is wanted.
struct Caption {
  double letters, line;  ///< size of a letter, height of a line
  int lines;             ///< the same for all figures of a run
  double height() const { return lines * line; }
};

Caption caption_of(const Trace& trace, const Handout& handout, const Box& box) {
  const double letters = box.width < 240 ? least_letters : 11;
  Caption caption{letters, 1.32 * letters, 1};
  if (!handout.look.slots.contains(Slot::sentence)) return caption;
  // The sentence gets what it needs, but leaves the figure the larger part of the box
  const int most = std::max(1, static_cast<int>(0.4 * box.height / caption.line) - 1);
  const auto lines = sentence_lines(trace.longest_sentence, letters, box.width, most);
  caption.lines += static_cast<int>(lines.size());
  return caption;
}

void add_text(Sheet& page, Slot slot, std::string id, dvec2 baseline, std::string text, Face face,
              double size, Align align, Tone tone) {
  page.shapes.push_back(
      {slot, std::move(id), TextShape{baseline, std::move(text), face, size, align, Paint::of(tone)}});
}

void add_rule(Sheet& page, Slot slot, std::string id, double y) {
  page.shapes.push_back(
      {slot, std::move(id),
       LineShape{{{page_margin, y}, {page.width - page_margin, y}}, Paint::of(Tone::rule), 1}});
}

void add_header(Sheet& page, const Handout& handout, const Trace& trace) {
  const double baseline = page_margin + 16, right = page.width - page_margin, room = right - page_margin;
  const std::string method = elided(trace.method_title, Face::sans, small_letters, 0.4 * room);
  const double left = room - text_width(method, Face::sans, small_letters) - 20;
  const std::string title = elided(handout.look.title.empty() ? trace.title : handout.look.title, Face::bold,
                                   heading_letters, left);
  const double title_width = text_width(title, Face::bold, heading_letters);
  add_text(page, Slot::title, "title", {page_margin, baseline}, title, Face::bold, heading_letters,
           Align::left, Tone::ink);
  add_text(page, Slot::title, "method", {right, baseline}, method, Face::sans, small_letters, Align::right,
           Tone::muted);
  if (const double rest = left - title_width - 10; rest > 40) {
    add_text(page, Slot::title, "input", {page_margin + title_width + 10, baseline},
             elided(trace.subtitle, Face::sans, 11, rest), Face::sans, 11, Align::left, Tone::muted);
  }
  if (!trace.faulty.empty()) {
    page.shapes.push_back(
        {Slot::title, "faulty",
         TextShape{{page_margin, baseline + 13},
                   elided(trace.wording.say("figure.faulty", fmt::arg("what", trace.faulty)), Face::bold,
                          small_letters, room),
                   Face::bold,
                   small_letters,
                   Align::left,
                   Paint::text(Role::measure)}});
  }
  add_rule(page, Slot::title, "title rule", page_margin + header - 8);
}

void add_footer(Sheet& page, const Handout& handout, const Trace& trace, std::size_t number,
                std::size_t pages) {
  const double baseline = page.height - page_margin;
  const std::string place =
      trace.wording.say("figure.page", fmt::arg("page", number + 1), fmt::arg("pages", pages));
  const double room = page.width - 2 * page_margin - text_width(place, Face::sans, small_letters) - 20;
  add_rule(page, Slot::footer, "footer rule", baseline - 14);
  add_text(page, Slot::footer, "source", {page_margin, baseline},
           elided(handout.source, Face::sans, small_letters, room), Face::sans, small_letters, Align::left,
           Tone::muted);
  add_text(page, Slot::footer, "page", {page.width - page_margin, baseline}, place, Face::sans, small_letters,
           Align::right, Tone::muted);
}

void add_caption(Sheet& page, const Figure& figure, const Box& box, const std::string& prefix,
                 const Caption& caption) {
  const double size = caption.letters;
  double baseline = box.bottom() - caption.height() + 0.8 * caption.line;
  const std::string place =
      figure.phase.empty() ? figure.position : fmt::format("{} · {}", figure.position, figure.phase);
  add_text(page, Slot::sentence, prefix + "position", {box.x, baseline},
           elided(place, Face::bold, size, box.width), Face::bold, size, Align::left, Tone::ink);
  if (caption.lines == 1) return;
  int index = 0;
  for (std::string& line : sentence_lines(figure.sentence, size, box.width, caption.lines - 1)) {
    baseline += caption.line;
    add_text(page, Slot::sentence, fmt::format("{}sentence {}", prefix, ++index), {box.x, baseline},
             std::move(line), Face::sans, size, Align::left, Tone::ink);
  }
}

/// One figure in its box, caption beneath.
void add_figure(Sheet& page, const Handout& handout, const Figure& figure, const Box& box) {
  const std::string prefix = fmt::format("step {} ", text_of(figure.number));
  const Caption caption = caption_of(*figure.trace, handout, box);
  const Box frame{box.x, box.y, box.width, box.height - caption.height() - 4};
  const Look look = look_in(handout, frame.width, frame.height);
  page.unit = unit_of(look);
  page.shapes.push_back({Slot::drawing, prefix + "box",
                         RectShape{frame, {}, Paint::of(Tone::rule), 0.75, 4, false, Hatch::none, {}}});
  Sheet inner = handout.draw(figure, look);
  for (Shape& shape : inner.shapes) {
    page.shapes.push_back(moved(std::move(shape), {frame.x, frame.y}));
    page.shapes.back().id.insert(0, prefix);
  }
  add_caption(page, figure, box, prefix, caption);
}

}  // namespace

std::span<const Paper> papers() { return all_papers; }

const Paper* find_paper(std::string_view name) {
  const auto found = std::ranges::find(all_papers, name, &Paper::name);
  return found == all_papers.end() ? nullptr : &*found;
}

std::size_t handout_page_count(const Handout& handout, std::size_t figures) {
  require_possible(handout.grid);
  const std::size_t on_one = handout.grid.figures();
  return std::max<std::size_t>(1, (figures + on_one - 1) / on_one);
}

Sheet handout_page(const Handout& handout, std::size_t page, std::size_t figures,
                   const std::function<Figure(std::size_t)>& figure) {
  const std::size_t pages = handout_page_count(handout, figures);
  const std::size_t first = page * handout.grid.figures();
  Sheet sheet{handout.paper.width, handout.paper.height, {}};
  for (std::size_t i = first; i < std::min(first + handout.grid.figures(), figures); ++i) {
    const Figure shown = figure(i);
    if (i == first) {
      add_header(sheet, handout, *shown.trace);
      add_footer(sheet, handout, *shown.trace, page, pages);
    }
    add_figure(sheet, handout, shown, box_of(handout, i - first));
  }
  return sheet;
}

}  // namespace gradus
