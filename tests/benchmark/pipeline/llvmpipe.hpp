#pragma once
// Mesa's llvmpipe as a peer of the engine: the same scene from static buffers, into a picture that stays
// where it is drawn until somebody asks for it.

#ifdef GRADUS_HAS_OSMESA

#include <memory>
#include <string>

#include "core/image.hpp"
#include "scene/scene.hpp"
#include "stages/points.hpp"

namespace gradus::bench::peers {

/// A scene in buffers of OpenGL. One at a time, on the thread that has made it.
class Llvmpipe {
 public:
  /// scene: seen in perspective, flat shading and textures without mip maps left out; point lights and
  /// directional ones without range or attenuation.
  /// threads: LP_NUM_THREADS. It counts for the process from the first context on.
  Llvmpipe(const pipeline::Scene& scene, pipeline::Size size, int threads);
  ~Llvmpipe();
  Llvmpipe(const Llvmpipe&) = delete;
  Llvmpipe& operator=(const Llvmpipe&) = delete;

  /// Clears, draws, and waits until all is drawn.
  void draw();
  /// What was drawn last.
  Image picture() const;
  /// GL_RENDERER.
  static std::string renderer();

 private:
  struct Buffers;
  std::unique_ptr<Buffers> own_;
};

}  // namespace gradus::bench::peers

#endif
