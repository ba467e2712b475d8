#pragma once
// What may come next on a command line: made from the tables of commands and topics, asked by the scripts
// that complete words in bash, zsh and fish.

#include <string>
#include <string_view>
#include <vector>

namespace gradus::cli {

/// A word that may stand here.
struct Candidate {
  std::string text;  ///< begins with what was typed
  std::string help;  ///< one line
};

struct Completions {
  std::vector<Candidate> words;
  bool files = false;                ///< files, too: of these endings, or any where there are none
  std::vector<std::string> endings;  ///< ".obj"
  bool folders = false;              ///< folders alone
};

/// What may come behind these words in the place of one that has been begun; it may be empty, or
/// "--theme=da". An earlier word that can't be read, and a name that means several things, give nothing.
Completions completions_of(const std::vector<std::string>& before, const std::string& typed);

/// A line each, "word<TAB>help"; then "<TAB>folders", "<TAB>files" or "<TAB>files<TAB>.obj .mtl".
std::string text_of(const Completions& completions);

/// The script for a shell: bash, zsh or fish.
std::string completion_script(std::string_view shell);

/// `gradus completion --next -- words…`: the last word is the one that has been begun.
int complete_next(const std::vector<std::string>& words);

}  // namespace gradus::cli
