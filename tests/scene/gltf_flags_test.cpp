// Sides and opacity from materials, what overrides them, and what is refused.
#include <catch2/catch.hpp>

#include "tests/scene/gltf_builder.hpp"

namespace provis {
namespace {

std::uint8_t flags_with(const Json& material, const LoadOptions& options = {}) {
  GltfBuilder builder = one_triangle({{"material", 0}});
  builder.add("materials", material);
  return builder.load(options).triangle_flags()[0];
}

Json transmission(const Json& factor) {
  return {{"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", factor}}}}}};
}

TEST_CASE("materials resolve to two flags") {
  CHECK(one_triangle().load().triangle_flags()[0] == single_sided);
  CHECK(flags_with(Json::object()) == single_sided);
  CHECK(flags_with({{"doubleSided", false}, {"alphaMode", "OPAQUE"}}) == single_sided);
  CHECK(flags_with({{"doubleSided", true}}) == 0);
  CHECK(flags_with({{"alphaMode", "MASK"}}) == (single_sided | see_through));
  CHECK(flags_with({{"alphaMode", "BLEND"}, {"doubleSided", true}}) == see_through);
}

TEST_CASE("transmission lets light through unless its factor is zero") {
  CHECK(flags_with(transmission(0.01)) == (single_sided | see_through));
  CHECK(flags_with(transmission(1)) == (single_sided | see_through));
  CHECK(flags_with(transmission(0)) == single_sided);
  CHECK(flags_with({{"extensions", {{"KHR_materials_transmission", Json::object()}}}}) == single_sided);
}

TEST_CASE("the options --sides both and --opacity all clear one flag each") {
  const Json material = {{"alphaMode", "BLEND"}};
  CHECK(flags_with(material, {Sides::both, Opacity::material}) == see_through);
  CHECK(flags_with(material, {Sides::material, Opacity::all}) == single_sided);
  CHECK(flags_with(material, {Sides::both, Opacity::all}) == 0);
}

TEST_CASE("every primitive has its own material") {
  GltfBuilder builder = one_triangle();
  builder.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"material", 0}});
  builder.add("materials", {{"doubleSided", true}});
  const Scene scene = builder.load();
  CHECK(scene.triangle_flags()[0] == single_sided);
  CHECK(scene.triangle_flags()[1] == 0);
}

TEST_CASE("a broken material is an error that names the member") {
  GltfBuilder builder = one_triangle({{"material", 1}});
  builder.add("materials", Json::object());
  CHECK_FAILURE(builder.failure(), 2, "meshes[0].primitives[0].material");
  builder.json["meshes"][0]["primitives"][0]["material"] = 0;
  builder.json["materials"][0]["alphaMode"] = "GLASS";
  CHECK_FAILURE(builder.failure(), 2, "materials[0].alphaMode");
  builder.json["materials"][0] = {{"doubleSided", 1}};
  CHECK_FAILURE(builder.failure(), 2, "materials[0].doubleSided");
}

TEST_CASE("extensions without a bearing on geometry may be required") {
  GltfBuilder builder = one_triangle();
  builder.json["extensionsRequired"] = {"KHR_mesh_quantization", "KHR_materials_unlit",
                                        "KHR_texture_transform"};
  CHECK(builder.load().triangles().size() == 1);
}

TEST_CASE("other required extensions are unsupported, by name") {
  GltfBuilder builder = one_triangle();
  builder.json["extensionsRequired"] = {"KHR_materials_unlit", "ACME_bent_space"};
  CHECK_FAILURE(builder.failure(), 3, "extensionsRequired");
  CHECK_THAT(builder.failure().message, Catch::Contains("ACME_bent_space"));
}

TEST_CASE("a second buffer without data is never taken for the binary chunk") {
  GltfBuilder builder = one_triangle();
  builder.json["buffers"] = {{{"byteLength", builder.binary.size()}},
                             {{"byteLength", builder.binary.size()}}};
  builder.json["bufferViews"][0]["buffer"] = 1;
  CHECK_FAILURE(builder.failure(), 2, "buffers[1]");
}

}  // namespace
}  // namespace provis
