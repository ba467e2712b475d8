#include "engine/shading.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "projection/viewing/viewing.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"
#include "shading/illumination/illumination.hpp"
#include "stages/1_input.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline::engine {
namespace {

// --- Lamps ---------------------------------------------------------------------------------------

Lamp lamp_of(const Light& light, int point, dvec3 eye) {
  const bool far = light.kind == Light::Kind::directional;
  Lamp lamp{light.kind,
            far ? unit_vector(-light.direction) : illumination::point_of<double>(light, point) - eye,
            light.intensity,
            static_cast<float>(light.constant),
            static_cast<float>(light.linear),
            static_cast<float>(light.quadratic),
            static_cast<float>(light.range),
            {},
            static_cast<float>(light.outer_cosine),
            static_cast<float>(light.inner_cosine),
            static_cast<float>(light.concentration),
            0};
  // Places there are as far from the eye as the lamp is, with digits down to 2^-24 of that
  if (!far) lamp.beside = 0x1p-14f * glm::dot(lamp.place, lamp.place);
  if (light.kind == Light::Kind::spot) lamp.front = unit_vector(light.direction);
  if (light.kind == Light::Kind::area)
    lamp.front = unit_vector(glm::cross(unit_vector(light.across), unit_vector(light.along))) /
                 double{illumination::lamps(light) * 1.0};
  return lamp;
}

std::int64_t lamps_of(const Scene& scene) {
  std::int64_t lamps = 0;
  for (const Light& light : scene.lights) lamps += illumination::lamps(light);
  return lamps;
}

// --- Materials -----------------------------------------------------------------------------------

int whole_power_of(float shininess) {
  return shininess >= 0 && shininess <= 1024 && std::floor(shininess) == shininess
             ? static_cast<int>(shininess)
             : -1;
}

TextureLevels levels_of(const LinearTexture& texture, TextureFilter filter) {
  const ivec2 size = texture.size();
  TextureLevels levels;
  levels.texels = &texture.texels().front().x;
  levels.levels = filter == TextureFilter::mip_mapped ? texture_mapping::levels_of(size) : 1;
  const auto power_of_two = [](int count) { return std::has_single_bit(static_cast<unsigned>(count)); };
  levels.powers_of_two = power_of_two(size.x) && power_of_two(size.y);
  for (int k = 0; k < levels.levels; ++k) {
    const ivec2 of_level = texture_mapping::size_of_level(size, k);
    const auto at = static_cast<std::size_t>(k);
    levels.begin[at] = static_cast<std::int32_t>(texture_mapping::begin_of_level(size, k));
    levels.columns[at] = of_level.x;
    levels.rows[at] = of_level.y;
  }
  return levels;
}

// --- Corners -------------------------------------------------------------------------------------

/// Of length 1; without the care of unit_vector where none is called for.
dvec3 quick_unit(dvec3 v) {
  const double square = glm::dot(v, v);
  return 1e-200 < square && square < 1e200 ? v / std::sqrt(square) : unit_vector(v);
}

SeenCorners corners_of_cut(const Triangle& t, dvec3 eye) {
  SeenCorners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const TriangleCorner& c = t.corners[k];
    corners.places[k] = c.world.at - eye;
    corners.normals[k] = c.normal;
    corners.texture[k] = c.texture;
    corners.over_w[static_cast<int>(k)] = c.over_w;
  }
  return corners;
}

}  // namespace

PlaneMaker::PlaneMaker(const triangle_coverage::Triangle& grid, const Window& box, const dvec3& over_w) {
  const auto edges = triangle_coverage::edges_of(grid);
  const auto area = static_cast<double>(std::abs(triangle_coverage::doubled_area(grid)));
  constexpr double most_change = 16;
  const ivec2 reach = box.upper - box.lower;
  for (std::size_t k = 0; k < 2; ++k) {
    const triangle_coverage::Edge& edge = edges[k + 1];
    across_[k] = static_cast<double>(edge.step()) / area;
    down_[k] = static_cast<double>(edge.to.x - edge.from.x) * triangle_coverage::subpixels / area;
    thin_ |= std::abs(across_[k]) * reach.x + std::abs(down_[k]) * reach.y > most_change;
  }
  const double to_second = over_w.y - over_w.x, to_third = over_w.z - over_w.x;
  const bool right = to_second * across_[0] + to_third * across_[1] > 0,
             below = to_second * down_[0] + to_third * down_[1] > 0;
  pixel_ = {right ? box.upper.x : box.lower.x, below ? box.upper.y : box.lower.y};
  const ivec2 centre = triangle_coverage::centre_of(pixel_);
  for (std::size_t k = 0; k < 2; ++k) there_[k] = static_cast<double>(edges[k + 1].at(centre)) / area;
}

void PlaneMaker::put(const dvec3& at, float* into) const {
  const double second = at.y - at.x, third = at.z - at.x;
  into[0] = static_cast<float>(there(at));
  into[1] = static_cast<float>(second * across_[0] + third * across_[1]);
  into[2] = static_cast<float>(second * down_[0] + third * down_[1]);
}

