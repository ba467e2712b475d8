#include "plot/pixel_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/colour.hpp"
#include "core/contract.hpp"
#include "figure/layout/layout.hpp"
#include "figure/text/metrics.hpp"
#include "figure/tone_of.hpp"

namespace gradus::plot {
namespace {

using layout::Pen;

// --- Pictures --------------------------------------------------------------------------------------

/// The mean of the light from one place to another, in cells.
Rgba8 mean_of(const Image& image, dvec2 from, dvec2 to) {
  dvec3 sum{0};
  double weight = 0;
  const ivec2 first(glm::floor(from)), last(glm::ceil(to));
  for (int y = first.y; y < std::min(last.y, image.height()); ++y) {
    for (int x = first.x; x < std::min(last.x, image.width()); ++x) {
      const dvec2 part = glm::min(dvec2(x + 1, y + 1), to) - glm::max(dvec2(x, y), from);
      sum += part.x * part.y * dvec3(linear_from_srgb8(image[{x, y}]));
      weight += part.x * part.y;
    }
  }
  return tone_of(sum / weight);
}

/// The picture, in fewer pixels where it is wider than that.
Image no_wider(const Image& image, int width) {
  if (image.width() <= width) return image;
  const double step = static_cast<double>(image.width()) / width;
  const int height = std::max(1, static_cast<int>(std::lround(image.height() / step)));
  Image small(width, height);
  const dvec2 cell{step, static_cast<double>(image.height()) / height};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      small[{x, y}] = mean_of(image, cell * dvec2(x, y), cell * dvec2(x + 1, y + 1));
  return small;
}

/// Some of its pixels.
Image part_of(const Image& image, const Window& window) {
  Image part(static_cast<int>(window.width()), static_cast<int>(window.height()));
  for (int y = 0; y < part.height(); ++y)
    for (int x = 0; x < part.width(); ++x) part[{x, y}] = image[window.lower + ivec2{x, y}];
  return part;
}

// --- The crop --------------------------------------------------------------------------------------

/// So many pixels either way round one, as far as the picture goes.
Window crop_round(const Image& image, ivec2 pixel, int side) {
  const ivec2 size{std::min(side, image.width()), std::min(side, image.height())};
  const ivec2 most = ivec2{image.width(), image.height()} - size;
  const ivec2 lower = glm::clamp(pixel - size / 2, ivec2{0}, most);
  return {lower, lower + size - 1};
}

Box box_of(const Window& window) {
  return {static_cast<double>(window.lower.x), static_cast<double>(window.lower.y),
          static_cast<double>(window.width()), static_cast<double>(window.height())};
}

int edges_in(const Cover& cover, const Box& box) {
  const auto& [a, b, c] = cover.corners;
  int count = 0;
  for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}})
    count += layout::clipped(from, to, box).has_value();
  return count;
}

/// The closest crop that shows most of the edges of the triangle that is seen.
Window crop_of(const PixelFigure& figure) {
  constexpr std::array<int, 4> sides{9, 13, 19, 27};
  Window best = crop_round(figure.picture, figure.pixel, sides.front());
  const auto seen = std::ranges::find(figure.covers, true, &Cover::seen);
  if (seen == figure.covers.end()) return best;
  for (const int side : sides) {
    const Window crop = crop_round(figure.picture, figure.pixel, side);
    if (edges_in(*seen, box_of(crop)) > edges_in(*seen, box_of(best))) best = crop;
  }
  return best;
}

// --- What is too much for a slide ------------------------------------------------------------------

constexpr std::size_t most_covers = 5;  ///< that have their names
/// How many shares may stand side by side: the first number with which what is written fits.
constexpr std::array<std::size_t, 3> most_shares{7, 5, 3};

/// From the nearest on; the one that is seen first.
std::vector<Cover> by_depth(std::vector<Cover> covers) {
  std::ranges::stable_sort(covers, [](const Cover& a, const Cover& b) {
    return std::pair(!a.seen, a.depth) < std::pair(!b.seen, b.depth);
  });
  return covers;
}

double strength(const LightSource& source) {
  double sum = 0;
  for (const LightShare& share : source.shares) sum += share.light.r + share.light.g + share.light.b;
  return sum;
}

std::size_t shares_of(const std::vector<LightSource>& sources) {
  std::size_t count = 0;
  for (const LightSource& source : sources) count += source.shares.size();
  return count;
}

