#pragma once
// The drawings of the tour: the model in the space of each stage, and the picture's cells from stage 6 on.

#include "figure/drawing.hpp"
#include "stories/pipeline/chain_run.hpp"
#include "stories/space_drawing.hpp"
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
  Views(const Run& run, const Followed& followed, const Words& words);

  View object(const Pointer& at = {}) const;
  View world(const Pointer& at = {}) const;
  View clip_space(const Pointer& at = {}) const;
  View facing() const;
  View clipping(const Pointer& at = {}) const;
  /// Cells of the followed piece down to this row; -1: before the first.
  View raster(int last_row, const Pointer& at = {}) const;
  /// The edge functions at the followed pixel, which the followed piece covers.
  View edge_functions(const pipeline::Snapped& triangle) const;
  /// Which fragments of the followed piece are nearest, among the depths of all; `at`: of the followed pixel.
  View depths(const std::string& at = {}) const;
  /// The light of what is seen.
  View lit() const;
  /// The picture; only the followed pixel of it where `whole` is false.
  View output(bool whole) const;

 private:
  /// From where a solid is looked at, and what is right and towards the reader there.
  struct Sight {
    Viewer viewer;
    dvec3 right, towards;
  };
  /// The paper from `left` to `right`, as parts of its width.
  Panel panel(double left, double right, const Extent& world) const;

  template <class At>
  void outlines(View& view, const Panel& panel, const std::string& name, At at, const Pointer& pointer,
                bool labelled = true) const;
  template <class At>
  Extent extent(At at, const std::vector<dvec2>& more = {}) const;
  template <class At>
  void solid(View& view, const Panel& panel, const std::string& name, const Mesh& mesh, const Sight& sight,
             At flat) const;
  void divided_solid(View& view, const Panel& panel, double aspect) const;
  int shade_of_face(int face) const;
  /// Seen along z, as the model was made, or from its right side, where what looks at its front looks right.
  Sight from_the_front() const;
  Sight from_the_right() const;
  void followed(View& view, const Panel& panel, const std::string& name, const std::vector<dvec2>& corners,
                const Pointer& pointer, bool labelled) const;
  void wedge_axes(View& view, const Panel& panel, const std::string& name, double depth,
                  const std::string& along) const;
  dvec2 corner_in_picture(const pipeline::SnappedPoint& p) const;
  void polygon(View& view, const Panel& panel, std::string id, Role role,
               const std::vector<dvec2>& points) const;
  /// aside: from the panel's middle, in units.
  void caption(View& view, const Panel& panel, const std::string& key, double aside = 0) const;
  void wedge(View& view, const Panel& panel, const std::string& name, double slope, double depth) const;
  void axes(View& view, const Panel& panel, const std::string& name, dvec2 (*to_paper)(dvec3)) const;
  void mark_pixel(View& view) const;

  bool follows(pipeline::PieceId id) const { return id == piece_.id; }

  const Run& run_;
  const pipeline::Piece& piece_;
  ivec2 pixel_;
  const Words& words_;
  const double unit_;                           ///< a thirty-sixth of the paper's width
  Mesh world_;                                  ///< the model where it stands
  mutable std::map<std::string, View> solids_;  ///< that were drawn already
};

/// "E0", "E1", "E2": the edge functions, each of the edge opposite a corner.
inline std::string edge_name(std::size_t edge) { return fmt::format("E{}", edge); }

/// Below it a number of a picture, of a depth or of light is a rounding error.
inline constexpr double small = 1e-6;
/// A number as the tour shows it: what is smaller than `noise` is a rounding error.
inline std::string real_text(double value, double noise = small) { return figure_real(value, noise); }
/// "(1, −0.5, 2)".
inline std::string place_text(dvec3 p, double noise = small) {
  return figure_place(p, [noise](double number) { return real_text(number, noise); });
}

}  // namespace gradus::textbook_chain
