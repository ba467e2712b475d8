// The story of iterated functions: all pieces level by level, one point at random, and the dimension of what
// both come to.

#include "modeling/iterated_functions/iterated_functions.hpp"

#include "stories/modeling/iterated_functions/checking.hpp"
#include "stories/modeling/iterated_functions/dimension_story.hpp"
#include "stories/modeling/iterated_functions/game_story.hpp"
#include "stories/modeling/iterated_functions/pieces_story.hpp"
#include "stories/parameters.hpp"
#include "stories/some_steps.hpp"

namespace gradus::iterated_functions {
namespace {

constexpr Extent whole_paper{{1.5, 1.5}, {34.5, 25.5}};

void set_up(Narrator& narrator, const Subject& subject) {
  narrator.paper(paper_width, paper_height);
  const bool own = !narrator.arguments().tuples("maps").empty();
  narrator.subtitle(own ? std::string("subtitle.own") : "subtitle." + narrator.arguments().text("system"),
                    {{"maps", std::ssize(subject.maps)}});
}

// --- All pieces

void tell_pieces(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  const Levels levels = levels_of(narrator.arguments(), subject);
  const Panel panel(whole_paper, levels.shown);
  require_scale(panel, narrator.arguments(), {"maps", "shape"});
  set_up(narrator, subject);
  narrator.columns({{"level"}, {"pieces"}, {"largest"}, {"within"}});
  narrator.legend({{Role::input, "shape"},
                   {Role::boundary, "frames"},
                   {Role::past, "before"},
                   {Role::candidate, "piece"},
                   {Role::measure, "way"},
                   {Role::current, "image"},
                   {Role::accepted, "so_far"},
                   {Role::result, "after"}});
  narrator.handles("shape", shown_in(panel));
  PiecesStory story(narrator.words(), subject, levels, panel);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const auto tells = [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Mapped<double>>) return levels.tells(step.level);
    return true;
  };
  const DPieces pieces = deterministic(subject.all(), levels.last, some_steps(watch, tells));
  narrator.result({{"pieces", std::ssize(pieces)}, {"within", largest_stretch(pieces) * levels.reach}});
}

// --- One point

Game<double> game_of(const Arguments& arguments, const Subject& subject) {
  Game<double> game{arguments.points("begin")[0], 0, arguments.integer("points"),
                    static_cast<std::uint64_t>(arguments.integer("seed"))};
  constexpr double most_moves = 2000;
  const double far = reach<double>(subject.all(), std::array{game.begin}, subject.c);
  const double near = 0.5 * Pixels(subject.attractor).pixel();
  if (!(far * gradus::pow(subject.c, most_moves) <= near))
    refuse("maps", "expected maps that bring a point near within {} moves, not by {} a move", most_moves,
           subject.c);
  game.skip = moves_until(near, far, subject.c);
  return game;
}

template <Choosing how>
void tell_game(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  const Game<double> game = game_of(narrator.arguments(), subject);
  Extent extent = with_frames(subject);
  extent.add(game.begin);
  const auto reaches = [&](const auto& step) {
    if constexpr (std::same_as<std::decay_t<decltype(step)>, Moved<double>>) extent.add(step.to);
  };
  play(how, subject, game, [](dvec2) {}, reaches);
  const Panel panel(whole_paper, extent);
  require_scale(panel, narrator.arguments(), {"maps", "begin"});
  set_up(narrator, subject);
  narrator.columns({{"move"}, {"map", false}, {"point", false}, {"pixels"}});
  narrator.legend({{Role::input, "begin"},
                   {Role::boundary, "frames"},
                   {Role::past, "reached"},
                   {Role::measure, "moves"},
                   {Role::candidate, "from"},
                   {Role::current, "move"}});
  narrator.handles("begin", shown_in(panel));
  GameStory story(narrator.words(), subject, how, game, panel);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const auto tells = [&]<class Step>(const Step& step) {
    if constexpr (std::same_as<Step, Moved<double>>) {
      story.note(step);
      return story.tells_move(step.move);
    }
    return true;
  };
  play(how, subject, game, [&](dvec2 p) { story.plot(p); }, some_steps(watch, tells));
  narrator.result({{"pixels", story.reached()}, {"skipped", game.skip}});
}

// --- Dimension

void tell_dimension(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  std::vector<double> ratios;
  for (const DMap& f : subject.maps) ratios.push_back(std::min(stretch(f), 1 - 0x1p-53));
  set_up(narrator, subject);
  narrator.columns({{"s"}, {"sum"}, {"low"}, {"high"}});
  narrator.legend({{Role::input, "sum"},
                   {Role::boundary, "one"},
                   {Role::candidate, "between"},
                   {Role::current, "tried"},
                   {Role::result, "dimension"}});
  DimensionStory story(narrator.words(), subject, ratios);
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  const int halvings = static_cast<int>(narrator.arguments().integer("halvings"));
  narrator.result({{"dimension", similarity_dimension(ratios, halvings, watch)}});
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  const Names of_game{"level", "shape", "halvings"}, all_numbers{"a", "b", "c", "d", "e", "f"};
  static const TopicEntry topic = completed<entry>(
      {.name = "iterated_functions",
       .chapter = "modeling",
       .aliases = {"ifs", "chaos game", "barnsley fern", "sierpinski", "hutchinson operator",
                   "collage theorem"},
       .summary = "maps that contract, applied again and again: all pieces, a point at random, the dimension",
       .methods = {{.name = "deterministic",
                    .standing = Standing::taught,
                    .tell = tell_pieces,
                    .unread = {"begin", "points", "seed", "halvings"}},
                   {.name = "chaos_game",
                    .tell = tell_game<Choosing::by_area>,
                    .unread = of_game,
                    .opening = {{"system", "fern"}}},
                   {.name = "dimension",
                    .tell = tell_dimension,
                    .function = "similarity_dimension",
                    .file = "similarity_dimension.hpp",
                    .unread = {"level", "shape", "begin", "points", "seed"}},
                   {.name = "equal_shares",
                    .standing = Standing::faulty,
                    .tell = tell_game<Choosing::equal_shares>,
                    .unread = of_game,
                    .opening = {{"system", "fern"}}},
                   {.name = "low_bits",
                    .standing = Standing::faulty,
                    .tell = tell_game<Choosing::low_bits>,
                    .unread = of_game,
                    .opening = {{"system", "dragon"}}}},
       .parameters = {choice("system", {"sierpinski", "carpet", "koch", "dragon", "fern"}, "sierpinski",
                             "fern", "a known system of maps"),
                      instead_of("system",
                                 points(1, 8, "maps", "", "0.5,0,0,0.5,0,0 0.5,0,0,0.5,0.5,0",
                                        "maps of one's own: (x, y) goes to (ax + by + e, cx + dy + f)",
                                        all_numbers, {1e-6, 1e6})),
                      integer(1, 10, "level", "3", "2", "how often all maps are applied to all pieces"),
                      points(
                          3, 12, "shape",
                          "0.2,0 0.4,0 0.4,0.35 0.65,0.35 0.65,0.5 0.4,0.5 0.4,0.65 0.8,0.65 0.8,0.8 0.2,0.8",
                          "0,0 1,0 0.5,1", "the corners of the first shape", xy, {1e-6, 1e6}),
                      points(1, 1, "begin", "0.3,0.3", "1,1", "where the point begins", xy, {1e-6, 1e6}),
                      integer(10, 100'000, "points", "10000", "1000", "how many points are plotted"),
                      integer(0, 1'000'000, "seed", "1", "7", "which random numbers"),
                      integer(1, 40, "halvings", "8", "12", "how often the interval is halved")},
       .examples = {"--system dragon --level 8", "--method chaos_game --system fern",
                    "--method dimension --system koch"},
       .checking = &checking()});
  return topic;
}

}  // namespace gradus::iterated_functions
