#pragma once
// The drawings of the tour: before and after each stage, the model in the spaces of the stage or the picture
// with its pixels, the followed triangle and pixel in them, and the stage's numbers below.

#include <functional>

#include "figure/drawing.hpp"
#include "stories/pipeline/textbook_chain/cards.hpp"
#include "stories/pipeline/textbook_chain/panels.hpp"
#include "stories/pipeline/textbook_chain/run.hpp"
#include "stories/pipeline/textbook_chain/way.hpp"
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
  Views(const Views&) = delete;
  Views& operator=(const Views&) = delete;

  const Way& way() const { return way_; }
  const ChainPaper& paper() const { return paper_; }

  View goal() const;
  View object(const Pointer& at = {}) const;
  View world(const Pointer& at = {}) const;
  View clip_space(const Pointer& at = {}) const;
  View facing() const;
  View clipping(const Pointer& at = {}) const;
  /// Cells of the followed piece down to this row; -1: before the first.
  View raster(int last_row, const Pointer& at = {}) const;
  /// The edge functions at the followed pixel. found: what a faulty stage has for them.
  View edge_functions(const EdgeValues& values, const std::optional<dvec3>& found = {}) const;
  /// The depths of what is nearest, and which fragments of the followed piece are.
  View depths(const pipeline::DepthTested& at) const;
  /// The place that is seen at the followed pixel, its normal and where its light comes from; and the light.
  View shading() const;
  /// Depths, and the light of what is seen.
  View visibility() const;
  /// The picture, only the followed pixel of it where `whole` is false; and the way that led to the pixel.
  View output(bool whole) const;

 private:
  using Flat = std::function<dvec2(dvec3)>;
  using FacePart = std::pair<int, std::vector<dvec3>>;  ///< which face, and the ring
  using Placing = std::function<dvec3(std::size_t)>;    ///< a vertex in some space

  /// From where a solid is looked at; what is right, up and towards the reader there; and its place on paper.
  struct Sight {
    Viewer viewer;
    dvec3 right, up, towards;
    Flat flat;
  };

  // --- Panels and what is the same in all of them

  Panel panel(const Extent& place, const Extent& world) const;
  Panel panel(Side side, const Extent& world) const { return panel(paper_.panel(side), world); }
  /// aside: of a panel that has nothing but text.
  void caption(View& view, Side side, const std::string& text, bool aside = false) const;
  void space(View& view, Side side, const char* key) const { caption(view, side, words_.say(key)); }
  /// From panel to panel, between their captions, with the name of what leads there.
  void arrow(View& view, const std::string& name = "") const;
  void polygon(View& view, const Panel& panel, std::string id, Role role,
               const std::vector<dvec2>& points) const;
  void area(View& view, const Panel& panel, std::string id, Role role,
            const std::vector<dvec2>& points) const;
  Side side_of(const Panel& panel) const;
  /// Where the followed pixel's place on the followed piece lies, if it lies there.
  void pixel_place(View& view, const std::string& name, dvec2 at) const;
  std::string pixel_name() const { return figure_point(pixel_); }

  // --- Solids

  Extent extent(const Placing& place, const Flat& flat, const std::vector<dvec2>& more = {}) const;
  void axes(View& view, const Panel& panel, const std::string& name, const Flat& flat) const;
  void solid(View& view, const Panel& panel, const std::string& name, const Mesh& mesh,
             const Sight& sight) const;
  /// Pieces of faces as a solid whose faces have the shades that they have from the directions of `sight`,
  /// which are those of the world.
  void pieces_solid(View& view, const Panel& panel, const std::string& name,
                    const std::vector<FacePart>& parts, const Sight& sight,
                    const std::array<dvec3, 3>& world) const;
  void side_solid(View& view, const Panel& panel, const std::string& name,
                  const std::vector<FacePart>& parts) const;
  void seen_solid(View& view, const Panel& panel, const std::string& name,
                  const std::vector<FacePart>& parts) const;
  bool few_faces() const;
  std::vector<FacePart> pieces(const Placing& place) const;
  int shade_of_face(int face, const std::array<dvec3, 3>& world) const;
  /// Seen along z, as the model was made.
  Sight from_the_front() const;
  /// Seen from the camera's right, so that what looks at a front looks right.
  Sight from_aside() const;
  std::vector<dvec2> own(const Placing& place, const Flat& flat) const;
  /// Which corners of the followed piece have names.
  enum class Names { none, pointed, all };
  void followed(View& view, const Panel& panel, const std::string& name, const std::vector<dvec2>& corners,
                const Pointer& pointer, Names names) const;

  // --- Stages of vertices

  void object_panel(View& view, const Extent& place, const Pointer& at, Names names) const;
  void wedge(View& view, const Panel& panel, const std::string& name, double slope, double depth,
             const std::string& along) const;
  void side_panel(View& view, Side side, const std::string& name, const Placing& place, double slope,
                  double depth, const Pointer& at) const;
  void lines_of_sight(View& view, const Panel& panel, const Flat& flat) const;
  std::vector<dvec2> window_in_world(const Flat& flat) const;
  std::vector<dvec3> seen_ring(const pipeline::Piece& piece) const;
  /// Where the picture will be.
  Panel picture_panel(Side side) const;
  void window(View& view, const Panel& panel, const std::string& id) const;
  void clip_panel(View& view, const Pointer& at) const;
  void divided_panel(View& view, const Pointer& at) const;

  // --- Stages of pixels

  dvec2 corner_in_picture(const pipeline::SnappedPoint& p) const { return dvec2(p.at) / 256.0 - 0.5; }
  void frame(View& view, Side side) const;
  void put(View& view, Side side, ivec2 pixel, Role role, std::optional<Rgba8> color = {}) const;
  void mark_pixel(View& view, Side side) const;
  void depth_picture(View& view, Side side) const;
  void lit_picture(View& view, Side side) const;
  /// The pixels round the followed one, large: what of the followed piece they are, and its outline.
  Panel near_pixel(View& view, Side side, const std::function<std::optional<Role>(ivec2)>& role) const;
  Panel near_panel(Side side) const;
  void edge_lines(View& view, const EdgeValues& values) const;
  void outline_near(View& view, const Panel& panel) const;
  Extent window_near() const;
  std::optional<Role> covered_role(ivec2 pixel, int last_row) const;
  std::optional<Role> kept_role(ivec2 pixel) const;

  bool follows(pipeline::PieceId id) const { return id == piece_.id; }

  const Run& run_;
  const pipeline::Piece& piece_;
  ivec2 pixel_;
  const Words& words_;
  const ChainPaper paper_;
  const double unit_;
  const Way way_;
  const Cards cards_;
  const double aspect_;
  Mesh world_;                                  ///< the model where it stands
  mutable std::map<std::string, View> solids_;  ///< that were drawn already
};

}  // namespace gradus::textbook_chain
