// What a model may name: its libraries and their places, and what is told of files beside it.

#include "scene/models/obj.hpp"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/refusal.hpp"
#include "scene/files.hpp"
#include "scene/models/materials.hpp"
#include "support/obj_text.hpp"

namespace gradus::pipeline::obj_files_test {
namespace {

// --- What a model may name -----------------------------------------------------------------------

/// A folder of its own with a model's folder in it, removed at the end.
class ObjFiles : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "gradus_obj_XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    root_ = name;
    std::filesystem::create_directory(root_ / "models");
  }
  void TearDown() override { std::filesystem::remove_all(root_); }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(root_ / name, std::ios::binary) << text;
  }
  /// What the reader says of a model with these lines before its faces: its refusal, else its notes.
  std::string said(const std::string& lines) {
    write("models/m.obj", lines + "\n" + square + "usemtl red\nf 1 2 3\n");
    try {
      const ModelFile m = load_obj((root_ / "models/m.obj").string());
      std::string all = m.mesh.materials.at(1).diffuse == LinearRgb{1, 0, 0} ? "red" : "default";
      for (const std::string& note : m.notes) all += "; " + note;
      return without_folder(all);
    } catch (const InputError& error) {
      return without_folder(error.what());
    }
  }
  std::string without_folder(std::string text) const {
    for (std::size_t at; (at = text.find(root_.string() + "/")) != std::string::npos;)
      text.erase(at, root_.string().size() + 1);
    return text;
  }

  std::filesystem::path root_;
};

TEST_F(ObjFiles, NoNameEndsAtANul) {
  write("models/a.mtl", red);
  const std::string name("a.mtl\0.mtl", 10);
  EXPECT_EQ(said("mtllib a.mtl"), "red");
  EXPECT_THAT(said("mtllib " + name), testing::Not(testing::StartsWith("red")));
  EXPECT_THAT(read_regular_file((root_ / "models/").string() + name).problem,
              testing::StartsWith("expected a file's name without NUL, found "));
}

TEST_F(ObjFiles, LibrariesWithBlanksInTheirNames) {
  write("models/a b.mtl", red);
  std::filesystem::create_directory(root_ / "models/a");
  EXPECT_EQ(said("mtllib a b.mtl"), "red");
  EXPECT_EQ(said("mtllib a\\ b.mtl"), "red");
  EXPECT_EQ(said("mtllib c.mtl a\\ b.mtl d.mtl"),
            "red; models/m.obj:1: no file 'c.mtl': its materials are the default; "
            "models/m.obj:1: no file 'd.mtl': its materials are the default");
  EXPECT_THAT(said("mtllib a\\ c.mtl"),
              testing::HasSubstr("models/m.obj:1: no file 'a c.mtl': its materials are the default"));
}

TEST_F(ObjFiles, AFolderIsNoLibrary) {
  std::filesystem::create_directory(root_ / "models/textures");
  const std::string material = "; models/m.obj:10: no material 'red' was read: it is drawn like the default";
  EXPECT_EQ(said("mtllib textures"),
            "default; models/m.obj:1: no file 'textures': its materials are the default" + material);
  EXPECT_EQ(said("mtllib ."),
            "default; models/m.obj:1: no file '.': its materials are the default" + material);
  EXPECT_EQ(said("mtllib .."),
            "default; models/m.obj:1: no file '..': its materials are the default" + material);
}

TEST_F(ObjFiles, OnlyRegularFilesOfAStatedSizeAreRead) {
  ASSERT_EQ(mkfifo((root_ / "models/pipe.mtl").c_str(), 0600), 0);
  EXPECT_EQ(said("mtllib pipe.mtl"),
            "models/m.obj:1: expected a regular file, found the pipe 'models/pipe.mtl'");
  EXPECT_EQ(said("mtllib /dev/zero"),
            "models/m.obj:1: expected a regular file, found the device '/dev/zero'");
  write("models/large.mtl", "");
  std::filesystem::resize_file(root_ / "models/large.mtl", most_library_bytes + 1);
  EXPECT_EQ(said("mtllib large.mtl"),
            "models/m.obj:1: expected a file of at most 16 MiB, found 'models/large.mtl'");
  std::string many = "mtllib";
  for (int i = 0; i <= 100; ++i) {
    write(fmt::format("models/{}.mtl", i), "");
    many += fmt::format(" {}.mtl", i);
  }
  EXPECT_EQ(said(many), "models/m.obj:1: expected at most 100 material libraries, found one more");
  // The model itself
  const auto refused = [&](const std::string& name) {
    try {
      load_obj((root_ / name).string());
    } catch (const InputError& error) {
      return without_folder(error.what());
    }
    return std::string("read");
  };
  EXPECT_EQ(refused("models/pipe.mtl"), "expected a regular file, found the pipe 'models/pipe.mtl'");
  EXPECT_EQ(refused("models"), "expected a regular file, found the folder 'models'");
  EXPECT_EQ(refused("models/none.obj"),
            "expected a readable file, found 'models/none.obj' (No such file or directory)");
  std::filesystem::resize_file(root_ / "models/large.mtl", most_file_bytes + 1);
  EXPECT_EQ(refused("models/large.mtl"), "expected a file of at most 256 MiB, found 'models/large.mtl'");
}

