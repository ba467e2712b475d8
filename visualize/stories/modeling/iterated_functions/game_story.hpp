#pragma once
// One point at random: which map moves it where, and which pixels have been reached.

#include "stories/modeling/iterated_functions/pieces_story.hpp"

namespace gradus::iterated_functions {

/// How a game chooses maps.
enum class Choosing : std::uint8_t { by_area, equal_shares, low_bits };

template <class Plot, class Watch>
void play(Choosing how, const Subject& subject, const Game<double>& game, const Plot& plot,
          const Watch& watch) {
  const std::vector<double> shares = shares_by_area(subject.all());
  if (how == Choosing::by_area) chaos_game(subject.all(), shares, game, plot, watch);
  if (how == Choosing::equal_shares) equal_shares(subject.all(), shares, game, plot, watch);
  if (how == Choosing::low_bits) low_bits(subject.all(), shares, game, plot, watch);
}

class GameStory {
 public:
  GameStory(const Words& words, const Subject& subject, Choosing how, const Game<double>& game,
            const Panel& panel)
      : words_(words),
        subject_(subject),
        how_(how),
        game_(game),
        panel_(panel),
        pixels_(subject.attractor),
        at_(game.begin) {
    constexpr int most_levels = 16;
    level_ = subject.levels_of(game.points, most_levels);
    const Ring points = subject.points(level_);
    Pixels other(subject.attractor);
    for (const dvec2 p : points) other.plot(p);
    pieces_ = std::ssize(points);
    of_pieces_ = other.reached();
  }
  Whole reached() const { return pixels_.reached(); }

  void plot(dvec2 p) {
    const Whole before = pixels_.reached();
    pixels_.plot(p);
    if (pixels_.few() && pixels_.reached() > before) few_.push_back(p);
    if (++plotted_ == pieces_) of_as_many_ = pixels_.reached();
  }
  /// Keeps the way of the last moves, told or not.
  void note(const Moved<double>& m) {
    from_ = std::exchange(at_, m.to);
    way_.push_back(from_);
    if (way_.size() > 8) way_.erase(way_.begin());
  }
  /// Of thousands of moves the first ones, those where the points are ten times as many, and the last ones.
  bool tells_move(Whole move) const {
    const Whole k = move - game_.skip;
    const bool power = k == 1 || k == 10 || k == 100 || k == 1000 || k == 10'000 || k == 100'000;
    return power || move <= first_told || is_late(move) || (k > 0 && k <= 3);
  }

  void show(Board& board, const steps::Started&) {
    View view = begun();
    view.add_named("g begin", Role::input, panel_.at(game_.begin), "P");
    board.milestone(std::move(view));
  }
  Event say(const steps::Started&) const {
    return {.text = "game.started",
            .words = {{"begin", game_.begin}, {"skipped", game_.skip}, {"pixel", 0.5 * pixels_.pixel()}},
            .row = {0, "", game_.begin, 0}};
  }
  void show(Board& board, const Moved<double>& m) {
    // The last ways lie over one picture, so that not each of them brings its own
    if (!late_) picture_ = drawn();
    late_ = is_late(m.move);
    View view = picture_;
    add_way(view);
    view.add({"f move", Role::current, Stroke{panel_.at(from_), panel_.at(m.to), true}});
    view.add({"g from", Role::candidate, Dot{panel_.at(from_), true}});
    view.add_named("g to", Role::current, panel_.at(m.to), name_of_map(m.map));
    board.milestone(std::move(view));
    // Of the last moves the longest is seen best
    board.tells(late_ && how_ == Choosing::by_area ? length_between(panel_.at(from_), panel_.at(m.to)) : 0);
  }
  Event say(const Moved<double>& m) const {
    Event event{.text = m.plotted ? "moved" : "moved.skipped",
                .facts = {{"map", static_cast<std::int64_t>(m.map + 1)},
                          {"x", m.to.x},
                          {"y", m.to.y},
                          {"plotted", m.plotted}},
                .words = {{"name", name_of_map(m.map)},
                          {"from", from_},
                          {"to", m.to},
                          {"points", plotted_},
                          {"pixels", pixels_.reached()},
                          {"left", game_.skip - m.move}},
                .row = {m.move, name_of_map(m.map), m.to, pixels_.reached()},
                .key = figure_number(m.move),
                .phase = words_.say(m.plotted ? "phase.plotting" : "phase.skipping")};
    event.decides = m.plotted ? where_to(words_, subject_, m.map, from_)
                              : yes_or_no(words_, "question.plotted", {{"skipped", game_.skip}}, false,
                                          "plotted", "skipped");
    return event;
  }
  void show(Board& board, const GameFinished&) {
    board.milestone(drawn());
    board.tells(how_ == Choosing::by_area ? 0 : 1);
  }
  Event say(const GameFinished& f) const {
    Event event{.text = "game.finished",
                .facts = {{"moves", f.moves}, {"pixels", pixels_.reached()}},
                .words = {{"points", game_.points},
                          {"pieces", pieces_},
                          {"level", level_},
                          {"of_pieces", of_pieces_},
                          {"of_as_many", of_as_many_}},
                .ends = true};
    if (how_ == Choosing::by_area) return event;
    Pixels right(subject_.attractor);
    play(Choosing::by_area, subject_, game_, [&](dvec2 p) { right.plot(p); }, Unobserved{});
    event.text = how_ == Choosing::low_bits ? "game.finished.low_bits" : "game.finished.equal_shares";
    event.words.push_back({"right", right.reached()});
    return event;
  }

 private:
  static constexpr Whole first_told = 6, last_told = 8;

  bool is_late(Whole move) const {
    return game_.points > 2 * last_told && move > game_.skip + game_.points - last_told;
  }
  View begun() const {
    View view;
    add_frames(view, subject_, panel_);
    return view;
  }
  View drawn() const {
    View view = begun();
    if (!pixels_.few()) pixels_.add_to(view, panel_);
    for (Index k = 0; pixels_.few() && k < few_.size(); ++k)
      view.add({fmt::format("d reached {:02}", k), Role::past, Dot{panel_.at(few_[k])}});
    return view;
  }
  /// How the point has come to where it was moved from.
  void add_way(View& view) const {
    for (Index k = 0; k + 1 < way_.size(); ++k) {
      const std::string id = fmt::format("e way {}", k);
      view.add({id, Role::measure, Stroke{panel_.at(way_[k]), panel_.at(way_[k + 1]), false, false, true}});
      view.add({id + " from", Role::measure, Dot{panel_.at(way_[k])}});
    }
  }

  const Words& words_;
  const Subject& subject_;
  const Choosing how_;
  const Game<double> game_;
  const Panel& panel_;
  Pixels pixels_;
  int level_ = 0;
  Whole pieces_ = 0, of_pieces_ = 0, of_as_many_ = 0, plotted_ = 0;
  dvec2 from_{}, at_;  ///< before the last move, and behind it
  Ring way_, few_;
  View picture_;
  bool late_ = false;  ///< the picture is that of the last moves
};

}  // namespace gradus::iterated_functions
