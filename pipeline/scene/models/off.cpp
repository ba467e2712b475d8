#include "scene/models/off.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/refusal.hpp"
#include "core/shown.hpp"
#include "scene/models/faces_by_place.hpp"
#include "scene/models/statements.hpp"

namespace gradus::pipeline {
namespace {

class OffReader {
 public:
  OffReader(std::string_view text, const TextFile& file)
      : file_(file), lines_(text, file, Statements::Backslash::is_a_letter) {
    model_.mesh.files.push_back(file.name);
  }

  ModelFile read() {
    Statement counts = head();
    const std::int64_t vertices = counts.whole("the number of vertices", 0, largest_count);
    const std::int64_t faces = counts.whole("the number of faces", 0, largest_count);
    if (counts.more()) counts.whole("the number of edges", 0, largest_count);
    counts.end("the numbers of vertices, faces and edges");
    for (std::int64_t i = 0; i < vertices; ++i) vertex(line("vertices", i, vertices));
    for (std::int64_t i = 0; i < faces; ++i) face(line("faces", i, faces));
    if (coloured_) note("colours of vertices and faces are not used");
    if (const auto more = lines_.next())
      model_.notes.push_back(more->place("what stands behind the last face is left out"));
    return finished(std::move(model_), file_);
  }

 private:
  static constexpr std::int64_t largest_count = std::int64_t{1}
                                                << 28;  // more lines than the largest file has

  void note(std::string_view what) {
    model_.notes.push_back(fmt::format("{}: {}", shown_name(file_.name), what));
  }

  /// Reads [ST][C][N]OFF, which may be left out and after which the counts may stand; some glue them to it.
  Statement head() {
    constexpr std::string_view expected = "expected an OFF file, which begins with OFF, ";
    std::optional<Statement> first = lines_.next();
    if (!first) refuse_input(fmt::format("{}: {}found none", shown_name(file_.name), expected));
    Statement ahead = *first;
    std::string_view word = ahead.word();
    const std::string_view whole = word;
    if (word.find_first_not_of("0123456789") == std::string_view::npos) return *first;
    const auto take = [&word](std::string_view letters) {
      const bool there = word.starts_with(letters);
      if (there) word.remove_prefix(letters.size());
      return there;
    };
    has_textures_ = take("ST"), has_colours_ = take("C"), has_normals_ = take("N");
    if (!take("OFF")) first->fail(fmt::format("{}found {}", expected, first->quoted(whole)));
    if (!word.empty()) {
      glued_ = std::string(word) + " " + std::string(ahead.rest());
      return {glued_, file_, first->line()};
    }
    if (ahead.more()) return ahead;
    if (std::optional<Statement> second = lines_.next()) return *second;
    first->fail("expected the numbers of vertices, faces and edges, found the end of the file");
  }

  Statement line(std::string_view what, std::int64_t so_far, std::int64_t all) {
    if (std::optional<Statement> next = lines_.next()) return *next;
    refuse_input(fmt::format("{}: expected {} {}, found {}", shown_name(file_.name), all, what, so_far));
  }

  static dvec3 triple(Statement& s, std::string_view what) {
    const double x = s.number(what), y = s.number(what), z = s.number(what);
    return {x, y, z};
  }

  /// x y z, its normal, its colour, its texture coordinates. Many write colours without a C in front.
  void vertex(Statement s) {
    positions_.push_back(places_.number_of(triple(s, "the vertex")));
    if (has_normals_) model_.mesh.normals.push_back(unit_vector(triple(s, "the normal")));
    std::vector<double> more;
    while (s.more()) more.push_back(s.number("the vertex"));
    if (has_textures_) {
      if (more.size() < 2) s.fail("expected two texture coordinates at the end, found none");
      model_.mesh.textures.emplace_back(more[more.size() - 2], more.back());
      more.resize(more.size() - 2);
    }
    if (has_colours_ ? more.empty() : !more.empty() && more.size() != 3 && more.size() != 4)
      s.fail(fmt::format("expected a vertex and at most a colour of 3 or 4 numbers, found {} numbers of one",
                         more.size()));
    coloured_ |= !more.empty();
  }

  /// The number of corners, the corners, and a colour of 1, 3 or 4 numbers.
  void face(Statement s) {
    const auto count = s.whole("the number of corners", 1, largest_count);
    std::vector<Corner> corners;
    const std::string expected = fmt::format("one of the {} vertices", positions_.size());
    for (std::int64_t i = 0; i < count; ++i) {
      const auto vertex = static_cast<int>(s.whole(expected, 0, std::ssize(positions_) - 1));
      corners.push_back({positions_[static_cast<std::size_t>(vertex)], has_textures_ ? vertex : -1,
                         has_normals_ ? vertex : -1});
    }
    int colours = 0;
    for (; s.more(); ++colours) s.number("a colour");
    if (colours > 4) s.fail(fmt::format("expected a colour of at most 4 numbers, found {}", colours));
    coloured_ |= colours > 0;
    if (count >= 3)
      add_face(model_.mesh, corners, 0, 0, s.line());
    else
      (count == 2 ? model_.lines : model_.points) += 1;
  }

  const TextFile& file_;
  Statements lines_;
  ModelFile model_;
  Places places_{model_.mesh};
  std::vector<int> positions_;  ///< of each vertex
  std::string glued_;           ///< the counts, where they stand glued to OFF
  bool has_textures_ = false, has_colours_ = false, has_normals_ = false, coloured_ = false;
};

}  // namespace

ModelFile parse_off(std::string_view text, const TextFile& file) { return OffReader(text, file).read(); }

}  // namespace gradus::pipeline
