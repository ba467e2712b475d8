#pragma once
// One pixel, large: its fragments, which part of each lies before another, what is taken away, and the areas
// of what is seen.

#include "antialiasing/area_sampling/area_sampling_notes.hpp"
#include "stories/antialiasing/area_sampling/subject.hpp"
#include "stories/antialiasing/ring_cut.hpp"

namespace gradus::area_sampling {

/// Where things stand on the paper, y up.
inline constexpr Window pixel_paper{{0, 0}, {38, 26}};

class PixelStory {
 public:
  PixelStory(const Words& words, const InPixel& subject, std::vector<Fragment<Exact>> fragments, bool faulty)
      : words_(words), subject_(subject), faulty_(faulty) {
    for (const auto& f : fragments) {
      shown_.push_back({f.key, ring_of(f.outline), {to_double(f.nearest()), to_double(f.deepest())}});
      depths_.add({shown_.back().depths.x, 0});
      depths_.add({shown_.back().depths.y, 0});
    }
    std::ranges::sort(shown_, {}, [](const Shown& s) { return std::pair(s.depths.x, s.key); });
    visible_areas(std::span(fragments), [&](const auto& f, const auto& pieces, Exact) {
      for (const auto& piece : pieces) at_last_.push_back({f.key, ring_of(piece), ""});
    });
  }

  double covered() const { return covered_; }
  double grey() const { return grey_; }

  void show(Board& board, const steps::Started&) { board.milestone(at_hand()); }
  Event say(const steps::Started&) const {
    return {.text = "pixel.started",
            .words = {{"first", shown_.empty() ? "" : name(shown_.front().key)}},
            .count = std::ssize(shown_)};
  }

  void show(Board& board, const FragmentTaken<Exact>& f) {
    mine_ = f.fragment.key;
    left_ = {ring_of(f.fragment.outline)};
    board.milestone(at_hand());
  }
  Event say(const FragmentTaken<Exact>& f) const {
    return {.text = faulty_         ? "taken.faulty"
                    : seen_.empty() ? "taken.first"
                                    : "taken",
            .facts = {{"fragment", name(mine_)}, {"nearest", to_double(f.fragment.nearest())}},
            .words = {{"area", area_text(area_of(f.fragment.outline))}},
            .row = {name(mine_), to_double(f.fragment.nearest())},
            .key = name(mine_),
            .phase = name(mine_)};
  }

  void show(Board& board, const Compared<Exact>& c) {
    View view = at_hand();
    add_other(view, c.other, c.before, c.behind);
    board.milestone(std::move(view));
    board.tells(crosses(c) ? 3 : c.before.empty() ? 1 : 2);
  }
  Event say(const Compared<Exact>& c) const {
    const std::size_t answer = c.before.empty() ? 2 : c.behind.empty() ? 0 : 1;
    constexpr std::array<std::string_view, 3> texts{"before", "crosses", "behind"};
    return {.text = texts[answer],
            .facts = {{"fragment", name(mine_)},
                      {"other", name(c.other)},
                      {"before", to_double(area_of(c.before))}},
            .words = {{"part", area_text(area_of(c.before))}, {"rest", area_text(area_of(c.behind))}},
            .key = name(mine_),
            .phase = name(mine_),
            .decides =
                Decision{words_.say("question.before", {{"other", name(c.other)}, {"fragment", name(mine_)}}),
                         {words_.say("answer.all"), words_.say("answer.part"), words_.say("answer.none")},
                         answer,
                         std::string(texts[answer])}};
  }

