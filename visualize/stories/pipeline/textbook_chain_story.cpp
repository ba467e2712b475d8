// The story of the textbook chain: a small model's data before and after each stage, and one triangle and one
// pixel followed through all eight.

#include "stories/parameters.hpp"
#include "stories/pipeline/chain_coordinates.hpp"
#include "stories/pipeline/chain_run.hpp"
#include "stories/pipeline/chain_views.hpp"
#include "stories/telling.hpp"

namespace gradus::textbook_chain {
namespace {

using namespace pipeline;

/// The stages as the parameter `stage` calls them, the calls that the chain makes of them, and the functions
/// of their own that report steps.
struct Stage {
  std::string_view name, call, file, function, function_below{};
};
constexpr std::array<Stage, 8> stages{
    {{"input", "input(", "1_input", "bring_in"},
     {"world", "to_world(", "2_world", "to_world"},
     {"perspective", "to_clip(", "3_perspective", "to_clip"},
     {"back_faces", "remove_back_faces(", "4_back_faces", "remove_back_faces"},
     {"clipping", " clip(", "5_clipping", "clip"},
     {"rasterization", "rasterize(", "6_rasterization", "rasterize"},
     {"visibility", "shade(", "7_visibility_and_shading", "keep_nearest", "shade"},
     {"output", "return output(", "8_output", "output"}}};

/// The stages that exhibits exchange.
constexpr std::size_t facing_stage = 4, raster_stage = 6;

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

/// Lists a stage's own functions, or the chain's eight calls. What an exhibit exchanges it lists itself.
void list(Narrator& narrator, std::size_t number, const Exchanged& exchanged) {
  if (number != 0 && number == exchanged.stage) return;
  if (number == 0) {
    // Above the first stage stand the picture's size and its checks
    std::vector<SourceLine>& lines = narrator.trace().listing;
    const auto first_stage = [](const SourceLine& l) { return l.text.starts_with("// 1"); };
    lines.erase(lines.begin(), std::ranges::find_if(lines, first_stage));
    return;
  }
  const Stage& stage = stages[number - 1];
  narrator.list(stage.function, fmt::format("pipeline/stages/{}.hpp", stage.file));
  if (!stage.function_below.empty()) narrator.list_below(stage.function_below);
}

/// The line of the chain that makes this call.
int line_of(const std::vector<SourceLine>& listing, std::string_view call) {
  const auto found = std::ranges::find_if(listing, [&](const SourceLine& l) {
    return l.text.find(call) != std::string::npos && !l.text.starts_with("//");
  });
  return found == listing.end() ? 0 : found->number;
}

class Tour {
 public:
  /// listed: the stage whose own source is listed; 0: the chain is. last: the stage that ends the tour.
  /// exchanged: the one that lists an exhibit; 0: none.
  Tour(Narrator& narrator, const Run& run, const Followed& followed, std::size_t listed, std::size_t last,
       std::size_t exchanged)
      : narrator_(narrator),
        listed_(listed),
        last_(last),
        exchanged_(exchanged),
        words_(narrator.words()),
        run_(run),
        followed_(followed.piece),
        piece_(run.pieces[followed.piece]),
        faced_(run.faced[followed.piece]),
        pixel_(followed.pixel),
        seen_(followed.seen),
        views_(run, followed, words_) {}

  /// Tells the stages up to the last one.
  void tell() {
    constexpr std::array tellers{&Tour::input,    &Tour::world,         &Tour::perspective, &Tour::facing,
                                 &Tour::clipping, &Tour::rasterization, &Tour::visibility,  &Tour::output};
    goal();
    for (stage_ = 1; stage_ <= last_; ++stage_) (this->*tellers[stage_ - 1])();
  }

 private:
  // --- Telling an event

  const std::vector<SourceLine>& listing() const { return narrator_.trace().listing; }

  /// The line of the chain that calls the stage, or `call`.
  int chain_line(std::string_view call = {}) const {
    if (stage_ == 0) return 0;
    return line_of(listing(), call.empty() ? stages[stage_ - 1].call : call);
  }

