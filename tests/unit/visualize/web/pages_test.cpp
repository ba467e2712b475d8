// The gallery and the topic pages as text; tests/browser looks at them in a browser.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "figure/text/markup.hpp"
#include "web/gallery_page.hpp"
#include "web/html.hpp"
#include "web/prose.hpp"
#include "web/topic_page.hpp"

namespace gradus {
namespace {

using testing::HasSubstr;
using testing::Not;

Card card(std::string slug, std::string chapter) {
  return {.slug = slug,
          .title = "Title of " + slug,
          .chapter = std::move(chapter),
          .caption = "What it shows",
          .group = {"line", "Line", ""},
          .command = "gradus figure line --from 0,0 -o a.pdf",
          .thumbnail = slug + ".svg",
          .player = slug + ".html"};
}

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Html, PlacesAreFilledOnce) {
  EXPECT_EQ(filled("a {{x}} {{y}} {{z}}", {{"x", "{{y}}"}, {"y", "2"}}), "a {{y}} 2 {{z}}");
  EXPECT_EQ(filled("{{x", {{"x", "1"}}), "{{x");
}

TEST(Html, LinksStayHere) {
  EXPECT_EQ(link_to("a/b c.html"), "./a/b%20c.html");
  EXPECT_EQ(link_to("javascript:x"), "./javascript%3Ax");
  EXPECT_EQ(link_to("//example.org"), ".///example.org");
}

TEST(GalleryPage, SaysWhatItIsGiven) {
  const std::vector<Card> cards{card("a", "scan_conversion"), card("b", "clipping"),
                                card("c", "scan_conversion")};
  const std::string page =
      gallery_page(cards, {.title = "Lecture <3>", .intro = "Lines & fills", .zip = "all.zip"});
  EXPECT_THAT(page, HasSubstr("<h1>Lecture &lt;3&gt;</h1>"));
  EXPECT_THAT(page, HasSubstr("Lines &amp; fills"));
  EXPECT_THAT(page, HasSubstr("href=\"./all.zip\""));
  EXPECT_THAT(page, HasSubstr("3 figures"));
  EXPECT_EQ(count(page, "<section data-chapter="), 2U) << "one section per chapter";
  EXPECT_THAT(page, HasSubstr("<option value=\"scan_conversion\">Scan conversion</option>"));
  EXPECT_LT(page.find("id=\"c\""), page.find("id=\"b\"")) << "chapters in the order of their first card";
}

TEST(GalleryPage, ShowsOnlyWhatACardHas) {
  Card one = card("a", "x");
  const std::string bare = gallery_page(std::vector{one});
  EXPECT_THAT(bare, Not(HasSubstr("how it works")));
  EXPECT_THAT(bare, Not(HasSubstr("lines for your slides")));
  EXPECT_THAT(bare, Not(HasSubstr(".zip")));
  EXPECT_THAT(bare, HasSubstr("1 figure."));
  one.group.page = "topics/x/line.html";
  one.zip = "a/a-steps.zip";
  one.words = {"dda", "digital <analyser>"};
  one.snippets = {{"Beamer", "\\includegraphics<1>{a}"}};
  const std::string full = gallery_page(std::vector{one});
  EXPECT_THAT(full, HasSubstr("href=\"./topics/x/line.html\""));
  EXPECT_THAT(full, HasSubstr("href=\"./a/a-steps.zip\""));
  EXPECT_THAT(full, HasSubstr("dda digital &lt;analyser&gt;\""));
  EXPECT_THAT(full, HasSubstr("<code>\\includegraphics&lt;1&gt;{a}</code>"));
}

TEST(Prose, SetsWhatIsAFormula) {
  EXPECT_EQ(set_prose("p = 3 - 2 r"), "<i>p</i> = 3 − 2 <i>r</i>");
  EXPECT_EQ(set_prose("y0 + (y1 - y0)(c - x0)"),
            "<i>y</i><sub>0</sub> + (<i>y</i><sub>1</sub> − <i>y</i><sub>0</sub>)(<i>c</i> − "
            "<i>x</i><sub>0</sub>)");
  EXPECT_EQ(set_prose("starts at -1; |z - f| > -dx"), "starts at −1; |<i>z</i> − <i>f</i>| &gt; −<i>dx</i>");
  EXPECT_EQ(set_prose("u = 2^-53, (x+1)^2"), "<i>u</i> = 2<sup>−53</sup>, (<i>x</i>+1)<sup>2</sup>");
  EXPECT_EQ(set_prose("(0,0)-(5,2) and (a + b)-(c + d)"),
            "(0,0)–(5,2) and (<i>a</i> + <i>b</i>)−(<i>c</i> + <i>d</i>)");
  EXPECT_EQ(set_prose("(P - e) at xmax - xmin"), "(P − <i>e</i>) at xmax − xmin");
  EXPECT_EQ(set_prose("pages 305-363"), "pages 305–363");
  EXPECT_EQ(set_prose("1e-8 and B^n"), "1e−8 and B<sup>n</sup>");
}

TEST(Prose, LeavesWordsWhatTheyAre) {
  for (const char* words :
       {"a right-angled, 8-connected step in 32-bit numbers, e.g. of a half-plane", "10 samples in 2 s",
        "the y-coordinate", "g++ -O3", "up to 1e308", "x-sorted lists"}) {
    EXPECT_EQ(set_prose(words), words);
  }
  EXPECT_EQ(set_prose("a corner <a>"), "a corner &lt;<i>a</i>&gt;");
}

TEST(TopicPage, EveryTopicHasOne) {
  for (const TopicEntry* topic : catalogue()) {
    EXPECT_EQ(topic_page_path(*topic), "topics/" + topic->chapter + "/" + topic->name + ".html");
    const std::string page = topic_page(*topic, {});
    EXPECT_THAT(page, HasSubstr("<title>" + escaped(topic->title) + ": how it works</title>"));
    EXPECT_THAT(page, Not(HasSubstr("aria-label=\"Players\""))) << "no list of nothing";
    EXPECT_EQ(count(page, "<section"), count(page, "</section>"));
  }
  TopicEntry unknown;
  unknown.chapter = "no_chapter";
  unknown.name = "no_topic";
  EXPECT_EQ(topic_page_path(unknown), "");
}

TEST(TopicPage, LeadsToThePlayers) {
  const std::vector<Link> figures{{"steep <line>", "a b/steep.html"}};
  const std::string page = topic_page(*catalogue().front(), figures);
  EXPECT_THAT(page, HasSubstr("<a href=\"../../a%20b/steep.html\">steep &lt;line&gt;</a>"));
}

TEST(TopicPage, PicturesAreInside) {
  const TopicEntry& topic = *catalogue().front();
  const std::string page = topic_page(topic, {});
  EXPECT_GE(count(page, "src=\"data:image/svg+xml;base64,"), 2U);
  EXPECT_THAT(page, HasSubstr("base64,PD94bWwg")) << "<?xml in base 64";
  EXPECT_THAT(page, Not(HasSubstr("../../../algorithms"))) << "a link out of the folder";
}

}  // namespace
}  // namespace gradus
