// The tour's stages of pixels: from rasterization to the picture.

#include "stories/pipeline/textbook_chain/tour.hpp"

namespace gradus::textbook_chain {

using namespace pipeline;

void Tour::rasterization() {
  std::size_t corner = 0;
  for (const Snapped& triangle : run_.snapped) {
    if (triangle.id != piece_.id) continue;
    for (std::size_t k = 0; k < 3; ++k) snapped_corner(triangle, k, corner++);
  }
  std::int64_t covered = 0;
  std::map<int, CoveredRow> rows;
  for (const Fragment& f : run_.covered) {
    if (f.id != piece_.id) continue;
    ++covered;
    rows[f.pixel.y].add(f);
  }
  for (const auto& [y, row] : rows) {
    covered_row(y, row);
    if (y == pixel_.y && run_.fault != Fault::expanded_edges) edge_functions();
  }
  if (run_.fault == Fault::expanded_edges) expanded_edge_functions();
  if (std::ranges::none_of(run_.covered, [&](const Fragment& f) { return f.pixel == pixel_; })) {
    fine(views_.rastered(), "Uncovered",
         {.text = "uncovered", .words = {pixel_word()}, .key = pixel_key(pixel_)}, "Covered");
  }
  Event event{.text = "rasterization",
              .facts = {{"covered", covered}, {"fragments", std::ssize(run_.covered)}},
              .words = {face_word(), {"all", run_.covered.size()}, {"triangles", run_.snapped.size()}},
              .count = covered};
  const bool closed = run_.fault == Fault::closed_half_planes;
  if (closed || run_.fault == Fault::expanded_edges) {
    event.text = closed ? "rasterization_closed" : "rasterization_expanded";
    event.facts.push_back({"misjudged", std::ssize(run_.misjudged)});
    event.count.reset();
  }
  milestone(views_.rastered(), "Rasterization", std::move(event));
}

void Tour::snapped_corner(const Snapped& triangle, std::size_t k, std::size_t corner) {
  const dvec2 exact = triangle.exact[k].at;
  const ivec2 at = triangle.corners[k].at;
  const std::string name = fmt::format("p{}", corner), x = real_text(at.x / 256.0),
                    y = real_text(at.y / 256.0), place = fmt::format("({},\u00a0{})", x, y);
  fine(views_.raster(-1, {corner, name}), "Snapped",
       {.text = "snapped",
        .facts = {{"x", at.x}, {"y", at.y}},
        .words = {{"name", name},
                  {"x", real_text(exact.x)},
                  {"y", real_text(exact.y)},
                  {"column", at.x},
                  {"row", at.y},
                  {"place", place}},
        .row = row(name, {x, y}),
        .key = name});
}

std::int64_t Tour::right_count(int y, std::int64_t covered) const {
  for (const Misjudged& wrong : run_.misjudged) {
    if (wrong.id == piece_.id && wrong.pixel.y == y) covered += wrong.covered ? -1 : 1;
  }
  return covered;
}

void Tour::covered_row(int y, const CoveredRow& covered) {
  const ivec2 first{covered.first, y};
  Event event{.text = "covered",
              .facts = {{"row", y}, {"first", covered.first}, {"last", covered.last}},
              .count = covered.count,
              .row = row(first, dvec3(dvec2(first) + 0.5, covered.depth)),
              .key = pixel_key(first)};
  const bool wrong = std::ranges::any_of(
      run_.misjudged, [&](const Misjudged& m) { return m.id == piece_.id && m.pixel.y == y; });
  if (wrong) {
    event.text = "covered_wrong";
    event.words = {{"found", covered.count}, {"right", right_count(y, covered.count)}};
    event.count.reset();
  }
  fine(views_.raster(y), "Covered", std::move(event));
}

void Tour::edge_functions() {
  const auto& [fragment, edges] = std::pair{views_.way().fragment, views_.way().edges};
  if (!fragment || !edges) return;
  const dvec3 e = edges->values;
  fine(views_.edge_functions(*edges), "EdgesTested",
       {.text = "covered.edges",
        .facts = {{"e0", e[0]}, {"e1", e[1]}, {"e2", e[2]}, {"depth", fragment->depth}},
        .words = {pixel_word(),
                  {"a", real_text(e[0])},
                  {"b", real_text(e[1])},
                  {"c", real_text(e[2])},
                  {"depth", real_text(fragment->depth)}},
        .row = row(words_.say("edges"), e),
        .key = pixel_key(pixel_),
        .decides = yes_or_no(words_, "question.inside", {pixel_word()}, true, "inside")},
       "Covered");
}

void Tour::expanded_edge_functions() {
  const auto wrong = std::ranges::find_if(
      run_.misjudged, [&](const Misjudged& m) { return m.id == piece_.id && m.pixel == pixel_; });
  if (wrong == run_.misjudged.end()) return;
  const Snapped& triangle = run_.snapped[static_cast<std::size_t>(wrong->triangle)];
  const auto edges = triangle_coverage::edges_of(on_grid(triangle.corners));
  const dvec3 found = triangle_coverage::FarEdges(edges, dvec2(far_origin)).areas_at(pixel_);
  const EdgeValues exact = edge_values(run_, wrong->triangle, pixel_);
  fine(views_.edge_functions(exact, found), "EdgesTested",
       {.text = "expanded.edges",
        .facts = {{"e0", found[0]}, {"e1", found[1]}, {"e2", found[2]}},
        .words = {pixel_word(), {"found", place_text(found)}, {"exact", place_text(exact.values)}},
        .row = row(words_.say("edges"), found),
        .key = pixel_key(pixel_),
        .decides = yes_or_no(words_, "question.inside", {pixel_word()}, wrong->covered, "inside", "outside")},
       "Covered");
}

void Tour::visibility() {
  for (const DepthTested& test : run_.tests) {
    if (test.fragment.pixel == pixel_) depth_test(test);
  }
  if (const Shaded* shaded = run_.shaded_at(pixel_)) {
    const dvec3 sum(shaded->colour);
    constexpr double unseen = 5e-4;  // a byte of the picture has no more than three decimals
    fine(views_.shading(), "Shaded",
         {.text = "shaded",
          .facts = {{"red", sum.x}, {"green", sum.y}, {"blue", sum.z}},
          .words = {pixel_word(),
                    {"ambient", place_text(shaded->ambient, unseen)},
                    {"diffuse", place_text(shaded->diffuse, unseen)},
                    {"specular", place_text(shaded->specular, unseen)},
                    {"sum", place_text(sum)}},
          .row = row(words_.say("light"), sum),
          .key = pixel_key(pixel_)});
  }
  const auto covered = std::ranges::count(run_.covered, piece_.id, &Fragment::id);
  const auto won =
      std::ranges::count_if(run_.shaded, [&](const Shaded& s) { return s.fragment.id == piece_.id; });
  milestone(views_.visibility(), "HiddenSurfaceRemovalAndShading",
            {.text = "visibility",
             .facts = {{"nearest", won}, {"covered", covered}, {"visible", std::ssize(run_.shaded)}},
             .words = {face_word(), {"shown", run_.shaded.size()}, {"fragments", run_.tests.size()}},
             .count = won});
}

void Tour::depth_test(const DepthTested& test) {
  const Fragment& f = test.fragment;
  Event event{.text = "tested.first",
              .facts = {{"face", f.id.face}, {"depth", f.depth}, {"nearer", test.nearer}},
              .words = {pixel_word(), {"depth", real_text(f.depth)}},
              .row = row(words_.say("face", {{"face", f.id.face}}), dvec3(dvec2(f.pixel) + 0.5, f.depth)),
              .key = pixel_key(f.pixel),
              .decides = yes_or_no(words_, "question.nearer", {{"face", f.id.face}, pixel_word()},
                                   test.nearer, "nearer", "farther")};
  if (test.before) {
    event.text = test.nearer ? "tested.nearer" : "tested.farther";
    event.words.push_back({"other", test.before->id.face});
    event.words.push_back({"kept", real_text(test.before->depth)});
  }
  fine(views_.depths(test), "DepthTested", std::move(event), {}, "keep_nearest(");
}

void Tour::output() {
  const bool seen = run_.shaded_at(pixel_);
  for (const Written& w : run_.written) {
    if (w.pixel != pixel_) continue;
    const auto [red, green, blue] = std::array{w.colour.r, w.colour.g, w.colour.b};
    fine(views_.output(false), "Written",
         {.text = seen ? "written.lit" : "written.background",
          .facts = {{"red", red}, {"green", green}, {"blue", blue}},
          .words = {pixel_word(), {"light", place_text(dvec3(w.light))}},
          .row = row("sRGB", {red, green, blue}),
          .key = pixel_key(pixel_),
          .decides = yes_or_no(words_, "question.seen", {pixel_word()}, seen, "lit", "background")});
  }
  milestone(views_.output(true), "Output",
            {.text = "output",
             .facts = {{"pixels", std::ssize(run_.written)}, {"visible", std::ssize(run_.shaded)}},
             .words = {{"shown", run_.shaded.size()}}});
}

}  // namespace gradus::textbook_chain
