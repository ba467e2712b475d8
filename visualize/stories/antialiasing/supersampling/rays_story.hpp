#pragma once
// A sphere over a chequered floor with one ray per pixel, and with n x n: the pixel drawn large whose rays
// differ, each in the colour of what it meets, and their mean.

#include "stories/antialiasing/supersampling/pictures.hpp"

namespace gradus::supersampling {

class RaysStory {
 public:
  RaysStory(const Words& words, const Subject& subject, const SphereScene& scene, ivec2 pixel)
      : subject_(subject), scene_(scene), pixel_(pixel) {
    Taken taken;
    once_ = picture_of(scene, {1, Filter::box}, taken);
    all_ = picture_of(scene, {subject.n, Filter::box}, taken);
    put_picture("one", upper(), once_, words.say("rays.one"));
    put_picture("all", lower(), all_, words.count("rays.all", std::int64_t{subject.n} * subject.n));
    base_.add({"c pixel", Role::input, round_cells(large_at, ivec2(large_side))});
    base_.add({"c mean", Role::input, round_cells(mean_at, mean_size)});
    const double middle = large_at.x + 0.5 * large_side - 0.5;
    base_.add({"c pixel name", Role::guide,
               Text{{middle, large_at.y - 0.5 * line - 0.5}, words.say("rays.pixel", {{"pixel", pixel}})}});
    base_.add(
        {"c mean name", Role::guide, Text{{middle, mean_at.y - 0.5 * line - 0.5}, words.say("rays.mean")}});
  }

  ivec2 cells() const { return {large_at.x + large_side + 2, lower().y + scene_.size.y + 1}; }
  StepNumber telling() const { return {std::int64_t{subject_.n} * subject_.n, 0}; }

  void show(Board& board, const Started&) { board.milestone(base_); }
  Event say(const Started& s) const {
    return {.text = "rays.started", .words = {{"pixel", pixel_}, {"rays", s.n * s.n}}};
  }
  void show(Board& board, const Added<dvec3>& a) {
    ++k_;
    const int n = subject_.n;
    const ivec2 cell = a.cell - pixel_ * n;
    const ivec2 first = large_at + cell * large_side / n, next = large_at + (cell + 1) * large_side / n;
    fill(first, next - first, a.value);
    fill(mean_at, mean_size, a.sum / static_cast<double>(k_));
    View view = base_;
    view.add({"z ray", Role::current, round_cells(first, next - first)});
    board.milestone(std::move(view));
  }
  Event say(const Added<dvec3>& a) const {
    const dvec2 place = place_of(a.cell, subject_.n);
    return {.text = "rays.added",
            .facts = {{"red", a.value.r}, {"green", a.value.g}, {"blue", a.value.b}},
            .words = {{"place", place},
                      {"light", light_text(a.value)},
                      {"mean", light_text(a.sum / static_cast<double>(k_))}},
            .count = k_,
            .row = {k_, place.x, place.y, a.value.r, a.value.g, a.value.b},
            .key = fmt::format("ray {}", k_)};
  }
  void show(Board& board, const Filtered<dvec3>& f) {
    base_.add({"d shown", Role::current, round_cells(mean_at, mean_size)});
    fill(mean_at, mean_size, f.value);
    board.milestone(base_);
  }
  Event say(const Filtered<dvec3>& f) const {
    return {.text = "rays.filtered",
            .facts = {{"red", f.value.r}, {"green", f.value.g}, {"blue", f.value.b}},
            .words = {{"rays", k_}, {"pixel", pixel_}, {"light", light_text(f.value)}},
            .key = "mean"};
  }
  void show(Board&, const Finished&) {}
  Event say(const Finished&) const { return {}; }

 private:
  ivec2 upper() const { return {1, line}; }
  ivec2 lower() const { return {1, 2 * line + scene_.size.y}; }
  static std::string light_text(const dvec3& light) { return Said(light).text; }

  void fill(ivec2 corner, ivec2 size, const dvec3& light) {
    put_values(base_, corner, size, 1, [&](ivec2) { return light; });
  }
  void put_picture(const std::string& id, ivec2 corner, const std::vector<dvec3>& values,
                   const std::string& name) {
    put_values(base_, corner, scene_.size, 1,
               [&](ivec2 at) { return values[static_cast<std::size_t>(at.y * scene_.size.x + at.x)]; });
    base_.add({"a name " + id, Role::guide,
               Text{{corner.x + 0.5 * scene_.size.x, corner.y - 0.5 * line - 0.5}, name}});
    base_.add({"b pixel " + id, Role::current, round_cells(corner + pixel_, ivec2(1))});
  }

  static constexpr int line = 5, large_side = 48;
  static constexpr ivec2 large_at{56, line}, mean_at{56, 2 * line + large_side}, mean_size{large_side, 24};

  const Subject& subject_;
  const SphereScene& scene_;
  const ivec2 pixel_;
  std::vector<dvec3> once_, all_;
  View base_{};
  std::int64_t k_ = 0;
};

/// The pixel whose rays differ most in their redness: about half of them meet the red sphere.
inline ivec2 most_divided(const SphereScene& scene, int n) {
  ivec2 found{0, 0};
  double widest = -1;
  for (int y = 0; y < scene.size.y; ++y) {
    for (int x = 0; x < scene.size.x; ++x) {
      double sum = 0, squares = 0;
      for (int k = 0; k < n * n; ++k) {
        const dvec3 light = scene(place_of(ivec2(x, y) * n + ivec2(k % n, k / n), n));
        const double redness = light.r - std::max(light.g, light.b);
        sum += redness;
        squares += redness * redness;
      }
      const double spread = n * n * squares - sum * sum;
      if (spread <= widest) continue;
      widest = spread;
      found = {x, y};
    }
  }
  return found;
}

inline void tell_rays(Narrator& narrator) {
  const Subject subject = subject_of(narrator.arguments());
  const SphereScene scene{{48, 36}};
  const ivec2 pixel = most_divided(scene, subject.n);
  RaysStory story(narrator.words(), subject, scene, pixel);
  set_cells(narrator, story.cells());
  narrator.subtitle("rays.subtitle", {{"n", fmt::format("{0} × {0}", subject.n)}});
  narrator.columns({{"k"}, {"x"}, {"y"}, {"red"}, {"green"}, {"blue"}});
  narrator.legend({{Role::current, "now_ray"}});
  dvec3 shown{};
  supersample(
      {pixel, pixel}, subject.n, Filter::box, scene, [&](ivec2, const dvec3& value) { shown = value; },
      narrator.watcher(story));
  narrator.telling(story.telling());
  narrator.result({{"red", shown.r}, {"green", shown.g}, {"blue", shown.b}});
}

}  // namespace gradus::supersampling