  void show(Board& board, const Subtracted<Exact>& s) {
    if (s.before.empty()) return;
    const auto before = left_;
    left_.clear();
    for (const auto& piece : s.left) left_.push_back(ring_of(piece));
    View view = at_hand();
    add_hidden(view, before, s);
    if (!s.hides) return board.detail(std::move(view));
    board.milestone(std::move(view));
  }
  Event say(const Subtracted<Exact>& s) const {
    Event event{
        .text = !s.hides         ? "apart"
                : s.left.empty() ? "hidden"
                                 : "subtracted",
        .facts = {{"fragment", name(mine_)}, {"other", name(s.other)}, {"pieces", std::ssize(s.left)}},
        .words = {{"area", area_text(area_of(s.left))}},
        .key = name(mine_),
        .phase = name(mine_)};
    if (s.hides && !s.left.empty()) event.count = std::ssize(s.left);
    return event;
  }

  void show(Board& board, const Seen<Exact>& s) {
    const double area = to_double(s.area), share = area * brightness(mine_);
    covered_ += area;
    weights_.push_back(area);
    grey_ += share;
    for (const auto& piece : s.pieces) seen_.push_back({mine_, ring_of(piece), area_text(area_of(piece))});
    left_.clear();
    done_.push_back(mine_);
    board.milestone(at_hand());
    if (faulty_) board.tells(static_cast<double>(done_.size()));  // the last one
  }
  Event say(const Seen<Exact>& s) const {
    const double area = to_double(s.area), share = area * brightness(mine_);
    Event event{.text = faulty_            ? "seen.faulty"
                        : s.pieces.empty() ? "unseen"
                                           : "seen",
                .facts = {{"fragment", name(mine_)}, {"area", area}, {"share", share}},
                .words = {{"area", area_text(s.area)},
                          {"I", brightness(mine_)},
                          {"covered", covered_},
                          {"sum", grey_}},
                .read = {name(mine_), nearest(mine_), area_text(s.area), brightness(mine_), share},
                .key = name(mine_),
                .phase = name(mine_)};
    return event;
  }

  void show(Board& board, const AreasFinished<Exact>&) {
    mine_ = -1;
    board.milestone(at_hand());
  }
  Event say(const AreasFinished<Exact>& f) const {
    return {.text = faulty_ ? "pixel.finished.faulty" : "pixel.finished",
            .facts = {{"covered", to_double(f.covered)}, {"I", grey_}},
            .words = {{"covered", area_text(f.covered)}, {"rest", area_text(Exact(1) - f.covered)}},
            .ends = true};
  }

  /// A place of the pixel in the drawing.
  static dvec2 at(dvec2 p) { return {corner + side * p.x, corner + side * (1 - p.y)}; }

 private:
  struct Shown {
    int key;
    std::vector<dvec2> ring;
    dvec2 depths;
  };
  struct SeenPiece {
    int key;
    std::vector<dvec2> ring;
    std::string area;
  };
  static constexpr double side = 22, corner = 2;

  static std::vector<dvec2> at(const std::vector<dvec2>& ring) {
    return mapped(ring, [](dvec2 p) { return at(p); });
  }
  static dvec2 middle(const std::vector<dvec2>& ring) {
    dvec2 sum(0);
    double doubled = 0;
    for (std::size_t i = 2; i < ring.size(); ++i) {
      const double area = doubled_area(ring[0], ring[i - 1], ring[i]);
      sum += area * (ring[0] + ring[i - 1] + ring[i]);
      doubled += area;
    }
    return doubled > 0 ? sum / (3 * doubled) : ring.front();
  }

  /// The place in a ring, and in no other one where that can be, that is farthest from all lines; nothing
  /// where no text has room.
  static std::optional<dvec2> roomiest(const std::vector<dvec2>& ring,
                                       const std::vector<std::vector<dvec2>>& lines) {
    std::optional<dvec2> best;
    double most = 0.04;
    for (int k = 0; k < 29 * 29; ++k) {
      const dvec2 p = dvec2{k % 29 + 1, k / 29 + 1} / 30.0;
      if (!holds(ring, p)) continue;
      double off = 1;
      for (const auto& line : lines) {
        off = std::min(off, distance(p, line));
        if (line != ring && holds(line, p)) off = std::min(off, 0.05);
      }
      if (off > most + 1e-9) most = off, best = p;
    }
    return best;
  }
  static bool holds(const std::vector<dvec2>& ring, dvec2 p) {
    return std::ranges::none_of(
        sides_of(ring), [&](const auto& side) { return doubled_area(side.first, side.second, p) < 0; });
  }
  std::string name(int key) const { return subject_.names[static_cast<std::size_t>(key)]; }
  double brightness(int key) const { return subject_.grey[static_cast<std::size_t>(key)]; }
  double nearest(int key) const { return std::ranges::find(shown_, key, &Shown::key)->depths.x; }
  static bool crosses(const Compared<Exact>& c) { return !c.before.empty() && !c.behind.empty(); }

