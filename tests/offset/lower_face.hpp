#pragma once
// The face of a cell that looks along -z.

#include <stdexcept>

#include "src/offset/face.hpp"

namespace provis::test {

inline offset::Face lower_face(const ViewCell& cell) {
  for (const offset::Face& f : offset::faces_of(cell))
    if (f.axis == 2 && !f.upper) return f;
  throw std::logic_error("no such face");
}

}  // namespace provis::test
