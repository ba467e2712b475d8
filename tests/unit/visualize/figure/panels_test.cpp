// Several drawings on one sheet: which steps stand together, what is asked for, and where it all lies.

#include "figure/panels.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "cli/command_line/errors.hpp"
#include "cli/command_line/inputs.hpp"
#include "cli/figures/compare.hpp"
#include "cli/figures/figure_file.hpp"
#include "cli/figures/panel_sheets.hpp"
#include "cli/lecture/lecture.hpp"
#include "figure/which_steps.hpp"
#include "support/example_traces.hpp"
#include "support/sheets.hpp"

namespace gradus {
namespace {

using cli::Format;
using testing::HasSubstr;

// --- What is asked for -------------------------------------------------------------------------------------

std::string complaint_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const UsageError& error) {
    return error.what();
  } catch (const ArgumentError& error) {
    return complaint_of(error);
  }
  return "";
}

OtherSide beside(const char* topic, const std::string& text, std::map<std::string, std::string> given = {}) {
  return cli::other_side(test::topic(topic), cli::read_inputs(test::topic(topic), given).arguments, text);
}

TEST(Compare, TakesAMethodATopicOrInputs) {
  const OtherSide method = beside("bresenham_line", "first-octant", {{"to", "2,4"}});
  EXPECT_EQ(method.arguments.text("method"), "first_octant");
  EXPECT_EQ(method.arguments.text("to"), "2,4");
  EXPECT_EQ(method.text, "first_octant");
  const OtherSide other =
      beside("cohen_sutherland_2d", "liang_barsky", {{"line", "-3,-8,13,16"}, {"window", "0,0,10,10"}});
  EXPECT_EQ(other.topic->name, "liang_barsky");
  EXPECT_EQ(other.arguments.text("line"), "-3,-8,13,16");
  EXPECT_EQ(other.text, "liang_barsky");
  const OtherSide inputs = beside("parallel", "--receding 45,1");
  EXPECT_EQ(inputs.arguments.text("receding"), "45,1");
  EXPECT_EQ(beside("parallel", inputs.text).text, inputs.text) << "its own text makes it again";
  const OtherSide exact = beside("perspective", "parallel");
  EXPECT_EQ(exact.topic->name, "parallel") << "not the method parallel_by_plane, which it begins";
  EXPECT_EQ(beside("perspective", "parallel_by").arguments.text("method"), "parallel_by_plane");
  const OtherSide both = beside("cohen_sutherland_2d", "liang_barsky --method correctly_rounded");
  EXPECT_EQ(both.arguments.text("method"), "correctly_rounded");
}

TEST(Compare, RefusesWhatIsNoOtherSide) {
  const auto said = [](const char* topic, const std::string& text,
                       std::map<std::string, std::string> given = {}) {
    return complaint_of([&] { beside(topic, text, given); });
  };
  EXPECT_THAT(said("bresenham_line", "bananas"), HasSubstr("--compare: expected a method of bresenham_line"));
  EXPECT_THAT(said("bresenham_line", ""), HasSubstr("--compare: expected a method, a topic"));
  EXPECT_THAT(said("bresenham_line", "flood_fill", {{"to", "2,4"}}),
              HasSubstr("--compare: expected a topic that takes --from as bresenham_line does"));
  EXPECT_THAT(said("bresenham_line", "--theme dark"), HasSubstr("--theme"));
  EXPECT_THAT(said("bresenham_line", "--to nowhere"), HasSubstr("--to: expected"));
  EXPECT_THAT(said("flood_fill", "--maze some/file"), HasSubstr("expected inputs that are no files"));
  EXPECT_THAT(said("bresenham_line", "first_octant 'open"), HasSubstr("--compare: expected"));
}

cli::FigureSpec spec_of(const std::string& topic, std::map<std::string, std::string> flags,
                        std::map<std::string, std::string> given = {}) {
  cli::Request request;
  request.topic = &test::topic(topic);
  request.flags = std::move(flags);
  return cli::read_spec(request, cli::read_inputs(*request.topic, given).arguments);
}

