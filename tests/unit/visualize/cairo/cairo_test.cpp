// Files: the same bytes every time, whole, and able to say how they were made.

#include "cairo/cairo_output.hpp"
#include "cairo/colophon_markup.hpp"
#include "cairo/fonts.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <thread>

#include "figure/figure.hpp"
#include "figure/text/metrics.hpp"
#include "support/example_traces.hpp"
#include "support/sanitized.hpp"
#include "support/sheets.hpp"

namespace gradus {
namespace {

Sheet sheet_at(const Trace& trace, StepNumber number) {
  Playhead playhead(trace);
  return lay_out(figure_of(trace, playhead, number), {});
}

/// All telling traces; under a sanitizer every fourth of them.
std::vector<const Trace*> some_traces() {
  std::vector<const Trace*> some;
  std::size_t number = 0;
  for (const Trace& trace : test::shared_traces()) {
    if (!test::sanitized || number++ % 4 == 0) some.push_back(&trace);
  }
  return some;
}

const Colophon hostile_colophon{
    "<b>Title</b> & \"more\"", "caption ]]> </desc> \xc3\xa9",
    "gradus figure flood_fill --maze '#.#/[x]' --paint '#d55e00' --x \"<script>\" %41 \xe2\x88\x92",
    "fnv1a64:0123456789abcdef"};

TEST(CairoOutput, MetricsTableIsTheFonts) {
  std::size_t compared = 0;
  for (const Face face : all_faces) {
    for (char32_t character = U' '; character < 0x3000; ++character) {
      const std::string one = utf8_of({&character, 1});
      if (!missing_characters(one, face).empty()) continue;
      ++compared;
      // In font units, of which the table has whole ones
      EXPECT_NEAR(drawn_width(one, face, units_per_em), text_width(one, face, units_per_em), 0.6) << one;
    }
  }
  EXPECT_GT(compared, 10'000u);
}

TEST(CairoOutput, SameSheetSameBytes) {
  const Trace trace = test::trace_of("bresenham_line");
  const Sheet sheet = sheet_at(trace, {4, 0});
  const Theme& light = themes()[0];
  const std::string svg = svg_of(sheet, light, hostile_colophon),
                    png = png_of(sheet, light, hostile_colophon);
  const auto same = [&sheet](std::size_t) { return sheet; };
  const std::string pdf = pdf_of(2, same, light, hostile_colophon);
  EXPECT_EQ(svg_of(sheet, light, hostile_colophon), svg);
  EXPECT_EQ(png_of(sheet, light, hostile_colophon), png);
  EXPECT_EQ(pdf_of(2, same, light, hostile_colophon), pdf);
}

TEST(CairoOutput, SameImagesSameBytes) {
  const Trace trace = test::trace_of(
      "flood_fill",
      {{"image", std::string(GRADUS_SOURCE_DIR) + "/examples/images/camera.png"}, {"at", "300,60"}}, {0, 50});
  const Sheet sheet = sheet_at(trace, {2, 0});
  const std::string first = svg_of(sheet, themes()[0], hostile_colophon);
  EXPECT_NE(first.find("data-id=\"picture\""), std::string::npos);
  EXPECT_NE(first.find("data-id=\"overview\""), std::string::npos);
  EXPECT_EQ(svg_of(sheet, themes()[0], hostile_colophon), first);
}

TEST(CairoOutput, APictureOnManyPagesIsInTheDocumentOnce) {
  const Trace trace =
      test::trace_of("flood_fill", {{"image", std::string(GRADUS_SOURCE_DIR) + "/examples/images/camera.png"},
                                    {"at", "300,60"},
                                    {"tolerance", "20"}});
  std::vector<Sheet> sheets;
  for (const std::int64_t step : {2, 20, 40}) sheets.push_back(sheet_at(trace, {step, 0}));
  const std::string pdf =
      pdf_of(sheets.size(), [&sheets](std::size_t i) { return sheets[i]; }, themes()[0], hostile_colophon);
  const std::regex whole_picture("/Width 512");
  EXPECT_EQ(std::distance(std::sregex_iterator(pdf.begin(), pdf.end(), whole_picture), {}), 1)
      << "pixels that are painted meanwhile lie over it";
}

TEST(CairoOutput, ThreadsGiveTheSameBytes) {
  const Trace trace = test::trace_of("flood_fill");
  const Sheet sheet = sheet_at(trace, {5, 0});
  const std::string svg = svg_of(sheet, themes()[1], hostile_colophon),
                    png = png_of(sheet, themes()[1], hostile_colophon);
  std::vector<std::string> svgs(8), pngs(8);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < 8; ++i) {
    threads.emplace_back([&, i] {
      svgs[i] = svg_of(sheet, themes()[1], hostile_colophon);
      pngs[i] = png_of(sheet, themes()[1], hostile_colophon);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(svgs[i], svg);
    EXPECT_EQ(pngs[i], png);
  }
}

TEST(CairoOutput, ThreadsMayLetGoOfTheSameFontAtOnce) {
  // Cairo 1.16 aborts when one thread frees a scaled font that another one finds again meanwhile
  const Trace trace = test::trace_of("bresenham_line");
  const Sheet sheet = sheet_at(trace, {4, 0});
  const Theme& light = themes()[0];
  const auto draw = [&] {
    for (int i = 0; i < (test::sanitized ? 10 : 60); ++i) {
      Finish finish = light;
      finish.scale = 0.2 + 0.01 * i;  // fonts of sizes that nobody holds
      EXPECT_GT(image_of(sheet, finish).width(), 0);
      EXPECT_FALSE(pdf_of(1, [&](std::size_t) { return sheet; }, light, hostile_colophon).empty());
    }
  };
  std::vector<std::jthread> threads;
  for (int i = 0; i < 3; ++i) threads.emplace_back(draw);
  draw();
}

TEST(CairoOutput, FilesSayHowTheyWereMade) {
  const Trace trace = test::trace_of("bresenham_line");
  const Sheet sheet = sheet_at(trace, {4, 0});
  for (const std::string& bytes :
       {svg_of(sheet, themes()[0], hostile_colophon), png_of(sheet, themes()[0], hostile_colophon),
        pdf_of(1, [&](std::size_t) { return sheet; }, themes()[0], hostile_colophon)}) {
    const auto found = colophon_in(bytes);
    ASSERT_TRUE(found) << bytes.substr(0, 20);
    EXPECT_EQ(found->command, hostile_colophon.command);
    EXPECT_EQ(found->input_hash, hostile_colophon.input_hash);
  }
  EXPECT_FALSE(colophon_in("<svg></svg>"));
  EXPECT_FALSE(colophon_in("%PDF-1.5 nothing"));
}

/// All matches of a pattern's first group.
std::vector<std::string> all(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator i(text.begin(), text.end(), regex), end; i != end; ++i) found.push_back((*i)[1]);
  return found;
}

TEST(Svg, SaysWhatItShowsFirst) {
  const Trace trace = test::trace_of("bresenham_line");
  const std::string svg = svg_of(sheet_at(trace, {4, 0}), themes()[0], hostile_colophon);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  EXPECT_EQ(svg.find("<b>"), std::string::npos);
  EXPECT_NE(svg.find("width=\"1280px\" height=\"720px\" viewBox=\"0 0 1280 720\""), std::string::npos);
  const auto names = all(svg, "role=\"img\" aria-labelledby=\"(title-[0-9a-f]{8} desc-[0-9a-f]{8})\"");
  ASSERT_EQ(names.size(), 1u);
  const std::size_t first = svg.find('<', svg.find("<svg") + 1);
  EXPECT_EQ(svg.find("<title id=\"" + names[0].substr(0, 14) + "\">&lt;b&gt;Title"), first);
  EXPECT_NE(svg.find("<desc id=\"" + names[0].substr(15) + "\">caption ]]&gt;"), std::string::npos);
}

TEST(Svg, EveryIdIsUniqueAndEveryLetterKnown) {
  for (const Trace* each : some_traces()) {
    const Trace& trace = *each;
    const std::string svg = svg_of(sheet_at(trace, trace.steps.back().number), themes()[0], hostile_colophon);
    const auto ids = all(svg, " id=\"([^\"]*)\"");
    const std::set<std::string> once(ids.begin(), ids.end());
    EXPECT_EQ(once.size(), ids.size()) << trace.subtitle;
    const auto used = all(svg, "<use xlink:href=\"#([^\"]*)\"");
    const std::set<std::string> letters(used.begin(), used.end());
    const auto known = all(svg, "<path id=\"([^\"]*)\"");
    EXPECT_EQ(letters, std::set<std::string>(known.begin(), known.end())) << "those used and no others";
    EXPECT_GT(letters.size(), 30u);
  }
}

TEST(Svg, GroupsAreSlotsAndRolesInDrawingOrder) {
  for (const Trace* each : some_traces()) {
    const Trace& trace = *each;
    const Sheet sheet = sheet_at(trace, trace.steps[trace.steps.size() / 2].number);
    const std::string svg = svg_of(sheet, themes()[0], hostile_colophon);
    for (const Slot slot : all_slots) {
      EXPECT_NE(svg.find(std::string("<g id=\"") + std::string(name_of(slot)) + "\" class=\"slot-"),
                std::string::npos);
    }
    EXPECT_EQ(all(svg, "(<g[ >])").size(), all(svg, "(</g>)").size());
    std::vector<std::string> drawn;  // shapes in their order, each once however many elements it takes
    for (const Shape& shape : sheet.shapes) {
      if (drawn.empty() || drawn.back() != shape.id) drawn.push_back(shape.id);
    }
    std::vector<std::string> written;
    for (const std::string& id : all(svg, " data-id=\"([^\"]*)\"")) {
      if (written.empty() || written.back() != id) written.push_back(id);
    }
    EXPECT_EQ(written, drawn) << trace.subtitle;
  }
  const Trace trace = test::trace_of("bresenham_line");
  const std::string svg = svg_of(sheet_at(trace, {4, 0}), themes()[0], hostile_colophon);
  EXPECT_NE(svg.find("<g id=\"drawing-current\" class=\"role-current\">"), std::string::npos);
  EXPECT_NE(svg.find("<g id=\"drawing-rule\" class=\"tone-rule\">"), std::string::npos);
  EXPECT_NE(svg.find("<g id=\"drawing-current-2\" class=\"role-current\">"), std::string::npos)
      << "its outline comes after the grid";
}

TEST(Svg, NumbersAreShort) {
  const Trace trace = test::trace_of("flood_fill");
  const std::string svg = svg_of(sheet_at(trace, {4, 0}), themes()[0], hostile_colophon);
  std::size_t count = 0;
  for (const std::string& number : all(svg, " (?:x|y|width|height|stroke-width|cx|cy|r)=\"(-?[0-9.]+)\"")) {
    EXPECT_TRUE(std::regex_match(number, std::regex("-?(0|[1-9][0-9]*)(\\.[0-9]?[1-9])?"))) << number;
    ++count;
  }
  EXPECT_GT(count, 300u);
}

TEST(Svg, NumbersAreRight) {
  const auto x_of = [](double x) {
    const Sheet sheet{100, 100, {{Slot::drawing, "", RectShape{{x, 0, 1, 1}, Paint::of(Tone::ink), {}}}}};
    return all(svg_of(sheet, themes()[0], hostile_colophon), "<rect x=\"([^\"]*)\"").at(0);
  };
  for (const auto& [value, text] : {std::pair{0.0, "0"},
                                    {-0.001, "0"},
                                    {0.004, "0"},
                                    {0.05, "0.05"},
                                    {-0.5, "-0.5"},
                                    {12.34, "12.34"},
                                    {99.999, "100"},
                                    {1280, "1280"},
                                    {-7.1, "-7.1"}}) {
    EXPECT_EQ(x_of(value), text);
  }
}

TEST(Svg, TextStaysText) {
  const Trace trace = test::trace_of("bresenham_line");
  const Sheet sheet = sheet_at(trace, {4, 0});
  Finish finish(themes()[0]);
  finish.svg_text = SvgText::text;
  const std::string svg = svg_of(sheet, finish, hostile_colophon);
  EXPECT_EQ(svg.find("<use"), std::string::npos);
  EXPECT_EQ(svg.find("<defs"), std::string::npos);
  // Names in their own colours are parts of the text
  const std::string plain = std::regex_replace(svg, std::regex("</?tspan[^>]*>"), "");
  std::size_t texts = 0;
  for (const Shape& shape : sheet.shapes) {
    const TextShape* text = std::get_if<TextShape>(&shape.what);
    if (!text || text->paint.part == Paint::Part::none) continue;  // a rim alone, below the marks
    ++texts;
    std::string escaped;
    for (const char c : text->text)
      escaped += c == '<'    ? "&lt;"
                 : c == '>'  ? "&gt;"
                 : c == '&'  ? "&amp;"
                 : c == '\'' ? "&#39;"
                             : std::string(1, c);
    EXPECT_NE(plain.find(">" + escaped + "</text>"), std::string::npos) << text->text;
  }
  EXPECT_EQ(all(svg, "(<text (?![^>]*aria-hidden))").size(), texts) << "a rim is not read twice";
  EXPECT_EQ(all(svg, "textLength=\"([0-9.]+)\"").size(), all(svg, "(<text )").size());
  EXPECT_NE(svg.find("xml:space=\"preserve\">  "), std::string::npos) << "the listing keeps its indentation";
}

TEST(Svg, HostileTextsStayTexts) {
  Sheet sheet{400, 100, {}};
  const std::string nasty = "<&>\"'\x01\x7f\n\xff\xed\xa0\x80]]>";
  sheet.shapes.push_back(
      {Slot::title, nasty, TextShape{{10, 50}, nasty, Face::sans, 20, Align::left, Paint::of(Tone::ink)}});
  Finish finish(themes()[0]);
  for (const SvgText how : {SvgText::text, SvgText::outlines}) {
    finish.svg_text = how;
    const std::string svg = svg_of(sheet, finish, {nasty, nasty, nasty, nasty});
    for (const char c : svg) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 || c == '\n');
    EXPECT_EQ(svg.find('\xff'), std::string::npos);
    EXPECT_EQ(svg.find("\xed\xa0"), std::string::npos) << "half a surrogate pair";
    EXPECT_EQ(svg.find("]]>"), std::string::npos);
    EXPECT_NE(svg.find("data-id=\"&lt;&amp;&gt;&quot;&#39;\xef\xbf\xbd"), std::string::npos);
  }
}

// --- Finish -----------------------------------------------------------------------------------------------

TEST(Svg, ACommandWithControlCharactersComesBack) {
  Colophon colophon;
  colophon.command = "gradus figure flood_fill --image '\u202e\r\x7f\u061c<&#x41;.png'";
  const std::string element = markup_of(colophon);
  EXPECT_EQ(element.find("\u202e"), std::string::npos);
  EXPECT_EQ(element.find('\r'), std::string::npos);
  const auto found = colophon_in("<svg>" + element + "</svg>");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->command, colophon.command);
}

// A search to the end of the file from every & would take hours
TEST(Svg, ACommandOfAmpersandsIsReadInLinearTime) {
  const std::string many(4 << 20, '&');
  const auto found = colophon_in("<svg gradus-command=\"" + many + "\"></svg>");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->command, many);
}

