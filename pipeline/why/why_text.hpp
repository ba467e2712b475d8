#pragma once
// The story of a pixel in words.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"
#include "stages/points.hpp"
#include "why/why.hpp"

namespace gradus::pipeline {

/// Stage by stage what happened at a pixel: each triangle that covers its centre, then the light of the one
/// seen. name: of the scene. size: of the picture.
std::string why_text(const std::string& name, const Scene& scene, Size size, const PixelStory& story);

/// A part of it, of whole lines.
struct StoryPart {
  std::string text;
  bool of_triangle = false;  ///< the same at every pixel that this triangle covers
};

/// What is said of triangles, by their places in the list that all pixels have.
using TriangleTexts = std::map<int, std::string>;

/// The same in parts. known: what was said before, of pixels of the same picture.
std::vector<StoryPart> why_parts(const std::string& name, const Scene& scene, Size size,
                                 const PixelStory& story, TriangleTexts& known);

/// What it calls the triangle of a fragment: "Spot, face 812 (spot.obj:4031), triangle 1 of 2".
std::string triangle_name(const Scene& scene, const FragmentStory& story);
/// And what the depths of fragments are: "depth", or "drawing order" where the last one is seen.
std::string_view depth_name(const Scene& scene);
/// And a light, by its number: "light 1 (directional)".
std::string light_name(const Scene& scene, std::size_t number);
/// And where the light of a pixel is computed: "Phong: at the pixel".
std::string lit_where(Shading shading);
/// And its numbers: six digits.
std::string told_number(double value);
std::string told_colour(const Rgba8& colour);

}  // namespace gradus::pipeline
