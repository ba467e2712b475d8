#include "web/topic_page.hpp"

#include <cmark-gfm-core-extensions.h>
#include <cmark-gfm.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "cairo/library_on_demand.hpp"
#include "figure/text/markup.hpp"
#include "web/article.hpp"
#include "web/formulas.hpp"
#include "web/html.hpp"
#include "web/prose.hpp"

namespace gradus {
namespace {

/// A member: the function of this name, without the "cmark_" before it.
#define GRADUS_CMARK_FUNCTION(name) GRADUS_ON_DEMAND_AS(name, cmark_##name)

/// cmark-gfm's functions, loaded by the first page of a topic.
struct CmarkLibrary {
  LibraryOnDemand library{GRADUS_CMARK, "pages of topics"};

  GRADUS_CMARK_FUNCTION(consolidate_text_nodes);
  GRADUS_CMARK_FUNCTION(find_syntax_extension);
  GRADUS_CMARK_FUNCTION(gfm_core_extensions_ensure_registered);
  GRADUS_CMARK_FUNCTION(iter_free);
  GRADUS_CMARK_FUNCTION(iter_get_node);
  GRADUS_CMARK_FUNCTION(iter_new);
  GRADUS_CMARK_FUNCTION(iter_next);
  GRADUS_CMARK_FUNCTION(node_first_child);
  GRADUS_CMARK_FUNCTION(node_free);
  GRADUS_CMARK_FUNCTION(node_get_fence_info);
  GRADUS_CMARK_FUNCTION(node_get_heading_level);
  GRADUS_CMARK_FUNCTION(node_get_literal);
  GRADUS_CMARK_FUNCTION(node_get_type);
  GRADUS_CMARK_FUNCTION(node_get_type_string);
  GRADUS_CMARK_FUNCTION(node_get_url);
  GRADUS_CMARK_FUNCTION(node_insert_after);
  GRADUS_CMARK_FUNCTION(node_insert_before);
  GRADUS_CMARK_FUNCTION(node_new);
  GRADUS_CMARK_FUNCTION(node_next);
  GRADUS_CMARK_FUNCTION(node_previous);
  GRADUS_CMARK_FUNCTION(node_replace);
  GRADUS_CMARK_FUNCTION(node_set_literal);
  GRADUS_CMARK_FUNCTION(node_set_url);
  GRADUS_CMARK_FUNCTION(parser_attach_syntax_extension);
  GRADUS_CMARK_FUNCTION(parser_feed);
  GRADUS_CMARK_FUNCTION(parser_finish);
  GRADUS_CMARK_FUNCTION(parser_free);
  GRADUS_CMARK_FUNCTION(parser_new);
  GRADUS_CMARK_FUNCTION(render_html);
};

#undef GRADUS_CMARK_FUNCTION

const CmarkLibrary& cmark() {
  static const CmarkLibrary functions;
  return functions;
}

struct Release {
  void operator()(cmark_node* node) const { cmark().node_free(node); }
  void operator()(cmark_parser* parser) const { cmark().parser_free(parser); }
  void operator()(cmark_iter* iterator) const { cmark().iter_free(iterator); }
  void operator()(char* text) const { std::free(text); }  // the default allocator's
};
template <class T>
using Owned = std::unique_ptr<T, Release>;

constexpr std::string_view topics_folder = "docs/topics/";

std::string key_of(const TopicEntry& topic) { return fmt::format("{}/{}", topic.chapter, topic.name); }
std::string file_of(const TopicEntry& topic) { return fmt::format("{}{}.md", topics_folder, key_of(topic)); }

Owned<cmark_node> parsed(std::string_view markdown) {
  cmark().gfm_core_extensions_ensure_registered();
  // The pages are the project's own: their HTML (folded answers) is kept
  const Owned<cmark_parser> parser(cmark().parser_new(CMARK_OPT_UNSAFE));
  cmark().parser_attach_syntax_extension(parser.get(), cmark().find_syntax_extension("table"));
  cmark().parser_feed(parser.get(), markdown.data(), markdown.size());
  return Owned<cmark_node>(cmark().parser_finish(parser.get()));
}

std::string html_of(cmark_node* document) {
  const Owned<char> text(cmark().render_html(document, CMARK_OPT_UNSAFE, nullptr));
  return text.get();
}

/// Kinds go by their names ("link", "image", "table"): those of extensions have no constant.
std::vector<cmark_node*> nodes_of(cmark_node* document, std::string_view kind) {
  std::vector<cmark_node*> found;
  const Owned<cmark_iter> iterator(cmark().iter_new(document));
  for (cmark_event_type event; (event = cmark().iter_next(iterator.get())) != CMARK_EVENT_DONE;) {
    cmark_node* node = cmark().iter_get_node(iterator.get());
    if (event == CMARK_EVENT_ENTER && cmark().node_get_type_string(node) == kind) found.push_back(node);
  }
  return found;
}

std::string text_in(cmark_node* node) {
  std::string text;
  for (const std::string_view kind : {"text", "code"}) {
    for (cmark_node* part : nodes_of(node, kind)) text += cmark().node_get_literal(part);
  }
  return text;
}

cmark_node* html_node(cmark_node_type type, const std::string& html) {
  cmark_node* node = cmark().node_new(type);
  cmark().node_set_literal(node, html.c_str());
  return node;
}

/// Takes a $ off the end or the start of the text beside a formula.
bool takes_dollar(cmark_node* text, bool at_end) {
  if (!text || cmark().node_get_type(text) != CMARK_NODE_TEXT) return false;
  std::string words = cmark().node_get_literal(text);
  if (at_end ? !words.ends_with('$') : !words.starts_with('$')) return false;
  words.erase(at_end ? words.size() - 1 : 0, 1);
  cmark().node_set_literal(text, words.c_str());
  return true;
}

void replace(cmark_node* node, cmark_node* by) {
  cmark().node_replace(node, by);
  cmark().node_free(node);
}

/// Formulas are written $`p < 0`$, or in a block ```math.
void put_formulas(cmark_node* document) {
  for (cmark_node* code : nodes_of(document, "code")) {
    cmark_node *before = cmark().node_previous(code), *after = cmark().node_next(code);
    if (!takes_dollar(before, true)) continue;
    if (!takes_dollar(after, false)) throw std::logic_error("a formula ends without $");
    replace(code, html_node(CMARK_NODE_HTML_INLINE, formula_in_line(cmark().node_get_literal(code))));
  }
  for (cmark_node* block : nodes_of(document, "code_block")) {
    if (std::string_view(cmark().node_get_fence_info(block)) != "math") continue;
    std::string html;
    std::string_view lines = cmark().node_get_literal(block);
    while (!lines.empty()) {
      html += formula_on_line(lines.substr(0, lines.find('\n')));
      lines.remove_prefix(std::min(lines.find('\n'), lines.size() - 1) + 1);
    }
    replace(block, html_node(CMARK_NODE_HTML_BLOCK, html));
  }
}

/// Sets what sentences and cells write in plain letters; headings are links, and a picture's words stay
/// words.
void put_prose(cmark_node* document) {
  cmark().consolidate_text_nodes(document);
  std::vector<cmark_node*> plain;
  for (const std::string_view kind : {"heading", "image"}) {
    for (cmark_node* node : nodes_of(document, kind))
      std::ranges::copy(nodes_of(node, "text"), std::back_inserter(plain));
  }
  for (cmark_node* text : nodes_of(document, "text")) {
    if (std::ranges::find(plain, text) != plain.end()) continue;
    replace(text, html_node(CMARK_NODE_HTML_INLINE, set_prose(cmark().node_get_literal(text))));
  }
}

/// The file that a link on the topic's page means, from the project's root.
std::string target_of(const TopicEntry& topic, std::string_view path) {
  std::string folder = fmt::format("{}{}", topics_folder, topic.chapter);
  while (path.starts_with("../")) {
    path.remove_prefix(3);
    const std::size_t slash = folder.rfind('/');
    folder.erase(slash == folder.npos ? 0 : slash);
  }
  return folder.empty() ? std::string(path) : fmt::format("{}/{}", folder, path);
}

std::string_view file_name(std::string_view path) { return path.substr(path.rfind('/') + 1); }

bool leads_elsewhere(std::string_view url) {
  return url.starts_with('#') || url.starts_with("https://") || url.starts_with("http://");
}

/// A heading's anchor, as repository hosts make it: "By hand" -> "by-hand".
std::string anchor_of(std::string_view heading) {
  std::string anchor;
  for (const char c : heading) {
    const bool letter = ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9');
    if (letter) anchor += static_cast<char>('A' <= c && c <= 'Z' ? c - 'A' + 'a' : c);
    if (c == ' ' || c == '-') anchor += '-';
    if (c == '_') anchor += c;
  }
  return anchor;
}

/// A topic's page in the making: its Markdown tree, changed in place.
class Page {
 public:
  explicit Page(const TopicEntry& topic) : topic_(topic), document_(parsed(docs_text(file_of(topic)))) {}

