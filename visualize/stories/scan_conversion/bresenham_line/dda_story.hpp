#pragma once
// The story of a line by adding a rounded slope again and again.

#include "scan_conversion/bresenham_line/bresenham_line.hpp"
#include "scan_conversion/bresenham_line/bresenham_line_window.hpp"
#include "stories/scan_conversion/bresenham_line/drawing.hpp"
#include "stories/side_by_side.hpp"

namespace gradus::bresenham_line {

/// The shortest decimal text that gives the float back.
inline std::string scalar_text(float value) { return fmt::format("{}", value); }

/// The steps of the digital differential analyser, and of each the right pixel.
class DdaStory {
 public:
  DdaStory(const Words& words, const Line& line) : words_(words), line_(line) {}

  /// Number of the first pixel that is not the nearest one.
  std::optional<std::int64_t> first_wrong() const { return first_wrong_; }

  void show(Board& board, const Divided<float>& d) {
    slope_ = d.slope;
    current_ = d.from;
    board.milestone(d.from);
    board.plot(d.from, Role::current);
  }
  Event say(const Divided<float>& d) const {
    return {.text = "divided",
            .facts = {{"from", d.from}, {"to", d.to}, {"dx", d.dx}, {"dy", d.dy}, {"slope", double{d.slope}}},
            .words = {{"slope", scalar_text(d.slope)}},
            .row = {0, 0, 0, d.from.x, d.from.y, words_.shared("words", "yes")},
            .key = pixel_key(d.from),
            .phase = words_.shared("words", "set_up")};
  }

  void show(Board& board, const Added<float>& a) {
    added_ = a;
    board.detail(current_);
  }
  Event say(const Added<float>& a) const {
    return {.text = "added",
            .facts = {{"k", a.k}, {"before", double{a.before}, "offset"}, {"offset", double{a.offset}}},
            .words = sum(),
            .key = pixel_key(current_)};
  }

  void show(Board& board, const Rounded<float>& r) {
    row_before_ = std::exchange(row_, r.row);
    current_ = r.pixel;
    right_ = pixel_at(line_.from, line_.to, r.k);
    board.milestone(r.pixel);
    if (right_ != r.pixel) {
      if (!first_wrong_) first_wrong_ = r.k;
      board.look_at(right_, Role::accepted);
      board.mark("right name", Role::accepted, Label{dvec2(right_), words_.say("right_pixel")});
    }
    board.plot(r.pixel, Role::current);
    board.mark("offset", Role::measure, Dot{place_of(r)});
    board.mark("offset name", Role::measure,
               Label{place_of(r), words_.say("offset", {{"offset", scalar_text(r.offset)}})});
  }
  Event say(const Rounded<float>& r) const {
    Event event{.text = verdict(r),
                .facts = {{"k", r.k}, {"offset", double{r.offset}}, {"row", r.row}, {"pixel", r.pixel}},
                .words = sum(),
                .row = {r.k, scalar_text(r.offset), r.row, r.pixel.x, r.pixel.y,
                        words_.shared("words", right_ == r.pixel ? "yes" : "no")},
                .key = pixel_key(r.pixel),
                .decides = decision(r)};
    event.words.push_back({"right", right_});
    return event;
  }

  void show(Board& board, const Finished&) {
    board.detail(current_);
    board.all_plotted(Role::result);
  }
  Event say(const Finished& f) const {
    Event event{.text = "all_right", .facts = {{"pixels", f.pixels}}, .count = f.pixels};
    if (first_wrong_) {
      event.text = "drifted";
      event.words = {{"k", *first_wrong_}};
      event.count.reset();
    }
    return event;
  }

 private:
  /// What the floats of the last sum are called in sentences.
  std::vector<Word> sum() const {
    return {{"before", scalar_text(added_.before)},
            {"slope", scalar_text(slope_)},
            {"offset", scalar_text(added_.offset)}};
  }
  /// What exact arithmetic says of the pixel that was taken.
  std::string_view verdict(const Rounded<float>& r) const {
    if (right_ == r.pixel) return "rounded.right";
    const bool tie = miss_times_dx(line_, right_, r.k) == miss_times_dx(line_, r.pixel, r.k);
    return tie ? "rounded.tie" : "rounded.wrong";
  }
  Decision decision(const Rounded<float>& r) const {
    const bool stays = r.row == row_before_;
    return {words_.say("question_row", {{"offset", scalar_text(r.offset)}}),
            {figure_number(row_before_), figure_number(row_before_ + 1)},
            stays ? 0u : 1u,
            stays ? "straight" : "diagonal"};
  }
  dvec2 place_of(const Rounded<float>& r) const {
    const dvec2 straight(line_.go.straight), aside = dvec2(line_.go.diagonal) - straight;
    return dvec2(line_.from) + static_cast<double>(r.k) * straight + double{r.offset} * aside;
  }

  const Words& words_;
  const Line line_;
  float slope_ = 0;
  Added<float> added_{};
  ivec2 current_{}, right_{};
  std::int64_t row_before_ = 0, row_ = 0;
  std::optional<std::int64_t> first_wrong_;
};

/// What the steps of the digital differential analyser hold.
struct DdaNumbers {
  template <class T>
  void operator()(NumericStep<T>& to, const Divided<T>& d) const {
    to.type = "Divided";
    to.number("slope", d.slope);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Added<T>&) const {
    to.type = "Added";
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Rounded<T>& r) const {
    to.type = "Rounded";
    to.number("offset", r.offset);
    to.decision(r.row);
  }
  template <class T>
  void operator()(NumericStep<T>& to, const Finished&) const {
    to.type = "Finished";
  }
};

}  // namespace gradus::bresenham_line
