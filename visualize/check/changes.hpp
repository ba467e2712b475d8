#pragma once
// Other values for a topic's parameters, as a kind of case asks for them.

#include <string>

#include "check/cases.hpp"
#include "core/random.hpp"

namespace gradus::check {

/// Whether there are other values than the default: of numbers, and of mazes.
bool can_be_changed(ParameterType type);

/// Values of one case, made from the parameters' defaults. Faces stay flat, of any kind. But for nasty ones,
/// an outline that crosses itself nowhere stays one, windows have an inside, and circles a radius. Easy faces
/// lie apart from each other.
class Changes {
 public:
  Changes(CaseKind kind, Random random);

  std::string of(const Parameter& parameter);
  /// True in this share of all calls.
  bool picks(double share) { return random_.unit() < share; }

 private:
  double small(int least, int most) { return static_cast<double>(random_.uniform_int(least, most)); }
  double number(std::size_t i, double usual, bool whole);
  double nasty(std::size_t i, double usual, bool whole);
  std::string numbers(const Parameter& parameter);
  std::string outlines(const Parameter& parameter);
  std::string easy_outlines(const Parameter& parameter);
  std::string window(const std::string& text);
  std::string maze(std::string rows);

  using Corners = std::vector<dvec3>;
  std::string faces(const std::string& text);
  Corners moved_face(const Corners& usual);
  Corners nasty_face(const Corners& usual);
  Corners face_in(dvec3 lower, dvec3 upper, const Corners& usual);
  dvec3 small_way(int least, int most);

  const CaseKind kind_;
  Random random_;
  const int way_;
  std::int64_t constant_ = 0;
  double last_ = 0;
};

}  // namespace gradus::check
