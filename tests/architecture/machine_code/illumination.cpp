// Every method of illumination as a function of its own; see machine_code_test.py.
#include "shading/illumination/illumination.hpp"
#include "core/surface.hpp"
#include "shading/illumination/illumination_notes.hpp"

extern "C" {
[[gnu::flatten]] void machine_code_phong(const glm::dvec3& place, const glm::dvec3& normal,
                                         const glm::dvec3& eye, const gradus::Material& material,
                                         const gradus::Light* lights, std::size_t count,
                                         bool (*visible)(glm::dvec3, glm::dvec3, double),
                                         gradus::illumination::Parts<double>& parts) {
  parts =
      gradus::illumination::phong(place, normal, eye, material, std::span<const gradus::Light>(lights, count),
                                  gradus::LinearRgb{1}, visible);
}
[[gnu::flatten]] void machine_code_blinn_phong(const glm::dvec3& place, const glm::dvec3& normal,
                                               const glm::dvec3& eye, const gradus::Material& material,
                                               const gradus::Light* lights, std::size_t count,
                                               bool (*visible)(glm::dvec3, glm::dvec3, double),
                                               gradus::illumination::Parts<double>& parts) {
  parts = gradus::illumination::blinn_phong(place, normal, eye, material,
                                            std::span<const gradus::Light>(lights, count),
                                            gradus::LinearRgb{1}, visible);
}
[[gnu::flatten]] void machine_code_unclamped(const glm::dvec3& place, const glm::dvec3& normal,
                                             const glm::dvec3& eye, const gradus::Material& material,
                                             const gradus::Light* lights, std::size_t count,
                                             bool (*visible)(glm::dvec3, glm::dvec3, double),
                                             gradus::illumination::Parts<double>& parts) {
  parts = gradus::illumination::unclamped(place, normal, eye, material,
                                          std::span<const gradus::Light>(lights, count), gradus::LinearRgb{1},
                                          visible);
}
[[gnu::flatten]] void machine_code_light_behind(const glm::dvec3& place, const glm::dvec3& normal,
                                                const glm::dvec3& eye, const gradus::Material& material,
                                                const gradus::Light* lights, std::size_t count,
                                                bool (*visible)(glm::dvec3, glm::dvec3, double),
                                                gradus::illumination::Parts<double>& parts) {
  parts = gradus::illumination::light_behind(place, normal, eye, material,
                                             std::span<const gradus::Light>(lights, count),
                                             gradus::LinearRgb{1}, visible);
}
[[gnu::flatten]] void machine_code_tinted_highlight(const glm::dvec3& place, const glm::dvec3& normal,
                                                    const glm::dvec3& eye, const gradus::Material& material,
                                                    const gradus::Light* lights, std::size_t count,
                                                    bool (*visible)(glm::dvec3, glm::dvec3, double),
                                                    gradus::illumination::Parts<double>& parts) {
  parts = gradus::illumination::tinted_highlight(place, normal, eye, material,
                                                 std::span<const gradus::Light>(lights, count),
                                                 gradus::LinearRgb{1}, visible);
}
[[gnu::flatten]] void machine_code_light_minus_normal(const glm::dvec3& place, const glm::dvec3& normal,
                                                      const glm::dvec3& eye, const gradus::Material& material,
                                                      const gradus::Light* lights, std::size_t count,
                                                      bool (*visible)(glm::dvec3, glm::dvec3, double),
                                                      gradus::illumination::Parts<double>& parts) {
  parts = gradus::illumination::light_minus_normal(place, normal, eye, material,
                                                   std::span<const gradus::Light>(lights, count),
                                                   gradus::LinearRgb{1}, visible);
}
}
