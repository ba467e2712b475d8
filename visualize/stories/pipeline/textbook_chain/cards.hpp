#pragma once
// What the card of each stage says: the numbers that the stage computed for the followed triangle and pixel.

#include <optional>
#include <string>

#include "stories/pipeline/textbook_chain/card.hpp"
#include "stories/pipeline/textbook_chain/panels.hpp"
#include "stories/pipeline/textbook_chain/way.hpp"
#include "stories/telling.hpp"

namespace gradus::textbook_chain {

/// Below it a number of a picture, of a depth or of light is a rounding error.
inline constexpr double small = 1e-6;
/// A number as the tour shows it: what is smaller than `noise` is a rounding error.
inline std::string real_text(double value, double noise = small) { return figure_real(value, noise); }
/// "(1, −0.5, 2)".
template <int N>
std::string place_text(const glm::vec<N, double>& p, double noise = small) {
  return figure_place(p, [noise](double number) { return real_text(number, noise); });
}
inline std::string place_text(dvec3 p, double noise = small) { return place_text<3>(p, noise); }

/// "E0", "E1", "E2": the edge functions, each of the edge opposite a corner.
inline std::string edge_name(std::size_t edge) { return fmt::format("E{}", edge); }

/// "z = 0.49 < 0.63": a fragment's depth and what it was compared with.
std::string depth_text(const Words& words, const pipeline::DepthTested& test);

class Cards {
 public:
  Cards(const Run& run, const Followed& followed, const Way& way, const Words& words, const ChainPaper& paper)
      : run_(run),
        piece_(run.pieces[followed.piece]),
        faced_(run.faced[followed.piece]),
        pixel_(followed.pixel),
        way_(way),
        words_(words),
        paper_(paper) {}

  /// Above all: the stages, this one with its name.
  void strip(View& view, std::size_t stage) const;
  /// What is to come: the names of the stages.
  void stages(View& view) const;
  /// 1: what the file says.
  void file(View& view) const;
  /// 2 and 3: the matrix times one corner, of the piece's three.
  void placement(View& view, std::size_t corner) const;
  void projection(View& view, std::size_t corner) const;
  /// 4: det[x y w].
  void determinant(View& view) const;
  /// 5: where edges are cut, and each corner divided by its w.
  void division(View& view) const;
  /// 6: edge functions, shares and depth at the followed pixel; `found`: what a faulty stage has instead.
  void edges(View& view, const EdgeValues& values, const std::optional<dvec3>& found = {}) const;
  /// 7: what the pixel's depths were compared with, up to this one.
  void depth(View& view, const pipeline::DepthTested& last) const;
  /// 7: the terms of the light, by lamp.
  void light(View& view) const;
  /// 8: from light to bytes; and all that led to it.
  void bytes(View& view) const;
  void way(View& view) const;

 private:
  Card card(View& view, const char* name) const { return {view, name, paper_.card(), paper_.unit()}; }
  void product(Card& card, const std::string& matrix, const glm::dmat4& m, std::size_t corner,
               const glm::dvec4& from, const glm::dvec4& to) const;
  /// How the followed pixel's place moves.
  void moves(Card& card, const std::string& from, const std::string& to) const;
  void cut(Card& card, const EdgeCut& cut) const;
  void lamp(Card& card, const LampLight& lamp) const;
  std::string vertex_name(std::size_t corner) const {
    return fmt::format("v{}", piece_.corners[corner].vertex);
  }
  std::string corner_name(const glm::dvec4& at) const;
  std::string plane_text(const EdgeCut& cut) const;
  std::string length_text(double x) const { return real_text(x, run_.noise); }
  template <int N>
  std::string at_text(const glm::vec<N, double>& p) const {
    return place_text(p, run_.noise);
  }
  const pipeline::Projected& projected(std::size_t corner) const {
    return run_.clip[static_cast<std::size_t>(piece_.corners[corner].vertex)];
  }
  std::string see(const char* key, std::initializer_list<Word> values = {}) const {
    return words_.say(key, values);
  }

  const Run& run_;
  const pipeline::Piece& piece_;
  const pipeline::Faced& faced_;
  const ivec2 pixel_;
  const Way& way_;
  const Words& words_;
  const ChainPaper& paper_;
};

}  // namespace gradus::textbook_chain
