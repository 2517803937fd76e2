#pragma once
// What R9 says of a triangle before any ray is looked at.

#include "provis/cell.hpp"

namespace provis {

enum class Contact : std::uint8_t {
  apart,    ///< nothing: it has to be looked at through the faces
  visible,  ///< it meets the open box, or overlaps a face, and shows a side that it has
  hidden,   ///< no viewpoint of the cell has hits of it, or all see a side that is not there
};

/// Requires:   a RoundUp guard on the thread
/// Guarantee:  exact; every sign is taken on exact numbers where comparing input numbers does not suffice
/// Degenerate: touching a face in an edge or a point is no contact; a flat cell has no interior and no faces
Contact contact(const Scene& scene, std::size_t triangle, const ViewCell& cell);

}  // namespace provis
