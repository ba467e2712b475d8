#pragma once
// Patterns beside each other: on one pixel with their power spectra, and in pictures of what is too fine for
// a regular one.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "core/arithmetic/elementary.hpp"
#include "figure/tone_of.hpp"
#include "stories/antialiasing/chequered_plane.hpp"
#include "stories/antialiasing/jittered/drawing.hpp"
#include "stories/antialiasing/spectrum.hpp"
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

/// A pattern's samples, its error over many edges, and its power spectrum.
struct PatternShown {
  Pattern pattern;
  std::vector<dvec2> samples;
  double rmse;
  Spectrum spectrum;
};

/// A pattern's mean power over many pixels.
inline Spectrum spectrum_of(Pattern pattern, int count, std::uint64_t seed) {
  Spectrum spectrum(10);
  std::vector<dvec2> samples(static_cast<std::size_t>(count));
  for (int i = 0; i < 32; ++i) {
    put(pattern, samples, numbers_of(seed, {i, 2}));
    spectrum.add(samples);
  }
  return spectrum;
}

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
  static Window cells() { return {{0, 0}, {3 * width + 2 * apart + 1, 2 * (side + heading) + foot}}; }
  static Square pixel_of(std::size_t i) { return {dvec2(lower(i)) + dvec2{-0.5, side - 0.5}, double{side}}; }

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
            .words = {{"why", words_.say("why." + std::string(name))},
                      {"spectrum", words_.say("spectrum." + std::string(name))}},
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
  // Three above three, each a pixel with its spectrum on the right
  static constexpr int side = 21, gap = 1, width = 2 * side + gap, apart = 4, heading = 8, foot = 6;
  /// The lower left cell of a pixel.
  static ivec2 lower(std::size_t i) {
    return {1 + static_cast<int>(i % 3) * (width + apart), foot + (i < 3 ? side + heading : 0)};
  }

  void put(Board& board) const {
    View view;
    view.add({"a spectra", Role::guide,
              Text{{0.5 * cells().upper.x, 0.4 * foot}, words_.say("patterns.spectra")}});
    for (std::size_t i = 0; i < all_of_them.size(); ++i) {
      const Square pixel = pixel_of(i);
      const std::string id = fmt::format("{} ", i), name(name_of(all_of_them[i]));
      view.add({id + "name", Role::guide,
                Text{pixel.corner + dvec2{0.5 * width, 0.45 * heading}, words_.say("short." + name)}});
      pixel.put_scene(view, id + "a", edge_);
      const Square spectrum{pixel.corner + dvec2{side + gap, 0}, double{side}};
      view.add({id + "b spectrum", Role::boundary, Path{spectrum.box({0, 0}, {1, 1}), true}});
      if (i >= done_.size()) continue;
      std::vector<Dropped> samples;
      for (const dvec2 s : done_[i].samples) samples.push_back({s, edge_.holds(s)});
      pixel.put_samples(view, id + "s", samples);
      put_spectrum(view, lower(i) + ivec2{side + gap, 0}, done_[i].spectrum);
    }
    board.milestone(std::move(view));
  }
  static void put_spectrum(View& view, ivec2 at, const Spectrum& spectrum) {
    for (ivec2 p{0, 0}; p.y < side; ++p.y) {
      for (p.x = 0; p.x < side; ++p.x)
        view.cells.insert_or_assign({at.y + p.y, at.x + p.x}, CellLook{Role::result, "", spectrum.tone(p)});
    }
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
  narrator.whole_grid(PatternsStory::cells(), true);
  narrator.trace().grid.lines = 0.5;  // as fine as on a screen
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
    watch(PatternShown{pattern, samples, error_on_edges(pattern, count, seed),
                       spectrum_of(pattern, count, seed)},
          narrator.last_line());
  }
  watch(steps::Finished{}, 0);
  narrator.telling({std::ssize(all_of_them), 0});
  narrator.result({{"rmse", story.best()}});
}

// --- Pictures

/// Pixels of a picture.
inline constexpr ivec2 picture_size{48, 36};

/// A scene that is finer than its picture's samples, in pixels.
class FineScene {
 public:
  /// across: the samples in a row of a pixel. Regular ones can carry half as many waves.
  FineScene(std::string_view name, int across)
      : plane_(name == "plane"), rings_(name == "zone_plate"), across_(across) {}

