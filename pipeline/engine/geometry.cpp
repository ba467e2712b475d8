#include "engine/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/cores.hpp"
#include "projection/viewing/viewing.hpp"
#include "stages/1_input.hpp"
#include "stages/4_back_faces.hpp"
#include "stages/5_clipping.hpp"
#include "stages/6_rasterization.hpp"
#include "transformation/affine_3d/affine_3d.hpp"

namespace gradus::pipeline::engine {
namespace {

/// The object that has an element of all: the last that begins at it or before.
std::size_t object_with(const Frame& frame, std::int64_t element, std::int64_t FrameObject::* first) {
  const auto after = std::ranges::upper_bound(frame.objects, element, {}, first);
  return static_cast<std::size_t>(after - frame.objects.begin()) - 1;
}

// --- Vertices ------------------------------------------------------------------------------------

/// Vertices from begin to end, which may belong to several objects.
void place_part(const Scene& scene, std::int64_t begin, std::int64_t end, Frame& frame) {
  std::size_t object = object_with(frame, begin, &FrameObject::first_vertex);
  while (begin < end) {
    const FrameObject& of = frame.objects[object];
    const Object& placed = object_at(scene, of.number);
    const std::span<const dvec3> own(placed.mesh->positions);
    const std::int64_t last = std::min(end, of.first_vertex + std::ssize(own));
    const auto first = static_cast<std::size_t>(begin), count = static_cast<std::size_t>(last - begin);
    place_vertices(
        frame.path, placed.placement, own.subspan(static_cast<std::size_t>(begin - of.first_vertex), count),
        std::span(frame.grid).subspan(first, count), std::span(frame.depths).subspan(first, count));
    begin = last;
    ++object;
  }
}

void place_all_vertices(const Scene& scene, Frame& frame) {
  in_parts(frame.grid.size(), 4096, [&](std::size_t begin, std::size_t end) {
    place_part(scene, static_cast<std::int64_t>(begin), static_cast<std::int64_t>(end), frame);
  });
}

/// A vertex in the world and in clip space.
struct SpaceVertex {
  dvec3 world{0};
  glm::dvec4 clip{0};
};

SpaceVertex in_space(const Scene& scene, const Frame& frame, const FrameObject& object, std::int32_t vertex) {
  const Object& placed = object_at(scene, object.number);
  const dvec3 world =
      affine_3d::transform(placed.placement, placed.mesh->positions[static_cast<std::size_t>(vertex)]);
  return {world, transform(frame.path.lens, viewing::to_view(scene.camera.frame, world))};
}

/// The depths of all shared planes.
void place_planes(const Scene& scene, Frame& frame) {
  frame.planes.clear();
  for (const FrameObject& object : frame.objects) {
    for (const auto& [a, b, c] : object.pieces->shared.planes) {
      const auto at = [&](int vertex) { return in_space(scene, frame, object, vertex).clip; };
      frame.planes.push_back(plane_depth({at(a), at(b), at(c)}, frame.path.size));
    }
  }
}

// --- Pieces --------------------------------------------------------------------------------------

/// The places of a piece's corners in it, counter-clockwise seen from outside after the placement.
std::array<std::size_t, 3> order_of(const FrameObject& object) {
  if (object.mirrored) return {0, 2, 1};
  return {0, 1, 2};
}

/// A piece with what clipping and shading ask for: the polygon of stage 5.
Polygon whole_polygon(const Scene& scene, const Frame& frame, const FrameObject& object, std::size_t piece,
                      bool seen_from_behind) {
  const Mesh& mesh = *object_at(scene, object.number).mesh;
  const MeshPiece& of_face = object.pieces->of_faces[piece];
  const MeshFace& face = mesh.faces[static_cast<std::size_t>(of_face.face)];
  Polygon polygon;
  polygon.reserve(3);
  for (const std::size_t k : order_of(object)) {
    const PieceCorner corner = corner_of(mesh, face, of_face.corners[k], 0);
    const dvec3 normal = unit_vector(object.normal_matrix * corner.normal);
    const auto [world, clip] = in_space(scene, frame, object, object.pieces->vertices[piece][k]);
    polygon.push_back({clip, world, seen_from_behind ? -normal : normal, corner.texture});
  }
  return polygon;
}

PieceId id_of(const FrameObject& object, std::size_t piece) {
  const MeshPiece& of_face = object.pieces->of_faces[piece];
  return {object.number, of_face.face, of_face.piece};
}

/// Stages 4 and 5 for pieces of one object.
class PieceWork {
 public:
  PieceWork(const Scene& scene, const Frame& frame, std::size_t object, const Window& window, Touch touch,
            Batch& batch)
      : scene_(scene),
        frame_(frame),
        object_(frame.objects[object]),
        place_(static_cast<std::int32_t>(object)),
        window_(window),
        touch_(touch),
        batch_(batch) {}

