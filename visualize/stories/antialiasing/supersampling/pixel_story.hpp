#pragma once
// One pixel drawn large: where the scene is asked, what each answer counts, and how the sum grows.

#include "stories/antialiasing/ring_cut.hpp"
#include "stories/antialiasing/supersampling/subject.hpp"
#include "stories/paper.hpp"

namespace gradus::supersampling {

class PixelStory {
 public:
  PixelStory(const Words& words, const Subject& subject)
      : words_(words),
        subject_(subject),
        margin_(std::max(0.3, static_cast<double>(reach_of(subject.filter, subject.n)) / subject.n)),
        panel_({{1, 1}, {27, 27}}, shown()) {}  // y down in the scene and on the paper

  static void set_paper(Narrator& narrator) { set_cells(narrator, {37, 28}); }
  StepNumber telling() const { return {telling_, 0}; }
  double value() const { return value_; }
  /// Where what is shown of the triangle has a corner, or the end of a side towards it.
  std::optional<dvec2> grip_at(dvec2 corner) const {
    const std::optional<dvec2> at = grip(shown(), subject_.corners, corner);
    return at ? std::optional(panel_.at(*at)) : std::nullopt;
  }

  void show(Board& board, const Started& s) {
    heaviest_ = 0;
    total_ = 0;
    put_scene();
    for (const auto& [at, weight] : kernel_of(s.filter, s.n).cells) {
      heaviest_ = std::max(heaviest_, weight);
      total_ += weight;
      ++cells_;
      const dvec2 place = place_of(subject_.pixel * s.n + at, s.n);
      base_.add({id_of(place), Role::guide, Dot{panel_.at(place), true}});  // to come
    }
    put_gauge(base_, 0);
    board.milestone(base_);
  }
  Event say(const Started& s) const {
    return {.text = s.filter == Filter::box ? "pixel.started" : "pixel.started_wide",
            .facts = {{"n", s.n}, {"reach", s.reach}},
            .words = {{"pixel", subject_.pixel},
                      {"cells", cells_},
                      {"filter", filter_name(words_, s.filter)},
                      {"radius", radius_of(s.filter)}}};
  }

  void show(Board& board, const Added<double>& a) {
    ++k_;
    const bool in = a.value > 0;
    inside_ += in;
    note_telling(a);
    const dvec2 place = place_of(a.cell, subject_.n);
    View view = base_;
    put_gauge(view, a.sum / a.total);
    put_sample(view, place, a.weight, Role::current, in);
    view.add({"z at", Role::current, square_at(place, 1)});
    put_sample(base_, place, a.weight, in ? Role::accepted : Role::rejected, in);
    board.milestone(std::move(view));
    last_ = a;
  }
  Event say(const Added<double>& a) const {
    const dvec2 place = place_of(a.cell, subject_.n);
    const bool in = a.value > 0, box = subject_.filter == Filter::box;
    Event event{
        .text = in ? (box ? "added.inside" : "added.inside_weighed")
                   : (box ? "added.outside" : "added.outside_weighed"),
        .facts = {{"x", place.x}, {"y", place.y}, {"value", a.value}, {"weight", a.weight}, {"sum", a.sum}},
        .words = {{"place", place}, {"before", a.sum - a.weight * a.value}, {"k", k_}},
        .row = {k_, place.x, place.y, a.value, a.weight, a.sum},
        .key = fmt::format("{},{}", a.cell.x, a.cell.y)};
    event.decides = yes_or_no(words_, "question", {{"place", place}}, in, "inside", "outside");
    return event;
  }

  void show(Board& board, const Filtered<double>& f) {
    value_ = f.value;
    put_gauge(base_, f.value);
    board.milestone(base_);
  }
  Event say(const Filtered<double>& f) const {
    const bool box = subject_.filter == Filter::box;
    const double exact = exact_share();
    return {.text = box ? "filtered" : "filtered_weighed",
            .facts = {{"sum", f.sum}, {"value", f.value}},
            .words = {{"inside", inside_},
                      {"cells", cells_},
                      {"total", total_},
                      {"exact", exact},
                      {"off", std::abs(f.value - exact)}},
            .key = "mean"};
  }
  void show(Board&, const Finished&) {}
  Event say(const Finished&) const { return {}; }

  /// Of the pixel's square, the part that the triangle covers.
  double exact_share() const {
    const dvec2 lower(subject_.pixel);
    const Polygon part = ring_within(subject_.corners, lower, lower + 1.0);
    return part.empty() ? 0 : area_of(part);
  }

