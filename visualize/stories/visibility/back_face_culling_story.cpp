// The story of back-face culling: one test a face, by its normal and the view vector, by its area in the
// picture, or before the division.

#include "core/arithmetic/elementary.hpp"
#include "visibility/back_face_culling/back_face_culling.hpp"

#include "stories/checking.hpp"
#include "stories/visibility/back_face_culling_drawing.hpp"
#include "visibility/back_face_culling/back_face_culling_notes.hpp"

namespace gradus::back_face_culling {
namespace {

constexpr int paper_width = 36, paper_height = 26;
/// Of the paper: space above, the picture and a plane below it; or a large picture, space beside it.
constexpr Extent space_place{{0.4, 10.4}, {35.6, 25.8}}, clip_place{{0.4, 10.4}, {35.6, 25}},
    picture_place{{0.4, 0.2}, {16.4, 7.8}}, lower_place{{19.6, 0.2}, {35.6, 7.8}},
    large_place{{0.4, 0.4}, {21.4, 25.6}}, beside_place{{23, 8}, {35.6, 22}};

/// What a method goes by.
enum class By { product, area, determinant, depth };

class CullingStory {
 public:
  CullingStory(const Words& words, const Task& task, By by, bool three_corners = false)
      : words_(words),
        task_(task),
        by_(by),
        three_corners_(three_corners),
        space_(task, space_in(by), by == By::determinant),
        picture_(task, in_space() ? picture_place : large_place, by == By::determinant),
        signs_(task.faces.size()) {}

  /// What the exact method says, where this one may be wrong.
  void compare_with(std::vector<int> right) { right_ = std::move(right); }

  const SpacePicture& space() const { return space_; }

  void show(Board& board, const steps::Started&) { put(board); }
  Event say(const steps::Started&) const {
    constexpr std::array<std::string_view, 4> texts{"started.product", "started.area", "started.determinant",
                                                    "started.depth"};
    return {.text = texts[static_cast<std::size_t>(by_)],
            .count = std::ssize(task_.faces),
            .begins = true,
            .level = Level::idea};
  }

  void show(Board& board, const NormalFound<double>& n) {
    turn_to(n.face);
    normal_ = n.normal;
    // View space is mirrored: there the cross product points inwards
    if (by_ == By::depth) {
      const Frame<double>& f = task_.frame;
      drawn_normal_ = -(n.normal.x * f.right + n.normal.y * f.up + n.normal.z * f.forward);
    } else {
      drawn_normal_ = n.normal;
    }
    put(board);
  }
  Event say(const NormalFound<double>& n) const {
    std::string_view text = by_ == By::depth ? "normal.view" : three_corners_ ? "normal.three" : "normal";
    if (n.normal == dvec3{0}) text = "normal.none";
    return {.text = text,
            .facts = fields_of(n.normal),
            .words = {{"name", name()}, {"N", n.normal}},
            .key = name()};
  }

  void show(Board& board, const ViewTaken<double>& v) {
    view_ = v.view;
    at_ = v.at;
    board.detail(drawing());
  }
  Event say(const ViewTaken<double>& v) const {
    return {.text = task_.distant ? "view.distant" : "view",
            .facts = fields_of(v.view),
            .words = {{"name", name()}, {"V", v.view}, {"E", dvec3(task_.eye)}, {"P", v.at}},
            .key = name()};
  }

  void show(Board& board, const TriangleAdded<double>& t) {
    if (t.corner == 1) turn_to(t.face);
    triangle_ = t;
    board.detail(drawing());
  }
  Event say(const TriangleAdded<double>& t) const {
    return {.text = t.corner == 1 ? "triangle.first" : "triangle",
            .facts = {{"area", t.area}, {"sum", t.sum}},
            .words = {{"name", name()}, {"area", t.area}, {"sum", t.sum}},
            .key = name()};
  }

