// The story of the textbook chain: a small model's data before and after each stage, and one triangle and one
// pixel followed through all eight.

#include <algorithm>
#include <array>
#include <cmath>

#include "core/exact_scalar.hpp"
#include "pipeline.hpp"
#include "stories/pipeline/chain_run.hpp"
#include "stories/pipeline/chain_views.hpp"
#include "stories/topic.hpp"
#include "stories/words.hpp"

namespace gradus::textbook_chain {
namespace {

using fmt::arg;
using namespace pipeline;

constexpr std::string_view chain_source = "pipeline/pipeline.hpp";

/// The stages as the parameter `stage` calls them, the calls that the chain makes of them, and the functions
/// of their own that report steps.
struct Stage {
  std::string_view name, call, file;
  std::vector<std::string_view> functions;
};
const std::vector<Stage>& stages() {
  static const std::vector<Stage> all{
      {"input", "input(", "1_input", {"bring_in"}},
      {"world", "to_world(", "2_world", {"to_world"}},
      {"perspective", "to_clip(", "3_perspective", {"to_clip"}},
      {"back_faces", "remove_back_faces(", "4_back_faces", {"remove_back_faces"}},
      {"clipping", "clip_and_divide(", "5_clipping", {"clip_and_divide"}},
      {"rasterization", "rasterize(", "6_rasterization", {"rasterize"}},
      {"visibility", "shade(", "7_visibility_and_shading", {"keep_nearest", "shade"}},
      {"output", "return output(", "8_output", {"output"}}};
  return all;
}

/// The choice of `stage` that stands for the whole chain.
constexpr std::string_view whole_chain = "all";

/// The stage's number from 1; 0 for the whole chain.
int number_of(std::string_view stage) {
  const auto found = std::ranges::find(stages(), stage, &Stage::name);
  return found == stages().end() ? 0 : static_cast<int>(found - stages().begin()) + 1;
}

std::string file_of(int stage) {
  return stage == 0
             ? std::string(chain_source)
             : fmt::format("pipeline/stages/{}.hpp", stages()[static_cast<std::size_t>(stage) - 1].file);
}

/// What is listed: a stage's own functions, or the chain's eight calls.
std::vector<SourceLine> listing_for(int stage) {
  const std::string_view text = source_text(file_of(stage));
  std::vector<SourceLine> listing;
  if (stage == 0) {
    listing = listing_of(text, "render");
    // Above the first stage stand the picture's size and its checks
    const auto first =
        std::ranges::find_if(listing, [](const SourceLine& l) { return l.text.starts_with("// 1"); });
    listing.erase(listing.begin(), first);
    return listing;
  }
  for (const std::string_view function : stages()[static_cast<std::size_t>(stage) - 1].functions) {
    const std::vector<SourceLine> lines = listing_of(text, function);
    listing.insert(listing.end(), lines.begin(), lines.end());
  }
  return listing;
}

/// The line of the chain that makes this call.
int line_of(const std::vector<SourceLine>& listing, std::string_view call) {
  const auto found = std::ranges::find_if(listing, [&](const SourceLine& l) {
    return l.text.find(call) != std::string::npos && !l.text.starts_with("//");
  });
  return found == listing.end() ? 0 : found->number;
}

std::vector<std::string> stage_names() {
  std::vector<std::string> names;
  for (const Stage& stage : stages()) names.emplace_back(stage.name);
  names.emplace_back(whole_chain);
  return names;
}

/// An event in the making.
struct Event {
  std::string type, key, sentence;
  Row row{};
  std::vector<Field> fields{};
};

std::vector<Field> fields_of(dvec3 p) { return {{"x", p.x}, {"y", p.y}, {"z", p.z}}; }
std::vector<Field> fields_of(glm::dvec4 p) { return {{"x", p.x}, {"y", p.y}, {"z", p.z}, {"w", p.w}}; }

class Tour {
 public:
  /// listed: the stage whose own source is listed; 0: the chain is.
  Tour(TraceWriter& writer, const Run& run, const Followed& followed, int listed)
      : writer_(writer),
        listed_(listed),
        words_(writer.wording()),
        run_(run),
        piece_(run.pieces[followed.piece]),
        number_(followed.piece),
        pixel_(followed.pixel),
        views_(run, followed, words_) {}