TEST(Finish, TransparentHasNoGround) {
  const Trace trace = test::trace_of("bresenham_line");
  const Sheet sheet = sheet_at(trace, {4, 0});
  Finish finish(themes()[0]);
  finish.transparent = true;
  EXPECT_EQ(svg_of(sheet, finish, hostile_colophon).find("id=\"paper\""), std::string::npos);
  EXPECT_NE(svg_of(sheet, themes()[0], hostile_colophon).find("id=\"paper\""), std::string::npos);
  // Over white it is the figure on white: what un-premultiplying got wrong would show
  const Image clear = image_of(sheet, finish), opaque = image_of(sheet, themes()[0]);
  ASSERT_EQ(clear.cells().size(), opaque.cells().size());
  std::size_t partly = 0;
  for (std::size_t i = 0; i < clear.cells().size(); ++i) {
    const Rgba8 c = clear.cells()[i], o = opaque.cells()[i];
    const auto over = [&c](int v) { return (v * c.a + 255 * (255 - c.a)) / 255.0; };
    ASSERT_NEAR(over(c.r), o.r, 3);
    ASSERT_NEAR(over(c.g), o.g, 3);
    ASSERT_NEAR(over(c.b), o.b, 3);
    partly += 0 < c.a && c.a < 255;
  }
  EXPECT_EQ((clear[{3, 3}]), (Rgba8{0, 0, 0, 0}));
  EXPECT_GT(partly, 5000u);
}

