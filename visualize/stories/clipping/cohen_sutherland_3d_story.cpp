// The story of a segment in space and its region codes: which end moves to which face, and when it is
// settled.

#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d.hpp"

#include "stories/checking.hpp"
#include "stories/clipping/cohen_sutherland_3d/drawing.hpp"
#include "stories/clipping/region_codes.hpp"
#include "stories/parameters.hpp"
#include "stories/side_by_side.hpp"

namespace gradus::cohen_sutherland_3d {
namespace {

template <int N>
class Story {
 public:
  Story(const Words& words, const Subject<N>& subject)
      : words_(words), subject_(subject), state_{.rest = subject.line} {}

  void show(Board& board, const Classified<N, double>& c) {
    state_.code_a = state_.first_a = c.code_a;
    state_.code_b = state_.first_b = c.code_b;
    read_ = state_;
    draw(board);
  }
  Event say(const Classified<N, double>& c) const {
    return {.text = "classified",
            .facts = facts(),
            .words = {{"a", beyond(c.code_a)}, {"b", beyond(c.code_b)}},
            .row = row(state_),
            .begins = true,
            .decides = decision()};
  }

  void show(Board& board, const Cut<N, double>& c) {
    read_ = state_;
    state_.moves.push_back({c.of_a, c.face, c.of_a ? state_.rest.a : state_.rest.b, c.to()});
    state_.rest = c.line;
    state_.code_a = c.code_a;
    state_.code_b = c.code_b;
    draw(board);
    board.tells(static_cast<double>(state_.moves.size()));
  }
  Event say(const Cut<N, double>& c) const {
    const std::string end = c.of_a ? "a" : "b", face = face_name(words_, c.face);
    Event event{.text = c.of_a ? "cut.a" : "cut.b",
                .facts = facts(),
                .words = {{"face", face},
                          {"test", test_of(words_, subject_.region, c.face)},
                          {"to", c.to()},
                          {"after", text(c.after())}},
                .row = row(state_),
                .read = row(read_, words_.say("decision.cut", {{"end", end}, {"face", face}})),
                .key = end,
                .phase = face,
                .decides = decision()};
    event.facts.push_back({"face", std::string(name_of(c.face))});
    return event;
  }

  void show(Board& board, const Accepted<N, double>& a) {
    read_ = state_;
    state_.accepted = true;
    state_.rest = a.line;
    draw(board);
  }
  Event say(const Accepted<N, double>& a) const {
    const auto& [from, to] = a.line;
    Event event{.text = "accepted.box",
                .facts = facts(),
                .words = {{"from", from}, {"to", to}},
                .read = row(read_, words_.say("decision.accept")),
                .ends = true,
                .decides = decision()};
    if constexpr (N == 4) {
      event.text = "accepted.volume";
      event.words.push_back({"divided_from", dvec3(from) / from.w});
      event.words.push_back({"divided_to", dvec3(to) / to.w});
    }
    return event;
  }

  void show(Board& board, const Rejected&) {
    read_ = state_;
    state_.rejected = true;
    draw(board);
  }
  Event say(const Rejected& r) const {
    const bool settled = r.common != 0;
    Event event{.text = settled ? "rejected" : "gave_up",
                .facts = facts(),
                .words = {{"faces", faces(r.common)}},
                .read = row(read_, words_.say("decision.reject")),
                .ends = true};
    event.facts.push_back({"common", r.common, "code"});
    if (settled) event.decides = decision();
    return event;
  }

 private:
  void draw(Board& board) const { board.milestone(view_of(words_, subject_, state_)); }

  std::string text(Code code) const { return code_text(code, subject_.bits); }
  std::string faces(Code code) const {
    std::string list;
    for (const Border face : usual_order<3>()) {
      if ((code & bit(face)) != 0) list += (list.empty() ? "" : ", ") + face_name(words_, face);
    }
    return list;
  }
  std::string beyond(Code code) const {
    return words_.say(code == 0 ? "inside" : "beyond", {{"code", text(code)}, {"faces", faces(code)}});
  }
  std::vector<Said> row(const State<N>& state, std::string decision = "") const {
    const Code both = state.code_a & state.code_b;
    return {state.moves.size(), text(state.code_a), text(state.code_b), text(both), std::move(decision)};
  }
  std::vector<Field> facts() const {
    std::vector<Field> facts{{"code_a", state_.code_a, "code"}, {"code_b", state_.code_b, "code"}};
    for (const auto& [end, at] : {std::pair{"a", state_.rest.a}, {"b", state_.rest.b}}) {
      for (int i = 0; i < N; ++i) {
        const std::string axis(1, "xyzw"[i]);
        facts.push_back({fmt::format("{}_{}", end, axis), at[i], axis});
      }
    }
    return facts;
  }
  Decision decision() const {
    return decided_by_codes(words_, read_.code_a, text(read_.code_a), read_.code_b, text(read_.code_b));
  }

