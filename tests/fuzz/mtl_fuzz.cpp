// Material libraries: sound materials, each name once, or a refusal with its line.

#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/image.hpp"
#include "scene/models/materials.hpp"
#include "support/fuzz_input.hpp"

using namespace gradus;
using gradus::test::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  std::vector<std::string> notes;
  try {
    std::set<std::string> names;
    for (const Material& m : pipeline::parse_mtl(text, "m.mtl", notes)) {
      require(names.insert(m.name).second, "a name stands for one material");
      for (const LinearRgb& c : {m.ambient, m.diffuse, m.specular, m.emission}) {
        for (int i = 0; i < 3; ++i)
          require(std::isfinite(c[i]) && c[i] >= 0, "light is finite and not negative");
      }
      require(std::isfinite(m.shininess) && m.shininess >= 0, "a highlight has an exponent");
      require(0 <= m.opacity && m.opacity <= 1, "opacity lies between 0 and 1");
    }
  } catch (const InputError& error) {
    const std::string what = error.what();
    require(what.starts_with("m.mtl:"), "an error names its file");
    require(test::harmless(what), "an error is safe to show");
  }
  for (const std::string& note : notes) require(test::harmless(note), "a note is safe to show");
  return 0;
}
