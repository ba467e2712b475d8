#pragma once
// Arguments that strain a topic: numbers of any magnitude, equal ones, tiny differences far from 0, windows
// of no size, in every flag that takes numbers.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "stories/topic.hpp"

namespace gradus::test {

/// Makes arguments of a topic; the same seed makes the same ones.
class OddArguments {
 public:
  explicit OddArguments(std::uint64_t seed) : random_(seed) {}

  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }

  /// A method, one to three parameters at odd values, and now and then a choice or a flag.
  std::vector<Argument> of(const TopicEntry& topic) {
    std::vector<Argument> given{{"method", topic.methods[below(topic.methods.size())].name}};
    const std::size_t wanted = 1 + below(3);
    std::vector<const Parameter*> numeric, other;
    for (const Parameter& p : topic.parameters) (is_numeric(p) ? numeric : other).push_back(&p);
    std::ranges::shuffle(numeric, random_);
    numeric.resize(std::min(wanted, numeric.size()));
    // One way of being odd for all of them, so that they still have to do with each other
    const Way way = new_way();
    for (const Parameter* p : numeric) {
      if (p->instead_of.empty() || !has(given, p->instead_of)) given.push_back({p->name, value(*p, way)});
    }
    for (const Parameter* p : other) {
      if (below(4) == 0 && p->type == ParameterType::choice)
        given.push_back({p->name, p->choices[below(p->choices.size())]});
      if (below(6) == 0 && p->type == ParameterType::flag) given.push_back({p->name, "yes"});
    }
    std::erase_if(given, [&](const Argument& a) {
      return std::ranges::any_of(
          topic.parameters, [&](const Parameter& p) { return p.instead_of == a.name && has(given, p.name); });
    });
    return given;
  }

 private:
  /// What the numbers of a run have in common.
  struct Way {
    enum class Kind { scaled, shifted, independent, mixed } kind;
    double scale, shift;
  };

  static bool is_numeric(const Parameter& p) {
    switch (p.type) {
      case ParameterType::cell:
      case ParameterType::window:
      case ParameterType::integer:
      case ParameterType::number:
      case ParameterType::numbers:
      case ParameterType::bounds:
      case ParameterType::points:
      case ParameterType::rings:
      case ParameterType::faces:
      case ParameterType::factors:
        return true;
      default:
        return false;
    }
  }
  static bool has(const std::vector<Argument>& given, std::string_view name) {
    return std::ranges::find(given, name, &Argument::name) != given.end();
  }

  double magnitude() {
    constexpr std::array<double, 44> special{0,
                                             5e-324,
                                             1e-320,
                                             2.3e-308,
                                             1e-307,
                                             1e-300,
                                             1e-200,
                                             1e-162,
                                             1e-155,
                                             1e-150,
                                             1e-100,
                                             1e-50,
                                             1e-20,
                                             1e-16,
                                             1e-12,
                                             1e-9,
                                             1e-6,
                                             1e-3,
                                             0.5,
                                             1,
                                             3,
                                             1e3,
                                             1e6,
                                             1e9,
                                             1e12,
                                             1e15,
                                             9007199254740992,
                                             1e17,
                                             1e18,
                                             1e20,
                                             1e30,
                                             1e50,
                                             1e75,
                                             1e77,
                                             1e100,
                                             1e102,
                                             1e150,
                                             1e154,
                                             1e155,
                                             1e200,
                                             1e300,
                                             8e307,
                                             1e308,
                                             1.7976931348623157e308};
    const double digits = 1 + static_cast<double>(below(900)) / 100;
    // Any size at all, sizes that most flags take, and those of everyday
    switch (below(4)) {
      case 0:
        return special[below(special.size())];
      case 1:
        return digits * std::pow(10.0, static_cast<double>(below(631)) - 323);
      case 2:
        return digits * std::pow(10.0, static_cast<double>(below(150)) - 75);
      default:
        return digits * std::pow(10.0, static_cast<double>(below(14)) - 7);
    }
  }
  double odd() { return below(2) ? magnitude() : -magnitude(); }
  double small() { return (static_cast<double>(below(2001)) - 1000) / 100; }

  Way new_way() {
    const auto kind = static_cast<Way::Kind>(below(4));
    Way way{kind, magnitude(), 0};
    if (kind == Way::Kind::shifted) {
      way.shift = odd();
      // Differences of a few steps of a double, or of any size
      if (below(2)) way.scale = std::abs(way.shift) * std::pow(2.0, -static_cast<double>(below(60)));
    }
    return way;
  }

  static double finite(double x) {
    constexpr double most = std::numeric_limits<double>::max();
    return std::clamp(x, -most, most);
  }
  /// The number at this place, whose usual value is given.
  double number(double usual, const Way& way) {
    switch (way.kind) {
      case Way::Kind::scaled:
        return finite(usual * way.scale);
      case Way::Kind::shifted:
        return finite(way.shift + (below(3) ? usual : small()) * way.scale);
      case Way::Kind::independent:
        return below(4) == 0 ? usual : odd();
      case Way::Kind::mixed:
        break;
    }
    return below(4) == 0 ? odd() : below(3) == 0 ? small() : usual;
  }
  static std::string text(double x) { return fmt::format("{}", x); }

