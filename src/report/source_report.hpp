#pragma once
// One primitive, or those of some nodes, as the file that they came from has them.

#include <string>
#include <vector>

#include "provis/source.hpp"

namespace provis {

/// Where the primitive stands in the file, its flags, and its corners or its centre and radius.
///
/// Throws:     Error::usage for an id that the scene does not have
std::string source_text(const std::string& file, const Scene& scene, PrimitiveId id);

/// The same as JSON of format "provis.primitive-source", version 1.
std::string source_json(const std::string& file, const Scene& scene, PrimitiveId id);

/// One "first-last" to a line.
std::string node_ids_text(const std::vector<IdRange>& ranges);

/// JSON of format "provis.node-ids", version 1.
std::string node_ids_json(const std::string& file, const Scene& scene, const std::vector<int>& nodes);

}  // namespace provis
