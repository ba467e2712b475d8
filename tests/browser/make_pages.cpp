// Makes the player pages that player_test.py drives: runs that are made up to reach the corners of the
// player, and so don't depend on any algorithm. Usage: make_pages FOLDER

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

#include "figure/recording.hpp"
#include "web/gallery_page.hpp"
#include "web/player.hpp"

namespace {

using namespace gradus;

Mark label(std::string id, Role role, dvec2 at, std::string text) {
  return {std::move(id), role, Label{at, std::move(text)}};
}

Delta change(std::vector<CellChange> cells, std::vector<Mark> set = {}) {
  return {.removed = {}, .cells = std::move(cells), .set = std::move(set)};
}

Trace& begin(TraceWriter& writer, const Window& cells) {
  Trace& trace = writer.trace();
  trace.topic = "synthetic_line";
  trace.method = "decision_parameter";
  trace.method_title = "decision parameter";
  trace.grid.cells = cells;
  trace.arguments = {{"method", "decision_parameter"}, {"from", "0,0"}, {"to", "7,3"}};
  trace.source_file = "algorithms/synthetic/line.hpp";
  trace.listing = {{38, "int p = 2 * dy - dx;"},
                   {39, "plot(x, y);"},
                   {40, "while (x < to.x) {"},
                   {41, "  x += 1;"},
                   {42, "  if (p < 0) {"},
                   {43, "    p += 2 * dy;        // E"},
                   {45, "  } else {"},
                   {46, "    y += 1;             // NE"},
                   {47, "    p += 2 * (dy - dx);"},
                   {48, "  }"},
                   {50, "  plot(x, y);"},
                   {51, "}"}};
  trace.columns = {{"k"}, {"x"}, {"y"}, {"p"}, {"test", false}, {"step", false}};
  trace.legend = {{Role::past, "drawn before"},
                  {Role::current, "chosen now"},
                  {Role::rejected, "rejected"},
                  {Role::measure, "distance to the ideal line"}};
  return trace;
}

std::string text_of_cell(ivec2 p) { return fmt::format("{},{}", p.x, p.y); }

/// A line in the first octant by the midpoint rule, told as a story would tell it; with `fine`, the sums too.
Trace line(ivec2 from, ivec2 to, const Window& cells, bool fine) {
  TraceWriter writer({});
  Trace& trace = begin(writer, cells);
  trace.title = "Bresenham line";
  trace.subtitle = fmt::format("({}, {}) to ({}, {})", from.x, from.y, to.x, to.y);
  trace.goal = "Choose, column by column, the pixel nearest to the line, with sums only.";
  trace.backdrop = {
      {"ideal", Role::boundary, Stroke{from, to}},
      {"from", Role::input, Dot{from}},
      {"to", Role::input, Dot{to}},
      label("ideal name", Role::boundary, dvec2(from) + 0.8 * (dvec2(to) - dvec2(from)), "ideal line")};
  const std::int64_t dx = std::int64_t{to.x} - from.x, dy = std::int64_t{to.y} - from.y;
  std::int64_t p = 2 * dy - dx;
  ivec2 at = from;

  writer.step(change({{at, CellLook{Role::current, ""}}}), at, 39, [&](TraceStep& step) {
    step.type = "Started";
    step.phase = "set up";
    step.key = text_of_cell(at);
    step.sentence = fmt::format("{} p = 2·{} − {} = {}.", trace.goal, dy, dx, p);
    step.fields = {{"at", at}, {"p", p}};
    step.row = {"0", fmt::to_string(at.x), fmt::to_string(at.y), fmt::to_string(p), "", ""};
  });
  for (std::int64_t k = 1; k <= dx; ++k) {
    const bool east = p < 0;
    const ivec2 before = at;
    const std::int64_t old = p;
    const ivec2 other{at.x + 1, at.y + (east ? 1 : 0)};
    at = {at.x + 1, at.y + (east ? 0 : 1)};
    p += east ? 2 * dy : 2 * (dy - dx);
    const double ideal = from.y + static_cast<double>(dy) * static_cast<double>(k) / static_cast<double>(dx);
    // What was rejected a step ago is bare again
    Delta delta = change({{{before.x, before.y + 1}, std::nullopt},
                          {{before.x, before.y - 1}, std::nullopt},
                          {before, CellLook{Role::past, ""}},
                          {other, CellLook{Role::rejected, ""}},
                          {at, CellLook{Role::current, ""}}});
    delta.set = {{"error", Role::measure, Stroke{{at.x, ideal}, at}},
                 {"chosen", Role::current, Dot{at}},
                 {"not chosen", Role::rejected, Dot{other, true}},
                 label("chosen name", Role::current, at, east ? "E chosen" : "NE chosen"),
                 label("rejected name", Role::rejected, other, east ? "NE rejected" : "E rejected"),
                 label("error name", Role::measure, {at.x, (ideal + at.y) / 2},
                       fmt::format("error {}/{}",
                                   std::abs(std::llround((ideal - at.y) * static_cast<double>(dx))), dx))};
    if (k == dx) {
      delta.cells.push_back({other, std::nullopt});
      delta.set = {{"chosen", Role::current, Dot{at}}, label("chosen name", Role::current, at, "arrived")};
      delta.removed = {"error", "error name", "not chosen", "rejected name"};
    }
    writer.step(std::move(delta), at, east ? 43 : 47, [&](TraceStep& step) {
      step.type = "Stepped";
      step.phase = "main loop";
      step.key = text_of_cell(at);
      step.sentence = east ? fmt::format(
                                 "p = {} < 0: the line passes below the midpoint, so step E to ({}, {}); "
                                 "p = {} + 2·{} = {}.",
                                 old, at.x, at.y, old, dy, p)
                           : fmt::format(
                                 "p = {} ≥ 0: the line passes above the midpoint, so step NE to ({}, {}); "
                                 "p = {} + 2·({} − {}) = {}.",
                                 old, at.x, at.y, old, dy, dx, p);
      step.fields = {{"at", at}, {"p", p}, {"east", east}};
      step.read = {fmt::to_string(k - 1), fmt::to_string(before.x), fmt::to_string(before.y),
                   fmt::to_string(old),   east ? "p < 0" : "p ≥ 0", east ? "E" : "NE"};
      step.row = {fmt::to_string(k), fmt::to_string(at.x), fmt::to_string(at.y), fmt::to_string(p), "", ""};
    });
    trace.pixels.push_back(at);
    if (!fine || k == dx) continue;
    for (int i = 1; i <= 2; ++i) {
      writer.fine(change({}, {{"sum", Role::candidate, Dot{{at.x, at.y + 0.25 * i}, true}}}), at, 41 + i,
                  [&](TraceStep& step) {
                    step.type = "Summed";
                    step.phase = "main loop";
                    step.sentence = fmt::format("Term {} of the sum for step {}.", i, k);
                  });
    }
  }
  trace.telling = {std::min<std::int64_t>(4, dx), 0};
  return std::move(writer).finish();
}

/// A run of many steps over a grid with a picture.
Trace many(int steps) {
  TraceWriter writer({});
  Trace& trace = begin(writer, {{0, 0}, {199, 199}});
  trace.title = "Ten thousand steps";
  trace.subtitle = "a field of 200 × 200";
  trace.goal = "Visit the cells row by row.";
  trace.grid.y_up = false;
  Image picture(200, 200, Rgba8{238, 244, 232, 255});
  for (int i = 0; i < 200; ++i) picture[{i, (i * 7) % 200}] = {90, 120, 80, 255};
  trace.grid.picture = std::make_shared<const Image>(picture);
  ivec2 last{-1, -1};
  for (int i = 0; i <= steps; ++i) {
    const ivec2 at{i % 200, i / 200};
    Delta delta = change({{at, CellLook{Role::current, ""}}});
    if (i > 0) delta.cells.insert(delta.cells.begin(), {last, CellLook{Role::past, ""}});
    last = at;
    writer.step(std::move(delta), at, i % 2 == 0 ? 41 : 47, [&](TraceStep& step) {
      step.type = "Visited";
      step.phase = i == 0 ? "set up" : i < steps / 2 ? "upper half" : "lower half";
      step.key = text_of_cell(at);
      step.sentence =
          fmt::format("Cell ({}, {}) is number {}: it lies right of the one before.", at.x, at.y, i);
      step.fields = {{"at", at}, {"index", std::int64_t{i}}};
      step.row = {
          fmt::to_string(i), fmt::to_string(at.x), fmt::to_string(at.y), fmt::to_string(i * 3), "", ""};
    });
  }
  return std::move(writer).finish();
}

/// Every text that can come from outside tries to get out of its place.
Trace hostile() {
  const std::string evil =
      "</script><script>window.hacked=1</script><img src=x "
      "onerror=window.hacked=1>{{player.js}}<!--\xe2\x80\xa8\xff\"'&";
  TraceWriter writer({});
  Trace& trace = begin(writer, {{0, 0}, {5, 3}});
  trace.title = trace.subtitle = trace.method_title = trace.faulty = trace.goal = evil;
  trace.grid.x_name = trace.grid.y_name = "<b>";
  trace.columns = {{evil}, {"<i>y</i>", false}};
  trace.listing = {{1, evil}, {2, "<script>window.hacked=1</script>"}};
  trace.legend = {{Role::current, evil}};
  trace.backdrop = {label(evil, Role::boundary, {1, 1}, "<b>bold</b>")};
  for (int i = 0; i < 3; ++i) {
    writer.step(change({{{i, 1}, CellLook{Role::current, "<i>"}}},
                       {label(evil + "2", Role::current, {i, 2}, "</text>")}),
                {i, 1}, 2, [&](TraceStep& step) {
                  step.type = step.phase = step.sentence = evil;
                  step.key = "<x>";
                  step.fields = {{evil, evil}};
                  step.row = {evil, "<td>"};
                });
  }
  trace.result = {{evil, evil}};
  return std::move(writer).finish();
}

/// What a recording that starts late still shows of the steps before.
Trace late() {
  TraceWriter writer({4, 3});
  Trace& trace = begin(writer, {{0, 0}, {9, 2}});
  trace.title = "Late recording";
  trace.goal = "Go right.";
  for (int i = 0; i < 9; ++i) {
    writer.step(change({{{i, 1}, CellLook{Role::past, ""}}}, {{"at", Role::current, Dot{{i, 1}}}}), {i, 1},
                41, [&](TraceStep& step) { step.sentence = fmt::format("Step {}.", i); });
  }
  return std::move(writer).finish();
}

/// The page in another language; the run's own texts are its story's business.
Trace german() {
  Trace trace = line({0, 0}, {7, 3}, {{0, 0}, {7, 4}}, false);
  trace.wording = Wording(*find_language("de"));
  return trace;
}

/// The same line by a fault that takes too little for E.
Trace faulty(Trace trace) {
  for (std::size_t i = 5; i < trace.listing.size(); ++i) trace.listing[i].number += 2;
  trace.struck = {{43, "    p += 2 * dy;", Change::struck}, {44, "    // E", Change::struck}};
  trace.listing[5] = {45, "    p += dy;", Change::added};
  for (TraceStep& step : trace.steps) step.line += step.line > 42 ? 2 : 0;
  return trace;
}

void write(const std::string& folder, const std::string& name, const Trace& trace,
           const PlayerOptions& options = {}) {
  const Colophon colophon{trace.title + ", steps", "The run of " + trace.title,
                          "gradus figure bresenham_line --from 0,0 --to 7,3", ""};
  std::ofstream file(folder + "/" + name + ".html", std::ios::binary);
  file << player_page(trace, colophon, options);
  if (!file.flush()) throw std::runtime_error("cannot write into " + folder);
}

}  // namespace

