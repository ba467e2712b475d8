#include "engine/describe_batch.hpp"

#include <bit>

// Highway compiles what follows once for every kind of machine, and picks at run time
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/describe_batch.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
// After it
#include <hwy/highway.h>

#include "engine/mask_bits-inl.hpp"
#include "engine/phong_lanes-inl.hpp"
#include "engine/shading_lanes-inl.hpp"
#include "scan_conversion/triangle_coverage/triangle_coverage.hpp"

HWY_BEFORE_NAMESPACE();
namespace gradus::pipeline::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Numbers in double precision, and as many in single precision and whole ones
using Wide = hn::CappedTag<double, block_cells>;
using WideSingle = hn::Rebind<float, Wide>;
using WideWhole = hn::Rebind<std::int32_t, Wide>;
using W = hn::Vec<Wide>;

template <class T>
using Lanes = SeenTriangles::Lanes<T>;

HWY_INLINE W wide(double x) { return hn::Set(Wide(), x); }
HWY_INLINE W load(const Lanes<double>& from, std::size_t i) { return hn::Load(Wide(), from.data() + i); }
HWY_INLINE W load(const Lanes<std::int32_t>& from, std::size_t i) {
  return hn::PromoteTo(Wide(), hn::Load(WideWhole(), from.data() + i));
}
HWY_INLINE W load(const Lanes<float>& from, std::size_t i) {
  return hn::PromoteTo(Wide(), hn::Load(WideSingle(), from.data() + i));
}
HWY_INLINE void store(W x, Lanes<double>& to, std::size_t i) { hn::Store(x, Wide(), to.data() + i); }
HWY_INLINE void store(W x, Lanes<float>& to, std::size_t i) {
  hn::Store(hn::DemoteTo(WideSingle(), x), WideSingle(), to.data() + i);
}