TEST(Finish, TransparentEdgesHaveTheInksColour) {
  const Sheet sheet{
      40, 40, {{Slot::drawing, "", DiscShape{{20, 20}, 12.3, Paint::mark(Role::current), {}, 0}}}};
  Finish finish(themes()[0]);
  finish.transparent = true;
  const Rgb ink = themes()[0][Role::current].mark;
  std::size_t edges = 0;
  const Image image = image_of(sheet, finish);
  for (const Rgba8& c : image.cells()) {
    if (c.a < 32) continue;
    edges += c.a < 255;
    EXPECT_NEAR(c.r, ink.hex >> 16, 4);
    EXPECT_NEAR(c.g, ink.hex >> 8 & 255, 4);
    EXPECT_NEAR(c.b, ink.hex & 255, 4);
  }
  EXPECT_GT(edges, 20u);
}

TEST(Finish, PdfPagesHaveTheirOwnSizes) {
  const std::array<Sheet, 3> sheets{Sheet{1280, 720, {}}, Sheet{794, 1123, {}}, Sheet{400, 300, {}}};
  Finish finish(themes()[1]);
  const auto pdf = [&] {
    return pdf_of(3, [&](std::size_t i) { return sheets[i]; }, finish, hostile_colophon);
  };
  const std::string opaque = pdf();
  EXPECT_EQ(all(opaque, "/MediaBox \\[ 0 0 ([0-9. ]+) \\]"),
            (std::vector<std::string>{"960 540", "595.5 842.25", "300 225"}));
  finish.transparent = true;
  EXPECT_NE(pdf(), opaque);
}

