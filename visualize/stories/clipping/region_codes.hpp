#pragma once
// What region codes decide, in the window as in space.

#include <cstdint>

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

}  // namespace gradus
