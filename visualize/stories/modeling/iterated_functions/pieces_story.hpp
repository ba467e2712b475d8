#pragma once
// Piece by piece: which map takes it where, and how near a level is to the attractor.

#include "stories/modeling/iterated_functions/subject.hpp"

namespace gradus::iterated_functions {

/// Where each map takes a point; nothing where two of them take it to one place, as it is written.
inline std::optional<Decision> where_to(const Words& words, const Subject& subject, Index map, dvec2 from) {
  std::vector<std::string> answers;
  for (const DMap& f : subject.maps) {
    const std::string place = figure_place(f(from));
    if (std::ranges::find(answers, place) != answers.end()) return std::nullopt;
    answers.push_back(place);
  }
  if (answers.size() < 2) return std::nullopt;
  return Decision{words.say("question.where", {{"map", name_of_map(map)}, {"from", from}}), answers, map,
                  map == 0 ? "first map" : "later map"};
}

/// The levels of a shape, complete.
struct Levels {
  Ring shape;
  int last;
  std::vector<DPieces> pieces;
  double reach;  ///< how far the shape is at most from the attractor
  Extent shown;

  /// More images of a level than these are not told one by one.
  static constexpr Index most_told = 64;
  bool tells(int level) const { return pieces[static_cast<Index>(level)].size() <= most_told; }
  int last_told() const {
    int level = last;
    while (level > 1 && !tells(level)) --level;
    return level;
  }
};

inline Levels levels_of(const Arguments& arguments, const Subject& subject) {
  constexpr Whole most = 1024;
  const int last = static_cast<int>(arguments.integer("level"));
  if (const int fit = subject.levels_of(most, last); fit < last)
    refuse("level", "expected at most {} levels of {} maps, so that {} pieces are drawn", fit,
           subject.maps.size(), most);
  Levels levels{arguments.points("shape"), last, {}, 0, with_frames(subject)};
  levels.reach = reach<double>(subject.all(), levels.shape, subject.c);
  for (int n = 0; n <= last; ++n) {
    levels.pieces.push_back(deterministic(subject.all(), n));
    for (const DMap& p : levels.pieces.back())
      for (const dvec2 corner : placed(p, levels.shape)) levels.shown.add(corner);
  }
  return levels;
}

class PiecesStory : public Past<steps::Started, Mapped<double>, LevelDone, Finished> {
 public:
  PiecesStory(const Words& words, const Subject& subject, const Levels& levels, const Panel& panel)
      : words_(words), subject_(subject), levels_(levels), panel_(panel) {}

  Event say(const steps::Started&) const {
    return {.text = "started",
            .words = {{"maps", std::ssize(subject_.maps)}, {"c", subject_.c}, {"within", levels_.reach}},
            .row = {0, 1, 1, levels_.reach}};
  }
  Event say(const Mapped<double>& m) const {
    const dvec2 corner = levels_.shape[0], from = m.from(corner), to = m.image(corner);
    return {.text = "mapped",
            .facts = {{"level", m.level},
                      {"piece", static_cast<std::int64_t>(m.piece + 1)},
                      {"map", static_cast<std::int64_t>(m.map + 1)},
                      {"x", to.x},
                      {"y", to.y}},
            .words = {{"name", name_of_map(m.map)}, {"before", m.level - 1}, {"from", from}, {"to", to}},
            .key = fmt::format("{}.{}.{}", m.level, m.piece + 1, m.map + 1),
            .phase = phase(m.level),
            .decides = where_to(words_, subject_, m.map, from)};
  }
  Event say(const LevelDone& d) const {
    const double within = d.largest * levels_.reach;
    return {.text = d.level == 1 ? "level_done.first" : "level_done",
            .facts = {{"level", d.level}, {"pieces", d.pieces}, {"largest", d.largest}, {"within", within}},
            .words = {{"before", static_cast<std::int64_t>(of_level(d.level - 1).size())},
                      {"maps", std::ssize(subject_.maps)}},
            .note = words_.say("note.pieces", {{"pieces", d.pieces}}),
            .row = {d.level, d.pieces, d.largest, within},
            .key = fmt::format("{}", d.level),
            .phase = phase(d.level)};
  }
  Event say(const Finished& f) const {
    const LevelDone* d = last<LevelDone>();
    return {.text = "finished",
            .facts = {{"pieces", f.pieces}},
            .words = {{"levels", levels_.last}, {"within", (d ? d->largest : 1) * levels_.reach}}};
  }

  /// An image of the last level that is told, where about half of them are there.
  double tells(const auto& step) const {
    if constexpr (std::same_as<std::decay_t<decltype(step)>, Mapped<double>>) {
      const bool half = step.piece == of_level(step.level - 1).size() / 2;
      return step.level == levels_.last_told() && half && step.map + 1 == subject_.maps.size() ? 1 : 0;
    }
    return 0;
  }

  View draw() const {
    View view;
    add_frames(view, subject_, panel_);
    if (const auto* m = now<Mapped<double>>()) {
      add_level(view, "c", Role::past, of_level(m->level - 1));
      const DPieces& all = of_level(m->level);
      const Index done = m->piece * subject_.maps.size() + m->map;
      add_level(view, "d", Role::accepted, std::span(all).first(done));
      add_image(view, *m);
      return view;
    }
    const LevelDone* d = last<LevelDone>();
    add_level(view, "d", d ? Role::result : Role::input, of_level(d ? d->level : 0));
    if (!d) view.add_named("g corner", Role::input, panel_.at(levels_.shape[0]), "A");
    return view;
  }

 private:
  const DPieces& of_level(int level) const { return levels_.pieces[static_cast<Index>(level)]; }
  std::string phase(int level) const { return words_.say("phase.level", {{"level", level}}); }

  void add_piece(View& view, const std::string& id, Role role, const DMap& piece) const {
    const Ring ring = panel_.at(placed(piece, levels_.shape));
    view.add({id, role, Area{{ring}}});
    view.add({id + " outline", role, Path{ring, true}});
  }
  void add_level(View& view, const std::string& id, Role role, std::span<const DMap> pieces) const {
    for (Index k = 0; k < pieces.size(); ++k)
      add_piece(view, fmt::format("{} piece {:04}", id, k), role, pieces[k]);
  }
  /// The piece at hand, its image, and how its corner A goes there.
  void add_image(View& view, const Mapped<double>& m) const {
    const dvec2 corner = levels_.shape[0], from = panel_.at(m.from(corner)), to = panel_.at(m.image(corner));
    view.add({"e piece", Role::candidate, Path{panel_.at(placed(m.from, levels_.shape)), true}});
    add_piece(view, "e image", Role::current, m.image);
    if (from != to) view.add({"f way", Role::measure, Stroke{from, to, true}});
    view.add_named("g from", Role::candidate, from, "A");
    view.add_named("g to", Role::current, to, name_of_map(m.map) + "(A)");
  }

  const Words& words_;
  const Subject& subject_;
  const Levels& levels_;
  const Panel& panel_;
};

}  // namespace gradus::iterated_functions
