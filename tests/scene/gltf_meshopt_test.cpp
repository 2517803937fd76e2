// EXT_meshopt_compression: documents whose views are compressed in the test by libmeshoptimizer's encoders.
#include <meshoptimizer.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "tests/scene/gltf_builder.hpp"
#include "tests/scene/grid.hpp"
#include "tests/support/environment.hpp"

namespace provis {
namespace {

const std::string extension = "EXT_meshopt_compression";
const std::string first_place = "bufferViews[0].extensions.EXT_meshopt_compression";

/// A compressed buffer view.
struct Stream {
  std::string mode, filter;
  std::size_t stride = 0, count = 0;
  std::vector<unsigned char> bytes;
};

/// stride bytes an element, `values` one after the other.
template <class T>
Stream attributes(const std::vector<T>& values, std::size_t stride, const std::string& filter = "") {
  Stream stream{"ATTRIBUTES", filter, stride, values.size() * sizeof(T) / stride, {}};
  stream.bytes.resize(meshopt_encodeVertexBufferBound(stream.count, stride));
  stream.bytes.resize(meshopt_encodeVertexBuffer(stream.bytes.data(), stream.bytes.size(), values.data(),
                                                 stream.count, stride));
  return stream;
}

Stream triangle_list(const std::vector<unsigned>& indices, std::size_t vertices, std::size_t stride) {
  meshopt_encodeIndexVersion(1);  // the one that the extension describes
  Stream stream{"TRIANGLES", "", stride, indices.size(), {}};
  stream.bytes.resize(meshopt_encodeIndexBufferBound(indices.size(), vertices));
  stream.bytes.resize(
      meshopt_encodeIndexBuffer(stream.bytes.data(), stream.bytes.size(), indices.data(), indices.size()));
  return stream;
}

Stream index_sequence(const std::vector<unsigned>& indices, std::size_t vertices, std::size_t stride) {
  meshopt_encodeIndexVersion(1);
  Stream stream{"INDICES", "", stride, indices.size(), {}};
  stream.bytes.resize(meshopt_encodeIndexSequenceBound(indices.size(), vertices));
  stream.bytes.resize(
      meshopt_encodeIndexSequence(stream.bytes.data(), stream.bytes.size(), indices.data(), indices.size()));
  return stream;
}

/// Adds the view; the buffer for its uncompressed data is number 1.
int compressed_view(GltfBuilder& builder, const Stream& stream) {
  const int index = builder.view(stream.bytes);
  Json& view = builder.json["bufferViews"][static_cast<std::size_t>(index)];
  Json compressed = {{"buffer", 0},
                     {"byteOffset", view["byteOffset"]},
                     {"byteLength", view["byteLength"]},
                     {"byteStride", stream.stride},
                     {"count", stream.count},
                     {"mode", stream.mode}};
  if (!stream.filter.empty()) compressed["filter"] = stream.filter;
  view = {{"buffer", 1}, {"byteOffset", 0}, {"byteLength", stream.stride * stream.count}};
  if (stream.mode == "ATTRIBUTES") view["byteStride"] = stream.stride;
  view["extensions"][extension] = std::move(compressed);
  return index;
}

int accessor(GltfBuilder& builder, int view, int component, std::size_t count, const std::string& type,
             bool normalized = false) {
  return builder.add("accessors", {{"bufferView", view},
                                   {"componentType", component},
                                   {"count", count},
                                   {"type", type},
                                   {"normalized", normalized}});
}

/// The second buffer stands for sizes only: no URI, and longer than the binary chunk.
void add_placeholder(GltfBuilder& builder) {
  builder.json["buffers"] = {{{"byteLength", builder.binary.size()}}, {{"byteLength", 1'000'000}}};
}

/// Positions of that stream, no indices: its vertices three by three.
GltfBuilder unindexed(const Stream& stream, int component, bool normalized = false) {
  GltfBuilder builder;
  const int view = compressed_view(builder, stream);
  builder.root(
      {{"mesh", builder.mesh(accessor(builder, view, component, stream.count, "VEC3", normalized))}});
  add_placeholder(builder);
  return builder;
}

/// A grid, positions and indices both compressed.
GltfBuilder indexed(const Grid& grid, const Stream& indices, int component, int mode) {
  GltfBuilder builder;
  const int positions = accessor(builder, compressed_view(builder, attributes(grid.coordinates, 12)), 5126,
                                 grid.vertex_count(), "VEC3");
  const int list = accessor(builder, compressed_view(builder, indices), component, indices.count, "SCALAR");
  builder.root({{"mesh", builder.mesh(positions, {{"indices", list}, {"mode", mode}})}});
  add_placeholder(builder);
  return builder;
}

Json& compressed_member(GltfBuilder& builder, std::size_t view) {
  return builder.json["bufferViews"][view]["extensions"][extension];
}

TEST_CASE("positions and triangle lists come out of meshopt's streams unchanged") {
  const Grid grid(20);  // more vertices than one block of the codec holds
  const int component = GENERATE(5123, 5125);
  const Stream list = triangle_list(grid.indices, grid.vertex_count(), component == 5123 ? 2 : 4);
  const Scene scene = indexed(grid, list, component, 4).load();
  CHECK(scene.arrays().vertices == grid.vertices());
  CHECK(turned(scene.arrays().triangles) == turned(grid.triangles()));  // the codec may turn a triangle
}

TEST_CASE("index sequences come out of meshopt's streams unchanged, lists and strips") {
  const Grid grid(20);
  const int component = GENERATE(5123, 5125);
  const std::size_t stride = component == 5123 ? 2 : 4;
  const Scene list =
      indexed(grid, index_sequence(grid.indices, grid.vertex_count(), stride), component, 4).load();
  CHECK(list.arrays().triangles == grid.triangles());
  const Scene strip =
      indexed(grid, index_sequence({0, 1, 20, 21, 40, 399}, 400, stride), component, 5).load();
  CHECK(strip.arrays().triangles ==
        std::vector<Triangle>{{0, 1, 20}, {1, 21, 20}, {20, 21, 40}, {21, 399, 40}});
}

TEMPLATE_TEST_CASE("quantised positions, padded to four bytes", "", std::int8_t, std::uint8_t, std::int16_t,
                   std::uint16_t) {
  constexpr std::size_t padded = sizeof(TestType) == 1 ? 4 : 8;
  std::vector<TestType> values;
  for (int i = 0; i < 300; ++i)
    for (const int c : {i, 7 * i, 300 - i, 0}) values.push_back(static_cast<TestType>(c));
  const bool normalized = GENERATE(false, true);
  const Scene scene = unindexed(attributes(values, padded), component_type<TestType>(), normalized).load();
  REQUIRE(scene.vertices().size() == 300);
  const double largest = normalized ? std::numeric_limits<TestType>::max() : 1;
  const auto number = [&](std::size_t i) {
    return normalized ? std::max(values[i] / largest, -1.0) : static_cast<double>(values[i]);
  };
  for (std::size_t i = 0; i < 300; ++i)
    REQUIRE(scene.vertices()[i] == Vec3d{number(4 * i), number(4 * i + 1), number(4 * i + 2)});
}

TEST_CASE("the exponential filter's numbers are mantissa times a power of two") {
  const Grid grid(9);
  std::vector<std::uint32_t> words(grid.coordinates.size());
  meshopt_encodeFilterExp(words.data(), grid.vertex_count(), 12, 15, grid.coordinates.data());
  const Scene scene = unindexed(attributes(words, 12, "EXPONENTIAL"), 5126).load();
  const auto number = [&](std::size_t i) {
    const auto mantissa = static_cast<std::int32_t>(words[i] << 8) >> 8;
    return std::ldexp(mantissa, static_cast<std::int32_t>(words[i]) >> 24);
  };
  REQUIRE(scene.vertices().size() == grid.vertex_count());
  for (std::size_t i = 0; i < grid.vertex_count(); ++i)
    REQUIRE(scene.vertices()[i] == Vec3d{number(3 * i), number(3 * i + 1), number(3 * i + 2)});
}

/// Whether each coordinate is within one unit in the last place of that type, as the extension promises.
bool within_one(const Vec3d& p, const Vec3d& q, double largest) {
  const auto close = [largest](double a, double b) { return std::abs(a - b) * largest < 1.5; };
  return close(p.x, q.x) && close(p.y, q.y) && close(p.z, q.z);
}

TEMPLATE_TEST_CASE("the octahedral filter gives unit vectors", "", std::int8_t, std::int16_t) {
  const std::vector<Vec3d> axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  std::vector<float> directions;
  for (const Vec3d& a : axes)
    for (const double x : {a.x, a.y, a.z, 0.0}) directions.push_back(static_cast<float>(x));
  constexpr int size = sizeof(TestType);
  std::vector<TestType> encoded(directions.size());
  meshopt_encodeFilterOct(encoded.data(), axes.size(), 4 * size, 8 * size, directions.data());
  const Scene scene =
      unindexed(attributes(encoded, 4 * size, "OCTAHEDRAL"), component_type<TestType>(), true).load();
  REQUIRE(scene.vertices().size() == axes.size());
  for (std::size_t i = 0; i < axes.size(); ++i)
    CHECK(within_one(scene.vertices()[i], axes[i], std::numeric_limits<TestType>::max()));
}

TEST_CASE("the quaternion filter gives unit quaternions") {
  const std::vector<float> units = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  std::vector<std::int16_t> encoded(units.size());
  meshopt_encodeFilterQuat(encoded.data(), 3, 8, 16, units.data());
  const Scene scene = unindexed(attributes(encoded, 8, "QUATERNION"), 5122, true).load();
  REQUIRE(scene.vertices().size() == 3);
  CHECK(within_one(scene.vertices()[0], {1, 0, 0}, 32767));
  CHECK(within_one(scene.vertices()[1], {0, 1, 0}, 32767));
  CHECK(within_one(scene.vertices()[2], {0, 0, 1}, 32767));
}

TEST_CASE("several accessors share a compressed view, at offsets and with a stride") {
  const std::vector<float> values = {9, 0, 1, 2, 9, 3, 4, 5, 9, 6, 7, 8, 9, 1, 1, 1, 9, 2, 2, 2, 9, 3, 3, 3};
  GltfBuilder builder;
  const int view = compressed_view(builder, attributes(values, 16));
  for (const int offset : {4, 52}) {
    const int positions = accessor(builder, view, 5126, 3, "VEC3");
    builder.json["accessors"][static_cast<std::size_t>(positions)]["byteOffset"] = offset;
    builder.root({{"mesh", builder.mesh(positions)}});
  }
  add_placeholder(builder);
  const Scene scene = builder.load();
  CHECK(scene.arrays().vertices ==
        std::vector<Vec3d>{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}});
}

TEST_CASE("sparse elements may be compressed") {
  GltfBuilder builder = one_triangle();
  const int targets = compressed_view(builder, index_sequence({0, 2}, 3, 2));
  const int values = compressed_view(builder, attributes(std::vector<float>{7, 8, 9, 10, 11, 12}, 12));
  builder.json["accessors"][0]["sparse"] = {{"count", 2},
                                            {"indices", {{"bufferView", targets}, {"componentType", 5123}}},
                                            {"values", {{"bufferView", values}}}};
  add_placeholder(builder);
  CHECK(builder.load().arrays().vertices == std::vector<Vec3d>{{7, 8, 9}, {1, 0, 0}, {10, 11, 12}});
}

GltfBuilder two_triangles() {
  return unindexed(attributes(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 5, 5, 6, 5, 5, 5, 6, 5}, 12),
                   5126);
}

