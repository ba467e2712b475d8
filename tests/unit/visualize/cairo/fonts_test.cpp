// The fonts that figures are drawn with, as Cairo holds them.

#include "cairo/fonts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>

#include "figure/text/metrics.hpp"

namespace gradus {
namespace {

/// The font files that are open, by what is in memory.
std::set<std::string> open_fonts() {
  std::set<std::string> names;
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    if (line.ends_with(".otf") || line.ends_with(".ttf")) names.insert(line.substr(line.rfind('/') + 1));
  }
  return names;
}

// Cairo keeps ten files open. When it needs one more it closes another, even while a second thread is about
// to read it: that ended the program.
TEST(Fonts, AllFilesStayOpen) {
  const std::string text =
      "gradus Σ≥⋮ᵀ⁻";  // letters of the font, of one that lends and of one that stands in
  for (int turn = 0; turn < 3; ++turn) {
    for (const Face face : all_faces) drawn_width(text, face, 20);
  }
  EXPECT_THAT(
      open_fonts(),
      testing::ElementsAre("DejaVuSans-Bold.ttf", "DejaVuSans-Oblique.ttf", "DejaVuSans.ttf",
                           "DejaVuSansMono.ttf", "Inter-Bold.otf", "Inter-BoldItalic.otf", "Inter-Italic.otf",
                           "Inter-Regular.otf", "JetBrainsMono-Bold.ttf", "JetBrainsMono-Regular.ttf"));
}

}  // namespace
}  // namespace gradus
