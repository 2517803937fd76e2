#pragma once
// The families of scenes from which the generator draws. Coordinates are small integers and halves, so that
// coincidences abound and midpoints are exact.

#include <vector>

#include "tests/support/mesh_builder.hpp"

namespace provis::test {

struct Family {
  const char* name;
  void (*build)(MeshBuilder&);
};

/// Loose triangles: grids, coincidence, coplanarity, fans, slivers, interpenetration, cyclic overlap.
const std::vector<Family>& triangle_families();

/// Things with walls: boxes in contact, closed meshes, voxels, staircases, walls with openings and gaps.
const std::vector<Family>& solid_families();

}  // namespace provis::test