  /// Tells the stages up to the one that is listed, or all.
  void tell() {
    const int last = listed_ == 0 ? static_cast<int>(stages().size()) : listed_;
    constexpr std::array<void (Tour::*)(), 8> tellers{
        &Tour::input,    &Tour::world,         &Tour::perspective, &Tour::facing,
        &Tour::clipping, &Tour::rasterization, &Tour::visibility,  &Tour::output};
    goal();
    for (stage_ = 1; stage_ <= last; ++stage_) (this->*tellers[static_cast<std::size_t>(stage_ - 1)])();
  }

 private:
  // --- Telling an event
  // --------------------------------------------------------------------------------------

  void describe(TraceStep& step, Event&& event) const {
    step.type = std::move(event.type);
    step.key = std::move(event.key);
    step.phase =
        stage_ == 0 ? words_.say("words.set_up") : words_.say("pipeline.stage." + std::to_string(stage_));
    step.sentence = std::move(event.sentence);
    step.row = std::move(event.row);
    step.fields = std::move(event.fields);
  }

  /// The line of the chain that calls the stage, or `call`.
  int chain_line(std::string_view call = {}) const {
    if (stage_ == 0) return 0;
    const Stage& stage = stages()[static_cast<std::size_t>(stage_) - 1];
    return line_of(writer_.trace().listing, call.empty() ? stage.call : call);
  }

  /// The listed stage's line that reported steps of this type: none of it did in the stages before.
  int own_line(std::string_view type) const {
    const auto reported = run_.lines.find(type);
    return stage_ == listed_ && reported != run_.lines.end() ? reported->second : 0;
  }

  /// reported: the step type of the pipeline that tells of it, where that is not the event's own.
  void fine(View view, Event event, std::string_view reported = {}, std::string_view call = {}) {
    const int line = listed_ == 0 ? chain_line(call)
                                  : own_line(reported.empty() ? std::string_view(event.type) : reported);
    reported_ = line;
    writer_.fine(shown_.change_to(std::move(view)), pixel_, line,
                 [&](TraceStep& step) { describe(step, std::move(event)); });
  }

  /// The line with which the listed stage ends: its return, or what it reported last.
  int end_line() const {
    const SourceLine& last = writer_.trace().listing.back();
    return stage_ != listed_ ? 0 : last.text.starts_with("return ") ? last.number : reported_;
  }

  void milestone(View view, Event event) {
    const int line = listed_ == 0 ? chain_line() : end_line();
    writer_.step(shown_.change_to(std::move(view)), pixel_, line, [&](TraceStep& step) {
      describe(step, std::move(event));
      step.level = Level::idea;
    });
  }

  Row row(std::string point, std::string x = {}, std::string y = {}, std::string z = {},
          std::string w = {}) const {
    return {figure_number(stage_), std::move(point), std::move(x), std::move(y), std::move(z), std::move(w)};
  }
  Row row(std::string point, dvec3 p) const {
    return row(std::move(point), real_text(p.x), real_text(p.y), real_text(p.z));
  }
  /// Lengths, as long as the model or a part of it.
  std::string length_text(double x) const { return real_text(x, run_.noise); }
  std::string at_text(dvec3 p) const { return place_text(p, run_.noise); }
  Row row_at(std::string point, dvec3 p) const {
    return row(std::move(point), length_text(p.x), length_text(p.y), length_text(p.z));
  }
  Row row_at(std::string point, glm::dvec4 p) const {
    return row(std::move(point), length_text(p.x), length_text(p.y), length_text(p.z), length_text(p.w));
  }

