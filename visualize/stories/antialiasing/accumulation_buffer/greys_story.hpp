#pragma once
// A picture from dark to light, the same in every pass: summed in numbers, and in the notes' bytes.

#include "antialiasing/accumulation_buffer/accumulation_buffer_notes.hpp"
#include "stories/antialiasing/accumulation_buffer/subject.hpp"

namespace gradus::accumulation_buffer {

/// Greys in equal steps, row by row; the last one is the lightest.
struct Wedge {
  static constexpr ivec2 size{5, 4};
  static constexpr int pixels = 20;

  int lightest;

  int value(ivec2 p) const { return lightest * (p.y * size.x + p.x + 1) / pixels; }
  template <class Plot>
  void draw(const Plot& plot) const {
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x) plot({x, y}, value({x, y}));
    }
  }
};

/// Value: of the sums, a byte or a number.
template <class Value>
class GreysStory {
 public:
  GreysStory(const Words& words, const Wedge& wedge, std::span<const Value> sums, std::int64_t passes)
      : words_(words), wedge_(wedge), sums_(sums), passes_(passes) {}

  static constexpr ivec2 paper{13, 8};

  void show(Board& board, const Started&) { board.milestone(drawing()); }
  Event say(const Started& s) const {
    return {.text = wide ? "wide.started" : "bytes.started",
            .facts = {{"passes", s.passes}},
            .words = {{"value", wedge_.lightest}},
            .count = s.passes,
            .key = "started"};
  }

  void show(Board& board, const PassAdded&) {
    before_ = held_;
    ++added_;
    held_ = at(Wedge::pixels - 1);
    board.milestone(drawing());
  }
  Event say(const PassAdded& p) const {
    const std::int64_t sum = before_ + wedge_.lightest;
    Event event{.text = wide        ? "wide.added"
                        : sum < 256 ? "bytes.fits"
                                    : "bytes.wraps",
                .facts = {{"pass", p.pass + 1}, {"held", held_}, {"right", total()}},
                .words = {{"before", before_}, {"value", wedge_.lightest}, {"sum", sum}, {"byte", held_}},
                .row = {p.pass + 1, wedge_.lightest, held_, total()},
                .key = fmt::format("pass {}", p.pass + 1),
                .phase = words_.say("phase.passes")};
    if (!wide) event.decides = yes_or_no(words_, "question.fits", {{"sum", sum}}, sum < 256, "fits", "wraps");
    return event;
  }

  void show(Board& board, const Averaged&) {
    done_ = true;
    board.milestone(drawing());
  }
  Event say(const Averaged& a) const {
    const std::int64_t shown = at(Wedge::pixels - 1);
    return {
        .text = wide                       ? "wide.averaged"
                : shown == wedge_.lightest ? "bytes.right"
                                           : "bytes.wrong",
        .facts = {{"passes", a.passes}, {"shown", shown}, {"right", wedge_.lightest}},
        .words = {{"byte", held_}, {"value", wedge_.lightest}, {"total", total()}, {"most", 255 / a.passes}},
        .key = "mean",
        .ends = true};
  }

 private:
  static constexpr bool wide = !std::same_as<Value, std::uint8_t>;
  static constexpr Frame left{{1, 1}, Wedge::size}, right{{7, 1}, Wedge::size};

  std::int64_t at(int pixel) const {
    return static_cast<std::int64_t>(sums_[static_cast<std::size_t>(pixel)]);
  }
  std::int64_t total() const { return added_ * wedge_.lightest; }

