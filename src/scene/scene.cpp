#include "provis/scene.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "src/scene/failure.hpp"
#include "src/scene/finite.hpp"
#include "src/scene/scene_hash.hpp"

namespace provis {
namespace {

constexpr std::uint8_t known_flags = single_sided | see_through;

void check_sizes(const SceneArrays& arrays) {
  const std::size_t triangles = arrays.triangles.size(), spheres = arrays.spheres.size();
  if (arrays.triangle_flags.size() != triangles)
    fail_invalid("triangle_flags",
                 fmt::format("{} flags for {} triangles", arrays.triangle_flags.size(), triangles));
  if (arrays.sphere_flags.size() != spheres)
    fail_invalid("sphere_flags", fmt::format("{} flags for {} spheres", arrays.sphere_flags.size(), spheres));
  constexpr std::size_t most = std::numeric_limits<PrimitiveId>::max();
  if (triangles > most || spheres > most - triangles)
    fail_invalid("primitives",
                 fmt::format("{} triangles and {} spheres; ids end at 2^32 - 1", triangles, spheres));
}

void check_flags(const char* name, const std::vector<std::uint8_t>& flags) {
  for (std::size_t i = 0; i < flags.size(); ++i)
    if ((flags[i] & ~known_flags) != 0)
      fail_invalid(fmt::format("{}[{}]", name, i), fmt::format("unknown flag bits in {}", flags[i]));
}

void check_vertices(const std::vector<Vec3d>& vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec3d& v = vertices[i];
    if (!finite(v))
      fail_invalid(fmt::format("vertices[{}]", i), fmt::format("({}, {}, {}) is not finite", v.x, v.y, v.z));
  }
}

void check_triangles(const SceneArrays& arrays) {
  for (std::size_t t = 0; t < arrays.triangles.size(); ++t)
    for (const std::uint32_t index : arrays.triangles[t])
      if (index >= arrays.vertices.size())
        fail_invalid(fmt::format("triangles[{}]", t),
                     fmt::format("vertex {} of {} does not exist", index, arrays.vertices.size()));
}

void check_spheres(const std::vector<Sphere>& spheres) {
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const auto& [center, radius] = spheres[i];
    if (!finite(center) || !std::isfinite(radius))
      fail_invalid(fmt::format("spheres[{}]", i), fmt::format("({}, {}, {}) with radius {} is not finite",
                                                              center.x, center.y, center.z, radius));
    if (radius < 0)
      fail_invalid(fmt::format("spheres[{}]", i), fmt::format("the radius {} is negative", radius));
  }
}

void check_sources(const std::vector<SourceRange>& sources, std::size_t primitives) {
  if (sources.empty()) return;
  std::uint64_t next = 0;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (sources[i].first != next)
      fail_invalid(fmt::format("sources[{}]", i),
                   fmt::format("starts at id {} instead of {}", sources[i].first, next));
    if (sources[i].per_element == 0 || sources[i].count % sources[i].per_element != 0)
      fail_invalid(fmt::format("sources[{}]", i), fmt::format("{} ids are no multiple of {} for each element",
                                                              sources[i].count, sources[i].per_element));
    next += sources[i].count;
  }
  if (next != primitives) fail_invalid("sources", fmt::format("covers {} of {} ids", next, primitives));
}

}  // namespace

Scene::Scene(SceneArrays arrays) : arrays_(std::move(arrays)) {
  check_sizes(arrays_);
  check_vertices(arrays_.vertices);
  check_triangles(arrays_);
  check_spheres(arrays_.spheres);
  check_flags("triangle_flags", arrays_.triangle_flags);
  check_flags("sphere_flags", arrays_.sphere_flags);
  check_sources(arrays_.sources, primitive_count());
  hash_ = scene_hash(arrays_);
}

}  // namespace provis
