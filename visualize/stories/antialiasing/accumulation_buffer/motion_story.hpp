#pragma once
// A disc flies past while the shutter is open: the picture of each moment, and the mean of them.

#include "stories/antialiasing/accumulation_buffer/subject.hpp"

namespace gradus::accumulation_buffer {

/// What flies, in pixels and seconds.
struct Flight {
  static constexpr ivec2 size{26, 7};
  static constexpr double radius = 2.5, start = 4;
  static constexpr ivec2 watched{9, 3};  ///< the pixel that the table follows

  int passes;
  double speed, shutter;

  dvec2 middle(double t) const { return {start + speed * t, 0.5 * size.y}; }
  double way() const { return speed * shutter; }
  double grey(dvec2 place, double t) const {
    const dvec2 off = place - middle(t);
    return glm::dot(off, off) <= radius * radius ? 1 : 0;
  }
  Picture picture(double t) const {
    return picture_at(size, dvec2(0.5), [&](dvec2 place) { return grey(place, t); });
  }
};

inline Flight flight_of(const Arguments& arguments) {
  const Flight flight{static_cast<int>(arguments.integer("passes")), *arguments.number("speed"),
                      *arguments.number("shutter")};
  constexpr double longest = Flight::size.x - Flight::start - Flight::radius;
  if (!(0 <= flight.speed && 0 <= flight.shutter && flight.way() <= longest))
    refuse(arguments, {"speed", "shutter"},
           fmt::format("expected a way to the right of at most {} pixels, speed times shutter", longest));
  return flight;
}

class MotionStory {
 public:
  MotionStory(const Words& words, const Flight& flight, Picture& sums)
      : words_(words), flight_(flight), sums_(sums) {}

  static constexpr ivec2 paper{28, 20};

  void show(Board& board, const Started&) { board.milestone(drawing()); }
  Event say(const Started& s) const {
    return {.text = "motion.started",
            .facts = {{"passes", s.passes}, {"way", flight_.way()}},
            .words = {{"speed", flight_.speed},
                      {"shutter", flight_.shutter},
                      {"part", flight_.way() / static_cast<double>(s.passes)}},
            .count = s.passes,
            .key = "started"};
  }

  void show(Board& board, const MomentAdded& m) {
    now_ = m.moment;
    value_ = flight_.grey(dvec2(Flight::watched) + 0.5, m.moment);
    ++passes_;
    View view = drawing();
    board.milestone(std::move(view));
  }
  Event say(const MomentAdded& m) const {
    const double sum = sums_.at(Flight::watched);
    return {.text = value_ > 0 ? "motion.in" : "motion.out",
            .facts = {{"pass", m.pass + 1}, {"t", m.moment}, {"sum", sum}},
            .words = {{"x", flight_.middle(m.moment).x}, {"pixel", Flight::watched}},
            .row = {m.pass + 1, m.moment, flight_.middle(m.moment).x, value_, sum,
                    sum / static_cast<double>(m.pass + 1)},
            .key = fmt::format("pass {}", m.pass + 1),
            .phase = words_.say("phase.passes"),
            .decides = yes_or_no(words_, "question.disc", {{"pixel", Flight::watched}}, value_ > 0, "inside",
                                 "outside")};
  }

  void show(Board& board, const Averaged&) {
    done_ = true;
    board.milestone(drawing());
  }
  Event say(const Averaged& a) const {
    const double mean = sums_.at(Flight::watched);
    return {.text = "motion.averaged",
            .facts = {{"passes", a.passes}, {"mean", mean}, {"way", flight_.way()}},
            .words = {{"pixel", Flight::watched}, {"speed", flight_.speed}, {"shutter", flight_.shutter}},
            .count = a.passes,
            .key = "mean",
            .ends = true};
  }

 private:
  static constexpr Frame moment_frame{{1, 2}, Flight::size}, mean_frame{{1, 12}, Flight::size};

