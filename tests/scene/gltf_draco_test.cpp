// KHR_draco_mesh_compression: what comes out of Draco data, and accessors that must agree with it.
#include <catch2/catch.hpp>

#include "tests/scene/draco_builder.hpp"

namespace provis {
namespace {

const std::string place = "meshes[0].primitives[0]";

TEST_CASE("floats come out of Draco data unchanged, triangle for triangle") {
  const Grid grid(6);
  const int method = GENERATE(sequential, edgebreaker);
  const int speed = GENERATE(0, 5, 10);
  const Scene scene = draco_document(grid, method, 0, speed).load();
  CHECK(scene.vertices().size() == grid.vertex_count());
  CHECK(soup(scene) == soup(grid));
}

/// The float32 arithmetic of Draco's specification: origin + integer * (range / (2^bits - 1)).
float dequantized(float value, int bits) {
  const auto largest = static_cast<float>((1 << bits) - 1);
  const float step = 10.0f / largest, scale = largest / 10.0f;
  const float product = std::floor(value * scale + 0.5f) * step;
  return 0.0f + product;
}

TEST_CASE("quantised positions are the float32 numbers of Draco's arithmetic") {
  const int bits = GENERATE(7, 11, 16), method = GENERATE(sequential, edgebreaker);
  Grid grid(6);
  const Scene scene = draco_document(grid, method, bits).load();
  const std::vector<Corners> exact = soup(grid);
  for (float& x : grid.coordinates) x = dequantized(x, bits);
  CHECK(soup(scene) == soup(grid));
  CHECK(soup(scene) != exact);
}

TEMPLATE_TEST_CASE("quantised accessors take integers out of Draco data", "", std::uint8_t, std::int16_t,
                   std::uint16_t) {
  Grid grid(6);
  std::vector<TestType> integers;
  for (const float x : grid.coordinates) integers.push_back(static_cast<TestType>(8 * x));
  DracoEncoded encoded(grid.vertex_count(), grid.indices);
  encoded.add<TestType>(draco::GeometryAttribute::POSITION, 3, integers, GENERATE(false, true));
  GltfBuilder builder = draco_document(encoded.bytes(edgebreaker), grid.vertex_count(), 50);
  builder.json["accessors"][0]["componentType"] = component_type<TestType>();
  const bool normalized = GENERATE(false, true);  // the accessor's word counts
  builder.json["accessors"][0]["normalized"] = normalized;
  std::vector<Vec3d> vertices;
  const double largest = normalized ? std::numeric_limits<TestType>::max() : 1;
  for (std::size_t i = 0; i < integers.size(); i += 3)
    vertices.push_back({integers[i] / largest, integers[i + 1] / largest, integers[i + 2] / largest});
  CHECK(soup(builder.load()) == soup(vertices, grid.triangles()));
}

TEST_CASE("the accessor's type must hold the decoded values") {
  const Grid grid(17);  // 289 vertices
  GltfBuilder builder = draco_document(grid, sequential);
  SECTION("indices of one byte") {
    builder.json["accessors"][1]["componentType"] = 5121;
    CHECK_FAILURE(builder.failure(), 2, "accessors[1]");
  }
  SECTION("indices of two bytes") {
    builder.json["accessors"][1]["componentType"] = 5123;
    CHECK(soup(builder.load()) == soup(grid));
  }
  SECTION("positions that are no integers") {
    builder.json["accessors"][0]["componentType"] = 5122;
    CHECK_FAILURE(builder.failure(), 2, "accessors[0]");
  }
}

TEST_CASE("normalised integers do not go into an accessor of floats") {
  DracoEncoded encoded(3, {0, 1, 2});
  encoded.add<std::uint8_t>(draco::GeometryAttribute::POSITION, 3, {0, 0, 0, 255, 0, 0, 0, 255, 0}, true);
  CHECK_FAILURE(draco_document(encoded.bytes(sequential), 3, 1).failure(), 2, place);
}

TEST_CASE("coordinates that are not finite are an error") {
  DracoEncoded encoded(3, {0, 1, 2});
  const float infinity = std::numeric_limits<float>::infinity();
  encoded.add<float>(draco::GeometryAttribute::POSITION, 3, {0, 0, 0, 1, 0, 0, 0, infinity, 0});
  CHECK_FAILURE(draco_document(encoded.bytes(sequential), 3, 1).failure(), 2, "accessors[0]");
}

TEST_CASE("declared counts and types must be those of the Draco data") {
  const Grid grid(6);
  GltfBuilder builder = draco_document(grid, edgebreaker);
  SECTION("too few points") { builder.json["accessors"][0]["count"] = 35; }
  SECTION("too many points") { builder.json["accessors"][0]["count"] = 37; }
  SECTION("other components") { builder.json["accessors"][0]["type"] = "VEC4"; }
  SECTION("too few indices") { builder.json["accessors"][1]["count"] = 147; }
  SECTION("too many indices") { builder.json["accessors"][1]["count"] = 153; }
  SECTION("no such attribute") { draco_of(builder)["attributes"]["POSITION"] = 1; }
  SECTION("no attribute has an id like that") { draco_of(builder)["attributes"]["POSITION"] = 4294967296; }
  SECTION("no indices") { primitive_of(builder).erase("indices"); }
  CHECK_FAILURE(builder.failure(), 2, place);
}

TEST_CASE("the number of triangles is accepted as that of the indices, as some exporters wrote it") {
  const Grid grid(6);
  GltfBuilder builder = draco_document(grid, edgebreaker);
  builder.json["accessors"][1]["count"] = 50;
  CHECK(soup(builder.load()) == soup(grid));
}

TEST_CASE("the extension's members are checked") {
  GltfBuilder builder = draco_document(Grid(3), edgebreaker);
  const std::string extension_place = place + ".extensions.KHR_draco_mesh_compression";
  SECTION("no such view") {
    draco_of(builder)["bufferView"] = 9;
    CHECK_FAILURE(builder.failure(), 2, place);
  }
  SECTION("no view") {
    draco_of(builder).erase("bufferView");
    CHECK_FAILURE(builder.failure(), 2, extension_place);
  }
  SECTION("no attributes") {
    draco_of(builder).erase("attributes");
    CHECK_FAILURE(builder.failure(), 2, extension_place);
  }
  SECTION("an id of another kind") {
    draco_of(builder)["attributes"]["POSITION"] = "0";
    CHECK_FAILURE(builder.failure(), 2, extension_place + ".attributes.POSITION");
  }
  SECTION("positions that the primitive does not have") {
    primitive_of(builder)["attributes"] = {{"NORMAL", 0}};
    CHECK_FAILURE(builder.failure(), 2, extension_place + ".attributes");
  }
  SECTION("ids of what no triangle needs may be broken") {
    draco_of(builder)["attributes"]["COLOR_0"] = "red";
    CHECK(builder.failure().status == 0);
  }
  SECTION("no such accessor") {
    primitive_of(builder)["attributes"]["POSITION"] = 2;
    CHECK_FAILURE(builder.failure(), 2, place);
  }
}

TEST_CASE("indices from 2^30 on are the loader's own, and no document reaches them") {
  GltfBuilder builder = draco_document(Grid(3), edgebreaker);
  builder.root({{"mesh", builder.mesh(1 << 30)}});
  CHECK_FAILURE(builder.failure(), 2, "meshes[1].primitives[0].attributes.POSITION");
}

TEST_CASE("Draco data is a list of triangles, also where the mode is a strip") {
  const Grid grid(4);
  GltfBuilder builder = draco_document(grid, edgebreaker);
  primitive_of(builder)["mode"] = 5;
  builder.json["accessors"][1]["count"] = 23;  // of a strip, which nothing says the length of
  CHECK(soup(builder.load()) == soup(grid));
  for (const int mode : {0, 1, 2, 3, 6}) {
    primitive_of(builder)["mode"] = mode;
    CHECK_FAILURE(builder.failure(), 2, place + ".mode");
  }
}

/// Uncompressed data, one unit higher, for the accessors of a document over Draco data.
void add_plain_data(GltfBuilder& builder, Grid grid, bool positions, bool indices) {
  for (float& x : grid.coordinates) x += 1;
  if (positions) builder.json["accessors"][0]["bufferView"] = builder.view(grid.coordinates);
  if (indices) builder.json["accessors"][1]["bufferView"] = builder.view(grid.indices);
}

TEST_CASE("uncompressed data is read where all of it is there") {
  const Grid grid(4);
  GltfBuilder builder = draco_document(grid, edgebreaker, 11);
  add_plain_data(builder, grid, true, true);
  const Scene scene = builder.load();
  CHECK(scene.arrays().triangles == grid.triangles());
  CHECK(scene.vertices()[0] == Vec3d{1, 1, 1});
  builder.json["bufferViews"][0]["byteLength"] = 1;  // nobody looks
  CHECK(builder.load().hash() == scene.hash());
}

TEST_CASE("Draco data is read where some of the uncompressed data is missing") {
  const Grid grid(4);
  GltfBuilder builder = draco_document(grid, edgebreaker);
  const bool positions = GENERATE(false, true);
  add_plain_data(builder, grid, positions, !positions);
  CHECK(soup(builder.load()) == soup(grid));
}

TEST_CASE("attributes that the extension does not name are read as usual") {
  const Grid grid(4);
  GltfBuilder builder = draco_document(grid, sequential);
  draco_of(builder)["attributes"] = {{"NORMAL", 0}};
  add_plain_data(builder, grid, true, false);
  CHECK(builder.load().vertices()[0] == Vec3d{1, 1, 1});
}

TEST_CASE("sparse elements replace those of the Draco data") {
  const Grid grid(3);
  GltfBuilder builder = draco_document(grid, sequential);
  const int targets = builder.view<std::uint8_t>({2}), values = builder.view<float>({7, 8, 9});
  builder.json["accessors"][0]["sparse"] = {{"count", 1},
                                            {"indices", {{"bufferView", targets}, {"componentType", 5121}}},
                                            {"values", {{"bufferView", values}}}};
  std::vector<Vec3d> vertices = grid.vertices();
  vertices[2] = {7, 8, 9};
  CHECK(soup(builder.load()) == soup(vertices, grid.triangles()));
}

TEST_CASE("an accessor that two Draco primitives share has the data of each") {
  const Grid grid(4);
  Grid other = grid;
  for (float& x : other.coordinates) x += 100;
  GltfBuilder builder = draco_document(grid, edgebreaker);
  builder.json["meshes"].push_back(builder.json["meshes"][0]);
  draco_of(builder, 1)["bufferView"] = builder.view(DracoEncoded(other).bytes(edgebreaker));
  builder.root({{"mesh", 1}});
  std::vector<Corners> both = soup(grid);
  const std::vector<Corners> second = soup(other);
  both.insert(both.end(), second.begin(), second.end());
  CHECK(soup(builder.load()) == both);
}

TEST_CASE("an accessor without data is zeros where no Draco primitive names it, in either order") {
  const Grid grid(4);
  GltfBuilder builder = draco_document(grid, edgebreaker);
  const int plain = builder.mesh(0);
  builder.json["accessors"][0]["count"] = 16;
  builder.json["meshes"][1]["primitives"][0]["mode"] = 5;
  const bool plain_first = GENERATE(false, true);
  builder.root({{"mesh", plain}});
  if (plain_first) builder.json["scenes"][0]["nodes"] = {1, 0};
  std::vector<Corners> expected(14, Corners{});
  const std::vector<Corners> decoded = soup(grid);
  expected.insert(expected.end(), decoded.begin(), decoded.end());
  std::ranges::sort(expected);
  CHECK(soup(builder.load()) == expected);
}

TEST_CASE("primitives over one Draco mesh") {
  const Grid grid(4);
  GltfBuilder builder = draco_document(grid, edgebreaker);
  builder.json["meshes"].push_back(builder.json["meshes"][0]);
  builder.root({{"mesh", 1}, {"translation", {100, 0, 0}}});
  const Scene scene = builder.load();
  CHECK(scene.triangles().size() == 36);
  CHECK(scene.vertices()[16] == scene.vertices()[0] + Vec3d{100, 0, 0});
}

TEST_CASE("a file may require the extension") {
  GltfBuilder builder = draco_document(Grid(4), edgebreaker);
  builder.json["extensionsUsed"] = builder.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  CHECK(builder.load().triangles().size() == 18);
}

TEST_CASE("joints and weights come out of Draco data") {
  const Grid grid(3);
  DracoEncoded encoded(grid);
  std::vector<std::uint16_t> joints;
  std::vector<float> weights;
  for (std::uint16_t i = 0; i < 9; ++i) {
    joints.insert(joints.end(), {static_cast<std::uint16_t>(i % 2), 0, 0, 0});
    weights.insert(weights.end(), {1, 0, 0, 0});
  }
  encoded.add(draco::GeometryAttribute::GENERIC, 4, joints)
      .add(draco::GeometryAttribute::GENERIC, 4, weights);
  GltfBuilder builder = draco_document(encoded.bytes(sequential), 9, 8);
  builder.add("accessors", {{"componentType", 5123}, {"count", 9}, {"type", "VEC4"}});
  builder.add("accessors", {{"componentType", 5126}, {"count", 9}, {"type", "VEC4"}});
  primitive_of(builder)["attributes"].update({{"JOINTS_0", 2}, {"WEIGHTS_0", 3}});
  draco_of(builder)["attributes"].update({{"JOINTS_0", 1}, {"WEIGHTS_0", 2}});
  builder.json["nodes"][0]["skin"] = 0;
  builder.json["skins"] = {{{"joints", {1, 2}}}};
  builder.root({{"translation", {10, 0, 0}}});
  builder.root({{"translation", {0, 20, 0}}});
  std::vector<Vec3d> vertices = grid.vertices();
  for (std::size_t i = 0; i < 9; ++i)
    vertices[i] = vertices[i] + (i % 2 == 0 ? Vec3d{10, 0, 0} : Vec3d{0, 20, 0});
  CHECK(soup(builder.load()) == soup(vertices, grid.triangles()));
}

}  // namespace
}  // namespace provis
