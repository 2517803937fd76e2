#pragma once
// What a verified level of detail is made of.

#include <limits>
#include <optional>

#include "provis/level_of_detail.hpp"
#include "src/lod/chain.hpp"

namespace provis::lod {

struct Object {
  std::string name;
  std::vector<PrimitiveId> full, occluders;
  Chain shell;
  std::optional<Chain> solid;  ///< its full opaque triangles; only where it has occluders
};

inline constexpr std::uint32_t no_object = std::numeric_limits<std::uint32_t>::max();

}  // namespace provis::lod

namespace provis {

struct LevelOfDetail::Parts {
  const Scene *full = nullptr, *occluders = nullptr, *shell = nullptr;
  std::vector<lod::Object> objects;
  std::vector<std::uint32_t> object_of;  ///< by id of the full scene; or lod::no_object
  double seconds = 0;                    ///< of verification, by the clock
};

}  // namespace provis