FrameShading::FrameShading(const Scene& scene, const Buffers& buffers, const Plan& plan, const Frame& frame)
    : scene_(scene), buffers_(buffers), plan_(plan), frame_(frame) {
  if (scene.camera.rays)
    towards_ = unit_vector(gradus::pipeline::towards_viewer(scene.camera.frame, scene.camera.rays->slant));
  std::vector<int> all(scene.lights.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  for (const FrameObject& object : frame.objects) {
    first_.push_back(static_cast<std::int32_t>(group_.size()));
    const auto& reaching = plan.of(object.number).lights;
    for (const Material& material : object_at(scene, object.number).mesh->materials)
      group_.push_back(group_for(material, reaching.size() < all.size() ? reaching : all));
  }
}

std::int32_t FrameShading::group_for(const Material& material, const std::vector<int>& lights) {
  const auto [known, is_new] =
      known_.try_emplace({&material, lights}, static_cast<std::int32_t>(groups_.size()));
  if (!is_new) return known->second;
  const LinearRgb even = material.ambient * scene_.ambient;
  ShadingGroup group{material.emission + even, material.diffuse, material.specular, material.shininess,
                     whole_power_of(material.shininess)};
  const auto texture = buffers_.textures.find(&material);
  if (texture != buffers_.textures.end()) group.texture = levels_of(texture->second, scene_.filter);
  for (const int number : lights) {
    const Light& light = scene_.lights[static_cast<std::size_t>(number)];
    for (int point = 0; point < illumination::lamps(light); ++point)
      group.lamps.push_back(lamp_of(light, point, scene_.camera.frame.eye));
  }
  group.lamps_left_out = lamps_of(scene_) - std::ssize(group.lamps);
  group.spared = !plan_.highlights(material);
  groups_.push_back(std::move(group));
  return known->second;
}

std::int32_t FrameShading::group_of(std::int32_t id) const {
  const FrameTriangle& t = frame_.triangle(id);
  const FrameObject& object = frame_.object_of(t);
  const auto of_cut = [&] {
    const Mesh& mesh = *object_at(scene_, object.number).mesh;
    return mesh.faces[static_cast<std::size_t>(frame_.cut_triangle(id).id.face)].material;
  };
  const int material = t.cut ? of_cut() : object.pieces->of_faces[static_cast<std::size_t>(t.piece)].material;
  return group_[static_cast<std::size_t>(first_[static_cast<std::size_t>(t.object)] + material)];
}

SeenCorners FrameShading::corners_of(std::int32_t id) const {
  const FrameTriangle& t = frame_.triangle(id);
  const dvec3 eye = scene_.camera.frame.eye;
  if (t.cut) return corners_of_cut(frame_.cut_triangle(id), eye);
  const FrameObject& object = frame_.object_of(t);
  const Object& placed = object_at(scene_, object.number);
  const Mesh& mesh = *placed.mesh;
  const auto piece = static_cast<std::size_t>(t.piece);
  const MeshPiece& of_face = object.pieces->of_faces[piece];
  SeenCorners corners;
  for (int k = 0; k < 3; ++k) {
    const auto at = static_cast<std::size_t>(k), from = object.mirrored && k > 0 ? 3 - at : at;
    const auto vertex = static_cast<std::size_t>(object.pieces->vertices[piece][from]);
    const std::int32_t own = of_face.normals[from], texture = of_face.textures[from];
    const dvec3 world = affine_3d::transform(placed.placement, mesh.positions[vertex]);
    const dvec3 normal = quick_unit(object.normal_matrix *
                                    (own < 0 ? object.pieces->flat_normals[static_cast<std::size_t>(-1 - own)]
                                             : mesh.normals[static_cast<std::size_t>(own)]));
    corners.places[at] = world - eye;
    corners.normals[at] = t.seen_from_behind ? -normal : normal;
    if (texture >= 0) corners.texture[at] = mesh.textures[static_cast<std::size_t>(texture)];
    if (!scene_.camera.rays)
      corners.over_w[k] = 1 / glm::dot(scene_.camera.frame.forward, corners.places[at]);
  }
  return corners;
}

bool suits_single_precision(const Scene& scene) {
  constexpr double least = 1e-9, most = 1e9;
  const auto fits = [](double x) { return std::abs(x) <= most; };
  const auto& rays = scene.camera.rays;
  const bool camera = rays ? least <= rays->height && least <= rays->far - rays->near && fits(rays->near) &&
                                 fits(rays->far) && fits(rays->height)
                           : least <= scene.camera.lens.near && scene.camera.lens.far <= most;
  const bool lights = std::ranges::all_of(scene.lights, [&](const Light& light) {
    const dvec3 way = light.position - scene.camera.frame.eye;
    return light.kind == Light::Kind::directional || (fits(way.x) && fits(way.y) && fits(way.z));
  });
  const auto textured = [](const Object& object) {
    return std::ranges::any_of(object.mesh->materials,
                               [](const Material& m) { return !m.diffuse_map.texels.cells().empty(); });
  };
  const bool textures =
      scene.filter != TextureFilter::nearest || std::ranges::none_of(scene.objects, textured);
  return camera && lights && textures && lamps_of(scene) <= 4096;
}

}  // namespace gradus::pipeline::engine