  /// What the buffer holds, beside what it should hold, or beside what every pass adds.
  View drawing() const {
    View view;
    left.put(view, "a held",
             words_.say(wide ? (done_ ? "heading.done" : "heading.sums")
                             : (done_ ? "heading.bytes_mean" : "heading.bytes")),
             0.4);
    right.put(view, "b beside",
              words_.say(wide ? "heading.each" : (done_ ? "heading.wide_mean" : "heading.wide")), 0.4);
    const std::int64_t n = done_ || added_ == 0 ? 1 : added_;
    for (int k = 0; k < Wedge::pixels; ++k) {
      const ivec2 p{k % Wedge::size.x, k / Wedge::size.x};
      const std::int64_t value = wedge_.value(p), beside = wide || done_ ? value : added_ * value;
      left.put_pixel(view, p, grey(at(k), wide ? n : 1), std::to_string(at(k)));
      right.put_pixel(view, p, grey(beside, wide ? 1 : n), std::to_string(beside));
    }
    if (added_ == 0) return view;
    left.mark(view, "c at", Wedge::size - 1);
    right.mark(view, "d at", Wedge::size - 1);
    put_line(view);
    return view;
  }
  /// A byte of sRGB as it would be shown.
  static double grey(std::int64_t sum, std::int64_t passes) {
    const auto shown = static_cast<std::uint8_t>(std::clamp<std::int64_t>(sum / passes, 0, 255));
    return linear_from_srgb8({shown, shown, shown, 255}).r;
  }
  /// The sum on a line that ends every 256, and what is left of it in a byte.
  void put_line(View& view) const {
    const double longest = static_cast<double>(std::max<std::int64_t>(passes_ * wedge_.lightest, 256));
    const double bytes = std::ceil(longest / 256), y = 5.8, scale = 12.0 / (256 * bytes);
    const auto on_line = [&](double value) { return dvec2{scale * value, y}; };
    view.add({"l line", Role::guide, Stroke{on_line(0), on_line(256 * bytes)}});
    const dvec2 tick{0, 0.35};
    const auto every = static_cast<int>(std::ceil(bytes / 6));
    for (int k = 0; k <= static_cast<int>(bytes); ++k) {
      const dvec2 p = on_line(256.0 * k);
      view.add({fmt::format("l tick {:02}", k), Role::boundary, Stroke{p - tick, p + tick}});
      if (k % every == 0)
        view.add(
            {fmt::format("l text {:02}", k), Role::guide, Text{p + dvec2{0, 0.75}, std::to_string(256 * k)}});
    }
    for (std::int64_t k = 0; k < added_; ++k) {
      const auto value = [&](std::int64_t n) { return static_cast<double>(n * wedge_.lightest); };
      const bool last = k + 1 == added_ && !done_;
      view.add({fmt::format("m hop {:02}", k), last ? Role::current : Role::past,
                Path{hop(on_line(value(k)), on_line(value(k + 1)))}});
    }
    const double sum = static_cast<double>(total());
    view.add({"n sum", Role::current, Dot{on_line(sum)}});
    if (wide) return;
    const dvec2 from = on_line(sum - static_cast<double>(held_)), to = on_line(sum), below{0, 0.2};
    view.add({"n rest", Role::measure, Stroke{from + below, to + below}});
    view.add(
        {"n text", Role::measure,
         Text{{std::min(0.5 * (from.x + to.x), 10.8), to.y + 1.35},
              words_.say("rest", {{"sum", total()}, {"times", (total() - held_) / 256}, {"byte", held_}})}});
  }
  static std::vector<dvec2> hop(dvec2 from, dvec2 to) {
    std::vector<dvec2> points;
    for (int k = 0; k <= 16; ++k) {
      const double t = k / 16.0;
      points.push_back(from + t * (to - from) - dvec2{0, 2.8 * t * (1 - t)});
    }
    return points;
  }

  const Words& words_;
  const Wedge& wedge_;
  std::span<const Value> sums_;
  std::int64_t passes_, added_ = 0, before_ = 0, held_ = 0;
  bool done_ = false;
};

/// run(grid, wedge, sums, observer).
template <class Value, class Run>
void tell_greys(Narrator& narrator, const Run& run) {
  const Wedge wedge{static_cast<int>(narrator.arguments().integer("value"))};
  const ivec2 grid = grid_of(narrator.arguments());
  const std::int64_t passes = std::int64_t{grid.x} * grid.y;
  narrator.subtitle("bytes.subtitle", {{"a", grid.x}, {"b", grid.y}, {"value", wedge.lightest}});
  set_paper(narrator, GreysStory<Value>::paper);
  narrator.columns({{"pass"}, {"value"}, {"held"}, {"right"}});
  narrator.legend({{Role::current, "pass_of_value"}, {Role::measure, "rest"}, {Role::boundary, "full"}});
  narrator.trace().legend.front().sample = Sample::outline;
  std::vector<Value> sums(Wedge::pixels);
  GreysStory<Value> story(narrator.words(), wedge, sums, passes);
  run(grid, wedge, sums, narrator.watcher(story));
  narrator.telling({passes, 0});
  narrator.result(
      {{"shown", static_cast<std::int64_t>(sums.back())}, {"right", std::int64_t{wedge.lightest}}});
}

inline void tell_wide_sums(Narrator& narrator) {
  narrator.list("add");
  narrator.list_below("divide");
  narrator.list_below("accumulate");
  tell_greys<double>(narrator, [](ivec2 grid, const Wedge& wedge, auto& sums, const auto& observer) {
    const auto render = [&](dvec2, const Sums<double>& plot) { wedge.draw(plot); };
    accumulate(grid, render, Sums<double>(sums, Wedge::size), observer);
  });
}
inline void tell_eight_bits(Narrator& narrator) {
  narrator.list("add");
  narrator.list_below("divide");
  narrator.list_below("eight_bits");
  tell_greys<std::uint8_t>(narrator, [](ivec2 grid, const Wedge& wedge, auto& sums, const auto& observer) {
    const auto render = [&](dvec2, const ByteSums& plot) { wedge.draw(plot); };
    eight_bits(grid, render, ByteSums{sums, Wedge::size}, observer);
  });
}

}  // namespace gradus::accumulation_buffer