  std::size_t vertex(int corner) const {
    return static_cast<std::size_t>(piece_.corners[static_cast<std::size_t>(corner)].vertex);
  }
  static std::string name_of_vertex(std::size_t v) { return fmt::format("v{}", v); }
  std::string face_name() const { return figure_number(piece_.id.face); }
  template <class... Values>
  std::string say(std::string_view key, const Values&... values) const {
    return words_.say(key, values...);
  }
  std::string pixel_text() const { return figure_point(pixel_); }

  // --- The stages
  // ----------------------------------------------------------------------------------------------

  void goal() {
    stage_ = 0;
    milestone(views_.object(), {"Started",
                                "",
                                say("pipeline.started", arg("face", face_name()), arg("pixel", pixel_text()),
                                    arg("width", run_.size.width), arg("height", run_.size.height)),
                                {},
                                {{"face", std::int64_t{piece_.id.face}},
                                 {"piece", std::int64_t{piece_.id.piece}},
                                 {"pixel", pixel_}}});
  }

  void input() {
    for (int i = 0; i < 3; ++i) {
      const dvec3 p = run_.read[vertex(i)].point.at;
      const std::string name = name_of_vertex(vertex(i));
      fine(views_.object({i, at_text(p)}),
           {"VertexRead", name, say("pipeline.vertex_read", arg("name", name), arg("place", at_text(p))),
            row_at(name, p), fields_of(p)});
    }
    const FaceRead& face = run_.faces[static_cast<std::size_t>(piece_.id.face)];
    const std::string key = face.pieces.size() == 1 ? "pipeline.face_read.whole" : "pipeline.face_read.cut";
    fine(views_.object(), {"FaceRead",
                           face_name(),
                           say(key, arg("face", face_name()), arg("line", figure_number(face.line)),
                               arg("corners", face.vertices.size()), arg("pieces", face.pieces.size()),
                               arg("names", corner_names())),
                           {},
                           {{"face", std::int64_t{face.face}},
                            {"line", std::int64_t{face.line}},
                            {"pieces", static_cast<std::int64_t>(face.pieces.size())}}});
    milestone(views_.object(), {"InputModel",
                                "",
                                say("pipeline.input", arg("vertices", run_.read.size()),
                                    arg("faces", run_.faces.size()), arg("pieces", run_.pieces.size())),
                                {},
                                {{"vertices", static_cast<std::int64_t>(run_.read.size())},
                                 {"faces", static_cast<std::int64_t>(run_.faces.size())},
                                 {"pieces", static_cast<std::int64_t>(run_.pieces.size())}}});
  }

  std::string corner_names() const { return fmt::format("v{}, v{}, v{}", vertex(0), vertex(1), vertex(2)); }

  void world() {
    for (int i = 0; i < 3; ++i) {
      const Placed& placed = run_.placed[vertex(i)];
      const std::string name = name_of_vertex(vertex(i));
      const bool moved = placed.from.at != placed.to.at;
      fine(views_.world({i, at_text(placed.to.at)}),
           {"Placed", name,
            say(moved ? "pipeline.placed.moved" : "pipeline.placed.same", arg("name", name),
                arg("from", at_text(placed.from.at)), arg("to", at_text(placed.to.at))),
            row_at(name, placed.to.at), fields_of(placed.to.at)});
    }
    const Camera& camera = run_.scene.camera;
    milestone(views_.world(), {"WorldTransformation",
                               "",
                               say("pipeline.world", arg("vertices", run_.placed.size()),
                                   arg("eye", at_text(camera.frame.eye))),
                               {},
                               fields_of(camera.frame.eye)});
  }