  std::string value(const Parameter& p, const Way& way) {
    switch (p.type) {
      case ParameterType::cell:
        return fmt::format("{},{}", integer(p), integer(p));
      case ParameterType::window: {
        const std::int64_t a = integer(p), b = integer(p), c = integer(p), d = integer(p);
        return fmt::format("{},{},{},{}", std::min(a, b), std::min(c, d), std::max(a, b), std::max(c, d));
      }
      case ParameterType::integer:
        return fmt::format("{}", integer(p));
      case ParameterType::number: {
        const auto usual = numbers_in(usual_of(p));
        const double least = static_cast<double>(p.least), most = static_cast<double>(p.most);
        return text(std::clamp(number(usual.empty() ? 1 : usual[0], way), least, most));
      }
      case ParameterType::numbers:
      case ParameterType::bounds: {
        std::vector<double> values = tuple(p, numbers_in(usual_of(p)), 0, way);
        if (p.type == ParameterType::bounds) order(values);
        return joined(values);
      }
      case ParameterType::points:
        return points(p, way, static_cast<std::size_t>(std::max<std::int64_t>(p.least, 1)),
                      static_cast<std::size_t>(std::min<std::int64_t>(p.most, 7)));
      case ParameterType::rings:
        return below(3) ? points(p, way, 3, 6) : points(p, way, 3, 4) + "; " + points(p, way, 3, 4);
      case ParameterType::faces:
        return below(3) ? faces(p, way, 1) : faces(p, way, 3);
      case ParameterType::factors:
        return factors(p, way);
      default:
        return p.default_value;
    }
  }

  static std::string usual_of(const Parameter& p) {
    return p.default_value.empty() ? p.example : p.default_value;
  }
  /// All numbers of a text, with anything between them.
  static std::vector<double> numbers_in(std::string_view text) {
    std::vector<double> found;
    const std::string all(text);
    for (const char* at = all.c_str(); *at != '\0';) {
      char* end = nullptr;
      const double x = std::strtod(at, &end);
      if (end == at || !std::isfinite(x)) {
        ++at;
        continue;
      }
      found.push_back(x);
      at = end;
    }
    return found;
  }
  std::int64_t integer(const Parameter& p) {
    const auto span = static_cast<std::uint64_t>(p.most - p.least) + 1;
    switch (below(5)) {
      case 0:
        return p.least;
      case 1:
        return p.most;
      case 2:
        return p.least + static_cast<std::int64_t>(random_() % span);
      case 3:
        return std::clamp<std::int64_t>(static_cast<std::int64_t>(below(200)) - 100, p.least, p.most);
      default: {
        const auto usual = numbers_in(usual_of(p));
        return std::clamp<std::int64_t>(usual.empty() ? 1 : static_cast<std::int64_t>(usual[0]), p.least,
                                        p.most);
      }
    }
  }
  std::vector<double> tuple(const Parameter& p, const std::vector<double>& usual, std::size_t first,
                            const Way& way) {
    std::vector<double> values;
    const bool same = below(8) == 0;  // all its numbers are one
    for (std::size_t i = 0; i < p.parts.size(); ++i) {
      const double u = first + i < usual.size() ? usual[first + i] : small();
      values.push_back(same && i > 0 ? values[0] : number(u, way));
    }
    return values;
  }
  static void order(std::vector<double>& values) {
    const std::size_t half = values.size() / 2;
    for (std::size_t i = 0; i < half; ++i) {
      if (values[i] > values[half + i]) std::swap(values[i], values[half + i]);
    }
  }
  static std::string joined(const std::vector<double>& values) {
    std::string all;
    for (const double x : values) all += (all.empty() ? "" : ",") + text(x);
    return all;
  }
  std::string points(const Parameter& p, const Way& way, std::size_t least, std::size_t most) {
    const std::vector<double> usual = numbers_in(usual_of(p));
    const std::size_t size = p.parts.size();
    std::size_t count = usual.size() / size;
    if (below(3) == 0 || count < least || count > most) count = least + below(most - least + 1);
    std::string all, last;
    for (std::size_t i = 0; i < count; ++i) {
      const std::string point =
          below(12) == 0 && !last.empty() ? last : joined(tuple(p, usual, i * size, way));
      all += (all.empty() ? "" : " ") + point;
      last = point;
    }
    return all;
  }
  std::string faces(const Parameter& p, const Way& way, std::size_t count) {
    std::string all;
    // Others than triangles are bent, as a rule, and refused for that
    for (std::size_t i = 0; i < count; ++i) all += (i == 0 ? "" : "; ") + points(p, way, 3, below(3) ? 3 : 5);
    return all;
  }
  std::string factors(const Parameter& p, const Way& way) {
    const bool space = p.parts.size() == 3;
    const auto vector = [&] { return joined(tuple(p, {2, 1, 3}, 0, way)); };
    const auto one = [&] { return text(number(30, way)); };
    std::string all;
    const std::size_t count = 1 + below(3);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t kind = below(space ? 3 : 5);
      std::string factor;
      if (kind == 0) factor = "translate " + vector();
      if (kind == 1)
        factor = "scale " + (below(2) ? one() : vector()) + (below(2) ? " about " + vector() : "");
      if (kind == 2 && space)
        factor = "rotate " + one() + " about " + vector() + (below(2) ? " through " + vector() : "");
      if (kind == 2 && !space) factor = "rotate " + one() + (below(2) ? " about " + vector() : "");
      if (kind == 3) factor = "shear " + vector() + (below(2) ? " about " + vector() : "");
      if (kind == 4) factor = "reflect " + vector() + " " + vector();
      all += (all.empty() ? "" : "; ") + factor;
    }
    return all;
  }

  std::mt19937_64 random_;
};

}  // namespace gradus::test
