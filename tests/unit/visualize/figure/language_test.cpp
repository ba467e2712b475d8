// The catalogues of texts, a language each: read, complete, and nothing in them that nobody says.

#include "figure/text/wording.hpp"

#include <fmt/args.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "figure/text/metrics.hpp"
#include "stories/topic.hpp"

namespace gradus {
namespace {

using Names = std::set<std::string>;

Names set_of(const std::vector<std::string>& names) { return {names.begin(), names.end()}; }

// --- Catalogues -------------------------------------------------------------------------------------------

TEST(Language, ReadsSectionsKeysAndComments) {
  const Language read("xx",
                      "# a comment\nlanguage = Xish\r\n\n[a]\none =  1 = [p] \n[b]\none = {n}\ntwo.x = ü\n");
  EXPECT_EQ(read.code(), "xx");
  EXPECT_EQ(read.name(), "Xish");
  EXPECT_EQ(read.text("a.one"), "1 = [p]");
  EXPECT_EQ(read.text("b.two.x"), "ü");
  EXPECT_EQ(read.texts().size(), 4u);
  EXPECT_TRUE(read.has("b.one"));
  EXPECT_FALSE(read.has("b"));
  EXPECT_THROW(read.text("b.three"), std::logic_error);
}

TEST(Language, SaysWhichLineIsWrong) {
  const auto message = [](std::string_view catalogue) {
    try {
      Language("xx", catalogue);
    } catch (const std::logic_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message("language = X\n[a]\nno text\n").find("line 3"), std::string::npos);
  EXPECT_NE(message("language = X\nlanguage = Y\n").find("line 2"), std::string::npos);
  EXPECT_NE(message("= Y\n").find("line 1"), std::string::npos);
}

TEST(Language, EnglishIsFirstAndAllHaveNames) {
  ASSERT_GE(languages().size(), 2u);
  EXPECT_EQ(languages().front().code(), "en");
  Names names;
  for (const Language& each : languages()) {
    EXPECT_EQ(find_language(each.code()), &each);
    names.insert(each.name());
  }
  EXPECT_EQ(names.size(), languages().size());
  EXPECT_EQ(find_language("tlh"), nullptr);
}

TEST(Language, AllHaveTheSameKeysValuesAndSymbols) {
  const Language& english = languages().front();
  EXPECT_GT(english.texts().size(), 150u);
  for (const Language& other : languages()) {
    Names ours, theirs;
    for (const auto& [key, text] : english.texts()) ours.insert(key);
    for (const auto& [key, text] : other.texts()) theirs.insert(key);
    EXPECT_EQ(ours, theirs) << other.code();
    for (const auto& [key, text] : english.texts()) {
      if (!other.has(key)) continue;
      SCOPED_TRACE(other.code() + " " + key);
      EXPECT_EQ(set_of(values_in(text)), set_of(values_in(other.text(key))));
      EXPECT_EQ(set_of(symbols_in(text)), set_of(symbols_in(other.text(key))));
    }
  }
}

TEST(Language, EveryTextCanBeFilledInAndDrawn) {
  for (const Language& each : languages()) {
    for (const auto& [key, text] : each.texts()) {
      SCOPED_TRACE(each.code() + " " + key);
      EXPECT_FALSE(text.empty());
      EXPECT_EQ(text.find("  "), std::string::npos);
      for (const Face face : {Face::sans, Face::bold, Face::italic, Face::bold_italic}) {
        EXPECT_EQ(missing_glyph(text, face).has_value(), false);
      }
      fmt::dynamic_format_arg_store<fmt::format_context> values;
      for (const std::string& name : values_in(text)) values.push_back(fmt::arg(name.c_str(), name));
      EXPECT_NO_THROW(fmt::vformat(text, values));
    }
  }
}

/// The program's sources, as the build sees them: C++ and the page's files.
std::pair<std::string, std::string> sources() {
  std::string program, page;
  const std::filesystem::path root = std::filesystem::path(GRADUS_SOURCE_DIR) / "visualize";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    const std::string kind = entry.path().extension().string();
    std::ostringstream text;
    text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    if (kind == ".cpp" || kind == ".hpp") program += text.str();
    if (kind == ".js" || kind == ".html") page += text.str();
  }
  return {program, page};
}

/// What all stories have by rule: texts that the narrator asks for by what the topic's entry says.
bool named_by_rule(std::string_view name) {
  const std::string_view kind = name.substr(0, name.find('.'));
  return name == "title" || name == "goal" || name == "symbols" || kind == "column" || kind == "method" ||
         kind == "note" || kind == "legend";
}

// Those of stories are all said, too: Telling.EverySentenceIsSaid.
TEST(Language, EveryTextIsUsed) {
  const auto [program, page] = sources();
  const auto in_program = [&](const std::string& text) {
    return program.find("\"" + text) != std::string::npos;
  };
  const auto in_page = [&](const std::string& name) {
    return page.find("say " + name + "}}") != std::string::npos ||
           page.find("'" + name + "'") != std::string::npos;
  };
  std::vector<std::string> unused;
  for (const auto& [key, text] : languages().front().texts()) {
    const std::size_t dot = key.rfind('.'), first = key.find('.');
    if (dot == std::string::npos) continue;  // "language"
    // A story leaves the topic's name out
    const bool of_a_story = find_entry(key.substr(0, first)) != nullptr;
    const std::string own = of_a_story ? key.substr(first + (key.substr(first, 6) == ".rows." ? 6 : 1)) : key;
    const std::string name = key.substr(dot + 1),
                      section = own.substr(0, std::max(own.rfind('.'), std::size_t{0}));
    const bool counted = name == "one" || name == "many";
    const auto asked_for = [&](const std::string& whole, const std::string& part) {
      const bool composed = part.find('.') != std::string::npos || of_a_story;
      return in_program(whole + "\"") || (counted && in_program(part + "\"")) ||
             (composed && whole != part && (in_program(part + ".\"") || in_program(part + ".{}\"")));
    };
    const bool shared = key.starts_with("words.") && in_program(name + "\"");  // shared("words", "yes")
    const bool of_a_page = key.starts_with("player.") || key.starts_with("live.");
    const bool used = shared || (of_a_story && named_by_rule(own)) || asked_for(own, section) ||
                      asked_for(key, key.substr(0, dot)) || (of_a_page && in_page(name));
    if (!used) unused.push_back(key);
  }
  EXPECT_EQ(unused, std::vector<std::string>());
}

}  // namespace
}  // namespace gradus