  void perspective() {
    for (int i = 0; i < 3; ++i) {
      const Projected& p = run_.clip[vertex(i)];
      const std::string name = name_of_vertex(vertex(i));
      fine(views_.clip_space({i, ""}),
           {"Projected", name,
            say("pipeline.projected", arg("name", name), arg("depth", length_text(p.view.z)),
                arg("view", at_text(p.view)), arg("x", length_text(p.clip.at.x)),
                arg("y", length_text(p.clip.at.y)), arg("z", length_text(p.clip.at.z))),
            row_at(name, p.clip.at), fields_of(p.clip.at)});
    }
    const auto behind = std::ranges::count_if(run_.clip, [](const Projected& p) { return p.clip.at.z < 0; });
    milestone(views_.clip_space(),
              {"PerspectiveTransformation",
               "",
               words_.count("pipeline.perspective", behind, arg("vertices", run_.clip.size())),
               {},
               {{"before_near", static_cast<std::int64_t>(behind)}}});
  }

  /// Of the corners' x, y and w, with the sign that the stage finds, which decides exactly.
  double exact_determinant() const {
    const ExactScope scope;
    std::array<glm::vec<3, Exact>, 3> c;
    for (int i = 0; i < 3; ++i) {
      const glm::dvec4 at = run_.clip[vertex(i)].clip.at;
      c[static_cast<std::size_t>(i)] = {Exact(at.x), Exact(at.y), Exact(at.w)};
    }
    return to_double(glm::dot(c[0], glm::cross(c[1], c[2])));
  }

  void facing() {
    const Faced& faced = run_.faced[number_];
    const double determinant = exact_determinant();
    const char* verdict = faced.facing == back_face_culling::Facing::front ? "pipeline.faced.front"
                          : faced.facing == back_face_culling::Facing::back
                              ? (faced.removed ? "pipeline.faced.back" : "pipeline.faced.two_sided")
                              : "pipeline.faced.edge_on";
    fine(views_.facing(), {"Faced",
                           face_name(),
                           say(verdict, arg("determinant", figure_real(determinant)),
                               arg("face", face_name()), arg("names", corner_names())),
                           row("det", figure_real(determinant)),
                           {{"determinant", determinant}, {"removed", faced.removed}}});
    const auto removed = std::ranges::count_if(run_.faced, &Faced::removed);
    milestone(views_.facing(),
              {"BackFaceRemoval",
               "",
               words_.count("pipeline.facing", removed,
                            arg("kept", static_cast<std::int64_t>(run_.faced.size()) - removed)),
               {},
               {{"removed", static_cast<std::int64_t>(removed)},
                {"kept", static_cast<std::int64_t>(run_.faced.size()) - removed}}});
  }

  void clipping() {
    if (const Clipped* own = run_.clipped_of(piece_.id)) {
      for (std::size_t k = 0; k < own->after.size(); ++k) clipped_corner(*own, k);
      if (own->after.empty()) {
        fine(views_.clipping(),
             {"Clipped", face_name(), say("pipeline.clipped.gone", arg("face", face_name()))});
      }
    }
    const auto changed = std::ranges::count_if(run_.clipped, &Clipped::changed);
    const auto gone = std::ranges::count_if(run_.clipped, [](const Clipped& c) { return c.after.empty(); });
    milestone(views_.clipping(), {"Clipping",
                                  "",
                                  words_.count("pipeline.clipping", changed, arg("gone", gone),
                                               arg("triangles", run_.snapped.size())),
                                  {},
                                  {{"clipped", static_cast<std::int64_t>(changed)},
                                   {"gone", static_cast<std::int64_t>(gone)},
                                   {"triangles", static_cast<std::int64_t>(run_.snapped.size())}}});
  }

  void clipped_corner(const Clipped& own, std::size_t k) {
    const glm::dvec4 at = own.after[k].at;
    const dvec3 ndc = own.divided[k].at;
    const std::string name = fmt::format("c{}", k);
    const auto old = std::ranges::find_if(own.before, [&](const ClipPoint& p) { return p.at == at; });
    const std::string from = old == own.before.end()
                                 ? std::string()
                                 : name_of_vertex(vertex(static_cast<int>(old - own.before.begin())));
    const std::string key = old == own.before.end() ? "pipeline.clipped.new" : "pipeline.clipped.kept";
    fine(views_.clipping({static_cast<int>(k), ""}),
         {"Clipped", name,
          say(key, arg("name", name), arg("vertex", from), arg("z", length_text(at.z)),
              arg("w", length_text(at.w))),
          row_at(name, at), fields_of(at)});
    fine(views_.clipping({static_cast<int>(k), place_text(ndc)}),
         {"Divided", name,
          say("pipeline.divided", arg("name", name), arg("w", figure_real(at.w)),
              arg("place", place_text(ndc))),
          row(fmt::format("{} / {}", name, words_.symbol("w")), ndc), fields_of(ndc)},
         "Clipped");
  }