  double operator()(dvec2 p) const {
    return plane_ ? ChequeredPlane{picture_size}(p) : 0.5 + 0.5 * cos(2 * pi * phase(p));
  }

 private:
  static constexpr double pi = 3.14159265358979323846;
  /// A tenth of a wave per pixel less than there are samples across, a little aslant; or rings round the
  /// upper left corner, which reach as many waves as samples 25 pixels away.
  double phase(dvec2 p) const {
    return rings_ ? across_ / 50.0 * (p.x * p.x + p.y * p.y) : (across_ - 0.1) * p.x + 0.06 * p.y;
  }

  bool plane_, rings_;
  int across_;
};

/// A picture by one pattern: what of it is false in every try, and what is noise.
struct PictureTaken {
  Pattern pattern;
  std::vector<double> greys;
  double wave, noise;
};

inline std::vector<double> picture_by(Pattern pattern, int count, std::uint64_t seed,
                                      const FineScene& scene) {
  std::vector<dvec2> samples(static_cast<std::size_t>(count));
  std::vector<double> greys;
  sample_picture({{0, 0}, picture_size - 1}, pattern, samples, seed, scene,
                 [&](ivec2, double grey) { greys.push_back(grey); });
  return greys;
}

/// The picture, and from many tries with other seeds what they have in common beside the truth (the root mean
/// square over the pixels) and by how much they differ.
inline PictureTaken picture_taken(Pattern pattern, int count, std::uint64_t seed, const FineScene& scene,
                                  const std::vector<double>& truth) {
  constexpr std::uint64_t tries = 8;
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
  const Words& words = narrator.words();
  const Arguments& given = narrator.arguments();
  const int count = static_cast<int>(given.integer("samples"));
  const std::string& scene_name = given.text("scene");
  const FineScene scene(scene_name, grid_of(count).x);
  const auto seed = static_cast<std::uint64_t>(given.integer("seed"));
  narrator.trace().subtitle =
      words.count("pictures.subtitle", count,
                  {{"seed", given.integer("seed")}, {"scene", words.say("scene." + scene_name)}});
  narrator.columns({{"pattern", false}, {"wave"}, {"noise"}});
  std::vector<Pattern> patterns;
  std::vector<std::string> names;
  for (const Pattern pattern : all_of_them) {
    // Sobol's has no other numbers of samples than powers of two
    if (pattern == Pattern::sobol && (count & (count - 1)) != 0) continue;
    patterns.push_back(pattern);
    names.push_back(words.say("short." + std::string(name_of(pattern))));
  }
  PictureShelf shelf(narrator, {.size = picture_size, .names = names, .row = 3, .gap = 3, .heading = 7});
  shelf.frame(Role::past);
  shelf.start({.text = scene_name == "plane" ? "pictures.started_plane" : "pictures.started",
               .words = {{"columns", picture_size.x}, {"rows", picture_size.y}},
               .count = count});
  const std::vector<double> truth = picture_by(Pattern::regular, 576, seed, scene);
  std::map<Pattern, PictureTaken> done;
  for (std::size_t k = 0; k < patterns.size(); ++k) {
    const Pattern pattern = patterns[k];
    const PictureTaken& p =
        done.emplace(pattern, picture_taken(pattern, count, seed, scene, truth)).first->second;
    shelf.show(
        "PictureTaken", narrator.last_line(),
        [&](ivec2 at) { return tone_of(p.greys[static_cast<std::size_t>(at.y * picture_size.x + at.x)]); },
        {.text = pattern == Pattern::regular ? "pictures.regular" : "pictures.random",
         .facts = {{"wave", p.wave}, {"noise", p.noise}},
         .words = {{"pattern", names[k]}},
         .row = {names[k], p.wave, p.noise},
         .key = std::string(name_of(pattern)),
         .phase = names[k]});
  }
  const double wave = done.at(Pattern::regular).wave, jittered = done.at(Pattern::jittered).noise,
               correlated = done.at(Pattern::correlated_multi_jittered).noise;
  shelf.finish({.text = "pictures.finished",
                .words = {{"wave", wave},
                          {"uniform", done.at(Pattern::uniform).noise},
                          {"jittered", jittered},
                          {"correlated", correlated}}});
  narrator.result({{"wave", wave}, {"noise_jittered", jittered}, {"noise_correlated", correlated}});
}

}  // namespace gradus::jittered
