#include "benchmark/pipeline/llvmpipe.hpp"

#ifdef GRADUS_HAS_OSMESA

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "projection/viewing/viewing.hpp"
#include "stages/1_input.hpp"
#include "stages/2_world.hpp"
#include "stages/3_perspective.hpp"

namespace gradus::bench::peers {
namespace {

using namespace pipeline;

// --- Shaders -------------------------------------------------------------------------------------

/// Phong's model, as algorithms/shading/illumination has it.
constexpr const char* light_text = R"(
uniform vec3 eye, ambient, kd, ks, lamp[8], intensity[8];
uniform float shininess;
uniform int lamps;
uniform bool far[8];
void lit(vec3 place, vec3 normal, out vec3 scattered, out vec3 highlight) {
  vec3 v = normalize(eye - place);
  scattered = ambient;
  highlight = vec3(0);
  for (int i = 0; i < LAMPS; ++i) {
    vec3 l = far[i] ? lamp[i] : normalize(lamp[i] - place);
    float nl = dot(normal, l);
    if (nl > 0.0) {
      scattered += nl * kd * intensity[i];
      float rv = dot(2.0 * nl * normal - l, v);
      if (SHINES && rv > 0.0) highlight += pow(rv, shininess) * ks * intensity[i];
    }
  }
}
)";

constexpr const char* vertex_text = R"(
layout(location = 0) in vec3 place_in;
layout(location = 1) in vec3 normal_in;
layout(location = 2) in vec2 uv_in;
uniform mat4 to_clip;
out vec2 uv;
#if PER_PIXEL
out vec3 place, normal;
#else
out vec3 scattered, highlight;
#endif
void main() {
  gl_Position = to_clip * vec4(place_in, 1);
  uv = uv_in;
#if PER_PIXEL
  place = place_in;
  normal = normal_in;
#else
  lit(place_in, normal_in, scattered, highlight);
#endif
}
)";

constexpr const char* fragment_text = R"(
in vec2 uv;
#if PER_PIXEL
in vec3 place, normal;
#else
in vec3 scattered, highlight;
#endif
uniform sampler2D texels;
out vec4 colour;
void main() {
#if PER_PIXEL
  vec3 scattered, highlight;
  vec3 n = normalize(normal);
#if BOTH_SIDES
  if (!gl_FrontFacing) n = -n;
#endif
  lit(place, n, scattered, highlight);
#endif
#if TEXTURED
  colour = vec4(scattered * texture(texels, uv).rgb + highlight, 1);
#else
  colour = vec4(scattered + highlight, 1);
#endif
}
)";

GLuint shader_of(GLenum kind, const std::string& text) {
  const GLuint shader = glCreateShader(kind);
  const char* source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (!compiled) {
    std::array<char, 4096> log{};
    glGetShaderInfoLog(shader, 4096, nullptr, log.data());
    throw std::runtime_error(fmt::format("llvmpipe: a shader: {}", log.data()));
  }
  return shader;
}

GLuint program_of(const std::string& head) {
  const std::string begin = "#version 330 core\n" + head + light_text;
  const GLuint program = glCreateProgram();
  glAttachShader(program, shader_of(GL_VERTEX_SHADER, begin + vertex_text));
  glAttachShader(program, shader_of(GL_FRAGMENT_SHADER, begin + fragment_text));
  glLinkProgram(program);
  return program;
}

// --- Vertices ------------------------------------------------------------------------------------

struct GlVertex {
  glm::vec3 place, normal;
  glm::vec2 uv;
};

/// Triangles of one material.
struct Batch {
  const Material* material = nullptr;
  bool both_sides = false;
  std::vector<std::uint32_t> indices{};
  GLsizei first = 0;
  GLuint program = 0, texture = 0;
};

/// All triangles in world space: a vertex for each place, normal and texture coordinate of a mesh.
struct Geometry {
  std::vector<GlVertex> vertices;
  std::vector<Batch> batches;

  Batch& batch_of(const Material* material, bool both_sides) {
    for (Batch& batch : batches)
      if (batch.material == material && batch.both_sides == both_sides) return batch;
    return batches.emplace_back(Batch{material, both_sides});
  }
};