  void rasterization() {
    int corner = 0, low = run_.size.height, high = -1;
    std::int64_t covered = 0;
    for (const Snapped& triangle : run_.snapped) {
      if (triangle.id != piece_.id) continue;
      for (std::size_t k = 0; k < 3; ++k) snapped_corner(triangle, k, corner++);
    }
    for (const Fragment& f : run_.covered) {
      if (f.id != piece_.id) continue;
      low = std::min(low, f.pixel.y);
      high = std::max(high, f.pixel.y);
      ++covered;
    }
    for (int y = low; y <= high; ++y) covered_row(y);
    const auto all = static_cast<std::int64_t>(run_.covered.size());
    milestone(views_.raster(run_.size.height),
              {"Rasterization",
               "",
               words_.count("pipeline.rasterization", covered, arg("face", face_name()), arg("all", all),
                            arg("triangles", run_.snapped.size())),
               {},
               {{"covered", covered}, {"fragments", all}}});
  }

  void snapped_corner(const Snapped& triangle, std::size_t k, int corner) {
    const dvec2 exact = triangle.exact[k].at;
    const ivec2 at = triangle.corners[k].at;
    const std::string name = fmt::format("p{}", corner);
    const std::string place = fmt::format("({},\u00a0{})", real_text(at.x / 256.0), real_text(at.y / 256.0));
    fine(views_.raster(-1, {corner, name + " " + place}),
         {"Snapped",
          name,
          say("pipeline.snapped", arg("name", name), arg("x", real_text(exact.x)),
              arg("y", real_text(exact.y)), arg("column", figure_number(at.x)),
              arg("row", figure_number(at.y)), arg("place", place)),
          row(name, real_text(at.x / 256.0), real_text(at.y / 256.0)),
          {{"x", std::int64_t{at.x}}, {"y", std::int64_t{at.y}}}});
  }

  void covered_row(int y) {
    int count = 0, first = 0, last = 0;
    double depth = 0;
    for (const Fragment& f : run_.covered) {
      if (f.id != piece_.id || f.pixel.y != y) continue;
      if (count++ == 0) {
        first = last = f.pixel.x;
        depth = f.depth;
      }
      first = std::min(first, f.pixel.x);
      last = std::max(last, f.pixel.x);
    }
    if (count == 0) return;
    fine(views_.raster(y),
         {"Covered",
          fmt::format("{},{}", first, y),
          words_.count("pipeline.covered", count, arg("row", figure_number(y)),
                       arg("first", figure_number(first)), arg("last", figure_number(last))),
          row(figure_point({first, y}), real_text(first + 0.5), real_text(y + 0.5), real_text(depth)),
          {{"row", std::int64_t{y}}, {"first", std::int64_t{first}}, {"last", std::int64_t{last}}}});
  }

