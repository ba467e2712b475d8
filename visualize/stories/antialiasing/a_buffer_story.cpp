// The story of a pixel's fragments: what is told of a list, of a mask, of pictures.

#include "antialiasing/a_buffer/a_buffer.hpp"

#include "antialiasing/a_buffer/a_buffer_notes.hpp"
#include "stories/antialiasing/a_buffer/list_story.hpp"
#include "stories/antialiasing/a_buffer/mask_story.hpp"
#include "stories/antialiasing/a_buffer/pictures.hpp"
#include "stories/parameters.hpp"

namespace gradus::a_buffer {
namespace {

constexpr auto drop = [](const Fragment&, double) {};

/// A polygon as it was given, of no depth yet.
Piece piece_of(std::size_t i, const std::vector<dvec2>& ring) {
  Piece piece{std::string(1, static_cast<char>('A' + i)), ring, {}, {}};
  for (const dvec2 p : ring) piece.snapped.push_back(triangle_coverage::snap(p));
  return piece;
}

/// All polygons with their depths.
std::vector<Piece> pieces_of(const Arguments& given) {
  const auto rings = given.rings("polygons");
  const auto depths = given.tuples("depths");
  if (rings.size() > 6) refuse("polygons", "expected at most 6 polygons, found {}", rings.size());
  if (depths.size() != rings.size())
    refuse(given, {"depths", "polygons"},
           fmt::format("expected as many depths as polygons, found {} and {}", depths.size(), rings.size()));
  std::vector<Tuple> surfaces;
  if (given.has("surfaces")) surfaces = given.tuples("surfaces");
  if (!surfaces.empty() && surfaces.size() != rings.size())
    refuse("surfaces", "expected as many as polygons, {}, found {}", rings.size(), surfaces.size());
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    Piece piece = piece_of(i, rings[i]);
    piece.left = depths[i][0].value, piece.right = depths[i][1].value;
    const auto [near, far] = std::minmax(piece.left, piece.right);
    const double opacity = depths[i][2].value;
    if (!is_share(opacity)) refuse("depths", "expected an opacity from 0 to 1, found {}", opacity);
    const int number = static_cast<int>(i);
    const int surface = surfaces.empty() ? number : static_cast<int>(surfaces[i][0].value);
    piece.fragment = {mask_of(piece.snapped, ivec2(0)), near, far, opacity, surface, number};
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// The depths of planes at the sub-samples.
struct PlaneDepths {
  const std::vector<Piece>& pieces;

  auto operator()(const Fragment& f) const {
    return [&piece = pieces[static_cast<std::size_t>(f.source)]](int sample) {
      const double across = (sample % mask_columns + 0.5) / mask_columns;
      return piece.left + across * (piece.right - piece.left);
    };
  }
};

/// The areas of all, hidden or not.
double sum_of(const std::vector<Piece>& pieces) {
  double sum = 0;
  for (const Piece& piece : pieces) sum += area_of(piece.fragment.mask);
  return sum;
}

/// adds_up: whether the shares add up to no more than the pixel.
template <class Run>
void tell_list(Narrator& narrator, std::vector<Column> columns, Run run, bool adds_up = true) {
  const std::vector<Piece> pieces = pieces_of(narrator.arguments());
  std::vector<Fragment> list;
  narrator.paper(paper_width, paper_height);
  narrator.trace().grid.lines = 13;  // smaller, the dots of a mask would touch
  narrator.trace().subtitle = narrator.words().count("subtitle", std::ssize(pieces));
  narrator.columns(std::move(columns));
  narrator.legend({{Role::current, "now"},
                   {Role::accepted, "seen"},
                   {Role::rejected, "hidden"},
                   {Role::past, "covered"}});
  // As in the pixel
  narrator.trace().legend[1].sample = Sample::dot;
  narrator.trace().legend[2].sample = Sample::ring;
  narrator.trace().legend[3].sample = Sample::dot;
  ListStory story(narrator.words(), pieces, adds_up ? 1 : std::max(1.0, sum_of(pieces)));
  LargePixel::let_drag(narrator, pieces[0]);
  const auto watch = narrator.watcher(story);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    list.push_back(pieces[i].fragment);
    watch(Listed{i}, 0);
  }
  run(list, watch, pieces);
  narrator.telling(story.telling());
  narrator.result({{"covered", story.covered()}});
}

void tell_resolve(Narrator& narrator) {
  narrator.list("put_in_order");
  narrator.list_below("take");
  narrator.list_below("resolve");
  tell_list(narrator, {{"fragment", false}, {"z"}, {"mask", false}, {"visible", false}, {"weight"}, {"left"}},
            [](auto& list, const auto& watch, const auto& pieces) {
              resolve(list, drop, PlaneDepths{pieces}, watch);
            });
}
void tell_ranges(Narrator& narrator) {
  tell_list(narrator, {{"fragment", false}, {"z"}, {"mask", false}, {"visible", false}, {"weight"}, {"left"}},
            [](auto& list, const auto& watch, const auto&) { by_ranges(list, drop, watch); });
}
void tell_sum(Narrator& narrator) {
  tell_list(
      narrator, {{"fragment", false}, {"z"}, {"mask", false}, {"area"}, {"total"}},
      [](auto& list, const auto& watch, const auto&) { sum_of_areas(list, drop, watch); }, false);
}
void tell_divided(Narrator& narrator) {
  tell_list(narrator, {{"fragment", false}, {"z"}, {"mask", false}, {"visible", false}, {"area"}, {"total"}},
            [](auto& list, const auto& watch, const auto&) { divided_by_covered(list, drop, watch); });
}
void tell_mask(Narrator& narrator) {
  const Piece piece = piece_of(0, narrator.arguments().rings("polygons")[0]);
  if (piece.snapped.size() != 3)
    refuse("polygons", "expected a triangle first, found {} corners", piece.snapped.size());
  narrator.paper(paper_width, paper_height);
  narrator.subtitle("mask.subtitle", {{"name", piece.name}});
  narrator.columns({{"edge"}, {"inside", false}, {"mask", false}, {"bits"}});
  narrator.legend({{Role::current, "edge"}, {Role::candidate, "beyond"}, {Role::accepted, "in"}});
  MaskStory story(narrator.words(), piece);
  LargePixel::let_drag(narrator, piece);
  const auto watch = narrator.watcher(story);
  const auto& p = piece.snapped;
  const triangle_coverage::Triangle triangle{p[0], p[1], p[2]};
  if (triangle_coverage::doubled_area(triangle) == 0) refuse("polygons", "expected a triangle with an area");
  watch(steps::Started{}, 0);
  mask_of(edges_of(triangle), ivec2(0), watch);
  watch(steps::Finished{}, 0);
  narrator.telling(story.telling());
  narrator.result({{"bits", std::popcount(story.mask())}});
}

}  // namespace

const TopicEntry& entry();  // the catalogue asks for it by this name
const TopicEntry& entry() {
  using namespace parameters;
  Parameter polygons{"polygons", ParameterType::rings,
                     "-0.2,1.3 0.75,-0.3 -0.2,-0.3; 0.3,-0.2 1.2,0.5 1.2,1.2 -0.1,1.2; -1,-1 2,-1 2,2 -1,2",
                     "-1,-1 0.5,-1 0.5,2 -1,2; -1,-1 2,-1 2,2 -1,2",
                     "convex polygons over the pixel, which reaches from 0 to 1 with y down"};
  polygons.parts = xy;
  polygons.least = 3;
  polygons.most = 24;
  polygons.sizes = {1e-6, 100};
  static const TopicEntry topic = completed<entry>(
      {.name = "a_buffer",
       .chapter = "antialiasing",
       .aliases = {"abuffer", "carpenter", "coverage mask", "fragment list",
                   "order-independent transparency"},
       .summary = "lists of fragments with masks of bits, resolved front to back",
       .methods =
           {{.name = "resolve", .standing = Standing::taught, .tell = tell_resolve, .unread = {"columns"}},
            {.name = "mask_of", .tell = tell_mask, .unread = {"depths", "surfaces", "columns"}},
            {.name = "pictures",
             .tell = tell_pictures,
             .function = "a_buffer",
             .file = "a_buffer_picture.hpp",
             .unread = {"polygons", "depths", "surfaces"}},
            {.name = "by_ranges", .standing = Standing::faulty, .tell = tell_ranges, .unread = {"columns"}},
            {.name = "sum_of_areas",
             .standing = Standing::faulty,
             .tell = tell_sum,
             .unread = {"surfaces", "columns"}},
            {.name = "divided_by_covered",
             .standing = Standing::faulty,
             .tell = tell_divided,
             .unread = {"surfaces", "columns"}}},
       .default_method = "resolve",
       .columns = {{"fragment", false}, {"z"}, {"mask", false}, {"visible", false}, {"weight"}, {"left"}},
       .parameters =
           {polygons,
            points(1, 6, "depths", "0.2,0.3,1 0.4,0.5,1 0.8,0.9,1", "0.2,0.3,0.5 0.8,0.9,1",
                   "of each polygon: its depth at the left and at the right side of the pixel, and its "
                   "opacity from 0 to 1",
                   {"left", "right", "opacity"}, {1e-6, 1000}),
            points(1, 6, "surfaces", "", "1 1 2",
                   "of each polygon the number of its surface, whose parts become one; without them "
                   "each is one of its own",
                   {"surface"}, {0, 1000}),
            integer(8, 40, "columns", "28", "20", "how many pixels the pictures are wide and high")},
       .examples = {
           "--polygons '-1,-1 0.5,-1 0.5,2 -1,2; -1,-1 2,-1 2,2 -1,2' --depths '0.1,0.1,1 0.5,0.5,1'",
           "--depths '0.2,0.3,0.5 0.4,0.5,1 0.8,0.9,1'",
           "--polygons '-1,-1 0.5,-1 0.5,2 -1,2; 0.5,-1 2,-1 2,2 0.5,2' --depths '0.2,0.3,1 0.2,0.4,1' "
           "--surfaces '1 1'",
           "--method mask_of", "--method pictures"}});
  return topic;
}

}  // namespace gradus::a_buffer
