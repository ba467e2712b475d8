#pragma once
// One place on a surface with N, L, R and V in a plane, and the colour that its lamps add up to.

#include <optional>
#include <string>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "stories/shading/illumination/balls.hpp"

namespace gradus::illumination {

/// In units; below the vectors stand balls.
inline constexpr int place_paper_width = 32, place_paper_height = 35;

/// Part of the colour as the bar has it.
struct Piece {
  Role role;
  dvec3 value;
  bool fresh;  ///< this step's
};

/// Up, turned to the left.
inline dvec2 leaning(double degrees) {
  const double a = degrees / degrees_per_radian;
  return {-gradus::sin(a), gradus::cos(a)};
}

/// A surface and the ground below it.
inline void add_ground(View& view, dvec2 left, dvec2 right, double deep) {
  const dvec2 down{0, deep};
  view.add({"s surface", Role::boundary, Stroke{left, right}});
  view.add({"a ground", Role::boundary, Area{{{left, right, right - down, left - down}}, 1}});
}

/// What the highlight is computed from.
enum class Mirror { reflected, halfway };

/// Directions are angles from N in degrees, turned to the left. The plane is that of N and of the L at hand;
/// what lies outside it is turned into it about R (or N), so that the angles that count stay.
class PlaceDrawing {
 public:
  PlaceDrawing(const Words& words, const Subject& subject, Mirror mirror, bool from_below, double brightest)
      : words_(words),
        subject_(subject),
        mirror_(mirror),
        from_below_(from_below),
        origin_(10.7, (with_range() ? 13 : 9.6) + (from_below ? 9.6 : 0)),
        length_(from_below ? 10.2 : 11.6),
        brightest_(brightest) {
    // The first lamp that has a side stands on the left
    for (const Light& light : subject.lights) {
      const dvec3 l = towards(light, 0, subject.place).first;
      left_ = unit_vector(l - glm::dot(l, subject.normal) * subject.normal);
      if (glm::length(left_) > 0.5) break;
    }
    const dvec3 v = unit_vector(subject.eye - subject.place);
    if (glm::length(left_) < 0.5) left_ = -unit_vector(v - glm::dot(v, subject.normal) * subject.normal);
  }

  /// Where the first drawing has a lamp, and the tip of the view vector to an eye; nothing for what lies in
  /// the place itself.
  std::optional<dvec2> lamp_at(const Light& light) const {
    const dvec3 l = towards(light, 0, subject_.place).first;
    return l == dvec3{0} ? std::nullopt : std::optional(in_cells(lamp_tip(angle(l))));
  }
  std::optional<dvec2> eye_at(dvec3 eye) const {
    const dvec3 v = unit_vector(eye - subject_.place);
    return v == dvec3{0} ? std::nullopt : std::optional(in_cells(tip(angle(v), 1)));
  }
  dvec3 left() const { return left_; }
  /// Whether it reaches below the surface, where lamps are or a range is drawn.
  bool is_high() const { return from_below_ || with_range(); }

  /// The drawing in cells, and below it the terms as balls: ambient + scattered + highlight = sum.
  View with_balls(View view, const Balls& balls) const {
    constexpr double side = double(Balls::side) / cells_of_unit, pitch = (place_paper_width - side) / 3;
    constexpr std::array<const char*, Balls::count> names{"legend.ambient", "legend.scattered",
                                                          "legend.highlight", "column.sum"};
    if (balls.empty()) return in_cells(std::move(view));
    for (std::size_t k = 0; k < Balls::count; ++k) {
      const double left = pitch * static_cast<double>(k);
      const std::string id = fmt::format("x ball {}", k);
      view.add({id + " name", Role::guide,
                Text{{left + side / 2 - 0.5, side + 0.4}, words_.say(names[k]), Align::centre, true}});
      if (k > 0)
        view.add(
            {id + " sign", Role::guide,
             Text{
                 {left - (pitch - side) / 2 - 0.5, side / 2 - 0.5}, k < 3 ? "+" : "=", Align::centre, true}});
    }
    view = in_cells(std::move(view));
    for (std::size_t k = 0; k < Balls::count; ++k) {
      const ivec2 corner(dvec2{pitch * static_cast<double>(k) * cells_of_unit, 0});
      balls.add(view, fmt::format("x ball {} picture", k), k, corner);
      if (!balls.own()) continue;
      Path ring{{}, true, false, true};
      for (int i = 0; i < 24; ++i)
        ring.points.push_back(dvec2(corner) + *balls.own() - 0.5 + 3.5 * leaning(15 * i));
      view.add({fmt::format("x ball {} place", k), Role::input, std::move(ring)});
    }
    return view;
  }