TEST(Panels, AreTwoToEightStepsOrThePhases) {
  for (const char* wrong : {"", "1", "1,2,3,4,5,6,7,8,9", "0-8", "many", "phase", "1;4"}) {
    EXPECT_THAT(complaint_of([&] { spec_of("bresenham_line", {{"panels", wrong}}); }),
                HasSubstr("--panels: expected"))
        << wrong;
  }
  EXPECT_EQ(spec_of("bresenham_line", {{"panels", "1,4,7"}}).said.at("panels"), "1,4,7");
  EXPECT_EQ(spec_of("bresenham_line", {{"panels", "Phases"}}).said.at("panels"), "phases");
  EXPECT_THAT(complaint_of([] { spec_of("bresenham_line", {{"panels", "1,4"}, {"step", "3"}}); }),
              HasSubstr("--panels: expected either this or --step, found both"));
  EXPECT_THAT(complaint_of([] { spec_of("bresenham_line", {{"panels", "1,4"}, {"compare", "dda"}}); }),
              HasSubstr("--panels: expected either this or --compare, found both"));
  const cli::FigureSpec spec = spec_of("bresenham_line", {{"panels", "1,99"}});
  const Takes takes(*spec.topic, spec.arguments);
  EXPECT_THAT(complaint_of([&] { cli::panel_steps(spec, takes); }), HasSubstr("has steps 0..7"));
}

TEST(Panels, OfPhasesEndEachPhase) {
  const Trace trace = test::trace_of("sutherland_hodgman");
  std::vector<std::string> phases;
  for (const StepNumber number : phase_steps(trace, 6)) {
    const TraceStep& step = trace.steps[index_of(trace, number)];
    phases.push_back(step.phase + ": " + step.note);
  }
  EXPECT_THAT(phases, testing::ElementsAre("left border: 8 → 9 corners", "right border: 9 → 10 corners",
                                           "bottom border: 10 → 9 corners", "top border: 9 → 9 corners"));
  EXPECT_EQ(phase_steps(test::trace_of("pipeline"), 8).size(), 8u) << "a panel each";
  EXPECT_EQ(phase_steps(test::trace_of("pipeline"), 6).size(), 6u) << "of eight stages six";
}

TEST(Panels, EveryTopicHasSomeForItsPhases) {
  for (const TopicEntry* topic : catalogue()) {
    const std::size_t count = phase_steps(test::trace_of(topic->name), 8).size();
    EXPECT_GE(count, 2u) << topic->name;
    EXPECT_LE(count, 8u) << topic->name;
  }
}

// --- The sheets --------------------------------------------------------------------------------------------

Sheet sheet_for(const cli::FigureSpec& spec) {
  Takes takes(*spec.topic, spec.arguments, spec.wording, spec.listing, cli::beside_of(spec));
  return cli::sheet_of(spec, takes, cli::shown_step(spec, takes));
}

std::vector<Box> frames_in(const Sheet& sheet) {
  std::vector<Box> frames;
  for (const Shape& shape : sheet.shapes) {
    const RectShape* rect = std::get_if<RectShape>(&shape.what);
    // "panel 2 frame"; an overview inside a panel has a frame, too
    const bool outermost = shape.id.starts_with("panel ") && shape.id.ends_with(" frame") &&
                           std::ranges::count(shape.id, ' ') == 2;
    if (rect && outermost && shape.slot == Slot::drawing) frames.push_back(rect->box);
  }
  return frames;
}

TEST(Panels, LieApartOnTheSheetWithTheirTextsApart) {
  const std::vector<cli::FigureSpec> specs{
      spec_of("sutherland_hodgman", {{"panels", "phases"}}),
      spec_of("cohen_sutherland_2d", {{"panels", "phases"}}, {{"line", "-3,-8,13,16"}}),
      spec_of("bresenham_line", {{"panels", "1,3,4,5,6,7"}}),
      spec_of("pipeline", {{"panels", "phases"}}),
      spec_of("cohen_sutherland_2d", {{"compare", "liang_barsky"}}, {{"line", "-3,-8,13,16"}}),
      spec_of("bresenham_line", {{"compare", "first_octant"}}, {{"to", "2,4"}}),
      spec_of("parallel", {{"compare", "--receding 45,0.5"}}, {{"receding", "45,1"}}),
  };
  for (cli::FigureSpec spec : specs) {
    for (const auto& [width, height] :
         {std::pair{1280.0, 720.0}, {960.0, 720.0}, {720.0, 720.0}, {720.0, 1280.0}, {640.0, 360.0}}) {
      for (const Layout layout : {Layout::slide, Layout::handout}) {
        spec.look.width = width;
        spec.look.height = height;
        spec.look.layout = layout;
        SCOPED_TRACE(fmt::format("{} {} x {}", spec.topic->name, width, height));
        Sheet sheet;
        if (const std::string refused = complaint_of([&] { sheet = sheet_for(spec); }); !refused.empty()) {
          EXPECT_THAT(refused, HasSubstr("--size: expected a size with room for"));
          EXPECT_EQ(width, height) << "a square slide alone may be too small";
          continue;
        }
        const std::vector<Box> frames = frames_in(sheet);
        ASSERT_GE(frames.size(), 2u);
        for (std::size_t i = 0; i < frames.size(); ++i) {
          EXPECT_GE(frames[i].x, 0);
          EXPECT_LE(frames[i].right(), width);
          EXPECT_LE(frames[i].bottom(), height);
          EXPECT_NEAR(frames[i].width, frames[0].width, 1e-6) << "the same room for all";
          EXPECT_NEAR(frames[i].height, frames[0].height, 1e-6);
        }
        test::expect_texts_apart(sheet);
      }
    }
  }
}

