#pragma once
// The notation of a book or a lecturer: what figures call things, and how they write them, where it differs
// from the code. Inputs, the algorithm and its listing stay as they are.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gradus {

/// A symbol of the algorithm and what the reader calls it: p, d.
struct SymbolLabel {
  std::string symbol, text;
  friend bool operator==(const SymbolLabel&, const SymbolLabel&) = default;
};

/// Of view space, with its axes right, up and the third one.
enum class Handedness : std::uint8_t {
  left,   ///< the third axis points forward, as in the code
  right,  ///< it points backward
};

/// What it does not say stays as in the code.
struct Notation {
  std::string name;  ///< as the command names it: one of ours, or an own one as JSON; empty: the code's
  std::map<std::string, std::vector<SymbolLabel>, std::less<>> symbols{};  ///< by topic
  std::string bits{};           ///< of a region code, the first digit to the left: "TBRL"
  std::string bits_in_space{};  ///< the same with near and far: "FNTBRL"
  bool rows = false;            ///< vectors are rows: matrices are transposed, products run the other way
  Handedness handedness = Handedness::left;
  std::vector<std::string> axes{};  ///< of view space: right, up and the third one; empty or three
  std::optional<std::array<double, 2>> depth{};  ///< after the projection, at the near and at the far plane

  friend bool operator==(const Notation&, const Notation&) = default;

  /// A depth from 0 to 1, as the code has it.
  double depth_of(double z) const { return clip_depth_of(z, 1); }
  /// The same before the division by w.
  double clip_depth_of(double z, double w) const {
    return depth ? (*depth)[0] * w + ((*depth)[1] - (*depth)[0]) * z : z;
  }
  bool looks_backward() const { return handedness == Handedness::right; }
  /// A coordinate on the third axis of view space.
  double third(double forward) const { return looks_backward() ? 0 - forward : forward; }
  /// The name of an axis of view space, by what the reader calls the directions right, up and forward.
  std::string axis_name(int axis, const std::string& direction) const;
  /// The same of the direction forward: "−n" where the third axis, n, points backward.
  std::string forward_name(const std::string& direction) const;
};

}  // namespace gradus
