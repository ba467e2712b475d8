// The parts of the command that need no topic: names, steps, terminal. The command as a whole is tested by
// tests/golden/cli_test.py.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <random>

#include "cli/figures/figure_file.hpp"
#include "cli/terminal/terminal.hpp"
#include "request/names.hpp"
#include "request/takes.hpp"
#include "support/complaint.hpp"

namespace gradus::cli {
namespace {

using test::complaint;

// --- Names ---------------------------------------------------------------------------------------

const std::vector<std::string> topics{"bresenham_line", "bresenham_circle", "flood_fill", "bsp_tree"};

TEST(Names, AreFolded) {
  EXPECT_EQ(folded("Bresenham-Line"), "bresenham_line");
  EXPECT_EQ(hyphened("x_axis"), "x-axis");
}

TEST(Names, EditDistance) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("line", "line"), 0u);
  EXPECT_EQ(edit_distance("lien", "line"), 1u) << "neighbours swapped";
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
}

TEST(Names, EditDistanceIsAMetricOnShortWords) {
  std::mt19937 random(3);
  const auto word = [&random] {
    std::string text(random() % 5, 'a');
    for (char& c : text) c = static_cast<char>('a' + random() % 2);
    return text;
  };
  int tried = 0;
  for (; tried < 2000; ++tried) {
    const std::string a = word(), b = word();
    EXPECT_EQ(edit_distance(a, b), edit_distance(b, a)) << a << " " << b;
    EXPECT_EQ(edit_distance(a, b) == 0, a == b);
    EXPECT_LE(edit_distance(a, b), std::max(a.size(), b.size()));
  }
  EXPECT_EQ(tried, 2000);
}

TEST(Names, ExactBeforeBeginning) {
  const std::vector<std::string> names{"step", "steps", "slots", "size"};
  EXPECT_EQ(matching_names("step", names), (std::vector<std::size_t>{0}));
  EXPECT_EQ(matching_names("steps", names), (std::vector<std::size_t>{1}));
  EXPECT_EQ(matching_names("st", names), (std::vector<std::size_t>{0})) << "all others go on from it";
  EXPECT_EQ(matching_names("s", names).size(), 4u);
  EXPECT_TRUE(matching_names("x", names).empty());
  EXPECT_TRUE(matching_names("", names).empty());
}

TEST(Names, Choosing) {
  EXPECT_EQ(choose_name("TOPIC", "Flood-F", topics), 2u);
  EXPECT_EQ(complaint([] { choose_name("TOPIC", "bresenham", topics); }),
            "TOPIC: expected one of bresenham_line, bresenham_circle, found 'bresenham'");
  EXPECT_EQ(complaint([] { choose_name("TOPIC", "flod_fill", topics); }),
            "TOPIC: expected one of bresenham_line, bresenham_circle, flood_fill, bsp_tree, found "
            "'flod_fill', did you "
            "mean 'flood_fill'?");
  EXPECT_EQ(
      complaint([] { choose_name("TOPIC", "zzzzzz\n", topics); }),
      "TOPIC: expected one of bresenham_line, bresenham_circle, flood_fill, bsp_tree, found 'zzzzzz\\n'");
}

