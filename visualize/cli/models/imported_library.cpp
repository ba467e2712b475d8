#include "cli/models/imported_library.hpp"

namespace gradus::cli {

const AssimpLibrary& assimp() {
  static const AssimpLibrary functions{{GRADUS_ASSIMP, "models of this format"}};
  return functions;
}

}  // namespace gradus::cli
