#pragma once
// How large and how sharp a highlight is: (R.V)^n round R for several n, as lobes, as curves and on balls.

#include "core/arithmetic/elementary.hpp"
#include "stories/past.hpp"
#include "stories/shading/illumination/drawing.hpp"

namespace gradus::illumination {

/// The highlight of one exponent is drawn.
struct LobeDrawn {
  double exponent;
  double half;  ///< where it has half its strength, in degrees from R
};

class LobeStory : public Past<steps::Started, LobeDrawn, steps::Finished> {
 public:
  /// balls: one for each exponent.
  LobeStory(const Words& words, double theta, std::vector<Balls> balls)
      : words_(words), theta_(theta), balls_(std::move(balls)) {}

  Event say(const steps::Started&) const {
    return {.text = "lobes", .words = {{"theta", fmt::format("{:.0f}°", theta_)}}};
  }
  Event say(const LobeDrawn& l) const {
    return {.text = l.exponent > 0 ? "lobe" : "lobe.zero",
            .facts = {{"exponent", l.exponent}, {"half", l.half}},
            .words = {{"n", l.exponent}, {"half", degrees_text(l.half)}},
            .row = {l.exponent, degrees_text(l.half)},
            .key = figure_real(l.exponent),
            .phase = words_.say("phase.lobes")};
  }
  Event say(const steps::Finished&) const {
    const auto [least, most] = std::ranges::minmax_element(all<LobeDrawn>(), {}, &LobeDrawn::exponent);
    return {.text = "lobes.finished",
            .words = {{"least", least->exponent},
                      {"most", most->exponent},
                      {"wide", degrees_text(least->half)},
                      {"narrow", degrees_text(most->half)}}};
  }

  /// Where the direction of a lamp at this angle begins.
  static dvec2 start_of(double at) { return tip(at, 0.72); }
  static constexpr int width = 38, height = 26;

  View draw() const {
    View view;
    add_ground(view, origin - dvec2{8.4, 0}, origin + dvec2{9.6, 0}, 0.9);
    const auto arrow = [&](const std::string& id, Role role, double at, const std::string& name) {
      view.add({id, role,
                Stroke{at == theta_ ? start_of(at) : origin, tip(at, at == theta_ ? 0.06 : 1.08), true}});
      view.add({id + " name", role, Text{tip(at, at == theta_ ? 0.78 : 1.14), name}});
    };
    arrow("n normal", Role::input, 0, "N");
    arrow("l way", Role::input, theta_, "L");
    arrow("r mirror", Role::measure, -theta_, "R");
    const Panel plot({{21.6, 11.4}, {35.6, 24.2}}, {{0, 0}, {90, 1}}, Panel::Fit::stretched);
    add_axes(view, plot, "p", {"α", ""}, 5);
    view.add({"q half", Role::guide, Stroke{plot.at({0, 0.5}), plot.at({90, 0.5}), false, true, true}});
    const std::size_t drawn = all<LobeDrawn>().size();
    for (std::size_t i = 0; i < drawn; ++i) add_lobe(view, plot, i);
    const double side = double(Balls::side) / cells_of_unit,
                 pitch = (width - side) / std::max(1.0, double(balls_.size()) - 1);
    const auto left = [&](std::size_t i) { return std::min(pitch, 1.3 * side) * static_cast<double>(i); };
    for (std::size_t i = 0; i < drawn; ++i)
      view.add({fmt::format("x ball {}", i), Role::guide,
                Text{{left(i) + side / 2 - 0.5, side + 0.4},
                     "n = " + figure_real(all<LobeDrawn>()[i].exponent),
                     Align::centre,
                     true}});
    view = in_cells(std::move(view));
    for (std::size_t i = 0; i < drawn; ++i)
      balls_[i].add(view, fmt::format("x ball {} picture", i), Balls::count - 1,
                    ivec2(dvec2{left(i) * cells_of_unit, 0}));
    return view;
  }

 private:
  static constexpr dvec2 origin{8.6, 10.8};
  static constexpr double length = 12.5;

