#pragma once
// The drawings of the tour: of each stage one, the model in the stage's space or the picture with its pixels,
// the followed triangle and pixel in them, and the stage's numbers beside it.

#include <functional>

#include "figure/drawing.hpp"
#include "stories/pipeline/textbook_chain/cards.hpp"
#include "stories/pipeline/textbook_chain/panels.hpp"
#include "stories/pipeline/textbook_chain/run.hpp"
#include "stories/pipeline/textbook_chain/solid_cells.hpp"
#include "stories/pipeline/textbook_chain/way.hpp"
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
  View divided(const Pointer& at) const;
  /// The picture, pixels of the followed piece down to this row; -1: before the first.
  View raster(int last_row, const Pointer& at = {}) const;
  /// Round the followed pixel, with its edge functions where the followed piece covers it.
  View rastered() const;
  /// The edge functions at the followed pixel. found: what a faulty stage has for them.
  View edge_functions(const EdgeValues& values, const std::optional<dvec3>& found = {}) const;
  /// The depths at the followed pixel, and which fragments of the followed piece are the nearest.
  View depths(const pipeline::DepthTested& at) const;
  /// The place that is seen at the followed pixel, its normal and where its light comes from; and the light.
  View shading() const;
  /// Depths in the left half of the picture, in the right one the light of what is seen.
  View visibility() const;
  /// The picture, and the way that led to the followed pixel, or only its last part: from light to bytes.
  View output(bool whole) const;

 private:
  using Place = std::function<dvec3(std::size_t)>;  ///< a vertex: to the right, up, towards the reader
  using Flat = std::function<dvec2(dvec3)>;         ///< a point of the world
  /// The reader's right, up and towards him, in the world.
  using Axes = std::array<dvec3, 3>;

  // --- What is the same in all of them

  /// The stages, and which is told; and what the panel shows.
  View begin(std::size_t stage, const std::string& caption) const;
  /// margin: for names, in units.
  Panel panel(const Extent& world, dvec2 margin = {1.4, 0.8}) const;
  void polygon(View& view, const Panel& panel, std::string id, Role role, const std::vector<dvec2>& points,
               bool dashed = false) const;
  void area(View& view, const Panel& panel, std::string id, Role role,
            const std::vector<dvec2>& points) const;
  /// Where the followed pixel's place on the followed piece lies, if it lies there.
  void pixel_place(View& view, const Panel& panel, dvec2 at) const;
  std::string pixel_name() const { return figure_point(pixel_); }

  // --- Solids

  Extent extent(const Place& place) const;
  std::vector<dvec2> own(const Place& place) const;
  std::vector<SolidPart> pieces(const Place& place) const;
  dvec3 colour_of(const SolidPart& part) const;
  /// It is drawn once for each name, and stays the same from step to step.
  void solid(View& view, const Panel& panel, const std::string& name,
             const std::vector<SolidPart>& parts) const;
  bool few_faces() const;
  /// From where the model is looked at where it was made, and where it stands.
  static Axes upright(dvec3 towards, dvec3 up);
  static Axes from_the_front();
  Axes from_aside() const;
  static Place turned(const Place& place, const Axes& axes);
  /// The directions of a space's axes, in the panel's lower left corner.
  void axes_cross(View& view, const Axes& axes) const;
  void followed(View& view, const Panel& panel, const std::vector<dvec2>& corners, const Pointer& pointer,
                bool all_names) const;

  // --- Stages of vertices

  dvec3 object_at(std::size_t vertex) const { return run_.read[vertex].point.at; }
  dvec3 world_at(std::size_t vertex) const { return run_.placed[vertex].to.at; }
  const glm::dvec4& clip_at(std::size_t vertex) const { return run_.clip[vertex].clip.at; }
  std::size_t vertex(std::size_t corner) const {
    return static_cast<std::size_t>(piece_.corners[corner].vertex);
  }
  void model(View& view) const;
  std::vector<dvec2> window_in_world(const Flat& flat) const;
  void lines_of_sight(View& view, const Panel& panel, const Flat& flat) const;
  /// What the camera sees of clip space, one of its axes against w, from the near plane on; and the axes.
  void wedge(View& view, const Panel& panel, const char* across, bool upright) const;
  std::vector<dvec3> seen_ring(const pipeline::Piece& piece) const;
  /// Where the picture will be, and a part as large all round it.
  Panel picture_panel(double widened = 0) const;
  void window(View& view, const Panel& panel) const;

  // --- Stages of pixels

  dvec2 corner_in_picture(const pipeline::SnappedPoint& p) const { return dvec2(p.at) / 256.0 - 0.5; }
  std::vector<dvec2> outline(const pipeline::Snapped& triangle) const;
  void frame(View& view) const;
  void put(View& view, ivec2 pixel, Role role, Rgba8 color) const;
  /// A run of pixels in the picture, from the first to the last.
  std::vector<dvec2> run_of_pixels(ivec2 first, int last) const;
  /// Pixels as areas: of other pieces all, of the followed one down to this row.
  void covered(View& view, int last_row) const;
  void mark_pixel(View& view) const;
  /// What comes out, and the followed pixel in it.
  void picture(View& view) const;
  Rgba8 depth_tone(double depth) const;
  /// The pixels round the followed one, large: what of the followed piece they are, and its outline.
  Panel near_pixel(View& view, const std::function<std::optional<Role>(ivec2)>& role) const;
  Panel near_panel() const;
  void edge_lines(View& view, const EdgeValues& values) const;
  Extent window_near() const;
  std::optional<Role> covered_role(ivec2 pixel) const;
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
  const bool closed_;
  mutable std::map<std::string, View> solids_;  ///< that were drawn already
};

}  // namespace gradus::textbook_chain
