#pragma once
// What a mark means. Stories speak in roles; only a theme knows colours.

#include <array>
#include <cstdint>
#include <string_view>

namespace gradus {

enum class Role : std::uint8_t {
  input,      ///< what the algorithm was given
  boundary,   ///< what limits it: a wall, a window, an ideal curve
  past,       ///< done in an earlier step
  current,    ///< what this step has just done
  candidate,  ///< considered, or waiting
  accepted,   ///< found good in this step
  rejected,   ///< considered and turned down in this step
  result,     ///< what comes out in the end
  measure,    ///< a length or angle that explains a choice: the distance to the ideal line
  guide,      ///< what only helps to read: axes and their numbers, captions
};

inline constexpr std::array all_roles{Role::input,     Role::boundary, Role::past,     Role::current,
                                      Role::candidate, Role::accepted, Role::rejected, Role::result,
                                      Role::measure,   Role::guide};

/// The role's name as it stands in JSON and in SVG ids.
constexpr std::string_view name_of(Role role) {
  constexpr std::array<std::string_view, 10> names{"input",    "boundary", "past",   "current", "candidate",
                                                   "accepted", "rejected", "result", "measure", "guide"};
  return names[static_cast<std::size_t>(role)];
}

enum class Hatch : std::uint8_t { none, rising, falling, cross };

/// How a cell shows its role without colour, the same in every theme: print, projector and eyes differ.
struct Channel {
  Hatch hatch = Hatch::none;
  double outline = 0;  ///< width at 720 lines; 0: none
  bool dashed = false;
  bool cross = false;  ///< a cross in its middle
};

constexpr Channel channel_of(Role role) {
  switch (role) {
    case Role::past:
      return {Hatch::rising, 0, false, false};
    case Role::current:
      return {Hatch::none, 5, false, false};
    case Role::candidate:
      return {Hatch::none, 3, true, false};
    case Role::accepted:
      return {Hatch::none, 3, false, false};
    case Role::rejected:
      return {Hatch::none, 3, true, true};
    case Role::result:
      return {Hatch::none, 2, false, false};
    case Role::input:
    case Role::boundary:
    case Role::measure:
    case Role::guide:
      break;
  }
  return {};
}

/// Of an area, which has no cross to be told by.
constexpr Hatch area_hatch(Role role) {
  return role == Role::rejected ? Hatch::falling : channel_of(role).hatch;
}

}  // namespace gradus