  const Words& words_;
  const Subject<N>& subject_;
  State<N> state_, read_;  ///< by now, and as it was when this step was decided
};

// --- The methods

/// What the steps of the taught method hold.
struct Numbers {
  template <int N, class T>
  void operator()(NumericStep<T>& to, const Classified<N, T>& c) const {
    to.point("a", c.line.a);
    to.point("b", c.line.b);
    to.decision(c.code_a);
    to.decision(c.code_b);
  }
  template <int N, class T>
  void operator()(NumericStep<T>& to, const Cut<N, T>& c) const {
    to.point(c.of_a ? "a" : "b", c.to());
    to.decision(c.face);
    to.decision(c.after());
  }
  template <class T, class Step>
  void operator()(NumericStep<T>&, const Step&) const {}
};

/// The segment of the view volume. Whatever the method is, it must be one.
Segment<4, double> seen_in(const Arguments& arguments) {
  const auto seen = segment_in<4>(arguments, "homogeneous");
  const dvec4 none(0);
  if (seen.a == none || seen.b == none) refuse("homogeneous", "0,0,0,0 is no point");
  if (opposite(seen.a, seen.b)) {
    refuse("homogeneous", "the ends are opposite each other: 0,0,0,0 lies between them");
  }
  return seen;
}

/// The plane that shows the first cut; x against w where there is none.
int plane_of(const Subject<4>& subject) {
  std::optional<int> axis;
  const auto watch = [&axis]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Cut<4, double>>) {
      if (!axis) axis = axis_of(step.face);
    }
  };
  correctly_rounded(subject.line, subject.region, subject.order, watch);
  return axis.value_or(0);
}

constexpr std::string_view usual_bits = "FNTBRL";

template <int N>
Subject<N> subject_of(const Arguments& arguments, const Notation& notation) {
  const auto seen = seen_in(arguments);
  const auto order = order_in<3>(arguments);
  const std::string bits = digit_letters(arguments, notation.bits_in_space);
  if constexpr (N == 4) {
    Subject<4> subject{seen, {}, order, bits};
    subject.plane = plane_of(subject);
    return subject;
  } else {
    return {segment_in<3>(arguments, "line"), box_in<3>(arguments, "box"), order, bits};
  }
}

/// The segment's ends and two opposite corners of the box, or ends with their w as they lie in space.
void let_drag(Narrator& narrator, const Subject<3>& subject) {
  const SpaceView space = space_of(subject);
  for (const std::string_view drawn : {"line", "box"})
    narrator.handles(drawn, [&](dvec3 p) { return space.at(p); });
}
void let_drag(Narrator& narrator, const Subject<4>& subject) {
  const SpaceView space = space_of(subject);
  narrator.handles("homogeneous", [&](const dvec4& p) { return space.at(in_space(p)); });
}

template <int N, class Clip>
void tell(Narrator& narrator, const Subject<N>& subject, Clip clip) {
  narrator.paper(paper_width, paper_height);
  const Words& words = narrator.words();
  say_digits_of_code(narrator, words.notation().bits_in_space, usual_bits,
                     [&words](std::size_t face) { return face_name(words, static_cast<Border>(face)); });
  narrator.subtitle("subtitle", {{"from", subject.line.a}, {"to", subject.line.b}});
  narrator.quantities({"a", "", "b"});  // as in the plane
  narrator.legend({{Role::boundary, N == 3 ? "box" : "volume"},
                   Role::input,
                   Role::current,
                   Role::rejected,
                   Role::result});
  let_drag(narrator, subject);
  Story<N> story(narrator.words(), subject);
  narrator.result({{"inside", clip(narrator.watcher(story)).has_value()}});
}

