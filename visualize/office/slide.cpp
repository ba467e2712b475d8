#include "office/slide.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "figure/layout/boxes.hpp"
#include "figure/text/markup.hpp"

namespace gradus {
namespace {

// Arial and Courier New, or what stands for them with the same widths, are on every machine with an Office
constexpr const char* sans_font = "Arial";
constexpr const char* mono_font = "Courier New";
constexpr double arial_ascent = 0.905, courier_ascent = 0.833;  ///< of an em, to the top of a line

bool is_mono(Face face) { return face == Face::mono || face == Face::mono_bold; }
bool is_bold(Face face) { return face == Face::bold || face == Face::mono_bold; }

double ascent_of(Face face) { return is_mono(face) ? courier_ascent : arial_ascent; }

// --- XML -----------------------------------------------------------------------------------------

std::string solid(Rgb color) {
  return fmt::format(R"(<a:solidFill><a:srgbClr val="{:06X}"/></a:solidFill>)", color.hex);
}

std::string transform(const Box& box, std::string_view space = "a") {
  return fmt::format(R"(<{0}:xfrm><a:off x="{1}" y="{2}"/><a:ext cx="{3}" cy="{4}"/></{0}:xfrm>)", space,
                     emu(box.x), emu(box.y), emu(box.width), emu(box.height));
}

/// How the letters of a run look.
struct RunLook {
  Face face = Face::sans;
  double size = 20;  ///< pixels
  Rgb color;
  bool underlined = false;
};

std::string run_properties(const RunLook& look, std::string_view tag) {
  const char* font = is_mono(look.face) ? mono_font : sans_font;
  return fmt::format(
      R"(<a:{} lang="en-GB" sz="{}"{}{}{} dirty="0">{}<a:latin typeface="{}"/><a:cs typeface="{}"/></a:{}>)",
      tag, std::lround(look.size * 75), is_bold(look.face) ? R"( b="1")" : "",
      look.face == Face::italic ? R"( i="1")" : "", look.underlined ? R"( u="sng")" : "", solid(look.color),
      font, font, tag);
}

/// A paragraph of one run; `pitch`: pixels from line to line, 0 as the font has it.
std::string paragraph(const std::string& text, const RunLook& look, Align align, double pitch = 0) {
  constexpr const char* sides[] = {"l", "ctr", "r"};
  const std::string spacing =
      pitch > 0 ? fmt::format(R"(<a:lnSpc><a:spcPts val="{}"/></a:lnSpc>)", std::lround(pitch * 75)) : "";
  const std::string properties =
      fmt::format(R"(<a:pPr algn="{}">{}</a:pPr>)", sides[static_cast<std::size_t>(align)], spacing);
  if (text.empty()) return fmt::format("<a:p>{}{}</a:p>", properties, run_properties(look, "endParaRPr"));
  return fmt::format("<a:p>{}<a:r>{}<a:t>{}</a:t></a:r></a:p>", properties, run_properties(look, "rPr"),
                     escaped(text));
}

// --- What stands where on the sheet ----------------------------------------------------------------

template <class S>
struct Found {
  std::string id;
  S shape;
};

template <class S>
std::vector<Found<S>> shapes_in(const Sheet& sheet, Slot slot) {
  std::vector<Found<S>> found;
  for (const Shape& shape : sheet.shapes) {
    if (shape.slot != slot) continue;
    if (const auto* what = std::get_if<S>(&shape.what)) found.push_back({shape.id, *what});
  }
  return found;
}

double middle(const TextShape& text) {
  const Box box = text.box();
  return box.x + box.width / 2;
}

/// The ground that is painted last under a point.
std::optional<Rgb> ground_under(const std::vector<Found<RectShape>>& rects, dvec2 point, const Theme& theme) {
  std::optional<Rgb> ground;
  for (const auto& [id, rect] : rects) {
    const bool holds = rect.box.x <= point.x && point.x <= rect.box.right() && rect.box.y <= point.y &&
                       point.y <= rect.box.bottom();
    if (holds && rect.fill.part != Paint::Part::none) ground = color_of(rect.fill, theme);
  }
  return ground;
}

// --- The slide -----------------------------------------------------------------------------------

class SlideWriter {
 public:
  SlideWriter(const PresentedStep& step, const DrawPart& draw, const Theme& theme)
      : step_(step), draw_(draw), theme_(theme), s_(step.sheet.unit) {}

