#include "scene/materials.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <unordered_set>
#include <utility>

#include "scene/statements.hpp"

namespace gradus::pipeline {
namespace {

/// A material as it is being read.
struct Draft {
  Material material;
  bool has_ambient = false;
  bool highlight = true;

  Material finished() const {
    Material done = material;
    if (!has_ambient) done.ambient = done.diffuse;
    if (!highlight) done.specular = LinearRgb{0};
    return done;
  }
};

double share(Statement& s, std::string_view what) {
  const double value = s.number(what);
  if (value < 0) s.fail(fmt::format("expected {} of 0 or more, found {}", what, s.quoted(value)));
  return value;
}

/// "r g b", or "r" for all three.
LinearRgb colour(Statement& s, std::string_view what) {
  Statement ahead = s;
  const std::string_view first = ahead.word();
  if (first == "spectral" || first == "xyz")
    s.fail(fmt::format("expected {} as r g b, found {}", what, first));
  const auto r = static_cast<float>(share(s, what));
  if (!s.more()) return LinearRgb{r};
  const auto g = static_cast<float>(share(s, what));
  const auto b = static_cast<float>(share(s, what));
  s.end(what);
  return {r, g, b};
}

bool numeric(std::string_view word) {
  return !word.empty() &&
         (std::isdigit(static_cast<unsigned char>(word[0])) || word[0] == '-' || word[0] == '+' ||
          word[0] == '.') &&
         word.find_first_not_of("+-.0123456789eE") == std::string_view::npos;
}

/// The file name of a map, behind its options.
std::string map_file(Statement& s) {
  while (true) {
    Statement ahead = s;
    const std::string_view option = ahead.word();
    if (option.size() < 2 || option[0] != '-') return std::string(s.rest());
    s.word();
    constexpr std::array one{"-blendu", "-blendv",     "-boost",   "-bm",     "-cc",
                             "-clamp",  "-colorspace", "-imfchan", "-texres", "-type"};
    if (std::ranges::find(one, option) != one.end()) {
      s.word();
    } else if (option == "-mm" || option == "-o" || option == "-s" || option == "-t") {
      for (int i = 0; i < 3; ++i) {
        Statement number = s;
        if (!numeric(number.word())) break;
        s.word();
      }
    } else {
      s.fail(fmt::format("expected an option of a map, found {}", s.quoted(option)));
    }
  }
}

bool known_but_unused(std::string_view key) {
  constexpr std::array numbers{"Ni",    "Pr",     "Pm",        "Ps", "Pc", "Pcr",
                               "aniso", "anisor", "sharpness", "Km", "Kt", "Tf"};
  return std::ranges::find(numbers, key) != numbers.end();
}

bool other_map(std::string_view key) {
  constexpr std::array maps{"bump", "disp", "decal", "refl", "norm"};
  return key.substr(0, 4) == "map_" || std::ranges::find(maps, key) != maps.end();
}

class MtlReader {
 public:
  MtlReader(std::vector<std::string>& notes) : notes_(notes) {}

  void read(Statement& s) {
    const std::string_view key = s.word();
    if (key == "newmtl") return begin(s);
    if (drafts_.empty()) s.fail(fmt::format("expected newmtl first, found {}", s.quoted(key)));
    Draft& draft = drafts_.back();
    Material& m = draft.material;
    if (key == "Ka") {
      m.ambient = colour(s, key);
      draft.has_ambient = true;
    } else if (key == "Kd") {
      m.diffuse = colour(s, key);
    } else if (key == "Ks") {
      m.specular = colour(s, key);
    } else if (key == "Ke") {
      m.emission = colour(s, key);
    } else if (key == "Ns") {
      m.shininess = static_cast<float>(share(s, key));
      s.end(key);
    } else if (key == "d" || key == "Tr") {
      opacity(s, key, m);
    } else if (key == "illum") {
      draft.highlight = s.number(key) >= 2;
      s.end(key);
    } else if (key == "map_Kd") {
      m.diffuse_map = texture(s);
      if (m.diffuse_map.file.empty())
        notes_.push_back(s.place("map_Kd names no file: the material has no texture"));
    } else if (known_but_unused(key)) {
      do s.number(key);
      while (s.more());
    } else if (!other_map(key)) {
      unknown_.add(s, key);
    }
  }

  std::vector<Material> finish() const {
    std::vector<Material> materials;
    for (const Draft& draft : drafts_) materials.push_back(draft.finished());
    for (std::string& note : unknown_.notes("an MTL file")) notes_.push_back(std::move(note));
    return materials;
  }

 private:
  static Texture texture(Statement& s) {
    std::string file = map_file(s);
    std::string place = s.place(fmt::format("map_Kd {}", s.quoted(file)));
    return {std::move(file), {}, std::move(place), s.file().quotable};
  }

  void begin(Statement& s) {
    const std::string name(s.rest());
    if (name.empty()) notes_.push_back(s.place("a material without a name, which nothing can use"));
    if (!names_.insert(name).second)
      s.fail(fmt::format("expected another name for each material, found {} again", s.quoted(name)));
    drafts_.emplace_back();
    drafts_.back().material.name = name;
  }

  /// d is 1 where nothing shines through, Tr 0.
  static void opacity(Statement& s, std::string_view key, Material& m) {
    Statement ahead = s;
    if (key == "d" && ahead.word() == "-halo") s.word();
    const double value = s.number(key);
    s.end(key);
    if (value < 0 || value > 1)
      s.fail(fmt::format("expected {} from 0 to 1, found {}", key, s.quoted(value)));
    m.opacity = static_cast<float>(key == "d" ? value : 1 - value);
  }

  std::vector<Draft> drafts_;
  std::unordered_set<std::string> names_;
  UnknownStatements unknown_;
  std::vector<std::string>& notes_;
};

}  // namespace

std::vector<Material> parse_mtl(std::string_view text, const TextFile& file,
                                std::vector<std::string>& notes) {
  Statements statements(text, file);
  MtlReader reader(notes);
  while (std::optional<Statement> s = statements.next()) reader.read(*s);
  return reader.finish();
}

}  // namespace gradus::pipeline