  /// The listed stage's line that reported steps of this type: none of it did in the stages before.
  int own_line(std::string_view type) const {
    const auto reported = run_.lines.find(type);
    return stage_ == listed_ && reported != run_.lines.end() ? reported->second : 0;
  }

  /// The line with which the listed stage ends: its return, or what it reported last.
  int end_line() const {
    if (stage_ == listed_ && stage_ == exchanged_) return narrator_.line();
    const SourceLine& last = listing().back();
    return stage_ != listed_ ? 0 : last.text.starts_with("return ") ? last.number : narrator_.line();
  }

  void tell(View view, std::string_view type, int line, Event event) {
    if (stage_ > 0) event.phase = words_.say(fmt::format("stage.{}", stage_));
    narrator_.board().draw(std::move(view));
    narrator_.tell(type, line, [&] { return std::move(event); });
  }

  /// reported: the step type of the pipeline that tells of it, where that is not the event's own.
  void fine(View view, std::string_view type, Event event, std::string_view reported = {},
            std::string_view call = {}) {
    narrator_.board().detail(pixel_);
    tell(std::move(view), type,
         listed_ == 0 ? chain_line(call) : own_line(reported.empty() ? type : reported), std::move(event));
  }

  void milestone(View view, std::string_view type, Event event) {
    event.level = Level::idea;
    narrator_.board().milestone(pixel_);
    tell(std::move(view), type, listed_ == 0 ? chain_line() : end_line(), std::move(event));
  }

  std::vector<Said> row(Said point, std::initializer_list<Said> numbers) const {
    std::vector<Said> cells{stage_, std::move(point)};
    cells.insert(cells.end(), numbers);
    return cells;
  }
  template <int N>
  std::vector<Said> row(Said point, const glm::vec<N, double>& p, double noise = small) const {
    std::vector<Said> cells{stage_, std::move(point)};
    for (int i = 0; i < N; ++i) cells.push_back(real_text(p[i], noise));
    return cells;
  }
  /// Lengths, as long as the model or a part of it.
  std::string length_text(double x) const { return real_text(x, run_.noise); }
  std::string at_text(dvec3 p) const { return place_text(p, run_.noise); }

  std::size_t vertex(std::size_t corner) const {
    return static_cast<std::size_t>(piece_.corners[corner].vertex);
  }
  std::string vertex_name(std::size_t corner) const { return fmt::format("v{}", vertex(corner)); }
  std::string corner_names() const {
    return fmt::format("{}, {}, {}", vertex_name(0), vertex_name(1), vertex_name(2));
  }
  int face() const { return piece_.id.face; }
  Word face_word() const { return {"face", face()}; }
  Word pixel_word() const { return {"pixel", pixel_}; }

  // --- The stages

  void goal() {
    stage_ = 0;
    milestone(views_.object(), "Started",
              {.text = seen_ ? "started" : "started.bare",
               .facts = {{"face", face()}, {"piece", piece_.id.piece}, {"pixel", pixel_}},
               .words = {{"width", run_.size.width}, {"height", run_.size.height}}});
  }

  void input() {
    for (std::size_t i = 0; i < 3; ++i) {
      const dvec3 p = run_.read[vertex(i)].point.at;
      const std::string name = vertex_name(i);
      fine(views_.object({i, at_text(p)}), "VertexRead",
           {.text = "vertex_read",
            .facts = fields_of(p),
            .words = {{"name", name}, {"place", at_text(p)}},
            .row = row(name, p, run_.noise),
            .key = name});
    }
    const FaceRead& read = run_.faces[static_cast<std::size_t>(face())];
    const bool whole = read.pieces.size() == 1;
    fine(views_.object(), "FaceRead",
         {.text = whole ? "face_read.whole" : "face_read.cut",
          .facts = {{"face", read.face}, {"line", read.line}, {"pieces", std::ssize(read.pieces)}},
          .words = {{"corners", read.vertices.size()}, {"names", corner_names()}},
          .key = figure_number(face()),
          .decides = yes_or_no(words_, "question.face", {face_word()}, !whole, "cut", "whole")});
    milestone(views_.object(), "InputModel",
              {.text = "input",
               .facts = {{"vertices", std::ssize(run_.read)},
                         {"faces", std::ssize(run_.faces)},
                         {"pieces", std::ssize(run_.pieces)}}});
  }

