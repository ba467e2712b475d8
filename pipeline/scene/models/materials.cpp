#include "scene/models/materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <optional>
#include <unordered_set>
#include <utility>

#include "core/shown.hpp"
#include "scene/models/letters.hpp"
#include "scene/models/statements.hpp"

namespace gradus::pipeline {
namespace {

/// A material as it is being read.
struct Draft {
  LibraryMaterial material;
  bool has_ambient = false;
  bool highlight = true;

  LibraryMaterial finished() const {
    LibraryMaterial done = material;
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

/// A map_Kd statement.
struct MapStatement {
  std::string file;
  TexturePlacement placement{};
  std::vector<std::string> unused{};  ///< options that would change the picture: "-clamp"
};

/// Up to three numbers; those that are not there are as before.
void read_numbers(Statement& s, std::string_view option, dvec3& numbers) {
  for (int i = 0; i < 3; ++i) {
    Statement ahead = s;
    const std::string_view word = ahead.word();
    if (!numeric(word)) return;
    numbers[i] = s.number(option, word);
    s = ahead;
  }
}

/// Reads the options of a map and the file's name behind them.
MapStatement map_in(Statement& s) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 10> words{{{"-blendu", "on"},
                                                                                 {"-blendv", "on"},
                                                                                 {"-boost", ""},
                                                                                 {"-bm", ""},
                                                                                 {"-cc", "off"},
                                                                                 {"-clamp", "off"},
                                                                                 {"-colorspace", ""},
                                                                                 {"-imfchan", ""},
                                                                                 {"-texres", ""},
                                                                                 {"-type", ""}}};
  MapStatement map;
  while (true) {
    Statement ahead = s;
    const std::string_view written = ahead.word();
    const std::string option = in_small_letters(written);
    if (option.size() < 2 || option[0] != '-') break;
    s = ahead;
    const auto one = std::ranges::find(words, std::string_view(option), &decltype(words)::value_type::first);
    bool used = true;
    if (one != words.end()) {
      used = in_small_letters(s.word()) == one->second;
    } else if (option == "-s" || option == "-o") {
      dvec2& part = option == "-s" ? map.placement.scale : map.placement.offset;
      dvec3 numbers{part, 0};
      read_numbers(s, option, numbers);
      part = dvec2(numbers);
    } else if (option == "-mm" || option == "-t") {
      const dvec3 neutral = option == "-mm" ? dvec3{0, 1, 0} : dvec3{0};
      dvec3 numbers = neutral;
      read_numbers(s, option, numbers);
      used = numbers == neutral;
    } else {
      s.fail(fmt::format("expected an option of a map, found {}", s.quoted(written)));
    }
    if (!used) map.unused.push_back(option);
  }
  map.file = s.rest();
  return map;
}

/// What the numbers of a statement that is not used are where they change nothing; none where no picture of
/// opaque surfaces without reflections shows them.
struct UnusedNumbers {
  std::string_view key;
  std::optional<double> neutral;
};

const UnusedNumbers* unused_numbers(std::string_view key) {
  static constexpr std::array<UnusedNumbers, 12> all{{{"ni", {}},
                                                      {"sharpness", {}},
                                                      {"tf", 1},
                                                      {"pr", 0},
                                                      {"pm", 0},
                                                      {"ps", 0},
                                                      {"pc", 0},
                                                      {"pcr", 0},
                                                      {"aniso", 0},
                                                      {"anisor", 0},
                                                      {"km", 0},
                                                      {"kt", 0}}};
  const auto found = std::ranges::find(all, key, &UnusedNumbers::key);
  return found == all.end() ? nullptr : &*found;
}

bool other_map(std::string_view key) {
  constexpr std::array maps{"bump", "disp", "decal", "refl", "norm"};
  return key.substr(0, 4) == "map_" || std::ranges::find(maps, key) != maps.end();
}

/// What a library says and no picture shows: told in one note, at the first of it.
class NotDrawn {
 public:
  void add(const Statement& s, std::string what) {
    constexpr std::size_t most = 16;
    if (line_ == 0) line_ = s.line();
    if (std::ranges::find(all_, what) != all_.end()) return;
    if (all_.size() < most)
      all_.push_back(std::move(what));
    else
      more_ = true;
  }
  void tell(const TextFile& file, std::vector<std::string>& notes) const {
    if (all_.empty()) return;
    notes.push_back(fmt::format("{}:{}: {}{} {} not drawn", shown_name(file.name), line_,
                                fmt::join(all_, ", "), more_ ? " and others" : "",
                                all_.size() == 1 ? "is" : "are"));
  }

