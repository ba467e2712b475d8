#include "benchmark/clipping/window_lines.hpp"

#include <fmt/format.h>

#include <boost/geometry/algorithms/detail/overlay/clip_linestring.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/segment.hpp>

#ifdef GRADUS_HAS_OPENCV
#include <opencv2/imgproc.hpp>
#endif
#ifdef GRADUS_HAS_AGG
#include <agg_clip_liang_barsky.h>
#endif

namespace gradus::bench::window_lines {

std::vector<Case> cases_of(const std::vector<Method>& methods) {
  std::vector<Case> cases;
  for (const Mix mix : {Mix::inside, Mix::crossing, Mix::outside, Mix::crossing_reals}) {
    for (const Method& method : methods) {
      // OpenCV knows whole numbers only
      if (mix == Mix::crossing_reals && method.name.starts_with("OpenCV")) continue;
      cases.push_back(segments::case_of(method.name, method.standing, lines_of(mix, 4096), method.clip,
                                        {name_of(mix)}, segments::add_errors<2>));
    }
  }
  for (const std::size_t count : {64u, 512u, 4096u, 32768u}) {
    for (const Method& method : methods) {
      cases.push_back(segments::case_of(
          method.name, method.standing, lines_of(Mix::crossing, count), method.clip,
          {fmt::format("{} crossing", count), static_cast<double>(count)}, segments::add_errors<2>));
    }
  }
  return cases;
}

namespace {

std::optional<Line> by_boost(const Line& line) {
  namespace bg = boost::geometry;
  using Point = bg::model::d2::point_xy<double>;
  using Box = bg::model::box<Point>;
  const Box box(Point(window.lower.x, window.lower.y), Point(window.upper.x, window.upper.y));
  const bg::strategy::intersection::liang_barsky<Box, Point> strategy;
  Point a(line.a.x, line.a.y), b(line.b.x, line.b.y);
  bg::model::referring_segment<Point> piece(a, b);
  bool cut_a = false, cut_b = false;
  if (!strategy.clip_segment(box, piece, cut_a, cut_b)) return std::nullopt;
  return Line{{a.x(), a.y()}, {b.x(), b.y()}};
}

#ifdef GRADUS_HAS_AGG
std::optional<Line> by_agg(const Line& line) {
  const agg::rect_base<double> box(window.lower.x, window.lower.y, window.upper.x, window.upper.y);
  constexpr unsigned outside = 4;
  Line piece = line;
  if (agg::clip_line_segment(&piece.a.x, &piece.a.y, &piece.b.x, &piece.b.y, box) >= outside) {
    return std::nullopt;
  }
  return piece;
}
#endif

#ifdef GRADUS_HAS_OPENCV
/// Whole numbers in, whole numbers out: its errors are those of cutting off what comes after the point. The
/// lines become whole numbers once, at the first call, and what it found doubles again: only clipLine counts.
class ByOpenCv {
 public:
  void operator()(const std::vector<Line>& lines, Clipped& clipped) {
    const bool first = from_.empty();
    if (first) {
      for (const Line& line : lines) from_.insert(from_.end(), {point(line.a), point(line.b)});
      to_.resize(from_.size());
    }
    for (std::size_t i = 0; i < lines.size(); ++i) {
      to_[2 * i] = from_[2 * i];
      to_[2 * i + 1] = from_[2 * i + 1];
      clipped.accepted[i] = cv::clipLine(cv::Size2l(side, side), to_[2 * i], to_[2 * i + 1]);
    }
    for (std::size_t i = 0; first && i < lines.size(); ++i)
      clipped.lines[i] = {back(to_[2 * i]), back(to_[2 * i + 1])};
  }

 private:
  static cv::Point2l point(const glm::dvec2& p) {
    return {static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y)};
  }
  static glm::dvec2 back(const cv::Point2l& p) {
    return {static_cast<double>(p.x), static_cast<double>(p.y)};
  }

  std::vector<cv::Point2l> from_, to_;
};
#endif

}  // namespace

std::vector<Method> peers() {
  std::vector<Method> peers{{"Boost.Geometry clip_segment", Standing::peer, each(by_boost)}};
#ifdef GRADUS_HAS_OPENCV
  peers.push_back({"OpenCV clipLine", Standing::peer, ByOpenCv()});
#endif
#ifdef GRADUS_HAS_AGG
  peers.push_back({"AGG clip_line_segment", Standing::peer, each(by_agg)});
#endif
  return peers;
}

}  // namespace gradus::bench::window_lines
