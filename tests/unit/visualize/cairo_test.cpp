// Files: the same bytes every time, whole, and able to say how they were made.

#include "cairo/cairo_output.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <thread>

#include "figure/figure.hpp"
#include "figure/metrics.hpp"
#include "support/example_traces.hpp"

namespace gradus {
namespace {

Sheet sheet_at(const Trace& trace, StepNumber number) {
  Playhead playhead(trace);
  return lay_out(figure_of(trace, playhead, number), {});
}

const Colophon hostile{
    "<b>Title</b> & \"more\"", "caption ]]> </desc> \xc3\xa9",
    "gradus figure flood_fill --maze '#.#/[x]' --color '#d55e00' --x \"<script>\" %41 \xe2\x88\x92",
    "fnv1a64:0123456789abcdef"};

TEST(CairoOutput, MetricsTableIsTheFonts) {
  const std::string text = "p = −3 < 0: the line (4, 2) · Σ ≥ ⋮ × … ÄÖ";
  for (const Face face : {Face::sans, Face::bold, Face::italic, Face::mono, Face::mono_bold}) {
    std::string known;  // not every face has every character
    for (const char32_t character : code_points(text)) {
      const std::string one = utf8_of(std::u32string(1, character));
      if (missing_characters(one, face).empty()) known += one;
    }
    EXPECT_GT(known.size(), 40u);
    EXPECT_NEAR(drawn_width(known, face, 100), text_width(known, face, 100), 0.5);
  }
}

TEST(CairoOutput, SameSheetSameBytes) {
  const Trace trace = test::trace_of("bresenham_line");
  const Sheet sheet = sheet_at(trace, {4, 0});
  const Theme& light = themes()[0];
  const std::string svg = svg_of(sheet, light, hostile), png = png_of(sheet, light, hostile);
  const auto same = [&sheet](std::size_t) { return sheet; };
  const std::string pdf = pdf_of(2, same, light, hostile);
  EXPECT_EQ(svg_of(sheet, light, hostile), svg) << "Cairo numbers SVG groups through the whole process";
  EXPECT_EQ(png_of(sheet, light, hostile), png);
  EXPECT_EQ(pdf_of(2, same, light, hostile), pdf);
}

TEST(CairoOutput, SameImagesSameBytes) {
  // Pictures have ids of their own, which Cairo counts through the whole process too
  const Trace trace = test::trace_of(
      "flood_fill",
      {{"image", std::string(GRADUS_SOURCE_DIR) + "/examples/images/camera.png"}, {"at", "300,60"}}, {0, 50});
  const Sheet sheet = sheet_at(trace, {2, 0});
  const std::string first = svg_of(sheet, themes()[0], hostile);
  EXPECT_NE(first.find("id=\"image1\""), std::string::npos);
  EXPECT_NE(first.find("id=\"image2\""), std::string::npos) << "the view and the overview";
  EXPECT_EQ(svg_of(sheet, themes()[0], hostile), first);
}

TEST(CairoOutput, ThreadsGiveTheSameBytes) {
  const Trace trace = test::trace_of("flood_fill");
  const Sheet sheet = sheet_at(trace, {5, 0});
  const std::string svg = svg_of(sheet, themes()[1], hostile), png = png_of(sheet, themes()[1], hostile);
  std::vector<std::string> svgs(8), pngs(8);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < 8; ++i) {
    threads.emplace_back([&, i] {
      svgs[i] = svg_of(sheet, themes()[1], hostile);
      pngs[i] = png_of(sheet, themes()[1], hostile);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(svgs[i], svg);
    EXPECT_EQ(pngs[i], png);
  }
}

TEST(CairoOutput, FilesSayHowTheyWereMade) {
  const Trace trace = test::trace_of("bresenham_line");
  const Sheet sheet = sheet_at(trace, {4, 0});
  for (const std::string& bytes : {svg_of(sheet, themes()[0], hostile), png_of(sheet, themes()[0], hostile),
                                   pdf_of(1, [&](std::size_t) { return sheet; }, themes()[0], hostile)}) {
    const auto found = colophon_in(bytes);
    ASSERT_TRUE(found) << bytes.substr(0, 20);
    EXPECT_EQ(found->command, hostile.command);
    EXPECT_EQ(found->input_hash, hostile.input_hash);
  }
  EXPECT_FALSE(colophon_in("<svg></svg>"));
  EXPECT_FALSE(colophon_in("%PDF-1.5 nothing"));
}

TEST(CairoOutput, SvgEscapesAndNumbersFromOne) {
  const Trace trace = test::trace_of("bresenham_line");
  const std::string svg = svg_of(sheet_at(trace, {4, 0}), themes()[0], hostile);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  EXPECT_EQ(svg.find("<b>"), std::string::npos);
  const std::regex number("surface([0-9]+)");
  std::size_t count = 0;
  for (std::sregex_iterator i(svg.begin(), svg.end(), number), end; i != end; ++i) {
    EXPECT_LE(std::stoi((*i)[1]), 20);
    ++count;
  }
  EXPECT_GT(count, 0u);
  EXPECT_NE(svg.find("width=\"1280px\""), std::string::npos) << svg.substr(0, 300);
}

TEST(CairoOutput, PngHoldsTheFigure) {
  const Trace trace = test::trace_of("bresenham_line");
  const std::string png = png_of(sheet_at(trace, {4, 0}), themes()[0], hostile);
  const Image image = decode_png({reinterpret_cast<const std::uint8_t*>(png.data()), png.size()}, "figure");
  EXPECT_EQ(image.width(), 1280);
  EXPECT_EQ(image.height(), 720);
  EXPECT_EQ((image[{3, 3}]), (Rgba8{255, 255, 255, 255}));
  std::size_t ink = 0;
  for (const Rgba8& pixel : image.cells()) ink += pixel.r < 128;
  EXPECT_GT(ink, 5000u);
}

TEST(CairoOutput, EveryThemeDrawsEveryTellingTrace) {
  for (const Trace& trace : test::telling_traces()) {
    for (const Theme& theme : themes()) {
      const std::string svg = svg_of(sheet_at(trace, trace.steps.back().number), theme, hostile);
      EXPECT_NE(svg.find("</svg>"), std::string::npos);
      EXPECT_EQ(svg.find("=\"nan"), std::string::npos) << trace.subtitle;
      EXPECT_EQ(svg.find(" nan "), std::string::npos) << trace.subtitle;
    }
  }
}

}  // namespace
}  // namespace gradus
