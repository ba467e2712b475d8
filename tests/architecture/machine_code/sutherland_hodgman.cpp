// Every method of sutherland_hodgman as a function of its own; see machine_code_test.py.
#include "clipping/sutherland_hodgman/sutherland_hodgman.hpp"
#include "clipping/sutherland_hodgman/separate_pieces.hpp"
#include "clipping/sutherland_hodgman/sutherland_hodgman_homogeneous.hpp"
#include "clipping/sutherland_hodgman/sutherland_hodgman_notes.hpp"

using namespace gradus::sutherland_hodgman;

using Ways = std::span<const int>;
using Corners = std::vector<Vertex<double>>;

extern "C" {
// By all planes, which has the cutting at one of them within
[[gnu::flatten]] void machine_code_clip(std::vector<Point<double>>& polygon, const Plane<double>* planes,
                                        std::size_t count) {
  polygon = clip(polygon, std::span<const Plane<double>>(planes, count));
}
void machine_code_cut_at_border(std::span<const Vertex<double>> polygon, int border,
                                const Scene<double, gradus::Rectangle<double>>& scene, Kept<double>& kept) {
  cut_at_border(polygon, ExactBorder{scene, border}, kept);
}
void machine_code_split_at(int border, std::vector<Ring<double>>& rings,
                           const Scene<double, ConvexWindow<double>>& scene) {
  split_at(border, rings, scene);
}
void machine_code_bridges(std::span<const Vertex<double>> polygon, std::span<const glm::dvec2> points,
                          const gradus::Rectangle<double>& window, std::vector<BridgeFound<double>>& result) {
  result = bridges(polygon, points, window);
}
void machine_code_separate_pieces(const Rings<double>& polygon, const gradus::Rectangle<double>& window,
                                  Ways order, std::vector<Piece<double>>& result) {
  result = separate_pieces(polygon, window, order);
}
void machine_code_cut_of_a_cut(std::span<const Vertex<double>> polygon, const PlainBorder<double>& border,
                               Corners& result) {
  result = cut_of_a_cut(polygon, border);
}
void machine_code_entering_not_cut(std::span<const Vertex<double>> polygon, const PlainBorder<double>& border,
                                   Corners& result) {
  result = entering_not_cut(polygon, border);
}
void machine_code_previous_left_behind(std::span<const Vertex<double>> polygon,
                                       const PlainBorder<double>& border, Corners& result) {
  result = previous_left_behind(polygon, border);
}
void machine_code_marked_by_window(std::span<const Vertex<double>> polygon, const PlainBorder<double>& border,
                                   Corners& result) {
  result = marked_by_window(polygon, border);
}
void machine_code_containing_left_whole(const Task<double>& task, Corners& result) {
  result = containing_left_whole(task);
}
}