  void visibility() {
    for (const DepthTested& test : run_.tests) {
      if (test.fragment.pixel == pixel_) depth_test(test);
    }
    if (const Shaded* shaded = run_.shaded_at(pixel_)) {
      const auto grey = [](dvec3 light) { return place_text(light); };
      const glm::dvec3 sum(shaded->colour);
      fine(views_.visible(true),
           {"Shaded",
            pixel_key(pixel_),
            say("pipeline.shaded", arg("pixel", pixel_text()), arg("ambient", grey(shaded->ambient)),
                arg("diffuse", grey(shaded->diffuse)), arg("specular", grey(shaded->specular)),
                arg("sum", grey(sum))),
            row(words_.say("pipeline.light"), sum),
            {{"red", sum.x}, {"green", sum.y}, {"blue", sum.z}}});
    }
    std::int64_t won = 0, covered = 0;
    for (const Fragment& f : run_.covered) covered += f.id == piece_.id;
    for (const Shaded& s : run_.shaded) won += s.fragment.id == piece_.id;
    milestone(views_.visible(false),
              {"HiddenSurfaceRemovalAndShading",
               "",
               words_.count("pipeline.visibility", won, arg("covered", covered), arg("face", face_name()),
                            arg("shown", run_.shaded.size()), arg("fragments", run_.tests.size())),
               {},
               {{"nearest", won},
                {"covered", covered},
                {"visible", static_cast<std::int64_t>(run_.shaded.size())}}});
  }

  void depth_test(const DepthTested& test) {
    const Fragment& f = test.fragment;
    const std::string key = !test.before  ? "pipeline.tested.first"
                            : test.nearer ? "pipeline.tested.nearer"
                                          : "pipeline.tested.farther";
    const std::string name = say("pipeline.face", arg("face", figure_number(f.id.face)));
    fine(views_.visible(false),
         {"DepthTested",
          pixel_key(f.pixel),
          say(key, arg("pixel", pixel_text()), arg("face", figure_number(f.id.face)),
              arg("depth", real_text(f.depth)),
              arg("other", test.before ? figure_number(test.before->id.face) : ""),
              arg("kept", test.before ? real_text(test.before->depth) : "")),
          row(name, real_text(f.pixel.x + 0.5), real_text(f.pixel.y + 0.5), real_text(f.depth)),
          {{"face", std::int64_t{f.id.face}}, {"depth", f.depth}, {"nearer", test.nearer}}},
         "DepthTested", "keep_nearest(");
  }

  void output() {
    for (const Written& w : run_.written) {
      if (w.pixel != pixel_) continue;
      const dvec3 light(w.light);
      fine(views_.output(false),
           {"Written",
            pixel_key(pixel_),
            say(run_.shaded_at(pixel_) ? "pipeline.written.lit" : "pipeline.written.background",
                arg("pixel", pixel_text()), arg("light", place_text(light)), arg("red", w.colour.r),
                arg("green", w.colour.g), arg("blue", w.colour.b)),
            row("sRGB", figure_number(w.colour.r), figure_number(w.colour.g), figure_number(w.colour.b)),
            {{"red", std::int64_t{w.colour.r}},
             {"green", std::int64_t{w.colour.g}},
             {"blue", std::int64_t{w.colour.b}}}});
    }
    milestone(views_.output(true),
              {"Output",
               "",
               say("pipeline.output", arg("pixels", run_.written.size()), arg("shown", run_.shaded.size())),
               {},
               {{"pixels", static_cast<std::int64_t>(run_.written.size())},
                {"visible", static_cast<std::int64_t>(run_.shaded.size())}}});
  }

