#pragma once
// The texts of a language, by their keys. figure/text/wording.hpp says what they are made of.

#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>

namespace gradus {

/// May be asked by several threads at once.
class Language {
 public:
  using Texts = std::map<std::string, std::string, std::less<>>;  ///< by key

  /// Reads a catalogue. Throws ContractViolation naming the line that is wrong.
  Language(std::string code, std::string_view catalogue);
  /// The same with one that outlives the language: of that each section is read when a text in it is first
  /// asked for, which throws then.
  static Language read_when_asked(std::string code, std::string_view catalogue);
  ~Language();

  const std::string& code() const { return code_; }           ///< "en", as in HTML's lang
  std::string_view name() const { return text("language"); }  ///< "English", in the language itself
  /// The template of this key. Throws ContractViolation when there is none: keys stand in our own code.
  std::string_view text(std::string_view key) const;
  bool has(std::string_view key) const;
  /// Those whose keys start like this; without it all.
  Texts texts(std::string_view start = {}) const;

 private:
  class Catalogue;
  struct WhenAsked {};

  Language(WhenAsked, std::string code, std::string_view catalogue);
  Catalogue& catalogue() const;

  std::string code_;
  std::string own_;         ///< the catalogue, where nobody else keeps it
  std::string_view whole_;  ///< the catalogue: texts are parts of it
  mutable std::once_flag asked_;
  mutable std::unique_ptr<Catalogue> catalogue_;
};

/// All languages, English first.
std::span<const Language> languages();
/// The language of that code, or nullptr.
const Language* find_language(std::string_view code);

}  // namespace gradus
