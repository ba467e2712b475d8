#pragma once
// Methods beside each other: what each looks like in all charts of a topic, and what their points say.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry.hpp"
#include "figure/role.hpp"

namespace gradus::plot {

enum class Marker : std::uint8_t { disc, square, diamond, triangle, cross };

/// What tells one method of a chart from the others: a colour of its own and, for who sees none, a marker.
struct Style {
  Role role = Role::current;  ///< whose colour it has
  Marker marker = Marker::disc;
  bool open = false;    ///< where the colours are used up: open markers, dashed lines
  bool chosen = false;  ///< the one to take: larger, thicker, its name bold
};

/// What a chart must know of a method to style it.
enum class Kind : std::uint8_t { usual, chosen, faulty };

/// The styles of some methods. Up to seven have a colour each, up to thirteen a colour and filling each. The
/// chosen one has the colour of what is current for itself, faulty ones are crossed.
std::vector<Style> styles_of(std::span<const Kind> methods);

/// The exponent b of y = a x^b through some points, by least squares in logarithms; nothing with fewer than
/// two different x.
std::optional<double> slope(std::span<const dvec2> points);

/// Which of some points no other beats: none is as good in both and better in one; less is better.
std::vector<bool> front(std::span<const dvec2> points);

/// Places in [least, most] at least `gap` apart, in the order of those wanted, which rise, and together as
/// near to them as can be. Where there is not room for all, they stand closer.
std::vector<double> moved_apart(std::span<const double> wanted, double gap, double least, double most);

}  // namespace gradus::plot
