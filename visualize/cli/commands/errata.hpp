#pragma once
// The errata gallery: each wrong form of docs/errata.md that can be run, beside the right one.

#include <string>
#include <vector>

#include "web/errata_page.hpp"

namespace gradus::cli {

/// Runs the wrong forms listed in examples/errata.json and their right ones on the same input.
std::vector<Exhibit> run_exhibits();

/// Has the faulty readers listed there and the project's own read the same texts.
std::vector<Reading> run_readings();

/// out/errata.html
std::string errata_gallery();

}  // namespace gradus::cli
