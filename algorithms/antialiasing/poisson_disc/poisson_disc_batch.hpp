#pragma once
// Bridson's samples for large areas: those of the textbook's method, found faster.

#include <vector>

#include "antialiasing/poisson_disc/poisson_disc.hpp"

namespace gradus::poisson_disc {

/// The samples of bridson in their order, to the bit. Places beside a sample are tried as many at once as fit
/// into a register, in single precision and from the sample: most are so near to another one, or so far
/// outside, that no rounding can save them. What is left is tried as bridson does, with the same numbers.
///
/// area, radius, k, random: as for bridson.
///
/// Domain: that of bridson. Areas of less than 12 cells across or up are left to it.
/// Accuracy: that of bridson, bit for bit, on every machine.
/// Cost: proportional to the number of samples; see the topic's page.
/// Errors: as bridson.
std::vector<dvec2> bridson_batch(const Area& area, double radius, int k, Random random);

}  // namespace gradus::poisson_disc