TEST(Names, NearestName) {
  EXPECT_EQ(nearest_name("bresenhm_line", topics), "bresenham_line");
  EXPECT_EQ(nearest_name("bresehnam", topics), "bresenham_line") << "a beginning with a slip";
  EXPECT_EQ(nearest_name("BSP-Tre", topics), "bsp_tree");
  EXPECT_EQ(nearest_name("radiosity", topics), std::nullopt);
  EXPECT_EQ(nearest_name(std::string(100'000, 'b'), topics), std::nullopt);
}

TEST(Names, Globs) {
  EXPECT_TRUE(matches_glob("bresenham*", "bresenham_line"));
  EXPECT_TRUE(matches_glob("Bresenham-*", "bresenham_line"));
  EXPECT_TRUE(matches_glob("*_[a-l]ine", "bresenham_line"));
  EXPECT_FALSE(matches_glob("bresenham", "bresenham_line"));
}

TEST(Names, ShellWordsUndoQuoting) {
  const std::vector<std::string> values{"plain", "-5,8", "#.#/...",     "two words", "it's",  "",
                                        "$HOME", "a\\b", "line\nbreak", "\"",        "'",     "ä",
                                        "*?[x]", "`x`",  "a;b|c&d",     "~",         "{1,2}", "\x01"};
  std::string line;
  for (const std::string& value : values) line += shell_quoted(value) + " ";
  EXPECT_EQ(shell_words(line), values);
  EXPECT_EQ(shell_quoted("-5,8"), "-5,8");
  EXPECT_EQ(shell_quoted("#.#"), "'#.#'");
  EXPECT_EQ(shell_words("a 'b"), std::nullopt);
  EXPECT_EQ(shell_words("a\\"), std::nullopt);
}

TEST(Names, AShellReadsTheQuotingAlike) {
  const std::string value = "it's $HOME \\ \"x\" `y` * #";
  FILE* shell = popen(("printf %s " + shell_quoted(value)).c_str(), "r");
  ASSERT_NE(shell, nullptr);
  char read[200] = "";
  const std::size_t size = fread(read, 1, sizeof read, shell);
  EXPECT_EQ(pclose(shell), 0);
  EXPECT_EQ(std::string(read, size), value);
}

// --- Steps ---------------------------------------------------------------------------------------

TEST(Steps, Numbers) {
  EXPECT_EQ(read_step("4"), (StepNumber{4, 0}));
  EXPECT_EQ(read_step("4.12"), (StepNumber{4, 12}));
  for (const char* text : {"", "-1", "4.", ".1", "4.0", "x", "1e3", "4.1.2", "99999999999999999999",
                           "4.9999999999", "+4", "1000000000000001"}) {
    EXPECT_EQ(complaint([text] { read_step(text); }),
              std::string("--step: expected a step like 4 or 4.1, or last, found '") + text + "'");
  }
}

TEST(Steps, Lists) {
  for (const char* text : {"4", "4.1", "3-9", "1,4,9-12", "0-100/5", "7,3,3"})
    EXPECT_EQ(text_of(read_steps(text)), text);
  EXPECT_EQ(text_of(read_steps(" 1 , 2 - 3 ")), "1,2-3");
  std::string numbers;
  for (const StepNumber number : numbers_in(read_steps("9,0-7/3,2.1"))) numbers += text_of(number) + " ";
  EXPECT_EQ(numbers, "9 0 3 6 2.1 ");
  EXPECT_EQ(count_in(read_steps("0-1000000000000000,1")), 1'000'000'000'000'002) << "counted, not listed";
  for (const char* text :
       {"", ",", "3-", "-3", "9-3", "1,,2", "3-9/0", "3.1-4", "3-4.1", "a-b", "1-2-3", "1/2"}) {
    EXPECT_EQ(complaint([text] { read_steps(text); }),
              std::string("--steps: expected steps like 3-9 or 1,4,9-12, found '") + text + "'");
  }
}

TEST(Steps, RangesHoldWhatIsInThem) {
  const StepRange range = read_steps("2-8/3")[0];
  EXPECT_TRUE(range.holds({2, 0}));
  EXPECT_TRUE(range.holds({5, 1})) << "with its finer events";
  EXPECT_FALSE(range.holds({3, 0}));
  EXPECT_FALSE(range.holds({9, 0}));
  const StepRange fine = read_steps("4.1")[0];
  EXPECT_TRUE(fine.holds({4, 1}));
  EXPECT_FALSE(fine.holds({4, 0}));
}

// --- Terminal ------------------------------------------------------------------------------------

// A file of four to seven bytes that begins like a WebP ended in an exception of the library
TEST(Formats, AreKnownByContentHoweverShortTheFileIs) {
  for (const std::string begin :
       {"\x89PNG", "%PDF", "GIF8", "RIFF\1\1\1\1WEBP", "\1\1\1\1ftypi", "<svg", "<html"}) {
    for (std::size_t size = 0; size < begin.size(); ++size) {
      EXPECT_EQ(format_by_content(begin.substr(0, size)), std::nullopt) << begin.substr(0, size);
    }
    EXPECT_TRUE(format_by_content(begin)) << begin;
  }
}

TEST(Terminal, ColorFollowsFlagThenEnvironment) {
  const auto with = [](const char* name, const char* value) {
    for (const char* known : {"NO_COLOR", "CLICOLOR_FORCE", "FORCE_COLOR", "TERM"}) unsetenv(known);
    if (name) setenv(name, value, 1);
  };
  with(nullptr, "");
  EXPECT_TRUE(use_color(Color::always, Stream::out));
  EXPECT_FALSE(use_color(Color::never, Stream::out));
  with("CLICOLOR_FORCE", "1");
  EXPECT_TRUE(use_color(Color::automatic, Stream::out));
  EXPECT_FALSE(use_color(Color::never, Stream::out));
  with("CLICOLOR_FORCE", "0");
  EXPECT_EQ(use_color(Color::automatic, Stream::out), is_terminal(Stream::out));
  with("NO_COLOR", "1");
  EXPECT_FALSE(use_color(Color::automatic, Stream::out));
  EXPECT_TRUE(use_color(Color::always, Stream::out));
  setenv("CLICOLOR_FORCE", "1", 1);
  EXPECT_FALSE(use_color(Color::automatic, Stream::out)) << "NO_COLOR comes first";
  with("TERM", "dumb");
  EXPECT_FALSE(use_color(Color::automatic, Stream::out));
  EXPECT_EQ(complaint([] { read_color("sometimes"); }),
            "--color: expected one of auto, always, never, found 'sometimes'");
}

}  // namespace
}  // namespace gradus::cli