  Slide finish() {
    title();
    picture(Slot::drawing, "Drawing", step_.caption);
    listing();
    table();
    sentence();
    footer();
    const Rgb paper = theme_[Tone::paper];
    slide_.xml = fmt::format(
        R"(<?xml version="1.0" encoding="UTF-8" standalone="yes"?>
<p:sld xmlns:a="http://schemas.openxmlformats.org/drawingml/2006/main" xmlns:r="http://schemas.openxmlformats.org/officeDocument/2006/relationships" xmlns:p="http://schemas.openxmlformats.org/presentationml/2006/main"><p:cSld><p:bg><p:bgPr>{}<a:effectLst/></p:bgPr></p:bg><p:spTree><p:nvGrpSpPr><p:cNvPr id="1" name=""/><p:cNvGrpSpPr/><p:nvPr/></p:nvGrpSpPr><p:grpSpPr><a:xfrm><a:off x="0" y="0"/><a:ext cx="0" cy="0"/><a:chOff x="0" y="0"/><a:chExt cx="0" cy="0"/></a:xfrm></p:grpSpPr>{}</p:spTree></p:cSld><p:clrMapOvr><a:masterClrMapping/></p:clrMapOvr></p:sld>)",
        solid(paper), shapes_);
    return std::move(slide_);
  }

 private:
  int next_id() { return ++last_id_; }

  RunLook look_of(const TextShape& text) const {
    return {text.face, text.size, color_of(text.paint, theme_), false};
  }

  void rectangle(const std::string& name, const Box& box, Rgb fill) {
    shapes_ += fmt::format(
        R"(<p:sp><p:nvSpPr><p:cNvPr id="{}" name="{}"/><p:cNvSpPr/><p:nvPr userDrawn="1"/></p:nvSpPr><p:spPr>{}<a:prstGeom prst="rect"><a:avLst/></a:prstGeom>{}<a:ln><a:noFill/></a:ln></p:spPr></p:sp>)",
        next_id(), escaped(name), transform(box), solid(fill));
  }

  /// A text box; `kind`: what else is said of it, a placeholder.
  void text_box(const std::string& name, const Box& box, const std::string& paragraphs, bool wraps = false,
                bool centred = false, std::string_view kind = "") {
    shapes_ += fmt::format(
        R"(<p:sp><p:nvSpPr><p:cNvPr id="{}" name="{}"/><p:cNvSpPr{}/><p:nvPr>{}</p:nvPr></p:nvSpPr><p:spPr>{}<a:prstGeom prst="rect"><a:avLst/></a:prstGeom><a:noFill/></p:spPr><p:txBody><a:bodyPr wrap="{}" lIns="0" tIns="0" rIns="0" bIns="0" anchor="{}"><a:noAutofit/></a:bodyPr><a:lstStyle/>{}</p:txBody></p:sp>)",
        next_id(), escaped(name), kind.empty() ? R"( txBox="1")" : "", kind, transform(box),
        wraps ? "square" : "none", centred ? "ctr" : "t", paragraphs);
  }

  /// A text where the sheet has it, its baseline kept.
  void text_as_laid_out(const std::string& name, const TextShape& text) {
    const Box box = text.box();
    text_box(name, {box.x, text.baseline.y - ascent_of(text.face) * text.size, box.width, 1.25 * text.size},
             paragraph(text.text, look_of(text), text.align));
  }

  /// The title's lines become the slide's title, which Office shows in its outline.
  void title() {
    std::optional<TextShape> first;
    std::string words;
    for (const auto& [id, text] : shapes_in<TextShape>(step_.sheet, Slot::title)) {
      if (!id.starts_with("title")) {
        text_as_laid_out(id, text);
        continue;
      }
      if (!first) first = text;
      words += (words.empty() ? "" : " ") + text.text;
    }
    if (!first) return;
    const Box box{first->baseline.x, first->baseline.y - arial_ascent * first->size,
                  step_.sheet.width - first->baseline.x, 1.25 * first->size};
    text_box("Title", box, paragraph(words, look_of(*first), Align::left), false, false,
             R"(<p:ph type="title"/>)");
  }

