#pragma once
// Scenes of objects with shells and inscribed occluders, made to touch, to coincide and to be cut by others.

#include "provis/level_of_detail.hpp"
#include "tests/lod/solids.hpp"
#include "tests/support/case.hpp"

namespace provis::test {

struct DetailCase {
  Case full;  ///< its view is a viewpoint somewhere among the objects
  SceneArrays occluders, shell;
  std::vector<DetailObject> objects;
};

/// One to five objects: boxes, octahedra and balls, whole or as unions, with shells and occluders that are
/// the surface itself, a box around it, or the surface scaled; and triangles in no object.
DetailCase detail_case(std::uint64_t seed);

/// The surfaces of an object: what is full has the flags.
struct DetailSoup {
  Soup full, occluders, shell;
  std::uint8_t flags = 0;
};
void add(DetailCase& c, const std::string& name, const DetailSoup& object);

}  // namespace provis::test