  static dvec2 tip(double at, double part) { return origin + part * length * leaning(at); }
  static double lobe(double off, double n) {
    const double c = gradus::cos(off / degrees_per_radian);
    return c > 0 ? pow(c, n) : 0;
  }
  void add_lobe(View& view, const Panel& plot, std::size_t i) const {
    const auto [n, half] = all<LobeDrawn>()[i];
    const bool is_now = &all<LobeDrawn>()[i] == now<LobeDrawn>();
    const Role role = is_now ? Role::current : now<steps::Finished>() ? Role::result : Role::past;
    std::vector<dvec2> ring{origin}, curve;
    // No light leaves below the surface
    for (double way = 90; way >= -90; way -= 0.75) ring.push_back(tip(way, lobe(way + theta_, n)));
    for (double off = 0; off <= 90; off += 0.5) curve.push_back(plot.at({off, lobe(off, n)}));
    const std::string id = fmt::format("{:02}", i), number = figure_real(n);
    view.add({"b lobe " + id, role, Area{{ring}, std::min<int>(3, static_cast<int>(i) + 1)}});
    view.add({"c lobe " + id, role, Path{ring, true}});
    view.add({"c curve " + id, role, Path{curve}});
    view.add({"d half " + id, role, Dot{plot.at({half, 0.5})}});
    // Low down the curves lie farthest apart
    const double low = n > 0 ? degrees_of(pow(0.2, 1 / n)) : 90;
    view.add({"d half " + id + " name", role,
              Text{plot.at({low, 0.2}) + dvec2{0.25, 0}, i == 0 ? "n = " + number : number, Align::left}});
  }

  const Words& words_;
  const double theta_;
  const std::vector<Balls> balls_;
};

/// A ball that shows the highlight well, seen along N.
inline Balls ball_of(Subject subject, double exponent) {
  subject.eye = subject.place + subject.normal;
  subject.surface = {dvec3{0.05}, dvec3{0.35}, dvec3{0.6}, exponent};
  const Light lamp = subject.lights[0];
  const dvec3 way = towards(lamp, 0, subject.place).first;
  return Balls(subject, way - glm::dot(way, subject.normal) * subject.normal, [&](dvec3 normal) {
    return phong(subject.place, normal, subject.eye, subject.surface, std::span(&lamp, 1), dvec3{1},
                 AllSeen{});
  });
}

inline void tell_lobes(Narrator& narrator) {
  const Arguments& arguments = narrator.arguments();
  const Subject subject = subject_of(arguments);
  const auto cosine_of = [&](const Light& light) {
    return glm::dot(towards(light, 0, subject.place).first, subject.normal);
  };
  const double cosine = cosine_of(subject.lights[0]);
  if (!(cosine > 0)) refuse(arguments, {"lights", "normal"}, "expected a first lamp in front of the surface");
  lay_paper(narrator, LobeStory::width, LobeStory::height);
  narrator.trace().subtitle = narrator.words().say("lobes.subtitle");
  narrator.columns({{"n"}, {"half"}});
  narrator.legend({{Role::input, "directions"},
                   {Role::measure, "mirror"},
                   {Role::current, "lobe"},
                   {Role::past, "before"},
                   {Role::result, "lobes"}});
  std::vector<Balls> balls;
  for (const Tuple& tuple : arguments.tuples("exponents")) balls.push_back(ball_of(subject, tuple[0].value));
  LobeStory story(narrator.words(), degrees_of(cosine), std::move(balls));
  narrator.handles("lights", [&](dvec3 position) {
    const Light lamp = moved_to(position, subject.lights[0], arguments);
    return in_cells(LobeStory::start_of(degrees_of(cosine_of(lamp))));
  });
  // Of several lamps the first alone is drawn
  std::erase_if(narrator.trace().handles, [](const Handle& handle) { return handle.numbers[0] > 0; });
  narrator.tell_whole(story, [&](const auto& watch) {
    for (const Tuple& tuple : arguments.tuples("exponents")) {
      const double n = tuple[0].value;
      if (n < 0) refuse("exponents", "expected 0 or more, found {}", n);
      watch(LobeDrawn{n, n > 0 ? degrees_of(pow(0.5, 1 / n)) : 90}, 0);
    }
  });
}

}  // namespace gradus::illumination
