#include "plot/heat_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include "core/contract.hpp"
#include "figure/layout/layout.hpp"
#include "figure/text/metrics.hpp"

namespace gradus::plot {
namespace {

using layout::Pen;

/// From little to much; the last one is for all that is more. Their lightness falls evenly.
constexpr std::array<Rgba8, 7> colours{{{255, 237, 160, 255},
                                        {254, 204, 92, 255},
                                        {253, 159, 68, 255},
                                        {243, 104, 48, 255},
                                        {212, 50, 44, 255},
                                        {158, 10, 58, 255},
                                        {88, 6, 58, 255}}};

/// The least amounts of the classes, in order; class 0 is for nothing.
class Classes {
 public:
  explicit Classes(const Raster<int>& amounts) {
    int least = 0, most = 0;
    for (int amount : amounts.cells()) {
      if (amount <= 0) continue;
      least = least == 0 ? amount : std::min(least, amount);
      most = std::max(most, amount);
    }
    if (most == 0) return;
    if (most < 4 * least)
      set_even(least, most);
    else
      set_doubling(least, most);
  }

  std::size_t of(int amount) const {
    if (amount <= 0) return 0;
    return static_cast<std::size_t>(std::ranges::upper_bound(least_, amount) - least_.begin());
  }
  std::size_t count() const { return least_.size(); }
  std::string text(std::size_t number) const {
    const int least = least_[number - 1];
    if (number == least_.size())
      return least == most_ ? fmt::format("{}", least) : fmt::format("{} to {}", least, most_);
    const int most = least_[number] - 1;
    return least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
  }

 private:
  /// Steps of 1, 2, 5, 10 …
  void set_even(int least, int most) {
    int step = 1;
    for (int digit = 0; (most - least) / step >= static_cast<int>(colours.size()); ++digit)
      step = digit % 3 == 1 ? step / 2 * 5 : step * 2;
    for (int from = least; from <= most; from = (from / step + 1) * step) least_.push_back(from);
    keep(most);
  }
  void set_doubling(int least, int most) {
    const int first = static_cast<int>(std::bit_floor(static_cast<unsigned>(least)));
    for (std::int64_t from = first; from <= most; from *= 2) least_.push_back(static_cast<int>(from));
    keep(most);
  }
  /// No more than there are colours: the last one takes what is more.
  void keep(int most) {
    least_.resize(std::min(least_.size(), colours.size()));
    most_ = most;
  }

  std::vector<int> least_;
  int most_ = 0;
};

/// A grey that leaves room for colours: lighter, and flatter.
Rgba8 faded(const Rgba8& c) {
  const double grey = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
  const auto light = static_cast<std::uint8_t>(std::lround(130 + grey * 0.45));
  return {light, light, light, 255};
}

/// Most of the colour, and so much of the grey that what is drawn there can be told.
Rgba8 over(const Rgba8& colour, const Rgba8& grey) {
  constexpr double share = 0.8;
  const auto mixed = [&](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(share * a + (1 - share) * b));
  };
  return {mixed(colour.r, grey.r), mixed(colour.g, grey.g), mixed(colour.b, grey.b), 255};
}

class HeatDrawing {
 public:
  HeatDrawing(const HeatMap& map, double width, double height)
      : map_(map), classes_(map.amounts), s_(std::min(width, height) / 720) {
    sheet_.width = width;
    sheet_.height = height;
    sheet_.unit = s_;
  }

  Sheet drawn() {
    draw_title();
    draw_legend();
    draw_picture();
    draw_sentence();
    return std::move(sheet_);
  }

 private:
  TextShape text(dvec2 baseline, std::string words, double size, Tone tone, Face face = Face::sans) const {
    return {baseline,    std::move(words), face,  size * s_,
            Align::left, Paint::of(tone),  false, Paint::of(Tone::paper)};
  }

  void draw_title() {
    Pen p{sheet_, Slot::title, s_};
    const double room = sheet_.width - 80 * s_;
    p.text("title", text({40 * s_, 54 * s_}, elided(map_.title, Face::bold, 34 * s_, room), 34, Tone::ink,
                         Face::bold));
    p.text("subtitle",
           text({40 * s_, 88 * s_}, elided(map_.subtitle, Face::sans, 22 * s_, room), 22, Tone::muted));
  }

