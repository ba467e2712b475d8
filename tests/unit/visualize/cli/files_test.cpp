// What the command reads and writes: files that appear on commit, and inputs that figures are made of.

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "cli/command_line/errors.hpp"
#include "cli/command_line/inputs.hpp"
#include "cli/files/files.hpp"
#include "request/fingerprint.hpp"
#include "request/names.hpp"
#include "support/complaint.hpp"

namespace gradus::cli {
namespace {

using test::complaint;

namespace fs = std::filesystem;

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

TEST_F(Files, ARefusedNameLeavesTheOthersAsTheyWere) {
  put("a", "old");
  {
    NewFiles files;
    for (const char* name : {"a", "b", "c", "d"}) files.add(path(name), "new", Replace::anything);
    fs::create_directory(path("c"));  // since then, so that no file can get its name
    EXPECT_EQ(complaint([&] { files.commit(); }),
              "work: can't write '" + path("c") + "': Is a directory; the others stay as they were");
  }
  EXPECT_EQ(names(), (FileNames{"a", "c"}));
  EXPECT_EQ(get("a"), "old");
}

TEST_F(Files, WhatIsKeptForAWhileLeavesNoTrace) {
  put("a", "old"), put("b", "old");
  fs::create_hard_link(path("a"), path("other"));
  NewFiles files;
  for (const char* name : {"a", "b", "c"}) files.add(path(name), "new", Replace::anything);
  files.commit();
  EXPECT_EQ(names(), (FileNames{"a", "b", "c", "other"}));
  EXPECT_EQ(get("a") + get("b") + get("c") + get("other"), "newnewnewold");
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

}  // namespace
}  // namespace gradus::cli