  /// The angle of a direction, on its side.
  double angle(const dvec3& way) const {
    const double from_n = degrees_of(glm::dot(way, subject_.normal));
    return glm::dot(way, left_) < -1e-9 ? -from_n : from_n;
  }

  void add_surface(View& view) const {
    add_ground(view, origin_ - dvec2{11, 0}, origin_ + dvec2{11, 0}, from_below_ ? 0.7 : 1.1);
    arrow(view, "n normal", Role::input, 0, "N");
    view.add({"n place", Role::input, Dot{origin_}});
  }

  /// Lamps that are not at hand.
  void add_lamps(View& view, std::size_t at_hand) const {
    for (std::size_t i = 0; i < subject_.lights.size(); ++i) {
      if (i == at_hand) continue;
      const dvec3 l = towards(subject_.lights[i], 0, subject_.place).first;
      if (l == dvec3{0}) continue;
      const Role role = at_hand != none && i < at_hand ? Role::past : Role::candidate;
      add_lamp(view, fmt::format("l lamp {}", i), role, angle(l), i, true);
    }
  }

  /// L to the lamp at hand, and what of its light arrives.
  void add_way(View& view, const LampTaken<double>& t, const Light& light) const {
    if (t.arrival.to_light == dvec3{0}) return;
    const double at = angle(t.arrival.to_light);
    arrow(view, "l way", Role::current, at, "L");
    add_lamp(view, "l lamp", Role::current, at, t.light, false);
    if (light.kind == Light::Kind::spot) add_cone(view, t, light);
    if (light.kind == Light::Kind::point && light.range < 1e300) add_range(view, t, light);
  }

  /// The angle between N and L, and N.L along N.
  void add_scattered(View& view, const LightAdded<double>& s, Role role) const {
    if (s.arrival.to_light == dvec3{0}) return;
    const double at = angle(s.arrival.to_light);
    arc(view, "g theta", role, 0, at, 0.3);
    foot(view, "f diffuse", role, 0, s.n_dot_l, tip(at, 1), fmt::format("N·L = {}", short_real(s.n_dot_l)));
  }

  /// R or H, V, the angle between the two that count, and the lobe of the highlight.
  void add_mirrored(View& view, const LightAdded<double>& s, Role role, double power) const {
    const dvec3 v = unit_vector(subject_.eye - subject_.place);
    if (v == dvec3{0} || s.mirror == dvec3{0} || s.arrival.to_light == dvec3{0}) return;
    const bool reflects = mirror_ == Mirror::reflected;
    const double theta = angle(s.arrival.to_light), off = degrees_of(s.cosine);
    const double flat = flat_angle(reflects ? v : s.mirror, s.arrival.to_light, theta);
    // H lies halfway between L and V
    const double axis = reflects ? -theta : flat < 0 ? -off : off;
    const double seen = reflects ? axis + (wrapped(flat - axis) < 0 ? -off : off) : 2 * axis - theta;
    const std::string product = reflects ? "R·V" : "N·H";
    const double part = s.cosine > 0 ? gradus::pow(s.cosine, power) : 0;
    const auto size = [&](double way) {
      return gradus::pow(cosine(reflects ? way - axis : 0.5 * (way + theta)), power);
    };
    if (!reflects || s.cosine > 0) {
      lobe(view, role, size);
      // Where it is half as long as its middle, on the side where V isn't
      const double half = std::min(30.0, degrees_of(gradus::pow(0.5, 1 / std::max(power, 1.0))));
      const double side = -theta + (wrapped(seen + theta) > 0 ? -half : half);
      view.add({"b lobe name", role,
                Label{tip(side, size(side) + 0.06), "(" + product + ")ⁿ = " + short_real(part)}});
    }
    arrow(view, "r mirror", role, axis, reflects ? "R" : "H");
    add_viewer(view, seen);
    const double from = reflects ? axis : 0, to = reflects ? seen : axis;
    arc(view, "g alpha", role, from, to, 0.42);
    foot(view, "f specular", role, from, s.cosine, tip(to, 1), product + " = " + short_real(s.cosine));
    if (part > 0.02) view.add({"p reached", role, Dot{tip(seen, part), true}});
  }

  void add_viewer(View& view, double at) const { arrow(view, "v view", Role::input, at, "V"); }
  /// V before any lamp is at hand.
  void add_viewer(View& view) const {
    const dvec3 v = unit_vector(subject_.eye - subject_.place);
    if (v != dvec3{0}) add_viewer(view, angle(v));
  }
  /// The direction that is right, where the method has another.
  void add_right_way(View& view, const dvec3& l) const {
    view.add({"l right", Role::accepted, Stroke{origin_, tip(angle(l), 1), true, true}});
    view.add({"l right name", Role::accepted, Label{tip(angle(l), 0.97), words_.say("right")}});
  }

