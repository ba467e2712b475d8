// Tables and snippets for documents: what is pasted must mean what the figure says.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "figure/text/markup.hpp"
#include "figure/which_steps.hpp"
#include "stories/topic.hpp"
#include "text/escape.hpp"
#include "text/snippet.hpp"
#include "text/text_output.hpp"
#include "text/wrap.hpp"

namespace gradus {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string hostile_text = "a_b & 50% of #1 {x} $y ~z ^2 <b> \"q\" 'r' \\end | [l](u) `c` * 1.";

TEST(Escape, LatexLeavesNoSpecialCharacterBare) {
  const std::string text = latex_escaped("a_b & 50% #1 {x} $y ~z ^2 \\end");
  EXPECT_EQ(
      text,
      "a\\_b \\& 50\\% \\#1 \\{x\\} \\$y \\textasciitilde{}z \\textasciicircum{}2 \\textbackslash{}end");
}

TEST(Escape, LatexKnowsTheSignsOfFigures) {
  EXPECT_EQ(latex_escaped("p = 2·3 − 7 ≤ −1"), "p = 2$\\cdot$3 $-$ 7 $\\le$ $-$1");
  EXPECT_EQ(latex_escaped("(4,\u00a0−2)"), "(4,~$-$2)");
  EXPECT_EQ(latex_escaped("Größe"), "Größe") << "letters stay: engines read UTF-8";
}

TEST(Escape, LatexCellsHaveFormulasInMathMode) {
  EXPECT_EQ(latex_cell("−7"), "$-7$");
  EXPECT_EQ(latex_cell("p > 0"), "$p > 0$");
  EXPECT_EQ(latex_cell("(2,333; 0)"), "$(2{,}333; 0)$") << "a decimal comma is no pause";
  EXPECT_EQ(latex_cell("(2, 3)"), "$(2, 3)$");
  EXPECT_EQ(latex_cell("code a"), "code $a$");
  EXPECT_EQ(latex_cell("b to left, 3 kept"), "$b$ to left, $3$ kept");
  EXPECT_EQ(latex_cell("E"), "E") << "a direction, a point";
  EXPECT_EQ(latex_cell("a_b & 50%"), "$a$\\_$b$ \\& $50$\\%") << "what has a meaning is escaped still";
  EXPECT_EQ(latex_cell("ε, Größe"), "ε, Größe");
  EXPECT_EQ(latex_cell(""), "");
}

TEST(Escape, HtmlMarkupBecomesText) {
  EXPECT_EQ(escaped("<b a=\"1\">&'"), "&lt;b a=&quot;1&quot;&gt;&amp;&#39;");
  EXPECT_EQ(escaped(std::string("a\x01z")), "a\xef\xbf\xbdz");
  EXPECT_EQ(escaped("a\u202e\u061c\u0085\x7f\rz\n"), "a&#x202e;&#x61c;&#x85;&#x7f;&#xd;z\n")
      << "a file holds no mark that turns the direction of text";
}

TEST(Escape, MarkdownPutsABackslashBeforeEverythingWithAMeaning) {
  const std::string text = markdown_escaped(hostile_text);
  const std::string special = "\\`*_{}[]()#+-.!|<>~&";
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\') {
      ASSERT_NE(special.find(text.at(i + 1)), std::string::npos);
      ++i;
    } else {
      EXPECT_EQ(special.find(text[i]), std::string::npos) << text[i] << " at " << i;
    }
  }
}

Trace line(std::string from, std::string to) {
  return trace_of(*find_entry("bresenham_line"), {{"from", std::move(from)}, {"to", std::move(to)}});
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string one; std::getline(in, one);) lines.push_back(one);
  return lines;
}

TEST(Values, AreWrittenForPeople) {
  EXPECT_EQ(value_text(std::int64_t{-7}), "-7");
  EXPECT_EQ(value_text(0.1), "0.1");
  EXPECT_EQ(value_text(1.0), "1");
  EXPECT_EQ(value_text(0.0), "0");
  EXPECT_EQ(value_text(-0.0), "0") << "the sign of nothing says nothing";
  EXPECT_EQ(value_text(true), "yes");
  EXPECT_EQ(value_text(false), "no");
  EXPECT_EQ(value_text(std::string("left")), "left");
  EXPECT_EQ(value_text(ivec2{3, -4}), "(3, -4)");
}

