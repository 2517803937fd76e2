#pragma once
// The extension objects that say where and how geometry is compressed, cut down and checked like the rest of
// the document (gltf_reduce.hpp).

#include <string>

#include "src/scene/json_member.hpp"

namespace provis {

/// EXT_meshopt_compression at a buffer view: all of its members.
///
/// Throws:     Error::invalid_input naming the member: missing, of another kind, or out of range
Json reduced_meshopt(const Json& extension, const std::string& place);

/// KHR_draco_mesh_compression at a primitive: the buffer view, and the ids of those attributes that the
/// reduced primitive keeps.
///
/// Throws:     Error::invalid_input as above, and for a POSITION that the primitive does not have: geometry
///             that would be left out
Json reduced_draco(const Json& extension, const Json& kept_attributes, const std::string& place);

}  // namespace provis
