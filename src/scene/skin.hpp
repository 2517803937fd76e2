#pragma once
// Linear blend skinning: a map of its own for every vertex.

#include <string>
#include <vector>

#include "src/scene/accessor.hpp"
#include "src/scene/placement.hpp"
#include "src/scene/pose.hpp"

namespace provis {

/// world(joint) * inverse bind matrix of every joint of that skin.
///
/// Throws:     Error::invalid_input naming skin or accessor: a skin, joint or accessor that does not exist,
///             too few matrices, a matrix that is no affine map, overflow
std::vector<Placement> joint_maps(int skin, const tinygltf::Model& model, Pose& pose,
                                  AccessorReader& accessors, const std::string& wanted_by);

/// The joints and weights of one primitive, all sets of them.
class SkinnedPrimitive {
 public:
  /// joints: how many the skin has; vertices: how many the primitive has
  ///
  /// Throws:     Error::invalid_input at place, naming accessor and element: no JOINTS_0 and WEIGHTS_0, sets
  ///             that do not match, a joint out of range that has a weight other than 0
  SkinnedPrimitive(const tinygltf::Primitive& primitive, std::size_t vertices, std::size_t joints,
                   AccessorReader& accessors, const std::string& place);

  /// The sum of weight * map over the vertex's influences, in order, those of weight 0 left out; zero
  /// without.
  Placement map_of(std::size_t vertex, const std::vector<Placement>& joints) const;

 private:
  /// JOINTS_n and WEIGHTS_n, four per vertex.
  struct Set {
    std::vector<double> joints, weights;
  };

  std::vector<Set> sets_;
};

}  // namespace provis
