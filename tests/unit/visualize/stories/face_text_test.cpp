// Faces as people write them: names, colours and corners.

#include "stories/face_text.hpp"

#include <gtest/gtest.h>

#include "stories/topic.hpp"

namespace gradus {
namespace {

Parameter faces_parameter() {
  Parameter parameter{"value", ParameterType::faces, "", "", ""};
  parameter.parts = {"x", "y", "z"};
  return parameter;
}

std::string faces_complaint(const Parameter& parameter, std::string_view text) {
  try {
    return "(taken as " + canonical(parameter, text) + ")";
  } catch (const ArgumentError& error) {
    return error.parameter + ": " + error.what();
  }
}

TEST(Canonical, FacesHaveNamesAndColours) {
  Parameter faces = faces_parameter();
  faces.most = 7;
  const std::string two = "a: 0,0,0 4,0,0 4,3,0; 2 #cc79a7: 0,0,1 4,0,1 1/2,3,1";
  EXPECT_EQ(canonical(faces, two), two);
  EXPECT_EQ(canonical(faces, " a :0,0,0\t4, 0,0\n(4,3,0);#CC79A7: 0,0,1 4,0,1 2/4,3,1;"), two);
  EXPECT_EQ(canonical(faces, "0,0,0 4,0,0 4,3,0"), "1: 0,0,0 4,0,0 4,3,0");
  EXPECT_EQ(faces_complaint(faces, "a: 0,0,0 4,0,0"), "value: face 'a': expected at least 3 points, found 2");
  EXPECT_EQ(faces_complaint(faces, "0,0,0 4,0,0 4,3"),
            "value: face '1': point 3: expected 3 numbers x,y,z, found '4,3'");
  EXPECT_EQ(faces_complaint(faces, "a: 0,0,0 4,0,0 4,3,0; a: 0,0,1 4,0,1 4,3,1"),
            "value: expected every name once, found 'a' twice");
  EXPECT_EQ(faces_complaint(faces, "a #12: 0,0,0 4,0,0 4,3,0"),
            "value: face 1: expected a colour #rrggbb, found '#12'");
  EXPECT_EQ(faces_complaint(faces, "a,b: 0,0,0 4,0,0 4,3,0"),
            "value: face 1: expected a name of at most 24 characters without ':', ';', ',' and '#', found "
            "'a,b'");
  EXPECT_EQ(faces_complaint(faces, "0,0,0 4,0,0 4,3,0 0,3,0; 0,0,1 4,0,1 4,3,1 0,3,1"),
            "value: expected at most 7 corners in all, found 8");
  for (const char* text : {"", " ; "})
    EXPECT_EQ(
        faces_complaint(faces, text),
        "value: expected faces like 'a: 0,0,0 4,0,0 4,3,0; b: 0,0,1 4,0,1 4,3,1', found " + shown(text));
  Arguments arguments;
  Arguments::Entry written = read_argument(faces, two);
  written.name = "faces";
  arguments.set(std::move(written));
  arguments.set({.name = "none", .text = ""});
  const std::vector<NamedFace> read = arguments.faces("faces");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].name + read[0].color + read[1].name + read[1].color, "a2#cc79a7");
  EXPECT_EQ(read[1].points, (std::vector<dvec3>{{0, 0, 1}, {4, 0, 1}, {0.5, 3, 1}}));
  EXPECT_TRUE(arguments.faces("none").empty());
}

}  // namespace
}  // namespace gradus