struct Wide3 {
  W x, y, z;
};
HWY_INLINE Wide3 load(const std::array<Lanes<double>, 3>& from, std::size_t i) {
  return {load(from[0], i), load(from[1], i), load(from[2], i)};
}
HWY_INLINE W dot(const Wide3& a, const Wide3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

// A value at the three corners of triangles
struct AtCorners {
  W first, second, third;
};
HWY_INLINE AtCorners times(const AtCorners& a, const AtCorners& b) {
  return {hn::Mul(a.first, b.first), hn::Mul(a.second, b.second), hn::Mul(a.third, b.third)};
}

// Shares of the second and the third corner: in the pixel that planes count from, and what a column and a row
// add. And 1 / w at the corners, at most 1
struct alignas(64) CornerShares {
  Lanes<double> there[2], across[2], down[2], over_w[3];
};

class Description {
 public:
  Description(const FrameShading& shading, const AskedPixels& asked, SeenTriangles& seen,
              RecordBlock& records)
      : shading_(shading), asked_(asked), seen_(seen), records_(records) {}

  std::uint32_t make() {
    for_each_kind(seen_.object, [&](std::int32_t object) {
      if (object != SeenTriangles::cut) place(object);
    });
    for_some([&](std::size_t i) { begin_planes(i); });
    const Shading how = shading_.scene().shading;
    if (how == Shading::phong) for_some([&](std::size_t i) { put_places_and_normals(i); });
    if (how == Shading::gouraud) light_corners();
    if (how == Shading::flat) for_some([&](std::size_t i) { put_face_light(i); });
    for_each_kind(seen_.group, [&](std::int32_t group) { put_texture(group); });
    return careful_ & ((1U << seen_.count) - 1);
  }

 private:
  /// Calls visit(i) where registers begin.
  template <class Visit>
  HWY_INLINE void for_some(const Visit& visit) const {
    for (std::size_t i = 0; i < seen_.count; i += hn::Lanes(Wide())) visit(i);
  }

  /// Calls visit for each number that some triangle has.
  template <class Visit>
  HWY_INLINE void for_each_kind(const Lanes<std::int32_t>& kinds, const Visit& visit) const {
    for (std::uint32_t left = (1U << seen_.count) - 1; left != 0;) {
      const std::int32_t kind = kinds[static_cast<std::size_t>(std::countr_zero(left))];
      for (std::size_t i = 0; i < block_cells; i += hn::Lanes(DI()))
        left &= ~(bits_of(DI(), hn::Eq(hn::Load(DI(), kinds.data() + i), whole(kind))) << i);
      visit(kind);
    }
  }

  // --- Corners -----------------------------------------------------------------------------------

  /// The corners of an object's triangles, from the eye in the world, and their normals.
  void place(std::int32_t number) {
    const FrameObject& object = shading_.frame().objects[static_cast<std::size_t>(number)];
    const glm::dmat4& to_world = object_at(shading_.scene(), object.number).placement;
    glm::dmat4x3 to_eye(to_world);
    to_eye[3] -= shading_.scene().camera.frame.eye;
    for_some([&](std::size_t i) {
      const auto own = hn::Eq(load(seen_.object, i), wide(number));
      for (std::size_t k = 0; k < 3; ++k) {
        turn(to_eye, seen_.places[k], own, i);
        turn(glm::dmat4x3(object.normal_matrix), seen_.normals[k], own, i);
        make_unit(seen_.normals[k], own, i);
      }
    });
  }

  HWY_INLINE static void turn(const glm::dmat4x3& by, std::array<Lanes<double>, 3>& points,
                              hn::Mask<Wide> own, std::size_t i) {
    const Wide3 p = load(points, i);
    for (int axis = 0; axis < 3; ++axis) {
      const auto along = [&](W x, int column) { return hn::Mul(x, wide(by[column][axis])); };
      const W turned =
          hn::Add(hn::Add(along(p.x, 0), along(p.y, 1)), hn::Add(along(p.z, 2), wide(by[3][axis])));
      store_own(turned, own, Wide(), points[static_cast<std::size_t>(axis)].data() + i);
    }
  }

  /// Normals of length 1, on the viewer's side.
  HWY_INLINE void make_unit(std::array<Lanes<double>, 3>& normals, hn::Mask<Wide> own, std::size_t i) {
    const Wide3 n = load(normals, i);
    const W square = dot(n, n), side = load(seen_.side, i);
    const auto fits = hn::And(hn::Gt(square, wide(1e-200)), hn::Lt(square, wide(1e200)));
    const W by = hn::IfThenElse(fits, hn::Div(side, hn::Sqrt(square)), side);
    store_own(hn::Mul(n.x, by), own, Wide(), normals[0].data() + i);
    store_own(hn::Mul(n.y, by), own, Wide(), normals[1].data() + i);
    store_own(hn::Mul(n.z, by), own, Wide(), normals[2].data() + i);
    for_each_bit(bits_of(Wide(), hn::AndNot(fits, own)),
                 [&](int lane) { make_unit_with_care(normals, i + static_cast<std::size_t>(lane)); });
  }

  /// Where squares leave the range of numbers, or are zero.
  static void make_unit_with_care(std::array<Lanes<double>, 3>& normals, std::size_t lane) {
    const dvec3 unit = unit_vector(dvec3{normals[0][lane], normals[1][lane], normals[2][lane]});
    for (std::size_t axis = 0; axis < 3; ++axis) normals[axis][lane] = unit[static_cast<int>(axis)];
  }

  // --- Planes ------------------------------------------------------------------------------------

  /// What a side of a triangle adds in a pixel, and from column to column and from row to row.
  struct WideSide {
    W x, y, dx, dy;

    HWY_INLINE W at(W px, W py) const {
      return hn::Sub(hn::Mul(dx, hn::Sub(py, y)), hn::Mul(dy, hn::Sub(px, x)));
    }
  };
  HWY_INLINE WideSide side(std::size_t from, std::size_t to, std::size_t i) const {
    const W x = load(seen_.grid[from][0], i), y = load(seen_.grid[from][1], i);
    return {x, y, hn::Sub(load(seen_.grid[to][0], i), x), hn::Sub(load(seen_.grid[to][1], i), y)};
  }

  /// The least and the largest pixel of the box on an axis.
  struct WideRange {
    W first, last;
  };
  HWY_INLINE WideRange range(std::size_t axis, std::size_t i) const {
    const WideWhole d;
    constexpr int half = triangle_coverage::subpixels / 2;
    const auto at = [&](std::size_t k) { return hn::Load(d, seen_.grid[k][axis].data() + i); };
    const auto a = at(0), b = at(1), c = at(2);
    const auto least = hn::Min(hn::Min(a, b), c), most = hn::Max(hn::Max(a, b), c);
    const auto first = asked_.squares ? least : hn::Add(least, hn::Set(d, half - 1)),
               last = asked_.squares ? most : hn::Sub(most, hn::Set(d, half));
    const int along = static_cast<int>(axis);
    return {hn::PromoteTo(Wide(), hn::Max(hn::ShiftRight<8>(first), hn::Set(d, asked_.square.lower[along]))),
            hn::PromoteTo(Wide(), hn::Min(hn::ShiftRight<8>(last), hn::Set(d, asked_.square.upper[along])))};
  }

  /// 1 / w up to a factor, at most 1.
  HWY_INLINE AtCorners over_w(std::size_t i) const {
    if (shading_.scene().camera.rays) return {wide(1), wide(1), wide(1)};
    const dvec3& forward = shading_.scene().camera.frame.forward;
    const Wide3 ahead{wide(forward.x), wide(forward.y), wide(forward.z)};
    const W a = dot(ahead, load(seen_.places[0], i)), b = dot(ahead, load(seen_.places[1], i)),
            c = dot(ahead, load(seen_.places[2], i)), nearest = hn::Min(hn::Min(a, b), c);
    return {hn::Div(nearest, a), hn::Div(nearest, b), hn::Div(nearest, c)};
  }

  /// Where planes count from, and the plane of 1 / w.
  HWY_INLINE void begin_planes(std::size_t i) {
    constexpr double step = triangle_coverage::subpixels, most_change = 16;
    const WideSide sides[]{side(2, 0, i), side(0, 1, i)};
    // Twice the area: what the last side has in the third corner. Both signs turn with it
    const W over_area = hn::Div(wide(1), sides[1].at(load(seen_.grid[2][0], i), load(seen_.grid[2][1], i)));
    const WideRange columns = range(0, i), rows = range(1, i);
    const W width = hn::Sub(columns.last, columns.first), height = hn::Sub(rows.last, rows.first);
    const AtCorners q = over_w(i);
    store(q.first, shares_.over_w[0], i);
    store(q.second, shares_.over_w[1], i);
    store(q.third, shares_.over_w[2], i);
    auto thin = hn::Lt(wide(1), wide(0));
    W right = wide(0), below = wide(0);
    for (std::size_t k = 0; k < 2; ++k) {
      const W across = hn::Mul(hn::Mul(sides[k].dy, wide(-step)), over_area),
              down = hn::Mul(hn::Mul(sides[k].dx, wide(step)), over_area),
              growth = hn::Sub(k == 0 ? q.second : q.third, q.first);
      store(across, shares_.across[k], i);
      store(down, shares_.down[k], i);
      const W change = hn::Add(hn::Mul(hn::Abs(across), width), hn::Mul(hn::Abs(down), height));
      thin = hn::Or(thin, hn::Gt(change, wide(most_change)));
      right = hn::Add(right, hn::Mul(growth, across));
      below = hn::Add(below, hn::Mul(growth, down));
    }
    careful_ |= bits_of(Wide(), thin) << i;
    const W column = hn::IfThenElse(hn::Gt(right, wide(0)), columns.last, columns.first),
            row = hn::IfThenElse(hn::Gt(below, wide(0)), rows.last, rows.first);
    const auto centre = [&](W pixel) { return hn::Add(hn::Mul(pixel, wide(step)), wide(step / 2)); };
    for (std::size_t k = 0; k < 2; ++k)
      store(hn::Mul(sides[k].at(centre(column), centre(row)), over_area), shares_.there[k], i);
    store(hn::Sub(column, wide(asked_.origin.x)), records_[record::column], i);
    store(hn::Sub(row, wide(asked_.origin.y)), records_[record::row], i);
    put(q, record::over_w, i);
  }

  HWY_INLINE AtCorners over_w_of(std::size_t i) const {
    return {load(shares_.over_w[0], i), load(shares_.over_w[1], i), load(shares_.over_w[2], i)};
  }
  HWY_INLINE static W mixed(const AtCorners& at, const Lanes<double> (&shares)[2], std::size_t i) {
    return hn::Add(hn::Mul(hn::Sub(at.second, at.first), load(shares[0], i)),
                   hn::Mul(hn::Sub(at.third, at.first), load(shares[1], i)));
  }
  /// A value in the pixel that planes count from.
  HWY_INLINE W there(const AtCorners& at, std::size_t i) const {
    return hn::Add(at.first, mixed(at, shares_.there, i));
  }
  /// Writes the plane of a value that is linear in the picture.
  HWY_INLINE void put(const AtCorners& at, int value, std::size_t i) {
    const auto place = static_cast<std::size_t>(value);
    store(there(at, i), records_[place], i);
    store(mixed(at, shares_.across, i), records_[place + 1], i);
    store(mixed(at, shares_.down, i), records_[place + 2], i);
  }

  /// For light in every pixel.
  HWY_INLINE void put_places_and_normals(std::size_t i) {
    const AtCorners q = over_w_of(i);
    for (int axis = 0; axis < 3; ++axis) {
      const auto of = [&](const SeenTriangles::Corners<double, 3>& corners) {
        const auto at = [&](std::size_t k) { return load(corners[k][static_cast<std::size_t>(axis)], i); };
        return times(q, {at(0), at(1), at(2)});
      };
      put(of(seen_.places), record::values + 3 * axis, i);
      put(of(seen_.normals), record::values + 9 + 3 * axis, i);
    }
  }

  /// For flat light.
  HWY_INLINE void put_face_light(std::size_t i) {
    const AtCorners q = over_w_of(i);
    for (std::size_t value = 0; value < 6; ++value) {
      const W light = load(seen_.face_light[value], i);
      put(times(q, {light, light, light}), record::values + 3 * static_cast<int>(value), i);
    }
  }

  // --- Light -------------------------------------------------------------------------------------

  /// Gouraud's: planes of the light of the corners.
  void light_corners() {
    make_single();
    bool highlights_apart = false, grey = true;
    for_each_kind(seen_.group, [&](std::int32_t number) {
      const ShadingGroup& group = shading_.groups()[static_cast<std::size_t>(number)];
      highlights_apart |= group.has_texture();
      grey = grey && group.grey;
      light_corners_of(group, number);
    });
    // Of grey light red alone is asked for
    const std::size_t step = grey ? 3 : 1;
    for_some([&](std::size_t i) {
      const AtCorners q = over_w_of(i);
      for (std::size_t value = 0; value < (highlights_apart ? 6U : 3U); value += step) {
        const auto at = [&](std::size_t k) { return load(light_[k][value], i); };
        put(times(q, {at(0), at(1), at(2)}), record::values + 3 * static_cast<int>(value), i);
      }
    });
  }

  HWY_INLINE void make_single() {
    for_some([&](std::size_t i) {
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          store(load(seen_.places[k][axis], i), places_[k][axis], i);
          store(load(seen_.normals[k][axis], i), normals_[k][axis], i);
        }
      }
    });
  }

  HWY_INLINE void light_corners_of(const ShadingGroup& group, std::int32_t number) {
    const D d;
    const bool parallel = shading_.towards() != glm::vec3(0);
    for (std::size_t i = 0; i < seen_.count; i += hn::Lanes(d)) {
      const M own = hn::RebindMask(d, hn::Eq(hn::Load(DI(), seen_.group.data() + i), whole(number)));
      const auto load3 = [&](const std::array<Lanes<float>, 3>& from) {
        const auto at = [&](std::size_t axis) { return hn::Load(d, from[axis].data() + i); };
        return Vec3{at(0), at(1), at(2)};
      };
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 place = load3(places_[k]);
        const Vec3 viewer = parallel ? set(shading_.towards()) : unit(minus(set(glm::vec3(0)), place));
        const Light3 light = lit(group, place, load3(normals_[k]), viewer);
        careful_ |= bits_of(d, hn::And(own, light.doubtful)) << i;
        put_light(group, light, own, light_[k], i);
      }
    }
  }

  /// Without a texture both are one.
  HWY_INLINE static void put_light(const ShadingGroup& group, const Light3& light, M own,
                                   std::array<Lanes<float>, 6>& into, std::size_t i) {
    const auto store = [&](std::size_t value, F scattered, F highlight) {
      const bool apart = group.has_texture();
      const F first = apart ? scattered : hn::Add(scattered, highlight), second = apart ? highlight : zero();
      store_own(first, own, D(), into[value].data() + i);
      store_own(second, own, D(), into[value + 3].data() + i);
    };
    store(0, light.scattered.x, light.highlight.x);
    store(1, light.scattered.y, light.highlight.y);
    store(2, light.scattered.z, light.highlight.z);
  }

  // --- Textures ----------------------------------------------------------------------------------

  /// Planes of texture coordinates, counted from a place nearby, of few binary digits.
  void put_texture(std::int32_t number) {
    const TextureLevels& texture = shading_.groups()[static_cast<std::size_t>(number)].texture;
    if (texture.levels == 0) return;
    for_some([&](std::size_t i) {
      const auto own = hn::Eq(load(seen_.group, i), wide(number));
      const W columns = put_texture_axis(0, texture.columns[0], own, i),
              rows = put_texture_axis(1, texture.rows[0], own, i);
      // Where there are levels, texels are as large as pixels, and so there are few of them in a tile
      if (texture.levels > 1) return;
      const auto near = hn::And(hn::Le(columns, wide(1024)), hn::Le(rows, wide(1024)));
      careful_ |= bits_of(Wide(), hn::AndNot(near, own)) << i;
    });
  }

  /// Returns how many texels the corners are away from that place, at most.
  HWY_INLINE W put_texture_axis(std::size_t axis, std::int32_t texels, hn::Mask<Wide> own, std::size_t i) {
    const AtCorners q = over_w_of(i);
    AtCorners at{load(seen_.texture[0][axis], i), load(seen_.texture[1][axis], i),
                 load(seen_.texture[2][axis], i)};
    const W here = hn::Div(there(times(q, at), i), there(q, i)), below = hn::Floor(here);
    const double digits = 0x1p23 / std::bit_ceil(static_cast<unsigned>(texels));
    const W base = hn::Mul(hn::Floor(hn::Mul(hn::Sub(here, below), wide(digits))), wide(1 / digits));
    const W from = hn::Add(below, base);
    at = {hn::Sub(at.first, from), hn::Sub(at.second, from), hn::Sub(at.third, from)};
    const auto place = static_cast<int>(axis);
    blend(base, own, records_[static_cast<std::size_t>(record::base + place)], i);
    const AtCorners planes = times(q, at);
    const auto first = static_cast<std::size_t>(record::texture + 3 * place);
    blend(there(planes, i), own, records_[first], i);
    blend(mixed(planes, shares_.across, i), own, records_[first + 1], i);
    blend(mixed(planes, shares_.down, i), own, records_[first + 2], i);
    const W farthest = hn::Max(hn::Max(hn::Abs(at.first), hn::Abs(at.second)), hn::Abs(at.third));
    return hn::Mul(farthest, wide(texels));
  }

  HWY_INLINE static void blend(W x, hn::Mask<Wide> own, Lanes<float>& to, std::size_t i) {
    store(hn::IfThenElse(own, x, load(to, i)), to, i);
  }

  const FrameShading& shading_;
  const AskedPixels& asked_;
  SeenTriangles& seen_;
  RecordBlock& records_;
  std::uint32_t careful_ = 0;
  CornerShares shares_;
  /// By corner: of those in single precision, for light, and their light.
  alignas(64) std::array<std::array<Lanes<float>, 3>, 3> places_, normals_;
  alignas(64) std::array<std::array<Lanes<float>, 6>, 3> light_;
};

std::uint32_t describe_some(const FrameShading& shading, const AskedPixels& asked, SeenTriangles& seen,
                            RecordBlock& records) {
  return Description(shading, asked, seen, records).make();
}

}  // namespace gradus::pipeline::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gradus::pipeline::engine {
HWY_EXPORT(describe_some);

std::uint32_t describe(const FrameShading& shading, const AskedPixels& asked, SeenTriangles& seen,
                       RecordBlock& records) {
  return HWY_DYNAMIC_DISPATCH(describe_some)(shading, asked, seen, records);
}

}  // namespace gradus::pipeline::engine
#endif
