// The story of a segment and the codes of its ends.

#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d.hpp"

#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d_notes.hpp"
#include "stories/clipping/clip_checking.hpp"
#include "stories/clipping/region_codes.hpp"
#include "stories/clipping/window_view.hpp"
#include "stories/parameters.hpp"
#include "stories/side_by_side.hpp"

namespace gradus::cohen_sutherland_2d {
namespace {

using window_view::Line;

/// What happens where the codes settle nothing: an end is cut off what is left or off the original line, or
/// gets a code alone, or all is dropped.
enum class Way { cut_of_a_cut, correctly_rounded, codes_only, whole_or_nothing };

struct Subject {
  Line line;
  Rectangle<double> window;
  Order order;
  std::string bits;  ///< which border each digit stands for, the first to the left
  std::optional<Line> right;
};

constexpr std::string_view usual_bits = "TBRL";

Subject subject_of(const Arguments& arguments, const Notation& notation) {
  const Line line = window_view::line_in(arguments);
  const Rectangle<double> window = window_view::window_in(arguments);
  window_view::require_scale(arguments, line, window);
  return {line, window, order_in<2>(arguments), digit_letters(arguments, notation.bits),
          correctly_rounded(line, window)};
}

/// The codes of both ends.
struct Codes {
  Code a = 0, b = 0;
};

class Story {
 public:
  Story(const Words& words, const Subject& subject, Way way)
      : words_(words),
        subject_(subject),
        plane_(subject.line, subject.window, {{3.2, 5}, {35, 25}}, code_size),
        way_(way),
        whole_(way == Way::whole_or_nothing),
        now_(subject.line) {}
  const window_view::DrawnPlane& plane() const { return plane_; }

  void show(Board& board, const Classified<double>& c) {
    codes_ = read_ = {c.code_a, c.code_b};
    board.milestone(drawing(Role::current));
  }
  Event say(const Classified<double>& c) const {
    return {.text = "classified",
            .facts = {{"code_a", c.code_a, "code"}, {"code_b", c.code_b, "code"}},
            .words = {{"a", c.line.a},
                      {"b", c.line.b},
                      {"code_a", digits(codes_.a)},
                      {"code_b", digits(codes_.b)},
                      {"verdict", verdict()}},
            .row = {"", "", "", "", "", digits(codes_.a), digits(codes_.b)},
            .key = "codes",
            .begins = true,
            .decides = decision()};
  }

  void show(Board& board, const Cut<double>& c) {
    read_ = std::exchange(codes_, {c.code_a, c.code_b});
    before_ = std::exchange(now_, c.line);
    cuts_.push_back({c.of_a ? before_.a : before_.b, c.to()});
    View view = drawing(Role::current);
    // Its new place is named with its code below
    view.marks.erase("moved " + end(c.of_a));
    view.marks.erase("moved " + end(c.of_a) + " name");
    plane_.add_cutting_border(view, c.border);
    plane_.add_point(view, "cut now", Role::measure, c.to(), c.to(),
                     fmt::format("{}: {}", figure_place(c.to()), digits(c.after())), false, end(c.of_a));
    board.milestone(std::move(view));
    board.tells(static_cast<double>(cuts_.size()));
  }
  Event say(const Cut<double>& c) const {
    const int axis = axis_of(c.border);
    return {.text = "cut",
            .facts = {{"of_a", c.of_a, "end"},
                      {"border", std::string(name_of(c.border))},
                      {"x", c.to().x},
                      {"y", c.to().y},
                      {"code_a", c.code_a, "code"},
                      {"code_b", c.code_b, "code"}},
            .words = {{"end", end(c.of_a)},
                      {"border", beyond(c.border)},
                      {"code", digits(c.of_a ? read_.a : read_.b)},
                      {"axis", words_.axis(axis)},
                      {"at", coordinate(subject_.window, c.border)},
                      {"other", words_.axis(1 - axis)},
                      {"formula", formula(c)},
                      {"value", c.to()[1 - axis]},
                      {"after", digits(c.after())}},
            .note = fmt::format("{}: {} → {}", end(c.of_a), digits(c.of_a ? read_.a : read_.b),
                                digits(c.after())),
            .row = row(cuts_.size(), c.of_a, c.border, c.to()),
            .key = std::string(name_of(c.border)),
            .phase = name(c.border),
            .decides = decision()};
  }

