#pragma once
// The player page: opens from the file system, without a network.

#include <set>
#include <string>

#include "figure/alignment.hpp"
#include "figure/colophon.hpp"
#include "figure/sheet.hpp"
#include "figure/trace.hpp"

namespace gradus {

/// Another run, played beside the first one, step beside step.
struct PlayedBeside {
  const Trace& trace;
  std::string command;  ///< what makes it alone
  const Alignment& alignment;
};

struct PlayerOptions {
  std::set<Slot> slots{all_slots.begin(), all_slots.end()};  ///< what is shown; of the rest not even the data
  std::string theme{};       ///< the page's first theme; empty: what the reader's system prefers
  std::string topic_page{};  ///< relative path of the page about the algorithm; empty: none
  const PlayedBeside* beside = nullptr;
};
/// The offline player: one HTML file with the trace in it, drawn from its marks by the page's own script. Its
/// own words are in the language of the trace.
std::string player_page(const Trace& trace, const Colophon& colophon, const PlayerOptions& options = {});

}  // namespace gradus
