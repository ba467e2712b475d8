#pragma once
// Sheets as lecturers ask for them: every size with every choice of slots.

#include <algorithm>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "figure/figure.hpp"
#include "support/sanitized.hpp"

namespace gradus::test {

struct Case {
  std::string name;
  Look look;
};

/// The sizes that slides have, one in between in centimetres, upright ones, and a banner.
inline std::vector<Case> aspects() {
  std::vector<Case> cases;
  for (const auto& [name, width, height] : {std::tuple{"16:9", 1280.0, 720.0},
                                            {"4:3", 960.0, 720.0},
                                            {"1:1", 720.0, 720.0},
                                            {"3:4", 540.0, 720.0},
                                            {"12cm x 8cm", 12 / 2.54 * 96, 8 / 2.54 * 96},
                                            {"9:16", 450.0, 800.0},
                                            {"32:9", 1920.0, 540.0}}) {
    Look look;
    look.width = width;
    look.height = height;
    cases.push_back({name, look});
  }
  return cases;
}

/// Every aspect with every choice of slots that a lecturer would make, as slide and as handout.
inline std::vector<Case> slides() {
  const std::vector<std::pair<std::string, std::set<Slot>>> choices{
      {"all", {all_slots.begin(), all_slots.end()}},
      {"no listing", {Slot::title, Slot::drawing, Slot::table, Slot::sentence, Slot::footer}},
      {"no table", {Slot::title, Slot::drawing, Slot::listing, Slot::sentence, Slot::footer}},
      {"drawing", {Slot::drawing}},
      {"drawing and sentence", {Slot::drawing, Slot::sentence}},
      {"drawing and table", {Slot::drawing, Slot::table}},
      {"text", {Slot::title, Slot::listing, Slot::table}},
      {"table", {Slot::table, Slot::footer}}};
  std::vector<Case> cases;
  for (const Case& aspect : aspects()) {
    if (test::sanitized && aspect.name != "16:9" && aspect.name != "3:4") continue;
    for (const auto& [name, slots] : choices) {
      if (test::sanitized && name != "all" && name != "drawing and table") continue;
      for (const Layout layout : {Layout::slide, Layout::handout}) {
        Look look = aspect.look;
        look.slots = slots;
        look.layout = layout;
        cases.push_back({aspect.name + ", " + name + (layout == Layout::slide ? "" : ", handout"), look});
      }
    }
  }
  return cases;
}

inline double shorter_side(const Look& look) { return std::min(look.width, look.height); }

}  // namespace gradus::test
