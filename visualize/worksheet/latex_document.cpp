#include "worksheet/latex_document.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "figure/text/metrics.hpp"
#include "text/escape.hpp"

namespace gradus::worksheet {
namespace {

/// Signs that LaTeX's own encodings lack, for math mode.
struct DeclaredSign {
  char32_t character;
  std::string_view as;
};
constexpr DeclaredSign declared_signs[] = {
    {U'≈', "\\approx"},
    {U'∞', "\\infty"},
    {U'°', "^\\circ"},
    {U'³', "^3"},
    {U'Δ', "\\Delta"},
    {U'α', "\\alpha"},
    {U'β', "\\beta"},
    {U'γ', "\\gamma"},
    {U'δ', "\\delta"},
    {U'ε', "\\varepsilon"},
    {U'θ', "\\theta"},
    {U'λ', "\\lambda"},
    {U'μ', "\\mu"},
    {U'π', "\\pi"},
    {U'ρ', "\\rho"},
    {U'σ', "\\sigma"},
    {U'φ', "\\varphi"},
    {U'ω', "\\omega"},
    {U'′', "'"},
    {U'⋮', "\\vdots"},
    {U'₀', "_0"},
    {U'₁', "_1"},
    {U'₂', "_2"},
    {U'₃', "_3"},
    {U'₄', "_4"},
    {U'ₙ', "_n"},
    {U'¹', "^1"},
    {U'⁻', "^-"},
    {U'ᵀ', "^T"},
    {U'∈', "\\in"},
    {U'⌊', "\\lfloor"},
    {U'⌋', "\\rfloor"},
    {U'⌈', "\\lceil"},
    {U'⌉', "\\rceil"},
    {U'∪', "\\cup"},
    {U'∩', "\\cap"},
    {U'∧', "\\wedge"},
    {U'∨', "\\vee"},
    {U'±', "\\pm"},
    {U'∅', "\\emptyset"},
    {U'⇒', "\\Rightarrow"},
    {U'←', "\\leftarrow"},
    {U'↔', "\\leftrightarrow"},
    {U'½', "\\frac12"},
    {U'∥', "\\parallel"},
};

/// What pdflatex has in its fonts without more: the letters of Latin-1 and Latin Extended-A, dashes, quotes.
bool is_known(char32_t c) {
  return c < 0x80 || (0xc0 <= c && c <= 0x17f) || c == 0x2013 || c == 0x2014 ||
         (0x2018 <= c && c <= 0x201e) || c == 0x2026 || c == 0xab || c == 0xbb || c == 0xb7 || c == 0xa7;
}

/// Declarations of the signs in a text that need some.
std::string declarations(const std::string& body) {
  std::set<char32_t> signs;
  for (const char32_t c : code_points(body)) {
    if (!is_known(c)) signs.insert(c);
  }
  std::string out;
  for (const char32_t c : signs) {
    const auto* const known = std::ranges::find(declared_signs, c, &DeclaredSign::character);
    if (known == std::end(declared_signs)) continue;
    out += fmt::format("\\DeclareUnicodeCharacter{{{:04X}}}{{\\ensuremath{{{}}}}}\n",
                       static_cast<std::uint32_t>(c), known->as);
  }
  // Engines of today read Unicode themselves
  return out.empty() ? "" : "\\ifdefined\\DeclareUnicodeCharacter\n" + out + "\\fi\n";
}

std::string latex_cell_of(const ExerciseRow& row, std::size_t column, Part part) {
  const std::string& text = row.cells[column];
  if (text.empty()) return "\\unused";
  if (!row.asked[column]) return latex_cell(text);
  return part == Part::key ? fmt::format("\\answer{{{}}}", latex_cell(text)) : "\\blank";
}

std::string task_table(const Task& task, Part part) {
  const Exercise& exercise = task.variant->exercise;
  const Wording& wording = wording_of(task);
  std::vector<std::string> heading;
  for (const Column& column : exercise.trace->columns) heading.push_back(latex_cell(column.name));
  std::string alignment(heading.size(), 'c');
  if (part == Part::key) {
    alignment += "lr";
    heading.push_back(latex_escaped(wording.say("worksheet.decision_heading")));
    heading.push_back(latex_escaped(wording.say("worksheet.points_heading")));
  }
  // Many columns get shorter blanks
  const double blank = std::min(14.0, 130.0 / static_cast<double>(exercise.trace->columns.size()) - 4);
  std::string out = fmt::format(
      "\\setlength{{\\blankwidth}}{{{:.1f}mm}}\n\\begin{{tabular}}{{{}}}\n\\toprule\n{} \\\\\n\\midrule\n",
      blank, alignment, fmt::join(heading, " & "));
  for (std::size_t r = 0; r < exercise.rows.size(); ++r) {
    const ExerciseRow& row = exercise.rows[r];
    std::vector<std::string> cells;
    for (std::size_t c = 0; c < row.cells.size(); ++c) cells.push_back(latex_cell_of(row, c, part));
    if (part == Part::key) {
      cells.push_back(latex_escaped(row.decision));
      const Points points = task.worth.rows[r];
      cells.push_back(points.parts > 0 ? text_of(points, wording) : "--");
    }
    out += fmt::format("\\tall {} \\\\\n", fmt::join(cells, " & "));
  }
  return out + "\\bottomrule\n\\end{tabular}\n";
}

std::string latex_paragraph(std::string_view text) { return latex_escaped(text) + "\\par\n"; }

std::string task_page(const StudentSheet& sheet, std::size_t number, Part part, const PageStyle& style,
                      const std::string& figures, std::size_t figure) {
  const Task& task = sheet.tasks[number];
  const Trace& trace = *task.variant->exercise.trace;
  const Wording& wording = trace.wording;
  const std::string points = points_text(task.points(), wording);
  const std::string worth = part == Part::key ? points : scored_text(task.points(), wording);
  const std::string name = latex_escaped(name_text(sheet.student, wording));
  std::string out = fmt::format("\\section*{{{} \\hfill \\normalsize\\normalfont {}}}\n",
                                latex_escaped(task_title(sheet, number)), latex_escaped(worth));
  if (part == Part::key) {
    out += fmt::format("{} \\hfill \\textbf{{{}}}\\par\\medskip\n", name,
                       latex_escaped(wording.say("worksheet.key")));
  } else {
    out += fmt::format("{}{}\\par\\medskip\n", name, sheet.student.empty() ? " \\rule{80mm}{0.4pt}" : "");
  }
  out += latex_paragraph(trace.goal);
  if (!trace.faulty.empty()) {
    out += fmt::format("\\textbf{{{}}}\\par\n",
                       latex_escaped(wording.say("figure.faulty", fmt::arg("what", trace.faulty))));
  }
  out += fmt::format("\\medskip\\textbf{{{}}}\\par\n",
                     latex_escaped(wording.say("worksheet.input", fmt::arg("input", trace.subtitle),
                                               fmt::arg("method", trace.method_title))));
  out += fmt::format("{{\\small\\ttfamily\\raggedright {}\\par}}\n\\medskip\n",
                     latex_escaped(fmt::format("{}", fmt::join(given_arguments(task), " · "))));
  out += latex_paragraph(filling_text(task, style.reckoning));
  out += "\\begin{center}\n" + task_table(task, part) + "\\end{center}\n";
  if (figures.empty()) return out;
  const std::string drawing =
      part == Part::key
          ? wording.say("worksheet.drawing_key", fmt::arg("points", points_text(task.worth.drawing, wording)))
          : drawing_text(task);
  return out + latex_paragraph(drawing) +
         fmt::format(
             "\\begin{{center}}\n\\includegraphics[page={},width=\\linewidth]{{{}}}\n\\end{{center}}\n",
             figure + 1, latex_path(figures));
}

}  // namespace

std::string latex_document(const std::vector<StudentSheet>& sheets, Part part, const PageStyle& style,
                           const std::string& figures) {
  std::string body;
  std::size_t figure = 0;
  for (const StudentSheet& sheet : sheets) {
    for (std::size_t i = 0; i < sheet.tasks.size(); ++i) {
      if (figure > 0) body += "\\clearpage\n";
      body += task_page(sheet, i, part, style, figures, figure++);
    }
  }
  const bool german = wording_of(sheets.front().tasks.front()).language().code() == "de";
  return fmt::format(
             "\\documentclass[11pt,{}paper]{{article}}\n"
             "\\usepackage[T1]{{fontenc}}\n\\usepackage[utf8]{{inputenc}}\n\\usepackage{{textcomp}}\n"
             "\\usepackage[{}]{{babel}}\n\\usepackage[margin=18mm]{{geometry}}\n"
             "\\usepackage{{booktabs}}\n\\usepackage{{colortbl}}\n\\usepackage{{graphicx}}\n",
             style.paper.name, german ? "ngerman" : "english") +
         declarations(body) +
         "\\newlength{\\blankwidth}\n"
         "\\newcommand{\\blank}{\\rule[-0.5mm]{\\blankwidth}{0.4pt}}\n"
         "\\newcommand{\\unused}{\\textcolor[gray]{0.5}{/}}\n"
         "\\newcommand{\\answer}[1]{\\textbf{#1}}\n"
         "\\newcommand{\\tall}{\\rule[-2mm]{0pt}{8mm}}\n"
         "\\setlength{\\parindent}{0pt}\n"
         "\\begin{document}\n" +
         body + "\\end{document}\n";
}

}  // namespace gradus::worksheet