  void show(Board& board, const Recoded<double>& r) {
    read_ = std::exchange(codes_, {r.code_a, r.code_b});
    ++rounds_;
    View view = drawing(Role::current);
    plane_.add_point(view, "computed", Role::candidate, r.at, r.at, words_.say("computed"), true);
    board.milestone(std::move(view));
  }
  Event say(const Recoded<double>& r) const {
    return {.text = "recoded",
            .facts = {{"of_a", r.of_a, "end"}, {"border", std::string(name_of(r.border))}},
            .words = {{"border", name(r.border)},
                      {"point", r.at},
                      {"code", digits(r.of_a ? codes_.a : codes_.b)},
                      {"end", end(r.of_a)}},
            .row = row(rounds_, r.of_a, r.border, r.at),
            .key = std::string(name_of(r.border)),
            .decides = decision()};
  }

  void show(Board& board, const Accepted<double>& a) {
    read_ = codes_;
    if (subject_.right) off_ = window_view::off_by(a.line, *subject_.right);
    const bool faulty = way_ == Way::codes_only || whole_;
    unclipped_ = !subject_.right || (faulty && off_.doubles > 0);
    View view = drawing(Role::result);
    if (unclipped_) add_right(view);
    board.milestone(std::move(view));
    result_ = {{"accepted", true}, {"cuts", count_of_cuts()}, {"off_by", off_.doubles}};
  }
  Event say(const Accepted<double>& a) const {
    Event event = window_view::accepted(a.line, unclipped_ ? window_view::Off{} : off_);
    if (unclipped_) event.text = "unclipped";
    event.decides = decision();
    return event;
  }

  void show(Board& board, const Rejected&) {
    read_ = codes_;
    View view = drawing(Role::rejected);
    if (whole_) add_right(view);
    board.milestone(std::move(view));
    result_ = {{"accepted", false}, {"cuts", count_of_cuts()}};
  }
  Event say(const Rejected& r) const {
    const bool settled = r.common != 0;
    return {.text = !settled ? "unsettled"
                    : whole_ ? "dropped"
                             : "rejected",
            .facts = {{"common", r.common, "code"}},
            .words = {{"code_a", digits(codes_.a)},
                      {"code_b", digits(codes_.b)},
                      {"border", beyond(first(subject_.order, r.common))}},
            .ends = true,
            .decides = settled ? std::optional(decision()) : std::nullopt};
  }

  void show(Board& board, const GaveUp& g) {
    View view = drawing(Role::rejected);
    add_right(view);
    board.milestone(std::move(view));
    result_ = {{"accepted", false}, {"rounds", g.rounds}};
  }
  static Event say(const GaveUp& g) {
    return {.text = "gave_up", .facts = {{"rounds", g.rounds}}, .ends = true};
  }

  const std::vector<Field>& result() const { return result_; }

 private:
  static constexpr dvec2 code_size{3.7, 2.2};  ///< of a code and some room round it

  std::string name(Border border) const { return words_.say(fmt::format("border.{}", name_of(border))); }
  std::string beyond(Border border) const { return words_.say(fmt::format("beyond.{}", name_of(border))); }
  static std::string end(bool of_a) { return of_a ? "a" : "b"; }
  std::string digits(Code code) const { return code_text(code, subject_.bits); }
  std::vector<Said> row(std::size_t number, bool of_a, Border border, dvec2 at) const {
    return {number, end(of_a), name(border), at.x, at.y, digits(codes_.a), digits(codes_.b)};
  }
  /// The cut with its numbers put in: "8 + 12·5/8".
  std::string formula(const Cut<double>& c) const {
    const Line line = way_ == Way::correctly_rounded ? subject_.line : before_;
    const int i = axis_of(c.border), j = 1 - i;
    return fmt::format("{} + {}·{}/{}", figure_real(line.a[j]), figure_factor(line.b[j] - line.a[j]),
                       figure_factor(coordinate(subject_.window, c.border) - line.a[i]),
                       figure_factor(line.b[i] - line.a[i]));
  }

  std::string verdict() const {
    if ((codes_.a | codes_.b) == 0) return words_.say("verdict.inside");
    if (whole_) return words_.say("verdict.dropped");
    return words_.say((codes_.a & codes_.b) != 0 ? "verdict.beyond" : "verdict.undecided");
  }
  Decision decision() const {
    const std::string a = digits(read_.a), b = digits(read_.b);
    if (!whole_) return decided_by_codes(words_, read_.a, a, read_.b, b);
    const bool set = (read_.a | read_.b) != 0;
    return yes_or_no(words_, "question_whole", {{"code_a", a}, {"code_b", b}}, set, "rejected", "accepted");
  }

