// How finely depth is stored: the smallest step that a depth buffer tells apart, against distance.

#include "core/arithmetic/elementary.hpp"
#include "stories/past.hpp"
#include "stories/projection/perspective/stories.hpp"

namespace gradus::perspective {
namespace {

struct Kind {
  DepthCurve curve;
  DepthFormat format;
  std::string_view name;  ///< of its texts
  Role role;              ///< of its curve: no two look alike
  bool dashed;
  double where;  ///< its name stands, in parts of the scale, beside the curve
  dvec2 beside;
  Align align;
};
constexpr std::array kinds{Kind{DepthCurve::linear,
                                DepthFormat::fixed24,
                                "linear_fixed",
                                Role::input,
                                true,
                                0.06,
                                {0, 0.9},
                                Align::left},
                           Kind{DepthCurve::inverse,
                                DepthFormat::fixed24,
                                "inverse_fixed",
                                Role::result,
                                false,
                                0.8,
                                {-0.6, 0.7},
                                Align::right},
                           Kind{DepthCurve::inverse,
                                DepthFormat::float32,
                                "inverse_float",
                                Role::candidate,
                                true,
                                0.7,
                                {0.5, -0.7},
                                Align::left},
                           Kind{DepthCurve::reversed,
                                DepthFormat::float32,
                                "reversed_float",
                                Role::accepted,
                                false,
                                0.6,
                                {0.4, -1.1},
                                Align::left}};

/// log10, rounded where it is as good as a whole number.
double decade(double value) {
  const double exact = gradus::log(value) / gradus::log(10.0);
  const double whole = std::round(exact);
  return std::abs(exact - whole) < 1e-9 ? whole : exact;
}

/// "100", "0.01", "10⁵".
std::string power_text(int exponent, int plain = 3) {
  if (-plain <= exponent && exponent <= plain) {
    return exponent < 0 ? "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + "1"
                        : "1" + std::string(static_cast<std::size_t>(exponent), '0');
  }
  constexpr std::string_view digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char c : fmt::format("{}", std::abs(exponent))) text += digits[c - '0'];
  return text;
}

/// A power of ten as one, all else as figures show it.
std::string short_depth(double z) {
  if (!(z > 0)) return figure_real(z);
  const double exponent = decade(z);
  return exponent == std::round(exponent) ? power_text(static_cast<int>(exponent)) : figure_real(z);
}

/// Three significant digits: "5.96·10⁻⁸", "0.0596", "596", "59605".
std::string step_text(double step) {
  if (step >= 1000) return step < 1e7 ? with_note(fmt::format("{:.0f}", step), step) : figure_real(step);
  if (step >= 1e-3) return with_note(fmt::format("{:.3g}", step), step);
  const std::string text = fmt::format("{:.2e}", step);
  const std::size_t e = text.find('e');
  std::string mantissa = text.substr(0, e);
  mantissa.erase(mantissa.find_last_not_of('0') + 1);
  if (mantissa.ends_with('.')) mantissa.pop_back();
  int power = 0;
  for (const char c : text.substr(e + 2)) power = 10 * power + (c - '0');
  const double unit = std::strtod(("1" + text.substr(e)).c_str(), nullptr);
  return (mantissa == "1" ? "" : with_note(mantissa, step / unit) + "·") + power_text(-power, 0);
}

/// The curve of one kind is complete.
struct Curve {};

constexpr int fine_points = 7, curve_points = 241;
constexpr std::array table_places{2, 3, 5, 6};  ///< of the fine points

class DepthStory : public Past<steps::Started, Finer<Resolved>, Curve, steps::Finished> {
 public:
  DepthStory(const Words& words, double near, double far) : words_(words), near_(near), far_(far) {
    const double left = decade(near_), right = decade(far_);
    // Right at its 0 a float curve is finer than any scale shows
    const double bottom = decade(step_at(kinds[1], near_)), top = decade(step_at(kinds[1], far_));
    panel_ = Panel({{4, 3.6}, {35, 21.8}}, {{left, std::floor(bottom)}, {right, std::ceil(top)}},
                   Panel::Fit::stretched);
  }

  /// The i-th of so many depths, in equal ratios.
  double place(int i, int count) const {
    if (i == 0) return near_;
    if (i == count - 1) return far_;
    const double share = static_cast<double>(i) / (count - 1);
    const double z = near_ * gradus::exp(share * gradus::log(far_ / near_));
    // A round number where it is meant to be one
    const double scale = decade(z);
    const double round = std::round(z);
    return scale == std::round(scale) && std::abs(round - z) < 1e-9 * z ? round : std::clamp(z, near_, far_);
  }

  Event say(const steps::Started&) const {
    return {.text = "started.depth_precision",
            .words = {{"near", short_depth(near_)}, {"far", short_depth(far_)}},
            .level = Level::idea};
  }

  Event say(const Resolved& r) const {
    return {.text = "resolved",
            .facts =
                {{"stored", key()}, {"z", r.z}, {"depth", r.depth}, {"spacing", r.spacing}, {"step", r.step}},
            .words = {{"z", short_depth(r.z)},
                      {"spacing", step_text(r.spacing)},
                      {"slope", step_text(r.slope)},
                      {"step", step_text(r.step)}},
            .key = key(),
            .phase = name_of_kind(turn())};
  }

  Event say(const Curve&) const {
    const Kind& kind = kinds[turn()];
    Event event{.facts = {{"stored", key()}},
                .sentence = words_.say("curve." + key(), {{"first", step_text(step_at(kind, near_))},
                                                          {"last", step_text(step_at(kind, far_))}}),
                .row = {name_of_kind(turn())},
                .key = key(),
                .phase = name_of_kind(turn())};
    for (const int i : table_places) event.row.push_back(table_text(step_at(kind, place(i, fine_points))));
    return event;
  }