  // --- What is drawn

  /// The pixel, the depths in order, and the colour so far.
  View base() const {
    View view;
    view.add({"z pixel", Role::boundary, Path{at({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), true}});
    view.add({"l depth", Role::guide, Text{{31.5, 25}, words_.say("depth")}});
    for (std::size_t i = 0; i < shown_.size(); ++i) add_depths(view, i);
    add_weights(view);
    return view;
  }
  static void add_area(View& view, const std::string& id, Role role, const std::vector<dvec2>& ring,
                       int shade) {
    view.add({id, role, Area{{ring}, shade}});
    view.add({id + " border", role, Path{ring, true}});
  }
  Role role_of(int key) const {
    if (key == mine_) return Role::current;
    return std::ranges::find(done_, key) != done_.end() ? Role::accepted : Role::input;
  }
  void add_depths(View& view, std::size_t i) const {
    const Shown& s = shown_[i];
    const double spread = std::min(3.3, 10.0 / static_cast<double>(shown_.size()));
    const double y = 22.6 - spread * static_cast<double>(i);
    const auto [least, most] = std::pair(depths_.lower.x, std::max(depths_.upper.x, depths_.lower.x + 1e-9));
    const auto x = [&](double depth) { return 28 + 6.5 * (depth - least) / (most - least); };
    const std::string id = fmt::format("l {:02}", i);
    view.add({id + " name", role_of(s.key), Text{{26.4, y}, name(s.key)}});
    view.add({id + " bar", role_of(s.key), Stroke{{x(s.depths.x), y}, {x(s.depths.y), y}}});
    view.add({id + " end", role_of(s.key), Dot{{x(s.depths.x), y}}});
  }
  /// The areas seen so far on top of each other, beside the whole pixel's.
  void add_weights(View& view) const {
    if (done_.empty()) return;
    const double unit = std::min(8.0, 10.5 / covered_), left = 26, right = 28, foot = corner;
    double top = foot;
    for (std::size_t i = 0; i < done_.size(); ++i) {
      const double high = unit * weights_[i];
      const std::string id = fmt::format("w {:02}", i);
      add_area(view, id, Role::accepted, Extent{{left, top}, {right, top + high}}.corners(), 1);
      if (high > 1.3)
        view.add({id + " name", Role::accepted, Text{{(left + right) / 2, top + high / 2}, name(done_[i])}});
      top += high;
    }
    view.add({"x whole", Role::boundary, Stroke{{left - 0.7, foot + unit}, {right + 0.7, foot + unit}}});
    view.add(
        {"x whole name", Role::boundary, Text{{right + 1, foot + unit}, words_.say("whole"), Align::left}});
    for (int row = 3; row < 6; ++row) {
      for (int column = 30; column < 33; ++column)
        view.cells.insert_or_assign({row, column}, CellLook{Role::result, "", tone_of(grey_)});
    }
    view.add({"s swatch", Role::boundary, Path{{{29.5, 2.5}, {32.5, 2.5}, {32.5, 5.5}, {29.5, 5.5}}, true}});
    view.add(
        {"s value", Role::guide,
         Text{{29.4, 7.2}, fmt::format("{} = {}", words_.symbol("I"), figure_real(grey_)), Align::left}});
  }
  /// What waits, as it will be seen, is there from the start; over it what is seen already, and what is left
  /// of the fragment at hand.
  View at_hand() const {
    View view = base();
    for (const Shown& s : shown_) {
      if (s.key != mine_ && std::ranges::find(done_, s.key) == done_.end()) add_waiting(view, s);
    }
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      add_area(view, fmt::format("r {:02}", i), Role::accepted, at(seen_[i].ring), 1);
    }
    if (left_.empty()) add_areas(view);
    for (std::size_t i = 0; i < left_.size(); ++i) {
      add_area(view, fmt::format("x {:02}", i), Role::current, at(left_[i]), 2);
    }
    if (left_.size() == 1) {
      if (const auto place = roomiest(left_[0], mapped(shown_, &Shown::ring)))
        view.add({"n mine", Role::current, Text{at(*place), name(mine_)}});
    }
    return view;
  }
  /// Where nothing nearer hides it, and nothing that is told of lies on it.
  void add_waiting(View& view, const Shown& s) const {
    const std::string id = name(s.key);
    Ways sides = sides_of(s.ring);
    std::vector<Ring2> lines(left_);
    int number = 0;
    for (const SeenPiece& piece : at_last_) {
      lines.push_back(piece.ring);
      if (piece.key != s.key) {
        sides = outside_of(piece.ring, sides);
      } else {
        view.add(
            {fmt::format("a {} {:02}", id, number++), Role::input, Area{{at(piece.ring)}, 1 + s.key % 3}});
      }
    }
    for (const Ring2& ring : left_) sides = outside_of(ring, sides);
    for (const auto& [a, b] : sides)
      view.add(
          {fmt::format("o {} {:02}", id, number++), Role::input, Stroke{at(a), at(b), false, false, true}});
    for (const SeenPiece& piece : at_last_) {
      const auto place = piece.key == s.key ? roomiest(piece.ring, lines) : std::nullopt;
      if (place) return view.add({"n " + id, Role::input, Text{at(*place), id}});
    }
  }
  /// The areas of what is seen, each where there is room.
  void add_areas(View& view) const {
    const auto lines = mapped(seen_, &SeenPiece::ring);
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      const auto place = roomiest(seen_[i].ring, lines);
      if (!place) continue;
      view.add({fmt::format("r {:02} area", i), Role::accepted,
                Text{at(*place), fmt::format("{} {}", name(seen_[i].key), seen_[i].area)}});
    }
  }
  void add_other(View& view, int key, const Outline<Exact>& before, const Outline<Exact>& behind) const {
    const auto whole = std::ranges::find(shown_, key, &Shown::key);
    std::erase_if(view.marks, [&](const auto& mark) {
      return mark.first.starts_with("o " + name(key) + " ") || mark.first == "n " + name(key);
    });
    view.add({"v other", Role::candidate, Path{at(whole->ring), true}});
    if (!before.empty()) view.add({"u before", Role::candidate, Area{{at(ring_of(before))}, 2}});
    const std::vector<dvec2> part = before.empty() ? whole->ring : ring_of(before);
    std::vector<std::vector<dvec2>> lines{part};
    lines.insert(lines.end(), left_.begin(), left_.end());
    view.add({"w other", Role::candidate, Text{at(roomiest(part, lines).value_or(middle(part))), name(key)}});
    if (before.empty() || behind.empty()) return;
    // The line that both parts share
    std::vector<dvec2> shared;
    for (const auto& p : before) {
      if (std::ranges::find(behind, p) != behind.end()) shared.emplace_back(to_double(p.x), to_double(p.y));
    }
    if (shared.size() == 2) view.add({"y line", Role::measure, Stroke{at(shared[0]), at(shared[1])}});
  }
  /// What was taken away: what was left before, within the other one.
  void add_hidden(View& view, const std::vector<std::vector<dvec2>>& before,
                  const Subtracted<Exact>& s) const {
    const std::vector<dvec2> taken = ring_of(s.before);
    view.add({"v other", Role::candidate, Path{at(taken), true}});
    for (std::size_t i = 0; i < before.size(); ++i) {
      std::vector<dvec2> rest = before[i];
      for (const auto& [a, b] : sides_of(taken)) {
        rest = split(rest, 1e-12, [&](dvec2 p) { return doubled_area(a, b, p); }).inside;
      }
      if (rest.size() > 2) view.add({fmt::format("t {:02}", i), Role::rejected, Area{{at(rest)}}});
    }
    for (std::size_t i = 0; left_.size() > 1 && i < left_.size(); ++i) {
      view.add({fmt::format("x {:02} number", i), Role::current,
                Text{at(middle(left_[i])), figure_number(static_cast<std::int64_t>(i) + 1)}});
    }
  }

