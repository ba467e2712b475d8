// In place of the importer, where gradus is built without Assimp.

#include "cli/models/imported_model.hpp"

namespace gradus::cli {

pipeline::ModelImporter model_importer() { return {}; }

}  // namespace gradus::cli
