#include "cli/system/descriptor.hpp"

#include <unistd.h>

namespace gradus::cli {

bool Descriptor::close() { return number_ < 0 || ::close(std::exchange(number_, -1)) == 0; }

}  // namespace gradus::cli
