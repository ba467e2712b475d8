// Phong's model at one place, under one lamp.
#include <cstdio>
#include <shading/illumination/illumination.hpp>

int main() {
  using namespace gradus;
  const illumination::Reflectance<float> material{
      .ambient = LinearRgb{0.1f}, .diffuse = LinearRgb{0.7f}, .specular = LinearRgb{0.2f}, .shininess = 10};
  const Light lamp{.position = {0, 3, 4}};
  const auto light = illumination::phong<double>({0, 0, 0}, {0, 0, 1}, {0, -3, 4}, material,
                                                 std::span(&lamp, 1), LinearRgb{1});
  std::printf("%.4f\n", light.sum().x);
}
// prints: 0.8600
