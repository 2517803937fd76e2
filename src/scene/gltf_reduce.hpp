#pragma once
// A glTF document cut down to what decides its triangles, every kept member checked.

#include <string>

#include "src/scene/json_member.hpp"

namespace provis {

/// Kept under a name of our own among a primitive's attributes: tinygltf refuses a whole file if the
/// accessor of "indices" has no buffer view, which glTF allows (zeros, or sparse).
inline constexpr char indices_attribute[] = "PROVIS_INDICES";

/// The attribute that makes spheres of points.
inline constexpr char radius_attribute[] = "_RADIUS";

/// The names of the extensions that decide geometry.
inline constexpr char instancing_extension[] = "EXT_mesh_gpu_instancing";
inline constexpr char draco_extension[] = "KHR_draco_mesh_compression";
inline constexpr char meshopt_extension[] = "EXT_meshopt_compression";
inline constexpr char transmission_extension[] = "KHR_materials_transmission";

/// A document that tinygltf reads without dropping, defaulting or refusing anything: it skips members of
/// the wrong type in silence, and gives up on textures, animations and cameras that no triangle needs.
/// Buffers are left out as well, since their files are ours to guard.
///
/// A broken mesh, primitive, skin, accessor, view or material fails where it is used, not here
/// (gltf_fault.hpp).
///
/// keep_wrong_kinds: those too that have a member of a wrong JSON type
/// Throws:     Error::invalid_input naming the member, Error::unsupported naming version or extension
Json reduced_document(const Json& document, bool keep_wrong_kinds);

}  // namespace provis
