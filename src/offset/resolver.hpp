#pragma once
// What is proven to hide what a beam may hit.

#include <optional>
#include <vector>

#include "src/offset/shadows.hpp"
#include "src/offset/side.hpp"

namespace provis::offset {

/// Occluders that together cover a beam: every ray of it meets one of them.
struct Cover {
  double far = 0;  ///< at no greater depth than this
  std::vector<std::uint32_t> members;
};

/// One worker's view of a face.
class Resolver {
 public:
  Resolver(const std::vector<Facet>& facets, const Mesh& mesh, const Shafts& shafts)
      : facets_(facets), fusion_(mesh), shafts_(shafts), place_(facets.size(), 0) {}

  /// Fused occluders that cover the whole beam: the nearest that is found.
  std::optional<Cover> cover(const Beam& beam, const std::vector<Entry>& list);

  /// Whether the entry certainly lies behind the cover, wherever a ray of the beam hits both.
  bool behind(const Cover& cover, const Entry& entry) const;

  /// shadows: of the list that the entry is in.
  /// Failure::none if some occluders of it certainly come before the entry on all rays of the beam that
  /// hit it; Failure::seen if one such ray certainly meets nothing before it, so that no part of the beam can
  /// hide it; otherwise what stood in the way of the nearest that came into question.
  /// by_sides: where an edge stands in the way, each side of its line is tried alone, which may take thrice
  /// as long.
  Failure hide(const Beam& beam, const Shadows& shadows, const Entry& entry, bool by_sides);

 private:
  class Hiding;
  double farthest(const std::vector<std::uint32_t>& members, const std::vector<Entry>& list);

  static constexpr std::size_t most_members = 256, most_seeds = 8, most_lines = 4;

  const std::vector<Facet>& facets_;
  Fusion fusion_;
  const Shafts& shafts_;
  std::uint32_t last_seed_ = UINT32_MAX;  ///< an occluder
  std::vector<std::uint32_t> place_;      ///< by facet: where it is in the list at hand, if it is
};

}  // namespace provis::offset
