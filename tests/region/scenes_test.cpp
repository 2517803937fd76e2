// Real scenes: the upper set holds the lower set, every witness holds, and neither needs the other.

#include <catch2/catch.hpp>

#include <algorithm>
#include <iostream>

#include "provis/cell.hpp"
#include "provis/witness.hpp"
#include "tests/point/named_views.hpp"
#include "tests/support/environment.hpp"

namespace provis::test {
namespace {

CellOptions coarse(CellMethod method) {
  CellOptions o;
  o.method = method;
  o.pixels = {8, 8};
  o.refinements = 2;
  o.viewpoints = 4;
  o.directions = 2;
  o.path_pixels = 2;
  return o;
}

void compare(const Scene& scene, const ViewCell& cell) {
  const CellSet upper = visible_from_cell(scene, cell, coarse(CellMethod::cos));
  const CellSet lower = visible_from_cell(scene, cell, coarse(CellMethod::lower));
  for (const PrimitiveId id : lower.set.with(Status::visible))
    REQUIRE(upper.set.status[id] != Status::hidden);
  REQUIRE(verify_witnesses(scene, cell, lower) == lower.set.witnesses.size());
  std::cout << lower.set.witnesses.size() << " proven, " << upper.bounds.hidden << " hidden of "
            << scene.primitive_count() << std::endl;  // a nightly run is watched
  // Beside walls, something is hidden from every cell of these scenes, but where the cell holds all of one.
  const bool inside = upper.bounds.touching == scene.primitive_count();
  CHECK((inside || upper.bounds.hidden > 0));
}

void compare(const std::filesystem::path& file, std::size_t views) {
  const Scene scene = load_scene(file);
  if (!scene.spheres().empty()) return;
  for (const NamedView& v : named_views(file)) {
    if (views-- == 0) break;
    for (const double edge : {0.05, 0.3}) {
      INFO(file << ", view " << v.name << ", edge " << edge);
      std::cout << file.stem().string() << ' ' << v.name << ' ' << edge << ": ";
      compare(scene, cell_around(v.view.eye, {edge, edge, edge}));
      ViewCell narrow = cell_around(v.view.eye, {edge, edge, edge});
      narrow.window = v.view.frames.front();
      std::cout << "  through its window: ";
      compare(scene, narrow);
    }
  }
}

}  // namespace

TEST_CASE("quake_bsp_e1m1: the upper set of a cell holds the lower set") {
  if (const auto file = shared_scene("quake_bsp_e1m1")) compare(*file, 2);
}

TEST_CASE("all real scenes: the upper set of a cell holds the lower set") {
  if (!nightly()) return;
  // Six faces of triangles and edges take about 500 bytes for each triangle: 3.7 GB and some minutes a cell
  // at this bound.
  constexpr std::size_t most_triangles = 8'000'000;
  std::vector<std::pair<std::size_t, std::filesystem::path>> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(shared_scenes_folder()))
    if (entry.path().extension() == ".glb" && !named_views(entry.path()).empty())
      scenes.emplace_back(load_scene(entry.path()).triangles().size(), entry.path());
  std::sort(scenes.begin(), scenes.end());
  for (const auto& [triangles, file] : scenes) {
    if (triangles <= most_triangles)
      compare(file, 1);
    else
      std::cout << "above " << most_triangles << " triangles: " << file.stem().string() << ", " << triangles
                << "\n";
  }
}

}  // namespace provis::test
