// The numbers that the tour draws at each stage: each is one of the chain's, by another way to them.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <regex>

#include "stories/pipeline/textbook_chain/run.hpp"
#include "stories/pipeline/textbook_chain/way.hpp"
#include "support/tours.hpp"
#include "why/why.hpp"

namespace gradus {
namespace {

using test::tours::Given, test::tours::scene, test::tours::size, test::tours::tour;

// ---------------------------------------------------------------

/// Runs whose followed triangle meets others in the followed pixel, is cut, and is lit by both lamps.
const std::vector<Given>& ways() {
  static const std::vector<Given> all{{{"turn", "-30"}},
                                      {{"turn", "40"}},
                                      {{"turn", "30"}, {"near", "1.72"}},
                                      {{"turn", "-50"}, {"columns", "33"}}};
  return all;
}

struct Told {
  textbook_chain::Run run;
  textbook_chain::Followed followed;
  textbook_chain::Way way;
  pipeline::PixelStory why;          ///< another way to the same numbers
  pipeline::FragmentStory fragment;  ///< of it, the followed triangle's
};

std::unique_ptr<Told> told(const Given& given) {
  auto all = std::make_unique<Told>();
  all->run = textbook_chain::run_of(scene(given), size(given));
  all->followed = textbook_chain::followed_in(all->run, test::complete(test::topic("pipeline"), given));
  all->way = textbook_chain::way_of(all->run, all->followed);
  all->why = pipeline::why(all->run.scene, all->run.size, all->followed.pixel);
  const auto own = std::ranges::find_if(all->why.fragments, [&](const pipeline::FragmentStory& f) {
    return f.tested.fragment.id == all->run.pieces[all->followed.piece].id;
  });
  if (own != all->why.fragments.end()) all->fragment = *own;
  return all;
}

TEST(PipelineWay, FollowsPixelAndTriangleAsWhyTellsThem) {
  std::size_t cuts = 0, lamps = 0, tests = 0;
  for (const Given& given : ways()) {
    const auto all = told(given);
    const auto& [run, followed, way, why, own] = *all;
    const double aspect = static_cast<double>(run.size.width) / run.size.height;
    ASSERT_TRUE(way.fragment && way.place && way.edges && way.shaded && way.written);
    // Bit for bit
    EXPECT_EQ(way.fragment->depth, own.tested.fragment.depth);
    EXPECT_EQ(way.fragment->weights, own.tested.fragment.weights);
    ASSERT_EQ(way.tests.size(), why.fragments.size());
    for (std::size_t i = 0; i < way.tests.size(); ++i) {
      EXPECT_EQ(way.tests[i].fragment.depth, why.fragments[i].tested.fragment.depth);
      EXPECT_EQ(way.tests[i].nearer, why.fragments[i].tested.nearer);
    }
    EXPECT_EQ(way.shaded->colour, why.layers.at(0).shaded.colour);
    ASSERT_EQ(way.lamps.size(), why.layers.at(0).lamps.size());
    dvec3 diffuse{0}, specular{0};
    for (std::size_t i = 0; i < way.lamps.size(); ++i) {
      EXPECT_EQ(way.lamps[i].n_dot_l, why.layers.at(0).lamps[i].added.n_dot_l);
      EXPECT_EQ(way.lamps[i].cosine, why.layers.at(0).lamps[i].added.cosine);
      EXPECT_EQ(way.lamps[i].arrival.share(), why.layers.at(0).lamps[i].added.arrival.share());
      diffuse += way.lamps[i].diffuse;
      specular += way.lamps[i].specular;
      lamps += way.lamps[i].n_dot_l > 0;
    }
    EXPECT_EQ(diffuse, way.shaded->diffuse) << "what the lamps add is what the pixel has";
    EXPECT_EQ(specular, way.shaded->specular);
    EXPECT_EQ(way.written->colour, why.written.colour);
    for (int c = 0; c < 3; ++c) {
      const double light = static_cast<double>(way.written->light[c]);
      const std::array bytes{why.written.colour.r, why.written.colour.g, why.written.colour.b};
      EXPECT_EQ(std::lround(255 * textbook_chain::srgb_of_linear(light)), bytes[static_cast<std::size_t>(c)]);
    }
    // The pixel's place is one point in all spaces
    const auto& place = *way.place;
    EXPECT_NEAR(place.shares.x + place.shares.y + place.shares.z, 1, 1e-12);
    const glm::dvec4 world = run.scene.objects[0].placement * glm::dvec4(place.object, 1);
    EXPECT_LT(glm::distance(dvec3(world), place.world), 1e-12);
    if (way.shaded->fragment.id == way.fragment->id)
      EXPECT_LT(glm::distance(place.world, way.shaded->place.at), 1e-12);
    const glm::dmat4 view = view_matrix(run.scene.camera.frame);
    const glm::dmat4 projection = projection_matrix(projection_of(run.scene.camera.lens, aspect));
    EXPECT_LT(glm::distance(place.view, dvec3(view * world)), 1e-12);
    EXPECT_LT(glm::distance(place.clip, projection * (view * world)), 1e-11);
    EXPECT_NEAR(place.divided.z, way.fragment->depth, 1e-3) << "but for snapping";
    // Shares in the picture, and the depth from them
    const auto& edges = *way.edges;
    EXPECT_GE(std::min({edges.values.x, edges.values.y, edges.values.z}), 0);
    EXPECT_NEAR(edges.values.x + edges.values.y + edges.values.z, edges.doubled_area, 1e-9);
    EXPECT_LT(glm::distance(edges.weights * edges.doubled_area, edges.values), 1e-9);
    EXPECT_NEAR(glm::dot(edges.weights, edges.corner_depths), way.fragment->depth, 1e-12);
    // Cuts lie where the edge meets the plane, and are corners of what is left
    for (const auto& cut : way.cuts) {
      EXPECT_LT(glm::distance(cut.inside + cut.t * (cut.outside - cut.inside), cut.at), 1e-12);
      EXPECT_NE(std::ranges::find(own.clipped.after, cut.at, &pipeline::ClipPoint::at),
                own.clipped.after.end());
      ++cuts;
    }
    tests += way.tests.size() > 1;
  }
  EXPECT_EQ(cuts, 2u);
  EXPECT_GE(lamps, 5u);
  EXPECT_GE(tests, 3u);
}

/// All numbers in a text that are no part of a name: "v6", "E0".
std::vector<std::string> printed_numbers(std::string text) {
  for (std::size_t at = text.find("−"); at != text.npos; at = text.find("−", at)) text.replace(at, 3, "-");
  static const std::regex number(R"((^|[^a-zA-Z0-9#.])(-?[0-9]+(\.[0-9]+)?(e[+-][0-9]+)?))");
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), number), end; it != end; ++it)
    found.push_back((*it)[2]);
  return found;
}

