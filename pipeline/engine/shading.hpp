#pragma once
// What shading in single precision is given: lamps, materials and, of each triangle that is seen, planes over
// the picture of what is linear on its surface.

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "engine/geometry.hpp"
#include "engine/visibility_batch.hpp"
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
  const float* texels = nullptr;  ///< three per texel, and one after the last
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
  bool grey = false;                ///< light is the same in red, green and blue, before a texture

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

/// Sixteen triangles that are seen, side by side, as their pixels ask for them: their numbers by place.
struct alignas(64) RecordBlock {
  std::array<std::array<float, block_cells>, record::size> numbers;

  std::array<float, block_cells>& operator[](std::size_t place) { return numbers[place]; }
  /// The first number of a triangle; others follow block_cells apart.
  const float* of(std::size_t lane) const { return numbers.front().data() + lane; }
};

/// Up to sixteen triangles that are seen, side by side.
struct alignas(64) SeenTriangles {
  template <class T>
  using Lanes = std::array<T, block_cells>;
  /// By corner, then by coordinate.
  template <class T, std::size_t coordinates>
  using Corners = std::array<std::array<Lanes<T>, coordinates>, 3>;

  Corners<std::int32_t, 2> grid{};  ///< in 1/256 pixel
  Corners<double, 3> places{},
      normals{};  ///< in the object's space, or, where cut, from the eye in the world
  Corners<double, 2> texture{};
  Lanes<double> side{};                   ///< 1, or -1 where seen from behind
  Lanes<std::int32_t> object{}, group{};  ///< object: place among the frame's, or `cut`
  std::array<Lanes<float>, 6>
      face_light{};  ///< flat shading: three colours of scattered light, then the highlight
  std::size_t count = 0;

  static constexpr std::int32_t cut = -1;
};

/// What shading needs of a scene and a camera.
class FrameShading {
 public:
  /// frame: made of this scene and plan, by these buffers.
  FrameShading(const Scene& scene, const Buffers& buffers, const Plan& plan, const Frame& frame);

  const std::vector<ShadingGroup>& groups() const { return groups_; }
  /// Puts a triangle beside others, but for its light. Returns its group.
  std::int32_t put(std::int32_t id, std::size_t lane, SeenTriangles& seen) const;
  /// Asks memory for what `put` reads of a triangle's face, and then for what that names.
  void fetch_face(std::int32_t id) const;
  void fetch_corners(std::int32_t id) const;
  /// The way to the viewer where rays are parallel, of length 1; else zero.
  const glm::vec3& towards() const { return towards_; }
  const Scene& scene() const { return scene_; }
  const Frame& frame() const { return frame_; }
  const Plan& plan() const { return plan_; }
  const Buffers& buffers() const { return buffers_; }

 private:
  using Key = std::pair<const Material*, std::vector<int>>;
  std::int32_t put_cut(std::int32_t id, std::size_t lane, SeenTriangles& seen) const;
  std::int32_t group_of(const FrameTriangle& t, int material) const {
    return group_[static_cast<std::size_t>(first_[static_cast<std::size_t>(t.object)] + material)];
  }
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
/// by at most one step of 255. Not with the texture filter `nearest`, texture coordinates far out, more than
/// 4096 lamps, and sizes beyond 1e-9 to 1e9.
bool suits_single_precision(const Scene& scene);

}  // namespace gradus::pipeline::engine