  std::int64_t count_of_cuts() const { return std::ssize(cuts_); }
  void add_right(View& view) const {
    if (subject_.right) plane_.add_line(view, "right", Role::accepted, *subject_.right);
  }
  /// The whole drawing: regions with their codes, what was cut off, what is left.
  View drawing(Role left_over) const {
    View view;
    plane_.add_window(view, words_);
    add_codes(view);
    for (std::size_t i = 0; i < cuts_.size(); ++i) {
      const bool last = i + 1 == cuts_.size() && left_over == Role::current;
      plane_.add_line(view, fmt::format("cut off {}", i + 1), last ? Role::rejected : Role::past, cuts_[i],
                      true);
    }
    plane_.add_line(view, "left over", left_over, now_, left_over == Role::rejected);
    const auto& [a, b] = subject_.line;
    const Role moved = left_over == Role::result ? left_over : Role::current;
    add_end(view, "a", {a, b}, now_.a, codes_.a, moved);
    add_end(view, "b", {b, a}, now_.b, codes_.b, moved);
    return view;
  }
  /// An end as it was given, hollow once it has moved, and the code of where it is by now.
  void add_end(View& view, const std::string& name, const Line& given, dvec2 now, Code code,
               Role moved) const {
    const bool stays = given.a == now;
    plane_.add_point(view, "end " + name, Role::input, given.a, given.b,
                     stays ? name + ": " + digits(code) : name, !stays, name);
    if (!stays) plane_.add_point(view, "moved " + name, moved, now, now, digits(code), false, name);
  }
  /// The end whose code a region has; none where both or neither have it.
  std::string end_in(Code region) const {
    if ((region == codes_.a) == (region == codes_.b)) return "";
    return end(region == codes_.a);
  }
  /// Each region's code where the segment leaves room for it, and which digit is which.
  void add_codes(View& view) const {
    const auto [lower, upper] = plane_.shown();
    const auto [from, to] = subject_.window;
    const double xs[] = {lower.x, from.x, to.x, upper.x}, ys[] = {lower.y, from.y, to.y, upper.y};
    const Code across[] = {bit(Border::left), 0, bit(Border::right)};
    const Code up[] = {bit(Border::bottom), 0, bit(Border::top)};
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        const Code region = static_cast<Code>(across[i] | up[k]);
        const auto place =
            plane_.clear_place({{xs[i], ys[k]}, {xs[i + 1], ys[k + 1]}}, subject_.line, code_size - 0.5);
        if (!place) continue;
        view.add(
            {fmt::format("region {:02}", region), Role::guide, Text{*place, digits(region)}, end_in(region)});
      }
    }
    add_order_of_digits(view);
  }
  /// Beside the plane, which loses no height to it, or below a wide one.
  void add_order_of_digits(View& view) const {
    std::vector<std::string> names;
    for (const char letter : subject_.bits)
      names.push_back(name(static_cast<Border>(border_letters.find(letter))));
    const Extent& plane = plane_.panel().place();
    constexpr double widest_with_room = 22;
    if (plane.size().x > widest_with_room) {
      const std::string order = fmt::format("{}", fmt::join(names, " · "));
      view.add(
          {"bits", Role::guide, Text{{18, 2.2}, words_.say("bits", {{"bits", order}}), Align::centre, true}});
      return;
    }
    const std::array<std::string, 3> lines{words_.say("bits", {{"bits", ""}}),
                                           names[0] + " · " + names[1] + " ·", names[2] + " · " + names[3]};
    const dvec2 at = plane.lower + dvec2{plane.size().x + 1.2, 0.4};
    for (int i = 0; i < 3; ++i)
      view.add({fmt::format("bits {}", i), Role::guide,
                Text{at, lines[static_cast<std::size_t>(i)], Align::left, true, i - 2}});
  }

  const Words& words_;
  const Subject& subject_;
  const window_view::DrawnPlane plane_;
  const Way way_;
  const bool whole_;
  Line now_, before_{};  ///< what is left, and what was before the last cut
  Codes codes_, read_;   ///< by now, and those that this step is decided by
  std::vector<Line> cuts_;
  std::size_t rounds_ = 0;
  window_view::Off off_{};
  bool unclipped_ = false;
  std::vector<Field> result_;
};

// --- The methods