  std::string body(std::span<const Link> figures) {
    put_pictures();
    put_formulas(document_.get());
    lead_links();
    frame_tables();
    make_sections(figures);
    put_prose(document_.get());
    return html_of(document_.get()) + sources_html() + "</section>\n";
  }

  /// The headings as links.
  const std::string& contents() const { return contents_; }

 private:
  /// A picture becomes part of the page: an image inside the page reaches for nothing else.
  void put_pictures() {
    for (cmark_node* image : nodes_of(document_.get(), "image")) {
      const std::string file = target_of(topic_, cmark().node_get_url(image));
      const std::string_view svg = docs_text(file);
      if (svg.empty())
        throw std::logic_error(fmt::format("{}: there is no picture {}", key_of(topic_), file));
      cmark().node_set_url(image, ("data:image/svg+xml;base64," + base64(svg)).c_str());
    }
  }

  void lead_links() {
    for (cmark_node* link : nodes_of(document_.get(), "link")) {
      const std::string url = cmark().node_get_url(link);
      if (leads_elsewhere(url)) continue;
      const std::string path = url.substr(0, url.find('#'));
      const std::string anchor = url.substr(path.size());
      const std::string file = target_of(topic_, path);
      if (const TopicEntry* other = topic_of(file)) {
        cmark().node_set_url(link, ("../../" + topic_page_path(*other) + anchor).c_str());
      } else if (!source_text(file).empty()) {
        cmark().node_set_url(link, ("#" + source_anchor(file)).c_str());
        if (std::ranges::find(sources_, file) == sources_.end()) sources_.push_back(file);
      } else {
        name_only(link, file);
      }
    }
  }