  void operator()(std::int64_t begin, std::int64_t end) {
    std::array<Left, batch_pieces> left;
    const auto count = static_cast<std::size_t>(end - begin);
    const PieceChoice choice{window_, touch_ == Touch::centres ? 0 : 1, object_.two_sided, object_.mirrored};
    const PieceCount counted = choose_pieces(
        choice, std::span(object_.pieces->vertices).subspan(static_cast<std::size_t>(begin), count),
        frame_.grid.data() + object_.first_vertex, static_cast<std::int32_t>(begin), left);
    batch_.count.add(counted);
    for (const Left& piece : std::span(left).first(static_cast<std::size_t>(counted.left))) {
      if (piece.seen() == Seen::unsure)
        look_closely(piece.number());
      else
        put_uncut(piece.number(), piece.seen() == Seen::behind, batch_.triangles.emplace_back());
    }
  }

 private:
  FrameTriangle uncut(std::int32_t number, bool behind) const {
    FrameTriangle t;
    put_uncut(number, behind, t);
    return t;
  }
  /// Writes a triangle where it stays: one that is written elsewhere and copied waits for its own parts.
  void put_uncut(std::int32_t number, bool behind, FrameTriangle& t) const {
    const PieceVertices& piece = object_.pieces->vertices[static_cast<std::size_t>(number)];
    const auto order = order_of(object_);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto vertex = static_cast<std::size_t>(object_.first_vertex + piece[order[k]]);
      t.grid[k] = frame_.grid[vertex];
      t.depth[static_cast<int>(k)] = frame_.depths[vertex];
    }
    t.object = place_;
    t.piece = number;
    t.seen_from_behind = behind;
    t.plane = plane_told_by(number, t.depth);
  }

  /// The place of a piece's shared plane among those of the frame.
  std::int32_t plane_of(std::int32_t number) const {
    const int own = object_.pieces->shared.of[static_cast<std::size_t>(number)];
    return own == SharedPlanes::none ? no_plane : static_cast<std::int32_t>(object_.first_plane) + own;
  }
  /// The same where a triangle of that piece has its depths from it.
  std::int32_t plane_told_by(std::int32_t number, const dvec3& corners) const {
    const std::int32_t plane = plane_of(number);
    if (plane == no_plane) return plane;
    return told_by(frame_.planes[static_cast<std::size_t>(plane)], corners) ? plane : no_plane;
  }

  void look_closely(std::int32_t number) {
    using back_face_culling::Facing;
    const PieceVertices& piece = object_.pieces->vertices[static_cast<std::size_t>(number)];
    const auto order = order_of(object_);
    const auto clip = [&](std::size_t k) { return in_space(scene_, frame_, object_, piece[order[k]]).clip; };
    const Facing facing = back_face_culling::facing(clip(0), clip(1), clip(2));
    const bool behind = facing == Facing::back;
    if (facing == Facing::edge_on || (behind && !object_.two_sided)) {
      ++batch_.count.turned_away;
      return;
    }
    const auto outside = [&](std::int32_t vertex) {
      return frame_.grid[static_cast<std::size_t>(object_.first_vertex + vertex)].x == beyond;
    };
    if (std::ranges::any_of(piece, outside))
      cut(number, behind);
    else
      add(uncut(number, behind));
  }

  /// Keeps what stage 6 draws, where it may cover something.
  void add(const FrameTriangle& t) {
    const std::int64_t area = triangle_coverage::doubled_area(t.grid);
    const bool drawn = t.seen_from_behind ? area > 0 : area < 0;
    if (!drawn)
      ++batch_.count.without_area;
    else if (touched(t.grid, window_, touch_).empty())
      ++batch_.count.without_pixel;
    else
      batch_.triangles.push_back(t);
  }

  void cut(std::int32_t number, bool behind) {
    const auto place = static_cast<std::size_t>(number);
    const Polygon before = whole_polygon(scene_, frame_, object_, place, behind);
    const Piece piece{id_of(object_, place), {}, behind, plane_of(number)};
    const auto planes = guard_volume(frame_.path.size);
    const Triangles parts = fan(piece, divided(part_inside(before, planes)), frame_.planes);
    ++batch_.clipped;
    batch_.clipped_away += parts.empty();
    batch_.more += parts.empty() ? 0 : std::ssize(parts) - 1;
    for (const Triangle& t : parts) {
      const auto& [a, b, c] = t.corners;
      const auto in_cut = static_cast<std::int32_t>(batch_.cut.size());
      batch_.cut.push_back(t);
      add({on_grid(snapped(in_picture(t, frame_.path.size))),
           {a.ndc.at.z, b.ndc.at.z, c.ndc.at.z},
           place_,
           in_cut,
           true,
           behind,
           t.depth ? plane_of(number) : no_plane});
    }
  }

