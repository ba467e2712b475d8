// The tour through the textbook chain: every stage has its step, its numbers are the pipeline's, and the
// followed pixel ends in the colour that it has in the picture.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <tuple>

#include "figure/figure.hpp"
#include "figure/layout/layout.hpp"
#include "pipeline.hpp"
#include "stories/pipeline/textbook_chain/panels.hpp"
#include "stories/pipeline/textbook_chain/run.hpp"
#include "support/sanitized.hpp"
#include "support/tours.hpp"

namespace gradus {
namespace {

using test::tours::Given, test::tours::scene, test::tours::size, test::tours::tour;

/// Runs in which something is cut, nothing is cut, the followed face is removed, and nothing is seen.
const std::vector<Given>& runs() {
  static const std::vector<Given> all{{},
                                      {{"turn", "50"}, {"near", "0.5"}},
                                      {{"face", "1"}},
                                      {{"eye", "0.3,0.6,6"}, {"target", "0.3,0.6,9"}, {"columns", "9"}},
                                      {{"turn", "-65"}, {"fov", "70"}, {"columns", "33"}, {"rows", "21"}}};
  return all;
}

template <class T>
T field(const TraceStep& step, std::string_view name) {
  for (const Field& f : step.fields) {
    if (f.name == name) return std::get<T>(f.value);
  }
  ADD_FAILURE() << step.type << " has no field " << name;
  return T{};
}
glm::dvec4 numbers(const TraceStep& step) {
  return {field<double>(step, "x"), field<double>(step, "y"), field<double>(step, "z"),
          field<double>(step, "w")};
}
dvec3 place(const TraceStep& step) {
  return {field<double>(step, "x"), field<double>(step, "y"), field<double>(step, "z")};
}
const TraceStep& milestone(const Trace& trace, std::int64_t stage) {
  return trace.steps[index_of(trace, {stage, 0})];
}

/// The first cell of a pixel's block in the picture.
ivec2 in_drawing(pipeline::Size picture, ivec2 pixel) {
  return textbook_chain::ChainPaper(picture).cell(pixel);
}

TEST(PipelineTour, AnExchangedStageSaysWhatItGetsWrong) {
  const auto method = [](const char* name, Given given = {}) {
    given["method"] = name;
    return tour(given);
  };
  // Culled after the division: told to the end, where the picture has holes
  const Trace culled = method("cull_after_division");
  EXPECT_EQ(culled.last, 8);
  EXPECT_GT(field<std::int64_t>(milestone(culled, 4), "wrong"), 0);
  const auto faced = std::ranges::find(culled.steps, "Faced", &TraceStep::type);
  ASSERT_NE(faced, culled.steps.end());
  EXPECT_LT(field<double>(*faced, "area") * field<double>(*faced, "determinant"), 0) << "the wrong sign";
  EXPECT_THAT(faced->sentence, testing::HasSubstr("behind the eye, came out mirrored"));
  // The others end with their stage, and mark what they misjudge
  for (const char* name : {"closed_half_planes", "expanded_edges"}) {
    SCOPED_TRACE(name);
    const Trace trace = method(name);
    EXPECT_EQ(trace.last, 6);
    EXPECT_EQ(method(name, {{"stage", "clipping"}}).last, 5);
    const Trace right = tour({{"stage", "rasterization"}, {"eye", "0,1.5,12.5899"}, {"target", "0,1.5,0"}});
    const auto fragments = [](const Trace& t) { return field<std::int64_t>(milestone(t, 6), "fragments"); };
    if (trace.method == "closed_half_planes") {
      EXPECT_EQ(fragments(trace) - fragments(right), field<std::int64_t>(milestone(trace, 6), "misjudged"));
    }
    Playhead playhead(trace);
    const Canvas& canvas = playhead.at(index_of(trace, {6, 0}));
    int marked = 0;
    for (int y = 0; y < 35; ++y) {
      for (int x = 0; x < 50; ++x) {
        const auto look = canvas.at(in_drawing({50, 35}, {x, y}));
        marked += look && look->role == Role::rejected;
      }
    }
    const std::int64_t misjudged = field<std::int64_t>(milestone(trace, 6), "misjudged");
    EXPECT_LE(marked, misjudged) << "a pixel may be misjudged for two triangles";
    EXPECT_EQ(marked > 0, misjudged > 0);
  }
  EXPECT_GT(field<std::int64_t>(milestone(method("expanded_edges"), 6), "misjudged"), 0);
}

TEST(PipelineTour, HasAStepForEveryStage) {
  for (const Given& given : runs()) {
    const Trace trace = tour(given);
    ASSERT_TRUE(trace.whole());
    ASSERT_EQ(trace.last, 8);
    std::vector<std::string> lines;
    for (std::int64_t stage = 1; stage <= 8; ++stage) {
      const TraceStep& step = milestone(trace, stage);
      EXPECT_TRUE(step.phase.starts_with(fmt::format("{} ", stage))) << step.phase;
      const auto line = std::ranges::find(trace.listing, step.line, &SourceLine::number);
      ASSERT_NE(line, trace.listing.end());
      lines.push_back(line->text.substr(line->text.find_first_not_of(' ')));
    }
    EXPECT_THAT(lines,
                testing::ElementsAre("auto in = input(scene);", "auto w = to_world(scene, in);",
                                     "auto c = to_clip(scene, size, w);", "auto front = cull(scene, c);",
                                     "auto t = clip(w, front, size);", "rasterize(t, size, emit);",
                                     "auto lit = shade(scene, t, kept);", "return output(lit);"));
  }
}

/// The face that a z-buffer of the test's own keeps at each pixel: of the nearest fragment, and of equally
/// near ones of the lowest.
std::map<std::pair<int, int>, int> faces_kept(const textbook_chain::Run& run) {
  std::map<std::pair<int, int>, pipeline::Fragment> kept;
  for (const pipeline::Fragment& f : run.covered) {
    const auto [cell, first] = kept.try_emplace({f.pixel.x, f.pixel.y}, f);
    const pipeline::Fragment& before = cell->second;
    if (!first && std::tie(f.depth, f.id) < std::tie(before.depth, before.id)) cell->second = f;
  }
  std::map<std::pair<int, int>, int> faces;
  for (const auto& [pixel, fragment] : kept) faces[pixel] = fragment.id.face;
  return faces;
}

TEST(PipelineTour, FollowsTheFaceThatColouredThePixel) {
  std::size_t seen = 0, bare = 0;
  for (const Given& given : runs()) {
    const textbook_chain::Run run = textbook_chain::run_of(scene(given), size(given));
    const auto faces = faces_kept(run);
    const int stride = test::sanitized ? 5 : 1;
    for (int y = 0; y < run.size.height; y += stride) {
      for (int x = 0; x < run.size.width; x += stride) {
        Given there = given;
        there.erase("face");
        there["pixel"] = fmt::format("{},{}", x, y);
        const auto followed =
            textbook_chain::followed_in(run, test::complete(test::topic("pipeline"), there));
        EXPECT_EQ(followed.pixel, ivec2(x, y));
        const auto face = faces.find({x, y});
        ASSERT_EQ(followed.seen.has_value(), face != faces.end());
        (followed.seen ? seen : bare) += 1;
        if (!followed.seen) continue;
        EXPECT_EQ(*followed.seen, face->second);
        EXPECT_EQ(run.pieces[followed.piece].id.face, face->second) << x << "," << y;
      }
    }
  }
  EXPECT_GT(seen, test::thinned(500, 25));
  EXPECT_GT(bare, test::thinned(500, 25));
}

TEST(PipelineTour, SaysWhereNothingCoversThePixel) {
  const Trace trace = tour({{"pixel", "0,0"}});
  const auto value = [&](std::string_view name) {
    const auto found = std::ranges::find(trace.result, name, &Field::name);
    return found == trace.result.end() ? std::nullopt : std::optional(found->value);
  };
  EXPECT_EQ(value("face"), std::nullopt);
  EXPECT_EQ(value("seen"), Value{std::string("nothing")});
  EXPECT_THAT(trace.steps.front().sentence, testing::HasSubstr("Nothing covers pixel (0,\u00a00)"));
  EXPECT_TRUE(std::ranges::any_of(trace.steps, [](const TraceStep& s) {
    return s.sentence.starts_with("No triangle covers the centre");
  }));
}

TEST(PipelineTour, EndsWithTheStageThatIsAskedFor) {
  const std::vector<std::string> names{"input",    "world",         "perspective", "back_faces",
                                       "clipping", "rasterization", "visibility",  "output"};
  EXPECT_EQ(tour({{"stage", "all"}}).source_file, "pipeline/pipeline.hpp");
  EXPECT_EQ(tour({}).source_file, "pipeline/pipeline.hpp");
  const Trace all = tour({});
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Trace trace = tour({{"stage", names[i]}});
    ASSERT_EQ(trace.last, static_cast<std::int64_t>(i) + 1);
    for (std::size_t k = 0; k < trace.steps.size(); ++k)
      ASSERT_EQ(trace.steps[k].sentence, all.steps[k].sentence);
  }
}

/// What stands in this line of a file of the project.
std::string line_in(const std::string& file, int number) {
  std::ifstream text(std::string(GRADUS_SOURCE_DIR) + "/" + file);
  std::string line;
  for (int i = 0; i < number; ++i) std::getline(text, line);
  return line;
}

/// The report that follows on this line of a file, with nothing listed but a continuation or braces between.
std::string report_behind(const std::string& file, int number) {
  for (int behind = 0; behind <= 4; ++behind) {
    const std::string line = line_in(file, number + behind);
    if (line.find("observer(") != std::string::npos) return line;
  }
  return "";
}

TEST(PipelineTour, AStageListsItsOwnSourceWithTheLinesThatReported) {
  // Stage, file, and for each event that its steps are told as what the reporting line hands over
  struct StageLines {
    std::string stage, file;
    std::map<std::string, std::string> events;
  };
  const std::vector<StageLines> cases{
      {"input", "1_input", {{"VertexRead", "VertexRead{"}, {"FaceRead", "face_read("}}},
      {"world", "2_world", {{"Placed", "Placed{"}}},
      {"perspective", "3_perspective", {{"Projected", "Projected{"}}},
      {"back_faces", "4_back_faces", {{"Faced", "Faced{"}}},
      {"clipping", "5_clipping", {{"Clipped", "clipped("}, {"Divided", "clipped("}}},
      {"rasterization",
       "6_rasterization",
       {{"Snapped", "Snapped{"}, {"Covered", "Covered{"}, {"EdgesTested", "Covered{"}}},
      {"visibility", "7_visibility_and_shading", {{"DepthTested", "tested("}, {"Shaded", "observer(lit)"}}},
      {"output", "8_output", {{"Written", "Written{"}}}};
  int listed = 0, reported = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const auto& [stage, file, events] = cases[i];
    SCOPED_TRACE(stage);
    const Trace trace = tour({{"stage", stage}});
    EXPECT_EQ(trace.source_file, "pipeline/stages/" + file + ".hpp");
    ASSERT_GE(trace.listing.size(), 6u);
    for (const SourceLine& line : trace.listing) {
      const std::string code = line.text.substr(0, line.text.find("  //"));
      EXPECT_LE(code.size(), 44u) << line.text << ": too wide for a slide";
      EXPECT_NE(line_in(trace.source_file, line.number).find(code.substr(0, code.find('('))),
                std::string::npos)
          << line.text;
      ++listed;
    }
    EXPECT_TRUE(std::ranges::is_sorted(trace.listing, {}, &SourceLine::number));
    for (const TraceStep& step : trace.steps) {
      const auto event = events.find(step.type);
      if (event != events.end()) {
        const std::string line = report_behind(trace.source_file, step.line);
        EXPECT_NE(line.find(event->second), std::string::npos) << step.type << ": " << line;
        EXPECT_NE(line.find("observer("), std::string::npos) << step.type << ": " << line;
        ++reported;
      } else if (step.number != StepNumber{static_cast<std::int64_t>(i) + 1, 0}) {
        EXPECT_EQ(step.line, 0) << step.type << ": nothing of this stage reported it";
      }
    }
    const bool returns = trace.listing.back().text.starts_with("return ");
    EXPECT_EQ(trace.steps.back().line,
              returns ? trace.listing.back().number : trace.steps[trace.steps.size() - 2].line)
        << "its end";
    EXPECT_GT(trace.steps.back().line, 0);
  }
  EXPECT_GE(listed, 100);
  EXPECT_GE(reported, 30);
}

