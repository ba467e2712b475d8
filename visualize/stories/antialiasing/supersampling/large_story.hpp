#pragma once
// The larger picture beside the one that is made of it: as it should be, and as the exhibits have it.

#include <limits>

#include "antialiasing/supersampling/supersampling_notes.hpp"
#include "stories/antialiasing/supersampling/subject.hpp"

namespace gradus::supersampling {

class LargeStory {
 public:
  LargeStory(const Words& words, const Subject& subject, bool exhibit, bool channels)
      : words_(words), subject_(subject), exhibit_(exhibit), channels_(channels) {
    put_frames();
  }

  ivec2 cells() const { return {2 * large().x + gap() + 2, large().y + heading() + 1}; }
  StepNumber telling() const { return {telling_, 0}; }
  bool exhibit() const { return exhibit_; }

  // The right way

  void show(Board& board, const Started&) { count(board, base_); }
  Event say(const Started& s) const {
    return {.text = "large.started",
            .facts = {{"n", s.n}},
            .words = {{"size", size_text(subject_.size)}, {"large", size_text(large())}},
            .key = "start"};
  }
  void show(Board& board, const RowDrawn<dvec3>& r) {
    const int reach = reach_of(subject_.filter, subject_.n);
    if (r.row < 0 || r.row >= large().y) return;  // beyond the picture: asked, not shown
    put_values(base_, left() + ivec2(0, r.row), {large().x, 1}, 1,
               [&](ivec2 at) { return r.values[static_cast<std::size_t>(at.x + reach)]; });
    row_ = r.row;
    if (r.row + 1 < large().y) return board.detail(base_);
    count(board, base_);
  }
  Event say(const RowDrawn<dvec3>&) const {
    if (row_ + 1 < large().y) return {.text = "large.row", .words = {{"row", row_}}, .key = "rows"};
    return {.text = "large.drawn",
            .words = {{"samples", std::int64_t{large().x} * large().y}, {"n", subject_.n}},
            .key = "drawn"};
  }
  void show(Board& board, const Filtered<dvec3>& f) {
    const int reach = reach_of(subject_.filter, subject_.n);
    show_pixel(board, f.pixel, f.pixel * subject_.n - reach, ivec2(subject_.n + 2 * reach), f.value);
  }
  Event say(const Filtered<dvec3>& f) const {
    const std::int64_t cells = std::ssize(kernel_of(subject_.filter, subject_.n).cells);
    return {.text = "large.filtered",
            .facts = {{"red", f.value.r}},
            .words = {{"pixel", f.pixel}, {"cells", cells}, {"value", f.value.r}},
            .row = row_of(f.pixel, f.value),
            .key = pixel_key(f.pixel)};
  }
  void show(Board& board, const Finished& f) {
    taken_ = f.taken;
    count(board, base_);
  }
  Event say(const Finished& f) const {
    return {.text = "large.finished",
            .words = {{"kept", f.taken.kept},
                      {"pixels", std::int64_t{subject_.size.x} * subject_.size.y},
                      {"band", cost_of_band(subject_.picture(), subject_.n, subject_.filter).kept}}};
  }

  // The exhibits

  void show(Board& board, const Replicated<dvec3>& r) { show_large(board, r.values); }
  Event say(const Replicated<dvec3>&) const {
    return {.text = "replicated",
            .words = {{"size", size_text(subject_.size)}, {"n", subject_.n}, {"blocks", block_text()}},
            .key = "replicas"};
  }
  void show(Board& board, const Blurred<dvec3>& b) { show_large(board, b.values); }
  Event say(const Blurred<dvec3>&) const {
    return {.text = channels_ ? "blurred_all" : "blurred",
            .words = {{"sigma", 0.5 * subject_.n}},
            .key = "blurred"};
  }
  void show(Board& board, const FirstTaken<dvec3>& f) {
    first_ = f.cell;
    show_pixel(board, f.pixel, f.cell, ivec2(subject_.n), f.value);
  }
  Event say(const FirstTaken<dvec3>& f) const {
    const double right = right_of(f.pixel).r;
    return {.text = channels_ ? "first_taken_all" : "first_taken",
            .facts = {{"red", f.value.r}, {"green", f.value.g}, {"blue", f.value.b}},
            .words = {{"pixel", f.pixel}, {"value", f.value.r}, {"blocks", block_text()}, {"right", right}},
            .row = row_of(f.pixel, f.value),
            .key = pixel_key(f.pixel)};
  }
  void show(Board& board, const steps::Finished&) { count(board, base_); }
  Event say(const steps::Finished&) const {
    return {.text = channels_ ? "exhibit_all.finished" : "exhibit.finished",
            .words = {{"n", subject_.n}, {"worst", worst_}, {"worst_at", worst_at_}}};
  }

