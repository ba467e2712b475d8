#pragma once
// Patterns beside each other: on one pixel, and in pictures of what is too fine for a regular one.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "figure/tone_of.hpp"
#include "stories/antialiasing/jittered/drawing.hpp"
#include "stories/picture_shelf.hpp"

namespace gradus::jittered {

inline Random numbers_of(const Arguments& given) {
  return numbers_of(static_cast<std::uint64_t>(given.integer("seed")), given.cell("pixel"));
}
inline Edge edge_of(const Arguments& given) {
  const std::vector<dvec2> places = given.points("edge");
  if (places[0] == places[1]) refuse("edge", "expected two different places");
  return {places[0], places[1]};
}
inline int count_of(const Arguments& given, Pattern pattern) {
  const int count = static_cast<int>(given.integer("samples"));
  if (pattern == Pattern::sobol && (count & (count - 1)) != 0)
    refuse("samples", "expected a power of two for Sobol’s pattern, found {}", count);
  return count;
}

inline constexpr std::array all_of_them{Pattern::regular, Pattern::uniform,
                                        Pattern::n_rooks, Pattern::jittered,
                                        Pattern::sobol,   Pattern::correlated_multi_jittered};
constexpr std::string_view name_of(Pattern pattern) {
  constexpr std::array<std::string_view, 6> names{
      "regular", "uniform", "jittered", "n_rooks", "correlated_multi_jittered", "sobol"};
  return names[static_cast<std::size_t>(pattern)];
}

// --- Six patterns on one pixel

/// A pattern's samples, and its error over many edges.
struct PatternShown {
  Pattern pattern;
  std::vector<dvec2> samples;
  double rmse;
};

/// The root mean square of what a pattern's means are off on random edges, each by another pattern: the same
/// edges for all.
inline double error_on_edges(Pattern pattern, int count, std::uint64_t seed) {
  constexpr int edges = 2000;
  Random random(seed, 77);
  std::vector<dvec2> samples(static_cast<std::size_t>(count));
  double squares = 0;
  for (int i = 0; i < edges; ++i) {
    const double angle = random.uniform(0, 2 * 3.14159265358979323846);
    const dvec2 way{cos(angle), sin(angle)}, normal{-way.y, way.x};
    const dvec2 middle = dvec2(0.5) + random.uniform(-0.70710678118654752, 0.70710678118654752) * normal;
    const Edge edge{middle - way, middle + way};
    const double area = edge.area();
    if (area == 0 || area == 1) {
      --i;
      continue;
    }
    put(pattern, samples, numbers_of(seed, {i, 1}));
    const auto colour_at = [&](dvec2 p) { return glm::dot(normal, p - middle) > 0 ? 1.0 : 0.0; };
    const double off = sample_pixel({0, 0}, samples, colour_at) - area;
    squares += off * off;
  }
  return std::sqrt(squares / edges);
}

class PatternsStory {
 public:
  static constexpr int width = 38, height = 29;
  /// Three above three.
  static Square pixel_of(std::size_t i) {
    return {{1.25 + 12.5 * static_cast<double>(i % 3), i < 3 ? 26.6 : 12.4}, 10.5};
  }

  PatternsStory(const Words& words, const Edge& edge, int count)
      : words_(words), edge_(edge), count_(count) {}

  double best() const { return done_.back().rmse; }

  void show(Board& board, const steps::Started&) { put(board); }
  Event say(const steps::Started&) const {
    return {.text = "patterns.started", .words = {{"area", edge_.area()}}, .count = count_};
  }
  void show(Board& board, const PatternShown& p) {
    done_.push_back(p);
    put(board);
  }
  Event say(const PatternShown& p) const {
    const auto inside = std::ranges::count_if(p.samples, [&](dvec2 s) { return edge_.holds(s); });
    const double mean = double(inside) / double(p.samples.size());
    const std::string_view name = name_of(p.pattern);
    return {.text = std::string_view("patterns.shown"),
            .facts = {{"mean", mean}, {"rmse", p.rmse}},
            .words = {{"why", words_.say("why." + std::string(name))}},
            .row = {words_.say("short." + std::string(name)), mean, p.rmse},
            .key = std::string(name),
            .phase = words_.say("short." + std::string(name))};
  }
  void show(Board& board, const steps::Finished&) { put(board); }
  Event say(const steps::Finished&) const {
    return {.text = "patterns.finished",
            .words = {{"uniform", done_[1].rmse}, {"jittered", done_[3].rmse}, {"best", done_[5].rmse}}};
  }