  static const TopicEntry* topic_of(const std::string& file) {
    for (const TopicEntry* topic : catalogue()) {
      if (file == file_of(*topic)) return topic;
    }
    return nullptr;
  }

  /// The words of a link without the link, and the file's name after them.
  static void name_only(cmark_node* link, const std::string& file) {
    while (cmark_node* word = cmark().node_first_child(link)) cmark().node_insert_before(link, word);
    cmark().node_insert_before(
        link, html_node(CMARK_NODE_HTML_INLINE, fmt::format(" (<code>{}</code>)", escaped(file))));
    cmark().node_free(link);
  }

  static std::string source_anchor(const std::string& file) {
    return fmt::format("source-{}", file_name(file));
  }

  /// A wide table scrolls inside its frame, which the keyboard must reach.
  void frame_tables() {
    for (cmark_node* table : nodes_of(document_.get(), "table")) {
      const std::string name = table_name(table);
      cmark().node_insert_before(
          table,
          html_node(CMARK_NODE_HTML_BLOCK,
                    fmt::format("<div class=\"table\" role=\"region\" tabindex=\"0\" aria-label=\"{}\">\n",
                                escaped(name))));
      cmark().node_insert_after(table, html_node(CMARK_NODE_HTML_BLOCK, "</div>\n"));
    }
  }