  void world() {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& [from, to] = std::pair{run_.placed[vertex(i)].from.at, run_.placed[vertex(i)].to.at};
      const std::string name = vertex_name(i);
      fine(views_.world({i, at_text(to)}), "Placed",
           {.text = from != to ? "placed.moved" : "placed.same",
            .facts = fields_of(to),
            .words = {{"name", name}, {"from", at_text(from)}, {"to", at_text(to)}},
            .row = row(name, to, run_.noise),
            .key = name});
    }
    const dvec3 eye = run_.scene.camera.frame.eye;
    milestone(views_.world(), "WorldTransformation",
              {.text = "world",
               .facts = fields_of(eye),
               .words = {{"vertices", run_.placed.size()}, {"eye", at_text(eye)}}});
  }

  void perspective() {
    for (std::size_t i = 0; i < 3; ++i) {
      const Projected& p = run_.clip[vertex(i)];
      const glm::dvec4 at = p.clip.at, shown = shown_clip(words_, at);
      const std::string name = vertex_name(i);
      fine(views_.clip_space({i, ""}), "Projected",
           {.text = "projected",
            .facts = fields_of(at),
            .words = {{"name", name},
                      {"depth", length_text(p.view.z)},
                      {"view", at_text(shown_view(words_, p.view))},
                      {"x", length_text(at.x)},
                      {"y", length_text(at.y)},
                      {"z", length_text(shown.z)}},
            .row = row(name, shown, run_.noise),
            .key = name});
    }
    const auto behind = std::ranges::count_if(run_.clip, [](const Projected& p) { return p.clip.at.z < 0; });
    milestone(views_.clip_space(), "PerspectiveTransformation",
              {.text = "perspective",
               .facts = {{"before_near", behind}},
               .words = {{"vertices", run_.clip.size()}, {"test", before_near(words_)}},
               .count = behind});
  }

  std::array<glm::dvec4, 3> corners() const {
    return {run_.clip[vertex(0)].clip.at, run_.clip[vertex(1)].clip.at, run_.clip[vertex(2)].clip.at};
  }

  /// What is found of the followed piece's side: its text and its branch.
  std::pair<std::string_view, std::string_view> verdict() const {
    using back_face_culling::Facing;
    if (faced_.facing == Facing::front) return {"faced.front", "front"};
    if (faced_.facing != Facing::back) return {"faced.edge_on", "edge on"};
    return faced_.removed ? std::pair{"faced.back", "back"} : std::pair{"faced.two_sided", "two sided"};
  }

  std::string_view faulty_verdict() const {
    using back_face_culling::Facing;
    const bool wrong = run_.wrongly_faced(followed_);
    if (faced_.facing == Facing::front) return wrong ? "divided.front.wrong" : "divided.front";
    if (faced_.facing == Facing::back) return wrong ? "divided.back.wrong" : "divided.back";
    return "divided.edge_on";
  }

  /// Stage 4 after the division, which mirrors the corners behind the eye.
  void facing_after_division() {
    const auto c = corners();
    const double area = back_face_culling::area_after_division(c[0], c[1], c[2]);
    const auto behind = std::ranges::count_if(c, [](const glm::dvec4& at) { return at.w < 0; });
    const bool front = faced_.facing == back_face_culling::Facing::front;
    fine(views_.facing(), "Faced",
         {.text = faulty_verdict(),
          .facts = {{"area", area},
                    {"determinant", exact_determinant(corners())},
                    {"removed", faced_.removed}},
          .words = {face_word(), {"names", corner_names()}, {"behind", behind}},
          .row = row("area", {area}),
          .key = figure_number(face()),
          .decides = yes_or_no(words_, "question.front", {face_word()}, front, "front", "back")});
    const auto removed = std::ranges::count_if(run_.faced, &Faced::removed);
    std::int64_t wrong = 0;
    for (std::size_t i = 0; i < run_.faced.size(); ++i) wrong += run_.wrongly_faced(i);
    milestone(
        views_.facing(), "BackFaceRemoval",
        {.text = wrong > 0 ? "facing_divided" : "facing_divided.right",
         .facts = {{"removed", removed}, {"kept", std::ssize(run_.faced) - removed}, {"wrong", wrong}}});
  }

