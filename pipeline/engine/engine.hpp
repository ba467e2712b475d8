#pragma once
// The engine: the picture of the textbook chain, sooner. Vertices go through the camera once, triangles are
// sorted into tiles, each tile finds what is nearest at its pixels and then lights that alone; tiles are
// shared among threads.

#include <cstdint>
#include <functional>
#include <memory>

#include "core/image.hpp"
#include "engine/buffers.hpp"
#include "plan/ledger.hpp"
#include "plan/plan.hpp"
#include "scene/scene.hpp"
#include "stages/antialiasing.hpp"

namespace gradus::pipeline::engine {

struct Frame;

/// Whether the engine draws a scene: surfaces by the z-buffer. The textbook chain draws wireframes, and what
/// asks for an order from back to front.
bool draws(const Scene& scene);

/// Whether picture_of computes light in single precision: with the antialiasing methods `none` and, of up to
/// 16 samples, `adaptive`, where single precision suits the scene. For all else it has that of light_of.
bool draws_in_single_precision(const Scene& scene);

/// Who watches a picture being made.
struct EngineWatch {
  Ledger* ledger =
      nullptr;  ///< gets all rows but what planning and `output` take; `hidden` is never among them
  Clock clock{};
  std::function<void(double)> reached{};  ///< told of the share of the tiles that are done, from any thread
};

/// The light of the part of the picture that a plan asks for, with the scene's antialiasing.
///
/// buffers: of this scene. plan: of this scene; nothing is added to it. threads: how many work at once; 0 for
///   as many as the machine has. watch: told of the work.
///
/// Domain: draws(scene), else refused; that of `antialiased`.
/// Accuracy: the bits of `antialiased`, for any number of threads.
/// Cost: stages 2 to 5 once per vertex and piece, 6 and 7 by tile, shading as `antialias` has it. Memory: 88
///   bytes per vertex, 80 per triangle that is drawn, 32 per pixel; with antialiasing 400 more for each
///   triangle of the tiles that are being drawn, and what the method takes for their pixels.
/// Errors: ContractViolation outside the domain.
LightPicture light_of(const Scene& scene, const Buffers& buffers, const Plan& plan, int threads = 0,
                      const EngineWatch& watch = {});

/// A picture, and how many of its pixels show some of an object.
struct Picture {
  Image image;
  std::int64_t covered = 0;
};

/// Memory that pictures take and the next one can have.
class Workspace {
 public:
  Workspace();
  ~Workspace();
  Workspace(Workspace&&) noexcept;
  Workspace& operator=(Workspace&&) noexcept;

  Frame& frame() { return *frame_; }

 private:
  std::unique_ptr<Frame> frame_;
};

/// The part of the picture that a plan asks for, before the scene's background: in single precision, sixteen
/// pixels at once, where draws_in_single_precision says so.
///
/// scene, buffers, plan, threads: as for light_of. workspace: of one picture at a time.
///
/// Domain, Errors: those of light_of.
/// Accuracy: every pixel shows the triangle that the textbook chain shows there. Its colour is that of
///   `render_antialiased`; in single precision it may be one step of 255 off, at the edge of a spot's cone,
///   too. The same bytes on every machine and for any number of threads.
/// Cost: some nanoseconds per vertex, triangle and pixel: docs/engine.md.
Picture picture_of(const Scene& scene, const Buffers& buffers, const Plan& plan, Workspace& workspace,
                   int threads = 0, const EngineWatch& watch = {});
/// The same into a picture that is there: where its size is the one asked for, in its own memory, so that the
/// system has not to give megabytes for every frame.
void draw_into(Picture& picture, const Scene& scene, const Buffers& buffers, const Plan& plan,
               Workspace& workspace, int threads = 0, const EngineWatch& watch = {});

/// The picture of a scene from the centres of its pixels, as pipeline::render makes it.
/// Accuracy: that of picture_of.
Image render(const Scene& scene, Size size, int threads = 0);

}  // namespace gradus::pipeline::engine
