#include "web/errata_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "figure/text/markup.hpp"
#include "web/article.hpp"
#include "web/html.hpp"
#include "web/topic_page.hpp"

namespace gradus {

namespace {

/// The cells of a row of a Markdown table: "| a | b |". A bar after a backslash is text.
std::vector<std::string> cells_of(std::string_view row) {
  std::vector<std::string> cells{""};
  for (std::size_t i = 1; i < row.size(); ++i) {
    if (row[i] == '|' && row[i - 1] != '\\') {
      cells.emplace_back();
    } else {
      cells.back() += row[i];
    }
  }
  cells.pop_back();  // behind the last bar
  for (std::string& cell : cells) {
    cell.erase(0, cell.find_first_not_of(' '));
    cell.erase(cell.find_last_not_of(' ') + 1);
  }
  return cells;
}

std::string anchor_of(const Erratum& erratum, std::size_t number) {
  return fmt::format("{}-{}", erratum.id == "part 4" ? "trap" : erratum.id, number);
}

std::string picture_html(std::string_view svg, std::string_view alt) {
  return fmt::format("<img src=\"data:image/svg+xml;base64,{}\" alt=\"{}\">", base64(svg), escaped(alt));
}

std::string side_html(std::string_view verdict, const ExhibitSide& side, const std::string& shown,
                      const std::string& about) {
  return fmt::format(
      "<figure class=\"{0}\"><figcaption><b>{0}</b> {1}</figcaption>{2}\n<p>{3}</p>\n<pre tabindex=\"0\" "
      "role=\"region\" aria-label=\"{4}\"><code>{5}</code></pre></figure>\n",
      verdict, escaped(side.title), shown, escaped(side.sentence),
      escaped(fmt::format("command of {}: {}", side.name, about)), escaped(side.command));
}

std::string refusal_html(const std::string& refusal) {
  return fmt::format("<p class=\"refusal\">refused: {}</p>", escaped(refusal));
}

/// With its sign where the exhibit strikes lines out and puts others in.
std::string line_html(const ExhibitLine& line, bool with_signs) {
  const bool struck = line.change == Change::struck, added = line.change == Change::added;
  const std::string sign = !with_signs ? "" : struck ? "− " : added ? "+ " : "  ";
  const std::string_view tag = line.culprit ? "mark" : struck ? "del" : added ? "ins" : "";
  if (tag.empty()) return sign + escaped(line.text) + "\n";
  return fmt::format("{0}<{1}>{2}</{1}>\n", sign, tag, escaped(line.text));
}

/// The wrong form's lines round the one to blame.
std::string source_html(const Exhibit& exhibit, const std::string& about) {
  if (exhibit.source.empty()) return "";
  std::string lines;
  const auto is_changed = [](const ExhibitLine& line) { return line.change != Change::none; };
  const bool with_signs = std::ranges::any_of(exhibit.source, is_changed);
  for (const ExhibitLine& line : exhibit.source) lines += line_html(line, with_signs);
  return fmt::format(
      "<pre class=\"culprit\" tabindex=\"0\" role=\"region\" aria-label=\"{}\"><code>{}</code></pre>\n",
      escaped("lines of " + about), lines);
}

std::string exhibit_html(const Exhibit& exhibit) {
  const auto& [id, title, wrong, right, source, refusal, parting, outcome, difference] = exhibit;
  // Names a reader of screens can tell apart: one input may have several wrong forms, one form several errata
  const std::string about = fmt::format("{}: {}, {} for {}", id, title, wrong.name, right.name);
  std::string facts;
  for (const std::string& fact : {parting, outcome, difference}) {
    if (!fact.empty()) facts += fmt::format("<li>{}</li>\n", escaped(fact));
  }
  const auto picture = [&](std::string_view verdict, const ExhibitSide& side) {
    return picture_html(side.picture, fmt::format("{}: {}, {}", about, verdict, side.title));
  };
  return fmt::format(
      "<p class=\"input\">{}</p>\n<div class=\"pair\">\n{}{}</div>\n{}<ul>\n{}</ul>\n", escaped(title),
      side_html("wrong", wrong, picture("wrong", wrong), about),
      side_html("right", right, refusal.empty() ? picture("right", right) : refusal_html(refusal), about),
      source_html(exhibit, about), facts);
}

/// Of two outcomes only the first can be wrong; the same twice is right.
std::string outcome_html(const ReadingRow& row, std::string_view wrong_head, std::string_view right_head) {
  const auto cell = [](std::string_view kind, std::string_view head, const std::string& text) {
    return fmt::format("<td class=\"{}\" data-head=\"{}\">{}</td>", kind, escaped(head), escaped(text));
  };
  return cell(row.wrong == row.right ? "right" : "wrong", wrong_head, row.wrong) +
         cell("right", right_head, row.right);
}

std::string reading_html(const Reading& reading) {
  const std::string about = fmt::format("{}: {}", reading.id, reading.title);
  std::string html = fmt::format("<p class=\"input\">{}</p>\n", escaped(reading.title));
  if (!reading.frame.empty()) {
    html += fmt::format(
        "<pre class=\"frame\" tabindex=\"0\" role=\"region\" aria-label=\"{}\"><code>{}</code></pre>\n",
        escaped("what stands before each input, " + about), escaped(reading.frame));
  }
  html += fmt::format(
      "<table class=\"reading\"><caption class=\"unseen\">{}</caption>\n<thead><tr><th "
      "scope=\"col\">input</th><th scope=\"col\">{}</th><th "
      "scope=\"col\">{}</th></tr></thead>\n<tbody>\n",
      escaped(about), escaped(reading.wrong_head), escaped(reading.right_head));
  for (const ReadingRow& row : reading.rows) {
    html += fmt::format("<tr><th scope=\"row\"><code>{}</code></th>{}</tr>\n", escaped(row.input),
                        outcome_html(row, reading.wrong_head, reading.right_head));
  }
  return html + "</tbody>\n</table>\n";
}

std::string erratum_html(const Erratum& erratum, std::size_t number, std::span<const Exhibit> exhibits,
                         std::span<const Reading> readings) {
  const std::string kind = erratum.kind == "W" ? "wrong" : "right in easy cases only";
  const std::string name = erratum.id == "part 4" ? "Numbers that are too small" : erratum.id;
  std::string html =
      fmt::format("<article class=\"erratum\" id=\"{}\">\n<h3>{} <span class=\"kind\">{}</span></h3>\n",
                  escaped(anchor_of(erratum, number)), escaped(name), kind);
  html += fmt::format("<p class=\"claim\">{}</p>\n", html_of_line(erratum.says));
  for (const Exhibit& exhibit : exhibits) {
    if (shows(exhibit, erratum)) html += exhibit_html(exhibit);
  }
  for (const Reading& reading : readings) {
    if (shows(reading, erratum)) html += reading_html(reading);
  }
  const auto line = [&](std::string_view what, const std::string& markdown) {
    html += fmt::format("<p><b>{}</b> {}</p>\n", what, html_of_line(markdown));
  };
  line("Why it is wrong:", erratum.why);
  line("Right:", erratum.right);
  return html + "</article>\n";
}

}  // namespace

std::vector<Erratum> wrong_and_fragile() {
  std::vector<Erratum> found;
  std::string section;
  std::string_view text = docs_text("docs/errata.md");
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.starts_with("## ")) section = line.substr(3);
    if (!line.starts_with("| ")) continue;
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() < 6 || (cells[1] != "W" && cells[1] != "F")) continue;
    const std::string exhibit = cells.size() > 6 ? cells[5] : "";
    found.push_back({cells[0], cells[1], cells[2], cells[3], cells[4], exhibit, cells.back(), section});
  }
  return found;
}