Geometry geometry_of(const Scene& scene) {
  Geometry geometry;
  const Model<WorldPoint> world = to_world(scene, input(scene));
  using Key = std::tuple<int, double, double, double, double, double>;
  std::map<Key, std::uint32_t> known;
  // Objects of one mesh and material are one batch: materials are told apart by what they say
  for (const Piece& piece : world.pieces) {
    const Object& object = object_at(scene, piece.id.object);
    const MeshFace& face = object.mesh->faces[static_cast<std::size_t>(piece.id.face)];
    Batch& batch =
        geometry.batch_of(&object.mesh->materials[static_cast<std::size_t>(face.material)], object.two_sided);
    for (const PieceCorner& corner : piece.corners) {
      const auto& [n, t] = std::pair(corner.normal, corner.texture);
      const auto [at, is_new] = known.try_emplace({corner.vertex, n.x, n.y, n.z, t.x, t.y},
                                                  static_cast<std::uint32_t>(geometry.vertices.size()));
      if (is_new) geometry.vertices.push_back({world.point(corner).at, n, t});
      batch.indices.push_back(at->second);
    }
  }
  return geometry;
}

/// From the world to OpenGL's clip space, where depths go from -w to w.
glm::mat4 matrix_of(const Scene& scene, Size size) {
  const SceneLens lens = lens_of(scene.camera, static_cast<double>(size.width) / size.height);
  const auto at = [&](dvec3 p) {
    glm::dvec4 clip = transform(lens, viewing::to_view(scene.camera.frame, p));
    clip.z = 2 * clip.z - clip.w;
    return clip;
  };
  const glm::dvec4 origin = at({0, 0, 0});
  return glm::mat4(
      glm::dmat4(at({1, 0, 0}) - origin, at({0, 1, 0}) - origin, at({0, 0, 1}) - origin, origin));
}

GLuint texture_of(const Scene& scene, const Image& texels) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  Image upside_down(texels.width(), texels.height());
  for (int y = 0; y < texels.height(); ++y)
    std::ranges::copy(texels.row(y), upside_down.row(texels.height() - 1 - y).begin());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, texels.width(), texels.height(), 0, GL_RGBA,
               GL_UNSIGNED_BYTE, upside_down.cells().data());
  glGenerateMipmap(GL_TEXTURE_2D);
  const GLint filter = scene.filter == TextureFilter::nearest    ? GL_NEAREST
                       : scene.filter == TextureFilter::bilinear ? GL_LINEAR
                                                                 : GL_LINEAR_MIPMAP_LINEAR;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER,
                  scene.filter == TextureFilter::nearest ? GL_NEAREST : GL_LINEAR);
  return texture;
}

void set_uniforms(const Scene& scene, const Batch& batch, const glm::mat4& to_clip) {
  const auto place = [&](const char* name) { return glGetUniformLocation(batch.program, name); };
  const auto put = [&](const char* name, const glm::vec3& v) { glUniform3f(place(name), v.x, v.y, v.z); };
  glUseProgram(batch.program);
  glUniformMatrix4fv(place("to_clip"), 1, GL_FALSE, &to_clip[0][0]);
  put("eye", glm::vec3(scene.camera.frame.eye));
  put("ambient", batch.material->ambient * scene.ambient + batch.material->emission);
  put("kd", batch.material->diffuse);
  put("ks", batch.material->specular);
  glUniform1f(place("shininess"), batch.material->shininess);
  int number = 0;
  for (const Light& light : scene.lights) {
    const bool far = light.kind == Light::Kind::directional;
    put(fmt::format("lamp[{}]", number).c_str(),
        far ? glm::vec3(unit_vector(-light.direction)) : glm::vec3(light.position));
    put(fmt::format("intensity[{}]", number).c_str(), light.intensity);
    glUniform1i(place(fmt::format("far[{}]", number).c_str()), far);
    ++number;
  }
}

}  // namespace

struct Llvmpipe::Buffers {
  Size size;
  OSMesaContext context = nullptr;
  std::vector<std::uint32_t> window;  ///< OSMesa's own, which nothing is drawn into
  glm::vec4 background{0};
  std::vector<Batch> batches;
};

