#pragma once
// The generated scenes. Each adds about as many triangles as it is asked for, by integers alone.

#include <cstdint>

#include "tools/scenes/ply_mesh.hpp"

namespace provis::scenes {

/// Buildings with recessed windows, ledges, parapets and party walls, in blocks between streets.
void city(Mesh& mesh, std::uint64_t triangles);
constexpr double city_unit = 0x1p-10;

/// Blades of five triangles on uneven ground.
void grass(Mesh& mesh, std::uint64_t triangles);
void dense_grass(Mesh& mesh, std::uint64_t triangles);
constexpr double grass_unit = 0x1p-13;

/// Trees with trunk, branches and leaves on uneven ground.
void forest(Mesh& mesh, std::uint64_t triangles);
constexpr double forest_unit = 0x1p-12;

/// A closed surface: a sphere with bumps, finely tessellated.
void closed_mesh(Mesh& mesh, std::uint64_t triangles);
constexpr double closed_mesh_unit = 0x1p-19;

/// Random triangles in a cube, none of which shares a vertex.
void soup(Mesh& mesh, std::uint64_t triangles);
constexpr double soup_unit = 0x1p-15;

}  // namespace provis::scenes