 private:
  void put(Board& board) const {
    View view;
    for (std::size_t i = 0; i < all_of_them.size(); ++i) {
      const Square pixel = pixel_of(i);
      const dvec2 corner = pixel.corner;
      const std::string id = fmt::format("{} ", i), name(name_of(all_of_them[i]));
      view.add({id + "name", Role::guide, Text{corner + dvec2{5.25, 1.15}, words_.say("short." + name)}});
      pixel.put_scene(view, id + "a", edge_);
      if (i >= done_.size()) continue;
      std::vector<Dropped> samples;
      for (const dvec2 s : done_[i].samples) samples.push_back({s, edge_.holds(s)});
      pixel.put_samples(view, id + "s", samples);
    }
    board.milestone(std::move(view));
  }

  const Words& words_;
  const Edge edge_;
  const int count_;
  std::vector<PatternShown> done_;
};

inline void tell_all_patterns(Narrator& narrator) {
  const Arguments& given = narrator.arguments();
  const int count = count_of(given, Pattern::sobol);
  PatternsStory story(narrator.words(), edge_of(given), count);
  PatternsStory::pixel_of(0).let_drag(narrator, edge_of(given));
  narrator.paper(PatternsStory::width, PatternsStory::height);
  narrator.trace().subtitle = narrator.words().count(
      "subtitle", count, {{"seed", given.integer("seed")}, {"pixel", given.cell("pixel")}});
  narrator.columns({{"pattern", false}, {"mean"}, {"rmse"}});
  narrator.legend({{Role::input, "scene"}, {Role::result, "inside"}, {Role::past, "outside"}});
  const auto watch = narrator.watcher(story);
  watch(steps::Started{}, 0);
  for (const Pattern pattern : all_of_them) {
    std::vector<dvec2> samples(static_cast<std::size_t>(count));
    put(pattern, samples, numbers_of(given));
    const auto seed = static_cast<std::uint64_t>(given.integer("seed"));
    watch(PatternShown{pattern, samples, error_on_edges(pattern, count, seed)}, narrator.last_line());
  }
  watch(steps::Finished{}, 0);
  narrator.telling({std::ssize(all_of_them), 0});
  narrator.result({{"rmse", story.best()}});
}

// --- Pictures

/// A scene that is finer than its picture's samples, in pixels.
class FineScene {
 public:
  /// across: the samples in a row of a pixel. Regular ones can carry half as many waves.
  FineScene(bool rings, int across) : rings_(rings), across_(across) {}

  double operator()(dvec2 p) const { return 0.5 + 0.5 * cos(2 * pi * phase(p)); }

 private:
  static constexpr double pi = 3.14159265358979323846;
  /// A tenth of a wave per pixel less than there are samples across, a little aslant; or rings round the
  /// upper left corner, which reach as many waves as samples 25 pixels away.
  double phase(dvec2 p) const {
    return rings_ ? across_ / 50.0 * (p.x * p.x + p.y * p.y) : (across_ - 0.1) * p.x + 0.06 * p.y;
  }