  /// What a slot shows, cut out of the sheet.
  void picture(Slot slot, const std::string& name, const std::string& alt) {
    Sheet part = step_.sheet;
    std::erase_if(part.shapes, [slot](const Shape& shape) {
      return shape.slot != slot || (slot == Slot::footer && std::holds_alternative<TextShape>(shape.what));
    });
    if (part.shapes.empty()) return;
    Box box = extents_of(part.shapes.front());
    for (const Shape& shape : part.shapes) box = layout::around(box, extents_of(shape));
    box = layout::grown(box, 4 * s_);
    const std::size_t i = slide_.pictures.size();
    slide_.pictures.push_back(draw_(cropped(std::move(part), box)));
    shapes_ += fmt::format(
        R"(<p:pic><p:nvPicPr><p:cNvPr id="{}" name="{}" descr="{}"/><p:cNvPicPr><a:picLocks noChangeAspect="1"/></p:cNvPicPr><p:nvPr/></p:nvPicPr><p:blipFill><a:blip r:embed="{}"><a:extLst><a:ext uri="{{96DAC541-7B7A-43D3-8B79-37D633B846F1}}"><asvg:svgBlip xmlns:asvg="http://schemas.microsoft.com/office/drawing/2016/SVG/main" r:embed="{}"/></a:ext></a:extLst></a:blip><a:stretch><a:fillRect/></a:stretch></p:blipFill><p:spPr>{}<a:prstGeom prst="rect"><a:avLst/></a:prstGeom></p:spPr></p:pic>)",
        next_id(), name, escaped(alt), png_relation(i), svg_relation(i), transform(box));
  }

  /// The code as two boxes of lines, numbers and source, over the grounds of the lines that count.
  void listing() {
    for (const auto& [id, rect] : shapes_in<RectShape>(step_.sheet, Slot::listing)) {
      rectangle(id == "panel" ? "Code ground" : id, rect.box, color_of(rect.fill, theme_));
    }
    std::vector<TextShape> numbers, lines;
    for (auto& [id, text] : shapes_in<TextShape>(step_.sheet, Slot::listing)) {
      (id.starts_with("number") ? numbers : lines).push_back(std::move(text));
    }
    lines_box("Line numbers", numbers);
    lines_box("Code", lines);
  }

  /// Lines at even distances as one text, empty ones where the sheet has a gap.
  void lines_box(const std::string& name, std::vector<TextShape>& lines) {
    if (lines.empty()) return;
    std::ranges::stable_sort(lines, {}, [](const TextShape& t) { return t.baseline.y; });
    const double size = lines.front().size;
    double pitch = 1.5 * size;
    for (std::size_t i = 1; i < lines.size(); ++i) {
      const double gap = lines[i].baseline.y - lines[i - 1].baseline.y;
      if (gap > 0.5 * size) pitch = std::min(pitch, gap);
    }
    Box box = lines.front().box();
    for (const TextShape& line : lines) box = layout::around(box, line.box());
    std::string paragraphs;
    double next = lines.front().baseline.y;
    for (const TextShape& line : lines) {
      for (; line.baseline.y - next > 0.5 * pitch; next += pitch)
        paragraphs += paragraph("", look_of(line), line.align, pitch);
      paragraphs += paragraph(line.text, look_of(line), line.align, pitch);
      next = line.baseline.y + pitch;
    }
    // Lines of a fixed height have four fifths of it above the baseline
    text_box(name,
             {box.x, lines.front().baseline.y - 0.8 * pitch, box.width, next - lines.front().baseline.y},
             paragraphs);
  }

  // A table of the sheet: its lines from above to below, the first of them with the columns' names
  struct TableLine {
    double baseline = 0;
    std::vector<TextShape> texts;
  };

  std::vector<TableLine> table_lines() const {
    std::vector<TableLine> lines;
    for (const auto& [id, text] : shapes_in<TextShape>(step_.sheet, Slot::table)) {
      const auto same = std::ranges::find_if(
          lines, [&](const TableLine& line) { return std::abs(line.baseline - text.baseline.y) < 2 * s_; });
      if (same == lines.end()) {
        lines.push_back({text.baseline.y, {text}});
      } else {
        same->texts.push_back(text);
      }
    }
    std::ranges::sort(lines, {}, &TableLine::baseline);
    for (TableLine& line : lines) std::ranges::sort(line.texts, {}, middle);
    return lines;
  }

  void table() {
    const std::vector<TableLine> lines = table_lines();
    if (lines.empty()) return;
    const auto rects = shapes_in<RectShape>(step_.sheet, Slot::table);
    Box frame = lines.front().texts.front().box();
    for (const auto& [id, rect] : rects) frame = layout::around(frame, rect.box);
    const std::vector<double> edges = column_edges(lines.front(), frame);
    std::string rows, grid;
    for (std::size_t c = 0; c + 1 < edges.size(); ++c) {
      grid += fmt::format(R"(<a:gridCol w="{}"/>)", emu(edges[c + 1]) - emu(edges[c]));
    }
    for (std::size_t r = 0; r < lines.size(); ++r) rows += table_row(lines, r, edges, frame, rects);
    shapes_ += fmt::format(
        R"(<p:graphicFrame><p:nvGraphicFramePr><p:cNvPr id="{}" name="Table"/><p:cNvGraphicFramePr><a:graphicFrameLocks noGrp="1"/></p:cNvGraphicFramePr><p:nvPr/></p:nvGraphicFramePr>{}<a:graphic><a:graphicData uri="http://schemas.openxmlformats.org/drawingml/2006/table"><a:tbl><a:tblPr firstRow="1"/><a:tblGrid>{}</a:tblGrid>{}</a:tbl></a:graphicData></a:graphic></p:graphicFrame>)",
        next_id(), transform(frame, "p"), grid, rows);
  }

