// Whole polygons in bytes: exact areas against what Cairo, AGG and FreeType fill, on the same shapes, whose
// corners lie on FreeType's grid of 1/64 pixel so that no library has to move them.

#include <cairo.h>
#include <fmt/format.h>
#include <ft2build.h>

#include <memory>
#include <numbers>
#include <vector>

#include "antialiasing/area_sampling/area_sampling_batch.hpp"
#include "benchmark/scan_conversion/peers.hpp"
#include "benchmark/subject.hpp"
#include "core/random.hpp"

#include FT_OUTLINE_H

#ifdef GRADUS_HAS_AGG
#include <agg_rasterizer_scanline_aa.h>
#include <agg_renderer_scanline.h>
#include <agg_scanline_p.h>
#endif

namespace gradus::bench {
namespace {

using area_sampling::AreaScan;
using Canvas = Raster<std::uint8_t>;
using Ring = std::vector<ivec2>;  ///< in 1/256 pixel, multiples of 4

constexpr int side = 1024;

/// Shapes in cells of their own, so that none is drawn over another.
struct Shapes {
  std::vector<Ring> rings;
  Raster<double> right{side, side};  ///< 255 times the area that is covered
  std::int64_t pixels = 0;           ///< of which something is covered
};

/// A place on FreeType's grid.
ivec2 on_grid(dvec2 place) { return 4 * ivec2(glm::floor(place * 64.0 + 0.5)); }

/// A ring round the middle of a cell. radius(corner) in pixels.
template <class Radius>
Ring round(dvec2 middle, int corners, Radius radius) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.13) / corners;
    ring.push_back(on_grid(middle + radius(i) * dvec2(std::cos(angle), std::sin(angle))));
  }
  return ring;
}

using Part = std::vector<glm::dvec2>;

/// What of a ring lies on one side of an upright or level line.
Part cut(const Part& ring, int axis, double limit, double sign) {
  Part kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec2 from = ring[i], to = ring[i + 1 < ring.size() ? i + 1 : 0];
    const double before = sign * (from[axis] - limit), after = sign * (to[axis] - limit);
    if (before >= 0) kept.push_back(from);
    if ((before >= 0) != (after >= 0)) kept.push_back(from + (to - from) * (before / (before - after)));
  }
  return kept;
}

double area_of(const Part& ring, dvec2 origin) {
  double doubled = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const dvec2 from = ring[i] - origin, to = ring[i + 1 < ring.size() ? i + 1 : 0] - origin;
    doubled += from.x * to.y - from.y * to.x;
  }
  return std::abs(doubled) / 2;
}

/// The areas, by cutting the ring to each row and each pixel of it.
void add_right(Shapes& shapes, const Ring& ring) {
  Part whole;
  for (const ivec2 p : ring) whole.push_back(dvec2(p) / 256.0);
  dvec2 lower(side), upper(0);
  for (const dvec2& p : whole) lower = glm::min(lower, p), upper = glm::max(upper, p);
  const ivec2 first(lower), last(upper);
  for (int y = first.y; y <= std::min(last.y, side - 1); ++y) {
    const Part row = cut(cut(whole, 1, y, 1), 1, y + 1, -1);
    for (int x = first.x; x <= std::min(last.x, side - 1); ++x) {
      const double area = area_of(cut(cut(row, 0, x, 1), 0, x + 1, -1), dvec2(x, y));
      if (area > 0) ++shapes.pixels;
      shapes.right[ivec2(x, y)] = 255 * area;
    }
  }
  shapes.rings.push_back(ring);
}

/// One shape in each cell of so many pixels.
template <class Make>
std::shared_ptr<const Shapes> shapes_of(int cell, Make make) {
  auto shapes = std::make_shared<Shapes>();
  Random random(23);
  for (int y = 0; y < side / cell; ++y) {
    for (int x = 0; x < side / cell; ++x)
      add_right(*shapes, make(random, dvec2(x + 0.5, y + 0.5) * double(cell)));
  }
  return shapes;
}

