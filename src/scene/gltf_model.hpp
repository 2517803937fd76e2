#pragma once
// tinygltf's model of a document. Its own code never opens a file: that part is not compiled in.

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#include <tiny_gltf.h>

#include <string>

namespace provis {

/// Reads JSON text of a reduced document (gltf_reduce.hpp).
///
/// Throws:     Error::invalid_input with tinygltf's words
tinygltf::Model parse_model(const std::string& json);

}  // namespace provis
