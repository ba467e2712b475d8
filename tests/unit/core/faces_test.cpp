#include "core/faces.hpp"

#include <gtest/gtest.h>

namespace gradus {
namespace {

TEST(Faces, AreRingsOneBehindTheOther) {
  Faces faces = faces_of({{0, 1, 2}, {2, 1, 3, 4}});
  ASSERT_EQ(faces.size(), 2U);
  EXPECT_EQ(faces[1].size(), 4U);
  EXPECT_EQ(faces[1][3], 4);
  faces.add(faces_of({{4, 3, 5}})[0]);
  EXPECT_EQ(faces.first, (std::vector<std::int32_t>{0, 3, 7, 10}));
  EXPECT_TRUE(Faces{}.empty());
}

TEST(Faces, ThatNoSurfaceHasAreRefused) {
  EXPECT_NO_THROW(expect_faces(faces_of({{0, 1, 2}}), 3));
  EXPECT_THROW(expect_faces(faces_of({{0, 1}}), 3), ContractViolation);
  EXPECT_THROW(expect_faces(faces_of({{0, 1, 3}}), 3), ContractViolation);
  EXPECT_THROW(expect_faces(faces_of({{0, -1, 2}}), 3), ContractViolation);
  EXPECT_THROW(expect_faces(faces_of({{0, 1, 2, 1}}), 3), ContractViolation);
}

}  // namespace
}  // namespace gradus
