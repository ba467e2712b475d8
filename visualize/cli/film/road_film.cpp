#include "cli/film/road_film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/colour.hpp"
#include "engine/engine.hpp"
#include "figure/tone_of.hpp"
#include "plan/plan.hpp"

namespace gradus::cli {
namespace {

using pipeline::Gaze;

constexpr int gap = 8;         ///< pixels between two pictures, white
constexpr int strip_side = 5;  ///< frames in a strip

void paste(const Image& from, ivec2 corner, Image& onto) {
  for (int y = 0; y < from.height(); ++y) {
    const auto row = from.row(y);
    std::ranges::copy(row, onto.row(corner.y + y).begin() + corner.x);
  }
}

/// Pictures of one size in rows of so many.
Image in_rows(const std::vector<Image>& pictures, int across) {
  const int down = static_cast<int>(pictures.size()) / across;
  const int width = pictures[0].width() + gap, height = pictures[0].height() + gap;
  Image sheet(across * width - gap, down * height - gap, {255, 255, 255});
  for (int i = 0; i < across * down; ++i)
    paste(pictures[static_cast<std::size_t>(i)], {i % across * width, i / across * height}, sheet);
  return sheet;
}

Image part(const Image& of, int left, int width) {
  Image cut(width, of.height());
  for (int y = 0; y < of.height(); ++y)
    std::ranges::copy(of.row(y).subspan(static_cast<std::size_t>(left), static_cast<std::size_t>(width)),
                      cut.row(y).begin());
  return cut;
}

/// The mean light of each 2 x 2 pixels.
Image halved(const Image& image) {
  Image half(image.width() / 2, image.height() / 2);
  for (int y = 0; y < half.height(); ++y) {
    for (int x = 0; x < half.width(); ++x) {
      LinearRgb sum{0};
      for (const ivec2 d : {ivec2{0, 0}, ivec2{1, 0}, ivec2{0, 1}, ivec2{1, 1}})
        sum += linear_from_srgb8(image[ivec2{2 * x, 2 * y} + d]);
      half[{x, y}] = tone_of(dvec3(sum) / 4.0);
    }
  }
  return half;
}

}  // namespace

RoadFilm::RoadFilm(pipeline::RoadDemo demo, Image texture, std::size_t which, const std::string& name)
    : demo_(std::move(demo)),
      scene_(scene_of(demo_, std::move(texture))),
      buffers_(pipeline::engine::buffers_of(scene_)),
      bounds_(bounds_of(scene_)),
      gazes_(which == 0   ? std::vector{Gaze::forward}
             : which == 1 ? std::vector{Gaze::target}
                          : std::vector{Gaze::forward, Gaze::target}) {
  for (const Gaze gaze : gazes_) {
    for (int i = 0; i < frame_count(demo_); ++i) {
      const pipeline::Aim aim = aim_at(demo_, gaze, i);
      if (leads_somewhere(aim) && tells_upright(aim)) continue;
      throw InputError(fmt::format(
          "{}: k_cam_target: expected a place beside the camera's and not straight above or below it, found "
          "({}, {}, {}), which it is in frame {}",
          name, aim.target.x, aim.target.y, aim.target.z, i));
    }
  }
}

Image RoadFilm::seen(Gaze gaze, int frame) const {
  pipeline::Scene scene = scene_;
  scene.camera = camera_at(demo_, gaze, frame, bounds_);
  const ivec2 size = frame_size(demo_);
  const pipeline::Plan plan = pipeline::plan_of(scene, {size.x, size.y});
  pipeline::engine::Workspace workspace;
  return pipeline::engine::picture_of(scene, buffers_, plan, workspace, 1).image;
}

Image RoadFilm::frame(std::size_t i) const {
  std::vector<Image> pictures;
  for (const Gaze gaze : gazes_) pictures.push_back(seen(gaze, static_cast<int>(i)));
  return in_rows(pictures, static_cast<int>(pictures.size()));
}

std::vector<std::size_t> frames_in_strip(std::size_t count) {
  std::vector<std::size_t> shown;
  for (std::size_t k = 0; k < strip_side; ++k) shown.push_back(k * (count - 1) / (strip_side - 1));
  return shown;
}

Image strip_of(const std::vector<Image>& frames, bool both) {
  std::vector<Image> upper, lower;
  for (const Image& frame : frames) {
    const int width = both ? (frame.width() - gap) / 2 : frame.width();
    upper.push_back(halved(part(frame, 0, width)));
    if (both) lower.push_back(halved(part(frame, width + gap, width)));
  }
  upper.insert(upper.end(), lower.begin(), lower.end());
  return in_rows(upper, static_cast<int>(frames.size()));
}

}  // namespace gradus::cli
