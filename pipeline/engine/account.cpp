#include "engine/account.hpp"

#include "plan/planned.hpp"

namespace gradus::pipeline::engine {

void count_geometry(const Scene& scene, const Plan& plan, const Frame& frame, Ledger& ledger) {
  count_objects(scene, plan, ledger);
  std::int64_t pieces = 0;
  for (int number = 0; number < size_of(scene.objects); ++number) {
    if (!plan.draws(number)) continue;
    const Mesh& mesh = *object_at(scene, number).mesh;
    ledger.input.done += std::ssize(mesh.faces);
    ledger.world.done += std::ssize(mesh.positions);
    ledger.perspective.done += std::ssize(mesh.positions);
    pieces += triangle_count(mesh);
  }
  PieceCount count;
  std::int64_t clipped = 0, clipped_away = 0, more = 0, drawn = 0;
  for (const Batch& batch : frame.batches) {
    count.add(batch.count);
    clipped += batch.clipped;
    clipped_away += batch.clipped_away;
    more += batch.more;
    drawn += std::ssize(batch.triangles);
  }
  ledger.facing.done += pieces;
  ledger.clipping.skip("turned away", count.turned_away);
  ledger.clipping.skip(name_of(Rule::inside), pieces - count.turned_away - count.beyond_plane - clipped);
  ledger.clipping.done += count.beyond_plane + clipped;
  ledger.rasterization.total += more;
  ledger.rasterization.done += drawn;
  ledger.rasterization.skip("turned away", count.turned_away);
  ledger.rasterization.skip("cut away", count.beyond_plane + clipped_away);
  ledger.rasterization.skip("no area", count.without_area);
  ledger.rasterization.skip("no pixel", count.without_pixel);
}

}  // namespace gradus::pipeline::engine
