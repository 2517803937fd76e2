#pragma once
// The oracle: visibility from a point by polygon subtraction over exact numbers, as plain as it can be.
// It shares no code with the engine. Triangles only: a scene with spheres is refused (std::logic_error).

#include <span>
#include <vector>

#include "provis/scene.hpp"
#include "provis/view.hpp"
#include "provis/visible_set.hpp"

namespace provis::test {

/// A mistake put into the oracle on purpose, to prove that the comparison would catch it.
enum class Plant {
  none,
  drop_an_occluder,  ///< each subtraction forgets the first occluder that takes something away
  flip_a_tie,        ///< a tied depth counts as nearer
  use_an_epsilon,    ///< pieces of a window area below 1e-9 count as empty
};

/// Per triangle: visible by R7, exactly.
///
/// threads: 0 takes every core
std::vector<bool> oracle_visible(const SceneArrays& scene, const PointView& view, Plant plant = Plant::none,
                                 int threads = 0);

/// The same decision for the given ids only, in their order.
std::vector<bool> subtract_check(const SceneArrays& scene, const PointView& view,
                                 std::span<const PrimitiveId> ids, int threads = 0);

/// One witness per visible triangle, in id order: a point of what the subtraction left over.
std::vector<Witness> oracle_witnesses(const SceneArrays& scene, const PointView& view, int threads = 0);

inline std::vector<bool> oracle_visible(const Scene& scene, const PointView& view, Plant plant = Plant::none,
                                        int threads = 0) {
  return oracle_visible(scene.arrays(), view, plant, threads);
}

inline std::vector<bool> subtract_check(const Scene& scene, const PointView& view,
                                        std::span<const PrimitiveId> ids, int threads = 0) {
  return subtract_check(scene.arrays(), view, ids, threads);
}

}  // namespace provis::test
