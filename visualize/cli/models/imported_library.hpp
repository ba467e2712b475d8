#pragma once
// Assimp's functions, loaded by the first model that it reads: with what it needs itself that takes
// milliseconds.

#include "cairo/library_on_demand.hpp"

#if __has_include(<assimp/cimport.h>)  // gradus can be built without it

#include <assimp/cimport.h>
#include <assimp/material.h>

namespace gradus::cli {

struct AssimpLibrary {
  LibraryOnDemand library;
  GRADUS_ON_DEMAND(aiAttachLogStream);
  GRADUS_ON_DEMAND(aiCreatePropertyStore);
  GRADUS_ON_DEMAND(aiGetErrorString);
  GRADUS_ON_DEMAND(aiGetMaterialColor);
  GRADUS_ON_DEMAND(aiGetMaterialFloatArray);
  GRADUS_ON_DEMAND(aiGetMaterialString);
  GRADUS_ON_DEMAND(aiGetMaterialTexture);
  GRADUS_ON_DEMAND(aiGetMaterialTextureCount);
  GRADUS_ON_DEMAND(aiGetMaterialUVTransform);
  GRADUS_ON_DEMAND(aiImportFileExWithProperties);
  GRADUS_ON_DEMAND(aiSetImportPropertyInteger);
};

/// Throws std::runtime_error where it can't be loaded.
const AssimpLibrary& assimp();

}  // namespace gradus::cli

#endif
