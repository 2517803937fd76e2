#pragma once
// Parts of a document that are broken, kept in their place so that only what uses them is lost.

#include "provis/error.hpp"
#include "src/scene/gltf_model.hpp"
#include "src/scene/json_member.hpp"

namespace provis {

/// An object that stands for a broken one: nothing but the error, in "extras". All others are without extras.
///
/// placeholder: members without which tinygltf would not keep the object
Json faulty(Json placeholder, const Error& error);

/// Throws the error that the object stands for, if it does.
void check_usable(const tinygltf::Value& extras);

}  // namespace provis