  void facing() {
    if (run_.fault == Fault::cull_after_division) return facing_after_division();
    const double determinant = exact_determinant(corners());
    const auto [text, branch] = verdict();
    fine(views_.facing(), "Faced",
         {.text = text,
          .facts = {{"determinant", determinant}, {"removed", faced_.removed}},
          .words = {face_word(), {"names", corner_names()}},
          .row = row("det", {determinant}),
          .key = figure_number(face()),
          .decides = yes_or_no(words_, "question.front", {face_word()}, branch == "front", branch, branch)});
    const auto removed = std::ranges::count_if(run_.faced, &Faced::removed);
    milestone(views_.facing(), "BackFaceRemoval",
              {.text = "facing",
               .facts = {{"removed", removed}, {"kept", std::ssize(run_.faced) - removed}},
               .count = removed});
  }

  void clipping() {
    if (const Clipped* own = run_.clipped_of(piece_.id)) {
      for (std::size_t k = 0; k < own->after.size(); ++k) clipped_corner(*own, k);
      if (own->after.empty()) {
        fine(views_.clipping(), "Clipped",
             {.text = "clipped.gone",
              .words = {face_word()},
              .key = figure_number(face()),
              .decides = yes_or_no(words_, "question.left", {face_word()}, false, "", "outside")});
      }
    }
    const auto changed = std::ranges::count_if(run_.clipped, &Clipped::changed);
    const auto gone = std::ranges::count_if(run_.clipped, [](const Clipped& c) { return c.after.empty(); });
    milestone(views_.clipping(), "Clipping",
              {.text = "clipping",
               .facts = {{"clipped", changed}, {"gone", gone}, {"triangles", std::ssize(run_.snapped)}},
               .count = changed});
  }

  void clipped_corner(const Clipped& own, std::size_t k) {
    const glm::dvec4 at = own.after[k].at, shown = shown_clip(words_, at);
    const dvec3 divided = own.divided[k].at, ndc = shown_divided(words_, divided);
    const auto [low, high] = bounds_of_depth(words_, at.w, length_text(at.w));
    const std::string name = fmt::format("c{}", k);
    const auto old = std::ranges::find(own.before, at, &ClipPoint::at);
    const bool kept = old != own.before.end();
    const std::string from = kept ? vertex_name(static_cast<std::size_t>(old - own.before.begin())) : "";
    fine(views_.clipping({k, ""}), "Clipped",
         {.text = kept ? "clipped.kept" : "clipped.new",
          .facts = fields_of(at),
          .words = {{"name", name},
                    {"vertex", from},
                    {"z", length_text(shown.z)},
                    {"w", length_text(at.w)},
                    {"low", low},
                    {"high", high}},
          .row = row(name, shown, run_.noise),
          .key = name,
          .decides = kept ? yes_or_no(words_, "question.within", {{"vertex", from}}, true, "inside")
                          : yes_or_no(words_, "question.edge", {{"name", name}}, true, "cut")});
    fine(views_.clipping({k, place_text(ndc)}), "Divided",
         {.text = "divided",
          .facts = fields_of(divided),
          .words = {{"name", name}, {"w", at.w}, {"place", place_text(ndc)}},
          .row = row(fmt::format("{} / {}", name, words_.symbol("w")), ndc),
          .key = name},
         "Clipped");
  }

