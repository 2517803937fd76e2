#pragma once
// One glTF primitive as triangles or points over its own vertices, before any node places it.

#include <cstdint>
#include <string>
#include <vector>

#include "provis/scene.hpp"
#include "src/scene/accessor.hpp"

namespace provis {

/// What becomes of a primitive's elements.
enum class Shape { nothing, triangles, spheres };

struct DecodedPrimitive {
  Shape shape = Shape::nothing;
  int positions = -1;  ///< the accessor of its vertices, unless it is nothing
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> points;  ///< the vertices that are centers of spheres
  std::vector<double> radii;          ///< of all vertices, before placement; empty if the file has none
  std::uint8_t flags = 0;
  Skipped skipped;
};

/// The accessor of that attribute, or -1.
int attribute(const tinygltf::Primitive& primitive, const std::string& name);

/// Triangles in glTF's order and winding:
///   TRIANGLES       (v[3i], v[3i+1], v[3i+2])
///   TRIANGLE_STRIP  (v[i], v[i+1+i%2], v[i+2-i%2])
///   TRIANGLE_FAN    (v[i+1], v[i+2], v[0])
///
/// and points in index order, where they have radii of their own or all points get one.
///
/// Degenerate: a primitive without positions is nothing, as glTF says; lines and other points are counted
/// Throws:     Error::invalid_input naming the primitive
DecodedPrimitive decode_primitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                                  AccessorReader& accessors, const std::string& place,
                                  bool points_are_spheres);

}  // namespace provis