  Event say(const steps::Finished&) const { return {.text = "done.depth_precision"}; }

  /// All curves up to this one; of this one the points so far, and the curve through them.
  View draw() const {
    View seen;
    add_scales(seen);
    const std::size_t at_hand = now<steps::Finished>() ? kinds.size() : turn();
    const auto points = std::span(all<Resolved>()).subspan(at_hand * fine_points);
    for (std::size_t i = 0; i < kinds.size() && i <= at_hand; ++i) {
      const bool current = i == at_hand;
      if (current && points.empty()) break;
      const double end = current ? points.back().z : far_;
      std::vector<dvec2> curve;
      for (int k = 0; k < curve_points; ++k) {
        const double z = place(k, curve_points);
        if (z <= end) curve.push_back(at(z, step_at(kinds[i], z)));
      }
      const Kind& kind = kinds[i];
      seen.add({fmt::format("c curve {}", i), kind.role, Path{curve, false, kind.dashed}});
      const double where = near_ * gradus::exp(kind.where * gradus::log(far_ / near_));
      if (!current || end == far_) {
        const dvec2 beside = at(where, step_at(kind, where)) + kind.beside;
        seen.add({fmt::format("f name {}", i), kind.role, Text{beside, name_of_kind(i), kind.align}});
      }
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
      seen.add({fmt::format("e point {}", k), kinds[turn()].role,
                Dot{at(points[k].z, points[k].step), k + 1 < points.size()}});
    }
    return seen;
  }

 private:
  std::string key() const { return std::string(kinds[turn()].name); }
  std::string name_of_kind(std::size_t i) const { return words_.say("stored." + std::string(kinds[i].name)); }
  /// Three digits; what lies below the scale is said to.
  std::string table_text(double step) const {
    const int bottom = static_cast<int>(panel_.shown().lower.y);
    return decade(step) < bottom ? "< " + power_text(bottom) : step_text(step);
  }
  double step_at(const Kind& kind, double z) const {
    return separable_step(kind.curve, kind.format, near_, far_, z);
  }
  dvec2 at(double z, double step) const {
    const Extent& shown = panel_.shown();
    return panel_.at({decade(z), std::clamp(decade(step), shown.lower.y, shown.upper.y)});
  }

  void add_scales(View& seen) const {
    const Extent shown = panel_.shown(), place = panel_.place();
    const auto mark = [&](std::string id, auto shape) {
      seen.add({"a " + id, Role::guide, std::move(shape)});
    };
    mark("x", Stroke{place.lower, {place.upper.x, place.lower.y}});
    mark("y", Stroke{place.lower, {place.lower.x, place.upper.y}});
    const int left = static_cast<int>(std::ceil(shown.lower.x - 1e-9));
    const int right = static_cast<int>(std::floor(shown.upper.x + 1e-9));
    for (int e = left; e <= right; ++e) {
      const dvec2 foot = panel_.at({static_cast<double>(e), shown.lower.y});
      mark(fmt::format("x tick {}", e), Stroke{foot, foot - dvec2{0, 0.4}});
      if ((e - left) % ((right - left) / 7 + 1) == 0)
        mark(fmt::format("x value {}", e), Text{foot - dvec2{0, 1.3}, power_text(e)});
    }
    const int bottom = static_cast<int>(shown.lower.y), top = static_cast<int>(shown.upper.y);
    for (int e = bottom; e <= top; ++e) {
      const dvec2 foot = panel_.at({shown.lower.x, static_cast<double>(e)});
      mark(fmt::format("y tick {}", e), Stroke{foot, foot - dvec2{0.4, 0}});
      if ((e - bottom) % ((top - bottom) / 8 + 1) == 0)
        mark(fmt::format("y value {}", e), Text{foot - dvec2{0.7, 0}, power_text(e), Align::right});
    }
    mark("z name", Text{{place.upper.x, place.lower.y - 2.7}, words_.say("depth_axis"), Align::right});
    mark("step name", Text{{0.5, place.upper.y + 1.2}, words_.say("step_axis"), Align::left});
  }

  const Words& words_;
  const double near_, far_;
  Panel panel_{{{0, 0}, {1, 1}}, {{0, 0}, {1, 1}}};
};

}  // namespace

void tell_depth_precision(Narrator& narrator) {
  const std::vector<double> planes = narrator.arguments().numbers("range");
  const double near = planes[0], far = planes[1];
  if (!(0 < near && 10 * near <= far && far <= 1e12 * near)) {
    refuse("range", "expected 0 < near and a far plane 10 to 1e12 times as far, not {},{}", near, far);
  }
  const Words& words = narrator.words();
  DepthStory story(words, near, far);
  narrator.subtitle("subtitle.range", {{"near", short_depth(near)}, {"far", short_depth(far)}});
  narrator.paper(solids::paper_width, paper_height);
  narrator.columns({{"stored", false}});
  for (const int i : table_places) {
    const std::string depth = short_depth(story.place(i, fine_points));
    narrator.trace().columns.push_back(
        {fmt::format("step_{}", i), true, without_notes(words.say("at_depth", {{"z", depth}}))});
  }
  narrator.telling({std::ssize(kinds), 0});  // when all four can be compared
  narrator.tell_each(story, kinds.size(), [&](std::size_t kind, const auto& watch) {
    for (int i = 0; i < fine_points; ++i) {
      separable_step(kinds[kind].curve, kinds[kind].format, near, far, story.place(i, fine_points), watch);
    }
    watch(Curve{}, narrator.line());
  });
  narrator.result(
      {{"step_at_far", separable_step(DepthCurve::inverse, DepthFormat::fixed24, near, far, far), "step"}});
}

}  // namespace gradus::perspective
