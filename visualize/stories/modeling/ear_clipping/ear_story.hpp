#pragma once
// Corners that are tested, ears that are cut off.

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "stories/modeling/ear_clipping/drawing.hpp"
#include "stories/past.hpp"

namespace gradus::ear_clipping {

/// Which ear is cut, and what of it is tested.
enum class Choice : std::uint8_t { first, widest, convex, of_joined };

class EarStory : public Past<steps::Started, Tested, Cut, Finished> {
 public:
  /// ring: the numbers of the subject's points that the method's own numbers stand for.
  EarStory(const Words& words, const Subject& subject, const Drawing& drawing, std::vector<int> ring,
           Choice choice)
      : words_(words), subject_(subject), drawing_(drawing), ring_(std::move(ring)), choice_(choice) {
    for (int i = 0; i < std::ssize(ring_); ++i) left_.push_back(i);
  }

  template <class Step>
  void take(const Step& step) {
    Past::take(step);
    follow(step);
  }

  Event say(const steps::Started&) const {
    return {.text = subject_.turned ? "started.turned" : "started",
            .words = {{"corners", ring_.size()}},
            .level = Level::idea};
  }
  Event say(const Tested& t) const {
    const Kind kind = kind_of(t);
    const std::string triangle = names_of(named(t));
    const double angle = angle_at(at(t.before), at(t.corner), at(t.after));
    const auto in_it = blocker_of_ear(t);
    std::vector<std::string> answers;
    for (const char* branch : branches) answers.push_back(words_.say(fmt::format("is.{}", branch)));
    const std::string result = kind == blocked ? words_.say("holds", {{"blocker", name(*t.blocker)}})
                                               : answers[static_cast<std::size_t>(kind)];
    return {.text = choice_ == Choice::convex && kind == ear ? in_it ? "tested.holds" : "tested.convex"
                                                             : fmt::format("tested.{}", branches[kind]),
            .facts = {{"corner", name(t.corner)}, {"turn", std::int64_t{t.turn}}, {"ear", t.ear}},
            .words = {{"triangle", triangle},
                      {"before", name(t.before)},
                      {"after", name(t.after)},
                      {"blocker", in_it       ? name(*in_it)
                                  : t.blocker ? name(*t.blocker)
                                              : ""},
                      {"angle", degrees(angle)}},
            .row = {name(t.corner), triangle, result, kind == ear ? degrees(smallest(t)) : ""},
            .key = name(t.corner),
            .decides = Decision{words_.say("question", {{"corner", name(t.corner)}}), answers,
                                static_cast<std::size_t>(kind), branches[kind]}};
  }
  Event say(const Cut& c) const {
    const Triangle t = named(c.triangle);
    const Smallest smallest = smallest_in(subject_, t);
    Event event{
        .text = c.forced               ? "cut.forced"
                : c.left == 2          ? "cut.last"
                : choice_ == widest_of ? "cut.widest"
                                       : "cut",
        .facts = {{"corner", corner_name(t[1])},
                  {"before", corner_name(t[0])},
                  {"after", corner_name(t[2])},
                  {"triangle", names_of(sorted(t))},
                  {"left", std::int64_t{c.left}},
                  {"angle", smallest.angle}},
        .words = {{"triangle", names_of(t)}, {"size", degrees(smallest.angle)}, {"ears", ears_before_}},
        .row = {corner_name(t[1]), names_of(t), words_.say("is.cut"), degrees(smallest.angle)},
        .key = corner_name(t[1])};
    if (choice_ == Choice::of_joined) {
      event.phase = words_.say("phase.ears");
      event.row.clear();  // the table is that of the bridges
    }
    return event;
  }
  Event say(const Finished& f) const {
    const Smallest worst = worst_angle();
    Event event{.text = "finished",
                .facts = {{"triangles", std::int64_t{f.triangles}}, {"smallest", worst.angle}},
                .words = {{"corners", ring_.size()},
                          {"size", degrees(worst.angle)},
                          {"corner", corner_name(worst.triangle[1])}}};
    if (choice_ != Choice::convex) return event;
    const auto [area, sum] = areas();
    event.text = has_turned() ? "finished.wrong" : "finished.lucky";
    event.words.insert(event.words.end(), {{"sum", sum}, {"area", area}});
    return event;
  }

