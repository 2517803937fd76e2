#include "src/scene/morph.hpp"

#include <fmt/format.h>

#include "src/scene/failure.hpp"

namespace provis {
namespace {

void displace(std::vector<Vec3d>& positions, double weight, const std::vector<Vec3d>& displacements) {
  for (std::size_t i = 0; i < positions.size(); ++i) {
    positions[i].x += weight * displacements[i].x;
    positions[i].y += weight * displacements[i].y;
    positions[i].z += weight * displacements[i].z;
  }
}

}  // namespace

std::optional<std::vector<Vec3d>> morphed(const std::vector<Vec3d>& positions,
                                          const tinygltf::Primitive& primitive,
                                          const std::vector<double>& weights, AccessorReader& accessors,
                                          const std::string& place) {
  const std::size_t targets = primitive.targets.size();
  if (!weights.empty() && weights.size() != targets)
    fail_invalid(place, fmt::format("{} weights for {} morph targets", weights.size(), targets));
  std::optional<std::vector<Vec3d>> result;
  for (std::size_t t = 0; t < weights.size(); ++t) {
    const auto found = primitive.targets[t].find("POSITION");
    if (weights[t] == 0 || found == primitive.targets[t].end()) continue;
    const std::string target_place = fmt::format("{}.targets[{}]", place, t);
    const std::vector<Vec3d> displacements = accessors.vectors(found->second, target_place);
    if (displacements.size() != positions.size())
      fail_invalid(target_place,
                   fmt::format("{} displacements of {} vertices", displacements.size(), positions.size()));
    if (!result) result = positions;
    displace(*result, weights[t], displacements);
  }
  return result;
}

}  // namespace provis