/// Whether the text is this number, rounded.
bool shows(const std::string& text, double value) {
  const double shown = std::stod(text);
  const double size = std::abs(value);
  if (size < 1e-3 && value != 0) return std::abs(shown - value) <= 0.006 * size;  // three digits
  // Zeros at the end are not shown: 0.12 is 0.120
  const double unit = size >= 1000 ? 0.1 : size >= 100 ? 0.01 : 0.001;
  return std::abs(shown - value) <= 0.5 * unit + 1e-9;
}

/// All that the chain computed of the followed triangle and pixel, by another way than the tour.
std::vector<double> numbers_of_the_chain(const Told& all) {
  const auto& [run, followed, way, why, own] = all;
  std::vector<double> known{0, 1, 255};
  const auto add = [&]<int N>(const glm::vec<N, double>& v) {
    for (int i = 0; i < N; ++i) known.push_back(v[i]);
  };
  for (int c = 0; c < 4; ++c) {
    add(run.scene.objects[0].placement[c]);
    add(projection_matrix(projection_of(run.scene.camera.lens, double(run.size.width) / run.size.height))[c]);
  }
  glm::dmat3 corners{0};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [placed, projected] = own.corners[i];
    add(placed.from.at);
    add(placed.to.at);
    add(projected.view);
    add(projected.clip.at);
    corners[static_cast<int>(i)] = {projected.clip.at.x, projected.clip.at.y, projected.clip.at.w};
  }
  known.push_back(glm::determinant(corners));
  for (const auto& p : own.clipped.after) add(p.at);
  for (const auto& p : own.clipped.divided) add(p.at);
  for (const auto& p : own.clipped.before) {
    known.push_back(std::abs(p.at.z));
    for (const auto& q : own.clipped.before) known.push_back(p.at.z / (p.at.z - q.at.z));  // near plane
  }
  // The pixel's place, from the place that is lit
  const dvec3 place = way.place->world;
  add(place);
  add(dvec3(glm::inverse(run.scene.objects[0].placement) * glm::dvec4(place, 1)));
  const glm::dvec4 view = view_matrix(run.scene.camera.frame) * glm::dvec4(place, 1);
  const glm::dvec4 clip =
      projection_matrix(projection_of(run.scene.camera.lens, double(run.size.width) / run.size.height)) *
      view;
  add(dvec3(view));
  add(clip);
  add(dvec3(clip) / clip.w);
  // Edge functions as cross products
  std::array<dvec2, 3> p{};
  for (std::size_t i = 0; i < 3; ++i) p[i] = dvec2(own.snapped.corners[i].at) / 256.0;
  const auto cross = [](dvec2 a, dvec2 b) { return std::abs(a.x * b.y - a.y * b.x); };
  const dvec2 centre = dvec2(followed.pixel) + 0.5;
  const double area = cross(p[1] - p[0], p[2] - p[0]);
  known.push_back(area);
  for (std::size_t i = 0; i < 3; ++i) {
    const double e = cross(p[(i + 1) % 3] - centre, p[(i + 2) % 3] - centre);
    known.insert(known.end(), {e, e / area});
  }
  for (const auto& fragment : why.fragments) {
    known.push_back(fragment.tested.fragment.depth);
    add(fragment.tested.fragment.weights);
    known.push_back(fragment.tested.fragment.id.face);
  }
  known.push_back(static_cast<double>(why.fragments.size()));
  for (const auto& lamp : why.layers.at(0).lamps) {
    known.insert(known.end(), {lamp.added.n_dot_l, lamp.added.cosine, lamp.added.arrival.share(),
                               static_cast<double>(lamp.added.light + 1)});
    add(lamp.added.diffuse);
    add(lamp.added.specular);
  }
  add(why.layers.at(0).shaded.ambient);
  add(dvec3(why.layers.at(0).shaded.colour));
  const pipeline::Written& written = why.written;
  for (int c = 0; c < 3; ++c) {
    const double light = static_cast<double>(written.light[c]);
    known.push_back(light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
  }
  const Mesh& mesh = *run.scene.objects[0].mesh;
  known.push_back(static_cast<double>(
      mesh.materials[static_cast<std::size_t>(why.layers.at(0).shaded.material)].shininess));
  known.insert(known.end(), {double(written.colour.r), double(written.colour.g), double(written.colour.b)});
  known.insert(known.end(), {double(followed.pixel.x), double(followed.pixel.y), double(own.face.line),
                             double(own.face.vertices.size()), double(own.face.pieces.size())});
  return known;
}

