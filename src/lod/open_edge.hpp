#pragma once
// Whether oriented triangles bound nothing.

#include <optional>

#include "src/lod/chain.hpp"
#include "src/offset/seams.hpp"

namespace provis::lod {

/// A part of an edge along which as many triangles do not run one way as the other.
struct OpenEdge {
  PrimitiveId triangle = 0;  ///< one that runs along it
  Vec3d from, to;
};

/// Nothing iff the chain is closed: cut at all vertices that lie on them, its edges cancel. Cut like that,
/// two edges have no inner point in common or are the same, so their sum vanishes iff each one's count does.
///
/// Input:      seams: of the chain's scene
/// Guarantee:  exact
std::optional<OpenEdge> open_edge(const Chain& chain, const offset::Seams& seams);

}  // namespace provis::lod