  void show(Board& board, const Judged<double>& j) {
    if (j.face != face_) turn_to(j.face);
    triangle_.reset();
    signs_[j.face] = j.sign;
    judged_ = true;
    put(board);
  }
  Event say(const Judged<double>& j) const {
    constexpr std::array<const char*, 3> branches{"back", "edge on", "front"};
    constexpr std::array<std::string_view, 3> sides{"side.back", "side.edge_on", "side.front"};
    constexpr std::array<std::array<std::string_view, 3>, 4> texts{
        {{"product.back", "product.edge_on", "product.front"},
         {"area.back", "area.edge_on", "area.front"},
         {"determinant.back", "determinant.edge_on", "determinant.front"},
         {"depth.back", "depth.edge_on", "depth.front"}}};
    const auto side = static_cast<std::size_t>(j.sign + 1);
    const bool rounded = detail::sign_of(j.value) != j.sign;
    const std::string answer = words_.say(sides[side]);
    Event event{.text = rounded ? "rounded" : texts[static_cast<std::size_t>(by_)][side],
                .facts = {{"value", j.value}, {"sign", j.sign}},
                .words = {{"name", name()}, {"value", j.value}, {"answer", answer}},
                .key = name(),
                .decides = Decision{words_.say("question", {{"name", name()}}),
                                    {words_.say(sides[0]), words_.say(sides[1]), words_.say(sides[2])},
                                    side,
                                    branches[side]}};
    if (by_ == By::product) {
      event.words.push_back({"terms", terms()});
      event.row = {name(), normal_, view_.value_or(dvec3{0}), j.value, answer};
    } else if (by_ == By::depth) {
      event.row = {name(), normal_, j.value, answer};
    } else {
      event.words.push_back({"what", right_.empty() ? "det" : "2A"});
      event.row = {name(), j.value, answer};
    }
    return event;
  }

