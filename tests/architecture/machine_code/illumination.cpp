// Every method of illumination as a function of its own; see machine_code_test.py.
#include "shading/illumination/illumination.hpp"

extern "C" {
[[gnu::flatten]] void machine_code_phong(const glm::dvec3& place, const glm::dvec3& normal,
                                         const glm::dvec3& eye, const gradus::Material& material,
                                         const gradus::Light* lights, std::size_t count,
                                         gradus::illumination::Parts<double>& parts) {
  parts = gradus::illumination::phong(place, normal, eye, material,
                                      std::span<const gradus::Light>(lights, count), gradus::Rgb{1});
}
}
