#pragma once
// What engines refuse that handle triangles only.

#include <string>

#include "provis/error.hpp"
#include "provis/scene.hpp"

namespace provis {

/// Throws Error::unsupported if there are spheres; queries: "from-point queries".
inline void require_triangles(const Scene& scene, const std::string& queries) {
  if (!scene.spheres().empty())
    throw Error(
        Error::Code::unsupported, "scene",
        "spheres are not handled by " + queries + ": " + std::to_string(scene.spheres().size()) + " of them");
}

}  // namespace provis