/// Whether the sheet has a shape of this id.
bool has(const Sheet& sheet, std::string_view id) {
  return std::ranges::any_of(sheet.shapes, [id](const Shape& shape) { return shape.id == id; });
}

TEST(Compare, ShowsTheFirstDifferenceInBothDrawings) {
  const cli::FigureSpec spec = spec_of("bresenham_circle", {{"compare", "late_update"}}, {{"radius", "7"}});
  Takes takes(*spec.topic, spec.arguments, spec.wording, spec.listing, cli::beside_of(spec));
  const StepNumber parting = cli::compared_step(spec, takes);
  EXPECT_EQ(cli::shown_step(spec, takes), parting);
  const Sheet sheet = cli::sheet_of(spec, takes, parting);
  for (const char* id : {"panel 1 ring", "panel 2 ring", "panel 1 note", "panel 2 note"})
    EXPECT_TRUE(has(sheet, id)) << id;
  EXPECT_FALSE(has(cli::sheet_of(spec, takes, {parting.step - 1, 0}), "panel 1 ring"));
}

TEST(Compare, OfAPainterPaintsUpToWhereTheOrdersDiffer) {
  for (const char* method : {"centroid", "mean_depth", "descending_mean_z"}) {
    const cli::FigureSpec spec = spec_of("painter", {{"compare", method}});
    Takes takes(*spec.topic, spec.arguments, spec.wording, spec.listing, cli::beside_of(spec));
    const StepPair pair = pair_with(takes.alignment(), cli::compared_step(spec, takes));
    const auto step_of = [](const Trace& trace, StepNumber number) {
      return trace.steps[index_of(trace, number)];
    };
    const TraceStep right = step_of(takes.opening(), pair.a),
                    wrong = step_of(takes.beside()->opening(), pair.b);
    EXPECT_EQ(right.type, "Drawn") << method;
    EXPECT_EQ(wrong.type, "Drawn") << method;
    EXPECT_EQ(right.key, wrong.key) << method << ": so many are painted";
    EXPECT_TRUE(tells_otherwise(right, wrong)) << method << ": another one now";
  }
}

/// Of the first shape with this id.
Box box_of(const Sheet& sheet, std::string_view id) {
  const auto found = std::ranges::find(sheet.shapes, id, &Shape::id);
  return found == sheet.shapes.end() ? Box{} : test::extent_of(*found);
}

TEST(Compare, ShowsWhatARunThatEndsEarlyLeavesOut) {
  // Both panels were the same step, the last one that the runs have in common
  const cli::FigureSpec spec = spec_of("mesh_structures", {{"compare", "half_edge"}},
                                       {{"method", "first_fan_only"}, {"mesh", "bow_tie"}});
  const Sheet sheet = sheet_for(spec);
  std::set<std::string> sentences;
  for (const Shape& shape : sheet.shapes) {
    const TextShape* text = std::get_if<TextShape>(&shape.what);
    if (text && shape.slot == Slot::sentence) sentences.insert(text->text);
  }
  // The one says that the walk is over, the other that it goes on to a face of the other fan
  const auto says = [&](const char* word) {
    return std::ranges::any_of(sentences, [&](const std::string& s) { return s.find(word) != s.npos; });
  };
  EXPECT_TRUE(says("once"));
  EXPECT_TRUE(says("f3"));
}