  const Words& words_;
  const InPixel& subject_;
  const bool faulty_;
  std::vector<Shown> shown_{};
  Extent depths_{};
  int mine_ = -1;
  std::vector<std::vector<dvec2>> left_{};
  double covered_ = 0, grey_ = 0;
  std::vector<SeenPiece> seen_{}, at_last_{};
  std::vector<int> done_{};
  std::vector<double> weights_{};
};

/// The triangles' corners, or the ends of their sides, as far as they are in the pixel.
inline void let_drag(Narrator& narrator, const InPixel& subject) {
  const std::vector<NamedFace> given = narrator.arguments().faces("triangles");
  narrator.handles("triangles", [&](dvec3 p) -> std::optional<dvec2> {
    // The corner that has been moved, from where it was put on the grid
    double least = std::numeric_limits<double>::max();
    std::optional<dvec2> place;
    for (std::size_t k = 0; k < given.size(); ++k) {
      Ring2 ring;
      for (const ivec2 corner : subject.triangles[k].corners) ring.push_back(in_pixels(dvec2(corner)));
      for (std::size_t i = 0; i < 3; ++i) {
        const dvec3 way = p - given[k].points[i];
        if (length_of(way) >= least) continue;
        least = length_of(way);
        place = grip({{0, 0}, {1, 1}}, ring, ring[i] + dvec2(way));
      }
    }
    return place ? std::optional(PixelStory::at(*place)) : std::nullopt;
  });
}

