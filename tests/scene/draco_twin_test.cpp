// An engine of 115 parts under KHR_draco_mesh_compression against the same engine uncompressed: each triangle
// has a twin whose corners are at most half a step of the quantisation away, and triangles are missing only
// where two corners are one point.
#include <draco/attributes/attribute_quantization_transform.h>
#include <draco/compression/decode.h>
#include <draco/mesh/mesh.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "tests/scene/gltf_builder.hpp"
#include "tests/support/environment.hpp"

namespace provis {
namespace {

/// A GLB with each of its meshes placed once, unmoved, in their order.
GltfBuilder unplaced(const std::filesystem::path& file) {
  const std::string glb = read_text(file);
  std::uint32_t size = 0;
  std::memcpy(&size, glb.data() + 12, sizeof size);
  GltfBuilder builder;
  builder.json = Json::parse(glb.substr(20, size));
  builder.binary = glb.substr(28 + size);
  for (const char* member : {"nodes", "scenes", "scene", "animations", "skins"}) builder.json.erase(member);
  for (std::size_t mesh = 0; mesh < builder.json["meshes"].size(); ++mesh) builder.root({{"mesh", mesh}});
  return builder;
}

/// How far a position may have moved, by what the data states of its quantisation: half of the step between
/// neighbouring values, and less than eight roundings of float32 on the way there and back.
double largest_move(const GltfBuilder& builder, const Json& primitive) {
  const Json& extension = primitive["extensions"]["KHR_draco_mesh_compression"];
  const Json& view = builder.json["bufferViews"][extension["bufferView"].get<std::size_t>()];
  draco::DecoderBuffer buffer;
  buffer.Init(builder.binary.data() + view.value("byteOffset", std::size_t{0}),
              view["byteLength"].get<std::size_t>());
  draco::Decoder decoder;
  decoder.SetSkipAttributeTransform(draco::GeometryAttribute::POSITION);
  auto mesh = decoder.DecodeMeshFromBuffer(&buffer);
  REQUIRE(mesh.ok());
  const auto id = extension["attributes"]["POSITION"].get<std::uint32_t>();
  draco::AttributeQuantizationTransform transform;
  REQUIRE(transform.InitFromAttribute(*mesh.value()->GetAttributeByUniqueId(id)));
  const double range = transform.range();
  double largest = range;
  for (int c = 0; c < 3; ++c) largest = std::max(largest, range + std::abs(double{transform.min_value(c)}));
  return range / (std::exp2(transform.quantization_bits()) - 1) / 2 + 8 * 0x1p-24 * largest;
}

using Corners = std::array<Vec3d, 3>;

std::vector<Corners> triangles_of(const Scene& scene, const SourceRange& source) {
  std::vector<Corners> all;
  for (std::uint32_t t = source.first; t < source.first + source.count; ++t)
    all.push_back({scene.corner(t, 0), scene.corner(t, 1), scene.corner(t, 2)});
  return all;
}

bool has_equal_corners(const Corners& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

bool close(const Vec3d& p, const Vec3d& q, double move) {
  return std::abs(p.x - q.x) <= move && std::abs(p.y - q.y) <= move && std::abs(p.z - q.z) <= move;
}

/// Triangles by the cells that their centroids lie in; near corners have near centroids.
class Near {
 public:
  Near(const std::vector<Corners>& triangles, double move) : triangles_(triangles), move_(move) {
    for (std::size_t i = 0; i < triangles.size(); ++i) cells_.emplace(key(triangles[i], {}), i);
  }

  /// Whether one of them has the corners of t, in the same order up to turning, moved by so much at most.
  bool has_twin_of(const Corners& t) const {
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k) {
          const auto [first, last] = cells_.equal_range(key(t, {i, j, k}));
          if (std::any_of(first, last, [&](const auto& cell) { return twins(triangles_[cell.second], t); }))
            return true;
        }
    return false;
  }

 private:
  bool twins(const Corners& a, const Corners& b) const {
    for (std::size_t turn = 0; turn < 3; ++turn)
      if (close(a[0], b[turn], move_) && close(a[1], b[(turn + 1) % 3], move_) &&
          close(a[2], b[(turn + 2) % 3], move_))
        return true;
    return false;
  }

  std::string key(const Corners& t, const std::array<int, 3>& offset) const {
    const Vec3d sum = t[0] + t[1] + t[2];
    const auto cell = [this](double x) { return static_cast<long>(std::floor(x / (3 * move_))); };
    return fmt::format("{},{},{}", cell(sum.x) + offset[0], cell(sum.y) + offset[1], cell(sum.z) + offset[2]);
  }

  const std::vector<Corners>& triangles_;
  double move_;
  std::unordered_multimap<std::string, std::size_t> cells_;
};

std::size_t without_twin(const std::vector<Corners>& triangles, const std::vector<Corners>& others,
                         double move) {
  const Near near(others, move);
  return static_cast<std::size_t>(
      std::ranges::count_if(triangles, [&near](const Corners& t) { return !near.has_twin_of(t); }));
}

TEST_CASE("an engine under Draco is its uncompressed twin, up to half a step of the quantisation") {
  const auto plain_file = test::shared_scene("khr_2CylinderEngine");
  const auto draco_file = test::shared_scene("khr_2CylinderEngine_draco");
  if (!plain_file || !draco_file) return;
  const GltfBuilder draco_builder = unplaced(*draco_file);
  const Scene plain = unplaced(*plain_file).load(), compressed = draco_builder.load();
  REQUIRE(plain.sources().size() == compressed.sources().size());
  std::size_t collapsed = 0;
  for (std::size_t s = 0; s < plain.sources().size(); ++s) {
    const SourceRange &a = plain.sources()[s], &b = compressed.sources()[s];
    REQUIRE((a.mesh == b.mesh && a.primitive == b.primitive));
    const auto mesh = static_cast<std::size_t>(b.mesh), primitive = static_cast<std::size_t>(b.primitive);
    const double move =
        largest_move(draco_builder, draco_builder.json["meshes"][mesh]["primitives"][primitive]);
    CAPTURE(mesh, primitive, move);
    std::vector<Corners> all = triangles_of(plain, a);
    collapsed += std::erase_if(all, has_equal_corners);
    const std::vector<Corners> decoded = triangles_of(compressed, b);
    CHECK(decoded.size() == all.size());
    CHECK(without_twin(decoded, all, move) == 0);
    CHECK(without_twin(all, decoded, move) == 0);
  }
  CHECK(plain.triangles().size() - compressed.triangles().size() == collapsed);
  CHECK(collapsed > 0);
}

}  // namespace
}  // namespace provis