/// What the steps of the taught method hold.
struct Numbers {
  template <class T>
  void operator()(NumericStep<T>& to, const Classified<T>& c) const {
    to.point("a", c.line.a);
    to.point("b", c.line.b);
    to.decision(c.code_a);
    to.decision(c.code_b);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Cut<T>& c) const {
    to.point(c.of_a ? "a" : "b", c.to());
    to.decision(c.border);
    to.decision(c.after());
  }
  template <class T, class Step>
  void operator()(NumericStep<T>&, const Step&) const {}
};

template <Way way>
void tell(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments(), narrator.words().notation());
  const auto& [line, window, order, bits, right] = subject;
  const Words& words = narrator.words();
  narrator.paper(window_view::paper_width, window_view::paper_height);
  say_digits_of_code(narrator, words.notation().bits, usual_bits, [&words](std::size_t border) {
    return words.say(fmt::format("border.{}", name_of(static_cast<Border>(border))));
  });
  narrator.subtitle("subtitle", {{"from", line.a}, {"to", line.b}});
  narrator.quantities({"a", "", "b"});  // the second looks like the border cut at
  narrator.legend(
      {Role::boundary, Role::input, Role::current, Role::measure, Role::rejected, Role::past, Role::result});
  if (narrator.method().standing == Standing::faulty) {
    narrator.add_to_legend(Role::accepted, "right");
    narrator.add_to_legend(Role::candidate, "candidate");
  }
  Story story(words, subject, way);
  window_view::let_drag(narrator, story.plane());
  const auto watcher = narrator.watcher(story);
  if constexpr (way == Way::cut_of_a_cut) cut_of_a_cut(line, window, order, watcher);
  if constexpr (way == Way::correctly_rounded) correctly_rounded(line, window, order, watcher);
  if constexpr (way == Way::codes_only) codes_only(line, window, order, 8, watcher);
  if constexpr (way == Way::whole_or_nothing) whole_or_nothing(line, window, watcher);
  narrator.result(story.result());
  tell_side_by_side<Numbers>(narrator, [subject]<class T>(T, const auto& observer) {
    cut_of_a_cut(in_scalar<T>(subject.line), in_scalar<T>(subject.window), subject.order, observer);
  });
}

const Checking& checking() {
  static const Checking known{.asked = {{.name = "segment",
                                         .same = SameList::segments,
                                         .type = "Accepted",
                                         .fields = {"x0", "y0", "x1", "y1"}}},
                              .follows = follows_by_cuts,
                              .bits = "TBRL",
                              .codes = {"code_a", "code_b"}};
  return known;
}

}  // namespace

const TopicEntry& entry() {  // the catalogue asks for it by this name
  using namespace parameters;
  const std::vector<SizesOf> rounded{{"line", window_view::rounded_sizes},
                                     {"window", window_view::rounded_sizes}};
  static const TopicEntry topic = completed<entry>(
      {.name = "cohen_sutherland_2d",
       .chapter = "clipping",
       .aliases = {"cohen sutherland", "line clipping", "region codes", "outcodes"},
       .summary = "the part of a segment that lies in a window, by region codes",
       .methods = {{.name = "cut_of_a_cut",
                    .standing = Standing::taught,
                    .tell = tell<Way::cut_of_a_cut>,
                    .sizes = rounded,
                    .exact = true},
                   {.name = "correctly_rounded",
                    .standing = Standing::fast,
                    .tell = tell<Way::correctly_rounded>},
                   {.name = "codes_only",
                    .standing = Standing::faulty,
                    .tell = tell<Way::codes_only>,
                    .sizes = rounded},
                   {.name = "whole_or_nothing",
                    .standing = Standing::faulty,
                    .tell = tell<Way::whole_or_nothing>,
                    .sizes = rounded}},
       .columns = {{"cut"},
                   {"end", false},
                   {"border", false},
                   {"x"},
                   {"y"},
                   {.id = "code_a", .numeric = false, .quantity = "a"},
                   {.id = "code_b", .numeric = false, .quantity = "b"}},
       .counts = {"Cut"},
       .parameters =
           {window_view::line_parameter(), window_view::window_parameter(), window_view::order_parameter(),
            noted(&Notation::bits,
                  choice("code_bits", {"TBRL", "LRBT"}, "TBRL", "LRBT",
                         "which border each digit of a code stands for: T top, B bottom, R right, L left")),
            exact_parameter()},
       .examples = {"--line -3,-8,13,16 --window 0,0,10,10", "--window 0,0,10,10 --line -5,8,3,20",
                    "--line 5,5,-5,5 --method codes_only"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::cohen_sutherland_2d
