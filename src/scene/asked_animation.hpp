#pragma once
// Which animation of a document is asked for, and what it drives.

#include <optional>
#include <string>
#include <vector>

#include "provis/scene.hpp"
#include "src/scene/interpolation.hpp"
#include "src/scene/json_member.hpp"

namespace provis {

enum class NodeProperty { translation, rotation, scale, weights };

/// One property of one node, and the accessors of its keys.
struct AnimationChannel {
  int node = -1;
  NodeProperty property = NodeProperty::translation;
  Interpolation interpolation = Interpolation::linear;
  int input = -1, output = -1;
  std::string place;          ///< of the channel
  std::string sampler_place;  ///< of its sampler
};

struct AskedAnimation {
  int index = -1;
  std::vector<AnimationChannel> channels;
};

/// The animation that options.animation names, or the first; nothing without options.time. No other
/// animation of the file is looked at, so those may be broken.
///
/// Degenerate: a channel without a target node is ignored, as glTF says; an exact name wins over an index
/// Throws:     Error::usage for --time in a file without animations and for a name that is unknown or
///             ambiguous; Error::invalid_input naming the member; Error::unsupported for
///             KHR_animation_pointer
std::optional<AskedAnimation> asked_animation(const Json& document, const LoadOptions& options);

/// Names and times of the document's animations, as far as the JSON alone tells them. Broken ones are left
/// out.
std::vector<AnimationInfo> animation_notes(const Json& document);

}  // namespace provis
