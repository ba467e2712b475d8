#pragma once
// A car on a circular road, and what is mounted on it: it turns as the car does.

#include <cmath>

#include "core/arithmetic/elementary.hpp"
#include "core/contract.hpp"
#include "core/geometry.hpp"

namespace gradus::pipeline {

/// A road round a centre, in the plane through it that z stands on. It is gone along counter-clockwise, seen
/// from +z, at a steady speed.
struct CircularRoad {
  dvec3 centre{0};
  double radius = 1;  ///< > 0
  double speed = 1;   ///< > 0, in lengths a second
};

/// Where a car is, and its own axes: a right-handed frame of x out of the bend, y ahead, z up.
struct Car {
  dvec3 place{0};
  dvec3 out{1, 0, 0}, ahead{0, 1, 0}, up{0, 0, 1};
};

/// omega = v / R, in radians a second.
inline double angular_speed(const CircularRoad& road) { return road.speed / road.radius; }

/// The car after so many seconds: at centre + R (cos, sin)(omega t), on its way along (-sin, cos).
///
/// Domain: finite; omega t up to 2^20, from 0 on or before.
/// Accuracy: the axes are within 2 ulp of 1, the place within 3 ulp of |centre| + R, for the rounded omega t.
/// Cost: a sine and a cosine.
/// Errors: ContractViolation for a radius or a speed that is not above 0.
inline Car car_at(const CircularRoad& road, double seconds) {
  expects(road.radius > 0 && road.speed > 0, "a road has a radius and a car a speed above 0, not {} and {}",
          road.radius, road.speed);
  // How far round it has come
  const auto [s, c] = sin_cos(angular_speed(road) * seconds);
  const dvec3 out{c, s, 0}, ahead{-s, c, 0};
  return {road.centre + road.radius * out, out, ahead, {0, 0, 1}};
}

/// Where in the world that is which is fixed to the car: `offset` is told in the car's axes and stays the
/// same there, while it turns with the car in the world. Accuracy: 4 ulp of |place| + |offset|. Cost: 9
/// products. Domain: finite. Errors: none.
inline dvec3 mounted_on(const Car& car, dvec3 offset) {
  return car.place + offset.x * car.out + offset.y * car.ahead + offset.z * car.up;
}

}  // namespace gradus::pipeline
