// Every method of adaptive as a function of its own; see machine_code_test.py.
#include "antialiasing/adaptive/adaptive.hpp"

using namespace gradus::adaptive;
using gradus::ivec2;
using gradus::Window;

// Defined nowhere: the compiler must call them
void set_pixel(ivec2 p, double sum, double share);
double colour_of(int triangle, ivec2 p, const Weights& weights);
double contrast_of(const Light<double>& a, const Light<double>& b);

extern "C" {
[[gnu::flatten]] void machine_code_mark_crossed(Survey& survey) { mark_crossed(survey); }
[[gnu::flatten]] void machine_code_take_samples(Survey& survey) { take_samples(survey); }
[[gnu::flatten]] double machine_code_mix(const Survey& survey, ivec2 p, std::span<const Fragment> fragments) {
  return mix(survey, p, fragments, colour_of).sum;
}
[[gnu::flatten]] double machine_code_blend(const Survey& survey, ivec2 p) {
  return blend(survey, p, colour_of).sum;
}
[[gnu::flatten]] void machine_code_adaptive(std::span<const ScreenTriangle> triangles, const Window& window,
                                            std::span<const ivec2> samples) {
  adaptive(triangles, window, samples, colour_of, set_pixel);
}
[[gnu::flatten]] void machine_code_each_sample(std::span<const ScreenTriangle> triangles,
                                               const Window& window, std::span<const ivec2> samples) {
  each_sample(triangles, window, samples, colour_of, set_pixel);
}
[[gnu::flatten]] void machine_code_adaptive_contrast(std::span<const ScreenTriangle> triangles,
                                                     const Window& window, std::span<const ivec2> samples) {
  adaptive_contrast(triangles, window, samples, contrast_of, 0.1, colour_of, set_pixel);
}
}