TEST(Finish, ScaleIsSharp) {
  const Sheet sheet{101, 50, {{Slot::drawing, "", RectShape{{10.5, 10, 20, 20}, Paint::of(Tone::ink), {}}}}};
  Finish finish(themes()[0]);
  finish.scale = 2;
  const Image image = image_of(sheet, finish);
  EXPECT_EQ(image.width(), 202);
  EXPECT_EQ(image.height(), 100);
  const Rgba8 ink{0x1b, 0x1f, 0x24, 255}, paper{255, 255, 255, 255};
  for (const Rgba8& c : image.cells())
    EXPECT_TRUE(c == ink || c == paper) << "half a pixel is a whole one at 2";
  EXPECT_EQ((image[{21, 20}]), ink);
  EXPECT_EQ((image[{20, 20}]), paper);
  finish.scale = 0.1;
  EXPECT_EQ(image_of(sheet, finish).width(), 10);
  finish.scale = 400;
  EXPECT_THROW(image_of(sheet, finish), std::runtime_error);
}

TEST(Finish, AnotherPaper) {
  for (const Theme& theme : themes()) EXPECT_FALSE(low_contrast(theme)) << theme.name;
  const Theme cream = with_paper(themes()[0], {0xfff8e7});
  EXPECT_FALSE(low_contrast(cream));
  EXPECT_EQ(cream[Tone::paper], (Rgb{0xfff8e7}));
  EXPECT_EQ(cream[Role::input].fill, (Rgb{0xfff8e7})) << "cells of the ground's colour follow";
  EXPECT_EQ(cream[Role::past].fill, themes()[0][Role::past].fill);
  EXPECT_EQ(cream[Tone::ink], themes()[0][Tone::ink]);
  const auto dark = low_contrast(with_paper(themes()[0], {0x303030}));
  ASSERT_TRUE(dark);
  EXPECT_EQ(dark->what, "texts");
  EXPECT_EQ(dark->least, 4.5);
  EXPECT_NEAR(dark->found, contrast({0x1b1f24}, {0x303030}), 1e-9) << "ink, the worst of all";
  const auto grey = low_contrast(with_paper(themes()[0], {0xd8d8d8}));
  ASSERT_TRUE(grey);
  EXPECT_LT(grey->found, grey->least);
}