TEST(Compare, RingsWhatDiffersAndNoText) {
  std::size_t rings = 0;
  for (const TopicEntry* topic : catalogue()) {
    for (const Method& method : topic->methods) {
      if (method.standing != Standing::faulty) continue;
      SCOPED_TRACE(topic->name + " beside " + method.name);
      cli::FigureSpec spec;
      // Some exhibits have inputs of their own, which the taught method lacks
      if (!complaint_of([&] { spec = spec_of(topic->name, {{"compare", method.name}}); }).empty()) continue;
      const Sheet sheet = sheet_for(spec);
      for (const std::string panel : {"panel 1 ", "panel 2 "}) {
        if (!has(sheet, panel + "ring")) continue;
        ++rings;
        const Box ring = box_of(sheet, panel + "ring");
        for (const Shape& shape : sheet.shapes) {
          const TextShape* text = std::get_if<TextShape>(&shape.what);
          if (!text || text->is_rim() || shape.slot != Slot::drawing) continue;
          const Box box = text->box();
          const dvec2 centre{ring.x + ring.width / 2, ring.y + ring.height / 2};
          const dvec2 corner = glm::max(glm::abs(dvec2(box.x, box.y) - centre),
                                        glm::abs(dvec2(box.right(), box.bottom()) - centre));
          const bool inside_of_it = glm::length(corner) <= ring.width / 2;
          const dvec2 nearest = glm::clamp(centre, {box.x, box.y}, {box.right(), box.bottom()});
          EXPECT_TRUE(inside_of_it || glm::distance(centre, nearest) >= ring.width / 2) << text->text;
        }
      }
    }
  }
  EXPECT_GT(rings, 20u);
}

TEST(Compare, OfTwoRightRunsShowsTheirResultsWithoutARing) {
  const cli::FigureSpec specs[] = {
      spec_of("cohen_sutherland_2d", {{"compare", "liang_barsky"}}),
      spec_of("parallel", {{"compare", "--receding 45,0.5"}}, {{"receding", "45,1"}}),
      spec_of("octree_order", {{"compare", "back_to_front"}})};
  for (const cli::FigureSpec& spec : specs) {
    SCOPED_TRACE(spec.topic->name);
    Takes takes(*spec.topic, spec.arguments, spec.wording, spec.listing, cli::beside_of(spec));
    EXPECT_EQ(cli::compared_step(spec, takes), (StepNumber{takes.last(), 0}));
    EXPECT_FALSE(has(cli::sheet_of(spec, takes, {takes.last(), 0}), "panel 1 ring"));
  }
}

std::string text_in(const Sheet& sheet, std::string_view id) {
  const TextShape* found = test::find_text(sheet, id);
  return found ? found->text : "";
}

TEST(Compare, OfTwoRightRunsSaysWhatTheyTook) {
  const auto counts = [](const cli::FigureSpec& spec) {
    const Sheet sheet = sheet_for(spec);
    std::vector<std::string> texts;
    for (const int panel : {1, 2}) {
      for (int i = 1; has(sheet, fmt::format("panel {} count {}", panel, i)); ++i) {
        const std::string id = fmt::format("panel {} count {}", panel, i);
        texts.push_back(text_in(sheet, id) + " " + text_in(sheet, id + " value"));
      }
    }
    test::expect_texts_apart(sheet);
    return texts;
  };
  // The default line crosses all four borders
  EXPECT_THAT(counts(spec_of("cohen_sutherland_2d", {{"compare", "liang_barsky"}})),
              testing::IsSupersetOf({"cuts 4", "borders tested 4"}));
  // Nine steps along x, a test each
  EXPECT_THAT(counts(spec_of("bresenham_line", {{"compare", "dda"}}, {{"to", "9,4"}})),
              testing::IsSupersetOf({"tests 9", "divisions 1", "additions 9", "roundings 9"}));
}

TEST(Compare, CountsAreOfTheWholeRun) {
  const Trace dda = trace_of(*find_entry("bresenham_line"), {{"method", "dda"}, {"to", "9,4"}});
  EXPECT_THAT(dda.counts, testing::ElementsAre("divisions: 1", "additions: 9", "roundings: 9"));
  for (const char* method : {"depth_first", "breadth_first"}) {
    const Trace trace = trace_of(*find_entry("flood_fill"), {{"method", method}});
    const std::set<std::uint64_t> painted = [&] {
      std::set<std::uint64_t> keys;
      for (const ivec2 p : trace.pixels) keys.insert(key_of(p));
      return keys;
    }();
    ASSERT_FALSE(trace.counts.empty()) << method;
    EXPECT_EQ(trace.counts.front(), fmt::format("painted: {}", painted.size())) << method;
  }
}

