// What a figure is to show, as the command line says it: read, and written back in one spelling.

#include <gtest/gtest.h>

#include <random>

#include "cli/command_line/errors.hpp"
#include "cli/command_line/inputs.hpp"
#include "cli/figures/figure_spec.hpp"
#include "request/names.hpp"
#include "request/takes.hpp"
#include "support/complaint.hpp"
#include "support/sanitized.hpp"

namespace gradus::cli {
namespace {

using test::complaint;

// --- What a figure is to show --------------------------------------------------------------------

/// "gradus figure bresenham_line --step 4" as the command line gives it.
FigureSpec spec_of(const std::vector<std::string>& words) {
  const Request request = read_request(words);
  return read_spec(request, read_inputs(*request.topic, request.arguments).arguments);
}

std::string canonical_command(std::vector<std::string> flags) {
  flags.insert(flags.begin(), {"figure", "bresenham_line"});
  return command_of(spec_of(flags));
}

/// What the command says after the topic's own inputs.
std::string canonical_flags(const std::vector<std::string>& flags) {
  const std::string line = canonical_command(flags), plain = canonical_command({});
  EXPECT_TRUE(line.starts_with(plain)) << line;
  return line.size() > plain.size() ? line.substr(plain.size() + 1) : "";
}

TEST(FigureSpecs, SayOnlyWhatDiffersFromTheDefaults) {
  for (const std::vector<std::string>& flags :
       std::vector<std::vector<std::string>>{{"--size", "16:9"},
                                             {"--size", "1280px X 720px"},
                                             {"--theme", "light"},
                                             {"--layout", "slide"},
                                             {"--scale", "1.0"},
                                             {"--svg-text", "outlines"},
                                             {"--language", "en"},
                                             {"--label", "p=p"},
                                             {"--slots", "title,drawing,listing,table,sentence,footer"},
                                             {"--paper", "a4"},
                                             {"--seconds-per-step", "1.50"},
                                             {"--hold-last", "3"},
                                             {"--fps", "25"},
                                             {"--loop", "0"}}) {
    EXPECT_EQ(canonical_flags(flags), "") << flags[0] << " " << flags[1];
  }
}

TEST(FigureSpecs, HaveOneSpelling) {
  EXPECT_EQ(canonical_flags({"--size", "12.50cm X 80MM", "--view", " -1, 0,8 , 4", "--background", "White"}),
            "--size 12.5cmx80mm --view -1,0,8,4 --background '#ffffff'");
  EXPECT_EQ(canonical_flags({"--label", "p=d", "--label", "E= O ", "--label", "p=q"}),
            "--label E=O --label p=q");
  EXPECT_EQ(canonical_flags({"--slots", "table,drawing", "--no-title"}), "--slots drawing,table");
  EXPECT_EQ(canonical_flags({"--no-title"}), "--slots drawing,listing,table,sentence,footer");
  EXPECT_EQ(canonical_flags({"--y", "up"}), "--y up") << "a topic may have it the other way";
}

TEST(FigureSpecs, SizesAreInPixels) {
  const auto size = [](const char* text) {
    const Look look = spec_of({"figure", "bresenham_line", "--size", text}).look;
    return std::pair{look.width, look.height};
  };
  EXPECT_EQ(size("4:3"), std::pair(960.0, 720.0));
  EXPECT_EQ(size("9:16"), std::pair(720.0, 1280.0));
  EXPECT_EQ(size("1:1"), std::pair(720.0, 720.0));
  EXPECT_NEAR(size("12cmx8cm").first, 12 / 2.54 * 96, 1e-9);
  EXPECT_NEAR(size("120mm x 80mm").second, 8 / 2.54 * 96, 1e-9);
  EXPECT_EQ(size("5inx4in"), std::pair(480.0, 384.0));
  EXPECT_EQ(size("640x5in"), std::pair(640.0, 480.0));
}

TEST(FigureSpecs, PicturesHaveAnEnd) {
  EXPECT_EQ(spec_of({"figure", "bresenham_line", "--size", "8192x4096", "--scale", "2"}).scale, 2);
  EXPECT_EQ(complaint([] { canonical_command({"--size", "8192x4096", "--scale", "2.01"}); }),
            "--scale: expected at most 16384 pixels per side, found 16466 x 8233");
}

TEST(FigureSpecs, GroundsKeepTextsLegible) {
  EXPECT_EQ(canonical_flags({"--background", "none"}), "--background none");
  const std::string found = complaint([] { canonical_command({"--background", "#777777"}); });
  EXPECT_TRUE(found.starts_with("--background: expected a ground on which the ")) << found;
  EXPECT_EQ(canonical_flags({"--background", "#112233", "--theme", "dark"}),
            "--theme dark --background '#112233'");
}

TEST(FigureSpecs, ALaterFlagTakesThePlaceOfTheOneBefore) {
  FigureSpec spec = spec_of({"figure", "bresenham_line", "--steps", "1-4", "--theme", "dark", "--label",
                             "p=d", "--no-title", "--scale", "2", "--background", "none"});
  apply_flags(spec, read_request({"again", "x.svg", "--step", "2", "--theme", "light", "--label", "p=p",
                                  "--slots", "title", "--scale", "1", "--background", "#ffffff"}));
  EXPECT_EQ(command_of(spec),
            canonical_command({"--step", "2", "--slots", "title", "--background", "#ffffff"}));
  EXPECT_FALSE(spec.transparent);
}

TEST(FigureSpecs, WhatNotationsMayHaveOtherwiseIsSaidWhereItWasAskedFor) {
  const std::string topic = "cohen_sutherland_2d";
  EXPECT_EQ(command_of(spec_of({"figure", topic})).find("--code-bits"), std::string::npos);
  for (const std::string bits : {"TBRL", "LRBT"}) {
    const std::string command = command_of(spec_of({"figure", topic, "--code-bits", bits}));
    EXPECT_NE(command.find("--code-bits " + bits), std::string::npos) << command;
  }
}

/// A command line of random flags, each with a value that it takes.
std::vector<std::string> random_flags(std::mt19937& random) {
  const std::vector<std::vector<std::string>> choices{
      {"--slots", "drawing", "title,table", "sentence, drawing ,footer", "LISTING"},
      {"--theme", "dark", "greyscale", "High-Contrast", "light"},
      {"--size", "4:3", "1:1", "640x480", "12cmx8cm", "100.5mmX4.7in", "16:9", "333.25x444"},
      {"--layout", "handout", "slide"},
      {"--view", "0,0,3,2", "-4,-5,7,8", "1, 1, 2, 2"},
      {"--y", "up", "down"},
      {"--background", "none", "#ffffff", "#000000", "white"},
      {"--scale", "2", "0.5", "1.25", "1"},
      {"--svg-text", "text", "outlines"},
      {"--language", "de", "en"},
      {"--title", "It's a \"title\" -- with $x & <y>", "Grüße", "-5 ≤ x", "--no-title", " a  b "},
      {"--caption", "See page 7.", "--x", "100% `ls`", "Ω → ∞"},
      {"--handout", "2x3", "1x1", "4 X 6"},
      {"--paper", "letter", "a4"},
      {"--seconds-per-step", "0.04", "1.5", "2.25"},
      {"--hold-last", "5", "3", "0.5"},
      {"--transition", "none", "0.3", "0.04", "None"},
      {"--fps", "30", "25", "60"},
      {"--loop", "0", "1", "65535"},
      {"--label", "p=d", "NE=T", "E = go east", "x=--x", "k=i=j", "dx=Δx"}};
  std::vector<std::string> flags;
  for (const std::vector<std::string>& choice : choices) {
    if (random() % 3 != 0) continue;
    // As --flag=value: that is how a value that looks like a flag is given
    flags.push_back(choice[0] + "=" + choice[1 + random() % (choice.size() - 1)]);
  }
  if (random() % 2 != 0) flags.push_back("--crop");
  if (random() % 4 == 0)
    flags.push_back("--step=" + std::to_string(random() % 8));
  else if (random() % 2 == 0)
    flags.push_back(random() % 2 != 0 ? "--steps=auto" : "--steps= 0 , 2-6/2 ");
  return flags;
}

TEST(FigureSpecs, CommandsReadBackAsThemselves) {
  std::mt19937 random(7);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < test::thinned(3000, 50); ++i) {
    std::vector<std::string> words = random_flags(random);
    words.insert(words.begin(), {"figure", "bresenham_line"});
    FigureSpec spec;
    try {
      spec = spec_of(words);
    } catch (const UsageError&) {
      continue;  // a ground that hides the theme's letters
    }
    ++kept;
    const std::string command = command_of(spec);
    const auto read = shell_words(command);
    ASSERT_TRUE(read) << command;
    const FigureSpec again = spec_of({read->begin() + 1, read->end()});
    ASSERT_EQ(command_of(again), command);
    ASSERT_EQ(again.look.slots, spec.look.slots) << command;
    ASSERT_EQ(std::pair(again.look.width, again.look.height), std::pair(spec.look.width, spec.look.height));
    ASSERT_EQ(again.look.layout, spec.look.layout) << command;
    ASSERT_EQ(again.look.crop, spec.look.crop) << command;
    ASSERT_EQ(again.look.view.has_value(), spec.look.view.has_value()) << command;
    if (spec.look.view) {
      ASSERT_EQ(again.look.view->lower, spec.look.view->lower);
      ASSERT_EQ(again.look.view->upper, spec.look.view->upper);
    }
    ASSERT_EQ(again.look.y_up, spec.look.y_up) << command;
    ASSERT_EQ(again.look.title, spec.look.title) << command;
    ASSERT_EQ(again.caption, spec.caption) << command;
    ASSERT_EQ(again.theme, spec.theme) << command;
    ASSERT_EQ(again.transparent, spec.transparent) << command;
    ASSERT_EQ(again.ground.has_value(), spec.ground.has_value()) << command;
    if (spec.ground) ASSERT_EQ(again.ground->hex, spec.ground->hex) << command;
    ASSERT_EQ(again.scale, spec.scale) << command;
    ASSERT_EQ(again.svg_text, spec.svg_text) << command;
    ASSERT_EQ(again.wording.language().code(), spec.wording.language().code()) << command;
    ASSERT_EQ(again.wording.labels().size(), spec.wording.labels().size()) << command;
    ASSERT_EQ(again.handout.has_value(), spec.handout.has_value()) << command;
    if (spec.handout) {
      ASSERT_EQ(again.handout->columns, spec.handout->columns) << command;
      ASSERT_EQ(again.handout->rows, spec.handout->rows) << command;
    }
    ASSERT_EQ(again.paper.name, spec.paper.name) << command;
    ASSERT_EQ(again.film.seconds_per_step, spec.film.seconds_per_step) << command;
    ASSERT_EQ(again.film.hold_last, spec.film.hold_last) << command;
    ASSERT_EQ(again.film.transition, spec.film.transition) << command;
    ASSERT_EQ(again.film.fps, spec.film.fps) << command;
    ASSERT_EQ(again.film.loop, spec.film.loop) << command;
    ASSERT_EQ(again.step, spec.step) << command;
    ASSERT_EQ(again.milestones, spec.milestones) << command;
    ASSERT_EQ(text_of(again.steps), text_of(spec.steps)) << command;
  }
  EXPECT_GT(kept, test::thinned(2000, 50));
}

}  // namespace
}  // namespace gradus::cli
