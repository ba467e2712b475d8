#pragma once
// Chains of transformations as people write them: "rotate 30 about 1,1; scale 2 about 1,1", in the order in
// which they act.

#include <string>
#include <string_view>
#include <vector>

#include "stories/point_text.hpp"

namespace gradus {

/// The most factors that one text may have.
inline constexpr std::size_t most_factors = 12;

/// The mirrors that have a name.
enum class Mirror { x_axis, y_axis, origin, diagonal, line };

/// One factor as written; which members mean something depends on its kind.
struct FactorText {
  enum class Kind { translate, scale, rotate, shear, reflect };
  Kind kind = Kind::translate;
  Tuple amount{};  ///< how far, how many times, how many degrees
  Tuple pivot{};   ///< the point that stays; empty: the origin
  Tuple axis{};    ///< in space: the direction that a rotation goes round
  Mirror mirror = Mirror::line;
  std::vector<Tuple> line{};  ///< a mirror's two points
};

/// Reads factors with ";" between them. In the plane (`names` has two names):
///   translate DX,DY   scale S | SX,SY [about X,Y]   rotate DEGREES [about X,Y]   shear SHX,SHY [about X,Y]
///   reflect x | y | origin | y=x | X,Y X,Y
/// and in space:
///   translate DX,DY,DZ   scale S | SX,SY,SZ [about X,Y,Z]
///   rotate DEGREES about x | y | z | AX,AY,AZ [through X,Y,Z]
/// Errors say which factor. Domain: 1 to most_factors factors, numbers 0 or from 1e-15 to 1e15 in size, a
/// mirror's points different, an axis not 0.
Read<std::vector<FactorText>> read_factors(std::string_view text, std::span<const std::string> names);

/// The canonical spelling of one factor, and of several with "; " between them.
std::string text_of(const FactorText& factor);
std::string text_of(const std::vector<FactorText>& factors);

}  // namespace gradus
