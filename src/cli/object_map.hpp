#pragma once
// The file that says which primitives of three scenes are one object.

#include <string>
#include <vector>

#include "provis/level_of_detail.hpp"

namespace provis {

/// Reads JSON of format "provis.objects", version 1: {"objects": [{"name": TEXT, "full": IDS, "occluders":
/// IDS, "shell": IDS}, ...]}, where IDS is a list of nodes, by name or number in the file as text, and of id
/// ranges [first, last], both included. A member that is not there is an empty list.
///
/// Throws:     Error::invalid_input naming the place
std::vector<DetailObject> read_object_map(const std::string& file, const DetailScene& full,
                                          const DetailScene& occluders, const DetailScene& shell);

}  // namespace provis
