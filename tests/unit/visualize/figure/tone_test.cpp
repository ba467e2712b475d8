// Light is drawn by the tone that shows it: half the light is 188, and 128 is a fifth of it. The oracle is
// the curve of IEC 61966-2-1 as it is printed, in long double, and the light as the algorithms give it.

#include "figure/tone_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "antialiasing/area_sampling/area_sampling_notes.hpp"
#include "antialiasing/sampling_theorem/test_patterns.hpp"
#include "support/example_traces.hpp"

namespace gradus {
namespace {

int tone_by_formula(long double light) {
  const long double code = light <= 0.0031308L ? 12.92L * light : 1.055L * std::pow(light, 1 / 2.4L) - 0.055L;
  return static_cast<int>(std::lround(255 * code));
}

TEST(Tone, HalfTheLightIs188) {
  EXPECT_EQ(tone_of(0.5), (Rgba8{188, 188, 188, 255}));
  EXPECT_EQ(tone_of(0.216), (Rgba8{128, 128, 128, 255}));
  EXPECT_EQ(tone_of(-1), (Rgba8{0, 0, 0, 255}));
  EXPECT_EQ(tone_of(2), (Rgba8{255, 255, 255, 255}));
  EXPECT_EQ(tone_on_paper({0, 0, 0, 255}, 0.5), tone_of(0.5)) << "half ink, half paper";
  EXPECT_EQ(tone_on_paper({86, 180, 233, 255}, 0), tone_of(1));
  EXPECT_EQ(tone_on_paper({86, 180, 233, 255}, 1), (Rgba8{86, 180, 233, 255}));
}

TEST(Tone, EveryShareOf255IsTheFormulas) {
  for (int k = 0; k <= 255; ++k) EXPECT_EQ(tone_of(k / 255.0).r, tone_by_formula(k / 255.0L)) << k;
}

/// The light that a tone shows, the other way round.
long double light_of(int tone) {
  const long double code = tone / 255.0L;
  return code <= 0.04045L ? code / 12.92L : std::pow((code + 0.055L) / 1.055L, 2.4L);
}

/// The greys of all cells that the whole run has drawn, how often each.
std::map<int, int> greys_of(const Trace& trace) {
  std::map<std::pair<int, int>, int> cells;
  for (const TraceStep& step : trace.steps) {
    for (const CellChange& change : step.delta.cells) {
      if (change.look && change.look->color) cells[{change.at.x, change.at.y}] = change.look->color->r;
    }
  }
  std::map<int, int> greys;
  for (const auto& [at, grey] : cells) ++greys[grey];
  return greys;
}

const Field& field_of(const TraceStep& step, std::string_view name) {
  return *std::ranges::find(step.fields, name, &Field::name);
}

/// Antialiased lines write the ink of a pixel into it, in 255ths.
TEST(Tone, InkOfALineTakesItsShareOfTheLight) {
  for (const char* method : {"wu", "gupta_sproull", "exact_area", "distance_along_column"}) {
    int seen = 0;
    const Trace trace = test::trace_of("antialiased_line", {{"method", method}});
    for (const TraceStep& step : trace.steps) {
      for (const CellChange& change : step.delta.cells) {
        if (!change.look || change.look->text.empty()) continue;
        const int ink = std::stoi(change.look->text);
        EXPECT_EQ(change.look->color->r, tone_by_formula(1 - ink / 255.0L)) << method << " " << ink;
        ++seen;
      }
    }
    EXPECT_GT(seen, 10) << method;
  }
}

TEST(Tone, AnAreaTakesItsShareOfThePixelsLight) {
  int seen = 0;
  const Trace trace = test::trace_of("area_sampling");
  for (const TraceStep& step : trace.steps) {
    if (step.type != "AreaTaken") continue;
    const long double area = std::get<double>(field_of(step, "area").value);
    ASSERT_EQ(step.delta.cells.size(), 1u);
    const Rgba8 tone = *step.delta.cells[0].look->color;
    const auto grey = static_cast<std::uint8_t>(tone_by_formula(1 - area));
    EXPECT_EQ(tone, (Rgba8{grey, grey, grey, 255})) << static_cast<double>(area);
    ++seen;
  }
  EXPECT_EQ(seen, 9);
}

// A cell of the zone plate's pictures shows the light that its samples have.
TEST(Tone, TheZonePlatesPicturesHaveTheirTones) {
  std::map<int, int> expected;
  for (const int n : {4, 16}) {
    const sampling_theorem::ZonePlate plate{dvec2(24.5), 18};
    sampling_theorem::picture_of(plate, ivec2(48), n,
                                 [&](ivec2, double light) { ++expected[tone_by_formula(light)]; });
  }
  EXPECT_EQ(greys_of(test::trace_of("sampling_theorem", {{"method", "zone_plate"}})), expected);
}

// The fine grating is half black, half white: so is the light of its pictures.
TEST(Tone, ANearlyEvenGreyHasHalfOfTheLight) {
  long double light = 0, cells = 0;
  const Trace trace = test::trace_of("jittered", {{"method", "pictures"}, {"scene", "grating"}});
  for (const auto& [grey, count] : greys_of(trace)) {
    light += count * light_of(grey);
    cells += count;
  }
  EXPECT_NEAR(static_cast<double>(light / cells), 0.5, 0.02);
}

// A mask has k of 32 bits, so a pixel of the star has one of 33 lights.
TEST(Tone, MasksHaveThirtySecondsOfTheLight) {
  std::set<int> possible;
  for (int k = 0; k <= 32; ++k) possible.insert(tone_by_formula(k / 32.0L));
  const std::map<int, int> greys = greys_of(test::trace_of("a_buffer", {{"method", "pictures"}}));
  for (const auto& [grey, count] : greys) EXPECT_TRUE(possible.contains(grey)) << grey << ", " << count;
  EXPECT_GT(greys.size(), 10u);
}

// The exhibit: what its tones show is less light than the polygon has.
TEST(AreaAsTone, ShowsLessLightThanThePolygonHas) {
  long double shown = 0;
  std::map<std::pair<int, int>, int> tones;
  const std::vector<ivec2> corners{{256, 768}, {1024, 256}, {512, 1280}};  // G001: area 4
  area_sampling::area_as_tone(corners, {{0, 0}, {4, 4}}, [&](ivec2 p, int tone) {
    tones[{p.x, p.y}] = tone;
    shown += light_of(tone);
  });
  EXPECT_EQ(tones.size(), 9u);
  EXPECT_EQ((tones[{3, 1}]), 106) << "5/12";
  EXPECT_NEAR(static_cast<double>(shown), 2.261, 0.0005);
  const Trace trace = test::trace_of("area_sampling", {{"method", "area_as_tone"}});
  EXPECT_NEAR(std::get<double>(trace.result.at(0).value), static_cast<double>(shown), 1e-6);
  EXPECT_EQ(std::get<double>(trace.result.at(1).value), 4);
}

}  // namespace
}  // namespace gradus
