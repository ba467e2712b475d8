#pragma once
// Colours of stage 7, to the bit and faster: what the places of a scene have in common is computed once, and
// powers only so far as the float asks for that a colour becomes.

#include <map>
#include <span>
#include <vector>

#include "core/geometry.hpp"
#include "core/light.hpp"
#include "stages/7_visibility_and_shading.hpp"

namespace gradus::pipeline::engine {

/// The colours that `shaded` gives. One per thread: it keeps what it knows of lamps.
class PixelColours {
 public:
  /// The colour of a fragment of a triangle, counted by the light as `shaded` does it.
  /// Accuracy: the bits of `shaded`.
  /// Cost: with Phong's shading a half to an eighth of it; all of it more where the bounds of a power become
  ///   different floats, in at most ten places of a million.
  LinearRgb operator()(SceneLight& light, const Fragment& fragment, const Triangle& triangle);

 private:
  /// A light, or one point of an area.
  struct Lamp {
    const Light* light;
    dvec3 intensity;
    dvec3 place;         ///< not of a directional light
    dvec3 axis;          ///< directional: L; spot: where it points; area: where it faces
    double share;        ///< directional: f, everywhere the same
    double most_square;  ///< beyond this squared distance there is surely nothing
  };
  struct Lamps {
    std::vector<Lamp> all;
    bool add_only;  ///< no light takes away or adds what is no number
  };
  struct Arriving;
  struct LightBetween;

  static Lamps lamps_of(std::span<const Light> lights);
  static bool is_idle(const Lamp& lamp, const dvec3& normal, const dvec3& to_lamp);
  static Arriving arriving(const Lamp& lamp, const dvec3& to_lamp);
  static LightBetween lit(const Lamps& lamps, const Material& material, bool shines, const Surface& at,
                          const Scene& scene);
  const Lamps& lamps_of(const SceneLight::Lights& lights);

  std::map<const SceneLight::Lights*, Lamps> known_{};
};

}  // namespace gradus::pipeline::engine