  /// A test that fails because of a corner that lies in the way; with holes their bridges tell more.
  double tells(const auto& step) const {
    using Step = std::decay_t<decltype(step)>;
    if constexpr (std::same_as<Step, Tested>) {
      if (choice_ == Choice::first) return step.blocker ? 3 : step.turn < 0 ? 2 : 1;
    }
    if constexpr (std::same_as<Step, Cut>)
      return choice_ == widest_of ? static_cast<double>(ears_before_) : 0;
    if constexpr (std::same_as<Step, Finished>) return choice_ == Choice::convex ? 4 : 0;
    return 0;
  }

  View draw() const {
    View view;
    drawing_.add_input(view);
    const auto& cuts = all<Cut>();
    const Cut* cut = now<Cut>();
    const bool done = now<Finished>() != nullptr, right = choice_ != Choice::convex;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      if (&cuts[i] == cut) continue;
      const Triangle t = named(cuts[i].triangle);
      const std::string id = fmt::format("c ear {:02}", i);
      if (!done)
        drawing_.add_cut_off(view, id, t);
      else if (turns_round(cuts[i]))
        drawing_.add_triangle(view, "d turned " + id, Role::rejected, t);
      else
        drawing_.add_result(view, id, t);
      if (done && right)
        drawing_.add_text(view, fmt::format("t number {:02}", i), Role::result, t, fmt::format("{}", i + 1));
    }
    const std::vector<int> left = mapped(left_, [this](int i) { return number(i); });
    if (!done && left.size() > 2) drawing_.add_ring(view, "d ring", Role::input, left);
    const Tested* tested = now<Tested>();
    if (cut) add_cut(view, *cut);
    if (tested) add_test(view, *tested);
    if (done && right) drawing_.add_angle(view, "u angle", worst_angle(), false);
    drawing_.add_names(view, [&](int i) {
      if (done) return Role::result;
      if (tested && i == number(tested->corner)) return Role::current;
      if (cut && i == number(cut->triangle[1])) return Role::current;
      if (tested && i == blocker_in(*tested)) return Role::rejected;
      return std::ranges::find(left, i) != left.end() ? Role::input : Role::past;
    });
    return view;
  }

 private:
  static constexpr Choice widest_of = Choice::widest;
  enum Kind : std::uint8_t { ear, blocked, reflex, straight };
  static constexpr std::array<const char*, 4> branches{"ear", "blocked", "reflex", "straight"};
  static Kind kind_of(const Tested& t) {
    return t.ear ? ear : t.blocker ? blocked : t.turn < 0 ? reflex : straight;
  }

  void follow(const auto&) {}
  void follow(const Tested& t) { known_.insert_or_assign(t.corner, t); }
  void follow(const Cut& c) {
    ears_before_ = std::ranges::count_if(known_, [](const auto& entry) { return entry.second.ear; });
    others_.clear();
    for (const auto& [corner, tested] : known_) {
      if (tested.ear && corner != c.triangle[1]) others_.push_back({tested.before, corner, tested.after});
    }
    known_.erase(c.triangle[1]);
    std::erase(left_, c.triangle[1]);
  }

  // Of the method's own numbers

  int number(int i) const { return ring_[static_cast<std::size_t>(i)]; }
  dvec2 at(int i) const { return subject_.at(number(i)); }
  std::string name(int i) const { return corner_name(number(i)); }
  Triangle named(const Triangle& t) const { return {number(t[0]), number(t[1]), number(t[2])}; }
  Triangle named(const Tested& t) const { return named(Triangle{t.before, t.corner, t.after}); }
  /// The corners in the order of their names: as answers are compared.
  static Triangle sorted(Triangle t) {
    std::ranges::sort(t);
    return t;
  }
  double smallest(const Tested& t) const { return smallest_in(subject_, named(t)).angle; }