TEST(Panels, OfAMazeShowAllOfIt) {
  const Sheet sheet = sheet_for(spec_of("flood_fill", {{"panels", "phases"}}));
  EXPECT_FALSE(has(sheet, "panel 1 overview frame"));
  for (int i = 1; i <= 6; ++i) EXPECT_TRUE(has(sheet, fmt::format("panel {} cell 9,6", i))) << i;
}

TEST(Panels, OfAMazeLeaveItsShelfOut) {
  const Sheet sheet = sheet_for(spec_of("flood_fill", {{"panels", "phases"}}));
  for (const Shape& shape : sheet.shapes) EXPECT_THAT(shape.id, testing::Not(HasSubstr("shelf"))) << shape.id;
  EXPECT_TRUE(has(sheet, "panel 6 text 1,1")) << "so that its cells have room for their numbers";
}

TEST(Panels, AreCalledByWhatTellsThemApart) {
  const Sheet faces = sheet_for(spec_of("z_buffer", {{"panels", "2,4,6"}}));
  EXPECT_EQ(text_in(faces, "panel 1 heading"), "A drawn");
  EXPECT_EQ(text_in(faces, "panel 1 note"), "step 2");
  EXPECT_EQ(text_in(faces, "panel 3 heading"), "C drawn");
  // Not all of these borders are another one
  const Sheet borders = sheet_for(spec_of("liang_barsky", {{"panels", "1,2,3,3"}}));
  EXPECT_EQ(text_in(borders, "panel 1 heading"), "step 1");
  const Sheet apart = sheet_for(spec_of("liang_barsky", {{"panels", "1,2,3"}}));
  EXPECT_EQ(text_in(apart, "panel 1 heading"), "left");
  EXPECT_THAT(text_in(apart, "panel 1 note"), testing::StartsWith("step 1"));
}

TEST(Panels, HaveTheGoalOfTheirMethod) {
  const std::string all = test::trace_of("bezier_curve", {}).goal,
                    chords = test::trace_of("bezier_curve", {{"method", "flatten"}}).goal;
  EXPECT_NE(chords, all);
  EXPECT_NE(chords.find("chords"), std::string::npos) << chords;
  EXPECT_EQ(test::trace_of("bezier_curve", {{"method", "split"}}).goal, all);
}

TEST(Panels, NotesSayWordsAsWords) {
  const auto note = [](const char* topic, const char* panels, const char* language) {
    return text_in(sheet_for(spec_of(topic, {{"panels", panels}, {"language", language}})), "panel 1 note");
  };
  EXPECT_THAT(note("area_sampling", "phases", "en"), testing::StartsWith("corners: 4"));
  EXPECT_THAT(note("area_sampling", "phases", "de"), testing::StartsWith("Ecken: 4"));
  EXPECT_THAT(note("perspective", "phases", "en"), HasSubstr("d/z = "));
}

TEST(Panels, NotesOfRoundedNumbersAreWrittenAsTextsAre) {
  // A note that was cut in the middle of an unseen mark could not be drawn
  const Trace trace = test::trace_of("bezier_curve", {{"method", "overwritten"}});
  bool rounded = false;
  for (const TraceStep& step : trace.steps) {
    EXPECT_EQ(step.note.find("\uf0a0"), std::string::npos) << step.note;
    rounded = rounded || step.note.find("≈") != std::string::npos;
  }
  EXPECT_TRUE(rounded);
}

TEST(Panels, OfOnePhaseAreItsStepsWithNotes) {
  const Sheet faces = sheet_for(spec_of("z_buffer", {{"panels", "phases"}}));
  EXPECT_EQ(text_in(faces, "panel 1 heading"), "A drawn");
  EXPECT_EQ(frames_in(faces).size(), 3u);
  // What was tested, and not the value that it became
  const Sheet line = sheet_for(spec_of("bresenham_line", {{"panels", "phases"}}));
  EXPECT_EQ(text_in(line, "panel 1 heading"), "p = −1 < 0 → E");
  EXPECT_EQ(text_in(line, "panel 1 note"), "step 1");
  // One of each kind, where there are three or more
  const Sheet triangles = sheet_for(spec_of("triangle_coverage", {{"panels", "phases"}}));
  EXPECT_EQ(frames_in(triangles).size(), 4u);
  EXPECT_EQ(text_in(triangles, "panel 1 heading"), "three half-planes");
}