TEST(PipelineTour, TellsTheNumbersOfAnotherWayToThem) {
  int placed = 0, projected = 0, divided = 0, snapped = 0;
  for (const Given& given : runs()) {
    const Trace trace = tour(given);
    const pipeline::Scene s = scene(given);
    const auto [width, height] = size(given);
    const auto turn = given.contains("turn") ? std::stod(given.at("turn")) * std::acos(-1.0) / 180 : 0.0;
    const glm::dmat4 view = view_matrix(s.camera.frame);
    const glm::dmat4 projection = projection_matrix(projection_of(s.camera.lens, double(width) / height));
    std::map<std::string, dvec3> object;
    glm::dvec4 clip{0};
    std::vector<dvec2> pixels;
    std::vector<dvec2> corners;
    for (const TraceStep& step : trace.steps) {
      if (step.type == "VertexRead") {
        object[step.key] = place(step);
        EXPECT_EQ(place(step), s.objects[0].mesh->positions[std::stoul(step.key.substr(1))]);
      } else if (step.type == "Placed") {
        const dvec3 p = object.at(step.key);
        const dvec3 turned{std::cos(turn) * p.x + std::sin(turn) * p.z, p.y,
                           std::cos(turn) * p.z - std::sin(turn) * p.x};
        EXPECT_LT(glm::distance(place(step), turned), 1e-14);
        object[step.key] = place(step);
        ++placed;
      } else if (step.type == "Projected") {
        const glm::dvec4 other = projection * (view * glm::dvec4(object.at(step.key), 1));
        EXPECT_LT(glm::distance(numbers(step), other), 1e-11) << step.sentence;
        ++projected;
      } else if (step.type == "Clipped" && !step.fields.empty()) {
        clip = numbers(step);
        EXPECT_GE(clip.z, -1e-12);
      } else if (step.type == "Divided") {
        EXPECT_LT(glm::distance(place(step), dvec3(clip) / clip.w), 1e-14);
        corners.emplace_back((clip.x / clip.w + 1) / 2 * width, (1 - clip.y / clip.w) / 2 * height);
        ++divided;
      } else if (step.type == "Snapped") {
        const dvec2 at = dvec2(field<std::int64_t>(step, "x"), field<std::int64_t>(step, "y")) / 256.0;
        const auto near = [&](dvec2 p) {
          return std::max(std::abs(p.x - at.x), std::abs(p.y - at.y)) <= 1 / 512.0 + 1e-9;
        };
        EXPECT_TRUE(std::ranges::any_of(corners, near)) << step.sentence;
        ++snapped;
      }
    }
  }
  EXPECT_EQ(placed, 15);
  EXPECT_EQ(projected, 15);
  EXPECT_GE(divided, 10);
  EXPECT_GE(snapped, 12);
}

