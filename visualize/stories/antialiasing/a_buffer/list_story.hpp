#pragma once
// The story of a pixel's fragments: their masks as squares, front to back, what of each is still seen, and
// its share of the pixel beside the true area.

#include <bit>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "antialiasing/a_buffer/a_buffer_notes.hpp"
#include "stories/antialiasing/a_buffer/seen_parts.hpp"

namespace gradus::a_buffer {

/// A polygon's fragment goes into the list.
struct Listed {
  std::size_t number;
};

/// What all stories of a list show.
class ListStory {
 public:
  /// most: what the shares add up to, 1 or, by mistake, more.
  ListStory(const Words& words, const std::vector<Piece>& pieces, double most)
      : words_(words), pieces_(pieces), parts_(pieces), most_(most) {
    for (std::size_t i = 0; i < pieces.size(); ++i) names_.push_back(parts_.name_place(i));
  }

  double covered() const { return share_; }
  StepNumber telling() const { return {telling_, 0}; }

  void show(Board& board, const Listed& l) {
    list_.push_back(pieces_[l.number].fragment);
    rows_.emplace_back();
    at_ = list_.size() - 1;
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
    set_list(s.list);
    sorted_ = true;
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
    set_list(o.list);
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
    const auto number = static_cast<std::size_t>(grown - m.list.begin());
    set_list(m.list);
    if (merged_ == 0) return;
    at_ = number;
    put(board);
  }
  Event say(const Merged&) const {
    return {.text = "merged",
            .facts = {{"fragments", std::ssize(list_)}},
            .count = static_cast<std::int64_t>(merged_)};
  }
  void show(Board& board, const Masked& m) {
    at_ = m.number;
    covered_ = m.covered;
    rows_[m.number].visible = m.visible;
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
  void show(Board& board, const Weighed& w) { weigh(board, w.covered, w.weight); }
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
    share_ = 1 - f.left;
    put(board);
  }
  Event say(const Finished& f) const {
    std::string shares;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (rows_[i].weight > 0) shares += (shares.empty() ? "" : ", ") + share_of(i);
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
    weigh(board, e.covered, e.weight);
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
    at_ = s.number;
    if (!masked_) rows_[s.number].visible = s.fragment.mask;
    weigh(board, covered_, s.area);
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
      event.read = {name, s.fragment.z_near, mask, hex_of(*rows_[s.number].visible), s.area, s.total};
    else
      event.row = {name, s.fragment.z_near, mask, s.area, s.total};
    return event;
  }
  void show(Board& board, const Divided& d) {
    at_.reset();
    most_ = 1;
    if (d.total > 0) {
      for (Row& row : rows_) row.weight /= d.total;
    }
    put(board);
    telling_ = milestones_;
  }
  Event say(const Divided& d) const {
    const double total = d.total;
    std::string shares;
    for (std::size_t i = 0; i < rows_.size(); ++i) shares += (i == 0 ? "" : ", ") + share_of(i);
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
  std::string share_of(std::size_t i) const {
    return fmt::format("{} {}", name_of(list_[i]), figure_real(rows_[i].weight));
  }
  void set_list(const std::vector<Fragment>& list) {
    list_ = list;
    rows_.assign(list.size(), {});
    at_.reset();
  }
  void weigh(Board& board, Mask covered, double weight) {
    covered_ = covered;
    rows_[*at_].weight = weight;
    put(board);
  }

  void put(Board& board) {
    ++milestones_;
    View view;
    LargePixel::add_grid(view);
    for (std::size_t i = 0; i < pieces_.size(); ++i) add_polygon(view, i);
    const Mask mask = at_ ? list_[*at_].mask : 0, seen = at_ ? rows_[*at_].visible.value_or(mask) : 0;
    LargePixel::add_samples(view, full, Role::guide, true);
    LargePixel::add_samples(view, covered_, Role::past, false);
    LargePixel::add_samples(view, mask & ~seen, Role::rejected, true);
    LargePixel::add_samples(view, seen, Role::accepted, false);
    add_list(view);
    add_bars(view);
    board.milestone(std::move(view));
  }
  /// What is seen of a polygon; of the fragment at hand all of it.
  void add_polygon(View& view, std::size_t i) const {
    const Piece& piece = pieces_[i];
    const bool now = at_ && is_part(piece.fragment, list_[*at_]);
    if (now) LargePixel::add_polygon(view, piece, Role::current, true);
    const std::string id = "b " + piece.name;
    int number = 0;
    for (const auto& [a, b] : parts_.sides(i)) {
      if (!now)
        view.add({fmt::format("{} {:02}", id, number++), Role::input,
                  Stroke{LargePixel::at(a), LargePixel::at(b)}});
    }
    if (names_[i])
      view.add(
          {id + " name", now ? Role::current : Role::input, Text{LargePixel::at(*names_[i]), piece.name}});
  }
  /// The fragments front to back: of each its name and depth, its mask, and what of that is seen beside what
  /// really is.
  void add_list(View& view) const {
    constexpr double left = 21.6, top = 21.6, low = 4.6;
    constexpr std::size_t most = 6;
    const std::size_t shown = std::min(list_.size(), most);
    const std::size_t first = at_ ? std::min(*at_ < most ? 0 : *at_ - most + 1, list_.size() - shown) : 0;
    const double pitch = std::min(6.0, (top - low) / static_cast<double>(std::max<std::size_t>(shown, 3)));
    for (std::size_t i = first; i < first + shown; ++i) {
      const Pattern pattern{{left, top - pitch * static_cast<double>(i - first)}, (pitch - 0.7) / mask_rows};
      add_fragment(view, i, pattern);
    }
    view.add({"l title", Role::guide, Text{{left + 4, 22.7}, words_.say(sorted_ ? "list" : "list.given")}});
  }
  void add_fragment(View& view, std::size_t i, const Pattern& pattern) const {
    const Fragment& f = list_[i];
    const Row& row = rows_[i];
    const Role role = at_ == i ? Role::current : row.visible ? Role::past : Role::input;
    const std::string id = fmt::format("l {:02}", i);
    const double middle = pattern.corner.y - pattern.height() / 2;
    view.add({id + " name", role == Role::past ? Role::input : role,
              Text{{pattern.corner.x - 1.2, middle}, name_of(f)}});
    pattern.add_bits(view, id + " a", row.visible.value_or(f.mask),
                     row.visible ? Role::accepted : Role::past);
    if (row.visible) pattern.add_bits(view, id + " b", f.mask & ~*row.visible, Role::rejected);
    pattern.add_frame(view, id, role);
    const dvec2 right{pattern.corner.x + pattern.width() + 0.7, middle};
    const auto line = [&](const char* own, Role its_role, const std::string& text, int number) {
      view.add({id + own, its_role, Text{right, text, Align::left, false, number}});
    };
    if (!row.visible) return line(" depth", Role::guide, words_.say("depth", {{"z", f.z_near}}), 0);
    const int bits = std::popcount(*row.visible);
    line(" seen", Role::accepted, words_.say("seen", {{"bits", bits}}), 0);
    if (row.weight > 0) line(" weight", Role::accepted, "= " + figure_real(row.weight), 1);
  }
  /// The shares of the pixel so far, and below them those by true areas.
  void add_bars(View& view) const {
    std::vector<Share> by_masks, by_areas;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const bool last = at_ == i;
      by_masks.push_back({name_of(list_[i]), rows_[i].weight, last ? Role::accepted : Role::past});
    }
    for (const std::size_t i : parts_.front_to_back())
      by_areas.push_back({pieces_[i].name, parts_.share(i), Role::measure});
    add_bar(view, "s masks", 2.5, by_masks, "by_masks");
    add_bar(view, "t areas", 0.1, by_areas, "by_areas");
  }
  struct Share {
    std::string name;
    double size;
    Role role;
  };
  void add_bar(View& view, const std::string& id, double low, const std::vector<Share>& shares,
               std::string_view title) const {
    const double left = LargePixel::corner.x, unit = LargePixel::side / most_, high = low + 1.6;
    const auto part = [&](double from, double to) {
      return Extent{{left + unit * from, low}, {left + unit * to, high}};
    };
    view.add({id + " frame", Role::boundary, Path{part(0, 1).corners(), true}});
    view.add({id + " title", Role::guide,
              Text{{left + LargePixel::side + 0.7, (low + high) / 2}, words_.say(title), Align::left}});
    double from = 0;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      const auto& [name, size, role] = shares[i];
      if (!(size > 0)) continue;
      const Extent share = part(from, from + size);
      from += size;
      const std::string own = fmt::format("{} {:02}", id, i);
      view.add({own + " part", role, gradus::Area{{share.corners()}, 2}});
      view.add({own + " end", Role::boundary, Stroke{{share.upper.x, low}, {share.upper.x, high}}});
      const std::string text = name + " " + figure_real(size);
      const double room = share.size().x - 0.6;
      if (room > 0.8)
        view.add({own + " name", Role::input,
                  Text{share.centre(), room > 0.75 * static_cast<double>(text.size()) ? text : name}});
    }
  }

  /// What is known of a fragment in the list.
  struct Row {
    std::optional<Mask> visible{};
    double weight = 0;
  };

  const Words& words_;
  const std::vector<Piece>& pieces_;
  const SeenParts parts_;
  double most_;
  std::vector<std::optional<dvec2>> names_;  ///< where the polygons' names stand
  std::vector<Fragment> list_;
  std::vector<Row> rows_;
  std::optional<std::size_t> at_;
  Mask covered_ = 0;
  double share_ = 0;
  std::size_t merged_ = 0;
  std::int64_t telling_ = 0, milestones_ = -1;
  bool told_ = false, masked_ = false, sorted_ = false;
};

}  // namespace gradus::a_buffer