/// Random triangles that may be thin.
std::shared_ptr<const Shapes> triangles() {
  return shapes_of(64, [](Random& random, dvec2 middle) {
    Ring ring;
    for (int i = 0; i < 3; ++i)
      ring.push_back(on_grid(middle + dvec2{random.uniform(-31, 31), random.uniform(-31, 31)}));
    return ring;
  });
}
/// As large as letters, with some twenty corners.
std::shared_ptr<const Shapes> letters() {
  return shapes_of(32, [](Random& random, dvec2 middle) {
    return round(middle, 22, [&](int i) { return (i % 2 == 0 ? 14.0 : 7.0) * random.uniform(0.7, 1.0); });
  });
}
std::shared_ptr<const Shapes> spikes() {
  return shapes_of(256, [](Random&, dvec2 middle) {
    return round(middle, 240, [](int i) { return i % 2 == 0 ? 125.0 : 40.0; });
  });
}
std::shared_ptr<const Shapes> boxes() {
  return shapes_of(64, [](Random& random, dvec2 middle) {
    const ivec2 a = on_grid(middle - dvec2{random.uniform(1, 31), random.uniform(1, 31)}),
                b = on_grid(middle + dvec2{random.uniform(1, 31), random.uniform(1, 31)});
    return Ring{a, {b.x, a.y}, b, {a.x, b.y}};
  });
}
std::shared_ptr<const Shapes> discs(int radius) {
  return shapes_of(2 * radius + 2, [radius](Random&, dvec2 middle) {
    return round(middle, std::max(16, 2 * radius), [=](int) { return radius + 0.3; });
  });
}

// --- The libraries -------------------------------------------------------------------------------------

/// Cairo fills a path on a surface of alphas.
class CairoFill {
 public:
  explicit CairoFill(Canvas& canvas)
      : surface_(
            cairo_image_surface_create_for_data(canvas.cells().data(), CAIRO_FORMAT_A8, side, side, side)),
        context_(cairo_create(surface_.get())) {}
  void operator()(const Ring& ring) {
    for (const ivec2 p : ring) cairo_line_to(context_.get(), p.x / 256.0, p.y / 256.0);
    cairo_close_path(context_.get());
    cairo_fill(context_.get());
  }

 private:
  std::unique_ptr<cairo_surface_t, peers::With<cairo_surface_destroy>> surface_;
  std::unique_ptr<cairo_t, peers::With<cairo_destroy>> context_;
};

/// FreeType's smooth rasterizer, which letters go through.
class FreeTypeFill {
 public:
  explicit FreeTypeFill(Canvas& canvas) {
    FT_Init_FreeType(&library_);
    bitmap_.rows = bitmap_.width = side;
    bitmap_.pitch = -side;  // y up: the first row in memory is the lowest
    bitmap_.buffer = canvas.cells().data();
    bitmap_.num_grays = 256;
    bitmap_.pixel_mode = FT_PIXEL_MODE_GRAY;
  }
  ~FreeTypeFill() { FT_Done_FreeType(library_); }
  FreeTypeFill(const FreeTypeFill&) = delete;
  FreeTypeFill& operator=(const FreeTypeFill&) = delete;

  void operator()(const Ring& ring) {
    points_.clear();
    for (const ivec2 p : ring) points_.push_back({p.x / 4, p.y / 4});
    tags_.assign(points_.size(), FT_CURVE_TAG_ON);
    short last = static_cast<short>(points_.size() - 1);
    FT_Outline outline{1, static_cast<short>(points_.size()), points_.data(), tags_.data(), &last, 0};
    FT_Outline_Get_Bitmap(library_, &outline, &bitmap_);
  }

 private:
  FT_Library library_ = nullptr;
  FT_Bitmap bitmap_{};
  std::vector<FT_Vector> points_;
  std::vector<char> tags_;
};

