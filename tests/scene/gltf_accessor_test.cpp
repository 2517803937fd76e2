// Accessors: component types, normalisation, strides, offsets, sparse substitution, zeros.
#include <catch2/catch.hpp>
#include <limits>

#include "tests/scene/gltf_builder.hpp"

namespace provis {
namespace {

/// The first vertex of a triangle whose coordinates are the given ones, then zeros.
template <class T>
Vec3d first_vertex(T x, T y, T z, bool normalized) {
  GltfBuilder builder;
  const int positions = builder.positions<T>({x, y, z, 0, 0, 0, 0, 0, 0});
  builder.json["accessors"][0]["normalized"] = normalized;
  builder.root({{"mesh", builder.mesh(positions)}});
  return builder.load().vertices()[0];
}

template <class T>
constexpr T least = std::numeric_limits<T>::min();
template <class T>
constexpr T most = std::numeric_limits<T>::max();

TEMPLATE_TEST_CASE("integers stand for themselves", "", std::int8_t, std::uint8_t, std::int16_t,
                   std::uint16_t, std::uint32_t) {
  const Vec3d v = first_vertex<TestType>(least<TestType>, most<TestType>, 1, false);
  CHECK(v == Vec3d{static_cast<double>(least<TestType>), static_cast<double>(most<TestType>), 1});
}

TEMPLATE_TEST_CASE("normalised integers are divided once by the largest", "", std::int8_t, std::uint8_t,
                   std::int16_t, std::uint16_t, std::uint32_t) {
  const Vec3d v = first_vertex<TestType>(least<TestType>, most<TestType>, 1, true);
  const double lowest = std::numeric_limits<TestType>::is_signed ? -1 : 0;
  CHECK(v == Vec3d{lowest, 1, 1 / static_cast<double>(most<TestType>)});
}

TEST_CASE("float positions are widened without rounding, normalised or not") {
  CHECK(first_vertex<float>(0.1f, -1e-45f, 3e38f, false) == Vec3d{0.1f, -1e-45f, 3e38f});
  CHECK(first_vertex<float>(0.1f, 2.0f, 0, true) == Vec3d{0.1f, 2, 0});
}

/// Three interleaved vertices: 12 bytes of position, 4 of something else, 4 bytes in front.
GltfBuilder interleaved() {
  GltfBuilder builder;
  const int view = builder.view<float>({9, 0, 1, 2, 9, 3, 4, 5, 9, 6, 7, 8});
  builder.json["bufferViews"][0]["byteStride"] = 16;
  const int positions = builder.add(
      "accessors",
      {{"bufferView", view}, {"byteOffset", 4}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
  builder.root({{"mesh", builder.mesh(positions)}});
  return builder;
}

TEST_CASE("offset and stride are honoured, and the last element needs no padding") {
  const Scene scene = interleaved().load();
  CHECK(scene.vertices()[0] == Vec3d{0, 1, 2});
  CHECK(scene.vertices()[1] == Vec3d{3, 4, 5});
  CHECK(scene.vertices()[2] == Vec3d{6, 7, 8});
}

TEST_CASE("an accessor that leaves its view by one byte is an error") {
  GltfBuilder builder = interleaved();
  builder.json["accessors"][0]["byteOffset"] = 5;
  CHECK_FAILURE(builder.failure(), 2, "accessors[0]");
  builder.json["accessors"][0]["byteOffset"] = 4;
  builder.json["accessors"][0]["count"] = 4;
  CHECK_FAILURE(builder.failure(), 2, "accessors[0]");
}

TEST_CASE("offsets and counts near 2^53 do not wrap around") {
  const std::uint64_t huge = std::uint64_t{1} << 53;
  GltfBuilder builder = interleaved();
  builder.json["accessors"][0]["byteOffset"] = huge;
  CHECK_FAILURE(builder.failure(), 2, "accessors[0]");
  builder = interleaved();
  builder.json["accessors"][0]["count"] = huge;
  CHECK_FAILURE(builder.failure(), 2, "accessors[0]");
  builder = interleaved();
  builder.json["bufferViews"][0]["byteOffset"] = huge;
  CHECK_FAILURE(builder.failure(), 2, "bufferViews[0]");
  builder = interleaved();
  builder.json["bufferViews"][0]["byteLength"] = huge;
  CHECK_FAILURE(builder.failure(), 2, "bufferViews[0]");
  builder = interleaved();
  builder.json["accessors"][0]["count"] = std::numeric_limits<std::uint64_t>::max();
  CHECK_FAILURE(builder.failure(), 2, "accessors[0].count");
}

TEST_CASE("a stride shorter than an element is an error") {
  GltfBuilder builder = interleaved();
  builder.json["bufferViews"][0]["byteStride"] = 8;
  CHECK_FAILURE(builder.failure(), 2, "bufferViews[0]");
}

TEST_CASE("positions must be VEC3 and indices an unsigned SCALAR") {
  GltfBuilder builder = one_triangle();
  builder.json["accessors"][0]["type"] = "VEC2";
  CHECK_FAILURE(builder.failure(), 2, "accessors[0]");
  GltfBuilder scalar = one_triangle({{"indices", 1}});
  scalar.indices<std::uint16_t>({0, 1, 2});
  scalar.json["accessors"][1]["componentType"] = 5122;
  CHECK_FAILURE(scalar.failure(), 2, "accessors[1]");
  scalar.json["accessors"][1]["componentType"] = 5123;
  scalar.json["accessors"][1]["type"] = "VEC3";
  CHECK_FAILURE(scalar.failure(), 2, "accessors[1]");
}

TEST_CASE("coordinates that are not finite are an error that names the element") {
  GltfBuilder builder;
  const float infinity = std::numeric_limits<float>::infinity();
  builder.root({{"mesh", builder.mesh(builder.positions<float>({0, 0, 0, 1, 0, 0, 0, infinity, 0}))}});
  CHECK_FAILURE(builder.failure(), 2, "accessors[0]");
  CHECK_THAT(builder.failure().message, Catch::Contains("element 2"));
}

TEST_CASE("an accessor without a buffer view holds zeros") {
  GltfBuilder builder = one_triangle();
  builder.json["accessors"][0].erase("bufferView");
  const Scene scene = builder.load();
  REQUIRE(scene.vertices().size() == 3);
  CHECK(scene.vertices()[1] == Vec3d{0, 0, 0});
}

TEST_CASE("absurd numbers of zeros are refused before memory is taken") {
  GltfBuilder builder = one_triangle();
  builder.json["accessors"][0].erase("bufferView");
  builder.json["accessors"][0]["count"] = 3'000'000'000;
  CHECK_FAILURE(builder.failure(), 3, "accessors[0]");
}

template <class Index>
GltfBuilder sparse(const std::vector<Index>& targets, bool with_base) {
  GltfBuilder builder = one_triangle();
  if (!with_base) builder.json["accessors"][0].erase("bufferView");
  const int index_view = builder.view(targets), value_view = builder.view<float>({7, 8, 9, 10, 11, 12});
  builder.json["accessors"][0]["sparse"] = {
      {"count", 2},
      {"indices", {{"bufferView", index_view}, {"componentType", component_type<Index>()}}},
      {"values", {{"bufferView", value_view}}}};
  return builder;
}

TEMPLATE_TEST_CASE("sparse accessors replace elements of their base", "", std::uint8_t, std::uint16_t,
                   std::uint32_t) {
  const Scene scene = sparse<TestType>({0, 2}, true).load();
  CHECK(scene.vertices()[0] == Vec3d{7, 8, 9});
  CHECK(scene.vertices()[1] == Vec3d{1, 0, 0});
  CHECK(scene.vertices()[2] == Vec3d{10, 11, 12});
}

TEST_CASE("sparse accessors without a base replace zeros") {
  const Scene scene = sparse<std::uint16_t>({1, 2}, false).load();
  CHECK(scene.vertices()[0] == Vec3d{0, 0, 0});
  CHECK(scene.vertices()[1] == Vec3d{7, 8, 9});
}

TEST_CASE("sparse indices must grow and stay in range") {
  CHECK_FAILURE(sparse<std::uint8_t>({2, 2}, true).failure(), 2, "accessors[0].sparse.indices");
  CHECK_FAILURE(sparse<std::uint8_t>({1, 0}, true).failure(), 2, "accessors[0].sparse.indices");
  CHECK_FAILURE(sparse<std::uint8_t>({0, 3}, true).failure(), 2, "accessors[0].sparse.indices");
  GltfBuilder builder = sparse<std::uint8_t>({0, 2}, true);
  builder.json["accessors"][0]["sparse"]["values"]["byteOffset"] = 4;
  CHECK_FAILURE(builder.failure(), 2, "accessors[0].sparse.values");
}

TEST_CASE("sparse indices of a primitive need no buffer view") {
  GltfBuilder builder = one_triangle({{"indices", 1}});
  const int index_view = builder.view<std::uint8_t>({1, 2}), value_view = builder.view<std::uint16_t>({2, 1});
  builder.add("accessors", {{"componentType", 5123},
                            {"count", 3},
                            {"type", "SCALAR"},
                            {"sparse",
                             {{"count", 2},
                              {"indices", {{"bufferView", index_view}, {"componentType", 5121}}},
                              {"values", {{"bufferView", value_view}}}}}});
  CHECK(builder.load().triangles()[0] == Triangle{0, 2, 1});
}

}  // namespace
}  // namespace provis
