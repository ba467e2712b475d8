#include "scene/models/stl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/refusal.hpp"
#include "core/shown.hpp"
#include "scene/models/faces_by_place.hpp"
#include "scene/models/letters.hpp"
#include "scene/models/little_endian.hpp"
#include "scene/models/statements.hpp"

namespace gradus::pipeline {
namespace {

/// Bytes of a binary file: before the number of triangles, before the triangles, and of each.
constexpr std::size_t stl_count = 80, stl_head = stl_count + 4, stl_record = 50;

/// Triangles that a binary file tells of.
std::uint64_t told_triangles(std::string_view bytes) { return whole_at(bytes, stl_count, 4); }

/// Whether all triangles are there that a binary file of these bytes would have. In a text the four bytes
/// that tell are characters, at least 9 each: it would be a file of gigabytes.
bool is_binary(std::string_view bytes) {
  return bytes.size() >= stl_head && told_triangles(bytes) <= (bytes.size() - stl_head) / stl_record;
}

class StlReader {
 public:
  explicit StlReader(const TextFile& file) : file_(file) { model_.mesh.files.push_back(file.name); }

  ModelFile binary(std::string_view bytes) {
    const auto count = static_cast<std::size_t>(told_triangles(bytes));  // all are there
    bool attributes = false;
    for (std::size_t i = 0; i < count; ++i) {
      const std::string_view triangle = bytes.substr(stl_head + stl_record * i, stl_record);
      const auto vector = [&](std::size_t number) {
        const auto part = [&](std::size_t axis) { return float_at(triangle, 12 * number + 4 * axis); };
        return dvec3{part(0), part(1), part(2)};
      };
      normal_ = sound(vector(0)) ? vector(0) : dvec3{0};
      for (const std::size_t corner : {1u, 2u, 3u}) {
        if (!sound(vector(corner)))
          refuse(fmt::format("expected coordinates within 1e30 of 0 in triangle {}, found others", i + 1));
        corners_.push_back(vector(corner));
      }
      attributes |= whole_at(triangle, stl_record - 2, 2) != 0;
      add_facet(0);
    }
    const std::size_t left = bytes.size() - stl_head - stl_record * count;
    if (attributes) note("attributes of triangles, such as their colours, are not used");
    if (left > 0) note(fmt::format("{} bytes behind its {} triangles are left out", left, count));
    return finish();
  }

  ModelFile text(std::string_view text) {
    Statements lines(text, file_, Statements::Backslash::is_a_letter);
    lines_ = &lines;
    while (true) {
      const std::string word = next();
      if (word == "facet") {
        facet();
      } else if (word == "solid") {
        inside_ = true;
        skip_name();
      } else if (word == "endsolid") {
        inside_ = false;
        skip_name();
      } else if (word.empty()) {
        break;
      } else {
        expected("solid, facet or endsolid", word);
      }
    }
    if (inside_) note("it ends without endsolid: something may be missing");
    return finish();
  }

 private:
  static bool sound(dvec3 v) {
    const auto near = [](double x) { return std::abs(x) <= Statement::largest; };
    return near(v.x) && near(v.y) && near(v.z);
  }

  [[noreturn]] void refuse(std::string_view what) const {
    refuse_input(fmt::format("{}: {}", shown_name(file_.name), what));
  }
  [[noreturn]] void expected(std::string_view what, std::string_view found) const {
    if (found.empty()) refuse(fmt::format("expected {}, found the end of the file", what));
    now_->fail(fmt::format("expected {}, found {}", what, now_->quoted(found)));
  }
  void note(std::string_view what) {
    model_.notes.push_back(fmt::format("{}: {}", shown_name(file_.name), what));
  }

  /// The next word of the text in small letters; empty at its end.
  std::string next() {
    while (!now_ || !now_->more()) {
      now_ = lines_->next();
      if (!now_) return "";
    }
    return in_small_letters(now_->word());
  }
  /// The name of a solid: the rest of its line, or, for blanks part words as line ends do, what stands there
  /// before its facets, its end or another solid.
  void skip_name() {
    while (now_->more()) {
      Statement ahead = *now_;
      const std::string word = in_small_letters(ahead.word());
      if (word == (inside_ ? "endsolid" : "solid")) return;
      if (inside_ && word == "facet" && in_small_letters(ahead.word()) == "normal") return;
      now_->word();
    }
  }
  void expect(std::string_view keyword) {
    if (const std::string word = next(); word != keyword) expected(keyword, word);
  }
  double number(std::string_view what) {
    const std::string word = next();
    if (word.empty()) expected(fmt::format("a number for {}", what), word);
    return now_->number(what, word);
  }

  void facet() {
    const int line = now_->line();
    expect("normal");
    normal_ = normal();
    expect("outer");
    expect("loop");
    for (std::string word = next(); word != "endloop"; word = next()) {
      if (word != "vertex") expected("vertex or endloop", word);
      const double x = number("the vertex"), y = number("the vertex"), z = number("the vertex");
      corners_.emplace_back(x, y, z);
    }
    if (corners_.size() < 3)
      now_->fail(fmt::format("expected a loop of at least 3 vertices, found {}", corners_.size()));
    expect("endfacet");
    add_facet(line);
  }

  /// "nan nan nan" is what exporters write for triangles without an area.
  dvec3 normal() {
    dvec3 n{0};
    bool numbers = true;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string word = next();
      if (Statement::is_no_number(word))
        numbers = false;
      else if (word.empty())
        expected("a number for the normal", word);
      else
        n[axis] = now_->number("the normal", word);
    }
    return numbers ? n : dvec3{0};
  }

  /// Adds the facet of these corners and starts the next one.
  void add_facet(int line) {
    const auto normal = static_cast<int>(model_.mesh.normals.size());
    model_.mesh.normals.push_back(unit_vector(normal_));
    std::vector<Corner> corners;
    for (const dvec3& corner : std::exchange(corners_, {}))
      corners.push_back({places_.number_of(corner), -1, normal});
    add_face(model_.mesh, corners, 0, 0, line);
  }

  ModelFile finish() {
    const std::vector<int> flat(model_.mesh.faces.size(), 0);
    return finished(std::move(model_), file_, flat);
  }

  const TextFile& file_;
  ModelFile model_;
  Places places_{model_.mesh};
  Statements* lines_ = nullptr;
  std::optional<Statement> now_;
  bool inside_ = false;         ///< of a solid
  dvec3 normal_{0};             ///< of the facet being read
  std::vector<dvec3> corners_;  ///< of it
};

}  // namespace

ModelFile parse_stl(std::string_view bytes, const TextFile& file) {
  if (is_binary(bytes)) return StlReader(file).binary(bytes);
  const std::string_view begin = bytes.substr(0, stl_head);
  const std::size_t word = std::min(begin.find_first_not_of(" \t\r\n\xef\xbb\xbf"), begin.size());
  const bool solid = in_small_letters(begin.substr(word, 5)) == "solid";
  if (solid && begin.find('\0') == std::string_view::npos) return StlReader(file).text(bytes);
  const std::string found = bytes.size() >= stl_head && file.quotable
                                ? fmt::format("one that tells of {} triangles and has {} bytes",
                                              told_triangles(bytes), bytes.size())
                                : "something else";
  refuse_input(fmt::format("{}: expected an STL file, a text of solids or binary and whole, found {}",
                           shown_name(file.name), found));
}

}  // namespace gradus::pipeline
