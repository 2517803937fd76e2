// From ids back to the file: nodes, and rows of PLY elements.

#include "provis/source.hpp"

#include <catch2/catch.hpp>

#include "tests/scene/files.hpp"

namespace provis {
namespace {

SourceRange run(PrimitiveId first, std::uint32_t count, std::int32_t node) {
  SourceRange range;
  range.first = first;
  range.count = count;
  range.node = node;
  return range;
}

/// Ten triangles in runs of these nodes: 0-1 of node 3, 2-4 of node 1, 5-5 of node 3, 6-8 of node 3, 9-9 of
/// node 0.
SceneArrays ten_triangles() {
  SceneArrays arrays;
  arrays.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  arrays.triangles.resize(10, {0, 1, 2});
  arrays.triangle_flags.resize(10, 0);
  arrays.sources = {run(0, 2, 3), run(2, 3, 1), run(5, 1, 3), run(6, 3, 3), run(9, 1, 0)};
  arrays.node_names = {"door", "wall", "7", "door", ""};
  return arrays;
}

TEST_CASE("an id leads to the run that holds it, and to its element there") {
  SceneArrays arrays = ten_triangles();
  arrays.sources[1].mesh = 5;
  arrays.sources[1].primitive = 2;
  arrays.sources[1].instance = 8;
  arrays.sources[1].element = 100;
  arrays.sources[3].element = 40;
  arrays.sources[3].per_element = 3;
  const Scene scene(arrays);
  const PrimitiveSource wall = *source_of(scene, 4);
  CHECK((wall.node == 1 && wall.mesh == 5 && wall.primitive == 2 && wall.instance == 8));
  CHECK((wall.element == 102 && wall.part == 0 && wall.parts == 1));
  CHECK(source_of(scene, 0)->node == 3);
  CHECK(source_of(scene, 9)->node == 0);
  const PrimitiveSource fan = *source_of(scene, 8);
  CHECK((fan.element == 40 && fan.part == 2 && fan.parts == 3));
  CHECK_FALSE(source_of(Scene([&] {
                          arrays.sources.clear();
                          return arrays;
                        }()),
                        3));
}

TEST_CASE("an id that is none is refused, with the range") {
  const Failure failure = failure_of([] { source_of(Scene(ten_triangles()), 10); });
  CHECK(failure.status == 1);
  CHECK_THAT(failure.message, Catch::Contains("0 to 9"));
  CHECK_THAT(failure_of([] { source_of(Scene(), 0); }).message, Catch::Contains("no primitives"));
}

TEST_CASE("runs of a node that touch are one range") {
  const Scene scene(ten_triangles());
  CHECK(ids_of_nodes(scene, {3}) == std::vector<IdRange>{{0, 1}, {5, 8}});
  CHECK(ids_of_nodes(scene, {1}) == std::vector<IdRange>{{2, 4}});
  CHECK(ids_of_nodes(scene, {0, 3}) == std::vector<IdRange>{{0, 1}, {5, 9}});
  CHECK(ids_of_nodes(scene, {2}).empty());
}

TEST_CASE("a node is called by its index, or by a name that several may share") {
  const Scene scene(ten_triangles());
  CHECK(nodes_called(scene, "2") == std::vector<int>{2});
  CHECK(nodes_called(scene, "wall") == std::vector<int>{1});
  CHECK(nodes_called(scene, "door") == std::vector<int>{0, 3});
  CHECK(nodes_called(scene, "") == std::vector<int>{4});
  for (const char* none : {"7", "99999999999999999999", "Wall", "-1", "1x"}) {
    const Failure failure = failure_of([&] { nodes_called(scene, none); });
    CAPTURE(none);
    CHECK(failure.status == 1);
    CHECK_THAT(failure.message, Catch::Contains(none));
  }
  CHECK_THAT(failure_of([] { nodes_called(Scene(), "0"); }).message, Catch::Contains("no nodes"));
}

TEST_CASE("a table of sources with a run that is cut through an element is refused") {
  SceneArrays arrays = ten_triangles();
  arrays.sources[1].per_element = 2;
  CHECK_FAILURE(failure_of([&] { Scene{arrays}; }), 2, "sources[1]");
  arrays.sources[1].per_element = 0;
  CHECK_FAILURE(failure_of([&] { Scene{arrays}; }), 2, "sources[1]");
}

}  // namespace
}  // namespace provis
