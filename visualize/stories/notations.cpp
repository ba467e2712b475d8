#include "stories/notations.hpp"

#include <algorithm>

namespace gradus {
namespace {

using Depth = std::array<double, 2>;

/// Foley, van Dam, Feiner, Hughes: Computer Graphics, Principles and Practice, 2nd edition.
Notation foley() {
  return {.name = "foley",
          .symbols = {{"bresenham_line", {{"p", "d"}}}, {"liang_barsky", {{"enter", "tE"}, {"leave", "tL"}}}},
          .bits = "TBRL",
          .bits_in_space = "TBRLFN",
          .handedness = Handedness::right,
          .axes = {"u", "v", "n"},
          .depth = Depth{0, -1}};
}

/// Hearn, Baker: Computer Graphics with OpenGL, 3rd edition; its line clipping is that of the C version.
Notation hearn() {
  return {.name = "hearn",
          .symbols = {{"liang_barsky", {{"t", "u"}, {"enter", "u1"}, {"leave", "u2"}}}},
          .bits = "TBRL",
          .bits_in_space = "FNTBRL",
          .handedness = Handedness::right,
          .axes = {"u", "v", "n"},
          .depth = Depth{-1, 1}};
}

/// Marschner, Shirley: Fundamentals of Computer Graphics, 4th edition. Its canonical volume is seen along −z:
/// the near plane lies at 1.
Notation shirley() {
  return {.name = "shirley", .handedness = Handedness::right, .axes = {"u", "v", "w"}, .depth = Depth{1, -1}};
}

/// The OpenGL specification and the red book, with gluLookAt.
Notation opengl() {
  return {.name = "opengl", .handedness = Handedness::right, .axes = {"s", "u", "−f"}, .depth = Depth{-1, 1}};
}

}  // namespace

std::span<const Notation> notations() {
  static const std::array all{foley(), hearn(), shirley(), opengl()};
  return all;
}

const Notation* find_notation(std::string_view name) {
  const auto found = std::ranges::find(notations(), name, &Notation::name);
  return found == notations().end() ? nullptr : &*found;
}

}  // namespace gradus