TEST_CASE("compressed data counts, whatever the buffer beside it is") {
  const Scene expected = two_triangles().load();
  GltfBuilder builder = two_triangles();
  SECTION("required and a marked placeholder") {
    builder.json["extensionsUsed"] = builder.json["extensionsRequired"] = {extension};
    builder.json["buffers"][1]["extensions"][extension]["fallback"] = true;
  }
  SECTION("other data") {
    builder.json["buffers"][1] = {{"byteLength", 72},
                                  {"uri", "data:application/octet-stream;base64," + std::string(96, 'A')}};
  }
  SECTION("a file that does not exist") { builder.json["buffers"][1]["uri"] = "missing.bin"; }
  SECTION("a file that may not be opened") { builder.json["buffers"][1]["uri"] = "../../secret.bin"; }
  SECTION("no such buffer") { builder.json["bufferViews"][0]["buffer"] = 7; }
  CHECK(builder.load().hash() == expected.hash());
}

TEST_CASE("a placeholder has no data of its own") {
  GltfBuilder builder = two_triangles();
  builder.json["buffers"][1]["extensions"][extension]["fallback"] = true;
  SECTION("for an uncompressed view") { builder.json["bufferViews"][0].erase("extensions"); }
  SECTION("for compressed data") { compressed_member(builder, 0)["buffer"] = 1; }
  CHECK_FAILURE(builder.failure(), 2, "buffers[1]");
}

