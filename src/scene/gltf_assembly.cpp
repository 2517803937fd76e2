#include "src/scene/gltf_assembly.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "src/scene/failure.hpp"
#include "src/scene/finite.hpp"

namespace provis {
namespace {

constexpr std::uint64_t most_ids = std::numeric_limits<PrimitiveId>::max();
/// A file of less than 2 MiB is refused before ids end. No published one comes near.
constexpr std::uint64_t most_per_byte = 2048;

std::string primitive_of(const SourceRange& source) {
  return fmt::format("meshes[{}].primitives[{}]{}", source.mesh, source.primitive,
                     source.instance < 0 ? "" : fmt::format(" of instance {}", source.instance));
}

std::string node_of(const SourceRange& source) { return fmt::format("nodes[{}]", source.node); }

}  // namespace

void GltfAssembly::set_bytes(std::uint64_t read) {
  most_ = read < most_ids / most_per_byte ? read * most_per_byte : most_ids;
}

/// Copies multiply what the file holds, so the product may not be formed before it is known to fit.
void GltfAssembly::add_product(std::uint64_t& total, std::uint64_t size, std::uint64_t copies,
                               const char* what) const {
  if (size != 0 && copies > (most_ - total) / size)
    fail_unsupported("scene",
                     most_ == most_ids
                         ? fmt::format("more than 2^32 - 1 {}, which is where ids end", what)
                         : fmt::format("more than {} {} for each byte that was read", most_per_byte, what));
  total += size * copies;
}

void GltfAssembly::expect(const DecodedPrimitive& primitive, std::size_t vertices, std::uint64_t copies) {
  arrays_.skipped.points += primitive.skipped.points * copies;
  arrays_.skipped.lines += primitive.skipped.lines * copies;
  if (primitive.shape == Shape::nothing) return;
  add_product(source_count_, 1, copies, "copies of primitives");
  if (primitive.shape == Shape::triangles) add_product(vertex_count_, vertices, copies, "vertices");
  add_product(triangle_count_, primitive.triangles.size(), copies, "triangles");
  add_product(sphere_count_, primitive.points.size(), copies, "spheres");
  std::uint64_t ids = triangle_count_;
  add_product(ids, sphere_count_, 1, "triangles and spheres");
}

void GltfAssembly::reserve() {
  arrays_.vertices.reserve(vertex_count_);
  arrays_.triangles.reserve(triangle_count_);
  arrays_.triangle_flags.reserve(triangle_count_);
  arrays_.spheres.reserve(sphere_count_);
  arrays_.sphere_flags.reserve(sphere_count_);
  arrays_.sources.reserve(source_count_);
}

GltfAssembly::Sizes GltfAssembly::sizes() const {
  return {arrays_.vertices.size(), arrays_.triangles.size(), arrays_.spheres.size(), arrays_.sources.size(),
          sphere_sources_.size()};
}

void GltfAssembly::cut(const Sizes& sizes) {
  arrays_.vertices.resize(sizes.vertices);
  arrays_.triangles.resize(sizes.triangles);
  arrays_.triangle_flags.resize(sizes.triangles);
  arrays_.spheres.resize(sizes.spheres);
  arrays_.sphere_flags.resize(sizes.spheres);
  arrays_.sources.resize(sizes.sources);
  sphere_sources_.resize(sizes.sphere_sources);
}

SceneArrays GltfAssembly::finish() {
  for (SourceRange source : sphere_sources_) {
    source.first += static_cast<PrimitiveId>(arrays_.triangles.size());
    arrays_.sources.push_back(source);
  }
  return std::move(arrays_);
}

/// A mirroring map turns front into back; swapping two corners turns it round again.
void GltfAssembly::add_triangles(const DecodedPrimitive& primitive, bool mirrored,
                                 const SourceRange& source) {
  add_source(arrays_.sources, arrays_.triangles.size(), primitive.triangles.size(), source);
  const auto first = static_cast<std::uint32_t>(arrays_.vertices.size());
  for (const auto& [a, b, c] : primitive.triangles) {
    arrays_.triangles.push_back({first + a, first + (mirrored ? c : b), first + (mirrored ? b : c)});
    arrays_.triangle_flags.push_back(primitive.flags);
  }
}

void GltfAssembly::add_sphere(const DecodedPrimitive& primitive, const Vec3d& center, const Placement& map,
                              std::size_t vertex, const SourceRange& source) {
  Sphere sphere{placed(center, map, vertex, source), radius_};
  if (!primitive.radii.empty()) {
    const auto scale = uniform_scale(map);
    if (!scale)
      fail_unsupported(node_of(source),
                       fmt::format("a map that makes an ellipsoid of the sphere at vertex {} of {}", vertex,
                                   primitive_of(source)));
    sphere.radius = primitive.radii[vertex] * *scale;
    if (!std::isfinite(sphere.radius))
      fail_invalid(node_of(source),
                   fmt::format("the radius of vertex {} of {} overflows", vertex, primitive_of(source)));
  }
  arrays_.spheres.push_back(sphere);
  arrays_.sphere_flags.push_back(primitive.flags);
}

Vec3d GltfAssembly::placed(const Vec3d& position, const Placement& map, std::size_t vertex,
                           const SourceRange& source) {
  const Vec3d v = apply(map, position);
  if (!finite(v))
    fail_invalid(node_of(source), fmt::format("vertex {} of {} overflows", vertex, primitive_of(source)));
  return v;
}

void GltfAssembly::add_source(std::vector<SourceRange>& sources, std::size_t first, std::size_t count,
                              SourceRange source) {
  if (count == 0) return;
  source.first = static_cast<PrimitiveId>(first);
  source.count = static_cast<std::uint32_t>(count);
  sources.push_back(source);
}

}  // namespace provis
