// Every method of texture_mapping as a function of its own; see machine_code_test.py.
#include "shading/texture_mapping/texture_mapping.hpp"
#include "shading/texture_mapping/texture_mapping_notes.hpp"

using namespace gradus::texture_mapping;
using gradus::dvec2, gradus::ivec2;

void set_pixel(ivec2 p, dvec2 uv, const Footprint<double>& area);  // defined nowhere: it must be called
double texel(ivec2 at);

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] double machine_code_nearest(dvec2 uv, Extent texture) { return nearest(uv, texture, texel); }
[[gnu::flatten]] double machine_code_bilinear(dvec2 uv, Extent texture) {
  return bilinear(uv, texture, texel);
}
[[gnu::flatten]] void machine_code_build_mip_chain(ivec2 size, std::span<double> chain) {
  build_mip_chain(size, texel, chain);
}
[[gnu::flatten]] double machine_code_mip_mapped(dvec2 uv, const Footprint<double>& area,
                                                const MipChain<double>& chain) {
  return mip_mapped(uv, area, chain);
}
[[gnu::flatten]] void machine_code_perspective_correct(const Triangle& triangle,
                                                       const Corners<double>& corners,
                                                       gradus::Window picture) {
  perspective_correct(triangle, corners, picture, set_pixel);
}
[[gnu::flatten]] void machine_code_affine(const Triangle& triangle, const Corners<double>& corners,
                                          gradus::Window picture) {
  affine(triangle, corners, picture, set_pixel);
}
}
