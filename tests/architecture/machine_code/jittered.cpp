// Every method of jittered as a function of its own; see machine_code_test.py.
#include "antialiasing/jittered/jittered.hpp"
#include "antialiasing/jittered/jittered_notes.hpp"

using namespace gradus::jittered;
using gradus::dvec2;
using gradus::ivec2;
using gradus::Random;

double colour_at(dvec2 place);  // defined nowhere: the compiler must call it
double colour_of(ivec2 pixel);

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_regular(std::span<dvec2> samples) { regular(samples); }
[[gnu::flatten]] void machine_code_uniform(std::span<dvec2> samples, Random random) {
  uniform(samples, random);
}
[[gnu::flatten]] void machine_code_jittered(std::span<dvec2> samples, Random random) {
  jittered(samples, random);
}
[[gnu::flatten]] void machine_code_n_rooks(std::span<dvec2> samples, Random random) {
  n_rooks(samples, random);
}
[[gnu::flatten]] void machine_code_correlated_multi_jittered(std::span<dvec2> samples, Random random) {
  correlated_multi_jittered(samples, random);
}
[[gnu::flatten]] void machine_code_sobol(std::span<dvec2> samples, Random random) { sobol(samples, random); }
[[gnu::flatten]] double machine_code_sample_pixel(ivec2 pixel, std::span<const dvec2> samples) {
  return sample_pixel(pixel, samples, colour_at);
}
[[gnu::flatten]] double machine_code_whole_coordinates(ivec2 pixel, int asked, Random random) {
  return whole_coordinates(pixel, asked, random, colour_of);
}
[[gnu::flatten]] double machine_code_divided_by_asked(ivec2 pixel, int asked, Random random) {
  return divided_by_asked(pixel, asked, random, colour_at);
}
}
