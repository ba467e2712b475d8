// The catalogues of texts, a language each: read, complete, and nothing in them that nobody says.

#include "figure/text/wording.hpp"

#include <fmt/args.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <thread>
#include <vector>

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

TEST(Language, ATextStandsOnceInWhicheverSections) {
  const auto line_of = [](std::string_view catalogue) {
    try {
      Language("xx", catalogue);
    } catch (const std::logic_error& error) {
      const std::string_view message = error.what();
      return std::string(message.substr(message.find("line ")).substr(0, 6));
    }
    return std::string();
  };
  EXPECT_EQ(line_of("[a]\none = 1\ntwo = 2\n[b]\none = 1\n[a]\nthree = 3\n"), "");
  EXPECT_EQ(line_of("[a]\none = 1\ntwo = 2\n[b]\none = 1\n[a]\none = 3\n"), "line 7");
  EXPECT_EQ(line_of("[a]\nb.one = 1\n[a.b]\none = 2\n"), "line 4");
  EXPECT_EQ(line_of("a.one = 1\n\n[a]\n# \none = 2\n"), "line 5");
}

TEST(Language, OutlivesTheCatalogueThatItReadAtOnce) {
  std::string catalogue = "[a]\none = 1\n";
  const Language read("xx", catalogue);
  std::ranges::fill(catalogue, '#');
  EXPECT_EQ(read.text("a.one"), "1");
}

TEST(Language, ReadsASectionWhenItIsAsked) {
  const Language read = Language::read_when_asked("xx", "language = X\n[a]\none = 1\n[b]\nno text\n");
  EXPECT_EQ(read.name(), "X");
  EXPECT_EQ(read.text("a.one"), "1");
  for (int i = 0; i < 2; ++i) {
    EXPECT_THROW(read.has("b.one"), std::logic_error);
    EXPECT_THROW(read.texts(), std::logic_error);
  }
  EXPECT_EQ(read.texts("a."), (Language::Texts{{"a.one", "1"}}));
}

TEST(Language, SectionsAndNamesMayHaveDots) {
  const Language read("xx", "a.top = 1\n[a]\nb.c = 2\nb = 3\n[a.b]\nd = 4\n[ab]\nd = 5\n[a]\nlate = 6\n");
  const Language::Texts all{{"a.top", "1"}, {"a.b.c", "2"}, {"a.b", "3"},
                            {"a.b.d", "4"}, {"ab.d", "5"},  {"a.late", "6"}};
  EXPECT_EQ(read.texts(), all);
  for (const auto& [key, text] : all) EXPECT_EQ(read.text(key), text);
  for (const char* key : {"", "a", "a.", ".a", "a.b.", "a.c", "a.b.d.e", "b", "top", "d"})
    EXPECT_FALSE(read.has(key)) << key;
  for (const std::string_view start : {"a", "a.", "a.b", "a.b.", "a.b.d", "ab", "a.t", "b", "."}) {
    Language::Texts some = all;
    std::erase_if(some, [&](const auto& each) { return !each.first.starts_with(start); });
    EXPECT_EQ(read.texts(start), some) << start;
  }
}

// Threads that ask at once get what one gets that asks alone (and a sanitizer watches).
TEST(Language, MayBeAskedByManyThreads) {
  std::string catalogue;
  for (int section = 0; section < 50; ++section) {
    catalogue += fmt::format("[s{}]\n", section);
    for (int text = 0; text < 20; ++text) catalogue += fmt::format("t{} = {}\n", text, section * 20 + text);
  }
  const Language read = Language::read_when_asked("xx", catalogue);
  std::atomic<int> wrong = 0;
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&, thread] {
      for (int i = 0; i < 1000; ++i) {
        const int number = (i * 7 + thread * 250) % 1000;
        wrong += read.text(fmt::format("s{}.t{}", number / 20, number % 20)) != std::to_string(number);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

TEST(Language, EnglishIsFirstAndAllHaveNames) {
  ASSERT_GE(languages().size(), 2u);
  EXPECT_EQ(languages().front().code(), "en");
  Names names;
  for (const Language& each : languages()) {
    EXPECT_EQ(find_language(each.code()), &each);
    names.emplace(each.name());
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
         kind == "note" || kind == "legend" || kind == "counts" || kind == "panel";
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

TEST(Language, EveryPanelHeadsATextThatThereIs) {
  const auto& texts = languages().front().texts();
  for (const auto& [key, text] : texts) {
    const std::size_t panel = key.find(".panel.");
    if (panel == std::string::npos) continue;
    const std::string headed = key.substr(0, panel + 1) + key.substr(panel + 7);
    const auto found = texts.lower_bound(headed);
    EXPECT_TRUE(found != texts.end() && (found->first == headed || found->first.starts_with(headed + ".")))
        << key;
  }
}

}  // namespace
}  // namespace gradus