 private:
  std::vector<std::string> all_;
  bool more_ = false;
  int line_ = 0;
};

class MtlReader {
 public:
  MtlReader(std::vector<std::string>& notes) : notes_(notes) {}

  void read(Statement& s) {
    const std::string_view key = s.word();
    const std::string small = in_small_letters(key);
    if (small == "newmtl") return begin(s);
    if (drafts_.empty()) s.fail(fmt::format("expected newmtl first, found {}", s.quoted(key)));
    Draft& draft = drafts_.back();
    LibraryMaterial& m = draft.material;
    if (small == "ka") {
      m.ambient = colour(s, key);
      draft.has_ambient = true;
    } else if (small == "kd") {
      m.diffuse = colour(s, key);
    } else if (small == "ks") {
      m.specular = colour(s, key);
    } else if (small == "ke") {
      m.emission = colour(s, key);
    } else if (small == "ns") {
      m.shininess = static_cast<float>(share(s, key));
      s.end(key);
    } else if (small == "d" || small == "tr") {
      opacity(s, key, m);
    } else if (small == "illum") {
      illumination(s, key, draft);
    } else if (small == "map_kd") {
      texture(s, m);
    } else if (const UnusedNumbers* numbers = unused_numbers(small)) {
      unused(s, key, *numbers);
    } else if (other_map(small)) {
      not_drawn_.add(s, s.file().quotable ? visible(key) : "another map");
    } else {
      unknown_.add(s, key);
    }
  }

  std::vector<LibraryMaterial> finish(const TextFile& file) const {
    std::vector<LibraryMaterial> materials;
    for (const Draft& draft : drafts_) materials.push_back(draft.finished());
    not_drawn_.tell(file, notes_);
    for (std::string& note : unknown_.notes("an MTL file")) notes_.push_back(std::move(note));
    return materials;
  }

 private:
  void texture(Statement& s, LibraryMaterial& m) {
    MapStatement map = map_in(s);
    for (const std::string& option : map.unused) not_drawn_.add(s, option + " of map_Kd");
    if (map.file.empty()) notes_.push_back(s.place("map_Kd names no file: the material has no texture"));
    std::string place = s.place(fmt::format("map_Kd {}", s.quoted(map.file)));
    m.diffuse_map = {std::move(map.file), {}, std::move(place), s.file().quotable};
    m.placement = map.placement;
  }

  /// 0 and 1 have no highlight; above 2 are mirrors and glass.
  void illumination(Statement& s, std::string_view key, Draft& draft) {
    const double model = s.number(key);
    s.end(key);
    draft.highlight = model >= 2;
    if (model > 2) not_drawn_.add(s, "illum above 2");
  }

  void unused(Statement& s, std::string_view key, const UnusedNumbers& numbers) {
    bool seen = false;
    do seen |= s.number(key) != numbers.neutral.value_or(0);
    while (s.more());
    if (seen && numbers.neutral) not_drawn_.add(s, std::string(key));
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
    const bool is_dissolve = key == "d" || key == "D";
    Statement ahead = s;
    if (is_dissolve && in_small_letters(ahead.word()) == "-halo") s.word();
    const double value = s.number(key);
    s.end(key);
    if (value < 0 || value > 1)
      s.fail(fmt::format("expected {} from 0 to 1, found {}", key, s.quoted(value)));
    m.opacity = static_cast<float>(is_dissolve ? value : 1 - value);
  }

  std::vector<Draft> drafts_;
  std::unordered_set<std::string> names_;
  UnknownStatements unknown_;
  NotDrawn not_drawn_;
  std::vector<std::string>& notes_;
};

}  // namespace

std::vector<LibraryMaterial> parse_mtl(std::string_view text, const TextFile& file,
                                       std::vector<std::string>& notes) {
  Statements statements(text, file);
  MtlReader reader(notes);
  while (std::optional<Statement> s = statements.next()) reader.read(*s);
  return reader.finish(file);
}

}  // namespace gradus::pipeline