TEST_F(ObjFiles, LinesOfFilesOutsideTheModelsFolderAreNeverQuoted) {
  const std::string secret = "topsecret";
  const std::string forms[]{"topsecret:x:0:0",
                            "newmtl topsecret\nnewmtl topsecret",
                            "newmtl a\nKd topsecret",
                            "newmtl a\nKd -7777 0 0",
                            "newmtl a\nd 7777",
                            "newmtl a\nKd 1 0 0 topsecret",
                            "newmtl a\nmap_Kd -topsecret x",
                            "newmtl a\ntopsecret 1 2",
                            "newmtl a\nKd 1e7777"};
  const std::vector<std::string> names{"../secret.txt", "link.mtl", (root_ / "secret.txt").string(),
                                       "..\\secret.txt"};
  std::filesystem::create_symlink("../secret.txt", root_ / "models/link.mtl");
  for (const std::string& form : forms) {
    SCOPED_TRACE(form);
    write("secret.txt", form + "\n");
    for (const std::string& name : names) {
      const std::string what = said("mtllib " + name);
      EXPECT_THAT(what, testing::AllOf(testing::Not(testing::HasSubstr(secret)),
                                       testing::Not(testing::HasSubstr("7777"))));
      EXPECT_THAT(what, testing::ContainsRegex("secret.txt:[0-9]: |link.mtl:[0-9]: |secret.txt':[0-9]: "))
          << name;
    }
    // Beside the model the user may see what is wrong
    write("models/own.mtl", form + "\n");
    EXPECT_THAT(said("mtllib own.mtl"), testing::ContainsRegex("topsecret|7777"));
  }
  write("secret.txt", red);
  EXPECT_EQ(said("mtllib ../secret.txt"), "red") << "it is read all the same";
}

TEST(Obj, AModelThatOthersNamedIsNotQuoted) {
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", f = "f 1 2 3\n";
  const auto said = [](const std::string& text) {
    LibraryText broken(std::string("topsecret\n"));
    try {
      const ModelFile m = parse_obj(text, {"far.obj", false}, [&](const std::string& name) {
        return name == "topsecret.mtl" ? std::optional(broken) : std::nullopt;
      });
      std::string all;
      for (const std::string& note : m.notes) all += note + "\n";
      return all;
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  for (const std::string text :
       {"v topsecret", "topsecret", "vt 7777e7777", "s topsecret", "f 1 2 topsecret", "f 1 2 7777",
        "f 1 2 -7777", "f 1 2 7777777777777", "l 1 7777", "usemtl topsecret", "mtllib topsecret",
        "mtllib topsecret.mtl", "curv topsecret"}) {
    const std::string what = said(v + text + "\n" + f);
    EXPECT_THAT(what, testing::StartsWith("far.obj:4: ")) << text;
    EXPECT_THAT(what, testing::Not(testing::ContainsRegex("topsecret|7777"))) << text;
  }
}

// Found by tests/fuzz: names of files, materials and statements that a terminal would act on
TEST(Obj, MessagesSpellOutWhatATerminalWouldActOn) {
  EXPECT_EQ(refusal("v \u202eboo\n"),
            "m.obj:1: expected a number for the vertex, found '\\xe2\\x80\\xaeboo'");
  EXPECT_EQ(refusal("v \xff\n"), "m.obj:1: expected a number for the vertex, found '\\xff'");
  EXPECT_THAT(parse(square + "\u202eboo\n\xff\nf 1 2 3\n").notes,
              testing::ElementsAre(testing::HasSubstr("'\\xe2\\x80\\xaeboo' is no known statement"),
                                   testing::HasSubstr("'\\xff' is no known statement")));
  EXPECT_EQ(refusal(square + "mtllib \x1b[1m.mtl\nf 1 2 3\n", {{"\x1b[1m.mtl", "Kd 1 1 1\n"}}),
            "'\\x1b[1m.mtl':1: expected newmtl first, found 'Kd'");
  EXPECT_THAT(parse(square + "usemtl \u2066\"<b>\nf 1 2 3\n").notes,
              testing::ElementsAre(testing::HasSubstr("no material '\\xe2\\x81\\xa6\"<b>' was read")));
  EXPECT_THAT(parse(square + "mtllib \x9b.mtl\nf 1 2 3\n").notes,
              testing::ElementsAre(testing::HasSubstr("no file '\\x9b.mtl'")));
  try {
    parse_obj("v boo\n", "\x1b]0;x\x07.obj", [](const std::string&) { return std::optional<LibraryText>(); });
    ADD_FAILURE() << "it was read";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "'\\x1b]0;x\\x07.obj':1: expected a number for the vertex, found 'boo'");
  }
}

}  // namespace
}  // namespace gradus::pipeline::obj_files_test
