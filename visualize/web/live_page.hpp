#pragma once
// The live page: a player whose input the reader changes, with the module that answers (docs/live.md).

#include <string>
#include <string_view>
#include <vector>

namespace gradus {

/// What the page is made for.
struct LiveContent {
  std::string topics;                    ///< list_json of those that it offers
  std::vector<std::string> notations{};  ///< their names
  /// Runs that play before the module is there, and without it: {"en": {"bresenham_line": trace_json, …}}
  std::string recorded = "{}";
};

/// One HTML file in every language, that asks nothing of a network. module: the bytes of gradus.wasm, which
/// then lie in the page; empty: the page loads "gradus.wasm" from beside it, which browsers do from servers
/// alone. Throws std::runtime_error when there is no memory for packing.
std::string live_page(const LiveContent& content, std::string_view module);

}  // namespace gradus
