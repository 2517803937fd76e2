#pragma once
// The scene's arrays, filled one placed primitive after the other.

#include <cstdint>
#include <utility>
#include <vector>

#include "provis/error.hpp"
#include "provis/scene.hpp"
#include "src/scene/gltf_primitive.hpp"
#include "src/scene/placement.hpp"

namespace provis {

class GltfAssembly {
 public:
  /// radius: of points that have none of their own, in scene units
  explicit GltfAssembly(double radius) : radius_(radius) {}

  /// How many bytes were read. Expected is no more than some thousand vertices or primitives for each of
  /// them: copies multiply what a file holds, and zeros in it take no bytes.
  void set_bytes(std::uint64_t read);

  /// Counts what that many copies of a primitive will add, before any memory is taken for them.
  ///
  /// Throws:     Error::unsupported where ids or vertices would exceed 2^32 - 1, or what set_bytes allows
  void expect(const DecodedPrimitive& primitive, std::size_t vertices, std::uint64_t copies);

  /// Takes memory for everything that is expected.
  void reserve();

  /// Adds one copy, or nothing of it where that fails. map_of(i) is the map of vertex i.
  ///
  /// mirrored:   whether front and back change places
  /// source:     node, mesh, primitive and instance; the rest is filled in
  /// Throws:     Error::invalid_input naming node, primitive and vertex: overflow; Error::unsupported for a
  ///             radius under a map that makes ellipsoids
  template <class MapOf>
  void add(const DecodedPrimitive& primitive, const std::vector<Vec3d>& positions, const MapOf& map_of,
           bool mirrored, const SourceRange& source) {
    const Sizes before = sizes();
    try {
      append(primitive, positions, map_of, mirrored, source);
    } catch (const Error&) {
      cut(before);
      throw;
    }
  }

  void leave_out(LeftOut what) { arrays_.left_out.push_back(std::move(what)); }

  /// Everything that was added, spheres after all triangles.
  SceneArrays finish();

 private:
  struct Sizes {
    std::size_t vertices, triangles, spheres, sources, sphere_sources;
  };

  Sizes sizes() const;
  void cut(const Sizes& sizes);

  template <class MapOf>
  void append(const DecodedPrimitive& primitive, const std::vector<Vec3d>& positions, const MapOf& map_of,
              bool mirrored, const SourceRange& source) {
    if (primitive.shape == Shape::triangles) {
      add_triangles(primitive, mirrored, source);
      for (std::size_t i = 0; i < positions.size(); ++i)
        arrays_.vertices.push_back(placed(positions[i], map_of(i), i, source));
    } else if (primitive.shape == Shape::spheres) {
      add_source(sphere_sources_, arrays_.spheres.size(), primitive.points.size(), source);
      for (const std::uint32_t i : primitive.points)
        add_sphere(primitive, positions[i], map_of(i), i, source);
    }
  }

  void add_triangles(const DecodedPrimitive& primitive, bool mirrored, const SourceRange& source);
  void add_sphere(const DecodedPrimitive& primitive, const Vec3d& center, const Placement& map,
                  std::size_t vertex, const SourceRange& source);
  static Vec3d placed(const Vec3d& position, const Placement& map, std::size_t vertex,
                      const SourceRange& source);
  static void add_source(std::vector<SourceRange>& sources, std::size_t first, std::size_t count,
                         SourceRange source);

  void add_product(std::uint64_t& total, std::uint64_t size, std::uint64_t copies, const char* what) const;

  double radius_;
  std::uint64_t most_ = 0;
  std::uint64_t triangle_count_ = 0, vertex_count_ = 0, sphere_count_ = 0, source_count_ = 0;
  SceneArrays arrays_;
  std::vector<SourceRange> sphere_sources_;  ///< counted from the first sphere
};

}  // namespace provis
