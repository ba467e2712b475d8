// Every method of sampling_theorem as a function of its own; see machine_code_test.py.
#include "antialiasing/sampling_theorem/sampling_theorem.hpp"
#include "antialiasing/sampling_theorem/sampling_theorem_notes.hpp"

using namespace gradus::sampling_theorem;

double signal(double t);  // defined nowhere: the compiler must call it

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_sample(double fs, std::span<double> samples) {
  sample(signal, fs, samples);
}
[[gnu::flatten]] double machine_code_alias_of(double f, double fs) { return alias_of(f, fs); }
[[gnu::flatten]] double machine_code_reconstruct(std::span<const double> samples, double x) {
  return reconstruct(samples, x, Dirichlet{std::ssize(samples)});
}
[[gnu::flatten]] void machine_code_film_wheel(double f, double fps, std::int64_t n, std::span<double> seen) {
  film_wheel(f, fps, n, seen);
}
// A comparison alone is too short to compare: how many frequencies are said to be so at how many rates
[[gnu::flatten]] int machine_code_at_least_twice(std::span<const double> f, std::span<const double> fs) {
  int enough = 0;
  for (const double frequency : f) {
    for (const double rate : fs) enough += at_least_twice(frequency, rate) ? 1 : 0;
  }
  return enough;
}
[[gnu::flatten]] int machine_code_half_frame_rate(std::span<const double> f, std::span<const double> fps) {
  int backward = 0;
  for (const double revolutions : f) {
    for (const double rate : fps) backward += half_frame_rate(revolutions, rate) ? 1 : 0;
  }
  return backward;
}
}
