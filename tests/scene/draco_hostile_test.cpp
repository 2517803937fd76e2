// Draco data that is broken, cut off, or claims more than it can hold.
#include <draco/core/varint_encoding.h>

#include <catch2/catch.hpp>

#include "src/scene/draco.hpp"
#include "src/scene/scene_source.hpp"
#include "tests/scene/draco_builder.hpp"
#include "tests/support/environment.hpp"

namespace provis {
namespace {

const std::string place = "meshes[0].primitives[0]";

/// Positions, and normals with a table of their own.
std::vector<std::uint8_t> two_attributes(int method, int bits, int speed) {
  const Grid grid(4);
  DracoEncoded encoded(grid);
  std::vector<float> normals;
  for (int i = 0; i < 16; ++i) normals.insert(normals.end(), {i % 3 == 0 ? 1.0f : 0.0f, 0, 1});
  encoded.add(draco::GeometryAttribute::NORMAL, 3, normals);
  return encoded.bytes(method, bits, speed);
}

/// Without a file on disk, of which there would be thousands.
Failure failure_in_memory(const GltfBuilder& builder) {
  const std::string glb = builder.glb();
  const ByteSpan file(reinterpret_cast<const std::uint8_t*>(glb.data()), glb.size());
  return failure_of([&file] { Scene(load_source(file, ".", {}).arrays); });
}

TEST_CASE("every truncation of Draco data is an error") {
  const int method = GENERATE(sequential, edgebreaker);
  GltfBuilder builder = draco_document(two_attributes(method, 11, 0), 16, 18);
  REQUIRE(builder.load().triangles().size() == 18);
  const auto length = builder.json["bufferViews"][0]["byteLength"].get<std::size_t>();
  for (std::size_t size = 0; size < length; ++size) {
    builder.json["bufferViews"][0]["byteLength"] = size;
    CAPTURE(size, method);
    CHECK_FAILURE(failure_in_memory(builder), 2, place);
  }
}

TEST_CASE("flipped bytes of Draco data load or are errors") {
  const std::size_t stride = test::case_count() < 1000 ? 4 : 1;  // few cases are asked for under sanitizers
  std::size_t loaded = 0, refused = 0;
  for (const int method : {sequential, edgebreaker})
    for (const int bits : {0, 11})
      for (const int speed : {0, 5, 10}) {
        const GltfBuilder whole = draco_document(two_attributes(method, bits, speed), 16, 18);
        for (std::size_t i = 0; i < whole.binary.size(); i += stride)
          for (const int flip : {0x01, 0x08, 0x80, 0xFF}) {
            GltfBuilder builder = whole;
            builder.binary[i] = static_cast<char>(builder.binary[i] ^ flip);
            const Failure failure = failure_in_memory(builder);
            CAPTURE(method, bits, speed, i, flip, failure.message);
            REQUIRE((failure.status == 0 || failure.status == 2 || failure.status == 3));
            ++(failure.status == 0 ? loaded : refused);
          }
      }
  CHECK(loaded > 0);
  CHECK(refused > 0);
}

TEST_CASE("only bitstream 2.2 is read, and only meshes") {
  GltfBuilder builder = draco_document(Grid(3), edgebreaker);
  SECTION("an older version") {
    builder.binary[6] = 1;
    CHECK_FAILURE(builder.failure(), 3, place);
    CHECK_THAT(builder.failure().message, Catch::Contains("2.1"));
  }
  SECTION("a later version") {
    builder.binary[5] = 3;
    CHECK_FAILURE(builder.failure(), 3, place);
  }
  SECTION("a point cloud") {
    builder.binary[7] = 0;
    CHECK_FAILURE(builder.failure(), 2, place);
  }
  SECTION("something else") {
    builder.binary[0] = 'd';
    CHECK_FAILURE(builder.failure(), 2, place);
  }
}

TEST_CASE("metadata is passed over") {
  const Grid grid(4);
  DracoEncoded encoded(grid);
  auto metadata = std::make_unique<draco::GeometryMetadata>();
  metadata->AddEntryString("name", "grid");
  encoded.mesh().AddMetadata(std::move(metadata));
  GltfBuilder builder = draco_document(encoded.bytes(edgebreaker), 16, 18);
  CHECK(soup(builder.load()) == soup(grid));
}

/// A header and the counts behind it, and then nothing.
std::vector<std::uint8_t> edgebreaker_counts(std::uint32_t vertices, std::uint32_t triangles,
                                             std::uint8_t attributes) {
  draco::EncoderBuffer buffer;
  const char header[] = {'D', 'R', 'A', 'C', 'O', 2, 2, draco::TRIANGULAR_MESH, edgebreaker, 0, 0, 0};
  buffer.Encode(header, sizeof header);
  draco::EncodeVarint(vertices, &buffer);
  draco::EncodeVarint(triangles, &buffer);
  buffer.Encode(attributes);
  draco::EncodeVarint(triangles, &buffer);         // symbols
  draco::EncodeVarint(std::uint32_t{0}, &buffer);  // splits
  return {buffer.data(), buffer.data() + buffer.size()};
}

TEST_CASE("counts that would take all memory are refused before it is taken") {
  const std::uint32_t huge = 1u << 30;
  CHECK_FAILURE(draco_document(edgebreaker_counts(3, huge, 0), 3, huge).failure(), 3, place);
  CHECK_FAILURE(draco_document(edgebreaker_counts(huge, huge, 0), huge, huge).failure(), 3, place);
  CHECK_FAILURE(draco_document(edgebreaker_counts(3, 1u << 20, 255), 3, 1u << 20).failure(), 3, place);
  CHECK_FAILURE(draco_document(edgebreaker_counts(3, 1u << 15, 0), 3, 1u << 15).failure(), 2, place);
}

TEST_CASE("all Draco data of a document shares one budget, which its length adds to") {
  DracoBudget budget;
  budget.take(DracoBudget::always - 1, place);
  CHECK_FAILURE(failure_of([&] { budget.take(2, place); }), 3, place);
  budget.take(1, place);
  budget.grow(3);
  budget.take(3 * DracoBudget::per_byte, place);
  CHECK_FAILURE(failure_of([&] { budget.take(1, place); }), 3, place);
}

}  // namespace
}  // namespace provis