  /// The classes that occur, the largest at the top.
  void draw_legend() {
    Pen p{sheet_, Slot::drawing, s_};
    std::vector<bool> there(classes_.count() + 1);
    for (int amount : map_.amounts.cells()) there[classes_.of(amount)] = true;
    double width = text_width(map_.unit, Face::bold, 20 * s_);
    for (std::size_t i = 1; i <= classes_.count(); ++i)
      width = std::max(width, 48 * s_ + text_width(classes_.text(i), Face::sans, 22 * s_));
    legend_ = sheet_.width - 40 * s_ - width;
    double y = 146 * s_;
    p.text("unit", text({legend_, y}, map_.unit, 20, Tone::ink, Face::bold));
    for (std::size_t i = there.size(); i-- > 0;) {
      if (!there[i]) continue;
      y += 40 * s_;
      swatch(p, i, {legend_, y - 24 * s_, 34 * s_, 30 * s_});
      p.text(fmt::format("class {}", i),
             text({legend_ + 48 * s_, y}, i == 0 ? "none" : classes_.text(i), 22, Tone::ink));
    }
  }

  /// Few classes take colours that are far apart.
  Rgba8 colour_of(std::size_t number) const {
    const std::size_t last = colours.size() - 1, count = classes_.count();
    return count == 1 ? colours[last / 2] : colours[(number - 1) * last / (count - 1)];
  }

  void swatch(Pen& p, std::size_t number, const Box& box) {
    const Rgba8 middle{128, 128, 128, 255};
    const Rgba8 colour = number == 0 ? faded(middle) : over(colour_of(number), faded(middle));
    sheet_.shapes.push_back(
        {Slot::drawing, fmt::format("swatch {}", number), ImageShape{box, Image(1, 1, colour)}});
    p.rect(fmt::format("frame {}", number), {.box = box,
                                             .fill = {},
                                             .stroke = Paint::of(Tone::muted),
                                             .stroke_width = 1 * s_,
                                             .hatch_paint = {}});
  }

  void draw_picture() {
    const Box room{40 * s_, 122 * s_, legend_ - 80 * s_, sheet_.height - 222 * s_};
    const double width = map_.picture.width(), height = map_.picture.height();
    const double scale = std::min(room.width / width, room.height / height);
    const Box box{room.x + (room.width - scale * width) / 2, room.y + (room.height - scale * height) / 2,
                  scale * width, scale * height};
    Image image = map_.picture;
    for (std::size_t i = 0; i < image.cells().size(); ++i) {
      Rgba8& pixel = image.cells()[i];
      pixel = faded(pixel);
      const std::size_t number = classes_.of(map_.amounts.cells()[i]);
      if (number > 0) pixel = over(colour_of(number), pixel);
    }
    sheet_.shapes.push_back({Slot::drawing, "heat map", ImageShape{box, std::move(image)}});
    Pen p{sheet_, Slot::drawing, s_};
    p.rect("picture", {.box = box,
                       .fill = {},
                       .stroke = Paint::of(Tone::rule),
                       .stroke_width = 1.5 * s_,
                       .hatch_paint = {}});
  }

  void draw_sentence() {
    Pen p{sheet_, Slot::sentence, s_};
    double y = sheet_.height - 60 * s_;
    for (const std::string& line : wrapped(map_.sentence, Face::sans, 26 * s_, sheet_.width - 80 * s_)) {
      p.text(fmt::format("sentence {}", y), text({40 * s_, y}, line, 26, Tone::ink));
      y += 34 * s_;
    }
  }

  const HeatMap& map_;
  Classes classes_;
  double s_;
  double legend_ = 0;  ///< where its column begins
  Sheet sheet_;
};

}  // namespace

Sheet sheet_of(const HeatMap& map, double width, double height) {
  expects(map.picture.width() >= 1 && map.picture.height() >= 1 &&
              map.picture.width() == map.amounts.width() && map.picture.height() == map.amounts.height(),
          "a heat map has an amount for each of its pixels, not {} x {} for {} x {}", map.amounts.width(),
          map.amounts.height(), map.picture.width(), map.picture.height());
  return HeatDrawing(map, width, height).drawn();
}

}  // namespace gradus::plot
