#pragma once
// Points as programs have them: in a vector, an array, a span or braces. Topics take them as a span, whose
// scalar a call can't deduce from the others; here is what lets them take the others, too.

#include <concepts>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <iterator>
#include <span>
#include <type_traits>
#include <utility>

#include "core/language.hpp"

namespace gradus {

/// Items side by side in memory: a vector, an array, C's or C++'s, a span, braces.
template <class Row>
concept ContiguousRow = requires(const Row& row) {
  { std::data(row) } -> std::convertible_to<const void*>;
  { std::size(row) } -> std::convertible_to<std::size_t>;
};
template <ContiguousRow Row>
using ItemOf = std::remove_cvref_t<decltype(*std::data(std::declval<const Row&>()))>;

/// Such a row of anything, as the functions take it.
template <ContiguousRow Row>
constexpr std::span<const ItemOf<Row>> span_of(const Row& row) {
  return {std::data(row), std::size(row)};
}

/// Any row but that span itself, which the functions take without help.
template <class Row>
concept OtherRow = ContiguousRow<Row> && !std::same_as<Row, std::span<const ItemOf<Row>>>;

template <class Point, int N>
concept PointOf =
    requires { typename Point::value_type; } && std::same_as<Point, glm::vec<N, typename Point::value_type>>;

/// Points with N coordinates in a row.
template <class Row, int N>
concept PointRow = ContiguousRow<Row> && PointOf<ItemOf<Row>, N>;

/// The same in any form but the functions' own.
template <class Row, int N>
concept OtherPointRow = OtherRow<Row> && PointRow<Row, N>;

/// The scalar of their coordinates.
template <ContiguousRow Row>
using ScalarOf = typename ItemOf<Row>::value_type;

/// What a row of points is in braces, which name no scalar.
template <int N>
using PointsInBraces = std::initializer_list<glm::vec<N, double>>;

}  // namespace gradus
