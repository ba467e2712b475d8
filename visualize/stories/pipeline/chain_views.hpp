#pragma once
// The drawings of the tour: the model in the space of each stage, and the picture's cells from stage 6 on.

#include "figure/drawing.hpp"
#include "stories/pipeline/chain_run.hpp"
#include "stories/telling.hpp"

namespace gradus::textbook_chain {

/// What an event points at: the corner of the followed piece, or of what clipping has left of it, and its
/// text.
struct Pointer {
  std::optional<std::size_t> corner{};  ///< without: at none
  std::string text{};
};

/// The drawings of a run.
class Views {
 public:
  Views(const Run& run, const Followed& followed, const Words& words)
      : run_(run), piece_(run.pieces[followed.piece]), pixel_(followed.pixel), words_(words) {}

  View object(const Pointer& at = {}) const;
  View world(const Pointer& at = {}) const;
  View clip_space(const Pointer& at = {}) const;
  View facing() const;
  View clipping(const Pointer& at = {}) const;
  /// Cells of the followed piece down to this row; -1: before the first.
  View raster(int last_row, const Pointer& at = {}) const;
  /// Which fragments of the followed piece are nearest; the followed pixel with the light that it has.
  View visible(bool lit) const;
  /// The picture; only the followed pixel of it where `whole` is false.
  View output(bool whole) const;

 private:
  Panel whole(dvec2 lower, dvec2 upper) const;
  Panel left(dvec2 lower, dvec2 upper) const;
  Panel right(dvec2 lower, dvec2 upper) const;
  Panel panel(double x0, double x1, dvec2 lower, dvec2 upper) const;

  template <class At>
  void model(View& view, const Panel& panel, const std::string& name, At at, const Pointer& pointer,
             bool labelled = true) const;
  template <class At>
  Panel fitted(At at, int side, const std::vector<dvec2>& more = {}) const;
  void polygon(View& view, const Panel& panel, std::string id, Role role,
               const std::vector<dvec2>& points) const;
  void caption(View& view, const Panel& panel, const std::string& key) const;
  void wedge(View& view, const Panel& panel, const std::string& name, double slope, double depth) const;
  void axes(View& view, const Panel& panel, const std::string& name, dvec2 (*to_paper)(dvec3)) const;
  void mark_pixel(View& view) const;

  bool follows(pipeline::PieceId id) const { return id == piece_.id; }

  const Run& run_;
  const pipeline::Piece& piece_;
  ivec2 pixel_;
  const Words& words_;
};

/// Below it a number of a picture, of a depth or of light is a rounding error.
inline constexpr double small = 1e-6;
/// A number as the tour shows it: what is smaller than `noise` is a rounding error.
inline std::string real_text(double value, double noise = small) { return figure_real(value, noise); }
/// "(1, −0.5, 2)".
inline std::string place_text(dvec3 p, double noise = small) {
  return figure_place(p, [noise](double number) { return real_text(number, noise); });
}

}  // namespace gradus::textbook_chain
