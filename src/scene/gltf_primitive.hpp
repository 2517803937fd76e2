#pragma once
// One glTF primitive as triangles over its own vertices, before any node places it.

#include <cstdint>
#include <string>
#include <vector>

#include "provis/scene.hpp"
#include "src/scene/accessor.hpp"

namespace provis {

struct DecodedPrimitive {
  int positions = -1;  ///< the accessor of its vertices; -1 if it has no surface
  std::vector<Triangle> triangles;
  std::uint8_t flags = 0;
  Skipped skipped;
};

/// Triangles in glTF's order and winding:
///   TRIANGLES       (v[3i], v[3i+1], v[3i+2])
///   TRIANGLE_STRIP  (v[i], v[i+1+i%2], v[i+2-i%2])
///   TRIANGLE_FAN    (v[i+1], v[i+2], v[0])
///
/// Degenerate: a primitive without positions is nothing, as glTF says; points and lines are counted
/// Throws:     Error::invalid_input naming the primitive, Error::unsupported for compressed geometry
DecodedPrimitive decode_primitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                                  AccessorReader& accessors, const std::string& place);

}  // namespace provis
