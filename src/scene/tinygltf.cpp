// The one translation unit that compiles tinygltf; in our own build, so that sanitizers see it.

// tinygltf's writers, which nobody calls, use std::ofstream without including it.
#include <fstream>

#define TINYGLTF_IMPLEMENTATION
#include "src/scene/gltf_model.hpp"

#include <limits>

#include "src/scene/failure.hpp"

namespace provis {
namespace {

/// Takes every image as loaded, without looking at it.
bool no_image(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return true;
}

}  // namespace

tinygltf::Model parse_model(const std::string& json) {
  if (json.size() > std::numeric_limits<unsigned int>::max())
    fail_unsupported("document", "over 4 GiB of JSON");
  tinygltf::TinyGLTF reader;
  reader.SetImageLoader(no_image, nullptr);
  tinygltf::Model model;
  std::string error, warning;
  const auto size = static_cast<unsigned int>(json.size());
  if (!reader.LoadASCIIFromString(&model, &error, &warning, json.data(), size, ""))
    fail_invalid("document", error.substr(0, error.find('\n')));
  return model;
}

}  // namespace provis
