#include "engine/geometry.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "projection/perspective/perspective.hpp"
#include "projection/viewing/viewing.hpp"
#include "stages/1_input.hpp"
#include "stages/2_world.hpp"
#include "stages/3_perspective.hpp"
#include "stages/4_back_faces.hpp"
#include "stages/5_clipping.hpp"
#include "stages/6_rasterization.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline::engine {
namespace {

using GuardPlanes = std::array<sutherland_hodgman::Plane<double>, 6>;

// --- Vertices ------------------------------------------------------------------------------------

/// What all vertices and pieces of a picture are given.
struct Passage {
  const Scene& scene;
  Size size;
  SceneLens lens;
  GuardPlanes planes;
};

FrameVertex vertex_of(const Passage& passage, const glm::dmat4& placement, dvec3 at) {
  const auto& [scene, size, lens, planes] = passage;
  FrameVertex v;
  v.world = affine_3d::transform(placement, at);
  v.clip = transform(lens, viewing::to_view(scene.camera.frame, v.world));
  v.inside = std::ranges::all_of(planes, [&](const auto& plane) { return distance(plane, v.clip) >= 0; });
  if (!v.inside) return v;
  const dvec3 ndc = perspective::divide(v.clip);
  v.depth = ndc.z;
  v.grid = triangle_coverage::snap(viewport::to_pixel(dvec2(ndc), size.width, size.height));
  return v;
}

/// The object that has an element of all: the last that begins at it or before.
std::size_t object_with(const Frame& frame, std::int64_t element, std::int64_t FrameObject::* first) {
  const auto after = std::ranges::upper_bound(frame.objects, element, {}, first);
  return static_cast<std::size_t>(after - frame.objects.begin()) - 1;
}

void place_vertices(const Passage& passage, Frame& frame) {
  const auto count = std::ssize(frame.vertices);
  const tbb::blocked_range<std::int64_t> all(0, count, 2048);
  tbb::parallel_for(all, [&](const tbb::blocked_range<std::int64_t>& part) {
    std::size_t object = object_with(frame, part.begin(), &FrameObject::first_vertex);
    for (std::int64_t i = part.begin(); i < part.end(); ++i) {
      while (object + 1 < frame.objects.size() && frame.objects[object + 1].first_vertex <= i) ++object;
      const FrameObject& of = frame.objects[object];
      const Object& placed = object_at(passage.scene, of.number);
      const dvec3 at = placed.mesh->positions[static_cast<std::size_t>(i - of.first_vertex)];
      frame.vertices[static_cast<std::size_t>(i)] = vertex_of(passage, placed.placement, at);
    }
  });
}

// --- Pieces --------------------------------------------------------------------------------------

/// The places of a piece's corners in it, counter-clockwise seen from outside after the placement.
std::array<std::size_t, 3> order_of(const FrameObject& object) {
  if (object.mirrored) return {0, 2, 1};
  return {0, 1, 2};
}

const FrameVertex& vertex_at(const Frame& frame, const FrameObject& object, std::int32_t vertex) {
  return frame.vertices[static_cast<std::size_t>(object.first_vertex + vertex)];
}

/// A piece with what clipping and shading ask for: the polygon of stage 5.
Polygon whole_polygon(const Scene& scene, const Frame& frame, const FrameObject& object,
                      const MeshPiece& piece, bool seen_from_behind) {
  const Mesh& mesh = *object_at(scene, object.number).mesh;
  const MeshFace& face = mesh.faces[static_cast<std::size_t>(piece.face)];
  Polygon polygon;
  polygon.reserve(3);
  for (const std::size_t k : order_of(object)) {
    const PieceCorner corner = corner_of(mesh, face, piece.corners[k], 0);
    const dvec3 normal = unit_vector(object.normal_matrix * corner.normal);
    const FrameVertex& v = vertex_at(frame, object, piece.vertices[k]);
    polygon.push_back({v.clip, v.world, seen_from_behind ? -normal : normal, corner.texture});
  }
  return polygon;
}

PieceId id_of(const FrameObject& object, const MeshPiece& piece) {
  return {object.number, piece.face, piece.piece};
}

/// Whether stage 4 keeps a piece, from which side it is seen.
struct Side {
  bool keep = false, behind = false;
};

Side side_of(const std::array<const FrameVertex*, 3>& v, bool two_sided) {
  using back_face_culling::Facing;
  const Facing facing = back_face_culling::facing(v[0]->clip, v[1]->clip, v[2]->clip);
  const bool behind = facing == Facing::back;
  return {facing == Facing::front || (behind && two_sided), behind};
}

/// Stages 4 and 5 for the pieces of one object.
class PieceWork {
 public:
  PieceWork(const Passage& passage, const Frame& frame, std::size_t object, Batch& batch)
      : passage_(passage),
        frame_(frame),
        object_(frame.objects[object]),
        place_(static_cast<std::int32_t>(object)),
        order_(order_of(object_)),
        two_sided_(two_sided(passage.scene, Piece{{object_.number, 0, 0}, {}, false})),
        batch_(batch) {}

