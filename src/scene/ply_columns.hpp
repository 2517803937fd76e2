#pragma once
// Which properties of a PLY element hold geometry. Positions are those of PlyRow::scalars.

#include <cstddef>
#include <optional>

#include "provis/vec3.hpp"
#include "src/scene/ply_body.hpp"

namespace provis {

/// Three scalars that make a point or a vector.
struct PlyPoint {
  std::size_t x, y, z;

  Vec3d in(const PlyRow& row) const { return {row.scalars[x], row.scalars[y], row.scalars[z]}; }
};

/// Our own flags, where an element has them; other programs use the name for numbers of other types.
using PlyFlags = std::optional<std::size_t>;

struct PlySphereColumns {
  PlyPoint center;
  std::optional<std::size_t> radius;
  std::optional<PlyPoint> velocity;  ///< vx, vy, vz; two of them are none
  PlyFlags flags;
};

struct PlyFaceColumns {
  std::size_t corners;  ///< the list, among all properties
  PlyFlags flags;
};

/// Throws:     Error::invalid_input naming the element's line of the header
PlyPoint ply_position(const PlyElement& element);

/// Throws:     as above
PlySphereColumns ply_sphere_columns(const PlyElement& element);

/// Throws:     as above
PlyFaceColumns ply_face_columns(const PlyElement& element);

}  // namespace provis
