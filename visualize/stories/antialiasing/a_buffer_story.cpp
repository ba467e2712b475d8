// The story of a pixel's fragments: their masks as bits, front to back, what of each is still seen, and its
// weight in the pixel's colour.

#include "antialiasing/a_buffer/a_buffer.hpp"

#include "antialiasing/a_buffer/a_buffer_notes.hpp"
#include "stories/antialiasing/a_buffer/drawing.hpp"
#include "stories/antialiasing/a_buffer/mask_story.hpp"
#include "stories/antialiasing/a_buffer/pictures.hpp"
#include "stories/parameters.hpp"

namespace gradus::a_buffer {
namespace {

constexpr auto drop = [](const Fragment&, double) {};

/// A polygon's fragment goes into the list.
struct Listed {
  std::size_t number;
};

/// What all stories of a list show.
class ListStory {
 public:
  ListStory(const Words& words, std::vector<Piece> pieces) : words_(words), pieces_(std::move(pieces)) {}

  double covered() const { return covered_; }
  StepNumber telling() const { return {telling_, 0}; }

  void show(Board& board, const Listed& l) {
    list_.push_back(pieces_[l.number].fragment);
    at_ = list_.size() - 1;
    covered_mask_ = 0;
    visible_ = list_.back().mask;
    put(board);
  }
  Event say(const Listed& l) const {
    const Piece& piece = pieces_[l.number];
    return {.text = "listed",
            .facts = {{"mask", hex_of(piece.fragment.mask)}, {"bits", std::popcount(piece.fragment.mask)}},
            .words = {{"name", piece.name}, {"bytes", std::ssize(list_) * std::int64_t{sizeof(Mask)}}},
            .count = std::popcount(piece.fragment.mask),
            .key = piece.name,
            .phase = words_.say("phase.listed"),
            .begins = false};
  }

  void show(Board& board, const Sorted& s) {
    list_ = s.list;
    at_.reset();
    visible_ = covered_mask_ = 0;
    put(board);
  }
  Event say(const Sorted& s) const {
    std::string order;
    for (const Fragment& f : s.list) order += (order.empty() ? "" : ", ") + name_of(f);
    return {.text = "sorted",
            .facts = {{"fragments", std::ssize(s.list)}},
            .words = {{"order", order}},
            .count = std::ssize(s.list)};
  }
  void show(Board& board, const Ordered& o) {
    const bool compared = any_overlap(list_);
    list_ = o.list;
    at_.reset();
    if (compared) put(board);
  }
  Event say(const Ordered& o) const {
    std::string order;
    for (const Fragment& f : o.list) order += (order.empty() ? "" : ", ") + name_of(f);
    Event event{.text = o.parts > 0 ? "ordered.parted" : "ordered",
                .facts = {{"fragments", std::ssize(o.list)}, {"parts", static_cast<std::int64_t>(o.parts)}},
                .words = {{"order", order}}};
    if (o.parts > 0) event.count = static_cast<std::int64_t>(o.parts);
    return event;
  }
  void show(Board& board, const Merged& m) {
    merged_ = list_.size() - m.list.size();
    const auto grown = std::ranges::mismatch(list_, m.list, {}, &Fragment::mask, &Fragment::mask).in2;
    list_ = m.list;
    if (merged_ == 0) return;
    at_ = static_cast<std::size_t>(grown - m.list.begin());
    visible_ = list_[*at_].mask;
    put(board);
  }
  Event say(const Merged&) const {
    return {.text = "merged",
            .facts = {{"fragments", std::ssize(list_)}},
            .count = static_cast<std::int64_t>(merged_)};
  }
  void show(Board& board, const Masked& m) {
    at_ = m.number;
    covered_mask_ = m.covered;
    visible_ = m.visible;
    masked_ = true;
    put(board);
    // What is hidden in part tells most
    const bool part = m.visible != m.fragment.mask && m.visible != 0;
    if (telling_ == 0 || (part && !told_)) telling_ = milestones_;
    told_ |= part;
  }
  Event say(const Masked& m) const {
    Event event{.text = m.visible == 0                 ? "masked.hidden"
                        : m.visible == m.fragment.mask ? "masked.whole"
                                                       : "masked",
                .facts = {{"mask", hex_of(m.fragment.mask)},
                          {"covered", hex_of(m.covered)},
                          {"visible", hex_of(m.visible)}},
                .words = {{"name", name_of(m.fragment)},
                          {"hidden", std::popcount(m.fragment.mask & m.covered)},
                          {"bits", std::popcount(m.fragment.mask)}},
                .row = {name_of(m.fragment), m.fragment.z_near, hex_of(m.fragment.mask), hex_of(m.visible)},
                .key = name_of(m.fragment)};
    if (m.visible != 0) event.count = std::popcount(m.visible);
    event.decides =
        yes_or_no(words_, "question", {{"name", name_of(m.fragment)}}, m.visible != 0, "seen", "hidden");
    return event;
  }
  void show(Board& board, const Weighed& w) {
    weights_.emplace_back(name_of(w.fragment), w.weight);
    covered_mask_ = w.covered;
    put(board);
  }
  Event say(const Weighed& w) const {
    return {.text = w.fragment.opacity == 1 ? "weighed" : "weighed.through",
            .facts = {{"weight", w.weight}, {"left", w.left}},
            .words = {{"name", name_of(w.fragment)},
                      {"opacity", w.fragment.opacity},
                      {"bits", std::popcount(w.visible)}},
            .read = {name_of(w.fragment), w.fragment.z_near, hex_of(w.fragment.mask), hex_of(w.visible),
                     w.weight, w.left},
            .key = name_of(w.fragment)};
  }
  void show(Board& board, const Finished& f) {
    at_.reset();
    visible_ = 0;
    left_ = f.left;
    covered_ = 1 - f.left;
    finished_ = true;
    put(board);
  }
  Event say(const Finished& f) const {
    std::string shares;
    for (const auto& [name, weight] : weights_) {
      if (weight > 0) shares += fmt::format("{}{} {}", shares.empty() ? "" : ", ", name, figure_real(weight));
    }
    Event event{.text = f.used < f.listed ? "finished.full" : "finished",
                .facts = {{"used", static_cast<std::int64_t>(f.used)},
                          {"listed", static_cast<std::int64_t>(f.listed)},
                          {"left", f.left}},
                .words = {{"shares", shares}, {"unused", f.listed - f.used}}};
    if (shares.empty()) event.text = "finished.empty";
    return event;
  }

