// OFF, PLY and STL: sound meshes or a refusal in one line that names the file. The first byte says which.

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/image.hpp"
#include "scene/models/off.hpp"
#include "scene/models/ply.hpp"
#include "scene/models/stl.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using gradus::test::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    const pipeline::ModelFile model = data[0] == 'o'   ? pipeline::parse_off(bytes, "m")
                                      : data[0] == 'p' ? pipeline::parse_ply(bytes, "m")
                                                       : pipeline::parse_stl(bytes, "m");
    const Mesh& mesh = model.mesh;
    require(!mesh.faces.empty(), "a model has a face");
    for (const dvec3& at : mesh.positions)
      for (int i = 0; i < 3; ++i) require(std::abs(at[i]) <= 1e30, "places are near");
    const auto within = [](int index, std::size_t count) {
      return index < 0 || static_cast<std::size_t>(index) < count;
    };
    for (const Corner& corner : mesh.corners) {
      require(corner.position >= 0 && within(corner.position, mesh.positions.size()), "positions are there");
      require(within(corner.texture, mesh.textures.size()), "texture coordinates are there");
      require(corner.normal >= 0 && within(corner.normal, mesh.normals.size()), "normals are there");
    }
    for (const std::string& note : model.notes) require(test::harmless(note), "a note is safe to show");
  } catch (const InputError& error) {
    const std::string what = error.what();
    require(what.starts_with("m:"), "an error names its file");
    require(test::harmless(what), "an error is safe to show");
  }
  return 0;
}
