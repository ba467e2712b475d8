// The parts of the command that need no topic: names, files, steps, progress. The command as a whole is
// tested by tests/golden/cli_test.py.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <set>
#include <sstream>

#include "cli/errors.hpp"
#include "cli/files.hpp"
#include "cli/inputs.hpp"
#include "cli/names.hpp"
#include "cli/takes.hpp"
#include "cli/terminal.hpp"

namespace gradus::cli {
namespace {

namespace fs = std::filesystem;

std::string complaint(const std::function<void()>& call) {
  try {
    call();
  } catch (const UsageError& error) {
    return error.what();
  } catch (const WorkError& error) {
    return std::string("work: ") + error.what();
  }
  return "(no complaint)";
}

// --- Names
// -------------------------------------------------------------------------------------------------------

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

// --- Steps
// -------------------------------------------------------------------------------------------------------

TEST(Steps, Numbers) {
  EXPECT_EQ(read_step("4"), (StepNumber{4, 0}));
  EXPECT_EQ(read_step("4.12"), (StepNumber{4, 12}));
  for (const char* text : {"", "-1", "4.", ".1", "4.0", "x", "1e3", "4.1.2", "99999999999999999999",
                           "4.9999999999", "+4", "1000000000000001"}) {
    EXPECT_EQ(complaint([text] { read_step(text); }),
              std::string("--step: expected a step like 4 or 4.1, found '") + text + "'");
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

// --- Files
// -------------------------------------------------------------------------------------------------------

class Files : public testing::Test {
 protected:
  Files() {
    char pattern[] = "/tmp/gradus_cli_test_XXXXXX";
    folder_ = mkdtemp(pattern);
  }
  ~Files() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void put(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  std::string get(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path(name), std::ios::binary).rdbuf();
    return text.str();
  }
  std::set<std::string> names() const {
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_)) found.insert(entry.path().filename().string());
    return found;
  }
  fs::path folder_;
};

using FileNames = std::set<std::string>;

TEST_F(Files, AppearOnCommit) {
  {
    NewFiles files;
    files.add(path("a"), "first");
    files.add(path("b"), "second");
    EXPECT_FALSE(fs::exists(path("a")));
    files.commit();
    EXPECT_EQ(names(), (FileNames{"a", "b"}));
  }
  EXPECT_EQ(get("a") + get("b"), "firstsecond");
}

TEST_F(Files, LeaveNoTraceWithoutCommit) {
  put("a", "old");
  {
    NewFiles files;
    files.add(path("a"), "new");
    files.add(path("b"), "new");
    EXPECT_EQ(names().size(), 3u);
  }
  EXPECT_EQ(names(), FileNames{"a"});
  EXPECT_EQ(get("a"), "old");
}

TEST_F(Files, ReplaceAndKeepPermissions) {
  put("a", "old");
  fs::permissions(path("a"), fs::perms::owner_read | fs::perms::owner_write);
  write_output(path("a"), "new");
  EXPECT_EQ(get("a"), "new");
  EXPECT_EQ(fs::status(path("a")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Files, ALinkStaysALink) {
  put("target", "old");
  fs::create_symlink("target", path("link"));
  write_output(path("link"), "new");
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(get("target"), "new");
  EXPECT_EQ(names(), (FileNames{"link", "target"}));
}

TEST_F(Files, ADeviceIsNotReplaced) {
  write_output("/dev/null", "text");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(complaint([] { write_output("/dev/full", "text"); }),
            "work: can't write '/dev/full': No space left on device");
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(Files, FailuresAreOneLine) {
  EXPECT_EQ(complaint([this] { write_output(path("no/a"), "x"); }),
            "work: can't write '" + path("no/a") + "': No such file or directory");
}

TEST_F(Files, Reading) {
  put("a", std::string("x\0y", 3));
  EXPECT_EQ(read_input(path("a"), "--maze"), std::string("x\0y", 3));
  EXPECT_EQ(complaint([this] { read_input(path("b"), "--maze"); }),
            "--maze: expected a readable file, found '" + path("b") + "' (No such file or directory)");
  EXPECT_EQ(complaint([this] { read_input(folder_.string(), "--maze"); }),
            "--maze: expected a readable file, found '" + folder_.string() + "' (Is a directory)");
  EXPECT_EQ(complaint([] { read_input("/dev/zero", "--maze"); }),
            "--maze: expected a file of at most 256 MiB, found '/dev/zero'");
}

TEST_F(Files, NeverOntoAnInput) {
  put("a", "x");
  fs::create_hard_link(path("a"), path("b"));
  fs::create_symlink("a", path("c"));
  const std::vector<std::string> inputs{"-", path("a")};
  for (const char* name : {"a", "b", "c", "./a"}) {
    const std::string output = path(name);
    EXPECT_EQ(complaint([&] { check_output(output, inputs); }),
              "-o: expected another file than the input, found '" + output + "'");
  }
  check_output(path("d"), inputs);
  check_output("-", inputs);
  EXPECT_EQ(complaint([&] { check_output(path(""), inputs); }),
            "-o: expected a file's name, found '" + path("") + "'");
  EXPECT_EQ(complaint([&] { check_output(path("no/d"), inputs); }),
            "-o: expected a folder that exists, found '" + path("no") + "'");
}

TEST_F(Files, Fingerprints) {
  EXPECT_EQ(fingerprint(""), "fnv1a:cbf29ce484222325");
  EXPECT_EQ(fingerprint("a"), "fnv1a:af63dc4c8601ec8c") << "from the FNV authors' test vectors";
  EXPECT_EQ(fingerprint("foobar"), "fnv1a:85944171f73967e8");
}

// --- Inputs
// ------------------------------------------------------------------------------------------------------

Trace no_run(const Arguments&, Recording) { return {}; }

TopicEntry topic_with_files() {
  TopicEntry topic;
  topic.name = "maze_topic";
  topic.methods = {{"plain", "plain", Standing::taught, ""}, {"other", "other", Standing::plain, ""}};
  topic.default_method = "plain";
  topic.parameters = {
      {"maze", ParameterType::maze, "#.#", "maze.txt", ""},
      {"image", ParameterType::picture, "", "photo.png", ""},
      {"at", ParameterType::cell, "1,1", "3,4", ""},
      {"connectivity", ParameterType::choice, "4", "8", "", INT32_MIN, INT32_MAX, {"4", "8"}}};
  topic.parameters[1].instead_of = "maze";
  topic.run = no_run;
  return topic;
}

TEST_F(Files, DefaultsAreFilledIn) {
  const TopicEntry topic = topic_with_files();
  const Inputs inputs = read_inputs(topic, {{"at", "(2, 3)"}});
  EXPECT_EQ(command_of("figure", topic, inputs.arguments),
            "gradus figure maze_topic --maze '#.#' --at 2,3 --connectivity 4");
  EXPECT_EQ(inputs.arguments.entry("maze").content, "#.#\n");
  EXPECT_EQ(input_hash(inputs.arguments), "");
  EXPECT_TRUE(inputs.files.empty());
}

TEST_F(Files, AMethodIsNamedWhenItIsNotTheDefault) {
  const TopicEntry topic = topic_with_files();
  const Inputs inputs = read_inputs(topic, {{"method", "oth"}});
  EXPECT_EQ(command_of("run", topic, inputs.arguments),
            "gradus run maze_topic --method other --maze '#.#' --at 1,1 --connectivity 4");
  EXPECT_EQ(complaint([&] { read_inputs(topic, {{"method", "plane"}}); }),
            "--method: expected one of plain, other, found 'plane', did you mean 'plain'?");
}

TEST_F(Files, AShortMazeIsWrittenOut) {
  put("m.txt", "\xef\xbb\xbf#.#\r\n.a.\r\n");
  const Inputs inputs = read_inputs(topic_with_files(), {{"maze", path("m.txt")}});
  EXPECT_EQ(inputs.arguments.text("maze"), "#.#/.a.");
  EXPECT_EQ(inputs.arguments.entry("maze").content, "#.#\n.a.\n");
  EXPECT_EQ(inputs.arguments.entry("maze").hash, "");
  EXPECT_EQ(inputs.files, std::vector<std::string>{path("m.txt")});
}

TEST_F(Files, ALongMazeIsNamedAndHashed) {
  std::string rows;
  for (int i = 0; i < 40; ++i) rows += std::string(40, '.') + "\n";
  put("m.txt", rows);
  const Inputs inputs = read_inputs(topic_with_files(), {{"maze", "@" + path("m.txt")}});
  EXPECT_EQ(inputs.arguments.text("maze"), "m.txt");
  EXPECT_EQ(inputs.arguments.entry("maze").content, rows);
  EXPECT_EQ(input_hash(inputs.arguments), fingerprint(rows));
}

TEST_F(Files, AnUnevenMazeKeepsItsNameForTheError) {
  put("m.txt", "##\n#\n");
  EXPECT_EQ(read_inputs(topic_with_files(), {{"maze", path("m.txt")}}).arguments.text("maze"), "m.txt");
}

TEST_F(Files, APictureGoesByItsNameAndHash) {
  const std::vector<std::uint8_t> png = encode_png(Image(3, 2, {1, 2, 3}));
  put("p.png", std::string(png.begin(), png.end()));
  const TopicEntry topic = topic_with_files();
  const Inputs inputs = read_inputs(topic, {{"image", path("p.png")}});
  EXPECT_EQ(command_of("figure", topic, inputs.arguments),
            "gradus figure maze_topic --image p.png --at 1,1 --connectivity 4");
  EXPECT_EQ(inputs.arguments.entry("image").image->width(), 3);
  EXPECT_EQ(input_hash(inputs.arguments), fingerprint(get("p.png")));
}

TEST_F(Files, EitherMazeOrImage) {
  EXPECT_EQ(complaint([] { read_inputs(topic_with_files(), {{"image", "p.png"}, {"maze", "#.#"}}); }),
            "--image: expected either this or --maze, found both");
}

// --- Terminal
// ----------------------------------------------------------------------------------------------------

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