/// The weakest become one, which has no factors, as long as there are too many.
std::vector<LightSource> strongest(std::vector<LightSource> sources, std::size_t most) {
  if (shares_of(sources) <= most) return sources;
  LightSource rest;
  std::size_t count = 0;
  while (shares_of(sources) + rest.shares.size() > most && sources.size() > 1) {
    // Ambient light, which has a single share, stays
    const auto weakest = std::ranges::min_element(sources, {}, [](const LightSource& source) {
      return std::pair(source.shares.size() == 1, strength(source));
    });
    if (weakest->shares.size() < std::max<std::size_t>(rest.shares.size(), 2)) break;
    if (rest.shares.empty()) {
      rest.shares = weakest->shares;
      for (LightShare& share : rest.shares) share.factor.reset();
    } else {
      for (std::size_t i = 0; i < rest.shares.size(); ++i)
        rest.shares[i].light = rest.shares[i].light + weakest->shares[i].light;
    }
    ++count;
    sources.erase(weakest);
  }
  if (count == 0) return sources;
  rest.name = fmt::format("{} other lights", count);
  sources.push_back(std::move(rest));
  return sources;
}

/// With so many digits; what no eye sees is 0.
std::string text_of(double value, int digits) {
  std::string text = fmt::format("{:.{}g}", std::abs(value) < 5e-4 ? 0.0 : value, digits);
  return text.starts_with('-') ? "−" + text.substr(1) : text;
}

std::string text_of(const Factor& factor) {
  if (text_of(factor.least, 3) == text_of(factor.most, 3))
    return fmt::format("{} {}", factor.name, text_of(factor.least, 3));
  return fmt::format("{} {} … {}", factor.name, text_of(factor.least, 2), text_of(factor.most, 2));
}

class PixelDrawing {
 public:
  PixelDrawing(const PixelFigure& figure, double width, double height)
      : figure_(figure), s_(std::min(width, height) / 720), crop_(crop_of(figure)) {
    sheet_.width = width;
    sheet_.height = height;
    sheet_.unit = s_;
  }

  Sheet drawn() {
    place_panels();
    draw_title();
    draw_picture();
    draw_crop();
    draw_zoom();
    draw_depths();
    draw_light();
    draw_sentence();
    return std::move(sheet_);
  }

 private:
  // --- Furniture

  TextShape text(dvec2 baseline, std::string words, double size, Tone tone, Face face = Face::sans) const {
    return {baseline,    std::move(words), face,  size * s_,
            Align::left, Paint::of(tone),  false, Paint::of(Tone::paper)};
  }
  /// The same, as short as there is room.
  TextShape short_text(dvec2 baseline, const std::string& words, double room, double size, Tone tone,
                       Face face = Face::sans) const {
    return text(baseline, elided(words, face, size * s_, room), size, tone, face);
  }
  RectShape frame(const Box& box, Tone tone, double width) const {
    return {.box = box, .fill = {}, .stroke = Paint::of(tone), .stroke_width = width * s_, .hatch_paint = {}};
  }
  LineShape line(std::vector<dvec2> points, Paint paint, double width) const {
    return {std::move(points), paint, width * s_, false, false, false};
  }
  /// Over a picture of any colours: on a rim of paper.
  void line_on_picture(Pen& p, const std::string& id, const std::vector<dvec2>& points, Paint paint,
                       double width, bool dashed = false) const {
    p.line(id + " rim", line(points, Paint::of(Tone::paper), width + 3));
    LineShape shape = line(points, paint, width);
    shape.dashed = dashed;
    p.line(id, shape);
  }
  void frame_on_picture(Pen& p, const std::string& id, const Box& box) const {
    p.rect(id + " rim", frame(layout::grown(box, 1.5 * s_), Tone::paper, 6));
    p.rect(id, frame(layout::grown(box, 1.5 * s_), Tone::ink, 3));
  }
  void caption(Pen& p, const std::string& id, double x, double room, const std::string& words) const {
    p.text(id, short_text({x, 124 * s_}, words, room, 20, Tone::muted, Face::bold));
  }

  /// The picture at the left, its crop beside it, the depths at the right, all of one height.
  void place_panels() {
    const double margin = 40 * s_, top = 136 * s_, height = 290 * s_;
    const double most = sheet_.width - 2 * margin - height - 290 * s_;
    const double aspect = static_cast<double>(figure_.picture.width()) / figure_.picture.height();
    const double width = std::clamp(height * aspect, 60 * s_, std::max(most, 60 * s_));
    const double fit = std::min(width / figure_.picture.width(), height / figure_.picture.height());
    const dvec2 size = fit * dvec2(figure_.picture.width(), figure_.picture.height());
    picture_ = {margin, top + (height - size.y) / 2, size.x, size.y};
    const double left = margin + width + 56 * s_;
    cell_ = height / static_cast<double>(std::max(crop_.width(), crop_.height()));
    crop_box_ = {left, top, cell_ * static_cast<double>(crop_.width()),
                 cell_ * static_cast<double>(crop_.height())};
    depths_ = {left + height + 44 * s_, top, 0, height};
    depths_.width = sheet_.width - margin - depths_.x;
  }