TEST_CASE("the later twin of the extension is refused by name where a file requires it") {
  GltfBuilder builder = two_triangles();
  builder.json["extensionsRequired"] = {"KHR_meshopt_compression"};
  CHECK_FAILURE(builder.failure(), 3, "extensionsRequired");
  CHECK_THAT(builder.failure().message, Catch::Contains("KHR_meshopt_compression"));
}

Failure after(GltfBuilder builder, const std::string& member, const Json& value) {
  compressed_member(builder, 0)[member] = value;
  return builder.failure();
}

TEST_CASE("the extension's rules are checked") {
  const GltfBuilder floats = two_triangles();
  CHECK_FAILURE(after(floats, "mode", "EDGES"), 2, first_place + ".mode");
  CHECK_FAILURE(after(floats, "filter", "COLOR"), 2, first_place + ".filter");
  CHECK_FAILURE(after(floats, "mode", 1), 2, first_place + ".mode");
  CHECK_FAILURE(after(floats, "byteStride", 16), 2, first_place);
  CHECK_FAILURE(after(floats, "count", 5), 2, first_place);
  CHECK_FAILURE(after(floats, "count", 7), 2, first_place);
  CHECK_FAILURE(after(floats, "byteLength", 1), 2, first_place);
  CHECK_FAILURE(after(floats, "byteLength", 1'000'000), 2, first_place);
  CHECK_FAILURE(after(floats, "byteOffset", 1'000'000), 2, first_place);
  CHECK_FAILURE(after(floats, "buffer", 9), 2, first_place);
  CHECK_FAILURE(after(floats, "filter", "QUATERNION"), 2, first_place);
  CHECK_FAILURE(after(floats, "filter", "OCTAHEDRAL"), 2, first_place);
  for (const char* member : {"buffer", "byteLength", "byteStride", "count", "mode"}) {
    GltfBuilder builder = floats;
    compressed_member(builder, 0).erase(member);
    CAPTURE(member);
    CHECK_FAILURE(builder.failure(), 2, first_place);
  }
}