TEST(Tables, MarkdownHasARowAStepAndAsManyCellsAsColumns) {
  const Trace trace = line("0,0", "7,3");
  const auto lines = lines_of(markdown_of(trace));
  ASSERT_EQ(lines.size(), 2u + 8u);
  for (const std::string& one : lines) {
    std::size_t bars = 0;
    for (std::size_t i = 0; i < one.size(); ++i) bars += one[i] == '|' && (i == 0 || one[i - 1] != '\\');
    EXPECT_EQ(bars, trace.columns.size() + 1) << one;
  }
  EXPECT_EQ(lines[1], "| --: | --: | --: | --: | :-- | :-- |") << "digits to the right, words to the left";
  EXPECT_EQ(lines[3], "| 1 | 1 | 0 | 5 | p \\> 0 | NE |");
}

TEST(Tables, LatexTabularIsBalanced) {
  const Trace trace = line("0,0", "-7,-3");
  const std::string text = latex_of(trace);
  EXPECT_THAT(text, StartsWith("% \\usepackage{booktabs}\n\\begin{tabular}{rrrrll}\n\\toprule\n"));
  EXPECT_THAT(text, EndsWith("\\end{tabular}\n"));
  for (const std::string& one : lines_of(text)) {
    if (!one.ends_with("\\\\")) continue;
    EXPECT_EQ(std::ranges::count(one, '&'), 5) << one;
    EXPECT_EQ(std::ranges::count(one, '$') % 2, 0) << one;
  }
  EXPECT_THAT(text, HasSubstr("$-7$ & $-3$"));
  EXPECT_THAT(text, Not(HasSubstr("−"))) << "pdfLaTeX's text fonts have no such letter";
}

SnippetFigure deck(std::string ending, bool titled, std::size_t steps) {
  SnippetFigure figure{ending, "A & B", titled, {}};
  for (std::size_t i = 0; i < steps; ++i) {
    const int page = ending == "pdf" ? static_cast<int>(i) + 1 : 0;
    figure.steps.push_back({"my line." + ending, page, "p < 0 \"east\""});
  }
  return figure;
}

TEST(Snippets, BeamerShowsPageKOnOverlayK) {
  const std::string text = snippet_of(SnippetKind::beamer, deck("pdf", true, 3));
  EXPECT_THAT(text, StartsWith("\\begin{frame}[plain]\n"));
  for (const int k : {1, 2, 3}) {
    EXPECT_THAT(text,
                HasSubstr("\\includegraphics<" + std::to_string(k) + ">[page=" + std::to_string(k) + ","));
  }
  EXPECT_THAT(snippet_of(SnippetKind::beamer, deck("pdf", true, 1)), HasSubstr("\\includegraphics[page=1,"));
  EXPECT_THAT(snippet_of(SnippetKind::beamer, deck("png", false, 1)), HasSubstr("\\begin{frame}{A \\& B}"))
      << "a figure without a title gets the slide's";
}

TEST(Snippets, BeamerNamesFilesWithAnyCharacter) {
  SnippetFigure figure = deck("pdf", true, 1);
  figure.steps[0].path = "50% of #1 {a}_b.pdf";
  EXPECT_THAT(
      snippet_of(SnippetKind::beamer, figure),
      HasSubstr("]{50\\csname c_percent_str\\endcsname \\space of \\csname c_hash_str\\endcsname 1 "
                "\\csname c_left_brace_str\\endcsname a\\csname c_right_brace_str\\endcsname _b.pdf}%\n"));
  // Plain names stay as they are
  EXPECT_THAT(snippet_of(SnippetKind::beamer, deck("pdf", true, 1)), HasSubstr("]{my line.pdf}%\n"));
}

