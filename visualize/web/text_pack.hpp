#pragma once
// Very many texts that are alike but for their numbers, packed for a page that shows one at a time.

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gradus {

/// A part of a text, of whole lines. What stands in many texts is packed once.
struct TextPart {
  std::string text;
  bool shared = false;
};
using PartedText = std::vector<TextPart>;

/// Packs texts in blocks, each to be read alone.
///
/// A line without its numbers, its form, is kept once for all blocks. In a form \1 stands for a number, \2
/// for a colour like #0a80ff; the line \3\1 for the shared part of that number. Shared parts are texts, too,
/// in blocks of their own. A block is packed by zlib; unpacked it holds three streams, the first two behind
/// their lengths:
///
///     forms     of each text how many lines it has, then the form of each
///     places    of each number how many decimals it has, a byte each
///     digits    of each number and colour, as a whole number, the difference to the last one that stood at
///               the same place of the same form with as many decimals, 0 before the first
///
/// Whole numbers are little-endian in groups of 7 bits, the highest bit of a byte says that more follow;
/// differences come with their sign in the lowest bit. "-0.25" has 2 decimals and the digits -25. No number
/// has more than 15 digits: a longer one is several.
class TextPack {
 public:
  static constexpr std::size_t shared_in_block = 64;  ///< the last block may have fewer

  /// The texts as a block. Domain: lines that end in '\n' and hold no other control character.
  std::string block(std::span<const PartedText> texts);

  const std::vector<std::string>& forms() const { return forms_; }
  /// The blocks of the shared parts of all texts so far.
  std::vector<std::string> shared_blocks();

 private:
  int form_of(const std::string& form);
  int shared_of(const std::string& text);

  std::vector<std::string> forms_;
  std::map<std::string, int, std::less<>> form_numbers_;
  std::vector<std::string> shared_;
  std::map<std::string, int, std::less<>> shared_numbers_;
};

}  // namespace gradus