  View drawing() const {
    View view;
    moment_frame.put(
        view, "a moment",
        now_ ? words_.say("heading.moment", {{"t", *now_}, {"pass", passes_}}) : words_.say("heading.opens"));
    mean_frame.put(view, "b mean",
                   passes_ == 0 ? words_.say("heading.empty") : words_.count("heading.mean", passes_));
    if (now_) moment_frame.put_picture(view, flight_.picture(*now_));
    if (passes_ > 0) mean_frame.put_picture(view, sums_, done_ ? 1 : static_cast<double>(passes_));
    put_ghosts(view);
    if (passes_ > 0) {
      moment_frame.mark(view, "w above", Flight::watched, Role::candidate);
      mean_frame.mark(view, "w below", Flight::watched, Role::candidate);
    }
    put_way(view);
    return view;
  }
  /// Where the disc is in every pass.
  void put_ghosts(View& view) const {
    const Shutter shutter{0, flight_.shutter};
    for (int k = 0; k < flight_.passes; ++k) {
      const double t = shutter.moment(k, flight_.passes);
      const Role role = now_ && t < *now_ ? Role::measure : now_ && t == *now_ ? Role::current : Role::guide;
      if (done_ || role != Role::guide || passes_ == 0)
        view.add({fmt::format("g ghost {:02}", k), done_ ? Role::measure : role, outline(t)});
    }
  }
  static constexpr int sides = 48;
  Path outline(double t) const {
    Path path{{}, true};
    for (int k = 0; k < sides; ++k) {
      const double turn = 2 * 3.14159265358979323846 * k / sides;
      path.points.push_back(moment_frame.on_paper(
          flight_.middle(t) + Flight::radius * dvec2{gradus::cos(turn), gradus::sin(turn)}));
    }
    return path;
  }
  /// How far its middle comes while the shutter is open.
  void put_way(View& view) const {
    const dvec2 from = mean_frame.on_paper({flight_.middle(0).x, Flight::size.y + 0.6});
    const dvec2 to = from + dvec2{flight_.way(), 0}, tick{0, 0.4};
    view.add({"l way", Role::accepted, Stroke{from, to, true}});
    view.add({"l opens", Role::accepted, Stroke{from - tick, from + tick}});
    view.add(
        {"l text", Role::accepted,
         Text{to + dvec2{0.6, 0},
              words_.say("way",
                         {{"speed", flight_.speed}, {"shutter", flight_.shutter}, {"way", flight_.way()}}),
              Align::left}});
  }

  const Words& words_;
  const Flight& flight_;
  Picture& sums_;
  std::optional<double> now_{};
  double value_ = 0;
  std::int64_t passes_ = 0;
  bool done_ = false;
};

inline void tell_motion_blur(Narrator& narrator) {
  const Flight flight = flight_of(narrator.arguments());
  narrator.subtitle("motion.subtitle", {{"speed", flight.speed}, {"shutter", flight.shutter}});
  set_paper(narrator, MotionStory::paper);
  narrator.columns({{"pass"}, {"t"}, {"x"}, {"value"}, {"sum"}, {"mean"}});
  narrator.legend({{Role::measure, "ghosts"},
                   {Role::current, "moment"},
                   {Role::candidate, "watched"},
                   {Role::accepted, "way"}});
  narrator.trace().legend.front().sample = Sample::line;
  Picture sums{Flight::size};
  MotionStory story(narrator.words(), flight, sums);
  const auto render = [&](double t, const Sums<double>& plot) {
    draw(Flight::size, dvec2(0.5), [&](dvec2 place) { return flight.grey(place, t); }, plot);
  };
  motion_blur(flight.passes, {0, flight.shutter}, render, sums.sums(), narrator.watcher(story));
  narrator.telling({(3 * flight.passes + 3) / 4, 0});
  narrator.result({{"way", flight.way()}, {"mean", sums.at(Flight::watched)}});
}

}  // namespace gradus::accumulation_buffer