  void draw_title() {
    Pen p{sheet_, Slot::title, s_};
    const double room = sheet_.width - 80 * s_;
    p.text("title", short_text({40 * s_, 52 * s_}, figure_.title, room, 34, Tone::ink, Face::bold));
    p.text("subtitle", short_text({40 * s_, 86 * s_}, figure_.subtitle, room, 22, Tone::muted));
  }

  // --- The picture and its crop

  dvec2 in_picture(dvec2 at) const {
    return {picture_.x + at.x * picture_.width / figure_.picture.width(),
            picture_.y + at.y * picture_.height / figure_.picture.height()};
  }
  dvec2 in_crop(dvec2 at) const {
    return dvec2{crop_box_.x, crop_box_.y} + cell_ * (at - dvec2(crop_.lower));
  }
  /// What the crop shows, in the picture; large enough to be found.
  Box cropped() const {
    const dvec2 from = in_picture(dvec2(crop_.lower)), to = in_picture(dvec2(crop_.upper + 1));
    const dvec2 size = glm::max(to - from, dvec2(10 * s_)), corner = (from + to - size) / 2.0;
    return {corner.x, corner.y, size.x, size.y};
  }

  void draw_picture() {
    Pen p{sheet_, Slot::drawing, s_};
    caption(p, "picture caption", picture_.x, crop_box_.x - picture_.x, "picture");
    // Twice as fine as on the slide
    const int most = std::max(1, static_cast<int>(std::ceil(2 * picture_.width)));
    p.image("picture", {picture_, no_wider(figure_.picture, most)});
    p.rect("picture frame", frame(picture_, Tone::rule, 1.5));
    const Box hole = cropped();
    const dvec2 at{hole.x + hole.width / 2, hole.y + hole.height / 2};
    const std::array<Segment<2, double>, 4> hairs{{{{picture_.x, at.y}, {hole.x, at.y}},
                                                   {{hole.right(), at.y}, {picture_.right(), at.y}},
                                                   {{at.x, picture_.y}, {at.x, hole.y}},
                                                   {{at.x, hole.bottom()}, {at.x, picture_.bottom()}}}};
    int number = 0;
    for (const auto& [a, b] : hairs)
      if (a.x < b.x || a.y < b.y)
        line_on_picture(p, fmt::format("hair {}", ++number), {a, b}, Paint::of(Tone::ink), 1.5);
    frame_on_picture(p, "crop frame", hole);
  }

  /// From the frame in the picture to the crop: two lines that widen.
  void draw_zoom() {
    Pen p{sheet_, Slot::drawing, s_};
    const Box hole = cropped();
    const double from = picture_.right();
    const auto edge = [&](const std::string& id, double start, double end) {
      // Only where it does not cross the picture
      const double share = (from - hole.right()) / (crop_box_.x - hole.right());
      const dvec2 a{from, start + share * (end - start)}, b{crop_box_.x, end};
      p.line(id, line({a, b}, Paint::mark(Role::guide), 1.6));
    };
    edge("upper zoom", hole.y, crop_box_.y);
    edge("lower zoom", hole.bottom(), crop_box_.bottom());
  }

  void draw_crop() {
    Pen p{sheet_, Slot::drawing, s_};
    caption(p, "crop caption", crop_box_.x, depths_.x - crop_box_.x - 8 * s_,
            fmt::format("{} × {} pixels of it", crop_.width(), crop_.height()));
    p.image("crop", {crop_box_, part_of(figure_.picture, crop_)});
    p.rect("crop border", frame(crop_box_, Tone::ink, 1.5));
    for (const bool seen : {false, true}) {
      for (std::size_t i = 0; i < figure_.covers.size(); ++i)
        if (figure_.covers[i].seen == seen) draw_outline(p, fmt::format("triangle {}", i), figure_.covers[i]);
    }
    const dvec2 corner = in_crop(dvec2(figure_.pixel));
    frame_on_picture(p, "pixel", {corner.x, corner.y, cell_, cell_});
    const double radius = std::min(7 * s_, cell_ / 4);
    p.disc("centre", {in_crop(dvec2(figure_.pixel) + 0.5), radius, Paint::of(Tone::ink),
                      Paint::of(Tone::paper), 2 * s_});
  }

