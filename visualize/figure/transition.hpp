#pragma once
// From the sheet of one step to that of the next, for films: what stays moves, what is new fades in.

#include "figure/sheet.hpp"

namespace gradus {

/// The sheet at a share of the time between two sheets of one size: `from` at 0, `to` at 1.
///
/// Shapes of the same slot, id and kind, the n-th of a name with the n-th, move and resize, slowly at first
/// and at last; a line that only goes on grows. What cannot move, a look or a text that changes, is exchanged
/// midway. Shapes that leave fade out in the first half, those that come fade in in the second. A slot whose
/// own texts have moved (a view that follows the step, a listing or table that was scrolled, a longer legend)
/// changes as a whole midway.
Sheet in_between(const Sheet& from, const Sheet& to, double share);

}  // namespace gradus
