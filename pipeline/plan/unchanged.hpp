#pragma once
// Frames of a film that show what the frame before them shows.

#include <cstddef>
#include <span>
#include <vector>

#include "plan/ledger.hpp"
#include "scene/camera/view.hpp"

namespace gradus::pipeline {

/// Whether two views of one scene give the same picture because every number of theirs has the same bits.
/// Domain: any. Accuracy: on the safe side: +0 and -0 are different. Cost: none to speak of. Errors: none.
bool same_view(const View& before, const View& now);

/// For each frame the number of the frame whose picture it has (Rule::unchanged): that of the frame before,
/// where the view is the same, else its own.
///
/// views: of one scene, in the order of the run. Domain: any. Cost: same_view, once per frame. Errors: none.
std::vector<std::size_t> pictures_of(std::span<const View> views);

/// Adds what was done for a frame to what was done for all.
void add(const Ledger& frame, Ledger& sum);

/// Adds a frame that has the picture of this one: as much there would have been to do, and all of it is left
/// out.
void add_unchanged(const Ledger& frame, Ledger& sum);

}  // namespace gradus::pipeline