  /// The heading above; a second table below it is "Heading, table 2".
  std::string table_name(cmark_node* table) {
    cmark_node* heading = table;
    while (heading && cmark().node_get_type(heading) != CMARK_NODE_HEADING) {
      heading = cmark().node_previous(heading);
    }
    const std::string name = heading ? text_in(heading) : topic_.title;
    const auto count = 1 + std::ranges::count(framed_, name);
    framed_.push_back(name);
    return count == 1 ? name + ", table" : fmt::format("{}, table {}", name, count);
  }

  /// A section for each heading, with the heading's anchor; the players below the title.
  void make_sections(std::span<const Link> figures) {
    for (cmark_node* heading : nodes_of(document_.get(), "heading")) {
      if (cmark().node_get_heading_level(heading) == 1) {
        const std::string html = players_html(figures) + "<section class=\"idea\">\n";
        cmark().node_insert_after(heading, html_node(CMARK_NODE_HTML_BLOCK, html));
      } else if (cmark().node_get_heading_level(heading) == 2) {
        const std::string name = text_in(heading), anchor = anchor_of(name);
        cmark().node_insert_before(
            heading, html_node(CMARK_NODE_HTML_BLOCK,
                               fmt::format("</section>\n<section id=\"{}\">\n", escaped(anchor))));
        contents_ += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", escaped(anchor), escaped(name));
      }
    }
  }

  static std::string players_html(std::span<const Link> figures) {
    if (figures.empty()) return "";
    std::string links;
    for (const Link& figure : figures) {
      links += fmt::format("<li><a href=\"../../{}\">{}</a></li>\n", link_to(figure.path).substr(2),
                           escaped(figure.name));
    }
    return fmt::format(
        "<nav class=\"players\" aria-label=\"Players\"><p>Step through it</p>\n<ul>\n{}</ul></nav>\n", links);
  }

  std::string sources_html() const {
    std::string out;
    for (const std::string& file : sources_) {
      out += fmt::format(
          "<details class=\"source\"><summary id=\"{}\"><code>{}</code></summary>\n"
          "<pre tabindex=\"0\" role=\"region\" aria-label=\"{}\"><code>{}</code></pre></details>\n",
          escaped(source_anchor(file)), escaped(file), escaped(file), escaped(source_text(file)));
    }
    return out;
  }

  const TopicEntry& topic_;
  Owned<cmark_node> document_;
  std::vector<std::string> sources_;  ///< files that links lead to
  std::vector<std::string> framed_;   ///< headings whose tables have a frame
  std::string contents_;
};

}  // namespace

std::string topic_page_path(const TopicEntry& topic) {
  return docs_text(file_of(topic)).empty() ? "" : fmt::format("topics/{}.html", key_of(topic));
}

void load_page_maker() { cmark(); }

std::string topic_page(const TopicEntry& topic, std::span<const Link> figures) {
  Page page(topic);
  std::string body = page.body(figures);  // finds the contents, too
  return page_of(
      {.title = escaped(topic.title) + ": how it works",
       .summary = escaped(topic.summary),
       .trail = "<a href=\"../../index.html\">all figures</a> <span aria-hidden=\"true\">›</span> " +
                escaped(heading_of(topic.chapter)),
       .contents = page.contents(),
       .body = std::move(body),
       .styles = {"topic.css"},
       .scripts = {"topic.js"}});
}

std::string html_of_line(std::string_view markdown) {
  const Owned<cmark_node> document = parsed(markdown);
  // Tags of a line are text: "<T>"
  for (const auto& [kind, type] :
       {std::pair{"html_inline", CMARK_NODE_TEXT}, {"html_block", CMARK_NODE_CODE_BLOCK}}) {
    for (cmark_node* tag : nodes_of(document.get(), kind))
      replace(tag, html_node(type, cmark().node_get_literal(tag)));
  }
  put_formulas(document.get());
  put_prose(document.get());
  std::string html = html_of(document.get());
  constexpr std::string_view before = "<p>", after = "</p>\n";
  if (html.starts_with(before) && html.ends_with(after)) {
    html = html.substr(before.size(), html.size() - before.size() - after.size());
  }
  return html;
}

}  // namespace gradus
