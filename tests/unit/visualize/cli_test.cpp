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
#include "cli/figure_file.hpp"
#include "cli/figure_spec.hpp"
#include "cli/files.hpp"
#include "cli/inputs.hpp"
#include "cli/names.hpp"
#include "cli/takes.hpp"
#include "cli/terminal.hpp"
#include "support/sanitized.hpp"

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

// --- Files ---------------------------------------------------------------------------------------

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
    files.add(path("a"), "new", Replace::anything);
    files.add(path("b"), "new");
    EXPECT_EQ(names().size(), 3u);
  }
  EXPECT_EQ(names(), FileNames{"a"});
  EXPECT_EQ(get("a"), "old");
}

TEST_F(Files, ReplaceAndKeepPermissions) {
  put("a", "old");
  fs::permissions(path("a"), fs::perms::owner_read | fs::perms::owner_write);
  write_output(path("a"), "new", Replace::anything);
  EXPECT_EQ(get("a"), "new");
  EXPECT_EQ(fs::status(path("a")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Files, ALinkStaysALink) {
  put("target", "old");
  fs::create_symlink("target", path("link"));
  write_output(path("link"), "new", Replace::anything);
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(get("target"), "new");
  EXPECT_EQ(names(), (FileNames{"link", "target"}));
}

TEST_F(Files, ALinkToWhatIsNotThereIsFollowedToo) {
  fs::create_directory(path("sub"));
  fs::create_symlink("sub/other", path("link"));
  fs::create_symlink("target", path("sub/other"));
  write_output(path("link"), "new");
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_TRUE(fs::is_symlink(path("sub/other")));
  EXPECT_EQ(get("sub/target"), "new");
}

TEST_F(Files, SomebodysFileIsNotReplaced) {
  put("a", "mine");
  put("empty", "");
  const std::string refusal =
      "-o: expected a new file or one that gradus made, found '" + path("a") + "' (--force replaces it)";
  EXPECT_EQ(complaint([this] { write_output(path("a"), "new"); }), refusal);
  EXPECT_EQ(complaint([this] { check_output(path("a"), {}, Replace::own); }), refusal);
  EXPECT_EQ(get("a"), "mine");
  EXPECT_EQ(names(), (FileNames{"a", "empty"}));
  check_output(path("a"), {}, Replace::anything);
  write_output(path("a"), "mine");
  write_output(path("empty"), "new");
  EXPECT_EQ(get("empty"), "new");
  NewFiles files;
  EXPECT_EQ(complaint([&] { files.add(path("a"), "new"); }), refusal);
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
            "--maze: expected a regular file, found the folder '" + folder_.string() + "'");
  EXPECT_EQ(complaint([] { read_input("/dev/zero", "--maze"); }),
            "--maze: expected a regular file, found the device '/dev/zero'");
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(complaint([this] { read_input(path("pipe"), "--maze"); }),
            "--maze: expected a regular file, found the pipe '" + path("pipe") + "'");
  put("large", "");
  fs::resize_file(path("large"), (256 << 20) + 1);
  EXPECT_EQ(complaint([this] { read_input(path("large"), "--maze"); }),
            "--maze: expected a file of at most 256 MiB, found '" + path("large") + "'");
}

TEST_F(Files, NeverOntoAnInput) {
  put("a", "x");
  fs::create_hard_link(path("a"), path("b"));
  fs::create_symlink("a", path("c"));
  const std::vector<std::string> inputs{"-", path("a")};
  for (const char* name : {"a", "b", "c", "./a"}) {
    const std::string output = path(name);
    EXPECT_EQ(complaint([&] { check_output(output, inputs, Replace::own); }),
              "-o: expected another file than the input, found '" + output + "'");
  }
  check_output(path("d"), inputs, Replace::own);
  check_output("-", inputs, Replace::own);
  EXPECT_EQ(complaint([&] { check_output(path(""), inputs, Replace::own); }),
            "-o: expected a file's name, found '" + path("") + "'");
  EXPECT_EQ(complaint([&] { check_output(path("no/d"), inputs, Replace::own); }),
            "-o: expected a folder that exists, found '" + path("no") + "'");
}

TEST_F(Files, Fingerprints) {
  EXPECT_EQ(fingerprint(""), "fnv1a:cbf29ce484222325");
  EXPECT_EQ(fingerprint("a"), "fnv1a:af63dc4c8601ec8c") << "from the FNV authors' test vectors";
  EXPECT_EQ(fingerprint("foobar"), "fnv1a:85944171f73967e8");
}

// --- Inputs --------------------------------------------------------------------------------------

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
            "--scale: expected at most 16384 pixels a side, found 16466 x 8233");
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
  for (std::size_t i = 0; i < test::thinned(3000, 10); ++i) {
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
  EXPECT_GT(kept, test::thinned(2000, 10));
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