  // The exhibits

  void show(Board& board, const Estimated& e) {
    weights_.emplace_back(name_of(e.fragment), e.weight);
    covered_mask_ = e.covered;
    put(board);
    if (e.crossed.front < 1) telling_ = milestones_;
  }
  Event say(const Estimated& e) const {
    return {.text = e.crossed.front < 1 ? "estimated" : "weighed",
            .facts = {{"weight", e.weight}, {"left", e.left}},
            .words = {{"name", name_of(e.fragment)},
                      {"share", e.crossed.front},
                      {"bits", std::popcount(e.visible)}},
            .read = {name_of(e.fragment), e.fragment.z_near, hex_of(e.fragment.mask), hex_of(e.visible),
                     e.weight, e.left},
            .key = name_of(e.fragment)};
  }
  void show(Board& board, const Summed& s) {
    if (s.number < list_.size()) at_ = s.number;
    weights_.emplace_back(name_of(s.fragment), s.area);
    total_ = s.total;
    if (!masked_) visible_ = s.fragment.mask;
    put(board);
    telling_ = milestones_;
  }
  Event say(const Summed& s) const {
    const std::string& name = name_of(s.fragment);
    const std::string mask = hex_of(s.fragment.mask);
    Event event{.text = masked_ ? "summed.seen" : "summed",
                .facts = {{"area", s.area}, {"total", s.total}},
                .words = {{"name", name}},
                .key = name};
    if (masked_)
      event.read = {name, s.fragment.z_near, mask, hex_of(visible_), s.area, s.total};
    else
      event.row = {name, s.fragment.z_near, mask, s.area, s.total};
    return event;
  }
  void show(Board& board, const Divided& d) {
    at_.reset();
    finished_ = true;
    left_ = 0;
    if (d.total > 0) {
      for (auto& [name, weight] : weights_) weight /= d.total;
    }
    put(board);
    telling_ = milestones_;
  }
  Event say(const Divided& d) const {
    const double total = d.total;
    std::string shares;
    for (const auto& [name, weight] : weights_)
      shares += fmt::format("{}{} {}", shares.empty() ? "" : ", ", name, figure_real(weight));
    return {.text = total > 1 ? "divided.hidden" : "divided",
            .facts = {{"total", total}},
            .words = {{"shares", shares}},
            .ends = true,
            .decides = yes_or_no(words_, "question.divided", {}, total == 1, "whole", "divided")};
  }

 private:
  const std::string& name_of(const Fragment& f) const {
    return pieces_[static_cast<std::size_t>(f.source)].name;
  }

  /// Whether two of them overlap in depth where both are.
  static bool any_overlap(const std::vector<Fragment>& list) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      for (std::size_t k = i + 1; k < list.size(); ++k)
        if ((list[i].mask & list[k].mask) != 0 && list[k].z_near <= list[i].z_far) return true;
    }
    return false;
  }