  /// The colour so far: a bar of its parts, for each channel where they differ.
  /// right: what the colour ought to be, if that is to be shown.
  void add_colour(View& view, const std::vector<Piece>& pieces, const std::optional<dvec3>& right) const {
    dvec3 sum{0};
    bool grey = true;
    for (const Piece& p : pieces) {
      sum += p.value;
      grey = grey && !(p.value.x != p.value.y || p.value.y != p.value.z);
    }
    if (right) grey = grey && right->x == right->y && right->y == right->z;
    if (!(sum.x == sum.x)) grey = true;
    const double x = 27.4, wide = grey ? 3.2 : 1, pitch = 1.15;
    for (int c = 0; c < (grey ? 1 : 3); ++c) {
      add_bar(view, pieces, c, x + pitch * c, wide, grey);
      if (!right) continue;
      const Extent bar{{x + pitch * c - 0.15, height(0)}, {x + pitch * c + wide + 0.15, height((*right)[c])}};
      view.add({fmt::format("w right {}", c), Role::accepted, Path{bar.corners(), true, true}});
    }
    const double step = tick_distance(brightest_, 3);  // between the numbers there is room for R·V
    for (int k = 0; k * step <= brightest_; ++k) {
      view.add({fmt::format("t tick {}", k), Role::guide,
                Text{{x - 0.4, height(k * step)}, short_real(k * step), Align::right}});
    }
    view.add({"t scale", Role::guide, Stroke{{x - 0.15, height(0)}, {x - 0.15, height(brightest_)}}});
    view.add({"t frame", Role::guide, Stroke{{x - 0.2, height(0)}, {x + (grey ? 3.4 : 4.1), height(0)}}});
    view.add({"t sum", Role::guide,
              Text{{x + (grey ? 1.6 : 1.9), height(brightest_) + 1.3},
                   words_.say("sum", {{"colour", short_colour(sum)}})}});
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

 private:
  /// Whether a lamp's range is drawn, below the ground.
  bool with_range() const {
    return std::ranges::any_of(subject_.lights, [](const Light& light) {
      return light.kind == Light::Kind::point && light.range < 1e300;
    });
  }
  static double cosine(double degrees) { return std::max(0.0, gradus::cos(degrees / degrees_per_radian)); }
  static double wrapped(double degrees) { return degrees - 360 * std::round(degrees / 360); }
  dvec2 tip(double degrees, double part) const { return origin_ + part * length_ * leaning(degrees); }
  dvec2 lamp_tip(double at) const { return tip(at, 1.06); }
  /// A lamp with its name on the far side.
  void add_lamp(View& view, const std::string& id, Role role, double at, std::size_t i, bool ring) const {
    const dvec2 lamp = lamp_tip(at);
    const bool left = lamp.x < origin_.x - 0.5;
    view.add({id, role, Dot{lamp, ring}});
    view.add({id + " name", role,
              Text{lamp + dvec2{left ? -0.6 : 0.6, 0.1}, words_.say("lamp", {{"number", i + 1}}),
                   left ? Align::right : Align::left}});
  }
  /// A direction's angle within the plane of N and L, before it is turned.
  double flat_angle(const dvec3& way, const dvec3& l, double theta) const {
    const dvec3 aside = unit_vector(l - glm::dot(l, subject_.normal) * subject_.normal);
    const double side = theta < 0 ? -1 : 1;
    const double across = glm::length(aside) > 0.5 ? side * glm::dot(way, aside) : glm::dot(way, left_);
    return gradus::atan2(across, glm::dot(way, subject_.normal)) * degrees_per_radian;
  }
  void arrow(View& view, const std::string& id, Role role, double at, const std::string& name) const {
    view.add({id, role, Stroke{origin_, tip(at, 1), true}});
    view.add({id + " name", role, Label{tip(at, 0.93), name}});
  }
  void arc(View& view, const std::string& id, Role role, double from, double to, double part) const {
    if (std::abs(to - from) < 1) return;
    Path path;
    for (int k = 0; k <= 24; ++k) path.points.push_back(tip(from + (to - from) * k / 24, part));
    view.add({id, role, path});
    view.add({id + " name", role,
              Text{tip(0.5 * (from + to), part + 0.09), fmt::format("{:.0f}°", std::abs(to - from))}});
  }
  /// The cosine of a direction as a length along another, and the right angle down to it.
  void foot(View& view, const std::string& id, Role role, double along, double length, dvec2 from,
            const std::string& text) const {
    const dvec2 at = tip(along, length);
    view.add({id + " down", role, Stroke{from, at, false, true, true}});
    view.add({id, role, Stroke{origin_, at}});
    view.add({id + " at", role, Dot{at}});
    view.add({id + " value", role, Label{at, text}});
  }
  template <class Size>
  void lobe(View& view, Role role, const Size& size) const {
    std::vector<dvec2> ring{origin_};
    for (double way = 90; way >= -90; way -= 1.5) ring.push_back(tip(way, size(way)));
    view.add({"b lobe", role, Area{{ring}, 2}});
  }
  void add_cone(View& view, const LampTaken<double>& t, const Light& light) const {
    const double l = angle(t.arrival.to_light);
    const dvec2 lamp = lamp_tip(l);
    // To the side of the place on which it points
    const bool left = glm::dot(unit_vector(light.direction) + t.arrival.to_light, left_) > 0;
    const double off = (left ? -1 : 1) * off_axis(light, t.arrival), outer = degrees_of(light.outer_cosine);
    const double length = (left ? 0.45 : 1) * length_;  // there the paper ends sooner
    const auto way = [&](double turned) { return lamp + length * leaning(l + 180 + turned); };
    const Role role = t.arrival.cone > 0 ? Role::boundary : Role::rejected;
    std::vector<dvec2> ring{lamp};
    for (int k = -12; k <= 12; ++k) ring.push_back(way(off + outer * k / 12));
    view.add({"c cone", role, Area{{ring}, 1}});
    view.add({"c left", role, Stroke{lamp, way(off - outer), false, true}});
    view.add({"c right", role, Stroke{lamp, way(off + outer), false, true}});
    view.add({"c axis", role, Stroke{lamp, way(off), true, true, true}});
  }
  void add_range(View& view, const LampTaken<double>& t, const Light& light) const {
    const double most = 1.15 * std::max(light.range, t.arrival.distance);
    const double y = 10.2;
    const NumberLine line({1.5, y}, {21, y}, 0, most);
    line.add_to(view, "d", "d");
    const Role role = t.arrival.window > 0 ? Role::current : Role::rejected;
    view.add({"d way", role, Stroke{line.at(0), line.at(t.arrival.distance)}});
    view.add_named("d lamp", role, line.at(t.arrival.distance), "d");
    view.add({"d end", Role::boundary,
              Stroke{line.at(light.range) - dvec2{0, 0.7}, line.at(light.range) + dvec2{0, 0.7}}});
    view.add(
        {"d end name", Role::boundary, Label{line.at(light.range) + dvec2{0, 0.7}, words_.say("range")}});
  }

  double height(double value) const {
    return origin_.y + (from_below_ ? -8 : 0) + (from_below_ ? 18 : 12) * value / brightest_;
  }
  void add_bar(View& view, const std::vector<Piece>& pieces, int channel, double x, double wide,
               bool grey) const {
    double top = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const double value = pieces[i].value[channel];
      const double from = std::clamp(top, 0.0, brightest_), to = std::clamp(top + value, 0.0, brightest_);
      if (!(std::abs(value) > 0)) continue;
      top += value;
      if (!(std::abs(value) > 0.004 * brightest_)) continue;
      const Role role = value < 0 ? Role::rejected : pieces[i].role;
      // What is taken away stands beside what was there
      const double left = value < 0 ? x + wide + 0.3 : x, right = value < 0 ? left + 0.8 : x + wide;
      const std::vector<dvec2> ring = Extent{{left, height(from)}, {right, height(to)}}.corners();
      const std::string id = fmt::format("u {} {:02}", channel, i);
      view.add({id, role, Area{{ring}, pieces[i].fresh ? 3 : 2}});
      view.add({id + " edge", role, Path{ring, true}});
      if (grey && value > 0 && std::abs(height(to) - height(from)) > 1.2)
        view.add({id + " value", role,
                  Text{{x + 0.5 * wide, 0.5 * (height(from) + height(to))}, short_real(value)}});
    }
    if (grey) return;
    constexpr std::array<const char*, 3> names{"R", "G", "B"};
    view.add({fmt::format("t channel {}", channel), Role::guide,
              Text{{x + 0.5 * wide, height(0) - 0.9}, names[static_cast<std::size_t>(channel)]}});
  }

  const Words& words_;
  const Subject& subject_;
  const Mirror mirror_;
  const bool from_below_;
  const dvec2 origin_;
  const double length_, brightest_;
  dvec3 left_{0};
};

}  // namespace gradus::illumination
