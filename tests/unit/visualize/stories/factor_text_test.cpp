// Chains of transformations as people write them: canonical spelling, and one line for what is wrong.

#include "stories/factor_text.hpp"

#include <gtest/gtest.h>

#include "stories/matrix_drawing.hpp"
#include "stories/topic.hpp"

namespace gradus {
namespace {

const std::vector<std::string> in_plane{"x", "y"}, in_space{"x", "y", "z"};

std::string canonical_of(std::string_view text, const std::vector<std::string>& names) {
  const Read<std::vector<FactorText>> read = read_factors(text, names);
  if (const Misread* misread = std::get_if<Misread>(&read)) return "! " + misread->what;
  const std::string spelled = text_of(std::get<std::vector<FactorText>>(read));
  // What is canonical stays as it is
  const Read<std::vector<FactorText>> again = read_factors(spelled, names);
  EXPECT_TRUE(std::holds_alternative<std::vector<FactorText>>(again)) << spelled;
  if (std::holds_alternative<std::vector<FactorText>>(again)) {
    EXPECT_EQ(text_of(std::get<std::vector<FactorText>>(again)), spelled);
  }
  return spelled;
}

TEST(FactorText, ReadsEveryKindInThePlane) {
  EXPECT_EQ(canonical_of("rotate 30 about 1,1; scale 2 about 1,1", in_plane),
            "rotate 30 about 1,1; scale 2 about 1,1");
  EXPECT_EQ(canonical_of("  Translate ( 2 , -1 ) ;; ", in_plane),
            "! factor 2: expected translate, scale, rotate, shear or reflect, found ''");
  EXPECT_EQ(canonical_of("  Translate ( 2 , -1 ) ; ", in_plane), "translate 2,-1");
  EXPECT_EQ(canonical_of("scale 2,3", in_plane), "scale 2,3");
  EXPECT_EQ(canonical_of("scale +2/6 about (1, 0.50)", in_plane), "scale 1/3 about 1,0.5");
  EXPECT_EQ(canonical_of("SHEAR 0.5,0.25 ABOUT 1,1", in_plane), "shear 0.5,0.25 about 1,1");
  EXPECT_EQ(canonical_of("rotate -90", in_plane), "rotate -90");
  EXPECT_EQ(canonical_of("reflect x;reflect y;reflect origin;reflect y=x", in_plane),
            "reflect x; reflect y; reflect origin; reflect y=x");
  EXPECT_EQ(canonical_of("reflect (0, 1) (3, 2)", in_plane), "reflect 0,1 3,2");
}

TEST(FactorText, ReadsEveryKindInSpace) {
  EXPECT_EQ(canonical_of("rotate 90 about x; rotate 90 about 0,1,0", in_space),
            "rotate 90 about x; rotate 90 about y");
  EXPECT_EQ(canonical_of("rotate 30 about 0,1,1 through 1,1,0", in_space),
            "rotate 30 about 0,1,1 through 1,1,0");
  EXPECT_EQ(canonical_of("scale 2; scale 1,2,3 about 1,1,1; translate 0,0,1", in_space),
            "scale 2; scale 1,2,3 about 1,1,1; translate 0,0,1");
}

TEST(FactorText, SaysWhichFactorIsWrong) {
  EXPECT_EQ(canonical_of("rotate 30; rotat 30", in_plane),
            "! factor 2: expected translate, scale, rotate, shear or reflect, found 'rotat 30'");
  EXPECT_EQ(canonical_of("rotate", in_plane),
            "! factor 1: expected something like 'rotate 30 about 1,1', found 'rotate'");
  EXPECT_EQ(canonical_of("rotate nan", in_plane),
            "! factor 1: expected something like 'rotate 30 about 1,1', found 'rotate nan'");
  EXPECT_EQ(canonical_of("translate 1,1 about 2,2", in_plane),
            "! factor 1: expected something like 'translate 2,1', found 'translate 1,1 about 2,2'");
  EXPECT_EQ(canonical_of("scale 1,2,3", in_plane),
            "! factor 1: expected something like 'scale 2,3 about 1,1', found 'scale 1,2,3'");
  EXPECT_EQ(canonical_of("shear 1,1", in_space),
            "! factor 1: expected translate, scale or rotate, found 'shear 1,1'");
  EXPECT_EQ(canonical_of("rotate 30", in_space),
            "! factor 1: expected something like 'rotate 30 about 0,1,1 through 1,1,0', found 'rotate 30'");
  EXPECT_EQ(canonical_of("rotate 30 about 0,0,0", in_space),
            "! factor 1: expected an axis, not the zero vector, found 'rotate 30 about 0,0,0'");
  EXPECT_EQ(canonical_of("reflect 1,1 1.0,1", in_plane),
            "! factor 1: expected two different points of the mirror, found 'reflect 1,1 1.0,1'");
  EXPECT_EQ(canonical_of("translate 1e16,0", in_plane),
            "! factor 1: expected numbers 0 or from 1e-15 to 1e15 in size, found 'translate 1e16,0'");
  EXPECT_EQ(canonical_of("", in_plane), "! expected 1 to 12 factors like 'rotate 30 about 1,1', found 0");
  std::string many;
  for (int i = 0; i < 13; ++i) many += "scale 2;";
  EXPECT_EQ(canonical_of(many, in_plane), "! expected 1 to 12 factors like 'rotate 30 about 1,1', found 13");
}

TEST(FactorText, SplitsAtPivots) {
  const auto read = read_factors("rotate 90 about 400,-300; scale 2", in_plane);
  EXPECT_EQ(text_of(split_at_pivots(std::get<std::vector<FactorText>>(read))),
            "translate -400,300; rotate 90; translate 400,-300; scale 2");
}

TEST(FactorText, StoriesRefuseWhatHasNoInverse) {
  const TopicEntry& topic = *find_entry("affine_2d");
  EXPECT_NO_THROW(trace_of(topic, {{"factors", "shear 2,1/2"}}));
  for (const char* flat : {"shear 2,1/2", "shear 3,1/3", "scale 0", "rotate 30; scale 1,0 about 2,2"}) {
    EXPECT_THROW(trace_of(topic, {{"factors", flat}, {"method", "undo"}}), ArgumentError) << flat;
  }
  EXPECT_THROW(trace_of(*find_entry("affine_3d"), {{"axis", "0,0,0"}, {"method", "decomposition"}}),
               ArgumentError);
}

TEST(FactorText, StoriesSayWhatTheAlgorithmsDo) {
  const TopicEntry& topic = *find_entry("affine_2d");
  const Trace trace = trace_of(
      topic, {{"factors", "translate 2,0; rotate 90"}, {"polygon", "1,0 2,0 2,1"}, {"orders", "both"}});
  EXPECT_EQ(trace.last, 4);
  EXPECT_EQ(trace.steps.back().type, "Reversed");
  EXPECT_EQ(std::get<double>(trace.result[1].value), 3);  // A.y
  EXPECT_EQ(trace_of(topic, {{"factors", "rotate 90 about 1,1"}, {"pivots", "split"}}).last, 4);
  // Seven factors for an axis in general position, input and result
  EXPECT_EQ(trace_of(*find_entry("affine_3d"), {{"axis", "1,2,3"}, {"method", "decomposition"}}).last, 8);
}

}  // namespace
}  // namespace gradus
