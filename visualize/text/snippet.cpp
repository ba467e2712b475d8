#include "text/snippet.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/shown.hpp"
#include "figure/text/markup.hpp"
#include "figure/text/metrics.hpp"
#include "text/escape.hpp"

namespace gradus {
namespace {

/// A path as an address: nothing in it is taken for a scheme, a query or a place, and no character of it
/// moves a cursor or turns the direction of text.
std::string address_of(std::string_view path) {
  std::string out;
  while (!path.empty()) {
    const std::size_t size = character_size(path);
    const std::string_view character = path.substr(0, std::max<std::size_t>(size, 1));
    path.remove_prefix(character.size());
    const bool plain = size != 0 && !is_control(code_points(character)[0]) &&
                       std::string_view(":%#?").find(character) == std::string_view::npos;
    if (plain) {
      out += character;
    } else {
      for (const char c : character) out += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return out;
}

/// One picture an overlay, all in one place. A figure with its own title fills the slide.
std::string beamer(const SnippetFigure& figure) {
  const std::string_view size = figure.titled ? "width=\\paperwidth,height=\\paperheight,keepaspectratio"
                                              : "width=\\linewidth,height=0.8\\textheight,keepaspectratio";
  std::string out = figure.titled ? "\\begin{frame}[plain]\n  \\makebox[\\linewidth][c]{%\n"
                                  : fmt::format("\\begin{{frame}}{{{}}}\n  \\makebox[\\linewidth][c]{{%\n",
                                                latex_escaped(figure.title));
  for (std::size_t i = 0; i < figure.steps.size(); ++i) {
    const SnippetStep& step = figure.steps[i];
    const std::string overlay = figure.steps.size() > 1 ? fmt::format("<{}>", i + 1) : "";
    const std::string page = step.page > 0 ? fmt::format("page={},", step.page) : "";
    out += fmt::format("    \\includegraphics{}[{}{}]{{{}}}%\n", overlay, page, size,
                       latex_path(visible(step.path)));
  }
  return out + "  }\n\\end{frame}\n";
}

/// The first picture is there when the slide opens; each next one takes the place of the one before.
std::string fragment_of(std::size_t i, std::size_t count) {
  if (count == 1) return "";
  if (i == 0) return " class=\"fragment fade-out\" data-fragment-index=\"0\"";
  return fmt::format(" class=\"fragment{}\" data-fragment-index=\"{}\"",
                     i + 1 < count ? " current-visible" : "", i - 1);
}

std::string reveal_element(const SnippetFigure& figure, const SnippetStep& step,
                           const std::string& fragment) {
  const std::string path = escaped(address_of(step.path)), alt = escaped(step.alt);
  if (figure.ending == "html") {
    return fmt::format("<iframe{} data-src=\"{}#embed\" title=\"{}\" width=\"1280\" height=\"720\"></iframe>",
                       fragment, path, alt);
  }
  if (figure.ending == "mp4") {
    return fmt::format("<video{} data-src=\"{}\" aria-label=\"{}\" controls data-autoplay></video>", fragment,
                       path, alt);
  }
  return fmt::format("<img{} src=\"{}\" alt=\"{}\">", fragment, path, alt);
}

std::string reveal(const SnippetFigure& figure) {
  std::string out = "<section>\n";
  if (!figure.titled) out += fmt::format("  <h2>{}</h2>\n", escaped(figure.title));
  out += "  <div class=\"r-stack\">\n";
  for (std::size_t i = 0; i < figure.steps.size(); ++i) {
    out +=
        fmt::format("    {}\n", reveal_element(figure, figure.steps[i], fragment_of(i, figure.steps.size())));
  }
  return out + "  </div>\n</section>\n";
}

/// A path between < and >, where only these and line ends have a meaning.
std::string markdown_path(std::string_view path) {
  std::string out = "<";
  for (const char c : path)
    out += c == '<' || c == '>' || c == '\\' ? fmt::format("\\{}", c) : std::string(1, c);
  return out + ">";
}

std::string markdown(const SnippetFigure& figure) {
  std::string out;
  if (!figure.titled) out += fmt::format("## {}\n\n", markdown_escaped(figure.title));
  const bool picture = figure.ending != "pdf" && figure.ending != "html" && figure.ending != "mp4";
  for (const SnippetStep& step : figure.steps) {
    const std::string page = step.page > 0 ? fmt::format("#page={}", step.page) : "";
    out += fmt::format("{}[{}]({})\n\n", picture ? "!" : "", markdown_escaped(step.alt),
                       markdown_path(address_of(step.path) + page));
  }
  out.pop_back();
  return out;
}

}  // namespace

std::vector<std::string_view> snippet_formats(SnippetKind kind) {
  switch (kind) {
    case SnippetKind::beamer:
      return {"pdf", "png"};
    case SnippetKind::reveal:
      return {"svg", "png", "html", "gif", "webp", "mp4"};
    case SnippetKind::markdown:
      break;
  }
  return {"svg", "png", "pdf", "html", "gif", "webp", "mp4"};
}

std::string snippet_of(SnippetKind kind, const SnippetFigure& figure) {
  switch (kind) {
    case SnippetKind::beamer:
      return beamer(figure);
    case SnippetKind::reveal:
      return reveal(figure);
    case SnippetKind::markdown:
      break;
  }
  return markdown(figure);
}

}  // namespace gradus