  /// Half way between the names of neighbouring columns, and the frame's sides.
  static std::vector<double> column_edges(const TableLine& heading, const Box& frame) {
    std::vector<double> edges{frame.x};
    for (std::size_t c = 1; c < heading.texts.size(); ++c) {
      edges.push_back((middle(heading.texts[c - 1]) + middle(heading.texts[c])) / 2);
    }
    edges.push_back(frame.right());
    return edges;
  }

  std::string table_row(const std::vector<TableLine>& lines, std::size_t r, const std::vector<double>& edges,
                        const Box& frame, const std::vector<Found<RectShape>>& rects) {
    const TableLine& line = lines[r];
    const double size = line.texts.front().size;
    const double above = r == 0 ? frame.y : (lines[r - 1].baseline + line.baseline) / 2 - 0.35 * size;
    const double below =
        r + 1 == lines.size() ? frame.bottom() : (line.baseline + lines[r + 1].baseline) / 2 - 0.35 * size;
    std::string cells;
    for (std::size_t c = 0; c + 1 < edges.size(); ++c) {
      const auto text = std::ranges::find_if(
          line.texts, [&](const TextShape& t) { return edges[c] <= middle(t) && middle(t) < edges[c + 1]; });
      RunLook look = look_of(text == line.texts.end() ? line.texts.front() : *text);
      look.underlined = r > 0 && is_bold(look.face);
      const dvec2 inside{(edges[c] + edges[c + 1]) / 2, line.baseline - 0.3 * size};
      const Rgb ground = ground_under(rects, inside, theme_).value_or(theme_[Tone::paper]);
      const std::string rule = solid(theme_[Tone::rule]);
      cells += fmt::format(
          R"(<a:tc><a:txBody><a:bodyPr/><a:lstStyle/>{}</a:txBody><a:tcPr marL="0" marR="0" marT="0" marB="0" anchor="ctr"><a:lnL><a:noFill/></a:lnL><a:lnR><a:noFill/></a:lnR><a:lnT w="12700">{}</a:lnT><a:lnB w="12700">{}</a:lnB>{}</a:tcPr></a:tc>)",
          paragraph(text == line.texts.end() ? "" : text->text, look, Align::centre), rule, rule,
          solid(ground));
    }
    return fmt::format(R"(<a:tr h="{}">{}</a:tr>)", emu(below - above), cells);
  }

  void sentence() {
    Box panel;
    for (const auto& [id, rect] : shapes_in<RectShape>(step_.sheet, Slot::sentence)) {
      rectangle(id == "panel" ? "Sentence ground" : id, rect.box, color_of(rect.fill, theme_));
      if (id == "panel") panel = rect.box;
    }
    const auto lines = shapes_in<TextShape>(step_.sheet, Slot::sentence);
    if (lines.empty()) return;
    std::string paragraphs;
    for (const auto& [id, text] : lines) paragraphs += paragraph(text.text, look_of(text), Align::left);
    const double left = lines.front().shape.box().x;
    text_box("Sentence", {left, panel.y, panel.right() - left, panel.height}, paragraphs, false, true);
  }

  /// The step's number and the legend: marks as a picture, words as text.
  void footer() {
    std::string words;
    for (const auto& [id, text] : shapes_in<TextShape>(step_.sheet, Slot::footer)) {
      text_as_laid_out(id, text);
      if (id != "position") words += (words.empty() ? "" : ", ") + text.text;
    }
    picture(Slot::footer, "Legend", words);
  }

  const PresentedStep& step_;
  const DrawPart& draw_;
  const Theme& theme_;
  double s_;  ///< pixels for a unit of the layout
  Slide slide_;
  std::string shapes_;
  int last_id_ = 1;
};

}  // namespace

long long emu(double pixels) { return std::llround(pixels * 9525); }
std::string png_relation(std::size_t i) { return fmt::format("rIdPng{}", i); }
std::string svg_relation(std::size_t i) { return fmt::format("rIdSvg{}", i); }

Slide slide_of(const PresentedStep& step, const DrawPart& draw, const Theme& theme) {
  return SlideWriter(step, draw, theme).finish();
}

}  // namespace gradus
