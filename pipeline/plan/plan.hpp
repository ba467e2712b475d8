#pragma once
// What a scene needs, decided from boxes and flags before any vertex is touched: which objects can be seen,
// which of them are cut, which lights reach them.

#include <optional>
#include <vector>

#include "core/geometry.hpp"
#include "core/raster.hpp"
#include "plan/rules.hpp"
#include "scene/scene.hpp"
#include "stages/points.hpp"

namespace gradus::pipeline {

/// A side of what the picture shows.
enum class Side { left, right, lower, upper, near, far };

/// A box as the picture has it.
struct ScreenBox {
  Window pixels;     ///< all it may touch, within the part that is asked for
  double depth = 0;  ///< nothing of it is nearer, after division; in [0, 1]
};

/// What is done with an object.
struct ObjectPlan {
  std::optional<Rule> skipped;        ///< why it is left out
  std::optional<Side> beyond{};       ///< Rule::outside, area_of_interest: which side it lies beyond
  int behind = -1;                    ///< Rule::hidden: the number of an object that hides some of it
  bool whole = false;                 ///< it lies wholly between the planes, and nothing of it is cut
  std::optional<ScreenBox> extent{};  ///< of what lies wholly behind the near plane
  std::vector<int> lights{};          ///< the numbers of those that may reach it
};

/// What is done with a scene.
struct Plan {
  Size size;
  Window window;  ///< the part of the picture that is asked for
  Rules rules = Rules::all();
  std::vector<ObjectPlan> objects;

  bool draws(int object) const { return !of(object).skipped; }
  bool cuts(int object) const { return !of(object).whole; }
  /// Whether the highlight of a material is looked for.
  bool highlights(const Material& material) const {
    return !rules.has(Rule::no_highlight) || material.specular != LinearRgb{0};
  }
  const ObjectPlan& of(int object) const { return objects[static_cast<std::size_t>(object)]; }
};

/// Those of the rules that hold for a scene. Only a z-buffer throws away what is hidden: edges of a wireframe
/// and what is painted over is drawn. A BSP tree is built of all triangles, and its cuts depend on each.
Rules sound_rules(const Scene& scene, Rules rules);

/// Plans a scene from the boxes of its objects. What only the geometry of nearer objects can tell,
/// Rule::hidden, is added by `geometry` (planned.hpp).
///
/// size: of the picture. rules: those that may be used. window: the part of the picture that is asked for;
///   all of it where none is given.
///
/// Domain: that of render; the window has a pixel at least and lies in the picture (refused otherwise).
/// Accuracy: on the safe side: a box is widened by a pixel and by what rounding may be off, so an object
///   near the border of a decision is drawn, cut and lit.
/// Cost: the vertices of each mesh once, however many objects show it; 8 corners per object, and its lights.
/// Errors: ContractViolation for a lens that sees nothing.
Plan plan_of(const Scene& scene, Size size, Rules rules = Rules::all(), std::optional<Window> window = {});

}  // namespace gradus::pipeline
