#pragma once
// Drawings of space as a draughtsman makes them: faces cover what lies behind them, hidden edges are thin and
// dashed or left out, faces that pierce each other meet in a line, and where a line passes behind another it
// leaves a gap. Right for any flat faces, concave, open, piercing and overlapping in cycles.

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/mesh.hpp"
#include "stories/hidden_lines.hpp"
#include "stories/paper.hpp"
#include "visibility/bsp_tree/bsp_tree.hpp"

namespace gradus {

/// How a drawing shows space.
struct SpaceLook {
  Viewer viewer;
  std::function<std::optional<dvec2>(dvec3)> at;        ///< a point's place on the paper, if it has one
  dvec3 right{1, 0, 0}, up{0, 1, 0}, towards{0, 0, 1};  ///< the reader's, in the space that is drawn
  std::optional<Extent> frame{};                        ///< of the paper: what lies beyond it is cut off

  /// A direction as the reader has it: right, up, towards him.
  dvec3 turned(dvec3 way) const { return {glm::dot(way, right), glm::dot(way, up), glm::dot(way, towards)}; }
};

/// How dark a face is drawn: from 1, turned to the light, to 3.
/// normal: of the side that is seen, as the reader has it: right, up, towards him; of any length.
int shade_of(dvec3 normal);

/// A flat face.
struct SpaceFace {
  std::string id;
  Role role;
  std::vector<dvec3> ring;  ///< counter-clockwise seen from outside
  bool one_sided = true;    ///< of a closed body, whose inside is never seen: left out where it looks away
  bool glass = false;       ///< lines are seen through it
  int shade = 0;            ///< 1 to 3; 0: by the light
  std::string quantity{};
};

/// A straight line.
struct SpaceEdge {
  std::string id;
  Role role;
  dvec3 a, b;
  bool arrow = false;                 ///< a head at b
  bool dashed = false, thin = false;  ///< also where it is seen
  bool behind = true;                 ///< its hidden parts are drawn, thin and dashed
  bool of_glass = false;              ///< glass hides it, too
  std::string quantity{};
};

/// The edges between a mesh's faces, each once.
std::vector<std::pair<dvec3, dvec3>> edges_of(const Mesh& mesh);

/// Corners of a face by their numbers, counter-clockwise from outside.
using Corners = std::vector<std::size_t>;

/// The faces of a box whose corner i lies at x, y, z = its bits 0, 1, 2.
inline std::vector<Corners> faces_of_box() {
  return {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
}

/// The corners of an upright box, numbered so.
std::vector<dvec3> corners_of_box(dvec3 lower, dvec3 upper);
/// The faces of a box with these corners.
std::vector<std::vector<dvec3>> rings_of_box(const std::vector<dvec3>& corners);

/// Which edges of a mesh are drawn: hidden ones are thin and dashed.
enum class EdgesShown { none, seen, all };

/// Collects what is to be seen, and draws it.
class SpaceDrawing {
 public:
  explicit SpaceDrawing(SpaceLook look) : look_(std::move(look)) {}

  void add(SpaceFace face) { faces_.push_back(std::move(face)); }
  void add(SpaceEdge edge) { edges_.push_back(std::move(edge)); }
  /// The faces of a mesh and the edges between them.
  void add(const std::string& id, Role role, const Mesh& mesh, EdgesShown shown = EdgesShown::all);

  /// The faces of a box, and their edges where they are seen; corners as faces_of_box numbers them.
  void add_box(const std::string& id, Role role, const std::vector<dvec3>& corners);
  /// Its twelve edges alone.
  void add_frame(const std::string& id, Role role, const std::vector<dvec3>& corners);

  /// Areas from back to front, whose ids begin with `id`, then lines under their own ids with a number, and
  /// those in which faces pierce each other.
  void add_to(View& view, const std::string& id) const;

  /// Parts of a line, as fractions of its length.
  using Spans = std::vector<std::pair<double, double>>;

 private:
  struct Course {
    dvec2 at, way;
  };

  void add_areas(View& view, const std::string& id) const;
  std::vector<bsp_tree::Polygon<double>> parts() const;
  std::vector<dvec2> on_paper(const std::vector<dvec3>& ring) const;

  void add_lines(View& view) const;
  std::vector<SpaceEdge> piercings() const;
  std::optional<Course> course(const SpaceEdge& edge, double part) const;
  std::optional<double> gap(const SpaceEdge& behind, double part, const SpaceEdge& front,
                            double part_of_front) const;
  void draw(View& view, const SpaceEdge& edge, const Spans& spans, bool behind) const;

  double size() const;

  SpaceLook look_;
  std::vector<SpaceFace> faces_;
  std::vector<SpaceEdge> edges_;
};

}  // namespace gradus
