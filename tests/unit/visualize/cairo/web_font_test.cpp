// The embedded fonts, read back by another reader of fonts.

#include "cairo/web_font.hpp"

#include <ft2build.h>
#include <gtest/gtest.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <cmath>
#include <memory>

#include "cairo/cairo_output.hpp"
#include "cairo/fonts.hpp"
#include "figure/figure.hpp"
#include "figure/text/metrics.hpp"
#include "support/example_traces.hpp"
#include "web/player.hpp"

namespace gradus {
namespace {

const std::u32string letters = U"AgQ0147 ,;(−)·×≈≤⋮ᵀ∈⌊⌋ₙ⁻⁶äÖßπΣ…√→";

class LoadedFont {
 public:
  explicit LoadedFont(std::string bytes) : bytes_(std::move(bytes)) {
    EXPECT_EQ(FT_Init_FreeType(&library_), 0);
    EXPECT_EQ(FT_New_Memory_Face(library_, reinterpret_cast<const FT_Byte*>(bytes_.data()),
                                 static_cast<FT_Long>(bytes_.size()), 0, &face_),
              0);
  }
  ~LoadedFont() {
    FT_Done_Face(face_);
    FT_Done_FreeType(library_);
  }
  LoadedFont(const LoadedFont&) = delete;
  LoadedFont& operator=(const LoadedFont&) = delete;

  const FT_FaceRec_& operator*() const { return *face_; }
  bool has(char32_t c) const { return FT_Get_Char_Index(face_, c) != 0; }
  const FT_GlyphSlotRec_& glyph(char32_t c) const {
    EXPECT_EQ(FT_Load_Char(face_, c, FT_LOAD_NO_SCALE), 0);
    return *face_->glyph;
  }

 private:
  std::string bytes_;
  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
};

TEST(WebFont, HoldsTheLettersAsFiguresDrawThem) {
  for (const Face face : all_faces) {
    const LoadedFont font(web_font(face, letters));
    EXPECT_EQ((*font).units_per_EM, 1000);
    int read = 0;
    for (const char32_t c : letters) {
      const std::string text = utf8_of({&c, 1});
      SCOPED_TRACE(text);
      ASSERT_EQ(font.has(c), missing_characters(text, face).empty());
      if (!font.has(c)) continue;
      ++read;
      const FT_GlyphSlotRec_& glyph = font.glyph(c);
      EXPECT_NEAR(static_cast<double>(glyph.metrics.horiAdvance), text_width(text, face, 1000), 0.51);
      // The box of the outline's points, y up
      FT_BBox box{};
      FT_Outline_Get_CBox(&glyph.outline, &box);
      double left = 0, top = 0, right = 0, bottom = 0;
      bool first = true;
      for (const OutlinePiece& piece : outline_pieces(c, face)) {
        for (const dvec2 p : piece.points) {
          left = first ? p.x : std::min(left, p.x), right = first ? p.x : std::max(right, p.x);
          top = first ? p.y : std::min(top, p.y), bottom = first ? p.y : std::max(bottom, p.y);
          first = false;
        }
      }
      constexpr double scale = 1000 / units_per_em;
      EXPECT_NEAR(static_cast<double>(box.xMin), left * scale, 1);
      EXPECT_NEAR(static_cast<double>(box.xMax), right * scale, 1);
      EXPECT_NEAR(static_cast<double>(box.yMin), -bottom * scale, 1);
      EXPECT_NEAR(static_cast<double>(box.yMax), -top * scale, 1);
    }
    EXPECT_GT(read, 30);
    EXPECT_FALSE(font.has(U'B'));
  }
}

TEST(WebFont, SaysItsStyle) {
  for (const Face face : all_faces) {
    const LoadedFont font(web_font(face, letters));
    const bool bold = face == Face::bold || face == Face::mono_bold || face == Face::bold_italic;
    EXPECT_EQ(((*font).style_flags & FT_STYLE_FLAG_BOLD) != 0, bold);
    EXPECT_EQ(((*font).style_flags & FT_STYLE_FLAG_ITALIC) != 0,
              face == Face::italic || face == Face::bold_italic);
  }
}

TEST(WebFont, NeedsNoOrderAndNoSecondLetter) {
  EXPECT_EQ(web_font(Face::sans, U"ba"), web_font(Face::sans, U"aba "));
  EXPECT_LT(web_font(Face::sans, U"a").size(), 1600u);
  // More glyphs than CFF has names for
  std::u32string many;
  for (char32_t c = 0x20; c < 0x500; ++c) many += c;
  const LoadedFont font(web_font(Face::sans, many));
  EXPECT_GT((*font).num_glyphs, 700);
  EXPECT_TRUE(font.has(U'ѫ') || font.has(U'Ж'));
}

TEST(WebFont, PagesAndTextsInSvgBringThem) {
  const Trace trace = test::trace_of("perspective", {{"method", "depth_precision"}});
  const std::string page = player_page(trace, {});
  Playhead playhead(trace);
  Finish finish(themes()[0]);
  finish.svg_text = SvgText::text;
  const std::string svg = svg_of(lay_out(figure_of(trace, playhead, {0, 0}), {}), finish, {});
  for (const std::string& text : {page, svg}) {
    std::size_t fonts = 0;
    for (std::size_t at = text.find("url(data:font/woff"); at != text.npos;
         at = text.find("url(data:font/woff", at + 1))
      ++fonts;
    EXPECT_EQ(fonts, all_faces.size());
    EXPECT_NE(text.find("SIL Open Font License"), text.npos);
  }
}

}  // namespace
}  // namespace gradus
