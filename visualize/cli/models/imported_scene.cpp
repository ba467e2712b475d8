#include "cli/models/imported_scene.hpp"

#include <assimp/GltfMaterial.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/matrix.hpp>
#include <span>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "cli/models/gltf_data.hpp"
#include "cli/models/imported_library.hpp"
#include "cli/models/imported_model.hpp"
#include "core/image.hpp"
#include "core/refusal.hpp"
#include "core/shown.hpp"

namespace gradus::cli {
namespace {

constexpr float largest_number = 1e30f;  // as in OBJ files

/// Rows of Assimp's matrices, columns of ours; what stands in the last row has no place in a model.
glm::dmat4 affine(const aiMatrix4x4& m) {
  return {{m.a1, m.b1, m.c1, 0}, {m.a2, m.b2, m.c2, 0}, {m.a3, m.b3, m.c3, 0}, {m.a4, m.b4, m.c4, 1}};
}

/// The inverse transposed, up to its size: how normals are moved. Also for what has no inverse.
glm::dmat3 normals_by(const glm::dmat3& m) {
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  return glm::determinant(m) < 0 ? -cofactors : cofactors;
}

struct PlaceHash {
  std::size_t operator()(dvec3 p) const {
    std::size_t hash = 0;
    for (int i = 0; i < 3; ++i) hash = hash * 0x9e3779b97f4a7c15u + std::hash<double>()(p[i]);
    return hash;
  }
};

/// A value of a material, if it has one.
template <class T>
std::optional<T> value_of(const aiMaterial& material, const char* key, unsigned type, unsigned index) {
  const auto asked = [&](auto function, auto* to, auto... more) {
    return function(&material, key, type, index, to, more...) == aiReturn_SUCCESS;
  };
  T value{};
  bool there = false;
  if constexpr (std::is_same_v<T, float>) {
    there = asked(assimp().aiGetMaterialFloatArray, &value, nullptr);
  } else if constexpr (std::is_same_v<T, aiString>) {
    there = asked(assimp().aiGetMaterialString, &value);
  } else if constexpr (std::is_same_v<T, aiUVTransform>) {
    there = asked(assimp().aiGetMaterialUVTransform, &value);
  } else {
    aiColor4D colour;
    there = asked(assimp().aiGetMaterialColor, &colour);
    value = T(colour.r, colour.g, colour.b);
  }
  return there ? std::optional(value) : std::nullopt;
}

class Conversion {
 public:
  Conversion(const aiScene& scene, const pipeline::TextFile& file, const ImportedFormat& format)
      : scene_(scene), file_(file), format_(format) {
    mesh_.files.push_back(file.name);
  }

  pipeline::ModelFile model() {
    for (const aiMaterial* material : all(scene_.mMaterials, scene_.mNumMaterials)) take_material(*material);
    take_nodes();
    if (mesh_.faces.empty()) {
      refuse(fmt::format("expected at least one face, found none ({} vertices, {} points, {} lines)",
                         mesh_.positions.size(), model_.points, model_.lines));
    }
    add_notes();
    model_.normals_in_file = std::ssize(mesh_.normals);
    add_missing_normals(mesh_, groups_);
    return std::move(model_);
  }

 private:
  [[noreturn]] void refuse(std::string_view what) const {
    refuse_input(fmt::format("{}: {}", shown_name(file_.name), what));
  }
  /// A list of Assimp's: none where it says so, whatever its count.
  template <class T>
  static std::span<T* const> all(T* const* first, unsigned count) {
    return {first, first ? count : 0};
  }

  void check(double number, std::string_view what) const {
    if (std::abs(number) <= largest_number) return;
    refuse(fmt::format("expected {} within 1e30 of 0, found {}", what,
                       file_.quotable ? fmt::format("{}", number) : "something else"));
  }

  // --- Materials

  LinearRgb light_of(const aiColor3D& colour) const {
    for (const float share : {colour.r, colour.g, colour.b}) {
      check(share, "colours");
      if (share < 0) refuse("expected colours of 0 or more, found others");
    }
    return {colour.r, colour.g, colour.b};
  }
  LinearRgb light_of(const aiMaterial& from, const char* key, unsigned type, unsigned index,
                     LinearRgb otherwise) const {
    const auto colour = value_of<aiColor3D>(from, key, type, index);
    return colour ? light_of(*colour) : otherwise;
  }

  void take_material(const aiMaterial& from) {
    Material m;
    if (const auto name = value_of<aiString>(from, AI_MATKEY_NAME)) m.name = name->C_Str();
    unsigned channel = 0;
    m.diffuse_map = texture_of(from, m.name, channel);
    channels_.push_back(channel);
    if (m.name != AI_DEFAULT_MATERIAL_NAME)
      take_light(from, m);
    else if (!m.diffuse_map.file.empty())
      m.diffuse = m.ambient = LinearRgb{1};  // the picture alone
    mesh_.materials.push_back(std::move(m));
  }