/// An otherwise sound view of that mode whose elements have that stride.
Failure with_stride(const std::string& mode, const std::string& filter, std::size_t stride) {
  GltfBuilder builder = two_triangles();
  Json& view = builder.json["bufferViews"][0];
  view.erase("byteStride");
  view["byteLength"] = 6 * stride;
  compressed_member(builder, 0).update({{"mode", mode}, {"filter", filter}, {"byteStride", stride}});
  return builder.failure();
}

TEST_CASE("each mode and filter allows strides of its own") {
  for (const std::size_t stride : {0, 3, 6, 260})
    CHECK_FAILURE(with_stride("ATTRIBUTES", "NONE", stride), 2, first_place);
  for (const std::size_t stride : {0, 1, 3, 8}) {
    CHECK_FAILURE(with_stride("TRIANGLES", "NONE", stride), 2, first_place);
    CHECK_FAILURE(with_stride("INDICES", "NONE", stride), 2, first_place);
  }
  CHECK_FAILURE(with_stride("TRIANGLES", "EXPONENTIAL", 4), 2, first_place);
  CHECK_FAILURE(with_stride("INDICES", "EXPONENTIAL", 4), 2, first_place);
  CHECK_FAILURE(with_stride("ATTRIBUTES", "OCTAHEDRAL", 12), 2, first_place);
  CHECK_FAILURE(with_stride("ATTRIBUTES", "QUATERNION", 4), 2, first_place);
  CHECK_FAILURE(with_stride("ATTRIBUTES", "EXPONENTIAL", 6), 2, first_place);
}

TEST_CASE("lists of triangles have three indices each") {
  const Grid grid(3);
  GltfBuilder builder = indexed(grid, triangle_list(grid.indices, grid.vertex_count(), 2), 5123, 4);
  builder.json["bufferViews"][1]["byteLength"] = 2 * (grid.indices.size() - 1);
  compressed_member(builder, 1)["count"] = grid.indices.size() - 1;
  CHECK_FAILURE(builder.failure(), 2, "bufferViews[1].extensions.EXT_meshopt_compression");
}