TEST(Snippets, RevealShowsOneAfterTheOtherAndEscapes) {
  const std::string text = snippet_of(SnippetKind::reveal, deck("svg", true, 3));
  EXPECT_THAT(text,
              HasSubstr("<img class=\"fragment fade-out\" data-fragment-index=\"0\" src=\"my line.svg\" "
                        "alt=\"p &lt; 0 &quot;east&quot;\">"));
  EXPECT_THAT(text, HasSubstr("<img class=\"fragment current-visible\" data-fragment-index=\"0\""));
  EXPECT_THAT(text, HasSubstr("<img class=\"fragment\" data-fragment-index=\"1\"")) << "the last one stays";
  EXPECT_THAT(snippet_of(SnippetKind::reveal, deck("svg", true, 1)), Not(HasSubstr("fragment")));
  EXPECT_THAT(snippet_of(SnippetKind::reveal, deck("html", true, 1)),
              HasSubstr("data-src=\"my line.html#embed\""));
}

TEST(Snippets, MarkdownLinksToThePage) {
  EXPECT_EQ(snippet_of(SnippetKind::markdown, deck("svg", true, 1)), "![p \\< 0 \"east\"](<my line.svg>)\n");
  EXPECT_THAT(snippet_of(SnippetKind::markdown, deck("pdf", true, 2)), HasSubstr("](<my line.pdf#page=2>)"));
}

TEST(Snippets, PathsStayPaths) {
  SnippetFigure figure = deck("html", true, 1);
  figure.steps[0].path = "javascript:alert(1)#\x1b[1m\u202e\xff.html";
  const std::string address = "javascript%3Aalert(1)%23%1B[1m%E2%80%AE%FF.html";
  EXPECT_THAT(snippet_of(SnippetKind::reveal, figure), HasSubstr("data-src=\"" + address + "#embed\""));
  EXPECT_THAT(snippet_of(SnippetKind::markdown, figure), HasSubstr("](<" + address + ">)"));
  figure.ending = "pdf";
  EXPECT_EQ(snippet_of(SnippetKind::beamer, figure).find('\x1b'), std::string::npos);
}

TEST(Wrapped, GoesOnBelowTheLastColumn) {
  EXPECT_EQ(wrapped("  name   a title: and what it is about\n  other  short\n", 34),
            "  name   a title: and what it is\n         about\n  other  short\n");
  EXPECT_EQ(wrapped("one two three", 7), "one two\n    three") << "no column: four blanks";
  EXPECT_EQ(wrapped("first column of a table  second", 20), "first column of a\n    table  second")
      << "too little room behind the last column";
}

TEST(Wrapped, LosesNothingAndBreaksNoWordNoCommandAndNoColour) {
  const std::string longer = "Antidisestablishmentarianism\u00a0is one word";
  EXPECT_EQ(wrapped(longer, 20), "Antidisestablishmentarianism\u00a0is\n    one word");
  EXPECT_EQ(wrapped("  gradus run topic --line 1,2,3,4", 20), "  gradus run topic --line 1,2,3,4");
  EXPECT_EQ(wrapped(longer, 0), longer);
  EXPECT_EQ(wrapped("\033[1mbold\033[0m \033[2mdim\033[0m", 8), "\033[1mbold\033[0m \033[2mdim\033[0m");
  EXPECT_EQ(wrapped("−−−− −−−", 8), "−−−− −−−") << "columns, not bytes";
  EXPECT_EQ(wrapped("a\n\nb", 20), "a\n\nb");
  EXPECT_EQ(wrapped("", 20), "");
}

TEST(Milestones, AreTheFirstTheTellingOneEachKindOfBranchAndTheLast) {
  const Trace trace = line("0,0", "7,3");
  const std::vector<StepNumber> numbers = milestones_of(trace);
  EXPECT_EQ(numbers, (std::vector<StepNumber>{{0, 0}, {3, 0}, {4, 0}, {7, 0}})) << "start, E, NE, end";
  EXPECT_EQ(trace.telling, (StepNumber{4, 0}));
  std::set<int> all, shown;
  for (const TraceStep& step : trace.steps) {
    if (step.number.fine == 0) all.insert(step.line);
  }
  for (const StepNumber number : numbers) shown.insert(trace.steps[index_of(trace, number)].line);
  EXPECT_EQ(shown, all);
  EXPECT_EQ(milestones_of(line("3,3", "3,3")).size(), 1u);
}

}  // namespace
}  // namespace gradus