TEST(PipelineTour, ShowsThePictureThatRenderMakes) {
  for (const Given& given : runs()) {
    const Trace trace = tour(given);
    const Image image = pipeline::render(scene(given), size(given));
    Playhead playhead(trace);
    const Canvas& canvas = playhead.at(trace.steps.size() - 1);
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x)
        ASSERT_EQ(canvas.at(in_drawing(size(given), {x, y})).value().color, (image[{x, y}]));
    }
    const ivec2 pixel = std::get<ivec2>(trace.result[0].value);
    const Rgba8 c = image[pixel];
    EXPECT_EQ(std::get<std::string>(trace.result[1].value),
              fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b));
    const auto written = std::ranges::find(trace.steps, "Written", &TraceStep::type);
    ASSERT_NE(written, trace.steps.end());
    EXPECT_EQ(field<std::int64_t>(*written, "red"), c.r);
    EXPECT_EQ(field<std::int64_t>(*written, "green"), c.g);
    EXPECT_EQ(field<std::int64_t>(*written, "blue"), c.b);
  }
}

TEST(PipelineTour, CountsWhatEveryStageKeeps) {
  for (const Given& given : runs()) {
    const Trace trace = tour(given);
    const auto count = [&](std::int64_t stage, std::string_view name) {
      return field<std::int64_t>(milestone(trace, stage), name);
    };
    EXPECT_EQ(count(1, "pieces"), 64);
    EXPECT_EQ(count(4, "removed") + count(4, "kept"), count(1, "pieces"));
    EXPECT_LE(count(5, "gone"), count(5, "clipped"));
    if (count(5, "clipped") == 0) EXPECT_EQ(count(5, "triangles"), count(4, "kept"));
    EXPECT_GE(count(5, "triangles"), count(4, "kept") - count(5, "gone"));
    EXPECT_LE(count(7, "nearest"), count(7, "covered"));
    EXPECT_EQ(count(7, "covered"), count(6, "covered"));
    EXPECT_LE(count(7, "visible"), count(6, "fragments"));
    EXPECT_EQ(count(8, "visible"), count(7, "visible"));
    EXPECT_EQ(count(8, "pixels"), std::int64_t{size(given).width} * size(given).height);
    std::int64_t cells = 0;
    for (const TraceStep& step : trace.steps) {
      if (step.type == "Covered")
        cells += field<std::int64_t>(step, "last") - field<std::int64_t>(step, "first") + 1;
    }
    EXPECT_EQ(cells, count(6, "covered"));
  }
}

