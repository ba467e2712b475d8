#pragma once
// Exhibit: a listing of lecture notes that clips nothing and may never end, kept so that a figure can show
// where it goes wrong. cohen_sutherland_2d.hpp has the right ones.

#include "clipping/cohen_sutherland_2d/cohen_sutherland_2d.hpp"

namespace gradus::cohen_sutherland_2d {

/// A point was computed and its code given to an end, which stays where it was.
template <class T>
struct Recoded {
  bool of_a;  ///< whether the code of a changed, not that of b
  Border border;
  glm::vec<2, T> at;  ///< the point whose code it is
  Code code_a, code_b;
};

/// It has gone round as often as was allowed.
struct GaveUp {
  int rounds;
};

/// FAULTY: computes where the line meets a border but moves no end there, only its code; and of two ends it
/// charges a left border always to a, every other one to b.
/// The notes' main listing (errata E001-24; printed it can't be parsed, for an `if` has two `else`: the
/// second is left out here).
///
/// line, window, order: as for cut_of_a_cut. rounds: after how many it is stopped; the notes have no limit.
///
/// Domain: right only where nothing needs to be cut. (-5,5)-(15,5) in [0,10]^2 comes back as it is,
///   (5,5)-(-5,5) goes round for ever.
/// Steps: Classified Recoded* (Accepted | Rejected | GaveUp)
/// Accuracy: none.
/// Cost: one division a round.
template <class T, Observer<Classified<T>, Recoded<T>, Accepted<T>, Rejected, GaveUp> O = Unobserved>
std::optional<Line<T>> codes_only(Line<T> line, const Rectangle<T>& window,
                                  const Order& order = usual_order<2>(), int rounds = 8, O&& observer = {}) {
  expect_clippable(line, window);
  const auto [a, b] = line;
  Code code_a = region_code(a, window);
  Code code_b = region_code(b, window);
  if constexpr (observed<O>) observer(Classified<T>{line, window, code_a, code_b});
  for (int i = 0; i < rounds; ++i) {
    if ((code_a | code_b) == 0) {
      if constexpr (observed<O>) observer(Accepted<T>{line});
      return line;
    }
    if ((code_a & code_b) != 0) {
      if constexpr (observed<O>) observer(Rejected{static_cast<Code>(code_a & code_b)});
      return std::nullopt;
    }
    // Where the line meets a border
    Code out = code_a ? code_a : code_b;
    auto border = first_of(order, out);
    auto at = meet(a, b, border, window);
    // Only its code goes to an end
    const bool of_a = border == Border::left;
    Code& code = of_a ? code_a : code_b;
    code = region_code(at, window);
    if constexpr (observed<O>) observer(Recoded<T>{of_a, border, at, code_a, code_b});
  }
  if constexpr (observed<O>) observer(GaveUp{rounds});
  return std::nullopt;
}

}  // namespace gradus::cohen_sutherland_2d
