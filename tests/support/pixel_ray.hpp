#pragma once
// The rays along pixels' centres (R8), for checkers that know rays only.

#include <gmpxx.h>

#include <optional>

#include "provis/segment.hpp"

namespace provis::test {

using Rational = mpq_class;

/// One centre to look along.
struct Pixel {
  int frame = 0, column = 0, row = 0;
};

/// Calls body(pixel) in order of frame, row and column.
template <class Body>
void for_pixels(const SegmentView& view, const Body& body) {
  for (int frame = 0; frame < static_cast<int>(view.frames.size()); ++frame) {
    for (int row = 0; row < view.pixels.height; ++row) {
      for (int column = 0; column < view.pixels.width; ++column) body(Pixel{frame, column, row});
    }
  }
}

/// from + t (to - from) where that is three float64 numbers.
std::optional<Vec3d> eye_at(const SegmentView& view, const Rational& t);

/// The ray from an eye along a pixel's centre as a claim to be checked; its primitive is still to be set. The
/// direction is 4 W H times the centre's, so that its numbers are dyadic.
Witness ray_along(const SegmentView& view, const Pixel& pixel, const Vec3d& eye);

}  // namespace provis::test