 private:
  Extent shown() const {
    const dvec2 p(subject_.pixel);
    return {p - margin_, p + 1.0 + margin_};
  }
  /// A square round a place whose side is a part of a cell's.
  Path square_at(dvec2 place, double part) const {
    const double half = 0.5 * part / subject_.n;
    const dvec2 a = panel_.at(place - half), b = panel_.at(place + half);
    return rectangle(a, b - a);
  }
  void put_scene() {
    const Extent all = shown();
    const Polygon part = ring_within(subject_.corners, all.lower, all.upper);
    if (part.size() > 2) {
      base_.add({"a shape", Role::input, Area{{panel_.at(std::span<const dvec2>(part))}, 3}});
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const auto side = shown_part(all, subject_.corners[i], subject_.corners[(i + 1) % 3]);
      if (side)
        base_.add(
            {fmt::format("a side {}", i), Role::boundary, Stroke{panel_.at(side->a), panel_.at(side->b)}});
    }
    const dvec2 pixel(subject_.pixel);
    const int reach = reach_of(subject_.filter, subject_.n);
    for (int i = -reach; i <= subject_.n + reach; ++i) {
      const double at = static_cast<double>(i) / subject_.n, low = -static_cast<double>(reach) / subject_.n,
                   high = 1 - low;
      put_line(fmt::format("b column {}", i), pixel + dvec2{at, low}, pixel + dvec2{at, high});
      put_line(fmt::format("b row {}", i), pixel + dvec2{low, at}, pixel + dvec2{high, at});
    }
    const dvec2 a = panel_.at(pixel), b = panel_.at(pixel + 1.0);
    base_.add({"c pixel", Role::input, rectangle(a, b - a)});
    const dvec2 gauge_top{gauge_x, gauge_low - gauge_height};
    base_.add({"g frame", Role::input, rectangle(gauge_top, {gauge_width, gauge_height})});
    if (subject_.filter != Filter::box) return;
    const double level = gauge_low - exact_share() * gauge_height;
    base_.add(
        {"g exact", Role::measure, Stroke{{gauge_x - 0.6, level}, {gauge_x + gauge_width + 0.6, level}}});
    base_.add({"g exact name", Role::measure,
               Text{{gauge_x + gauge_width + 1, level}, figure_real(exact_share()), Align::left}});
  }
  void put_line(const std::string& id, dvec2 a, dvec2 b) {
    base_.add({id, Role::guide, Stroke{panel_.at(a), panel_.at(b), false, false, true}});
  }
  /// What the samples so far make of the pixel, as a column that rises.
  void put_gauge(View& view, double share) const {
    const double height = share * gauge_height;
    view.marks.erase("g filled");
    view.marks.erase("g level");
    if (share > 0) {
      const Path filled = rectangle({gauge_x, gauge_low - height}, {gauge_width, height});
      view.add({"g filled", Role::result, Area{{filled.points}, 3}});
      view.add({"g level", Role::result, filled});
    }
    view.add({"g value", Role::result, Text{{gauge_x + 0.5 * gauge_width, 26.2}, figure_real(share)}});
  }
  static std::string id_of(dvec2 place) { return fmt::format("s {} {}", place.y, place.x); }
  /// A sample: a square as large as its weight, filled or not as its place is inside or not.
  void put_sample(View& view, dvec2 place, double weight, Role role, bool in) const {
    const std::string id = id_of(place);
    if (subject_.filter != Filter::box) {
      const double part = 0.92 * std::sqrt(weight / heaviest_);
      const Path square = square_at(place, part);
      if (in) {
        view.add({"r" + id, Role::accepted, Area{{square.points}, 2}});
      } else {
        view.add({"r" + id, Role::rejected, square});
      }
    }
    view.add({id, role, Dot{panel_.at(place), !in}});
  }
  /// The step that tells most: of the second half, the sample next to the triangle's border.
  void note_telling(const Added<double>& a) {
    if (2 * k_ < cells_) return;
    const dvec2 place = place_of(a.cell, subject_.n);
    double near = 1e9;
    for (std::size_t i = 0; i < 3; ++i) {
      const dvec2 from = subject_.corners[i], way = subject_.corners[(i + 1) % 3] - from;
      const double length = std::max(1e-9, glm::dot(way, way));
      const double t = std::clamp(glm::dot(place - from, way) / length, 0.0, 1.0);
      near = std::min(near, glm::length(place - from - t * way));
    }
    if (near >= nearest_) return;
    nearest_ = near;
    telling_ = k_;
  }

  static constexpr double gauge_x = 29.5, gauge_low = 24.5, gauge_height = 22, gauge_width = 2.6;

  const Words& words_;
  const Subject& subject_;
  const double margin_;
  const Panel panel_;
  View base_{};
  Added<double> last_{};
  double heaviest_ = 1, total_ = 1, value_ = 0, nearest_ = 1e9;
  std::int64_t cells_ = 0, k_ = 0, inside_ = 0, telling_ = 1;
};

inline void tell_supersample(Narrator& narrator) {
  narrator.list("weight_at");
  narrator.list_below("draw");
  const Subject subject = subject_of(narrator.arguments());
  PixelStory::set_paper(narrator);
  narrator.subtitle("pixel.subtitle", {{"pixel", subject.pixel},
                                       {"n", subject.n},
                                       {"filter", filter_name(narrator.words(), subject.filter)}});
  narrator.columns({{"k"}, {"x"}, {"y"}, {"value"}, {"weight"}, {"sum"}});
  narrator.legend({{Role::input, "shape"},
                   {Role::current, "now"},
                   {Role::accepted, "inside"},
                   {Role::rejected, "outside"},
                   {Role::result, "mean"}});
  // Also where squares as large as their weights stand round them
  narrator.trace().legend[2].sample = Sample::dot;
  narrator.trace().legend[3].sample = Sample::ring;
  if (subject.filter == Filter::box) narrator.add_to_legend(Role::measure, "exact");
  PixelStory story(narrator.words(), subject);
  narrator.handles("corners", [&](dvec2 corner) { return story.grip_at(corner); });
  const auto share = [&](dvec2 place) { return subject.share_at(place); };
  supersample(
      {subject.pixel, subject.pixel}, subject.n, subject.filter, share, [](ivec2, double) {},
      narrator.watcher(story));
  narrator.telling(story.telling());
  narrator.result({{"value", story.value()}, {"exact", story.exact_share()}});
}

}  // namespace gradus::supersampling