TEST(CairoOutput, PngHoldsTheFigure) {
  const Trace trace = test::trace_of("bresenham_line");
  const std::string png = png_of(sheet_at(trace, {4, 0}), themes()[0], hostile_colophon);
  const Image image = decode_png({reinterpret_cast<const std::uint8_t*>(png.data()), png.size()}, "figure");
  EXPECT_EQ(image.width(), 1280);
  EXPECT_EQ(image.height(), 720);
  EXPECT_EQ((image[{3, 3}]), (Rgba8{255, 255, 255, 255}));
  std::size_t ink = 0;
  for (const Rgba8& pixel : image.cells()) ink += pixel.r < 128;
  EXPECT_GT(ink, 5000u);
}

TEST(CairoOutput, GreyscaleIsGreyInEveryPixel) {
  const Trace trace = test::trace_of("z_buffer");
  const std::string png = png_of(sheet_at(trace, trace.telling), *find_theme("greyscale"), hostile_colophon);
  const Image image = decode_png({reinterpret_cast<const std::uint8_t*>(png.data()), png.size()}, "figure");
  for (const Rgba8& pixel : image.cells()) {
    ASSERT_EQ(pixel.r, pixel.g);
    ASSERT_EQ(pixel.g, pixel.b);
  }
}

TEST(CairoOutput, EveryThemeDrawsEveryTellingTrace) {
  for (const Trace* each : some_traces()) {
    const Trace& trace = *each;
    for (const Theme& theme : themes()) {
      const std::string svg = svg_of(sheet_at(trace, trace.steps.back().number), theme, hostile_colophon);
      EXPECT_NE(svg.find("</svg>"), std::string::npos);
      EXPECT_EQ(svg.find("=\"nan"), std::string::npos) << trace.subtitle;
      EXPECT_EQ(svg.find(" nan "), std::string::npos) << trace.subtitle;
    }
  }
}

}  // namespace
}  // namespace gradus