/// What the cards of a step say.
std::vector<std::string> card_of(const Canvas& canvas) {
  std::vector<std::string> texts;
  for (const auto& [id, mark] : canvas.marks()) {
    if (const Text* text = std::get_if<Text>(&mark.shape); text && id.starts_with("k "))
      texts.push_back(text->text);
  }
  return texts;
}

TEST(PipelineWay, EveryNumberOnACardIsOneOfTheChain) {
  std::size_t checked = 0;
  for (const Given& given : ways()) {
    const auto all = told(given);
    const std::vector<double> known = numbers_of_the_chain(*all);
    const Trace trace = tour(given);
    Playhead playhead(trace);
    for (std::size_t k = 0; k < trace.steps.size(); ++k) {
      if (trace.steps[k].number == StepNumber{0, 0}) continue;  // the names of the stages
      for (const std::string& text : card_of(playhead.at(k))) {
        // The way's lines begin with the number of their stage
        const bool stage = text.size() == 1 && '1' <= text[0] && text[0] <= '8';
        for (const std::string& number : stage ? std::vector<std::string>{} : printed_numbers(text)) {
          EXPECT_TRUE(std::ranges::any_of(known, [&](double value) { return shows(number, value); }))
              << trace.steps[k].type << ": " << number << " in: " << text;
          ++checked;
        }
      }
    }
  }
  EXPECT_GT(checked, 2000u);
}

