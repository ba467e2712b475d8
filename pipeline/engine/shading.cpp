#include "engine/shading.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "projection/viewing/viewing.hpp"
#include "shading/illumination/illumination.hpp"

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

bool is_grey(const glm::vec3& colour) { return colour.r == colour.g && colour.g == colour.b; }

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

void put_in(std::size_t lane, const dvec3& v, std::array<SeenTriangles::Lanes<double>, 3>& into) {
  into[0][lane] = v.x;
  into[1][lane] = v.y;
  into[2][lane] = v.z;
}

}  // namespace

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
  group.grey = is_grey(group.even) && is_grey(group.diffuse) && is_grey(group.specular) &&
               std::ranges::all_of(group.lamps, is_grey, &Lamp::intensity);
  groups_.push_back(std::move(group));
  return known->second;
}

void FrameShading::fetch_face(std::int32_t id) const {
  const FrameTriangle& t = frame_.triangle(id);
  if (t.cut) return;
  const MeshPieces& pieces = *frame_.object_of(t).pieces;
  __builtin_prefetch(&pieces.of_faces[static_cast<std::size_t>(t.piece)]);
  __builtin_prefetch(&pieces.vertices[static_cast<std::size_t>(t.piece)]);
}

void FrameShading::fetch_corners(std::int32_t id) const {
  const FrameTriangle& t = frame_.triangle(id);
  if (t.cut) return;
  const FrameObject& object = frame_.object_of(t);
  const Mesh& mesh = *object_at(scene_, object.number).mesh;
  const auto piece = static_cast<std::size_t>(t.piece);
  for (const std::int32_t vertex : object.pieces->vertices[piece])
    __builtin_prefetch(&mesh.positions[static_cast<std::size_t>(vertex)]);
  for (const std::int32_t normal : object.pieces->of_faces[piece].normals)
    if (normal >= 0) __builtin_prefetch(&mesh.normals[static_cast<std::size_t>(normal)]);
}

std::int32_t FrameShading::put_cut(std::int32_t id, std::size_t lane, SeenTriangles& seen) const {
  const FrameTriangle& t = frame_.triangle(id);
  const Triangle& cut = frame_.cut_triangle(id);
  for (std::size_t k = 0; k < 3; ++k) {
    const TriangleCorner& corner = cut.corners[k];
    put_in(lane, corner.world.at - scene_.camera.frame.eye, seen.places[k]);
    put_in(lane, corner.normal, seen.normals[k]);
    seen.texture[k][0][lane] = corner.texture.x;
    seen.texture[k][1][lane] = corner.texture.y;
  }
  seen.object[lane] = SeenTriangles::cut;
  seen.side[lane] = 1;  // normals are on the viewer's side already
  const Mesh& mesh = *object_at(scene_, frame_.object_of(t).number).mesh;
  return group_of(t, mesh.faces[static_cast<std::size_t>(cut.id.face)].material);
}

std::int32_t FrameShading::put(std::int32_t id, std::size_t lane, SeenTriangles& seen) const {
  const FrameTriangle& t = frame_.triangle(id);
  for (std::size_t k = 0; k < 3; ++k) {
    seen.grid[k][0][lane] = t.grid[k].x;
    seen.grid[k][1][lane] = t.grid[k].y;
  }
  if (t.cut) return seen.group[lane] = put_cut(id, lane, seen);
  const FrameObject& object = frame_.object_of(t);
  const Mesh& mesh = *object_at(scene_, object.number).mesh;
  const auto piece = static_cast<std::size_t>(t.piece);
  const MeshPiece& of_face = object.pieces->of_faces[piece];
  const PieceVertices& vertices = object.pieces->vertices[piece];
  const std::int32_t group = group_of(t, of_face.material);
  const bool textured = groups_[static_cast<std::size_t>(group)].has_texture();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t from = object.mirrored && k > 0 ? 3 - k : k;
    const std::int32_t own = of_face.normals[from];
    put_in(lane, mesh.positions[static_cast<std::size_t>(vertices[from])], seen.places[k]);
    put_in(lane,
           own < 0 ? object.pieces->flat_normals[static_cast<std::size_t>(-1 - own)]
                   : mesh.normals[static_cast<std::size_t>(own)],
           seen.normals[k]);
    if (!textured) continue;
    const std::int32_t texture = of_face.textures[from];
    const dvec2 at = texture < 0 ? dvec2(0) : mesh.textures[static_cast<std::size_t>(texture)];
    seen.texture[k][0][lane] = at.x;
    seen.texture[k][1][lane] = at.y;
  }
  seen.object[lane] = t.object;
  seen.side[lane] = t.seen_from_behind ? -1 : 1;
  return seen.group[lane] = group;
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
