// Every method of painter as a function of its own; see machine_code_test.py.
#include "visibility/painter/painter.hpp"
#include "visibility/painter/painter_notes.hpp"

using namespace gradus::painter;

void draw_polygon(const Polygon<double>& polygon);  // defined nowhere: the compiler must call it

using Polygons = std::vector<Polygon<double>>;

// Not flattened: GCC takes minutes over all that the exact tests would bring in; what is called is compared
extern "C" {
void machine_code_newell(const Polygons& polygons, const View<double>& view) {
  newell(polygons, view, draw_polygon);
}
std::size_t machine_code_covered(const List<double>& list, const View<double>& view) {
  gradus::Unobserved nobody;
  return covered(list, view, nobody);
}
void machine_code_put_back(List<double>& list, const View<double>& view) {
  gradus::Unobserved nobody;
  put_back(list, view, nobody);
}
void machine_code_draw_by_planes(const List<double>& list, const View<double>& view) {
  draw_by_planes(list, view, draw_polygon, gradus::Unobserved{});
}
void machine_code_farthest_vertex(const Polygons& polygons, const View<double>& view) {
  farthest_vertex(polygons, view, draw_polygon);
}
void machine_code_centroid(const Polygons& polygons, const View<double>& view) {
  centroid(polygons, view, draw_polygon);
}
void machine_code_mean_depth(const Polygons& polygons, const View<double>& view) {
  mean_depth(polygons, view, draw_polygon);
}
void machine_code_descending_mean_z(const Polygons& polygons, const View<double>& view) {
  descending_mean_z(polygons, view, draw_polygon);
}
}