TEST(PipelineWay, EachStageShowsItsOwnNumbers) {
  for (const Given& given : ways()) {
    const auto all = told(given);
    const auto& [run, followed, way, why, own] = *all;
    const std::vector<std::vector<double>> wanted{
        {own.corners[0].placed.from.at.x, own.corners[2].placed.from.at.y},
        {own.corners[0].placed.to.at.x, own.corners[0].placed.to.at.z, run.scene.objects[0].placement[0][0]},
        {own.corners[0].projected.clip.at.x, own.corners[0].projected.clip.at.z,
         own.corners[0].projected.clip.at.w},
        {textbook_chain::exact_determinant({own.corners[0].projected.clip.at,
                                            own.corners[1].projected.clip.at,
                                            own.corners[2].projected.clip.at})},
        {own.clipped.after[0].at.y, own.clipped.divided[0].at.x, own.clipped.divided.back().at.y},
        {way.edges->values.x, way.edges->values.y, way.edges->values.z, own.tested.fragment.depth},
        {why.layers.at(0).lamps[0].added.n_dot_l, why.layers.at(0).lamps[1].added.n_dot_l,
         why.layers.at(0).lamps[0].added.diffuse.x, double(why.layers.at(0).shaded.colour.r),
         double(why.layers.at(0).shaded.colour.b)},
        {double(why.written.light.g), double(why.written.colour.r), double(why.written.colour.b)}};
    const Trace trace = tour(given);
    Playhead playhead(trace);
    for (std::size_t stage = 1; stage <= 8; ++stage) {
      SCOPED_TRACE(stage);
      const Canvas& canvas = playhead.at(index_of(trace, {static_cast<std::int64_t>(stage), 0}));
      std::vector<std::string> numbers;
      for (const std::string& text : card_of(canvas)) {
        for (std::string& number : printed_numbers(text)) numbers.push_back(std::move(number));
      }
      for (const double value : wanted[stage - 1]) {
        EXPECT_TRUE(std::ranges::any_of(numbers, [&](const std::string& text) { return shows(text, value); }))
            << value;
      }
      // One triangle and one pixel, each in its own colour
      const auto drawn = [&](Role role) {
        return std::ranges::any_of(canvas.marks(), [&](const auto& entry) {
          return entry.second.role == role && !std::holds_alternative<Text>(entry.second.shape) &&
                 !std::holds_alternative<Label>(entry.second.shape);
        });
      };
      EXPECT_TRUE(drawn(Role::current) || stage == 7);
      EXPECT_TRUE(drawn(Role::input));
      EXPECT_TRUE(canvas.marks().contains("caption") && canvas.marks().contains("j strip told"));
    }
    const std::vector<std::string> end = card_of(playhead.at(trace.steps.size() - 1));
    const Rgba8 c = why.written.colour;
    EXPECT_THAT(end,
                testing::Contains(fmt::format("sRGB {0}, {1}, {2} = #{0:02x}{1:02x}{2:02x}", c.r, c.g, c.b)));
  }
}

}  // namespace
}  // namespace gradus
