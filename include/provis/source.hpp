#pragma once
// Where a primitive came from in its file, and which primitives came from a node (R2).

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "provis/scene.hpp"

namespace provis {

/// The place of one primitive; -1 where the format has no such thing.
struct PrimitiveSource {
  std::int32_t node = -1, mesh = -1, primitive = -1, instance = -1;  ///< as in SourceRange
  std::uint32_t element = 0;                                         ///< as in SourceRange
  std::uint32_t part = 0, parts = 1;  ///< which of the ids that its element became: a triangle of a fan
};

/// Guarantee:  nothing only where the scene has no table of sources
/// Throws:     Error::usage for an id that the scene does not have
/// Cost:       O(log R), R runs of the table
std::optional<PrimitiveSource> source_of(const Scene& scene, PrimitiveId id);

/// Ids from first to last, both included.
struct IdRange {
  PrimitiveId first = 0, last = 0;

  friend bool operator==(const IdRange&, const IdRange&) = default;
};

/// The ids of any of these nodes (not of nodes below them), ascending, no two ranges in contact.
std::vector<IdRange> ids_of_nodes(const Scene& scene, const std::vector<int>& nodes);

/// The nodes that are meant: the one of that index if the text is a whole number, else all of exactly that
/// name.
///
/// Throws:     Error::usage where there is none, and for a file that has no nodes
std::vector<int> nodes_called(const Scene& scene, const std::string& index_or_name);

}  // namespace provis