  /// The number of the point that lies in a tested triangle, or -1.
  int blocker_in(const Tested& t) const {
    const auto in_it = t.blocker ? t.blocker : blocker_of_ear(t);
    return in_it ? number(*in_it) : -1;
  }
  /// What the faulty test has overlooked.
  std::optional<int> blocker_of_ear(const Tested& t) const {
    if (choice_ != Choice::convex || !t.ear) return std::nullopt;
    const dvec2 a = at(t.before), b = at(t.corner), c = at(t.after);
    for (const int i : left_) {
      const dvec2 p = at(i);
      if (p != a && p != b && p != c && orient2d(a, b, p) >= 0 && orient2d(b, c, p) >= 0 &&
          orient2d(c, a, p) >= 0)
        return i;
    }
    return std::nullopt;
  }
  bool turns_round(const Cut& c) const {
    return orient2d(at(c.triangle[0]), at(c.triangle[1]), at(c.triangle[2])) < 0;
  }
  bool has_turned() const {
    return std::ranges::any_of(all<Cut>(), [this](const Cut& c) { return turns_round(c); });
  }
  static double area_of(const std::vector<dvec2>& p) {
    double doubled = 0;
    for (std::size_t i = 2; i < p.size(); ++i) {
      const dvec2 a = p[i - 1] - p[0], b = p[i] - p[0];
      doubled += a.x * b.y - a.y * b.x;
    }
    return std::abs(doubled) / 2;
  }
  /// Of the polygon, and of all triangles.
  std::pair<double, double> areas() const {
    double sum = 0;
    for (const Cut& c : all<Cut>()) sum += area_of({at(c.triangle[0]), at(c.triangle[1]), at(c.triangle[2])});
    return {area_of(subject_.places(ring_)), sum};
  }
  Smallest worst_angle() const {
    Smallest worst{{}, 361};
    for (const Cut& c : all<Cut>()) {
      const Smallest smallest = smallest_in(subject_, named(c.triangle));
      if (smallest.angle < worst.angle) worst = smallest;
    }
    return worst;
  }

  void add_test(View& view, const Tested& t) const {
    const Triangle corners = named(t);
    const Role role = t.ear ? Role::accepted : Role::rejected;
    if (t.turn > 0)
      drawing_.add_triangle(view, "e tested", role, corners);
    else
      view.add({"e tested", role, Stroke{drawing_.at(corners[0]), drawing_.at(corners[2]), false, true}});
    view.add({"f sides", Role::current, Path{drawing_.at({corners[0], corners[1], corners[2]})}});
  }
  void add_cut(View& view, const Cut& c) const {
    const Triangle t = named(c.triangle);
    for (std::size_t i = 0; choice_ == widest_of && i < others_.size(); ++i) {
      const std::string id = fmt::format("e other {:02}", i);
      drawing_.add_triangle(view, id, Role::candidate, named(others_[i]));
      drawing_.add_angle(view, id + " angle", smallest_in(subject_, named(others_[i])), false);
    }
    drawing_.add_triangle(view, "f cut", Role::current, t);
    drawing_.add_angle(view, "g angle", smallest_in(subject_, t), true);
  }

  const Words& words_;
  const Subject& subject_;
  const Drawing& drawing_;
  const std::vector<int> ring_;
  const Choice choice_;
  std::vector<int> left_;         ///< as the method numbers them
  std::map<int, Tested> known_;   ///< of each corner that is left, its last test
  std::vector<Triangle> others_;  ///< ears that were not the one that is cut
  std::int64_t ears_before_ = 0;  ///< how many there were
};

}  // namespace gradus::ear_clipping