  void show(Board& board, const Finished&) {
    face_ = none;
    ended_ = true;
    if (right_.empty()) hidden_ = hidden_front();
    put(board);
  }
  Event say(const Finished& f) const {
    Event event{.text = "finished",
                .facts = {{"tests", static_cast<std::int64_t>(f.tests)},
                          {"drawn", static_cast<std::int64_t>(f.drawn)}},
                .words = {{"tests", f.tests}, {"drawn", f.drawn}, {"skipped", f.tests - f.drawn}}};
    for (std::size_t i = 0; i < right_.size(); ++i) {
      const bool draws = *signs_[i] > 0, should = right_[i] > 0;
      if (draws == should) continue;
      event.text = draws ? "finished.drawn_wrongly" : "finished.skipped_wrongly";
      event.words.push_back({"name", task_.faces[i].name});
      return event;
    }
    if (!right_.empty()) return event;
    for (std::size_t i = 0; i < task_.faces.size(); ++i) {
      if (faces_task::is_flat(task_.faces[i].points)) continue;
      event.text = "finished.not_flat";
      event.words.push_back({"name", task_.faces[i].name});
      return event;
    }
    if (hidden_) {
      event.text = "finished.hidden";
      event.words.push_back({"name", task_.faces[hidden_->first].name});
    }
    return event;
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  static const Extent& space_in(By by) {
    if (by == By::area) return beside_place;
    return by == By::determinant ? clip_place : space_place;
  }
  bool in_space() const { return by_ != By::area; }
  const std::string& name() const { return task_.faces[face_].name; }
  void turn_to(std::size_t face) {
    face_ = face;
    normal_ = drawn_normal_ = dvec3{0};
    view_.reset();
    triangle_.reset();
    judged_ = false;
  }
  /// "0·1 + 4·(−2) + 4·3".
  std::string terms() const {
    std::string sum;
    for (int k = 0; k < 3; ++k) {
      const std::string first = figure_real(normal_[k]);
      sum +=
          (k > 0 ? " + " + figure_factor(first) : first) + "·" + figure_factor(view_.value_or(dvec3{0})[k]);
    }
    return sum;
  }
  /// A face that is drawn, and a place on its border that another one hides from the eye.
  std::optional<std::pair<std::size_t, dvec3>> hidden_front() const {
    std::vector<Ring> rings;
    for (const NamedFace& face : task_.faces) rings.push_back(face.points);
    const HiddenLines lines(rings,
                            task_.distant ? distant_viewer(dvec3(task_.eye)) : viewer_at(dvec3(task_.eye)),
                            2 * task_.radius);
    for (std::size_t i = 0; i < rings.size(); ++i) {
      if (signs_[i].value_or(0) <= 0) continue;
      for (std::size_t k = 0; k < rings[i].size(); ++k) {
        const dvec3 a = rings[i][k], b = rings[i][(k + 1) % rings[i].size()];
        for (const SightPiece& piece : lines.pieces(a, b)) {
          if (piece.hidden) return std::pair(i, a + 0.5 * (piece.from + piece.to) * (b - a));
        }
      }
    }
    return std::nullopt;
  }

  Look look_of(std::size_t i) const {
    if (i == face_ && !judged_) return {Role::current, true, false, true, 3};
    if (!signs_[i]) return {Role::past, false, false, in_space(), 1};
    const bool front = *signs_[i] > 0;
    if (!front) return {Role::rejected, false, true, i == face_, 0};
    return {ended_ ? Role::result : Role::accepted, true, false, true, 2};
  }

  void put(Board& board) const { board.milestone(drawing()); }
  View drawing() const {
    View view;
    std::vector<Look> looks;
    for (std::size_t i = 0; i < task_.faces.size(); ++i) looks.push_back(look_of(i));
    space_.add(view, looks);
    picture_.add(view, looks);
    if (by_ == By::area) picture_.add_names(view, looks);
    if (by_ == By::area || !picture_.empty()) {
      const std::string caption = by_ == By::area          ? words_.say("caption.space")
                                  : by_ == By::determinant ? words_.say("caption.divided")
                                                           : words_.say("caption.picture");
      const Extent& beside = in_space() ? picture_place : beside_place;
      view.add({"z caption", Role::guide, Text{{beside.centre().x, beside.upper.y + 1.1}, caption}});
    }
    if (hidden_ && in_space()) space_.add_sight(view, hidden_->second);
    if (face_ == none) return view;
    if (by_ == By::area || by_ == By::determinant) {
      const Role role = !judged_ ? Role::current : *signs_[face_] > 0 ? Role::accepted : Role::rejected;
      if (triangle_)
        picture_.add_triangle(view, face_, triangle_->corner,
                              triangle_->area < 0 ? Role::rejected : Role::accepted);
      picture_.add_turn(view, face_, role, by_ == By::determinant);
    }
    if (by_ == By::determinant) add_depths(view);
    if (by_ == By::product || by_ == By::depth) add_plane(view);
    return view;
  }
  void add_plane(View& view) const {
    const dvec3 p = task_.faces[face_].points[0];
    std::optional<dvec3> to_eye = view_;
    if (by_ == By::depth && judged_) to_eye = view_vector<double>(std::span(&p, 1), task_.eye);
    space_.add_normal(view, face_, drawn_normal_);
    if (to_eye) space_.add_view(view, face_);
    std::string angle;
    if (to_eye && drawn_normal_ != dvec3{0} && *to_eye != dvec3{0}) {
      const double cosine = std::clamp(glm::dot(unit_vector(drawn_normal_), unit_vector(*to_eye)), -1.0, 1.0);
      angle = fmt::format("{:.0f}°", gradus::acos(cosine) * 57.29577951308232);
    }
    std::optional<dvec3> along_z;
    if (by_ == By::depth) along_z = -task_.frame.forward;
    add_edge_on(view, lower_place, drawn_normal_, to_eye, along_z, angle);
    view.add({"z caption plane", Role::guide,
              Text{{lower_place.centre().x, lower_place.upper.y + 1.1}, words_.say("caption.plane")}});
  }
  /// Where the corners of the face lie before the eye and behind it.
  void add_depths(View& view) const {
    const auto rings = task_.clip();
    double least = 0, most = 0;
    for (const Ring& ring : rings) {
      for (const dvec3 p : ring) {
        least = std::min(least, p.z);
        most = std::max(most, p.z);
      }
    }
    const double y = lower_place.centre().y;
    const NumberLine line({lower_place.lower.x + 0.6, y}, {lower_place.upper.x - 0.6, y}, least, most);
    line.add_to(view, "w", "w");
    const Ring& ring = rings[face_];
    for (std::size_t k = 0; k < ring.size(); ++k)
      view.add_named(fmt::format("w corner {:02}", k), Role::current, line.at(ring[k].z),
                     fmt::format("{}", k + 1));
    view.add({"z caption depth", Role::guide,
              Text{{lower_place.centre().x, lower_place.upper.y + 1.1}, words_.say("caption.depth")}});
  }

  const Words& words_;
  const Task& task_;
  const By by_;
  const bool three_corners_;
  SpacePicture space_;
  EyePicture picture_;
  std::vector<std::optional<int>> signs_;
  std::vector<int> right_{};
  std::size_t face_ = none;
  dvec3 normal_{0}, drawn_normal_{0}, at_{0};
  std::optional<dvec3> view_{};
  std::optional<TriangleAdded<double>> triangle_{};
  std::optional<std::pair<std::size_t, dvec3>> hidden_{};
  bool judged_ = false, ended_ = false;
};

// --- The methods

constexpr auto drop = [](std::size_t) {};

void set_up(Narrator& narrator, const Task& task, By by, bool faulty) {
  narrator.paper(paper_width, paper_height);
  narrator.subtitle(by == By::area          ? "subtitle.image"
                    : by == By::determinant ? "subtitle.clip"
                                            : "subtitle.object",
                    {{"count", task.faces.size()}});
  if (by == By::area) narrator.columns({{"face", false}, {"area"}, {"side", false}});
  if (by == By::determinant) narrator.columns({{"face", false}, {faulty ? "area" : "det"}, {"side", false}});
  if (by == By::depth) narrator.columns({{"face", false}, {"N"}, {"z"}, {"side", false}});
  narrator.legend({{Role::current, "current"},
                   {Role::accepted, "front"},
                   {Role::rejected, "back"},
                   {Role::past, "waiting"},
                   {Role::result, "result"}});
}

/// The signs that the exact method finds.
std::vector<int> exact_signs(const Task& task) {
  std::vector<int> signs;
  normal_and_view<double>(task.world(), task.eye, drop, [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Judged<double>>) signs.push_back(step.sign);
  });
  return signs;
}

/// Every corner must have its place in the picture.
void require_before_the_eye(const Narrator& narrator, const Task& task, bool behind_too = false) {
  for (const Ring& ring : task.clip()) {
    for (const dvec3 p : ring) {
      if (behind_too ? p.z != 0 : p.z > 1e-6 * task.radius) continue;
      refuse(narrator.arguments(), {"eye", "target", "faces"},
             behind_too ? "corners before the eye or behind it expected, found one beside it"
                        : "corners before the eye expected, found one behind it: clip first");
    }
  }
}

template <class Run>
void tell_method(Narrator& narrator, By by, bool faulty, const Run& run) {
  const Task task = task_of(narrator.arguments());
  set_up(narrator, task, by, faulty);
  if (by == By::area) require_before_the_eye(narrator, task);
  CullingStory story(narrator.words(), task, by, faulty && by == By::product);
  if (faulty) story.compare_with(exact_signs(task));
  narrator.handles("faces", [&](dvec3 p) { return story.space().at(p); });
  if (task.eye_is_near()) narrator.handles("eye", [&](dvec3 p) { return story.space().at(p); });
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  std::size_t drawn = 0;
  run(task, [&](std::size_t) { ++drawn; }, watch);
  narrator.result({{"tests", std::ssize(task.faces)}, {"drawn", static_cast<std::int64_t>(drawn)}});
}

void tell_normal_and_view(Narrator& narrator) {
  tell_method(narrator, By::product, false, [](const Task& task, const auto& draw, const auto& watch) {
    normal_and_view<double>(task.world(), task.eye, draw, watch);
  });
}
void tell_first_three(Narrator& narrator) {
  tell_method(narrator, By::product, true, [](const Task& task, const auto& draw, const auto& watch) {
    first_three_corners<double>(task.world(), task.eye, draw, watch);
  });
}
void tell_screen_area(Narrator& narrator) {
  tell_method(narrator, By::area, false, [](const Task& task, const auto& draw, const auto& watch) {
    const auto outlines = task.outlines();
    screen_area<double>(spans_of(outlines), draw, watch);
  });
}
void tell_misprinted(Narrator& narrator) {
  tell_method(narrator, By::area, true, [](const Task& task, const auto& draw, const auto& watch) {
    const auto outlines = task.outlines();
    misprinted_shoelace<double>(spans_of(outlines), draw, watch);
  });
}
void tell_six_products(Narrator& narrator) {
  tell_method(narrator, By::area, true, [](const Task& task, const auto& draw, const auto& watch) {
    const auto outlines = task.outlines();
    six_products<double>(spans_of(outlines), draw, watch);
  });
}
void tell_homogeneous(Narrator& narrator) {
  tell_method(narrator, By::determinant, false, [](const Task& task, const auto& draw, const auto& watch) {
    const auto rings = task.clip();
    homogeneous<double>(spans_of(rings), draw, watch);
  });
}
void tell_after_division(Narrator& narrator) {
  tell_method(narrator, By::determinant, true, [&](const Task& task, const auto& draw, const auto& watch) {
    require_before_the_eye(narrator, task, true);
    const auto rings = task.clip();
    after_division<double>(spans_of(rings), draw, watch);
  });
}
void tell_eye_space_normal(Narrator& narrator) {
  tell_method(narrator, By::depth, true, [](const Task& task, const auto& draw, const auto& watch) {
    eye_space_normal<double>(spans_of(task.view), draw, watch);
  });
}

const Checking& checking() {
  static const Checking known{
      .asked = {{.name = "signs", .same = SameList::set, .type = "Judged", .fields = {"key", "sign"}}},
      // Seen from its edge
      .is_tie = [](const TraceStep& step) {
        return step.type == "Judged" && value_as<std::int64_t>(step.fields, "sign") == 0;
      }};
  return known;
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  static const Sizes sizes{1e-6, 1e9};
  static const auto faces = [] {
    Parameter parameter = faces_task::faces_parameter(
        "+z: -1,-1,1 1,-1,1 1,1,1 -1,1,1; -z: 1,-1,-1 -1,-1,-1 -1,1,-1 1,1,-1; "
        "+x: 1,-1,1 1,-1,-1 1,1,-1 1,1,1; -x: -1,-1,-1 -1,-1,1 -1,1,1 -1,1,-1; "
        "+y: -1,1,1 1,1,1 1,1,-1 -1,1,-1; -y: -1,-1,-1 1,-1,-1 1,-1,1 -1,-1,1",
        "A: 0,0,0 4,0,0 4,3,0; B: 1,1,-1 1,2,2 3,1,-1");
    parameter.help = "what is looked at: faces, counter-clockwise seen from outside";
    parameter.sizes = sizes;
    return parameter;
  }();
  static const TopicEntry topic = completed<entry>(
      {.name = "back_face_culling",
       .chapter = "visibility",
       .aliases = {"backface culling", "back-face removal", "facing"},
       .summary = "faces that turn their backs to the eye are skipped, one test each",
       .methods = {{.name = "normal_and_view", .standing = Standing::taught, .tell = tell_normal_and_view},
                   {.name = "screen_area", .tell = tell_screen_area},
                   {.name = "homogeneous", .tell = tell_homogeneous},
                   {.name = "first_three_corners", .standing = Standing::faulty, .tell = tell_first_three},
                   {.name = "eye_space_normal", .standing = Standing::faulty, .tell = tell_eye_space_normal},
                   {.name = "after_division", .standing = Standing::faulty, .tell = tell_after_division},
                   {.name = "misprinted_shoelace", .standing = Standing::faulty, .tell = tell_misprinted},
                   {.name = "six_products", .standing = Standing::faulty, .tell = tell_six_products}},
       .default_method = "normal_and_view",
       .columns = {{"face", false}, {"N"}, {"V"}, {"product"}, {"side", false}},
       .parameters = {faces,
                      parameters::numbers("eye", "2,1.8,2.9", "3,4,5", "where the eye is", parameters::xyz,
                                          sizes),
                      parameters::instead_of("eye", faces_task::towards_parameter("")),
                      parameters::numbers("target", "0,0,0", "0,1,0",
                                          "what the eye looks at: the middle of its picture", parameters::xyz,
                                          sizes)},
       .examples = {"--eye 3,0,0.5", "--method screen_area", "--towards 1,2,3"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::back_face_culling