  TraceWriter& writer_;
  int listed_;
  const Wording& words_;
  const Run& run_;
  const Piece& piece_;
  std::size_t number_;
  ivec2 pixel_;
  Views views_;
  Shown shown_;
  int stage_ = 0;
  int reported_ = 0;  ///< the line of the last finer event
};

void describe(Trace& trace, const Arguments& arguments, const Run& run, int listed) {
  const Wording& words = trace.wording;
  introduce(trace, "pipeline", arguments, false);
  const bool given = arguments.has("model") && !arguments.text("model").empty();
  trace.subtitle =
      words.say("pipeline.subtitle", arg("model", given ? arguments.text("model") : "letter_f.obj"),
                arg("width", run.size.width), arg("height", run.size.height));
  trace.source_file = file_of(listed);
  trace.listing = listing_for(listed);
  trace.grid.cells = run.image.window();
  trace.grid.y_up = false;
  trace.grid.whole = true;
  trace.grid.x_name = words.say("pipeline.column_name");
  trace.grid.y_name = words.say("pipeline.row_name");
  trace.columns = {{"stage"}, {"point", false}, {"x"}, {"y"}, {"z"}, {"w"}};
  for (const Role role : {Role::current, Role::accepted, Role::rejected, Role::past, Role::boundary,
                          Role::candidate, Role::input}) {
    trace.legend.push_back({role, words.say("pipeline.legend." + std::string(name_of(role)))});
  }
}

Trace run_tour(const Arguments& arguments, Recording recording) {
  const Size size{static_cast<int>(arguments.integer("columns")),
                  static_cast<int>(arguments.integer("rows"))};
  const Run run = run_of(scene_of(arguments), size);
  const Followed followed = followed_in(run, arguments);
  TraceWriter writer(recording);
  const int listed = number_of(arguments.text("stage"));
  describe(writer.trace(), arguments, run, listed);
  Tour(writer, run, followed, listed).tell();
  Trace trace = std::move(writer).finish();
  const Rgba8 colour = run.image[followed.pixel];
  const std::string hex = fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b);
  trace.result = {
      {"face", std::int64_t{run.pieces[followed.piece].id.face}}, {"pixel", followed.pixel}, {"colour", hex}};
  trace.telling = {trace.last, 0};
  return trace;
}

Parameter whole(std::string name, std::string value, std::string example, std::string help, int least,
                int most) {
  return {std::move(name),
          ParameterType::integer,
          std::move(value),
          std::move(example),
          std::move(help),
          least,
          most};
}

/// Of lengths: what the chain can project, and what its determinants hold.
constexpr Sizes length_sizes{1e-30, 1e30};

Parameter place(std::string name, std::string example, std::string help) {
  return {.name = std::move(name),
          .type = ParameterType::numbers,
          .default_value = "",
          .example = std::move(example),
          .help = std::move(help),
          .parts = {"x", "y", "z"},
          .sizes = length_sizes};
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const TopicEntry topic{
      .name = "pipeline",
      .title = Wording().say("pipeline.title"),
      .chapter = "pipeline",
      .aliases = {"textbook chain", "rendering pipeline", "graphics pipeline", "tour"},
      .summary = "a small model through the eight stages of the textbook chain",
      .methods = {method_in_english("pipeline", "z_buffer", Standing::taught)},
      .default_method = "z_buffer",
      .parameters =
          {{"model", ParameterType::model, "", "MODEL.obj", "a small model; the letter F if not given"},
           {.name = "stage",
            .type = ParameterType::choice,
            .default_value = std::string(whole_chain),
            .example = "clipping",
            .help = "the tour ends with this stage and lists its source; all lists the chain",
            .choices = stage_names()},
           whole("columns", "20", "32", "the picture's width in pixels", 8, 64),
           whole("rows", "14", "20", "the picture's height in pixels", 8, 64),
           whole("face", "", "3", "the face that is followed, counted from 0; a telling one if not given", 0,
                 INT32_MAX),
           {.name = "pixel",
            .type = ParameterType::cell,
            .default_value = "",
            .example = "12,7",
            .help =
                "the pixel that is followed: column,row from the top left; one of the face's if not given",
            .least = 0,
            .most = 63},
           place("eye", "1,1,3", "where the viewer stands: x,y,z; placed for the model if not given"),
           place("target", "0,0.5,0", "what the viewer looks at: x,y,z; the model's middle if not given"),
           {"fov", ParameterType::number, "40", "60", "the vertical angle of view in degrees", 1, 170},
           {.name = "near",
            .type = ParameterType::number,
            .default_value = "",
            .example = "0.5",
            .help = "the depth of the near plane; before the model if not given",
            .least = 0,
            .sizes = length_sizes},
           whole("turn", "0", "30", "degrees by which the model is turned round the y axis, stage 2", -360,
                 360)},
      .examples = {"--stage clipping", "--model letter_f.obj --eye 1,1,3", "--turn 30 --face 0 --pixel 12,7"},
      .run = run_tour};
  return topic;
}

}  // namespace gradus::textbook_chain