int main(int count, char** arguments) try {
  if (count != 2) throw std::runtime_error("usage: make_pages FOLDER");
  const std::string folder = arguments[1];
  write(folder, "line", line({0, 0}, {7, 3}, {{0, 0}, {7, 4}}, false));
  write(folder, "fine", line({0, 0}, {7, 3}, {{0, 0}, {7, 4}}, true));
  write(folder, "other", line({-2, 1}, {9, 6}, {{-2, 0}, {9, 7}}, false));
  write(folder, "long", line({0, 0}, {120, 47}, {{0, 0}, {120, 50}}, false));
  write(folder, "many", many(10'000));
  write(folder, "hostile", hostile());
  write(folder, "german", german());
  const Trace short_line = line({0, 0}, {7, 3}, {{0, 0}, {7, 4}}, false);
  write(folder, "topic", short_line, {.theme = "greyscale", .topic_page = "topics/a line.html"});
  for (const Slot dropped : all_slots) {
    PlayerOptions options;
    options.slots.erase(dropped);
    write(folder, fmt::format("without_{}", name_of(dropped)), short_line, options);
  }
  for (const Slot kept : all_slots)
    write(folder, fmt::format("only_{}", name_of(kept)), short_line, {.slots = {kept}});
  write(folder, "faulty", faulty(short_line));
  write(folder, "late", late());
  constexpr int far = INT32_MAX;
  write(folder, "huge",
        line({far - 300, far - 200}, {far - 1, far - 40}, {{INT32_MIN, INT32_MIN}, {far, far}}, false));

  const std::string odd = "<script>window.hacked=1</script>\"'";
  const std::vector<Card> cards{
      {.slug = "line",
       .title = "Bresenham line",
       .chapter = "scan_conversion",
       .caption = "Step 4: the line passes above the midpoint.",
       .group = {"bresenham_line", "Bresenham line", "topics/line.html"},
       .command = "gradus figure bresenham_line --from 0,0 --to 7,3 -o line.svg",
       .thumbnail = "line.svg",
       .player = "line.html",
       .downloads = {{"SVG", "line.svg"}, {"PDF", "line.pdf"}},
       .words = {"bresenham", "decision_parameter"},
       .zip = "line-steps.zip",
       .snippets = {{"Beamer", "\\begin{frame}\n  \\includegraphics<1>[page=1]{line.pdf}\n\\end{frame}"},
                    {"reveal.js", "<section>\n  <img src=\"line-0.svg\">\n</section>"},
                    {"Markdown", "![Bresenham line](line.svg)"}}},
      {.slug = odd,
       .title = odd,
       .chapter = odd,
       .caption = odd,
       .group = {odd, odd, odd},
       .name = odd,
       .faulty = odd,
       .command = odd,
       .thumbnail = "javascript:window.hacked=1",
       .player = "a folder/#1?.html",
       .downloads = {{odd, odd}},
       .words = {odd},
       .zip = odd,
       .snippets = {{odd, odd}}}};
  std::ofstream(folder + "/gallery.html", std::ios::binary) << gallery_page(cards);
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