  const Scene& scene_;
  const Frame& frame_;
  const FrameObject& object_;
  std::int32_t place_;
  Window window_;
  Touch touch_;
  Batch& batch_;
};

/// Pieces from begin to end, which may belong to several objects.
void make_batch(const Scene& scene, const Frame& frame, const Window& window, Touch touch, std::int64_t begin,
                std::int64_t end, Batch& batch) {
  batch.triangles.clear();
  batch.cut.clear();
  batch.count = {};
  batch.clipped = batch.clipped_away = batch.more = 0;
  std::size_t object = object_with(frame, begin, &FrameObject::first_piece);
  while (begin < end) {
    const FrameObject& of = frame.objects[object];
    const std::int64_t last = std::min(end, of.first_piece + of.pieces->count());
    PieceWork(scene, frame, object, window, touch, batch)(begin - of.first_piece, last - of.first_piece);
    begin = last;
    ++object;
  }
}

/// The objects that a plan draws, those nearer to the eye first, by one vertex of each: what comes later is
/// then often hidden.
std::vector<int> front_to_back(const Scene& scene, const Buffers& buffers, const Plan& plan) {
  std::vector<std::pair<double, int>> order;
  const auto& eye = scene.camera.frame;
  for (int number = 0; number < size_of(scene.objects); ++number) {
    if (!plan.draws(number) || buffers.pieces[static_cast<std::size_t>(number)]->count() == 0) continue;
    const Object& object = object_at(scene, number);
    const dvec3 place = affine_3d::transform(object.placement, object.mesh->positions.front());
    const double distance = glm::dot(eye.forward, place - eye.eye);
    order.emplace_back(std::isfinite(distance) ? distance : 0, number);
  }
  std::ranges::sort(order);
  std::vector<int> numbers(order.size());
  std::ranges::transform(order, numbers.begin(), [](const auto& placed) { return placed.second; });
  return numbers;
}

std::vector<FrameObject> objects_of(const Scene& scene, const Buffers& buffers, const Plan& plan) {
  std::vector<FrameObject> objects;
  std::int64_t vertices = 0, pieces = 0, planes = 0;
  for (const int number : front_to_back(scene, buffers, plan)) {
    const MeshPieces& own = *buffers.pieces[static_cast<std::size_t>(number)];
    const Object& object = object_at(scene, number);
    objects.push_back({number, vertices, pieces, planes, &own, affine_3d::normal_matrix(object.placement),
                       affine_3d::mirrors(object.placement),
                       two_sided(scene, Piece{{number, 0, 0}, {}, false})});
    vertices += std::ssize(object.mesh->positions);
    pieces += own.count();
    planes += std::ssize(own.shared.planes);
  }
  return objects;
}

}  // namespace

Window touched(const triangle_coverage::Triangle& t, const Window& window, Touch touch) {
  if (touch == Touch::centres) return triangle_coverage::centres(t, window);
  const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
  return intersection({{(left >> 8) - 1, (top >> 8) - 1}, {(right >> 8) + 1, (bottom >> 8) + 1}}, window);
}

void make_frame(const Scene& scene, const Buffers& buffers, const Plan& plan, Touch touch, Frame& frame) {
  const auto [width, height] = plan.size;
  frame.path = {scene.camera, lens_of(scene.camera, static_cast<double>(width) / height), plan.size};
  frame.objects = objects_of(scene, buffers, plan);
  std::int64_t vertices = 0, pieces = 0;
  if (!frame.objects.empty()) {
    const FrameObject& last = frame.objects.back();
    vertices = last.first_vertex + std::ssize(object_at(scene, last.number).mesh->positions);
    pieces = last.first_piece + last.pieces->count();
  }
  frame.grid.resize(static_cast<std::size_t>(vertices));
  frame.depths.resize(static_cast<std::size_t>(vertices));
  place_all_vertices(scene, frame);
  place_planes(scene, frame);

  frame.batches.resize(static_cast<std::size_t>((pieces + batch_pieces - 1) / batch_pieces));
  for_each_of(frame.batches.size(), [&](std::size_t i) {
    const std::int64_t begin = static_cast<std::int64_t>(i) * batch_pieces;
    const std::int64_t end = std::min(pieces, begin + batch_pieces);
    make_batch(scene, frame, plan.window, touch, begin, end, frame.batches[i]);
  });
}

Triangle whole_triangle(const Scene& scene, const Frame& frame, std::int32_t id) {
  const FrameTriangle& t = frame.triangle(id);
  if (t.cut) return frame.cut_triangle(id);
  const FrameObject& object = frame.object_of(t);
  const auto piece = static_cast<std::size_t>(t.piece);
  const auto corners = divided(whole_polygon(scene, frame, object, piece, t.seen_from_behind));
  const int plane = object.pieces->shared.of[piece];
  return {id_of(object, piece),
          {corners[0], corners[1], corners[2]},
          t.seen_from_behind,
          plane,
          frame.plane_of(t)};
}

}  // namespace gradus::pipeline::engine