/// What is seen in the pixel 0,0.
template <bool faulty>
void tell_in_pixel(Narrator& narrator) {
  const ExactScope scope;
  const InPixel subject = in_pixel_of(narrator.arguments());
  std::vector<Fragment<Exact>> fragments;
  for (std::size_t k = 0; k < subject.triangles.size(); ++k) {
    if (auto f = fragment_in<Exact>(subject.triangles[k], {0, 0}, static_cast<int>(k)))
      fragments.push_back(*f);
  }
  if (fragments.empty()) refuse("triangles", "expected a triangle with a part in the pixel 0,0");
  narrator.paper(pixel_paper.upper.x, pixel_paper.upper.y);
  narrator.trace().subtitle = narrator.words().count("pixel.subtitle", std::ssize(fragments));
  narrator.trace().goal = narrator.words().say("pixel.goal");
  narrator.columns({{"fragment", false}, {"nearest"}, {"area"}, {"I"}, {"share"}});
  narrator.legend({{Role::input, "waiting"},
                   {Role::current, "at_hand"},
                   {Role::candidate, "nearer"},
                   {Role::rejected, "hidden"},
                   {Role::accepted, faulty ? "added" : "seen"},
                   {Role::measure, "equal"}});
  PixelStory story(narrator.words(), subject, fragments, faulty);
  let_drag(narrator, subject);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const auto drop = [](const auto&, const auto&, Exact) {};
  if constexpr (faulty)
    areas_without_visibility(std::span(fragments), drop, watch);
  else
    visible_areas(std::span(fragments), drop, watch);
  narrator.result({{"covered", story.covered()}, {"I", story.grey()}});
}

}  // namespace gradus::area_sampling
