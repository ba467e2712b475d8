// Faces from files: every mistake is told with its line.

#include "request/faces_file.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/refusal.hpp"

namespace gradus::cli {
namespace {

std::string read(std::string_view text, std::int64_t most = 100) {
  const auto open = [](const std::string&) -> std::optional<pipeline::LibraryText> {
    return pipeline::LibraryText("newmtl red\nKd 1 0 0\n");
  };
  try {
    return faces_of_file(text, "f", open, most);
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(FacesFile, ReadsAListOfFaces) {
  EXPECT_EQ(read(R"([{"name": "a", "color": "#cc79a7", "points": [[0, 0, 0], [4, 0, 0.50], [4, 3, 1e1]]},
                     {"points": [[0, 0, 1], [4, 0, 1], [4, 3, 1]]}])"),
            "a #cc79a7: 0,0,0 4,0,0.50 4,3,1e1; 2: 0,0,1 4,0,1 4,3,1");
}

TEST(FacesFile, SaysWhatIsWrongAndWhere) {
  const std::string points = R"("points": [[0, 0, 1], [4, 0, 1], [4, 3, 1]])";
  EXPECT_EQ(read("[]"),
            "f:1: expected a list of faces like [{\"name\": \"a\", \"points\": [[0, 0, 0], [4, 0, 0], [4, 3, "
            "0]]}], found an empty list");
  EXPECT_EQ(read("[\n4]"),
            "f:2: expected a face {\"name\": …, \"color\": …, \"points\": …} with points at least, found 4");
  EXPECT_EQ(read("[{\n\"colour\": \"red\", " + points + "}]"),
            "f:2: expected name, color or points, found 'colour'");
  EXPECT_EQ(read("[{\"name\": 3, " + points + "}]"), "f:1: expected a name, found 3");
  EXPECT_EQ(read("[{\"name\": \"a;b\", " + points + "}]"),
            "f:1: expected a name of at most 24 characters without ':', ';', ',' and '#', found 'a;b'");
  EXPECT_EQ(read("[{\"color\": \"#12\", " + points + "}]"),
            "f:1: face 1: expected a colour #rrggbb, found '#12'");
  EXPECT_EQ(read("[{\"points\": [[0, 0, 1],\n[4, 0], [4, 3, 1]]}]"),
            "f:2: expected a point of three numbers like [4, 3, 0], found a list");
  EXPECT_EQ(read("[{\"points\": [[0, 0, 1], [4, 0, 1]]}]"),
            "f:1: face '1': expected at least 3 points, found 2");
  EXPECT_EQ(read("[{\"points\": "),
            "f:1: expected a value (a text in double quotes, a number, true, false, a list or an object), "
            "found the end of "
            "the file");
}

TEST(FacesFile, TakesTheFacesOfAnObjFile) {
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  EXPECT_EQ(read(square + "f 1 2 3 4\n"), "1: 0,0,0 1,0,0 1,1,0 0,1,0");
  EXPECT_EQ(read("mtllib m.mtl\n" + square + "usemtl red\nf 1 2 3\nf 1 3 4"),
            "1 #ff0000: 0,0,0 1,0,0 1,1,0; 2 #ff0000: 0,0,0 1,1,0 0,1,0");
  EXPECT_EQ(read(square + "f 1 2 3 4\n", 3), "f: expected at most 3 corners of faces in all, found 4");
  EXPECT_EQ(read(square + "f 1 2 9\n").substr(0, 4), "f:5:");
}

}  // namespace
}  // namespace gradus::cli