Llvmpipe::Llvmpipe(const Scene& scene, Size size, int threads) : own_(std::make_unique<Buffers>()) {
  setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);
  const int wishes[] = {OSMESA_FORMAT,
                        OSMESA_RGBA,
                        OSMESA_PROFILE,
                        OSMESA_CORE_PROFILE,
                        OSMESA_CONTEXT_MAJOR_VERSION,
                        3,
                        OSMESA_CONTEXT_MINOR_VERSION,
                        3,
                        0};
  own_->size = size;
  own_->context = OSMesaCreateContextAttribs(wishes, nullptr);
  if (!own_->context) throw std::runtime_error("llvmpipe: no context");
  own_->window.resize(16 * 16);
  OSMesaMakeCurrent(own_->context, own_->window.data(), GL_UNSIGNED_BYTE, 16, 16);
  own_->background = {scene.background, 1};

  GLuint names[5];
  glGenTextures(1, names);
  glBindTexture(GL_TEXTURE_2D, names[0]);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, size.width, size.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glGenRenderbuffers(1, names + 1);
  glBindRenderbuffer(GL_RENDERBUFFER, names[1]);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, size.width, size.height);
  glGenFramebuffers(1, names + 2);
  glBindFramebuffer(GL_FRAMEBUFFER, names[2]);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, names[0], 0);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, names[1]);
  glEnable(GL_FRAMEBUFFER_SRGB);
  glEnable(GL_DEPTH_TEST);
  glViewport(0, 0, size.width, size.height);

  Geometry geometry = geometry_of(scene);
  std::vector<std::uint32_t> indices;
  for (Batch& batch : geometry.batches) {
    batch.first = static_cast<GLsizei>(indices.size());
    indices.insert(indices.end(), batch.indices.begin(), batch.indices.end());
  }
  GLuint array = 0;
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glGenBuffers(2, names + 3);
  glBindBuffer(GL_ARRAY_BUFFER, names[3]);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(geometry.vertices.size() * sizeof(GlVertex)),
               geometry.vertices.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[4]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
               indices.data(), GL_STATIC_DRAW);
  for (GLuint i = 0; i < 3; ++i) {
    glEnableVertexAttribArray(i);
    glVertexAttribPointer(i, i == 2 ? 2 : 3, GL_FLOAT, GL_FALSE, sizeof(GlVertex),
                          reinterpret_cast<const void*>(i * sizeof(glm::vec3)));
  }
  const glm::mat4 to_clip = matrix_of(scene, size);
  for (Batch& batch : geometry.batches) {
    const Image& texels = batch.material->diffuse_map.texels;
    const bool textured = !texels.cells().empty();
    batch.program =
        program_of(fmt::format("#define PER_PIXEL {}\n#define BOTH_SIDES {}\n#define TEXTURED {}\n#define "
                               "SHINES {}\n#define LAMPS {}\n",
                               int{scene.shading == Shading::phong}, int{batch.both_sides}, int{textured},
                               batch.material->specular != LinearRgb{0}, scene.lights.size()));
    if (textured) batch.texture = texture_of(scene, texels);
    set_uniforms(scene, batch, to_clip);
    own_->batches.push_back(std::move(batch));
  }
  glFinish();
}

Llvmpipe::~Llvmpipe() { OSMesaDestroyContext(own_->context); }

void Llvmpipe::draw() {
  glClearColor(own_->background.r, own_->background.g, own_->background.b, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (const Batch& batch : own_->batches) {
    if (batch.both_sides)
      glDisable(GL_CULL_FACE);
    else
      glEnable(GL_CULL_FACE);
    glUseProgram(batch.program);
    if (batch.texture != 0) glBindTexture(GL_TEXTURE_2D, batch.texture);
    glDrawElements(
        GL_TRIANGLES, static_cast<GLsizei>(batch.indices.size()), GL_UNSIGNED_INT,
        reinterpret_cast<const void*>(static_cast<std::size_t>(batch.first) * sizeof(std::uint32_t)));
  }
  glFinish();
}

Image Llvmpipe::picture() const {
  const auto [width, height] = own_->size;
  Image upside_down(width, height), image(width, height);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.cells().data());
  for (int y = 0; y < height; ++y) std::ranges::copy(upside_down.row(height - 1 - y), image.row(y).begin());
  return image;
}

std::string Llvmpipe::renderer() { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }

}  // namespace gradus::bench::peers

#endif
