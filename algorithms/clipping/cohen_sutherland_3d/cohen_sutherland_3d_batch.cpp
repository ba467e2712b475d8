#include "clipping/cohen_sutherland_3d/cohen_sutherland_3d_batch.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

// Highway compiles what follows once for every kind of machine, and picks at run time
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "clipping/cohen_sutherland_3d/cohen_sutherland_3d_batch.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// After it
#include <hwy/highway.h>

#include "core/arithmetic/certified_lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace gradus::cohen_sutherland_3d::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using namespace lanes::HWY_NAMESPACE;
using Space = Segment<3, double>;

constexpr double largest = 0x1p300;

// --- Lines in registers ------------------------------------------------------------------------------------

// Both ends of some lines
struct Lanes {
  Pair x, y, z;
};

// Registers hold the points of a line one after the other. The ends are told apart within blocks of two, so
// that even lanes hold the first half of the lines, odd lanes the second
HWY_INLINE std::size_t line_of(std::size_t lane) { return lane / 2 + lane % 2 * (hn::Lanes(D()) / 2); }

#if HWY_TARGET == HWY_SCALAR
HWY_INLINE Lanes load(const Space* lines) {
  const D d;
  const auto of = [&](int i) { return Pair{hn::LoadU(d, &lines->a[i]), hn::LoadU(d, &lines->b[i])}; };
  return {of(0), of(1), of(2)};
}
HWY_INLINE void store(const Lanes& p, Space* lines) {
  const D d;
  hn::StoreInterleaved3(p.x.a, p.y.a, p.z.a, d, &lines->a.x);
  hn::StoreInterleaved3(p.x.b, p.y.b, p.z.b, d, &lines->b.x);
}
#else
HWY_INLINE Pair ends_of(V first, V second) {
  const D d;
  return {hn::InterleaveLower(d, first, second), hn::InterleaveUpper(d, first, second)};
}
HWY_INLINE Lanes load(const Space* lines) {
  const D d;
  const double* const first = &lines->a.x;
  V x, y, z, u, v, w;
  hn::LoadInterleaved3(d, first, x, y, z);
  hn::LoadInterleaved3(d, first + 3 * hn::Lanes(d), u, v, w);
  return {ends_of(x, u), ends_of(y, v), ends_of(z, w)};
}
HWY_INLINE void store(const Lanes& p, Space* lines) {
  const D d;
  double* const first = &lines->a.x;
  const Pair x = ends_of(p.x.a, p.x.b), y = ends_of(p.y.a, p.y.b), z = ends_of(p.z.a, p.z.b);
  hn::StoreInterleaved3(x.a, y.a, z.a, d, first);
  hn::StoreInterleaved3(x.b, y.b, z.b, d, first + 3 * hn::Lanes(d));
}
#endif

// The lines as they are; `to` may be `from`
HWY_INLINE void copy(const Space* from, Space* to) {
  const D d;
  const double* const source = &from->a.x;
  double* const target = &to->a.x;
  for (std::size_t i = 0; i < 6; ++i) {
    hn::StoreU(hn::LoadU(d, source + i * hn::Lanes(d)), d, target + i * hn::Lanes(d));
  }
}

// --- Cuts -------------------------------------------------------------------------------------------------

// One coordinate of both ends, how large both are together, the faces across it, and beyond which of them the
// ends lie
struct Axis {
  Pair at;
  V size, lower, upper;
  PairMask below, above, beyond;
};

HWY_INLINE Axis axis(Pair at, double lower, double upper) {
  // + 0.0 as in coordinate(): of the two zeros +0
  const V low = hn::Set(D(), lower + 0.0), high = hn::Set(D(), upper + 0.0);
  const PairMask below = greater(both(low), at), above = greater(at, both(high));
  return {at,
          hn::Add(hn::Abs(at.a), hn::Abs(at.b)),
          low,
          high,
          below,
          above,
          {hn::Or(below.a, above.a), hn::Or(below.b, above.b)}};
}

// Whether both ends lie beyond the same face
HWY_INLINE M rejects(const Axis& x) {
  return hn::Or(hn::And(x.below.a, x.below.b), hn::And(x.above.a, x.above.b));
}

// The face of an axis that an end may be cut at: how far away, and how long the line is along the axis
struct Candidate {
  PairMask beyond;
  Pair face, way, length;
};

HWY_INLINE Candidate candidate(const Axis& x, const Difference& length) {
  const Pair face = choose(x.below, both(x.lower), both(x.upper));
  return {x.beyond, face, size_of(subtract(face, x.at)), both(hn::Abs(length.value))};
}

struct Later {
  PairMask second, unsure;
};

// Beyond two faces: the later one is where the way in, divided by the length, is longer
HWY_INLINE Later later(const Candidate& first, const Candidate& second) {
  const Pair by_first = multiply(first.way, second.length), by_second = multiply(second.way, first.length);
  const Pair bound =
      multiply_add(add(by_first, by_second), both(hn::Set(D(), 0x1p-51)), both(hn::Set(D(), 0x1p-1000)));
  const PairMask ordered = greater(size_of(subtract(by_first, by_second)), bound);
  const PairMask first_is_later = but_not(first.beyond, but_not(second.beyond, greater(by_first, by_second)));
  return {but_not(second.beyond, first_is_later), but_not(first.beyond & second.beyond, ordered)};
}