  void rasterization() {
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
      fine(views_.raster(run_.size.height), "Uncovered",
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
    milestone(views_.raster(run_.size.height), "Rasterization", std::move(event));
  }

  void snapped_corner(const Snapped& triangle, std::size_t k, std::size_t corner) {
    const dvec2 exact = triangle.exact[k].at;
    const ivec2 at = triangle.corners[k].at;
    const std::string name = fmt::format("p{}", corner), x = real_text(at.x / 256.0),
                      y = real_text(at.y / 256.0), place = fmt::format("({},\u00a0{})", x, y);
    fine(views_.raster(-1, {corner, name + " " + place}), "Snapped",
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

  /// What the followed piece covers of a row of pixels.
  struct CoveredRow {
    int count = 0, first = INT32_MAX, last = 0;
    double depth = 0;  ///< of the first fragment

    void add(const Fragment& f) {
      if (count++ == 0) depth = f.depth;
      first = std::min(first, f.pixel.x);
      last = std::max(last, f.pixel.x);
    }
  };

  /// How many pixels of a row the followed piece should cover.
  std::int64_t right_count(int y, std::int64_t covered) const {
    for (const Misjudged& wrong : run_.misjudged) {
      if (wrong.id == piece_.id && wrong.pixel.y == y) covered += wrong.covered ? -1 : 1;
    }
    return covered;
  }

  void covered_row(int y, const CoveredRow& covered) {
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

  /// The followed pixel, where the followed piece covers it.
  void edge_functions() {
    const auto found = std::ranges::find_if(
        run_.covered, [&](const Fragment& f) { return f.id == piece_.id && f.pixel == pixel_; });
    if (found == run_.covered.end()) return;
    const Snapped& triangle = run_.snapped[static_cast<std::size_t>(found->triangle)];
    const auto edges = triangle_coverage::edges_of(on_grid(triangle.corners));
    dvec3 e{0};
    for (int i = 0; i < 3; ++i) {
      const auto at = edges[static_cast<std::size_t>(i)].at(triangle_coverage::centre_of(pixel_));
      e[i] = static_cast<double>(at) / 65536;
    }
    fine(views_.edge_functions(triangle), "EdgesTested",
         {.text = "covered.edges",
          .facts = {{"e0", e[0]}, {"e1", e[1]}, {"e2", e[2]}, {"depth", found->depth}},
          .words = {pixel_word(),
                    {"a", real_text(e[0])},
                    {"b", real_text(e[1])},
                    {"c", real_text(e[2])},
                    {"depth", real_text(found->depth)}},
          .row = row(words_.say("edges"), e),
          .key = pixel_key(pixel_),
          .decides = yes_or_no(words_, "question.inside", {pixel_word()}, true, "inside")},
         "Covered");
  }

  /// The multiplied-out edge functions at the followed pixel, where they are wrong about it.
  void expanded_edge_functions() {
    const auto wrong = std::ranges::find_if(
        run_.misjudged, [&](const Misjudged& m) { return m.id == piece_.id && m.pixel == pixel_; });
    if (wrong == run_.misjudged.end()) return;
    const Snapped& triangle = run_.snapped[static_cast<std::size_t>(wrong->triangle)];
    const auto edges = triangle_coverage::edges_of(on_grid(triangle.corners));
    const ivec2 centre = triangle_coverage::centre_of(pixel_);
    const dvec3 found = triangle_coverage::FarEdges(edges, dvec2(far_origin)).areas_at(pixel_);
    dvec3 exact{0};
    for (int i = 0; i < 3; ++i) {
      exact[i] = static_cast<double>(edges[static_cast<std::size_t>(i)].at(centre)) / 65536;
    }
    fine(views_.edge_functions(triangle), "EdgesTested",
         {.text = "expanded.edges",
          .facts = {{"e0", found[0]}, {"e1", found[1]}, {"e2", found[2]}},
          .words = {pixel_word(), {"found", place_text(found)}, {"exact", place_text(exact)}},
          .row = row(words_.say("edges"), found),
          .key = pixel_key(pixel_),
          .decides =
              yes_or_no(words_, "question.inside", {pixel_word()}, wrong->covered, "inside", "outside")},
         "Covered");
  }

  void visibility() {
    for (const DepthTested& test : run_.tests) {
      if (test.fragment.pixel == pixel_) depth_test(test);
    }
    if (const Shaded* shaded = run_.shaded_at(pixel_)) {
      const dvec3 sum(shaded->colour);
      fine(views_.lit(), "Shaded",
           {.text = "shaded",
            .facts = {{"red", sum.x}, {"green", sum.y}, {"blue", sum.z}},
            .words = {pixel_word(),
                      {"ambient", place_text(shaded->ambient)},
                      {"diffuse", place_text(shaded->diffuse)},
                      {"specular", place_text(shaded->specular)},
                      {"sum", place_text(sum)}},
            .row = row(words_.say("light"), sum),
            .key = pixel_key(pixel_)});
    }
    const auto covered = std::ranges::count(run_.covered, piece_.id, &Fragment::id);
    const auto won =
        std::ranges::count_if(run_.shaded, [&](const Shaded& s) { return s.fragment.id == piece_.id; });
    milestone(views_.depths(), "HiddenSurfaceRemovalAndShading",
              {.text = "visibility",
               .facts = {{"nearest", won}, {"covered", covered}, {"visible", std::ssize(run_.shaded)}},
               .words = {face_word(), {"shown", run_.shaded.size()}, {"fragments", run_.tests.size()}},
               .count = won});
  }

  void depth_test(const DepthTested& test) {
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
    const std::string depth = fmt::format("{} = {}", words_.symbol("z"), real_text(f.depth));
    const std::string against =
        test.before ? fmt::format(" {} {}", test.nearer ? "<" : "≥", real_text(test.before->depth)) : "";
    fine(views_.depths(depth + against), "DepthTested", std::move(event), {}, "keep_nearest(");
  }

  void output() {
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

  Narrator& narrator_;
  const std::size_t listed_, last_, exchanged_;
  const Words& words_;
  const Run& run_;
  const std::size_t followed_;
  const Piece& piece_;
  const Faced& faced_;
  const ivec2 pixel_;
  const std::optional<int> seen_;  ///< the face that is seen at the pixel
  const Views views_;
  std::size_t stage_ = 0;
};

void tell_tour(Narrator& narrator, const Exchanged& exchanged) {
  const Arguments& arguments = narrator.arguments();
  const Size size{static_cast<int>(arguments.integer("columns")),
                  static_cast<int>(arguments.integer("rows"))};
  const Run run = run_of(scene_of(arguments, exchanged.fault), size, exchanged.fault);
  const Followed followed = followed_in(run, arguments);
  const std::size_t asked = number_of(arguments.text("stage"));
  const std::size_t listed = asked == 0 ? exchanged.stage : asked;
  const std::size_t last = asked == 0 ? exchanged.end : asked;
  const std::string model = arguments.has("model") ? arguments.text("model") : "";
  list(narrator, listed, exchanged);
  narrator.subtitle(
      "subtitle",
      {{"model", model.empty() ? "letter_f.obj" : model}, {"width", size.width}, {"height", size.height}});
  Grid& grid = narrator.trace().grid;
  grid.cells = run.image.window();
  grid.y_up = false;
  grid.whole = true;
  grid.x_name = narrator.words().say("column_name");
  grid.y_name = narrator.words().say("row_name");
  narrator.shows_depths(true);
  narrator.legend({Role::current, Role::accepted, Role::rejected, Role::past, Role::boundary, Role::candidate,
                   Role::input});
  if (exchanged.stage == raster_stage) {
    narrator.legend({Role::current,
                     Role::accepted,
                     {Role::rejected, "misjudged"},
                     Role::past,
                     Role::boundary,
                     Role::candidate,
                     Role::input});
  }
  Tour(narrator, run, followed, listed, last, exchanged.stage).tell();
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
       .columns = {{"stage"}, {"point", false}, {"x"}, {"y"}, {"z"}, {"w"}},
       .parameters =
           {{"model", ParameterType::model, "", "MODEL.obj", "a small model; the letter F if not given"},
            choice("stage", stage_names(), std::string(whole_chain), "clipping",
                   "the tour ends with this stage and lists its source; all lists the chain"),
            {"columns", ParameterType::integer, "40", "32", "the picture's width in pixels", 8, 64},
            {"rows", ParameterType::integer, "28", "20", "the picture's height in pixels", 8, 64},
            {"face", ParameterType::integer, "", "3",
             "the face that is followed, counted from 0; a telling one if not given", 0, INT32_MAX},
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
            {"turn", ParameterType::integer, "0", "30",
             "degrees by which the model is turned round the y axis, stage 2", -360, 360}},
       .examples = {"--stage clipping", "--model letter_f.obj --eye 1,1,3",
                    "--turn 30 --face 0 --pixel 12,7"}});
  return topic;
}

}  // namespace gradus::textbook_chain
