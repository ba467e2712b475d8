#pragma once
// The tour of the chain: one triangle and one pixel followed through its stages, as events.

#include "stories/pipeline/textbook_chain/run.hpp"
#include "stories/pipeline/textbook_chain/views.hpp"
#include "stories/telling.hpp"

namespace gradus::textbook_chain {

/// The stages as the parameter `stage` calls them, the calls that the chain makes of them, and the functions
/// of their own that report steps.
struct Stage {
  std::string_view name, call, file, function, function_below{};
};
inline constexpr std::array<Stage, 8> stages{
    {{"input", "input(", "1_input", "bring_in"},
     {"world", "to_world(", "2_world", "to_world"},
     {"perspective", "to_clip(", "3_perspective", "to_clip"},
     {"back_faces", "cull(", "4_back_faces", "cull"},
     {"clipping", " clip(", "5_clipping", "clip"},
     {"rasterization", "rasterize(", "6_rasterization", "rasterize"},
     {"visibility", "shade(", "7_visibility_and_shading", "keep_nearest", "shade"},
     {"output", "return output(", "8_output", "output"}}};

/// The events of the chain's stages, one after another.
class Tour {
 public:
  /// listed: the stage whose own source is listed; 0: the chain is. last: the stage that ends the tour.
  /// exchanged: the one that lists an exhibit; 0: none.
  Tour(Narrator& narrator, const Run& run, const Followed& followed, std::size_t listed, std::size_t last,
       std::size_t exchanged)
      : narrator_(narrator),
        listed_(listed),
        last_(last),
        exchanged_(exchanged),
        words_(narrator.words()),
        run_(run),
        followed_(followed.piece),
        piece_(run.pieces[followed.piece]),
        faced_(run.faced[followed.piece]),
        pixel_(followed.pixel),
        seen_(followed.seen),
        views_(run, followed, words_) {}

  /// Tells the stages up to the last one.
  void tell();

 private:
  // --- Telling an event

  const std::vector<SourceLine>& listing() const { return narrator_.trace().listing; }

  /// The line of the chain that calls the stage, or `call`.
  int chain_line(std::string_view call = {}) const;

  /// The listed stage's line that reported steps of this type: none of it did in the stages before.
  int own_line(std::string_view type) const;

  /// The line with which the listed stage ends: its return, or what it reported last.
  int end_line() const;

  void tell(View view, std::string_view type, int line, Event event);

  /// reported: the step type of the pipeline that tells of it, where that is not the event's own.
  void fine(View view, std::string_view type, Event event, std::string_view reported = {},
            std::string_view call = {});

  void milestone(View view, std::string_view type, Event event);

  std::vector<Said> row(Said point, std::initializer_list<Said> numbers) const;
  template <int N>
  std::vector<Said> row(Said point, const glm::vec<N, double>& p, double noise = small) const {
    std::vector<Said> cells{std::move(point), stage_};
    for (int i = 0; i < N; ++i) cells.push_back(real_text(p[i], noise));
    return cells;
  }
  /// Lengths, as long as the model or a part of it.
  std::string length_text(double x) const { return real_text(x, run_.noise); }
  std::string at_text(dvec3 p) const { return place_text(p, run_.noise); }

  std::size_t vertex(std::size_t corner) const;
  std::string vertex_name(std::size_t corner) const { return fmt::format("v{}", vertex(corner)); }
  std::string corner_names() const;
  int face() const { return piece_.id.face; }
  Word face_word() const { return {"face", face()}; }
  Word pixel_word() const { return {"pixel", pixel_}; }

  // --- The stages

  void goal();
  void input();
  void world();
  void perspective();

  /// Of the followed piece, in clip space.
  std::array<glm::dvec4, 3> corners() const;

  /// What is found of the followed piece's side: its text and its branch.
  std::pair<std::string_view, std::string_view> verdict() const;

  std::string_view faulty_verdict() const;

  /// Stage 4 after the division, which mirrors the corners behind the eye.
  void facing_after_division();

  void facing();

  void clipping();
  std::string own_clipping() const;
  void clipped_corner(const pipeline::Clipped& own, std::size_t k);

  void rasterization();
  void snapped_corner(const pipeline::Snapped& triangle, std::size_t k, std::size_t corner);

  /// What the followed piece covers of a row of pixels.
  struct CoveredRow {
    int count = 0, first = INT32_MAX, last = 0;
    double depth = 0;  ///< of the first fragment

    void add(const pipeline::Fragment& f) {
      if (count++ == 0) depth = f.depth;
      first = std::min(first, f.pixel.x);
      last = std::max(last, f.pixel.x);
    }
  };

  /// How many pixels of a row the followed piece should cover.
  std::int64_t right_count(int y, std::int64_t covered) const;

  void covered_row(int y, const CoveredRow& covered);

  /// The followed pixel, where the followed piece covers it.
  void edge_functions();

  /// The multiplied-out edge functions at the followed pixel, where they are wrong about it.
  void expanded_edge_functions();

  void visibility();
  void depth_test(const pipeline::DepthTested& test);
  void output();

  Narrator& narrator_;
  const std::size_t listed_, last_, exchanged_;
  const Words& words_;
  const Run& run_;
  const std::size_t followed_;
  const pipeline::Piece& piece_;
  const pipeline::Faced& faced_;
  const ivec2 pixel_;
  const std::optional<int> seen_;  ///< the face that is seen at the pixel
  const Views views_;
  std::size_t stage_ = 0;
};

}  // namespace gradus::textbook_chain