  static Paint paint_of(const Cover& cover) {
    return Paint::mark(cover.seen ? Role::result : Role::rejected);
  }

  /// The edges of a triangle, as far as the crop shows them.
  void draw_outline(Pen& p, const std::string& id, const Cover& cover) const {
    const Box box = box_of(crop_);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto part = layout::clipped(cover.corners[i], cover.corners[(i + 1) % 3], box);
      if (!part) continue;
      line_on_picture(p, fmt::format("{} edge {}", id, i), {in_crop(part->a), in_crop(part->b)},
                      paint_of(cover), cover.seen ? 5 : 3, !cover.seen);
    }
  }

  // --- The depths

  void draw_depths() {
    Pen p{sheet_, Slot::drawing, s_};
    caption(p, "depth caption", depths_.x, depths_.width, figure_.depth_name);
    const std::vector<Cover> covers = by_depth(figure_.covers);
    if (covers.empty()) {
      double y = depths_.y + 30 * s_;
      for (const std::string& words : wrapped(figure_.empty, Face::sans, 22 * s_, depths_.width)) {
        p.text(fmt::format("empty {}", y), text({depths_.x, y}, words, 22, Tone::ink));
        y += 30 * s_;
      }
      return;
    }
    const double axis = depths_.x + 12 * s_, top = depths_.y + 14 * s_, bottom = depths_.bottom() - 14 * s_;
    p.line("depth axis", line({{axis, depths_.y}, {axis, depths_.bottom()}}, Paint::of(Tone::muted), 2));
    const auto [least, most] = std::ranges::minmax(covers, {}, &Cover::depth);
    const double range = most.depth > least.depth ? most.depth - least.depth : 1;
    const std::size_t named = covers.size() <= most_covers ? covers.size() : most_covers - 1;
    for (std::size_t i = covers.size(); i-- > 0;) {
      const Cover& cover = covers[i];
      const dvec2 dot{axis, top + (cover.depth - least.depth) / range * (bottom - top)};
      if (i < named) draw_cover(p, i, cover, dot);
      p.disc(fmt::format("depth {}", i),
             {dot, (cover.seen ? 9 : 7) * s_, paint_of(cover), Paint::of(Tone::paper), 2 * s_});
    }
    if (named == covers.size()) return;
    p.text("others", text({depths_.x + 64 * s_, row(named) + 7 * s_},
                          fmt::format("and {} more", covers.size() - named), 20, Tone::muted));
  }

  /// The middle of the row of a cover.
  double row(std::size_t number) const { return depths_.y + (28 + 58 * static_cast<double>(number)) * s_; }

  void draw_cover(Pen& p, std::size_t number, const Cover& cover, dvec2 dot) const {
    const double x = depths_.x + 64 * s_, y = row(number), room = depths_.right() - x;
    p.line(fmt::format("to depth {}", number),
           line({dot, {x - 24 * s_, y}, {x - 8 * s_, y}}, Paint::mark(Role::guide), 1.6));
    const Face face = cover.seen ? Face::bold : Face::sans;
    p.text(fmt::format("cover {}", number),
           short_text({x, y - 3 * s_}, cover.name, room, 20, Tone::ink, face));
    const std::string depth = cover.seen ? cover.depth_text + ": seen" : cover.depth_text;
    TextShape shape = short_text({x, y + 22 * s_}, depth, room, 20, Tone::muted, face);
    if (cover.seen) shape.paint = Paint::text(Role::result);
    p.text(fmt::format("cover depth {}", number), std::move(shape));
  }

  // --- The light

  void draw_light() {
    Pen p{sheet_, Slot::drawing, s_};
    const double left = 40 * s_, room = sheet_.width - 80 * s_;
    p.text("light caption",
           short_text({left, light_top_ * s_}, figure_.light_name, room, 20, Tone::muted, Face::bold));
    std::vector<LightSource> sources;
    double step = 0;
    for (const std::size_t most : most_shares) {
      sources = strongest(figure_.sources, most);
      step = std::min(room / static_cast<double>(shares_of(sources) + 1), 240 * s_);
      if (widest_factor(sources) <= step - gap_ * s_) break;
    }
    double x = left;
    int number = 0;
    for (const LightSource& source : sources) {
      const double width = step * static_cast<double>(source.shares.size());
      draw_source(p, fmt::format("source {}", number), source, x, width);
      for (const LightShare& share : source.shares) {
        if (number > 0) sign(p, fmt::format("plus {}", number), x, "+");
        draw_share(p, fmt::format("share {}", number++), share, x, step);
        x += step;
      }
    }
    sign(p, "equals", x, "=");
    draw_swatch(p, "colour", figure_.colour, x, step);
    const double rest = sheet_.width - 40 * s_ - x;
    p.text("colour text",
           short_text({x, name_line_ * s_}, figure_.colour_text, rest, 22, Tone::ink, Face::bold));
    double y = factor_line_;
    for (const std::string& note : figure_.colour_notes) {
      p.text(fmt::format("colour note {}", y), short_text({x, y * s_}, note, rest, 20, Tone::muted));
      y += 28;
    }
  }

  double widest_factor(const std::vector<LightSource>& sources) const {
    double widest = 0;
    for (const LightSource& source : sources)
      for (const LightShare& share : source.shares)
        if (share.factor) widest = std::max(widest, text_width(text_of(*share.factor), Face::sans, 20 * s_));
    return widest;
  }

  /// What stands between two swatches, the second of which begins at x.
  void sign(Pen& p, const std::string& id, double x, const std::string& words) const {
    TextShape shape = text({x - gap_ / 2 * s_, (swatch_top_ + 34) * s_}, words, 30, Tone::ink, Face::bold);
    shape.align = Align::centre;
    p.text(id, std::move(shape));
  }

  void draw_swatch(Pen& p, const std::string& id, const Rgba8& colour, double x, double step) const {
    const Box box{x, swatch_top_ * s_, step - gap_ * s_, 46 * s_};
    p.image(id, {box, Image(1, 1, colour)});
    p.rect(id + " frame", frame(box, Tone::ink, 1.5));
  }

  void draw_share(Pen& p, const std::string& id, const LightShare& share, double x, double step) const {
    draw_swatch(p, id, tone_of(dvec3(share.light)), x, step);
    const double room = step - gap_ * s_;
    p.text(id + " name", short_text({x, name_line_ * s_}, share.name, room, 20, Tone::ink));
    if (share.factor) draw_factor(p, id, *share.factor, x, room, factor_line_);
  }

  /// The name of a source above its swatches, what goes for all of them below.
  void draw_source(Pen& p, const std::string& id, const LightSource& source, double x, double width) const {
    const double room = width - gap_ * s_;
    if (!source.name.empty())
      p.text(id + " name", short_text({x, (swatch_top_ - 8) * s_}, source.name, room, 20, Tone::ink));
    if (source.factor) draw_factor(p, id, *source.factor, x, room, factor_line_ + 38);
  }

  /// Its numbers, and a bar from 0 to 1 that is full up to the least and light up to the most.
  void draw_factor(Pen& p, const std::string& id, const Factor& factor, double x, double width,
                   double line) const {
    p.text(id + " factor", short_text({x, line * s_}, text_of(factor), width, 20, Tone::ink));
    const auto bar = [&](double share, Paint fill) {
      return RectShape{.box = {x, (line + 7) * s_, width * std::clamp(share, 0.0, 1.0), 8 * s_},
                       .fill = fill,
                       .stroke = {},
                       .hatch_paint = {}};
    };
    p.rect(id + " bar ground", bar(1, Paint::of(Tone::header)));
    if (factor.most > std::max(factor.least, 0.0))
      p.rect(id + " bar most", bar(factor.most, Paint::of(Tone::muted)));
    if (factor.least > 0) p.rect(id + " bar", bar(factor.least, Paint::mark(Role::measure)));
  }

  void draw_sentence() {
    Pen p{sheet_, Slot::sentence, s_};
    double y = sheet_.height - 52 * s_;
    int number = 0;
    for (const std::string& words :
         layout::sentence_lines(figure_.sentence, 26 * s_, sheet_.width - 80 * s_, 2)) {
      p.text(fmt::format("sentence {}", number++), text({40 * s_, y}, words, 26, Tone::ink));
      y += 34 * s_;
    }
  }

  static constexpr double light_top_ = 451, swatch_top_ = 485, name_line_ = 554, factor_line_ = 581,
                          gap_ = 34;

  const PixelFigure& figure_;
  double s_;
  Window crop_;
  double cell_ = 0;  ///< side of a pixel in the crop
  Box picture_, crop_box_, depths_;
  Sheet sheet_;
};

}  // namespace

Sheet sheet_of(const PixelFigure& figure, double width, double height) {
  expects(figure.picture.contains(figure.pixel), "a pixel of {} x {}, not ({}, {})", figure.picture.width(),
          figure.picture.height(), figure.pixel.x, figure.pixel.y);
  return PixelDrawing(figure, width, height).drawn();
}

}  // namespace gradus::plot
