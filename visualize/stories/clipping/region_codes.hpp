#pragma once
// What region codes decide, in the window as in space, and in which order their digits are written.

#include <cstdint>

#include "stories/noted.hpp"
#include "stories/telling.hpp"

namespace gradus {

/// Of the codes of both ends, and of how they are written: whether to accept, to reject or to cut.
inline Decision decided_by_codes(const Words& words, std::uint8_t a, const std::string& a_text,
                                 std::uint8_t b, const std::string& b_text) {
  const std::size_t answer = (a | b) == 0 ? 0 : (a & b) != 0 ? 1 : 2;
  return {words.say("question", {{"code_a", a_text}, {"code_b", b_text}}),
          {words.say("question.accept"), words.say("question.reject"), words.say("question.cut")},
          answer,
          std::array{"accepted", "rejected", "cut"}[answer]};
}

/// The borders in the order in which they have their bits: L is the lowest.
inline constexpr std::string_view border_letters = "LRBTNF";

/// Which border each digit of a code stands for, the first to the left: as the input "code_bits" says, else
/// as the reader's notation has it, else as the code does.
inline const std::string& digit_letters(const Arguments& arguments, const std::string& of_notation) {
  return noted_text(arguments.entry("code_bits"), of_notation);
}

/// The digits of a code in that order: "1001".
inline std::string code_text(std::uint8_t code, std::string_view letters) {
  std::string text;
  for (const char letter : letters) text += (code >> border_letters.find(letter) & 1) != 0 ? '1' : '0';
  return text;
}

/// The names of the borders in that order, with a sign between them. name(number) is that of a border.
template <class Name>
std::string digit_names(std::string_view letters, std::string_view between, Name name) {
  std::string names;
  for (const char letter : letters) {
    if (!names.empty()) names += between;
    names += name(border_letters.find(letter));
  }
  return names;
}

/// Says once what order the code has, where a reader with a notation sees another one.
template <class Name>
void say_digits_of_code(Narrator& narrator, const std::string& of_notation, std::string_view of_code,
                        Name name) {
  if (of_notation.empty() || digit_letters(narrator.arguments(), of_notation) == of_code) return;
  narrator.in_the_code("notation.digits", {{"digits", digit_names(of_code, " ", name)}});
}

}  // namespace gradus
