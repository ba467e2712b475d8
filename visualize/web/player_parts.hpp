#pragma once
// What pages with a player are put together from.

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "figure/text/wording.hpp"

namespace gradus {

/// The same looks as Cairo's figures, for the page's script: a list of themes.
std::string themes_json();

/// The texts of a section of the language as parts of a template: {{say next}} is "player.next" where the
/// section is "player.".
std::vector<std::pair<std::string, std::string>> page_words(const Language& language,
                                                            std::string_view section);

/// The templates that the page's script fills in, as one object: the texts of these sections, each by the
/// rest of its key, and what figures say too.
std::string said_words(const Language& language, std::initializer_list<std::string_view> sections);

/// The scripts of the player, in the order in which they need each other.
std::string player_scripts();

}  // namespace gradus