TEST(Panels, HaveALegendOfWhatIsSeenInThem) {
  // The section along a row lies beside the grid, where the panels are cut
  const Sheet faces = sheet_for(spec_of("z_buffer", {{"panels", "2,4,6"}}));
  EXPECT_TRUE(has(faces, "legend text input"));
  EXPECT_FALSE(has(faces, "legend text accepted")) << "its depths so far";
}

TEST(Panels, HaveOneLegendOfWhatAnyOfThemShows) {
  const auto says = [](const Sheet& sheet, const std::string& entry) {
    return std::ranges::any_of(sheet.shapes, [&](const Shape& shape) {
      const TextShape* text = std::get_if<TextShape>(&shape.what);
      return text && shape.id.starts_with("legend text") && text->text == entry;
    });
  };
  // The last point has no pixel, the others lie inside
  const Sheet points = sheet_for(spec_of("viewport", {{"panels", "phases"}}));
  EXPECT_TRUE(says(points, "its pixel"));
  EXPECT_TRUE(says(points, "outside"));
  // Each run has its own
  const Sheet runs = sheet_for(spec_of("cohen_sutherland_2d", {{"compare", "liang_barsky"}}));
  for (const char* entry : {"window", "given ends", "in the window", "enters", "leaves"})
    EXPECT_TRUE(says(runs, entry)) << entry;
  // What is left out where drawings are many: the frame of the stage that is told
  EXPECT_FALSE(says(sheet_for(spec_of("pipeline", {{"panels", "6,7,8"}})), "removed"));
}

TEST(Panels, OfTheViewportAreFilledByBothFrames) {
  const Sheet sheet = sheet_for(spec_of("viewport", {{"panels", "phases"}}));
  double widths = 0;
  for (const char* frame : {"panel 1 window", "panel 1 picture"}) {
    const auto found = std::ranges::find(sheet.shapes, frame, &Shape::id);
    ASSERT_NE(found, sheet.shapes.end()) << frame;
    widths += extents_of(*found).width;
  }
  EXPECT_GE(widths, 0.5 * frames_in(sheet)[0].width) << "without the pixel that is enlarged below them";
}

TEST(Panels, LeaveOutWhatStandsAside) {
  // The star below its solid fills a panel from side to side, without the levels beside it
  const Sheet sheet = sheet_for(spec_of("subdivision_surface", {{"panels", "phases"}}));
  ASSERT_EQ(frames_in(sheet).size(), 4u);
  for (const Shape& shape : sheet.shapes)
    EXPECT_THAT(shape.id, testing::Not(HasSubstr("aside "))) << shape.id;
  const auto picture = std::ranges::find(sheet.shapes, "panel 4 a a", &Shape::id);
  ASSERT_NE(picture, sheet.shapes.end());
  EXPECT_GE(extents_of(*picture).width, 0.7 * frames_in(sheet)[3].width);
  // Where one drawing is all there is, they stand beside it
  EXPECT_TRUE(has(sheet_for(spec_of("subdivision_surface", {})), "aside b a"));
}

TEST(Panels, SayEachItsOwnWhereThatTakesNothingOfThem) {
  EXPECT_TRUE(has(sheet_for(spec_of("sutherland_hodgman", {{"panels", "phases"}})), "panel 1 sentence 1"));
  const Sheet pipeline = sheet_for(spec_of("pipeline", {{"panels", "phases"}}));
  EXPECT_FALSE(has(pipeline, "panel 1 sentence 1"));
  EXPECT_TRUE(has(pipeline, "sentence 1"));
}

TEST(Compare, IsSaidByTheCanonicalCommand) {
  const cli::FigureSpec spec =
      spec_of("parallel", {{"compare", "--receding 45,0.5"}}, {{"receding", "45,1"}});
  EXPECT_THAT(cli::command_of(spec), HasSubstr("--compare='--receding 45,0.5'"));
  EXPECT_THAT(cli::command_of(spec_of("sutherland_hodgman", {{"panels", "phases"}})),
              HasSubstr("--panels phases"));
}

}  // namespace
}  // namespace gradus