TEST(PipelineTour, FollowsAFaceThatIsRemovedOnlyToItsEnd) {
  const Trace trace = tour({{"face", "1"}});
  for (const TraceStep& step : trace.steps) {
    EXPECT_NE(step.type, "Clipped");
    EXPECT_NE(step.type, "Covered");
  }
  const auto faced = std::ranges::find(trace.steps, "Faced", &TraceStep::type);
  ASSERT_NE(faced, trace.steps.end());
  EXPECT_TRUE(field<bool>(*faced, "removed"));
  EXPECT_LT(field<double>(*faced, "determinant"), 0);
}

TEST(PipelineTour, CutsTheFollowedTriangleAtTheNearPlane) {
  const Trace trace = tour({});
  const auto made = std::ranges::count_if(trace.steps, [](const TraceStep& step) {
    return step.type == "Clipped" && field<double>(step, "z") == 0;
  });
  EXPECT_EQ(made, 2);
  EXPECT_GT(field<std::int64_t>(milestone(trace, 5), "clipped"), 0);
}

TEST(PipelineTour, SpeaksEveryLanguage) {
  for (const Language& language : languages()) {
    for (const Given& given : runs()) {
      const Trace trace = test::trace_of("pipeline", given, {0, Recording::default_most, Wording(language)});
      for (const TraceStep& step : trace.steps) EXPECT_FALSE(step.sentence.empty());
    }
  }
}