  bool rings_;
  int across_;
};

/// A picture by one pattern: what of it is false in every try, and what is noise.
struct PictureTaken {
  Pattern pattern;
  std::vector<double> greys;
  double wave, noise;
};

/// Pixels per side of a picture, and of its part that is magnified.
inline constexpr int picture_side = 30, crop_side = 10;

inline std::vector<double> picture_by(Pattern pattern, int count, std::uint64_t seed,
                                      const FineScene& scene) {
  std::vector<dvec2> samples(static_cast<std::size_t>(count));
  std::vector<double> greys;
  sample_picture({{0, 0}, ivec2(picture_side - 1)}, pattern, samples, seed, scene,
                 [&](ivec2, double grey) { greys.push_back(grey); });
  return greys;
}

/// The picture, and from many tries with other seeds what they have in common beside the truth (the root mean
/// square over the pixels) and by how much they differ.
inline PictureTaken picture_taken(Pattern pattern, int count, std::uint64_t seed, const FineScene& scene,
                                  const std::vector<double>& truth) {
  constexpr std::uint64_t tries = 16;
  std::vector<std::vector<double>> taken;
  for (std::uint64_t k = 0; k < tries; ++k) taken.push_back(picture_by(pattern, count, seed + k, scene));
  double wave = 0, noise = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    // Tries that are all alike have exactly no variance
    double mean = taken[0][i], variance = 0;
    for (const auto& greys : taken) mean += (greys[i] - taken[0][i]) / tries;
    for (const auto& greys : taken) variance += (greys[i] - mean) * (greys[i] - mean) / (tries - 1);
    noise += variance;
    // Less what the mean of so few tries still has of the noise
    wave += (mean - truth[i]) * (mean - truth[i]) - variance / tries;
  }
  const double pixels = static_cast<double>(truth.size());
  return {pattern, taken.front(), std::sqrt(std::max(0.0, wave / pixels)),
          std::sqrt(std::max(0.0, noise / pixels))};
}

inline void tell_pictures(Narrator& narrator) {
  constexpr std::array patterns{Pattern::regular, Pattern::jittered, Pattern::correlated_multi_jittered};
  const Words& words = narrator.words();
  const Arguments& given = narrator.arguments();
  const int count = static_cast<int>(given.integer("samples"));
  const FineScene scene(given.text("scene") == "zone_plate", grid_of(count).x);
  const auto seed = static_cast<std::uint64_t>(given.integer("seed"));
  narrator.trace().subtitle =
      words.count("pictures.subtitle", count,
                  {{"seed", given.integer("seed")}, {"scene", words.say("scene." + given.text("scene"))}});
  narrator.columns({{"pattern", false}, {"wave"}, {"noise"}});
  narrator.legend({{Role::current, "crop"}});
  std::vector<std::string> names;
  for (const Pattern pattern : patterns) names.push_back(words.say("short." + std::string(name_of(pattern))));
  // Its part is round a place where rings are as fine as the samples' grid
  PictureShelf shelf(narrator, {.size = ivec2(picture_side),
                                .names = names,
                                .gap = 3,
                                .heading = 4,
                                .part = PictureShelf::Part{ivec2(picture_side - crop_side - 1),
                                                           ivec2(crop_side), picture_side / crop_side}});
  shelf.start({.text = "pictures.started", .words = {{"side", picture_side}}, .count = count});
  const std::vector<double> truth = picture_by(Pattern::regular, 1600, seed, scene);
  std::vector<PictureTaken> done;
  for (const Pattern pattern : patterns) {
    const PictureTaken& p = done.emplace_back(picture_taken(pattern, count, seed, scene, truth));
    const std::string& name = names[done.size() - 1];
    shelf.show(
        "PictureTaken", narrator.last_line(),
        [&](ivec2 at) { return tone_of(p.greys[static_cast<std::size_t>(at.y * picture_side + at.x)]); },
        {.text = pattern == Pattern::regular ? "pictures.regular" : "pictures.random",
         .facts = {{"wave", p.wave}, {"noise", p.noise}},
         .words = {{"pattern", name}},
         .row = {name, p.wave, p.noise},
         .key = std::string(name_of(pattern)),
         .phase = name});
  }
  shelf.finish(
      {.text = "pictures.finished",
       .words = {{"wave", done[0].wave}, {"jittered", done[1].noise}, {"correlated", done[2].noise}}});
  narrator.result(
      {{"wave", done[0].wave}, {"noise_jittered", done[1].noise}, {"noise_correlated", done[2].noise}});
}

}  // namespace gradus::jittered
