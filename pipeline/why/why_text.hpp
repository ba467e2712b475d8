#pragma once
// The story of a pixel in words.

#include <string>

#include "scene/scene.hpp"
#include "stages/points.hpp"
#include "why/why.hpp"

namespace gradus::pipeline {

/// Stage by stage what happened at a pixel: each triangle that covers its centre, then the light of the one
/// seen. name: of the scene. size: of the picture.
std::string why_text(const std::string& name, const Scene& scene, Size size, const PixelStory& story);

}  // namespace gradus::pipeline