/// Lines of numbers below the panels are legible or are left out; listing and table stay in any case.
TEST(PipelineTour, NumbersAreShownWhereTheyHaveRoom) {
  const Trace trace = tour({});
  Playhead playhead(trace);
  const Figure figure = figure_of(trace, playhead, {6, 0});
  const auto shows_numbers = [&](double width, const std::set<Slot>& slots) {
    Look look;
    look.width = width;
    look.height = 720;
    look.slots = slots;
    return std::ranges::any_of(lay_out(figure, look).shapes, [](const Shape& shape) {
      const TextShape* text = std::get_if<TextShape>(&shape.what);
      return shape.slot == Slot::drawing && text && text->text.starts_with("λ");
    });
  };
  const std::set<Slot> all{all_slots.begin(), all_slots.end()};
  const std::set<Slot> drawing{Slot::title, Slot::drawing, Slot::sentence, Slot::footer};
  EXPECT_TRUE(shows_numbers(1280, all));
  EXPECT_FALSE(shows_numbers(960, all));
  EXPECT_TRUE(shows_numbers(960, drawing));
  EXPECT_FALSE(shows_numbers(720, all));
}

TEST(PipelineTour, RefusesWhatThereIsNot) {
  const auto complaint = [](const Given& given) {
    try {
      tour(given);
    } catch (const ArgumentError& error) {
      return error.parameter + ": " + error.what();
    }
    return std::string("none");
  };
  EXPECT_EQ(complaint({{"face", "28"}}), "face: expected a face from 0 to 27, found 28");
  EXPECT_EQ(complaint({{"pixel", "50,3"}}), "pixel: expected a pixel inside the 50 × 35 picture, found 50,3");
  EXPECT_EQ(complaint({{"eye", "1,1,1"}, {"target", "1,1,1"}}),
            "eye: expected an eye apart from the target, found both in one place");
  EXPECT_THAT(complaint({{"near", "0"}}),
              testing::StartsWith("near: expected a depth above 0 and before the far plane"));
}

}  // namespace
}  // namespace gradus