  /// Whether a fragment is another one, or has been merged into it.
  static bool is_part(const Fragment& part, const Fragment& whole) {
    return part.source == whole.source ||
           (part.surface == whole.surface && (part.mask & ~whole.mask) == 0 && part.mask != 0);
  }
  void put(Board& board) {
    ++milestones_;
    View view;
    LargePixel::add_grid(view);
    for (const Piece& piece : pieces_) {
      const bool now = at_ && is_part(piece.fragment, list_[*at_]);
      const auto has = [&](const Fragment& f) { return is_part(piece.fragment, f); };
      if (std::ranges::any_of(list_, has))
        LargePixel::add_polygon(view, piece, now ? Role::current : Role::input, now);
    }
    LargePixel::add_samples(view, full, Role::guide, true);
    LargePixel::add_samples(view, covered_mask_, Role::past, false);
    if (at_)
      LargePixel::add_samples(view, list_[*at_].mask & ~visible_ & ~covered_mask_, Role::rejected, true);
    if (at_)
      LargePixel::add_samples(view, list_[*at_].mask & covered_mask_ & ~visible_, Role::rejected, true);
    LargePixel::add_samples(view, visible_, Role::accepted, false);
    add_list(view);
    add_shares(view);
    board.milestone(std::move(view));
  }
  /// The fragments front to back: name, depth and mask as bits.
  void add_list(View& view) const {
    constexpr double left = 25, top = 21.6, height = 3.7;
    const std::size_t first = at_ && *at_ >= 4 ? *at_ - 3 : 0;
    for (std::size_t i = first; i < std::min(list_.size(), first + 4); ++i) {
      const Fragment& f = list_[i];
      const double y = top - height * static_cast<double>(i - first);
      const Role role = at_ == i ? Role::current : at_ && i < *at_ ? Role::past : Role::input;
      const std::string id = fmt::format("l {}", i);
      view.add({id + " name", role, Text{{left - 1.3, y - 1}, name_of(f)}});
      add_pattern(view, id, {left, y}, f.mask, role);
      view.add(
          {id + " depth", Role::guide, Text{{left + 4.7, y - 1}, "z " + figure_real(f.z_near), Align::left}});
    }
    view.add({"l title", Role::guide, Text{{left + 2.6, 23.2}, words_.say("list")}});
  }
  /// What each has of the pixel so far, as parts of a bar.
  void add_shares(View& view) const {
    constexpr double left = 24, right = 35, low = 1.4, high = 3.2;
    const auto at = [&](double share) { return left + (right - left) * share; };
    view.add(
        {"s frame", Role::boundary, Path{{{left, low}, {right, low}, {right, high}, {left, high}}, true}});
    view.add({"s title", Role::guide, Text{{(left + right) / 2, high + 1.1}, words_.say("bar")}});
    double from = 0;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      const auto& [name, weight] = weights_[i];
      const double to = std::min(from + weight, 1.0);
      if (to <= from) continue;
      const std::string id = fmt::format("s {}", i);
      view.add({id + " part", i + 1 == weights_.size() && !finished_ ? Role::accepted : Role::past,
                gradus::Area{{{{at(from), low}, {at(to), low}, {at(to), high}, {at(from), high}}}, 2}});
      view.add({id + " end", Role::boundary, Stroke{{at(to), low}, {at(to), high}}});
      if (to - from > 0.09)
        view.add({id + " name", Role::result, Text{{at((from + to) / 2), (low + high) / 2}, name}});
      from = to;
    }
  }

  const Words& words_;
  std::vector<Piece> pieces_;
  std::vector<Fragment> list_;
  std::optional<std::size_t> at_;
  Mask covered_mask_ = 0, visible_ = 0;
  std::vector<std::pair<std::string, double>> weights_;
  std::size_t merged_ = 0;
  double left_ = 1, covered_ = 0, total_ = 0;
  std::int64_t telling_ = 0, milestones_ = -1;
  bool finished_ = false, told_ = false, masked_ = false;
};

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

template <class Run>
void tell_list(Narrator& narrator, std::vector<Column> columns, Run run) {
  std::vector<Piece> pieces = pieces_of(narrator.arguments());
  std::vector<Fragment> list;
  narrator.paper(paper_width, paper_height);
  narrator.trace().subtitle = narrator.words().count("subtitle", std::ssize(pieces));
  narrator.columns(std::move(columns));
  narrator.legend({{Role::current, "now"},
                   {Role::accepted, "seen"},
                   {Role::rejected, "hidden"},
                   {Role::past, "covered"}});
  ListStory story(narrator.words(), pieces);
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
  tell_list(narrator, {{"fragment", false}, {"z"}, {"mask", false}, {"area"}, {"total"}},
            [](auto& list, const auto& watch, const auto&) { sum_of_areas(list, drop, watch); });
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
