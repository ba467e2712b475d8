#pragma once
// Exhibits: a listing of lecture notes that clips nothing and may never end, and one that keeps or drops
// segments whole, kept so that a figure can show where they go wrong. cohen_sutherland_2d.hpp has the right
// ones.

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
/// Cost: one division per round.
template <class T = double, Observer<Classified<T>, Recoded<T>, Accepted<T>, Rejected, GaveUp> O = Unobserved>
std::optional<Segment<2, T>> codes_only(Segment<2, T> line, const Rectangle<T>& window,
                                        const Order& order = usual_order<2>(), int rounds = 8,
                                        O&& observer = {}) {
  expect_clippable(line, window);
  End<T> a = end_in(line.a, window);
  End<T> b = end_in(line.b, window);
  if constexpr (observed<O>) observer(Classified<T>{line, window, a.code, b.code});
  for (int i = 0; i < rounds; ++i) {
    if ((a.code | b.code) == 0) {
      if constexpr (observed<O>) observer(Accepted<T>{line});
      return line;
    }
    if ((a.code & b.code) != 0) {
      if constexpr (observed<O>) observer(Rejected{static_cast<Code>(a.code & b.code)});
      return std::nullopt;
    }
    // Where the line meets a border
    End<T>& e = a.code ? a : b;
    auto to = first(order, e.code);
    auto c = cut(a, b, to, window);
    // Only its code goes to an end
    bool of_a = to == Border::left;
    (of_a ? a : b).code = c.code;
    if constexpr (observed<O>) observer(Recoded<T>{of_a, to, c.at, a.code, b.code});
  }
  if constexpr (observed<O>) observer(GaveUp{rounds});
  return std::nullopt;
}

/// FAULTY: a segment is drawn whole when both ends pass the test, else it is dropped whole; and where the
/// test should compare y with the lower border it compares x again, so what lies below the window passes. The
/// notes' clipNode and its use, for edges and faces alike (errata E002-06 and E002-07). There the window is
/// the screen from (0,0) to its width and height, and a node has a depth, too.
///
/// line, window: as for cut_of_a_cut.
///
/// Domain: right for segments in a window whose lower corner is (0,0), and for those that miss it and have an
///   end to the left, to the right or above.
/// Steps: Classified (Accepted | Rejected); Rejected.common has the bits of both ends
/// Accuracy: none. In [0,10]^2 (10,-5)-(5,5) is kept whole, where (7.5,0)-(5,5) is right; of (15,2)-(5,8)
///   nothing is left, where (10,5)-(5,8) is right.
/// Cost: four comparisons per end.
/// Errors: as cut_of_a_cut.
template <class T = double, Observer<Classified<T>, Accepted<T>, Rejected> O = Unobserved>
std::optional<Segment<2, T>> whole_or_nothing(Segment<2, T> line, const Rectangle<T>& window,
                                              O&& observer = {}) {
  expect_clippable(line, window);
  const auto [low, high] = window;
  auto code_of = [=](auto node) {
    Code code = 0;
    if (node.x < low.x) code |= 1;
    if (node.x > high.x) code |= 2;
    // Misprinted: node.y was meant
    if (node.x < low.y) code |= 4;
    if (node.y > high.y) code |= 8;
    return code;
  };
  Code code_a = code_of(line.a);
  Code code_b = code_of(line.b);
  if constexpr (observed<O>) observer(Classified<T>{line, window, code_a, code_b});
  // All of it, or nothing
  Code outside = code_a | code_b;
  if (outside != 0) {
    if constexpr (observed<O>) observer(Rejected{outside});
    return std::nullopt;
  }
  if constexpr (observed<O>) observer(Accepted<T>{line});
  return line;
}

}  // namespace gradus::cohen_sutherland_2d