void tell_cut_of_a_cut(Narrator& narrator) {
  const auto subject = subject_of<3>(narrator.arguments(), narrator.words().notation());
  tell(narrator, subject,
       [&](auto watcher) { return cut_of_a_cut(subject.line, subject.region, subject.order, watcher); });
  tell_side_by_side<Numbers>(narrator, [subject]<class T>(T, const auto& observer) {
    cut_of_a_cut(in_scalar<T>(subject.line), in_scalar<T>(subject.region), subject.order, observer);
  });
}

/// In a box, or in the view volume before the division by w.
template <int N>
void tell_correctly_rounded(Narrator& narrator) {
  const auto subject = subject_of<N>(narrator.arguments(), narrator.words().notation());
  tell(narrator, subject,
       [&](auto watcher) { return correctly_rounded(subject.line, subject.region, subject.order, watcher); });
}

const Checking& checking() {
  static const Checking known{.asked = {{.name = "segment",
                                         .same = SameList::segments,
                                         .type = "Accepted",
                                         .fields = {"a_x", "a_y", "a_z", "b_x", "b_y", "b_z"}}},
                              .bits = "FNTBRL",
                              .codes = {"code_a", "code_b"}};
  return known;
}

}  // namespace

const TopicEntry& entry() {  // the catalogue asks for it by this name
  using namespace parameters;
  static const TopicEntry topic = completed<entry>(
      {.name = "cohen_sutherland_3d",
       .chapter = "clipping",
       .aliases = {"clip segments in space", "six-bit region codes", "view volume"},
       .summary = "the part of a segment in a box or in the view volume, by region codes of six bits",
       .methods = {{.name = "cut_of_a_cut",
                    .standing = Standing::taught,
                    .tell = tell_cut_of_a_cut,
                    .sizes = {{"line", {1e-75, 1e75}}, {"box", {1e-75, 1e75}}},
                    .unread = {"homogeneous"},
                    .exact = true},
                   {.name = "correctly_rounded",
                    .standing = Standing::fast,
                    .tell = tell_correctly_rounded<3>,
                    .unread = {"homogeneous"}},
                   {.name = "view_volume",
                    .tell = tell_correctly_rounded<4>,
                    .function = "correctly_rounded",
                    .unread = {"line", "box"}}},
       .columns = {{"cut"},
                   {.id = "code_a", .quantity = "a"},
                   {.id = "code_b", .quantity = "b"},
                   {"and"},
                   {"decision", false}},
       .counts = {"Cut"},
       .parameters =
           {numbers("line", "-2,1,2,12,11,9", "-2,1,2,12,11,9", "the segment's ends: x0,y0,z0,x1,y1,z1",
                    {"x0", "y0", "z0", "x1", "y1", "z1"}, {1e-300, 1e300}),
            bounds("box", "0,0,0,10,8,6", "0,0,0,10,8,6",
                   "the box: xmin,ymin,zmin,xmax,ymax,zmax; its faces belong to it",
                   {"xmin", "ymin", "zmin", "xmax", "ymax", "zmax"}, {1e-300, 1e300}),
            numbers("homogeneous", "-2.2,0.5,1.5,2,2,1,-1.5,-1", "-2.2,0.5,1.5,2,2,1,-1.5,-1",
                    "method view_volume: the ends x0,y0,z0,w0,x1,y1,z1,w1, not divided by w yet",
                    {"x0", "y0", "z0", "w0", "x1", "y1", "z1", "w1"}, {1e-100, 1e100}),
            order_parameter<3>("top,bottom,far,near,right,left",
                               "which face an end beyond several is cut at first"),
            noted(
                &Notation::bits_in_space,
                choice(
                    "code_bits",
                    {"FNTBRL", "LRBTNF"}, "FNTBRL",
                    "LRBTNF",
                    "how codes are written: far first, as a binary number (FNTBRL), or left first (LRBTNF)")),
            exact_parameter()},
       .examples = {"--line -2,1,2,12,11,9", "--line -3,5,1,4,12,2 --order top,bottom,left,right,near,far",
                    "--method view_volume --homogeneous -2.2,0.5,1.5,2,2,1,-1.5,-1"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::cohen_sutherland_3d
