#pragma once
// Pieces without bridges: the crossings of each border are joined in their order along it.

#include "stories/clipping/sutherland_hodgman/drawing.hpp"

namespace gradus::sutherland_hodgman {

class PiecesStory : public PlaneDrawing {
 public:
  using PlaneDrawing::PlaneDrawing;
  using PlaneDrawing::say;
  using PlaneDrawing::show;

  void show(Board& board, const RingTested<double>& t) {
    if (enter_border(t.border)) numbers_.clear();
    quiet();
    for (std::size_t i = 0; i < t.ring.size(); ++i) mark_side(t.ring[i], t.sides[i]);
    view_.add({"f ring", Role::current, Path{panel_.at(places(t.ring)), true}});
    put(board);
  }
  Event say(const RingTested<double>& t) const {
    const std::int64_t inside = std::ranges::count(t.sides, 1), outside = std::ranges::count(t.sides, -1);
    const std::size_t answer = outside == 0 ? 0 : inside > 0 ? 1 : 2;
    constexpr std::array<const char*, 3> branches{"inside", "cut", "outside"};
    const std::string border = border_in_words(t.border);
    return {.text = "ring_tested",
            .facts = {{"border", t.border}, {"inside", inside}},
            .words = {{"corners", t.ring.size()}, {"border", border}},
            .phase = phase_of(t.border),
            .decides = Decision{
                words_.say("question.ring", {{"border", border}}),
                {words_.say("side.inside"), words_.say("question.ring.both"), words_.say("side.outside")},
                answer,
                branches[answer]}};
  }

  void show(Board& board, const CrossingsOrdered<double>& o) {
    quiet();
    erase("e ");
    std::size_t number = 0;
    for (const BorderCrossing<double>& c : o.crossings) {
      const std::string id = fmt::format("g crossing {:03}", number++);
      numbers_[{c.chain, c.enters}] = number;
      view_.add_named(id, Role::current, panel_.at(c.vertex.at),
                      words_.say(c.enters ? "in" : "out", {{"number", number}}), !c.enters);
    }
    put(board);
  }
  Event say(const CrossingsOrdered<double>& o) const {
    const auto crossings = std::ssize(o.crossings);
    return {.text = crossings == 0 ? "ordered_none" : "ordered",
            .facts = {{"border", o.border}, {"crossings", crossings}},
            .words = {{"border", border_in_words(o.border)}},
            .phase = phase_of(o.border)};
  }

  void show(Board& board, const CrossingsJoined<double>& j) {
    quiet();
    const dvec2 a = panel_.at(j.leaves.vertex.at), b = panel_.at(j.enters.vertex.at);
    view_.add({"f join", Role::current, Stroke{a, b, true}});
    view_.add({fmt::format("d join {:03}", number_of(j.leaves)), Role::result, Stroke{a, b}});
    put(board);
  }
  Event say(const CrossingsJoined<double>& j) const {
    const std::int64_t from = number_of(j.leaves), to = number_of(j.enters);
    const std::string border = name_of_border(j.border);
    return {.text = "joined",
            .facts = {{"from", from, "crossing"}, {"to", to, "crossing"}},
            .words = {{"border", border_in_words(j.border)}},
            .row = {border, from, to},
            .phase = phase_of(j.border)};
  }

  void show(Board& board, const BorderSplit<double>& s) {
    quiet();
    erase("g ");
    pass_border(s.rings);
    put(board);
    leave_border();
  }
  Event say(const BorderSplit<double>& s) const {
    const auto rings = std::ssize(s.rings);
    const std::string border = name_of_border(s.border);
    return {.text = "split",
            .facts = {{"border", s.border}, {"rings", rings}},
            .words = {{"border", border_in_words(s.border)}},
            .count = rings,
            .row = {border, "", "", rings},
            .phase = phase_of(s.border),
            .level = Level::idea,
            .decides = yes_or_no(words_, "question.left", {}, rings > 0, "accepted", "rejected")};
  }

  void show(Board& board, const PieceTraced<double>& p) {
    if (p.number == 0) {
      erase("c ");
      erase("d ");
    }
    quiet();
    std::vector<Points> rings{panel_.at(places(p.piece.outline))};
    for (const auto& hole : p.piece.holes) rings.push_back(panel_.at(places(hole)));
    const std::string id = fmt::format("h piece {:03}", p.number);
    view_.add({id, Role::result, Area{rings}});
    for (std::size_t i = 0; i < rings.size(); ++i) {
      view_.add({fmt::format("{} line {}", id, i), Role::result, Path{rings[i], true}});
    }
    for (std::size_t i = 0; i < rings[0].size(); ++i) {
      view_.add({fmt::format("{} dot {:03}", id, i), Role::result, Dot{rings[0][i]}});
    }
    view_.add({"f outline", Role::current, Path{rings[0], true}});
    put(board);
    total_ += area_of(p.piece);
    ++traced_;
  }
  Event say(const PieceTraced<double>& p) const {
    return {.text = "piece",
            .facts = {{"piece", static_cast<std::int64_t>(p.number)}, {"area", area_of(p.piece)}},
            .words = {{"number", p.number + 1}, {"corners", p.piece.outline.size()}},
            .phase = words_.shared("words", "result")};
  }

  void show(Board& board, const steps::Finished&) {
    quiet();
    put(board);
  }
  Event say(const steps::Finished&) const {
    if (traced_ == 0) return {.text = "nothing"};
    return {.text = "done_pieces", .words = {{"area", total_}}, .count = traced_};
  }

 private:
  /// Along its border, from 1 on.
  std::int64_t number_of(const BorderCrossing<double>& c) const {
    return static_cast<std::int64_t>(numbers_.at({c.chain, c.enters}));
  }

  std::map<std::pair<std::size_t, bool>, std::size_t> numbers_;
  std::int64_t traced_ = 0;
  double total_ = 0;
};

}  // namespace gradus::sutherland_hodgman
