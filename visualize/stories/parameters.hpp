#pragma once
// Parameters as topics declare them: a name, the default, an example and a line of help, and what their type
// asks for besides.

#include <string>
#include <utility>
#include <vector>

#include "stories/topic.hpp"

namespace gradus::parameters {

using Names = std::vector<std::string>;

/// The names of a point's numbers.
inline const Names xy{"x", "y"}, xyz{"x", "y", "z"};

/// One number.
inline Parameter number(std::string name, std::string value, std::string example, std::string help,
                        Sizes sizes = {}) {
  Parameter parameter{std::move(name), ParameterType::number, std::move(value), std::move(example),
                      std::move(help)};
  parameter.sizes = sizes;
  return parameter;
}

/// As many numbers as there are parts.
inline Parameter numbers(std::string name, std::string value, std::string example, std::string help,
                         Names parts, Sizes sizes = {}) {
  Parameter parameter = number(std::move(name), std::move(value), std::move(example), std::move(help), sizes);
  parameter.type = ParameterType::numbers;
  parameter.parts = std::move(parts);
  return parameter;
}

/// The same for a window or a box, all lower ones first.
inline Parameter bounds(std::string name, std::string value, std::string example, std::string help,
                        Names parts, Sizes sizes = {}) {
  Parameter parameter = numbers(std::move(name), std::move(value), std::move(example), std::move(help),
                                std::move(parts), sizes);
  parameter.type = ParameterType::bounds;
  return parameter;
}

/// From `least` to `most` points of such numbers.
inline Parameter points(int least, int most, std::string name, std::string value, std::string example,
                        std::string help, Names parts, Sizes sizes = {}) {
  Parameter parameter = numbers(std::move(name), std::move(value), std::move(example), std::move(help),
                                std::move(parts), sizes);
  parameter.type = ParameterType::points;
  parameter.least = least;
  parameter.most = most;
  return parameter;
}

/// Faces in space of up to so many corners in all.
inline Parameter faces(int most, std::string name, std::string value, std::string example, std::string help,
                       Sizes sizes = {}) {
  Parameter parameter = number(std::move(name), std::move(value), std::move(example), std::move(help), sizes);
  parameter.type = ParameterType::faces;
  parameter.parts = xyz;
  parameter.most = most;
  return parameter;
}

/// One whole number, from `least` to `most`.
inline Parameter integer(std::int64_t least, std::int64_t most, std::string name, std::string value,
                         std::string example, std::string help) {
  Parameter parameter{std::move(name), ParameterType::integer, std::move(value), std::move(example),
                      std::move(help)};
  parameter.least = least;
  parameter.most = most;
  return parameter;
}

/// Given or not.
inline Parameter flag(std::string name, std::string help) {
  return {std::move(name), ParameterType::flag, "", "yes", std::move(help)};
}

/// One of these.
inline Parameter choice(std::string name, Names choices, std::string value, std::string example,
                        std::string help) {
  Parameter parameter{std::move(name), ParameterType::choice, std::move(value), std::move(example),
                      std::move(help)};
  parameter.choices = std::move(choices);
  return parameter;
}

/// The other parameter's default gives way when this one is given.
inline Parameter instead_of(std::string other, Parameter parameter) {
  parameter.instead_of = std::move(other);
  return parameter;
}

/// A reader's notation may have another one than the default.
inline Parameter noted(std::string Notation::* by, Parameter parameter) {
  parameter.noted = by;
  return parameter;
}

}  // namespace gradus::parameters