  void operator()(std::int32_t number) {
    const MeshPiece& piece = object_.pieces[static_cast<std::size_t>(number)];
    const auto vertex = [&](std::size_t k) { return &vertex_at(frame_, object_, piece.vertices[order_[k]]); };
    const std::array<const FrameVertex*, 3> v{vertex(0), vertex(1), vertex(2)};
    const Side side = side_of(v, two_sided_);
    if (!side.keep) return;
    if (v[0]->inside && v[1]->inside && v[2]->inside) {
      add({{v[0]->grid, v[1]->grid, v[2]->grid},
           {v[0]->depth, v[1]->depth, v[2]->depth},
           place_,
           number,
           false,
           side.behind});
    } else {
      cut(piece, side.behind);
    }
  }

 private:
  /// Keeps what stage 6 draws.
  void add(const FrameTriangle& t) {
    const std::int64_t area = triangle_coverage::doubled_area(t.grid);
    if (t.seen_from_behind ? area > 0 : area < 0) batch_.triangles.push_back(t);
  }

  void cut(const MeshPiece& number, bool behind) {
    const Polygon before = whole_polygon(passage_.scene, frame_, object_, number, behind);
    const Piece piece{id_of(object_, number), {}, behind};
    for (const Triangle& t : fan(piece, divided(part_inside(before, passage_.planes)))) {
      const auto& [a, b, c] = t.corners;
      const auto place = static_cast<std::int32_t>(batch_.cut.size());
      batch_.cut.push_back(t);
      add({on_grid(snapped(in_picture(t, passage_.size))),
           {a.ndc.at.z, b.ndc.at.z, c.ndc.at.z},
           place_,
           place,
           true,
           behind});
    }
  }

  const Passage& passage_;
  const Frame& frame_;
  const FrameObject& object_;
  std::int32_t place_;
  std::array<std::size_t, 3> order_;
  bool two_sided_;
  Batch& batch_;
};

void work_on(const Passage& passage, const Frame& frame, std::int64_t begin, std::int64_t end, Batch& batch) {
  std::size_t object = object_with(frame, begin, &FrameObject::first_piece);
  while (begin < end) {
    const FrameObject& of = frame.objects[object];
    const std::int64_t last = std::min(end, of.first_piece + std::ssize(of.pieces));
    PieceWork work(passage, frame, object, batch);
    for (; begin < last; ++begin) work(static_cast<std::int32_t>(begin - of.first_piece));
    ++object;
  }
}

std::vector<FrameObject> objects_of(const Scene& scene, const Buffers& buffers, const Plan& plan) {
  std::vector<FrameObject> objects;
  std::int64_t vertices = 0, pieces = 0;
  for (int number = 0; number < size_of(scene.objects); ++number) {
    const auto& own = *buffers.pieces[static_cast<std::size_t>(number)];
    if (!plan.draws(number) || own.empty()) continue;
    const Object& object = object_at(scene, number);
    objects.push_back({number, vertices, pieces, own, affine_3d::normal_matrix(object.placement),
                       affine_3d::mirrors(object.placement)});
    vertices += std::ssize(object.mesh->positions);
    pieces += std::ssize(own);
  }
  return objects;
}

}  // namespace

Frame frame_of(const Scene& scene, const Buffers& buffers, const Plan& plan) {
  const auto [width, height] = plan.size;
  const Passage passage{scene, plan.size, lens_of(scene.camera, static_cast<double>(width) / height),
                        guard_volume(plan.size)};
  Frame frame{objects_of(scene, buffers, plan), {}, {}};
  if (frame.objects.empty()) return frame;
  const FrameObject& last = frame.objects.back();
  frame.vertices.resize(static_cast<std::size_t>(last.first_vertex) +
                        object_at(scene, last.number).mesh->positions.size());
  place_vertices(passage, frame);

  const std::int64_t pieces = last.first_piece + std::ssize(last.pieces);
  frame.batches.resize(static_cast<std::size_t>((pieces + batch_pieces - 1) / batch_pieces));
  tbb::parallel_for(std::int64_t{0}, std::ssize(frame.batches), [&](std::int64_t i) {
    const std::int64_t begin = i * batch_pieces, end = std::min(pieces, begin + batch_pieces);
    work_on(passage, frame, begin, end, frame.batches[static_cast<std::size_t>(i)]);
  });
  return frame;
}

Triangle whole_triangle(const Scene& scene, const Frame& frame, std::int32_t id) {
  const FrameTriangle& t = frame.triangle(id);
  if (t.cut) {
    const Batch& batch = frame.batches[static_cast<std::size_t>(id / batch_triangles)];
    return batch.cut[static_cast<std::size_t>(t.piece)];
  }
  const FrameObject& object = frame.objects[static_cast<std::size_t>(t.object)];
  const MeshPiece& piece = object.pieces[static_cast<std::size_t>(t.piece)];
  const auto corners = divided(whole_polygon(scene, frame, object, piece, t.seen_from_behind));
  return {id_of(object, piece), {corners[0], corners[1], corners[2]}, t.seen_from_behind};
}

}  // namespace gradus::pipeline::engine