#ifdef GRADUS_HAS_AGG
class AggFill {
 public:
  explicit AggFill(Canvas& canvas) : buffer_(canvas.cells().data(), side, side, side) {}
  AggFill(const AggFill&) = delete;
  AggFill& operator=(const AggFill&) = delete;

  void operator()(const Ring& ring) {
    rasterizer_.reset();
    rasterizer_.move_to(ring[0].x, ring[0].y);
    for (std::size_t i = 1; i < ring.size(); ++i) rasterizer_.line_to(ring[i].x, ring[i].y);
    agg::render_scanlines_aa_solid(rasterizer_, scanline_, base_, agg::gray8(255));
  }

 private:
  agg::rendering_buffer buffer_;
  agg::pixfmt_gray8 pixels_{buffer_};
  agg::renderer_base<agg::pixfmt_gray8> base_{pixels_};
  agg::rasterizer_scanline_aa<> rasterizer_;
  agg::scanline_p8 scanline_;
};
#endif

class ExactFill {
 public:
  explicit ExactFill(Canvas& canvas) : canvas_(canvas) {}
  void operator()(const Ring& ring) { scan_.draw(canvas_, AreaScan::Ring(ring)); }

 private:
  Canvas& canvas_;
  AreaScan scan_;
};

/// Against the areas: in steps of a byte, over all pixels that edges cross. Wrong is a byte that is not the
/// nearest.
Error error_of(const Canvas& canvas, const Shapes& shapes) {
  Error::Sum sum;
  for (std::size_t i = 0; i < canvas.cells().size(); ++i) {
    const double right = shapes.right.cells()[i], off = canvas.cells()[i] - right;
    const bool crossed = right > 1e-9 && right < 255 - 1e-9;
    if (crossed) sum.add(off);
    if (std::abs(off) > 0.5 + 1e-9) sum.wrong_decision();
  }
  return sum.error();
}

template <class Fill>
Case case_of(const char* name, Standing standing, const std::shared_ptr<const Shapes>& shapes,
             const Workload& workload) {
  struct Drawn {
    Canvas canvas{side, side};
    Fill fill{canvas};
  };
  const auto drawn = std::make_shared<Drawn>();
  const auto run = [=] {
    for (const Ring& ring : shapes->rings) drawn->fill(ring);
  };
  run();
  return {.method = name,
          .standing = standing,
          .workload = workload,
          .items = shapes->pixels,
          .run = run,
          .prepare = [drawn] { std::ranges::fill(drawn->canvas.cells(), std::uint8_t{0}); },
          .error = error_of(drawn->canvas, *shapes)};
}

void add_cases(std::vector<Case>& all, const Workload& workload,
               const std::shared_ptr<const Shapes>& shapes) {
  all.push_back(case_of<ExactFill>("AreaScan", Standing::batch, shapes, workload));
  all.push_back(case_of<CairoFill>("Cairo", Standing::peer, shapes, workload));
  all.push_back(case_of<FreeTypeFill>("FreeType", Standing::peer, shapes, workload));
#ifdef GRADUS_HAS_AGG
  all.push_back(case_of<AggFill>("AGG", Standing::peer, shapes, workload));
#endif
}

std::vector<Case> cases() {
  std::vector<Case> all;
  add_cases(all, {"letters"}, letters());
  add_cases(all, {"triangles"}, triangles());
  add_cases(all, {"spikes"}, spikes());
  add_cases(all, {"boxes"}, boxes());
  for (const int radius : {3, 15, 63, 255}) {
    add_cases(all, {fmt::format("discs of radius {}", radius), static_cast<double>(radius)}, discs(radius));
  }
  return all;
}

}  // namespace

Subject exact_areas() {
  return {.topic = "exact_areas",
          .title = "Areas of whole polygons, in bytes",
          .item = "pixel",
          .unit = "steps of a byte",
          .measure = "radius in pixels",
          .telling = "letters",
          .cases = cases,
          .choice = {"AreaScan", "every byte the nearest one, in the least time"}};
}

}  // namespace gradus::bench