TEST_CASE("hostile counts are refused before memory is taken") {
  const std::uint64_t huge = std::uint64_t{1} << 50;
  GltfBuilder builder = two_triangles();
  builder.json["bufferViews"][0]["byteLength"] = 12 * huge / 8;
  CHECK_FAILURE(after(builder, "count", huge / 8), 2, first_place);
  builder.json["bufferViews"][0]["byteLength"] = 12 * 3000;
  CHECK_FAILURE(after(builder, "count", 3000), 2, first_place);
  CHECK_THAT(after(builder, "count", 3000).message, Catch::Contains("at least"));

  const Grid grid(3);
  for (const Stream& stream : {triangle_list(grid.indices, 9, 4), index_sequence(grid.indices, 9, 4)}) {
    GltfBuilder indices = indexed(grid, stream, 5125, 4);
    indices.json["bufferViews"][1]["byteLength"] = std::uint64_t{12} << 40;
    compressed_member(indices, 1)["count"] = std::uint64_t{3} << 40;
    CHECK_FAILURE(indices.failure(), 2, "bufferViews[1].extensions.EXT_meshopt_compression");
  }
}

TEST_CASE("repeated elements reach the codec's limit of 64 bytes for one, and load") {
  const std::size_t count = 256 * 99;
  const Stream stream = attributes(std::vector<float>(3 * count, 0.0f), 12);
  REQUIRE(stream.bytes.size() < 12 * count / 60);
  CHECK(unindexed(stream, 5126).load().arrays().vertices == std::vector<Vec3d>(count, Vec3d{}));
}

/// Every mode in one document.
GltfBuilder every_mode() {
  const Grid grid(5);
  GltfBuilder builder = indexed(grid, triangle_list(grid.indices, grid.vertex_count(), 2), 5123, 4);
  const Stream sequence = index_sequence(grid.indices, grid.vertex_count(), 4);
  const int list = accessor(builder, compressed_view(builder, sequence), 5125, sequence.count, "SCALAR");
  builder.root({{"mesh", builder.mesh(0, {{"indices", list}})}});
  std::vector<std::uint32_t> words(grid.coordinates.size());
  meshopt_encodeFilterExp(words.data(), grid.vertex_count(), 12, 15, grid.coordinates.data());
  const int view = compressed_view(builder, attributes(words, 12, "EXPONENTIAL"));
  builder.root({{"mesh", builder.mesh(accessor(builder, view, 5126, 24, "VEC3"))}});
  add_placeholder(builder);
  return builder;
}

TEST_CASE("every truncation of a compressed view is an error") {
  const GltfBuilder whole = every_mode();
  REQUIRE(whole.load().triangles().size() == 32 + 32 + 8);
  for (std::size_t view = 0; view < whole.json["bufferViews"].size(); ++view) {
    const std::string place = fmt::format("bufferViews[{}].extensions.{}", view, extension);
    GltfBuilder builder = whole;
    const auto length = compressed_member(builder, view)["byteLength"].get<std::size_t>();
    for (std::size_t size = 0; size < length; ++size) {
      compressed_member(builder, view)["byteLength"] = size;
      CAPTURE(size, view);
      CHECK_FAILURE(builder.failure(), 2, place);
    }
  }
}

TEST_CASE("flipped bytes of compressed views load or are errors") {
  const std::size_t stride = test::case_count() < 1000 ? 4 : 1;  // few cases are asked for under sanitizers
  const GltfBuilder whole = every_mode();
  std::size_t loaded = 0, refused = 0;
  for (std::size_t i = 0; i < whole.binary.size(); i += stride)
    for (const int flip : {0x01, 0x80, 0xFF}) {
      GltfBuilder builder = whole;
      builder.binary[i] = static_cast<char>(builder.binary[i] ^ flip);
      const Failure failure = builder.failure();
      CAPTURE(i, flip, failure.message);
      REQUIRE((failure.status == 0 || failure.status == 2));
      ++(failure.status == 0 ? loaded : refused);
    }
  CHECK(loaded > 0);
  CHECK(refused > 0);
}

}  // namespace
}  // namespace provis
