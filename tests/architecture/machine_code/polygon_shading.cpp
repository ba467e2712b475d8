// Every method of polygon_shading as a function of its own; see machine_code_test.py.
#include <vector>

#include "shading/polygon_shading/polygon_shading.hpp"
#include "shading/polygon_shading/polygon_shading_notes.hpp"
#include "shading/polygon_shading/vertex_normals.hpp"

using namespace gradus::polygon_shading;
using Smooth = std::span<const Corner<double, Surface<double>>>;
using Lit = std::span<const Corner<double, double>>;

void set_pixel(gradus::ivec2 p, double colour);  // defined nowhere: the compiler must call it
double light(glm::dvec3 place, glm::dvec3 normal);

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_flat(Smooth polygon, gradus::Window picture) {
  flat(polygon, picture, light, set_pixel);
}
[[gnu::flatten]] void machine_code_gouraud(Lit polygon, gradus::Window picture) {
  gouraud(polygon, picture, set_pixel);
}
[[gnu::flatten]] void machine_code_phong(Smooth polygon, gradus::Window picture) {
  phong(polygon, picture, light, set_pixel);
}
[[gnu::flatten]] void machine_code_light_vertices(std::span<const Surface<double>> vertices,
                                                  std::span<double> lit) {
  light_vertices(vertices, light, lit);
}
[[gnu::flatten]] void machine_code_flat_by_vertex_normals(Smooth polygon, gradus::Window picture) {
  flat_by_vertex_normals(polygon, picture, light, set_pixel);
}
[[gnu::flatten]] void machine_code_vertex_normals(std::span<const glm::dvec3> places,
                                                  const std::vector<std::vector<int>>& faces,
                                                  std::span<glm::dvec3> normals) {
  vertex_normals(places, faces, Weighting::angle, normals);
}
}