  void take_light(const aiMaterial& from, Material& m) const {
    const LinearRgb base = light_of(from, AI_MATKEY_BASE_COLOR, m.diffuse);
    m.diffuse = light_of(from, AI_MATKEY_COLOR_DIFFUSE, base);
    m.ambient = m.diffuse;  // as in material libraries; formats that tell another seldom mean it
    m.specular = light_of(from, AI_MATKEY_COLOR_SPECULAR, m.specular);
    if (const auto strength = value_of<float>(from, AI_MATKEY_SHININESS_STRENGTH); strength && *strength >= 0)
      m.specular = light_of({m.specular.r * *strength, m.specular.g * *strength, m.specular.b * *strength});
    if (const auto exponent = value_of<float>(from, AI_MATKEY_SHININESS);
        exponent && 0 <= *exponent && *exponent <= largest_number)
      m.shininess = *exponent;
    // The factor of a picture that is not read: all of the surface would shine
    if (assimp().aiGetMaterialTextureCount(&from, aiTextureType_EMISSIVE) == 0)
      m.emission = light_of(from, AI_MATKEY_COLOR_EMISSIVE, m.emission);
    const auto mode = value_of<aiString>(from, AI_MATKEY_GLTF_ALPHAMODE);
    const bool lets_through = !mode || std::string_view(mode->C_Str()) == "BLEND";
    if (const auto share = value_of<float>(from, AI_MATKEY_OPACITY);
        share && lets_through && 0 <= *share && *share <= 1)
      m.opacity = *share;
  }

  /// The diffuse picture; channel: which texture coordinates are for it.
  Texture texture_of(const aiMaterial& from, const std::string& material, unsigned& channel) {
    aiString path;
    constexpr std::array kinds{aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR};
    const auto* kind = kinds.begin();
    const auto has = [&](aiTextureType one) {
      return assimp().aiGetMaterialTexture(&from, one, 0, &path, nullptr, &channel, nullptr, nullptr, nullptr,
                                           nullptr) == aiReturn_SUCCESS;
    };
    while (kind != kinds.end() && !has(*kind)) ++kind;
    if (kind == kinds.end() || path.length == 0) return {};
    if (value_of<aiUVTransform>(from, AI_MATKEY_UVTRANSFORM(*kind, 0))) moved_textures_ = true;
    std::string name = path.C_Str();
    if (const aiTexture* inside = scene_.GetEmbeddedTexture(path.C_Str()))
      take_picture(name, *inside);
    else if (format_.uris)
      name = name_in_uri(name);
    std::string place =
        fmt::format("{}: texture {} of material {}", shown_name(file_.name), shown(name), shown(material));
    if (!file_.quotable) place = shown_name(file_.name) + ": a texture";
    return {std::move(name), {}, std::move(place), file_.quotable};
  }

  /// A picture inside the model: a whole file's bytes, or bare texels, which become one.
  void take_picture(const std::string& name, const aiTexture& picture) {
    std::string& bytes = model_.pictures[name];
    if (!bytes.empty()) return;
    if (picture.mHeight == 0) {
      bytes.assign(reinterpret_cast<const char*>(picture.pcData), picture.mWidth);
      return;
    }
    constexpr unsigned longest = 1 << 15;
    if (picture.mWidth == 0 || std::max(picture.mWidth, picture.mHeight) > longest)
      refuse(fmt::format("expected pictures of 1 to {} texels per side, found {} x {}", longest,
                         picture.mWidth, picture.mHeight));
    Image image(static_cast<int>(picture.mWidth), static_cast<int>(picture.mHeight));
    for (std::size_t i = 0; i < image.cells().size(); ++i) {
      const aiTexel& texel = picture.pcData[i];
      image.cells()[i] = {texel.r, texel.g, texel.b, texel.a};
    }
    const std::vector<std::uint8_t> png = encode_png(image);
    bytes.assign(png.begin(), png.end());
  }

  // --- Nodes and their meshes

  /// All nodes, each before its children, these in their order.
  void take_nodes() {
    std::vector<std::pair<const aiNode*, glm::dmat4>> open;
    if (scene_.mRootNode) open.emplace_back(scene_.mRootNode, glm::dmat4(1));
    while (!open.empty()) {
      const auto [node, above] = open.back();
      open.pop_back();
      const glm::dmat4 placement = above * affine(node->mTransformation);
      for (unsigned i = 0; i < node->mNumMeshes; ++i) {
        if (node->mMeshes[i] >= scene_.mNumMeshes) refuse("expected meshes of the file, found another");
        take_mesh(*scene_.mMeshes[node->mMeshes[i]], placement);
      }
      for (unsigned i = node->mNumChildren; i > 0; --i) open.emplace_back(node->mChildren[i - 1], placement);
    }
  }