HWY_INLINE Candidate one_of(const Candidate& first, const Candidate& second, PairMask is_second) {
  return {{hn::Or(first.beyond.a, second.beyond.a), hn::Or(first.beyond.b, second.beyond.b)},
          choose(is_second, second.face, first.face),
          choose(is_second, second.way, first.way),
          choose(is_second, second.length, first.length)};
}

HWY_INLINE Differences choose(PairMask m, const Differences& yes, const Differences& no) {
  return {choose(m, yes.value, no.value), choose(m, yes.error, no.error)};
}

// A coordinate that a cut computes, x or y, and where a lies there: surely between the faces, or surely
// beyond one
struct Other {
  Pair value;
  PairMask sure;
  M inside, beside;
};

HWY_INLINE Other other(const Differences& way, const Differences& length, const Axis& x, const Difference& dx,
                       const Axis& y, const Difference& dy, PairMask of_x) {
  const Pair base = choose(of_x, x.at, y.at);
  const Differences rise = choose(of_x, dx, dy);
  const Pair size = choose(of_x, both(x.size), both(y.size));
  const Sums sum = nearest_sum(base, way, rise, length, add(size, both(hn::Set(D(), 0x1p-900))));
  // Along the face every point is as good as the ends, and -0 becomes 0
  const Pair zero = both(hn::Zero(D()));
  const PairMask level = equal(rise.value, zero);
  const Pair value = choose(level, add(base, zero), sum.value);
  // A point that was rounded onto a face may lie beyond it
  const V lower = hn::IfThenElse(of_x.a, x.lower, y.lower), upper = hn::IfThenElse(of_x.a, x.upper, y.upper);
  const M between = hn::And(hn::Gt(value.a, lower), hn::Lt(value.a, upper));
  return {value,
          {hn::Or(sum.sure.a, level.a), hn::Or(sum.sure.b, level.b)},
          hn::Or(level.a, between),
          hn::Or(hn::Lt(value.a, lower), hn::Gt(value.a, upper))};
}

// Each end cut at the face that the line comes to last on its way in
struct Cuts {
  Lanes at;
  PairMask sure;
  M inside, beside;  // of a
};

HWY_INLINE Cuts cut_ends(const Axis& x, const Axis& y, const Axis& z) {
  const Difference dx = difference(x.at.b, x.at.a), dy = difference(y.at.b, y.at.a),
                   dz = difference(z.at.b, z.at.a);
  const Candidate of_x = candidate(x, dx), of_y = candidate(y, dy), of_z = candidate(z, dz);
  const Later y_or_x = later(of_x, of_y);
  const Candidate of_xy = one_of(of_x, of_y, y_or_x.second);
  const Later z_or_xy = later(of_xy, of_z);
  const PairMask at_z = z_or_xy.second, at_y = but_not(y_or_x.second, at_z);
  const PairMask not_x{hn::Or(at_y.a, at_z.a), hn::Or(at_y.b, at_z.b)};

  // The axis of the cut, and the two others in their order
  const Pair c = choose(at_z, of_z.face, of_xy.face);
  const Pair along = choose(at_z, z.at, choose(at_y, y.at, x.at));
  const Differences length = choose(at_z, {both(dz.value), both(dz.error)}, choose(at_y, dy, dx));
  const Differences way = difference(c, along);
  const Other first = other(way, length, x, dx, y, dy, not_x);
  const Other second = other(way, length, y, dy, z, dz, at_z);
  const PairMask sure = but_not(but_not(first.sure & second.sure, y_or_x.unsure), z_or_xy.unsure);
  return {{choose(not_x, first.value, c), choose(at_z, second.value, choose(at_y, c, first.value)),
           choose(at_z, c, second.value)},
          sure,
          hn::And(first.inside, second.inside),
          hn::Or(first.beside, second.beside)};
}

// What is left of the lines p, in place, and of which something is left; returns where that is certain
HWY_INLINE M cut_lanes(Lanes& p, const Axis& x, const Axis& y, const Axis& z, PairMask outside, M rejected,
                       M& accepted) {
  const M undecided = hn::AndNot(rejected, hn::Or(outside.a, outside.b));
  // Each end that is outside is cut once
  const Cuts cut = cut_ends(x, y, z);

  // With both ends outside the line may pass an edge: it is in the box where the point of a lies there
  const M two = hn::And(outside.a, outside.b);
  const M missed = hn::And(hn::And(undecided, two), cut.beside);
  accepted = hn::Not(hn::Or(rejected, missed));
  const M a_unsure =
      hn::Or(hn::AndNot(cut.sure.a, outside.a), hn::AndNot(hn::Or(cut.inside, cut.beside), two));
  const M b_unsure = hn::AndNot(hn::Or(cut.sure.b, missed), outside.b);

  const PairMask moved = PairMask{accepted, accepted} & outside;
  p.x = choose(moved, cut.at.x, p.x);
  p.y = choose(moved, cut.at.y, p.y);
  p.z = choose(moved, cut.at.z, p.z);
  return hn::Not(hn::And(undecided, hn::Or(a_unsure, b_unsure)));
}