bool shows(const Exhibit& exhibit, const Erratum& erratum) {
  return exhibit.id == erratum.id && erratum.exhibit.find(exhibit.wrong.name) != std::string::npos;
}

bool shows(const Reading& reading, const Erratum& erratum) {
  return reading.id == erratum.id && erratum.exhibit.find(reading.reader) != std::string::npos;
}

std::string errata_page(std::span<const Erratum> errata, std::span<const Exhibit> exhibits,
                        std::span<const Reading> readings) {
  std::string body, contents, section;
  for (std::size_t i = 0; i < errata.size(); ++i) {
    if (errata[i].section != section) {
      if (!section.empty()) body += "</section>\n";
      section = errata[i].section;
      const std::string id = fmt::format("part-{}", i);
      contents += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", id, escaped(section));
      body += fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n", id, escaped(section));
    }
    body += erratum_html(errata[i], i, exhibits, readings);
  }
  if (!section.empty()) body += "</section>\n";
  const std::string_view about =
      "What the lecture notes behind this catalogue print wrong, or right in easy cases only, run beside "
      "what is "
      "right.";
  return page_of({.title = "Errata: wrong beside right",
                  .summary = "What lecture notes print wrong, run beside what is right.",
                  .trail = "<a href=\"index.html\">all figures</a>",
                  .contents = contents,
                  .body = fmt::format("<h1>Errata</h1>\n<section class=\"idea\">\n<p>{}</p>\n</section>\n{}",
                                      about, body),
                  .styles = {"topic.css", "errata.css"},
                  .scripts = {}});
}

}  // namespace gradus
