#pragma once
// Segments, windows and boxes among the arguments, and what their axes and borders are called.

#include <fmt/ranges.h>

#include "core/axis_cut.hpp"
#include "stories/telling.hpp"

namespace gradus {

inline constexpr std::array<std::string_view, 6> border_names{"left", "right", "bottom",
                                                              "top",  "near",  "far"};
constexpr std::string_view name_of(Border border) { return border_names[static_cast<std::size_t>(border)]; }

/// Both ends, one after the other.
template <int N>
Segment<N, double> segment_in(const Arguments& arguments, std::string_view name) {
  const auto numbers = arguments.numbers(name);
  Segment<N, double> line{};
  for (int i = 0; i < N; ++i) {
    line.a[i] = numbers[static_cast<std::size_t>(i)];
    line.b[i] = numbers[static_cast<std::size_t>(N + i)];
  }
  return line;
}

/// All lower borders, then the upper ones.
template <int N>
AxisBox<N, double> box_in(const Arguments& arguments, std::string_view name) {
  const auto [lower, upper] = segment_in<N>(arguments, name);
  return {lower, upper};
}

/// The parameter for the order of all borders of a window or box.
template <int N>
Parameter order_parameter(std::string example, std::string help) {
  Parameter order{.name = "order",
                  .type = ParameterType::order,
                  .default_value = "",
                  .example = std::move(example),
                  .help = std::move(help)};
  order.choices.assign(border_names.begin(), border_names.begin() + 2 * N);
  order.default_value = fmt::format("{}", fmt::join(order.choices, ","));
  return order;
}
template <int N>
BorderOrder<N> order_in(const Arguments& arguments) {
  const auto places = arguments.order(order_parameter<N>("", ""));
  BorderOrder<N> order{};
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Border>(places[i]);
  return order;
}

}  // namespace gradus
