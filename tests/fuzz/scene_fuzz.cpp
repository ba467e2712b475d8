// Scenes: whatever the bytes are, they are read as a scene that can be drawn or refused with file and line.

#include <cmath>
#include <cstdint>
#include <glm/matrix.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "core/refusal.hpp"
#include "scene/scene_file.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using gradus::test::require;

namespace {

std::optional<pipeline::FoundModel> found(const std::string& name) {
  if (name.empty() || name[0] == 'x') return std::nullopt;
  return pipeline::FoundModel{std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "m.obj",
                              [](const std::string&) { return std::nullopt; }};
}

bool finite(dvec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void expect_sound(const pipeline::CameraPath& path, const pipeline::View& beside) {
  require(0 <= path.first && path.first < path.last && path.last <= pipeline::most_frame, "frames");
  require(!path.eye.empty() || beside.eye, "an eye is told");
  for (const double share : {0.0, 0.3, 0.5, 1.0}) {
    const pipeline::View view = view_at(path, beside, path.first + share * (path.last - path.first));
    require(view.eye && finite(*view.eye), "an eye is somewhere");
    require(0 < view.vertical_radians && view.vertical_radians < 3.1416, "an angle of view on a path");
  }
}

void expect_sound(const pipeline::SceneFile& file) {
  require(!file.scene.objects.empty(), "a scene has an object");
  for (const pipeline::Object& object : file.scene.objects) {
    const double volume = glm::determinant(glm::dmat3(object.placement));
    require(std::isfinite(volume) && volume != 0, "a place has an inverse");
    require(finite(dvec3(object.placement[3])) && object.placement[3][3] == 1, "a place is affine");
  }
  for (const Light& light : file.scene.lights) {
    require(finite(light.position) && light.range > 0, "a light stands somewhere");
    require(light.constant >= 0 && light.linear >= 0 && light.quadratic >= 0 &&
                light.constant + light.linear + light.quadratic > 0,
            "light weakens");
    require(-1 <= light.outer_cosine && light.outer_cosine <= light.inner_cosine && light.inner_cosine <= 1,
            "an inner cone lies within the outer one");
    const bool aimed = light.kind == Light::Kind::directional || light.kind == Light::Kind::spot;
    require(!aimed || light.direction != dvec3{0}, "a direction is one");
  }
  if (file.depths) require(0 < file.depths->x && file.depths->x < file.depths->y, "far lies behind near");
  require(0 < file.view.vertical_radians && file.view.vertical_radians < 3.1416, "an angle of view");
  require(file.view.up != dvec3{0}, "up is a direction");
  if (file.path) expect_sound(*file.path, file.view);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    expect_sound(pipeline::parse_scene(text, "s.json", found, {}));
  } catch (const InputError& error) {
    const std::string_view what = error.what();
    require(what.starts_with("s.json:") || what.starts_with("m.obj:"), "a mistake has its file");
    require(test::harmless(what), "a message is safe to show");
  }
  return 0;
}
