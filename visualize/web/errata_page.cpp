#include "web/errata_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "figure/markup.hpp"
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

/// shown: a picture, or what is said in its place.
std::string side_html(std::string_view verdict, const std::string& name, const std::string& shown,
                      const std::string& command, const std::string& title) {
  return fmt::format(
      "<figure>{}<figcaption>{} <code>{}</code></figcaption>\n<pre tabindex=\"0\" role=\"region\" "
      "aria-label=\"{}\"><code>{}</code></pre></figure>\n",
      shown, verdict, escaped(name), escaped(fmt::format("command of {}: {}", name, title)),
      escaped(command));
}

std::string refusal_html(const std::string& refusal) {
  return fmt::format("<p class=\"refusal\">refused: {}</p>", escaped(refusal));
}

std::string exhibit_html(const Exhibit& exhibit) {
  // Names a reader of screens can tell apart: one input may have several wrong forms, one form several errata
  const std::string about =
      fmt::format("{}: {}, {} for {}", exhibit.id, exhibit.title, exhibit.wrong_name, exhibit.right_name);
  std::string facts;
  for (const std::string& fact : {exhibit.parting, exhibit.outcome, exhibit.difference}) {
    if (!fact.empty()) facts += fmt::format("<li>{}</li>\n", escaped(fact));
  }
  const auto picture = [&](std::string_view verdict, const std::string& name, const std::string& svg) {
    return picture_html(svg, fmt::format("{}: {} {}", about, verdict, name));
  };
  const std::string wrong = picture("wrong:", exhibit.wrong_name, exhibit.wrong_picture);
  const std::string right = exhibit.refusal.empty()
                                ? picture("right:", exhibit.right_name, exhibit.right_picture)
                                : refusal_html(exhibit.refusal);
  return fmt::format("<p><b>{}</b></p>\n<div class=\"pair\">\n{}{}</div>\n<ul>\n{}</ul>\n",
                     escaped(exhibit.title),
                     side_html("wrong:", exhibit.wrong_name, wrong, exhibit.wrong_command, about),
                     side_html("right:", exhibit.right_name, right, exhibit.right_command, about), facts);
}

std::string erratum_html(const Erratum& erratum, std::size_t number, std::span<const Exhibit> exhibits) {
  const std::string kind = erratum.kind == "W" ? "wrong" : "fragile: right in easy cases only";
  std::string html =
      fmt::format("<article id=\"{}\">\n<h3>{}: {}</h3>\n", escaped(anchor_of(erratum, number)),
                  escaped(erratum.id == "part 4" ? "A numerical trap" : erratum.id), kind);
  const auto line = [&](std::string_view what, const std::string& markdown) {
    html += fmt::format("<p><b>{}</b> {}</p>\n", what, html_of_line(markdown));
  };
  line("The notes:", erratum.says);
  line("Why it is wrong:", erratum.why);
  line("Right:", erratum.right);
  for (const Exhibit& exhibit : exhibits) {
    if (shows(exhibit, erratum)) html += exhibit_html(exhibit);
  }
  line("What would notice it:", erratum.test);
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
  return exhibit.id == erratum.id && erratum.exhibit.find(exhibit.wrong_name) != std::string::npos;
}

std::string errata_page(std::span<const Erratum> errata, std::span<const Exhibit> exhibits) {
  std::string body, contents, section;
  for (std::size_t i = 0; i < errata.size(); ++i) {
    if (errata[i].section != section) {
      if (!section.empty()) body += "</section>\n";
      section = errata[i].section;
      const std::string id = fmt::format("part-{}", i);
      contents += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", id, escaped(section));
      body += fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n", id, escaped(section));
    }
    body += erratum_html(errata[i], i, exhibits);
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
