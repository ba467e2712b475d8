#pragma once
// Lists of an answer beside ours: what one has that the other lacks, and which outlines and segments are the
// same.

#include <cstddef>
#include <vector>

#include "check/expected.hpp"

namespace gradus::check {

std::vector<Element> elements_of(const ExpectedList& list);

/// Whether the lists have the same elements in the same places.
bool same_in_order(const std::vector<Element>& a, const std::vector<Element>& b, double tolerance);

/// The places in `of` of the elements that the list lacks, each as often as it lacks it.
std::vector<std::size_t> missing_from(const std::vector<Element>& list, const std::vector<Element>& of,
                                      double tolerance);

/// Two outlines side by side: their corners but for those that stand again behind themselves, the last of all
/// beside the first; the second begun, and gone round, so that most of its corners stand where those of the
/// first do.
struct RingsBeside {
  std::vector<ExpectedElement> ours;
  std::vector<Element> theirs;
  bool turned = false, backwards = false;
  bool closed = false;       ///< theirs ends with its first corner again, and ours does not
  std::size_t repeated = 0;  ///< of their other corners
};
RingsBeside rings_beside(const ExpectedList& ours, const std::vector<Element>& theirs, double tolerance);

/// Turns those of their segments round that are ours from the other end; returns how many.
std::size_t turn_segments(const std::vector<Element>& ours, std::vector<Element>& theirs, double tolerance);

}  // namespace gradus::check
