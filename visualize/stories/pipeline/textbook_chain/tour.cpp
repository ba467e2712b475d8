// How the tour tells an event, and its stages of vertices and pieces: from the model to clipping.

#include "stories/pipeline/textbook_chain/tour.hpp"

#include "stories/pipeline/textbook_chain/coordinates.hpp"

namespace gradus::textbook_chain {

using namespace pipeline;

namespace {

/// The line of the chain that makes this call.
int line_of(const std::vector<SourceLine>& listing, std::string_view call) {
  const auto found = std::ranges::find_if(listing, [&](const SourceLine& l) {
    return l.text.find(call) != std::string::npos && !l.text.starts_with("//");
  });
  return found == listing.end() ? 0 : found->number;
}

}  // namespace

void Tour::tell() {
  constexpr std::array tellers{&Tour::input,    &Tour::world,         &Tour::perspective, &Tour::facing,
                               &Tour::clipping, &Tour::rasterization, &Tour::visibility,  &Tour::output};
  goal();
  for (stage_ = 1; stage_ <= last_; ++stage_) (this->*tellers[stage_ - 1])();
}

int Tour::chain_line(std::string_view call) const {
  if (stage_ == 0) return 0;
  return line_of(listing(), call.empty() ? stages[stage_ - 1].call : call);
}

int Tour::own_line(std::string_view type) const {
  const auto reported = run_.lines.find(type);
  return stage_ == listed_ && reported != run_.lines.end() ? reported->second : 0;
}

int Tour::end_line() const {
  if (stage_ == listed_ && stage_ == exchanged_) return narrator_.line();
  const SourceLine& last = listing().back();
  return stage_ != listed_ ? 0 : last.text.starts_with("return ") ? last.number : narrator_.line();
}

void Tour::tell(View view, std::string_view type, int line, Event event) {
  if (stage_ > 0) event.phase = words_.say(fmt::format("stage.{}", stage_));
  narrator_.board().draw(std::move(view));
  narrator_.tell(type, line, [&] { return std::move(event); });
}

void Tour::fine(View view, std::string_view type, Event event, std::string_view reported,
                std::string_view call) {
  narrator_.board().detail(pixel_);
  tell(std::move(view), type, listed_ == 0 ? chain_line(call) : own_line(reported.empty() ? type : reported),
       std::move(event));
}

void Tour::milestone(View view, std::string_view type, Event event) {
  event.level = Level::idea;
  narrator_.board().milestone(pixel_);
  tell(std::move(view), type, listed_ == 0 ? chain_line() : end_line(), std::move(event));
}

std::vector<Said> Tour::row(Said point, std::initializer_list<Said> numbers) const {
  std::vector<Said> cells{std::move(point), stage_};
  cells.insert(cells.end(), numbers);
  return cells;
}

std::size_t Tour::vertex(std::size_t corner) const {
  return static_cast<std::size_t>(piece_.corners[corner].vertex);
}

std::string Tour::corner_names() const {
  return fmt::format("{}, {}, {}", vertex_name(0), vertex_name(1), vertex_name(2));
}

void Tour::goal() {
  stage_ = 0;
  milestone(views_.goal(), "Started",
            {.text = seen_ ? "started" : "started.bare",
             .facts = {{"face", face()}, {"piece", piece_.id.piece}, {"pixel", pixel_}},
             .words = {{"width", run_.size.width}, {"height", run_.size.height}}});
}

void Tour::input() {
  for (std::size_t i = 0; i < 3; ++i) {
    const dvec3 p = run_.read[vertex(i)].point.at;
    const std::string name = vertex_name(i);
    fine(views_.object({i, ""}), "VertexRead",
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

void Tour::world() {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [from, to] = std::pair{run_.placed[vertex(i)].from.at, run_.placed[vertex(i)].to.at};
    const std::string name = vertex_name(i);
    fine(views_.world({i, ""}), "Placed",
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

void Tour::perspective() {
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
            {.text = behind > 0 ? "perspective" : "perspective.none",
             .facts = {{"before_near", behind}},
             .words = {{"vertices", run_.clip.size()}, {"test", before_near(words_)}},
             .count = behind > 0 ? std::optional(behind) : std::nullopt});
}

std::array<glm::dvec4, 3> Tour::corners() const {
  return {run_.clip[vertex(0)].clip.at, run_.clip[vertex(1)].clip.at, run_.clip[vertex(2)].clip.at};
}

std::pair<std::string_view, std::string_view> Tour::verdict() const {
  using back_face_culling::Facing;
  if (faced_.facing == Facing::front) return {"faced.front", "front"};
  if (faced_.facing != Facing::back) return {"faced.edge_on", "edge on"};
  return faced_.removed ? std::pair{"faced.back", "back"} : std::pair{"faced.two_sided", "two sided"};
}

std::string_view Tour::faulty_verdict() const {
  using back_face_culling::Facing;
  const bool wrong = run_.wrongly_faced(followed_);
  if (faced_.facing == Facing::front) return wrong ? "divided.front.wrong" : "divided.front";
  if (faced_.facing == Facing::back) return wrong ? "divided.back.wrong" : "divided.back";
  return "divided.edge_on";
}

void Tour::facing_after_division() {
  const auto c = corners();
  const double area = back_face_culling::divided_area(c[0], c[1], c[2]);
  const auto behind = std::ranges::count_if(c, [](const glm::dvec4& at) { return at.w < 0; });
  const bool front = faced_.facing == back_face_culling::Facing::front;
  fine(views_.facing(), "Faced",
       {.text = faulty_verdict(),
        .facts = {{"area", area}, {"determinant", exact_determinant(corners())}, {"removed", faced_.removed}},
        .words = {face_word(), {"names", corner_names()}, {"behind", behind}},
        .row = row("area", {area}),
        .key = figure_number(face()),
        .decides = yes_or_no(words_, "question.front", {face_word()}, front, "front", "back")});
  const auto removed = std::ranges::count_if(run_.faced, &Faced::removed);
  std::int64_t wrong = 0;
  for (std::size_t i = 0; i < run_.faced.size(); ++i) wrong += run_.wrongly_faced(i);
  milestone(views_.facing(), "BackFaceRemoval",
            {.text = wrong > 0 ? "facing_divided" : "facing_divided.right",
             .facts = {{"removed", removed}, {"kept", std::ssize(run_.faced) - removed}, {"wrong", wrong}}});
}

void Tour::facing() {
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

void Tour::clipping() {
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
            {.text = changed > 0 ? "clipping" : "clipping.none",
             .facts = {{"clipped", changed}, {"gone", gone}, {"triangles", std::ssize(run_.snapped)}},
             .words = {{"own", own_clipping()}},
             .count = changed > 0 ? std::optional(changed) : std::nullopt});
}

/// What clipping does to the followed triangle.
std::string Tour::own_clipping() const {
  const Clipped* own = run_.clipped_of(piece_.id);
  if (!own) return words_.say("own.removed", {face_word()});
  const std::string_view key = own->after.empty() ? "own.gone" : own->changed ? "own.cut" : "own.whole";
  return words_.say(key, {{"names", corner_names()}, {"corners", own->after.size()}});
}

void Tour::clipped_corner(const Clipped& own, std::size_t k) {
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
  fine(views_.divided({k, ""}), "Divided",
       {.text = "divided",
        .facts = fields_of(divided),
        .words = {{"name", name}, {"w", at.w}, {"place", place_text(ndc)}},
        .row = row(fmt::format("{} / {}", name, words_.symbol("w")), ndc),
        .key = name},
       "Clipped");
}

}  // namespace gradus::textbook_chain
