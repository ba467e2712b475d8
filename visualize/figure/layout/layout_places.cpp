// Where the slots go: the arrangement that shows the drawing best and leaves the texts enough.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/contract.hpp"
#include "figure/layout/layout.hpp"

namespace gradus::layout {
namespace {

/// The drawing is the hero: so much of a slide's width, or of the height between title and sentence, the
/// marks of all its steps fill if they can. A little above the 54 and 90 % that one step's shall reach.
constexpr double hero_width = 0.61, hero_height = 0.97;
/// Where the code stands below: of what there is between title and sentence.
constexpr double upright_width = 0.9, upright_height = 0.62;
constexpr double wide_sheet = 1.6;  ///< width to height: from here on the code may stand beside the drawing
constexpr double many_cells = 14;   ///< along a side of a view that follows the step: no reader misses more
constexpr int most_rows = 40;
constexpr double crowded = -10;      ///< of what is worthless, since lines of text lie on each other
constexpr double poor_paper = 0.25;  ///< what a paper is worth that no column of the table should cost
/// Characters in a line of a listing beside the drawing, the first choice first.
constexpr std::array<std::size_t, 5> line_lengths{36, 33, 30, 27, 24};

constexpr std::array<Least, 4> content_with{Least{12, 4}, Least{6, 4}, Least{4, 3}, Least{4, 2}};
constexpr std::size_t on_a_slide = 1;  ///< the first that a slide tries; a handout has room for more text
/// What each of them costs in the choice, and a step of the line length, and a column left out.
constexpr double cost_of_less = 0.12, cost_of_shorter = 0.03, cost_of_unusual = 0.02;
constexpr double cost_of_tight = 0.002;  ///< less than what its room is worth to a drawing
constexpr double tight_gap = 0.5;        ///< what is left of the usual gap between slots
constexpr double tight_overhang = 0.5;   ///< of the margin: so far a paper reaches into it that got smaller
constexpr double cost_of_column = 0.2, cost_of_column_above_code = 0.08;
constexpr double most_for_whole_lines = 0.3;  ///< of the drawing's worth, rather than break lines
constexpr double last_resort = 5;             ///< where nothing else shows anything

bool stands_below(const Page& page) { return page.width < wide_sheet * page.height; }

Wants wants_of(const Trace& trace, const Look& look, const Page& page, ListingRows& listing_rows) {
  Wants wants;
  wants.trace = &trace;
  wants.look = &look;
  wants.listing_rows = &listing_rows;
  wants.listing = look.slots.contains(Slot::listing) && !trace.listing.empty();
  wants.table = look.slots.contains(Slot::table) && !trace.columns.empty();
  wants.rows = static_cast<int>(std::clamp<std::int64_t>(trace.last + 1, 2, most_rows));
  wants.gutter = page.margin * 0.4;
  wants.row_gutter = wants.gutter;
  wants.column_gap = page.margin * 0.6;
  return wants;
}

// --- What may be chosen ---------------------------------------------------------------------------

/// A column beside the drawing, and what it costs.
struct ColumnChoice {
  double width, cost;
  Spacing spacing = Spacing::usual;
};

/// Widths of a listing in a column, the first choice first.
std::vector<ColumnChoice> listing_choices(const Wants& wants) {
  const std::size_t longest = longest_line(*wants.trace);
  const auto width = [&](std::size_t length, Spacing spacing) {
    return listing_width(*wants.trace, *wants.look, std::min(length, longest), spacing);
  };
  std::vector<ColumnChoice> choices;
  if (wants.whole_lines) {
    for (const Spacing spacing : {Spacing::usual, Spacing::tight}) {
      const double cost = spacing == Spacing::tight ? cost_of_tight : 0;
      for (std::size_t length = longest; length >= line_lengths.back(); --length)
        choices.push_back({width(length, spacing), cost, spacing});
    }
    return choices;
  }
  double shorter = 0;
  for (const std::size_t length : line_lengths) {
    choices.push_back({width(length, Spacing::usual), shorter});
    if (length <= longest) shorter += cost_of_shorter;
  }
  return choices;
}

/// The first is the widest: all columns of the table, no line of the listing broken more than it must.
std::vector<ColumnChoice> column_choices(const Wants& wants) {
  const Trace& trace = *wants.trace;
  if (!wants.listing) return {{std::max(table_width(trace), 280.0), 0}, {least_table_width(trace, 0), 0}};
  std::vector<ColumnChoice> choices;
  for (const ColumnChoice& listing : listing_choices(wants)) {
    const bool first = choices.empty() || choices.back().spacing != listing.spacing;
    const std::size_t spare = wants.table ? spare_columns(trace) : 0;
    for (std::size_t left_out = 0; left_out <= spare; ++left_out) {
      const double table = wants.table ? least_table_width(trace, left_out, listing.spacing) : 0;
      const double width = std::max(listing.width, table);
      if ((first && left_out == 0) || width < choices.back().width - 1)
        choices.push_back({width, listing.cost, listing.spacing});
      if (table <= listing.width) break;
    }
  }
  return choices;
}

/// The wants with a column.
Wants with_column(Wants wants, const ColumnChoice& column) {
  wants.column_width = column.width;
  wants.spacing = column.spacing;
  if (column.spacing == Spacing::tight) {
    wants.column_gap *= tight_gap;
  } else {
    wants.overhang = 0;
  }
  return wants;
}

/// Ways to stand below the drawing. A listing of whole lines takes no more of a table that stands close than
/// it needs.
std::vector<Wants> layings_below(const Wants& wants) {
  std::vector<Wants> layings{wants};
  if (!wants.whole_lines || !wants.table) return layings;
  for (std::size_t length = line_lengths.back(); length <= longest_line(*wants.trace); ++length) {
    Wants with = wants;
    with.spacing = Spacing::tight;
    with.row_gutter *= tight_gap;
    with.characters = length;
    layings.push_back(with);
  }
  return layings;
}

/// One arrangement with its sizes, and how much it costs that it gives the texts less than others.
struct Candidate {
  Arrange arrange;
  Wants wants;
  Least least;
  double cost;
};

/// Calls f with each candidate, until it returns true.
template <class F>
void for_each_candidate(const Wants& wants, const Page& page, const Look& look, F f) {
  const std::vector<ColumnChoice> columns =
      wants.listing || wants.table ? column_choices(wants) : std::vector<ColumnChoice>{};
  const std::vector<Wants> layings = layings_below(wants);
  const bool below = stands_below(page);
  for (std::size_t i = look.layout == Layout::slide ? on_a_slide : 0; i < content_with.size(); ++i) {
    const double less = cost_of_less * static_cast<double>(i);
    const auto offer = [&](Arrange arrange, const Wants& what, double cost) {
      return f(Candidate{arrange, what, content_with[i], less + cost});
    };
    if (offer(alone, wants, 0)) return;
    if (!below || !wants.listing) {
      for (const ColumnChoice& column : columns)
        if (offer(beside, with_column(wants, column), column.cost)) return;
      if (offer(abreast, wants, cost_of_unusual)) return;
    }
    for (const Arrange arrange : {shelf, ledge, stack}) {
      for (const Wants& laying : arrange == ledge ? layings : std::vector{wants}) {
        const double tight = laying.spacing == Spacing::tight ? cost_of_tight : 0;
        if (offer(arrange, laying, tight + (below ? 0 : cost_of_unusual))) return;
      }
    }
    if (!below || !wants.listing) continue;
    for (const ColumnChoice& column : columns)
      if (offer(beside, with_column(wants, column), last_resort)) return;
  }
}

// --- How good it is -------------------------------------------------------------------------------

/// How well a drawing shows its stage, at most 1: all of it before a part, then how far the marks reach; of a
/// part, how many cells are in view.
double worth_of(const Fit& shown, const Stage& stage, const Page& page) {
  if (shown.follows) {
    const auto columns = static_cast<double>(shown.columns), rows = static_cast<double>(shown.rows);
    const double side = std::sqrt(std::min(columns, 2 * rows) * std::min(rows, 2 * columns));
    return -2 + std::min(side / many_cells, 1.0);
  }
  const dvec2 marks = stage.core * shown.cell;
  const double across = stands_below(page) ? upright_width * page.middle.width : hero_width * page.width;
  const double up = (stands_below(page) ? upright_height : hero_height) * page.middle.height;
  const double reach = std::min(1.0, std::max(marks.x / across, marks.y / up));
  if (shown.cell < stage.lines) return reach + crowded;
  return shown.cell >= stage.largest_cell ? 1 : shown.cell < stage.easy_cell ? reach - 0.5 : reach;
}

struct Choice {
  Body body;
  double worth = 0;
  double cost = 0;
};

double cost_of_table(const Wants& wants, const Body& body, const Page& page) {
  if (!wants.table) return 0;
  const std::size_t shown = table_columns(*wants.trace, body.table.width, body.spacing).size();
  return static_cast<double>(wants.trace->columns.size() - shown) *
         (stands_below(page) ? cost_of_column_above_code : cost_of_column);
}

/// Whether a line that some step shows is broken.
bool breaks_a_line(const Wants& wants, const Body& body) {
  if (body.listing.width <= 0) return false;
  const std::size_t columns = listing_columns(*wants.trace, *wants.look, body.listing.width, body.spacing);
  return wants.listing_rows->break_a_shown_line(columns, body.lines);
}

std::optional<Choice> choice_of(const Candidate& candidate, const Stage& stage, const Page& page) {
  const std::optional<Body> body = candidate.arrange(page.middle, candidate.wants, candidate.least);
  if (!body || (candidate.wants.whole_lines && breaks_a_line(candidate.wants, *body))) return std::nullopt;
  const std::optional<Fit> shown = fit(stage, body->drawing.width, body->drawing.height);
  if (!shown) return std::nullopt;
  return Choice{*body, worth_of(*shown, stage, page),
                candidate.cost + cost_of_table(candidate.wants, *body, page)};
}

/// As many lines and rows as do the drawing no harm; a column beside it has them already.
Choice with_more_text(const Choice& choice, Candidate candidate, const Stage& stage, const Page& page) {
  if (candidate.arrange == alone || candidate.arrange == beside || candidate.arrange == abreast)
    return choice;
  const Least least = candidate.least;
  for (int more = most_rows; more > 0; --more) {
    candidate.least = {least.lines + more, least.rows + more};
    const auto better = choice_of(candidate, stage, page);
    if (better && better->worth >= choice.worth - 1e-9) return *better;
  }
  return choice;
}

std::optional<Choice> best_of(const Wants& wants, const Look& look, const Stage& stage, const Page& page) {
  std::optional<Choice> best;
  std::optional<Candidate> chosen;
  double most = 0;
  for_each_candidate(wants, page, look, [&](const Candidate& candidate) {
    if (best && 1 - candidate.cost <= most) return false;  // however good
    const auto choice = choice_of(candidate, stage, page);
    if (!choice || (best && choice->worth - choice->cost <= most)) return false;
    best = choice;
    chosen = candidate;
    most = choice->worth - choice->cost;
    return false;
  });
  return best ? std::optional(with_more_text(*best, *chosen, stage, page)) : std::nullopt;
}

// --- The choice -----------------------------------------------------------------------------------

/// In the small boxes of a handout's page the listing gives way, then the table.
bool may_give_way(const Look& look) { return look.layout == Layout::handout && look.least_text > 0; }

bool legible(const Choice& choice) { return choice.worth > -0.5 || choice.worth > -2 + 6 / many_cells; }

ivec2 largest_in(const Page& page, Wants wants, const Look& look, const Stage& stage) {
  if (may_give_way(look)) wants.listing = wants.table = false;
  ivec2 largest{0, 0};
  const auto cells = [](ivec2 size) { return std::int64_t{size.x} * size.y; };
  for_each_candidate(wants, page, look, [&](const Candidate& candidate) {
    if (const auto body = candidate.arrange(page.middle, candidate.wants, candidate.least)) {
      const Fit room = capacity(stage, body->drawing.width, body->drawing.height);
      const ivec2 size{static_cast<int>(room.columns), static_cast<int>(room.rows)};
      if (cells(size) > cells(largest)) largest = size;
    }
    return false;
  });
  return largest;
}

/// Whether the drawing, or what lies on a paper, is so small that the table had better give columns up.
bool poor(const std::optional<Choice>& choice, const Stage& stage) {
  return !choice || (stage.content && choice->worth < poor_paper);
}

/// Leaves in the wants what may be shown.
std::optional<Choice> choice_for(const Page& page, Wants& wants, const Look& look, const Stage& stage) {
  auto choice = best_of(wants, look, stage, page);
  for (bool* slot : {&wants.listing, &wants.table}) {
    if (!may_give_way(look) || (choice && legible(*choice))) break;
    *slot = false;
    choice = best_of(wants, look, stage, page);
  }
  // A table of few columns stands beside the listing, and both below the drawing
  const std::size_t most = stage.fixed ? 0 : spare_columns(*wants.trace);
  for (std::size_t spare = 1; spare <= most && poor(choice, stage); ++spare) {
    wants.columns_to_spare = spare;
    const auto other = best_of(wants, look, stage, page);
    if (!choice || (other && other->worth > choice->worth)) choice = other;
  }
  return choice;
}

/// The best that breaks no line: where that takes much of the drawing, the table had better give columns up.
std::optional<Choice> choice_of_whole_lines(const Page& page, Wants wants, const Look& look,
                                            const Stage& stage) {
  wants.whole_lines = true;
  std::optional<Choice> choice;
  const std::size_t most = stage.fixed || !wants.table ? 0 : spare_columns(*wants.trace);
  for (wants.columns_to_spare = 0; wants.columns_to_spare <= most; ++wants.columns_to_spare) {
    const auto other = best_of(wants, look, stage, page);
    if (!choice || (other && other->worth - other->cost > choice->worth - choice->cost)) choice = other;
  }
  return choice;
}

/// Listing and table without a drawing. (The small boxes of a handout have no room for whole lines.)
Body texts_of(const Page& page, const Wants& wants) {
  Wants whole = wants;
  whole.whole_lines = !may_give_way(*wants.look);
  for (const Wants& laying : layings_below(whole)) {
    const Body body = without_drawing(page.middle, laying);
    if (!breaks_a_line(laying, body)) return body;
  }
  return without_drawing(page.middle, wants);
}

Body body_of(const Page& page, Wants wants, const Look& look, const Stage& stage) {
  if (!look.slots.contains(Slot::drawing)) return texts_of(page, wants);
  auto choice = choice_for(page, wants, look, stage);
  if (choice && !may_give_way(look) && breaks_a_line(wants, choice->body)) {
    auto other = choice_of_whole_lines(page, wants, look, stage);
    if (stage.content && other && other->worth < choice->worth) {
      Wants wider = wants;
      wider.overhang = page.margin * tight_overhang;
      other = choice_of_whole_lines(page, wider, look, stage);
    }
    if (other && other->worth >= choice->worth - most_for_whole_lines) choice = other;
  }
  if (choice) return choice->body;
  if (!stage.fixed) return texts_of(page, wants);
  const ivec2 largest = largest_in(page, wants, look, stage);
  contract_violated(fmt::format("expected at most {} x {} cells for this size, found {} x {}", largest.x,
                                largest.y, stage.cells.width(), stage.cells.height()));
}

/// Whether lines of text on the paper would lie on each other.
bool is_crowded(const Stage& stage, const Body& body) {
  const std::optional<Fit> shown = fit(stage, body.drawing.width, body.drawing.height);
  return !shown || shown->cell < stage.lines;
}

}  // namespace

Places places_of(const Trace& trace, const Look& look, const Stage& stage) {
  const Page page = page_of(trace, look);
  ListingRows listing_rows(trace);
  const Wants wants = wants_of(trace, look, page, listing_rows);
  Body body = body_of(page, wants, look, stage);
  Places at = page.at;
  // Without what is aside rather than with texts that lie on each other, or with lines of code that are
  // broken
  const bool breaks = !may_give_way(look) && breaks_a_line(wants, body);
  if (stage.content && stage.lines > 0 && (is_crowded(stage, body) || breaks)) {
    Content content;
    body = body_of(page, wants, look, bare(stage, content));
    at.bare = true;
  }
  at.drawing = body.drawing;
  at.listing = body.listing;
  at.table = body.table;
  at.lines = body.lines;
  at.rows = body.rows;
  at.spacing = body.spacing;
  return at;
}

}  // namespace gradus::layout

namespace gradus {

ivec2 largest_view(const Trace& trace, const Look& look) {
  const layout::Page page = layout::page_of(trace, look);
  const layout::Stage stage = layout::stage_of(trace, look);
  layout::ListingRows listing_rows(trace);
  return layout::largest_in(page, layout::wants_of(trace, look, page, listing_rows), look, stage);
}

}  // namespace gradus
