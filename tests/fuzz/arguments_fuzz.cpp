// What people give for a parameter, for every parameter of every topic: the canonical spelling reads as
// itself and can be used, and numbers are the nearest doubles.

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/contract.hpp"
#include "stories/factor_text.hpp"
#include "stories/point_text.hpp"
#include "stories/topic.hpp"
#include "support/clip_oracle.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using gradus::test::require;
using Rational = boost::multiprecision::cpp_rational;

namespace {

const std::vector<const Parameter*>& parameters() {
  static const std::vector<const Parameter*> all = [] {
    std::vector<const Parameter*> found;
    for (const TopicEntry* topic : catalogue()) {
      for (const Parameter& parameter : topic->parameters) found.push_back(&parameter);
    }
    return found;
  }();
  return all;
}

/// What topics do with a canonical value.
void use(const Parameter& parameter, const std::string& text) {
  Arguments arguments;
  arguments.set(read_argument(parameter, text));
  switch (parameter.type) {
    case ParameterType::cell:
      static_cast<void>(arguments.cell(parameter.name));
      break;
    case ParameterType::window: {
      const auto window = arguments.window(parameter.name);
      require(window && window->lower.x <= window->upper.x && window->lower.y <= window->upper.y,
              "a window is the right way round");
      break;
    }
    case ParameterType::flag:
      require(arguments.flag(parameter.name) == (text == "yes"), "a flag is given or not");
      break;
    case ParameterType::integer: {
      const std::int64_t value = arguments.integer(parameter.name);
      require(parameter.least <= value && value <= parameter.most, "a number is in its range");
      break;
    }
    case ParameterType::number: {
      const auto value = arguments.number(parameter.name);
      require(value && static_cast<double>(parameter.least) <= *value &&
                  *value <= static_cast<double>(parameter.most),
              "a number is in its range");
      break;
    }
    case ParameterType::numbers:
    case ParameterType::bounds: {
      const auto values = arguments.numbers(parameter.name);
      require(values.size() == parameter.parts.size(), "there are as many numbers as parts");
      for (const double value : values) require(std::isfinite(value), "numbers are finite");
      if (parameter.type == ParameterType::numbers) break;
      for (std::size_t i = 0; i < values.size() / 2; ++i) {
        require(values[i] <= values[i + values.size() / 2], "bounds are the right way round");
      }
      break;
    }
    case ParameterType::points: {
      const std::size_t count = arguments.tuples(parameter.name).size();
      if (parameter.parts.size() == 2)
        require(arguments.points(parameter.name).size() == count, "points of the plane");
      if (parameter.parts.size() == 3)
        require(arguments.places(parameter.name).size() == count, "points of space");
      require(static_cast<std::int64_t>(count) >= parameter.least &&
                  static_cast<std::int64_t>(count) <= parameter.most,
              "there are as many points as allowed");
      break;
    }
    case ParameterType::order:
      require(arguments.order(parameter.name).size() == parameter.choices.size(), "an order has all of them");
      break;
    case ParameterType::color:
      static_cast<void>(arguments.color(parameter.name));
      break;
    default:
      break;
  }
}

/// A number as written, in rationals: digits, a point, an exponent. Only for what read_number accepts.
Rational written(std::string_view text) {
  using boost::multiprecision::cpp_int;
  if (const std::size_t slash = text.find('/'); slash != std::string_view::npos) {
    return written(text.substr(0, slash)) / written(text.substr(slash + 1));
  }
  cpp_int digits = 0;
  long exponent = 0;
  bool negative = false, point = false;
  std::size_t i = 0;
  for (; i < text.size() && text[i] != 'e' && text[i] != 'E'; ++i) {
    if (text[i] == '-') negative = true;
    if (text[i] == '.') point = true;
    if (text[i] < '0' || text[i] > '9') continue;
    digits = 10 * digits + (text[i] - '0');
    exponent -= point;
  }
  if (i < text.size()) exponent += std::stol(std::string(text.substr(i + 1)));
  const cpp_int power = pow(cpp_int(10), static_cast<unsigned>(std::abs(exponent)));
  const Rational value = exponent < 0 ? Rational(digits, power) : Rational(digits * power);
  return negative ? Rational(-value) : value;
}

void check_number(std::string_view text) {
  if (text.size() > 400) return;
  const Read<Number> read = read_number(text);
  const Number* number = std::get_if<Number>(&read);
  if (!number) {
    require(test::harmless(std::get<Misread>(read).what), "an error is safe to show");
    return;
  }
  const Rational exact = written(trimmed(text));
  if (std::abs(number->value) < 1e308)
    require(test::is_nearest(number->value, exact), "a number is the nearest double");
  if (number->exact) {
    require(Rational(number->exact->numerator) / number->exact->denominator == exact, "a fraction is exact");
  }
  const Read<Number> again = read_number(number->text);
  require(std::holds_alternative<Number>(again) && std::get<Number>(again).value == number->value &&
              std::get<Number>(again).text == number->text,
          "the canonical number reads as itself");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  require(test::harmless(shown(text)), "a text in a message is safe to show");
  check_number(text);
  const Parameter& parameter = *parameters()[data[0] % parameters().size()];
  try {
    const std::string once = canonical(parameter, text);
    require(canonical(parameter, once) == once, "the canonical spelling reads as itself");
    use(parameter, once);
  } catch (const ArgumentError& error) {
    require(error.parameter == parameter.name, "an error names its parameter");
    require(test::harmless(error.what()), "an error is safe to show");
  }
  return 0;
}