// --- Loops ------------------------------------------------------------------------------------------------

// Lines that are not certain, one by one, from what stands in `lines`, which `clipped` may be; returns for
// which lanes something is left
HWY_NOINLINE std::uint64_t clip_unsure(const Space* lines, const AxisBox<3, double>& box, std::uint64_t sure,
                                       std::uint64_t accepted, const Lanes& found, Space* clipped) {
  const std::size_t count = hn::Lanes(D());
  std::array<Space, HWY_MAX_BYTES / sizeof(double)> before;
  std::copy_n(lines, count, before.begin());
  store(found, clipped);
  for (std::size_t lane = 0; lane < count; ++lane) {
    if (sure >> lane & 1) continue;
    const std::size_t i = line_of(lane);
    const std::optional<Space> line = correctly_rounded(before[i], box);
    clipped[i] = line ? *line : before[i];
    accepted = (accepted & ~(std::uint64_t{1} << lane)) | std::uint64_t{line.has_value()} << lane;
  }
  return accepted;
}

// As many lines as go together, from `lines` on; returns for which lanes something is left
HWY_INLINE std::uint64_t clip_some(const Space* lines, const AxisBox<3, double>& box, Space* clipped) {
  const D d;
  Lanes p = load(lines);
  const Axis x = axis(p.x, box.lower.x, box.upper.x), y = axis(p.y, box.lower.y, box.upper.y),
             z = axis(p.z, box.lower.z, box.upper.z);
  const M rejected = hn::Or(hn::Or(rejects(x), rejects(y)), rejects(z));
  const PairMask outside{hn::Or(hn::Or(x.beyond.a, y.beyond.a), z.beyond.a),
                         hn::Or(hn::Or(x.beyond.b, y.beyond.b), z.beyond.b)};
  // A coordinate that is not a number makes the sum none either
  const V size = hn::Add(hn::Add(x.size, y.size), z.size);
  M sure = hn::Le(size, hn::Set(d, largest));
  M accepted = hn::Not(rejected);
  if (hn::AllFalse(d, hn::AndNot(rejected, hn::Or(outside.a, outside.b)))) {
    if (hn::AllTrue(d, sure)) {
      copy(lines, clipped);
      return bits_of(accepted);
    }
  } else {
    sure = hn::And(sure, cut_lanes(p, x, y, z, outside, rejected, accepted));
  }
  if (!hn::AllTrue(d, sure)) return clip_unsure(lines, box, bits_of(sure), bits_of(accepted), p, clipped);
  store(p, clipped);
  return bits_of(accepted);
}

// Returns how many lines were done, all but the last few, and counts those of which something is left
std::size_t clip_most(const Space* lines, std::size_t size, const AxisBox<3, double>& box, Space* clipped,
                      std::uint8_t* accepted, std::size_t& kept) {
  const std::size_t count = hn::Lanes(D());
  std::size_t i = 0;
  for (; i + count <= size; i += count) {
    const std::uint64_t bits = clip_some(lines + i, box, clipped + i);
    for (std::size_t lane = 0; lane < count; ++lane) {
      accepted[i + line_of(lane)] = static_cast<std::uint8_t>(bits >> lane & 1);
    }
    kept += static_cast<std::size_t>(std::popcount(bits));
  }
  return i;
}

}  // namespace gradus::cohen_sutherland_3d::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gradus::cohen_sutherland_3d {

HWY_EXPORT(clip_most);

std::size_t clip_batch(std::span<const Segment<3, double>> lines, const AxisBox<3, double>& box,
                       std::span<Segment<3, double>> clipped, std::span<std::uint8_t> accepted) {
  static_assert(sizeof(Segment<3, double>) == 6 * sizeof(double));
  expects(clipped.size() == lines.size() && accepted.size() == lines.size(),
          "{} lines, but room for {} and for {} answers", lines.size(), clipped.size(), accepted.size());
  expect_clippable(Segment<3, double>{box.lower, box.upper}, box);
  // Without lines in range the faces need not be either
  double size = 0;
  for (const Border face : usual_order<3>()) size = std::max(size, std::abs(coordinate(box, face)));
  std::size_t kept = 0, i = 0;
  if (size <= 0x1p300) {
    i = HWY_DYNAMIC_DISPATCH(clip_most)(lines.data(), lines.size(), box, clipped.data(), accepted.data(),
                                        kept);
  }
  // The last few, or all
  for (; i < lines.size(); ++i) {
    const std::optional<Segment<3, double>> line = correctly_rounded(lines[i], box);
    clipped[i] = line ? *line : lines[i];
    accepted[i] = line.has_value();
    kept += line.has_value();
  }
  return kept;
}

}  // namespace gradus::cohen_sutherland_3d
#endif
