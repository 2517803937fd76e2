#pragma once
// Occluder fusion: occluders joined along shared edges until no open edge of theirs is in the way.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "src/offset/facet.hpp"

namespace provis::offset {

/// The occluders among the facets of one face, and which of them share edges.
class Mesh {
 public:
  struct Edge {
    std::array<const Vec3d*, 2> ends{};
    std::array<std::uint32_t, 2> v{};    ///< welded, ascending
    std::uint32_t first = 0, count = 0;  ///< of its halves
  };
  struct Half {
    std::uint32_t facet;
    int way;  ///< +1 where the facet runs from the smaller number to the larger, otherwise -1
  };

  Mesh(std::span<const Facet> facets, const Seams& seams);

  std::size_t edge_count() const { return edges_.size(); }
  const Edge& edge(std::uint32_t e) const { return edges_[e]; }
  std::span<const Half> halves(std::uint32_t e) const { return {&halves_[edges_[e].first], edges_[e].count}; }
  /// The edges of an occluder, cut at all vertices that lie on them.
  std::span<const std::uint32_t> edges_of(std::uint32_t facet) const {
    return {edges_of_.data() + first_[facet], first_[facet + 1] - first_[facet]};
  }

 private:
  std::vector<Edge> edges_;
  std::vector<Half> halves_;
  std::vector<std::uint32_t> first_, edges_of_;  ///< by facet
};

/// Why a set of occluders hides nothing.
enum class Failure : std::uint8_t {
  none,
  seen,             ///< a ray of the beam meets nothing before it
  nothing_between,  ///< no occluder to begin with
  open_edge,        ///< an edge is in the way, and nobody continues beyond it
  unusable,         ///< who does may pierce the triangle or come after it
  too_many,
};

/// Grows sets of occluders. Count the members of a set that a segment crosses: as the segment moves, the
/// count changes only where the segment meets an edge along which the members do not cancel (as many run
/// along it one way as the other), or where an end of it meets a member (README.md, "The count"). Edges that
/// cancel are the inactive ones of the paper's Algorithm 1.
class Fusion {
 public:
  explicit Fusion(const Mesh& mesh) : mesh_(mesh), net_(mesh.edge_count(), 0) {}

  /// A set that holds the seed and has no edge that may be crossed and does not cancel; nothing if it would
  /// need an occluder that is not usable, or too many: then failure() says which. In the order in which
  /// members were added.
  template <class Usable, class MayCross>
  std::optional<std::vector<std::uint32_t>> grow(std::uint32_t seed, std::size_t most, const Usable& usable,
                                                 const MayCross& may_cross);
  Failure failure() const { return failure_; }
  /// The edge at which the last failure came up; null where the seed itself was not usable.
  const Mesh::Edge* open_edge() const { return open_edge_; }

 private:
  void add(std::uint32_t facet);

  const Mesh& mesh_;
  std::vector<int> net_;  ///< by edge; zero between calls
  std::vector<std::uint32_t> members_, touched_;
  Failure failure_ = Failure::none;
  const Mesh::Edge* open_edge_ = nullptr;
};

template <class Usable, class MayCross>
std::optional<std::vector<std::uint32_t>> Fusion::grow(std::uint32_t seed, std::size_t most,
                                                       const Usable& usable, const MayCross& may_cross) {
  members_.clear();
  touched_.clear();
  open_edge_ = nullptr;
  failure_ = usable(seed) ? Failure::none : Failure::unusable;
  if (failure_ == Failure::none) add(seed);
  // touched_ grows while it is walked; an edge is looked at again whenever a new member runs along it.
  for (std::size_t k = 0; failure_ == Failure::none && k < touched_.size(); ++k) {
    const std::uint32_t e = touched_[k];
    if (net_[e] == 0 || !may_cross(mesh_.edge(e))) continue;
    failure_ = Failure::open_edge;
    open_edge_ = &mesh_.edge(e);
    for (const Mesh::Half& h : mesh_.halves(e)) {
      if (h.way * net_[e] > 0 || std::find(members_.begin(), members_.end(), h.facet) != members_.end())
        continue;
      if (members_.size() >= most) {
        failure_ = Failure::too_many;
      } else if (!usable(h.facet)) {
        failure_ = Failure::unusable;
      } else {
        add(h.facet);
        touched_.push_back(e);  // until it cancels
        failure_ = Failure::none;
        break;
      }
    }
  }
  for (const std::uint32_t e : touched_) net_[e] = 0;
  if (failure_ != Failure::none) return std::nullopt;
  return members_;
}

}  // namespace provis::offset