  void take_mesh(const aiMesh& from, const glm::dmat4& placement) {
    vertices_ += from.mNumVertices;
    check_room(vertices_);
    const auto first_normal = static_cast<int>(mesh_.normals.size()),
               first_texture = static_cast<int>(mesh_.textures.size());
    const unsigned material = from.mMaterialIndex;
    if (material >= scene_.mNumMaterials) refuse("expected materials of the file, found another");
    const bool wears = take_textures(from, channels_[material]);
    const bool has_normals = take_normals(from, normals_by(glm::dmat3(placement)));
    std::vector<int> places;
    for (const aiVector3D& at : std::span(from.mVertices, from.mVertices ? from.mNumVertices : 0))
      places.push_back(place_of(placement, at));
    const bool mirrored = glm::determinant(glm::dmat3(placement)) < 0;
    for (const aiFace& face : std::span(from.mFaces, from.mFaces ? from.mNumFaces : 0)) {
      if (face.mNumIndices < 3) {
        (face.mNumIndices == 2 ? model_.lines : model_.points) += 1;
        continue;
      }
      std::vector<Corner> corners;
      for (const unsigned vertex : std::span(face.mIndices, face.mNumIndices)) {
        if (vertex >= places.size())
          refuse(
              fmt::format("expected faces of the {} vertices of their mesh, found another", places.size()));
        const auto i = static_cast<int>(vertex);
        corners.push_back(
            {places[vertex], wears ? first_texture + i : -1, has_normals ? first_normal + i : -1});
      }
      // What a placement mirrors keeps its outside
      if (mirrored) std::reverse(corners.begin() + 1, corners.end());
      check_room(mesh_.corners.size() + corners.size());
      add_face(mesh_, corners, static_cast<int>(material) + 1, 0);
      groups_.push_back(format_.flat ? 0 : 1);
    }
    coloured_ |= from.HasVertexColors(0);
    moves_ |= from.HasBones();
  }

  void check_room(std::size_t corners) const {
    if (corners > most_imported_corners)
      refuse(fmt::format("expected at most {} corners with all that stands in it several times, found more",
                         most_imported_corners));
  }

  /// The number of a position, the same for all that stand at one place: of what formats cut into single
  /// triangles a body becomes again.
  int place_of(const glm::dmat4& placement, const aiVector3D& local) {
    const dvec3 at =
        dvec3(placement * glm::dvec4(local.x, local.y, local.z, 1)) + 0.0;  // no zero is negative
    for (int i = 0; i < 3; ++i) check(at[i], "coordinates");
    const auto [known, is_new] = numbers_.try_emplace(at, static_cast<int>(mesh_.positions.size()));
    if (is_new) mesh_.positions.push_back(at);
    return known->second;
  }

  bool take_textures(const aiMesh& from, unsigned channel) {
    if (channel >= AI_MAX_NUMBER_OF_TEXTURECOORDS || !from.HasTextureCoords(channel)) return false;
    for (const aiVector3D& uv : std::span(from.mTextureCoords[channel], from.mNumVertices)) {
      check(uv.x, "texture coordinates");
      check(uv.y, "texture coordinates");
      mesh_.textures.emplace_back(uv.x, uv.y);
    }
    return true;
  }

  bool take_normals(const aiMesh& from, const glm::dmat3& by) {
    if (!from.HasNormals()) return false;
    for (const aiVector3D& n : std::span(from.mNormals, from.mNumVertices)) {
      for (unsigned i = 0; i < 3; ++i) check(n[i], "normals");
      mesh_.normals.push_back(unit_vector(by * dvec3{n.x, n.y, n.z}));
    }
    return true;
  }

  // --- What is left out

  void add_notes() {
    const auto note = [this](bool there, std::string_view what) {
      if (there) model_.notes.push_back(fmt::format("{}: {}", shown_name(file_.name), what));
    };
    note(coloured_, "colours of vertices are not used");
    note(moved_textures_, "textures are laid on without their own transformations");
    note(moves_ || scene_.HasAnimations(), "it is drawn as it rests, without its movements");
    note(scene_.HasCameras() || scene_.HasLights(), "its cameras and lights are not used");
  }

  const aiScene& scene_;
  const pipeline::TextFile& file_;
  ImportedFormat format_;
  pipeline::ModelFile model_;
  Mesh& mesh_ = model_.mesh;
  std::vector<unsigned> channels_;  ///< of each material: the texture coordinates of its picture
  std::vector<int> groups_;         ///< the smoothing group of each face
  std::unordered_map<dvec3, int, PlaceHash> numbers_;
  std::size_t vertices_ = 0;
  bool coloured_ = false, moves_ = false, moved_textures_ = false;
};

}  // namespace

pipeline::ModelFile model_of(const aiScene& scene, const pipeline::TextFile& file,
                             const ImportedFormat& format) {
  return Conversion(scene, file, format).model();
}

}  // namespace gradus::cli