 private:
  ivec2 large() const { return subject_.size * subject_.n; }
  int heading() const { return std::max(2, (large().y + 7) / 8); }
  int gap() const { return std::max(2, large().x / 12); }
  ivec2 left() const { return {1, heading()}; }
  ivec2 right() const { return {1 + large().x + gap(), heading()}; }
  static std::string size_text(ivec2 size) { return fmt::format("{} × {}", size.x, size.y); }
  std::string block_text() const { return fmt::format("{0} × {0}", subject_.n); }

  void put_frames() {
    const std::string_view name = exhibit_ ? "large.copies" : "large.samples";
    put_name("left", left(), words_.say(name, {{"size", size_text(large())}}));
    put_name("right", right(), words_.say("large.pixels", {{"size", size_text(subject_.size)}}));
    for (int y = 0; y < large().y; ++y) {
      for (int x = 0; x < large().x; ++x) {
        for (const ivec2 corner : {left(), right()})
          base_.cells.insert_or_assign({corner.y + y, corner.x + x}, CellLook{Role::guide, ""});
      }
    }
    // The pixels to come
    const dvec2 from = dvec2(right()) - 0.5, to = from + dvec2(large());
    for (int x = 1; x < subject_.size.x; ++x)
      put_line(fmt::format("a x {}", x), {from.x + x * subject_.n, from.y}, {from.x + x * subject_.n, to.y});
    for (int y = 1; y < subject_.size.y; ++y)
      put_line(fmt::format("a y {}", y), {from.x, from.y + y * subject_.n}, {to.x, from.y + y * subject_.n});
    base_.add({"a frame left", Role::input, round_cells(left(), large())});
    base_.add({"a frame right", Role::input, round_cells(right(), large())});
  }
  void put_line(const std::string& id, dvec2 a, dvec2 b) {
    base_.add({id, Role::guide, Stroke{a, b, false, false, true}});
  }
  void put_name(const std::string& id, ivec2 corner, const std::string& name) {
    const dvec2 at{corner.x + 0.5 * large().x - 0.5, 0.45 * heading() - 0.5};
    base_.add({"a name " + id, Role::guide, Text{at, name}});
  }
  void count(Board& board, View view) {
    ++milestones_;
    board.milestone(std::move(view));
  }
  void show_large(Board& board, const std::vector<dvec3>& values) {
    put_values(base_, left(), large(), 1,
               [&](ivec2 at) { return values[static_cast<std::size_t>(at.y * large().x + at.x)]; });
    count(board, base_);
  }
  /// A pixel comes out of these cells.
  void show_pixel(Board& board, ivec2 pixel, ivec2 first, ivec2 many, const dvec3& value) {
    const ivec2 at = right() + pixel * subject_.n;
    put_values(base_, at, ivec2(1), subject_.n, [&](ivec2) { return value; });
    View view = base_;
    const ivec2 lower = glm::max(first, ivec2(0)), upper = glm::min(first + many, large());
    view.add({"z cells", Role::candidate, round_cells(left() + lower, upper - lower)});
    if (exhibit_) view.add({"z first", Role::measure, Dot{dvec2(left() + first_)}});
    view.add({"z pixel", Role::current, round_cells(at, ivec2(subject_.n))});
    count(board, std::move(view));
    note_telling(pixel, value);
  }
  dvec3 right_of(ivec2 pixel) const {
    dvec3 found{};
    const auto light = [&](dvec2 place) { return subject_.light_at(place); };
    supersample({pixel, pixel}, subject_.n, subject_.filter, light,
                [&](ivec2, const dvec3& value) { found = value; });
    return found;
  }
  /// Right: a pixel on the border, not too early. Wrong: where it goes most wrong.
  void note_telling(ivec2 pixel, const dvec3& value) {
    const dvec3 off = glm::abs(value - right_of(pixel));
    const double wrong = channels_ ? std::max(off.g, off.b) : std::max({off.r, off.g, off.b});
    const double mixed = value.r * (1 - value.r);
    if (wrong > worst_ + 1e-9) {
      worst_ = wrong;
      worst_at_ = pixel;
      telling_ = milestones_;
    } else if (worst_ == 0 && mixed >= 0.18) {
      telling_ = milestones_;
    }
  }
  std::vector<Said> row_of(ivec2 pixel, const dvec3& value) const {
    return {pixel.x, pixel.y, channels_ ? value.g : value.r};
  }

