// Every method of point_cloud as a function of its own; see machine_code_test.py.
#include "modeling/point_cloud/point_cloud.hpp"

#include "modeling/point_cloud/point_cloud_notes.hpp"

using namespace gradus::point_cloud;

using Found = Normal<double>;

// Flattened: what is compared is the whole method, not a call of it
extern "C" {
[[gnu::flatten]] void machine_code_normal(const Tree<double>& tree, Index i, std::size_t k,
                                          const Place<double>& eye, Found& found) {
  found = normal(tree, i, k, eye);
}
[[gnu::flatten]] void machine_code_back_project(const gradus::Raster<double>& depth,
                                                const Pinhole<double>& camera,
                                                std::vector<Place<double>>& points) {
  points = back_project(depth, camera);
}
[[gnu::flatten]] void machine_code_draw(Places<double> points, gradus::ivec2 size, int radius,
                                        gradus::Raster<Index>& front) {
  front = draw(points, size, radius);
}
[[gnu::flatten]] void machine_code_uncentred(const Tree<double>& tree, Index i, std::size_t k,
                                             const Place<double>& eye, Found& found) {
  found = uncentred(tree, i, k, eye);
}
[[gnu::flatten]] void machine_code_unturned(const Tree<double>& tree, Index i, std::size_t k,
                                            const Place<double>& eye, Found& found) {
  found = unturned(tree, i, k, eye);
}
}
