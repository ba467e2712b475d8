// Every method of poisson_disc as a function of its own; see machine_code_test.py.
#include "antialiasing/poisson_disc/poisson_disc.hpp"

using namespace gradus::poisson_disc;
using gradus::dvec2;
using gradus::Random;

void put(dvec2 sample);  // defined nowhere: the compiler must call it

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_dart_throwing(const Area& area, double radius, int misses, Random random) {
  dart_throwing(area, radius, misses, random, put);
}
[[gnu::flatten]] void machine_code_bridson(const Area& area, double radius, int tries, Random random) {
  bridson(area, radius, tries, random, put);
}
[[gnu::flatten]] double machine_code_best_candidate(std::span<dvec2> samples, int candidates, Random random) {
  return best_candidate(samples, candidates, random);
}
}