  const Words& words_;
  const Subject& subject_;
  const bool exhibit_, channels_;
  View base_{};
  Taken taken_{};
  int row_ = 0;
  double worst_ = 0;
  ivec2 worst_at_{}, first_{};
  std::int64_t milestones_ = -1, telling_ = 0;
};

inline void set_large(Narrator& narrator, const Subject& subject, const LargeStory& story) {
  set_cells(narrator, story.cells());
  narrator.subtitle(
      story.exhibit() ? "large.subtitle_copies" : "large.subtitle",
      {{"columns", subject.size.x}, {"rows", subject.size.y}, {"n", fmt::format("{0} × {0}", subject.n)}});
}

inline void tell_large_picture(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  LargeStory story(narrator.words(), subject, false, false);
  set_large(narrator, subject, story);
  narrator.columns({{"x"}, {"y"}, {"light"}});
  narrator.legend({{Role::candidate, "taken"}, {Role::current, "new"}});
  const auto light = [&](dvec2 place) { return subject.light_at(place); };
  const Taken taken = large_picture(
      subject.picture(), subject.n, subject.filter, light, [](ivec2, const dvec3&) {},
      narrator.watcher(story));
  narrator.telling(story.telling());
  narrator.result({{"asked", taken.asked}, {"kept", taken.kept}});
}

template <class Run>
void tell_exhibit(Narrator& narrator, const Subject& subject, bool channels, const Run& run) {
  LargeStory story(narrator.words(), subject, true, channels);
  set_large(narrator, subject, story);
  narrator.legend({{Role::candidate, "copies"}, {Role::measure, "first"}, {Role::current, "new"}});
  const auto watch = narrator.watcher(story);
  const auto finished = [&](ivec2 pixel) { return subject.light_at(dvec2(pixel) + 0.5); };
  run(finished, watch);
  watch(steps::Finished{}, 0);
  narrator.telling(story.telling());
  narrator.result({{"pixels", std::int64_t{subject.size.x} * subject.size.y}});
}

inline void tell_upsampled_image(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  narrator.columns({{"x"}, {"y"}, {"light"}});
  tell_exhibit(narrator, subject, false, [&](const auto& finished, const auto& watch) {
    upsampled_image(subject.size, subject.n, finished, [](ivec2, const dvec3&) {}, watch);
  });
}

inline void tell_blurred_channels(Narrator& narrator) {
  Subject subject = subject_of(narrator.arguments());
  subject.red = true;
  narrator.columns({{"x"}, {"y"}, {"green"}});
  tell_exhibit(narrator, subject, true, [&](const auto& finished, const auto& watch) {
    blurred_channels(subject.size, subject.n, finished, [](ivec2, const dvec3&) {}, watch);
  });
}

}  // namespace gradus::supersampling
