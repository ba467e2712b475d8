#include <vector>

#include "stress/domain.hpp"

namespace gradus::stress {

/// Those of this program's topics, and nullptr: in a file that tests/CMakeLists.txt writes.
extern Domain (*const makers_of_domains[])();

std::span<const Domain> domains() {
  static const std::vector<Domain> all = [] {
    std::vector<Domain> made;
    for (const auto* maker = makers_of_domains; *maker; ++maker) made.push_back((*maker)());
    return made;
  }();
  return all;
}

}  // namespace gradus::stress
