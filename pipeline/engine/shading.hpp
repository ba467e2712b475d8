#pragma once
// What shading in single precision is given: lamps, materials and, of each triangle that is seen, planes over
// the picture of what is linear on its surface.

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "engine/geometry.hpp"
#include "stages/textures.hpp"

namespace gradus::pipeline::engine {

/// A light, or one point of an area, in single precision. Places are counted from the eye.
struct Lamp {
  Light::Kind kind;
  glm::vec3 place;  ///< directional: the way to the light, of length 1
  glm::vec3 intensity;
  float constant, linear, quadratic, range;
  glm::vec3 front;  ///< spot: its axis; area: the way it faces, over the number of its points
  float outer, inner, concentration;
  float beside;  ///< places whose squared distance is less are too near

  bool weakens() const { return constant != 1 || linear != 0 || quadratic != 0; }
};

/// A texture and where its levels begin.
struct TextureLevels {
  const float* texels = nullptr;  ///< three a texel, and one after the last
  std::int32_t levels = 0;
  bool powers_of_two = false;  ///< columns and rows
  std::array<std::int32_t, 16> begin{}, columns{}, rows{};
};

/// What all pixels of a material have in common that the same lights may reach.
struct ShadingGroup {
  glm::vec3 even, diffuse, specular;  ///< ambient light with emission, k_d, k_s
  float shininess = 1;
  int whole_power = -1;  ///< the shininess where it is a small whole number, else -1
  TextureLevels texture{};
  std::vector<Lamp> lamps{};
  std::int64_t lamps_left_out = 0;  ///< they do not reach the object
  bool spared = false;              ///< by the plan: the highlight

  bool shines() const { return specular != glm::vec3(0); }
  bool has_texture() const { return texture.levels > 0; }
};

/// Places in a triangle's record.
namespace record {
inline constexpr int column = 0, row = 1;  ///< of the pixel that planes count from
inline constexpr int over_w = 2;           ///< planes have three numbers: there, a column more, a row more
inline constexpr int values = 5;    ///< six planes: place and normal; or scattered light and highlight,
                                    ///< without a texture three, of their sum
inline constexpr int texture = 23;  ///< two planes, of what is more than the base
inline constexpr int base = 29;     ///< texture coordinates of the pixel that planes count from
inline constexpr int size = 32;     ///< numbers in all
}  // namespace record

/// A triangle that is seen, as its pixels ask for it.
using TriangleRecord = std::array<float, record::size>;

/// The corners of a triangle that is seen.
struct SeenCorners {
  std::array<dvec3, 3> places, normals;  ///< counted from the eye; of length 1 or 0, on the viewer's side
  std::array<dvec2, 3> texture{};
  dvec3 over_w{1};  ///< 1 / w, up to a factor
};

/// Planes over a triangle.
class PlaneMaker {
 public:
  /// box: pixels that are asked for; not empty. over_w: of the corners. Planes count from the pixel in a
  /// corner of the box that is nearest to the viewer: from there on what is linear on the surface changes
  /// ever faster, so that single precision has the digits it needs everywhere.
  PlaneMaker(const triangle_coverage::Triangle& grid, const Window& box, const dvec3& over_w);

  ivec2 pixel() const { return pixel_; }
  /// Writes the plane of a value that is linear in the picture. at: of the corners.
  void put(const dvec3& at, float* into) const;
  /// Its value at pixel().
  double there(const dvec3& at) const { return at.x + (at.y - at.x) * there_[0] + (at.z - at.x) * there_[1]; }
  /// Whether the triangle is so thin that planes lose digits.
  bool is_thin() const { return thin_; }

 private:
  ivec2 pixel_;
  bool thin_ = false;
  double there_[2], across_[2], down_[2];  ///< shares of the second and the third corner
};

/// What shading needs of a scene and a camera.
class FrameShading {
 public:
  /// frame: made of this scene and plan, by these buffers.
  FrameShading(const Scene& scene, const Buffers& buffers, const Plan& plan, const Frame& frame);

  const std::vector<ShadingGroup>& groups() const { return groups_; }
  /// The group of a triangle.
  std::int32_t group_of(std::int32_t id) const;
  SeenCorners corners_of(std::int32_t id) const;
  /// The way to the viewer where rays are parallel, of length 1; else zero.
  const glm::vec3& towards() const { return towards_; }
  const Scene& scene() const { return scene_; }
  const Frame& frame() const { return frame_; }
  const Plan& plan() const { return plan_; }
  const Buffers& buffers() const { return buffers_; }

 private:
  using Key = std::pair<const Material*, std::vector<int>>;
  std::int32_t group_for(const Material& material, const std::vector<int>& lights);

  const Scene& scene_;
  const Buffers& buffers_;
  const Plan& plan_;
  const Frame& frame_;
  glm::vec3 towards_{0};
  std::vector<ShadingGroup> groups_;
  std::map<Key, std::int32_t> known_;
  std::vector<std::int32_t> first_, group_;  ///< by the frame's object; by material from there
};

/// Whether single precision is enough for a scene: its picture then differs from that of the textbook chain
/// by at most one step of 255, but at sharp edges of spots. Not with the texture filter `nearest`, texture
/// coordinates far out, more than 4096 lamps, and sizes beyond 1e-9 to 1e9.
bool suits_single_precision(const Scene& scene);

}  // namespace gradus::pipeline::engine
