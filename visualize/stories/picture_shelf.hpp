#pragma once
// Pictures of one size beside each other, each under its name: what waits there at first, then the picture,
// one step each. Below each, if asked for, a part of it magnified.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "figure/tone_of.hpp"
#include "stories/telling.hpp"

namespace gradus {

/// The tones of a picture by (column, row); where it has no value, none.
inline auto tones_in(const std::map<std::pair<int, int>, double>& picture) {
  return [&picture](ivec2 p) {
    const auto found = picture.find({p.x, p.y});
    return found == picture.end() ? std::nullopt : std::optional(tone_of(found->second));
  };
}

class PictureShelf {
 public:
  /// A part of each picture, shown magnified below it.
  struct Part {
    ivec2 at, size;
    int magnified;
  };
  /// Lengths are in cells, a pixel each unless pictures are fine.
  struct Look {
    ivec2 size;                      ///< of a picture
    std::vector<std::string> names;  ///< of the pictures, in their order
    int row = 0;                     ///< so many stand beside each other; 0: all
    int gap = 2, heading = 3;        ///< between pictures, and above each for its name
    bool y_up = false;               ///< rows of pictures count upwards
    int plot = 0;                    ///< with y_up: so many rows below each picture, for marks
    int left = 0;                    ///< so many columns left of each, for marks
    int fine = 1;                    ///< so many pixels a cell, either way: above 1, looked at as a whole
    std::optional<Part> part{};
  };
  /// The drawing gets the cells that all of them take.
  PictureShelf(Narrator& narrator, Look look);

  /// Where the first picture has a place, if it reaches as far; its first pixel is [0, 1] x [0, 1].
  std::optional<dvec2> shown_at(dvec2 place) const;
  /// Stands in the place of the k-th picture until it comes: an outline, in the pictures' places.
  void wait(std::size_t k, Role role, const std::vector<dvec2>& ring);
  /// The same: the rim of the picture.
  void wait(std::size_t k, Role role = Role::past);
  /// A mark of the k-th picture's, whose places are on_paper.
  void mark(std::size_t k, std::string_view id, Role role, decltype(Mark::shape) shape) {
    view_.add({fmt::format("m {} {}", k, id), role, std::move(shape)});
  }
  /// Where the k-th picture has a place, on the drawing or beside it.
  dvec2 on_paper(std::size_t k, dvec2 place) const { return dvec2(corner(k)) - 0.5 + place; }
  /// Round each picture, from now on.
  void frame(Role role);

  /// The step that shows all that waits.
  void start(const Event& event);
  /// The step of the next picture: the tone of each of its pixels, or none. They count from its corner with
  /// the least numbers, `fine` to a cell.
  void show(std::string_view type, int line, const std::function<std::optional<Rgba8>(ivec2)>& tone,
            const Event& event);
  /// The step after the last one; the figure that tells most is the last picture's.
  void finish(const Event& event);

 private:
  ivec2 corner(std::size_t k) const;
  ivec2 below(std::size_t k) const;
  int width() const;
  int height() const;
  std::size_t columns() const;
  std::size_t rows() const;
  void add_name(std::size_t k);
  using ToneAt = std::function<std::optional<Rgba8>(ivec2)>;
  void put(ivec2 cell, const std::optional<Rgba8>& tone);
  Picture picture(std::size_t k, const ToneAt& tone) const;
  void step(std::string_view type, int line, const Event& event);

  Narrator& narrator_;
  const Look look_;
  View view_{};
  std::size_t shown_ = 0;
};

}  // namespace gradus
