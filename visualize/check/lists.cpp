#include "check/lists.hpp"

#include <algorithm>
#include <map>
#include <string>

namespace gradus::check {
namespace {

bool has_reals(const std::vector<Element>& list) {
  return std::ranges::any_of(list, [](const Element& element) {
    return std::ranges::any_of(element, [](const Value& v) { return std::holds_alternative<double>(v); });
  });
}

const Element& values_of_corner(const Element& corner) { return corner; }
const Element& values_of_corner(const ExpectedElement& corner) { return corner.values; }

bool is_closed(const std::vector<Element>& ring, double tolerance) {
  return ring.size() > 1 && agree(ring.front(), ring.back(), tolerance);
}

template <class Corner>
std::vector<Corner> without_repeats(const std::vector<Corner>& ring, double tolerance) {
  std::vector<Corner> corners;
  const auto same = [tolerance](const Corner& a, const Corner& b) {
    return agree(values_of_corner(a), values_of_corner(b), tolerance);
  };
  for (const Corner& corner : ring) {
    if (corners.empty() || !same(corners.back(), corner)) corners.push_back(corner);
  }
  while (corners.size() > 1 && same(corners.front(), corners.back())) corners.pop_back();
  return corners;
}

/// Begins a ring of as many corners elsewhere, or goes it round the other way, as far as that fits better.
void fit(RingsBeside& rings, double tolerance) {
  const std::size_t size = rings.ours.size();
  std::size_t best = 0, best_turn = 0;
  bool best_backwards = false;
  std::vector<Element> corners = rings.theirs;
  for (const bool backwards : {false, true}) {
    for (std::size_t turn = 0; turn < size; ++turn) {
      std::size_t fitting = 0;
      for (std::size_t i = 0; i < size; ++i)
        fitting += agree(rings.ours[i].values, corners[(i + turn) % size], tolerance);
      if (fitting <= best) continue;
      best = fitting;
      best_turn = turn;
      best_backwards = backwards;
    }
    std::ranges::reverse(corners);
  }
  if (best_backwards) std::ranges::reverse(corners);
  std::ranges::rotate(corners, corners.begin() + static_cast<std::ptrdiff_t>(best_turn));
  rings.theirs = std::move(corners);
  rings.backwards = best_backwards;
  // Backwards from its own beginning, its first corner is still the first
  rings.turned = best_turn != (best_backwards ? size - 1 : 0);
}

/// The second point first.
Element turned_round(Element segment) {
  std::ranges::rotate(segment, segment.begin() + std::ssize(segment) / 2);
  return segment;
}

}  // namespace

std::vector<Element> elements_of(const ExpectedList& list) {
  std::vector<Element> elements;
  for (const ExpectedElement& element : list.elements) elements.push_back(element.values);
  return elements;
}

bool same_in_order(const std::vector<Element>& a, const std::vector<Element>& b, double tolerance) {
  return std::ranges::equal(
      a, b, [tolerance](const Element& x, const Element& y) { return agree(x, y, tolerance); });
}

std::vector<std::size_t> missing_from(const std::vector<Element>& list, const std::vector<Element>& of,
                                      double tolerance) {
  std::vector<std::size_t> missing;
  if (!has_reals(list)) {
    std::map<std::string, std::size_t> there;
    for (const Element& element : list) ++there[text_of(element)];
    for (std::size_t i = 0; i < of.size(); ++i) {
      const auto found = there.find(text_of(of[i]));
      if (found == there.end() || found->second == 0)
        missing.push_back(i);
      else
        --found->second;
    }
    return missing;
  }
  std::vector<bool> taken(list.size());
  for (std::size_t i = 0; i < of.size(); ++i) {
    std::size_t j = 0;
    while (j < list.size() && (taken[j] || !agree(list[j], of[i], tolerance))) ++j;
    if (j < list.size())
      taken[j] = true;
    else
      missing.push_back(i);
  }
  return missing;
}

RingsBeside rings_beside(const ExpectedList& ours, const std::vector<Element>& theirs, double tolerance) {
  RingsBeside rings{.ours = without_repeats(ours.elements, tolerance),
                    .theirs = without_repeats(theirs, tolerance)};
  rings.closed = is_closed(theirs, tolerance) && !is_closed(elements_of(ours), tolerance);
  const std::size_t fewer = theirs.size() - rings.theirs.size() - (rings.closed ? 1 : 0);
  const std::size_t ours_fewer = ours.elements.size() - rings.ours.size();
  rings.repeated = std::max(fewer, ours_fewer) - ours_fewer;
  if (rings.ours.size() == rings.theirs.size() && !rings.ours.empty()) fit(rings, tolerance);
  return rings;
}

std::size_t turn_segments(const std::vector<Element>& ours, std::vector<Element>& theirs, double tolerance) {
  const auto is_ours = [&](const Element& segment) {
    return std::ranges::any_of(ours, [&](const Element& e) { return agree(e, segment, tolerance); });
  };
  std::size_t turned = 0;
  for (Element& segment : theirs) {
    Element other = turned_round(segment);
    if (is_ours(segment) || !is_ours(other)) continue;
    segment = std::move(other);
    ++turned;
  }
  return turned;
}

}  // namespace gradus::check
