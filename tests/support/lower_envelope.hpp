#pragma once
// CGAL's lower_envelope_3 behind plain types: its header alone takes a minute to compile.

#include <gmpxx.h>

#include <array>
#include <set>
#include <vector>

namespace provis::test {

/// A triangle in space, none of it vertical, with the id of what it belongs to.
struct EnvelopeTriangle {
  std::array<std::array<mpq_class, 3>, 3> corners;
  unsigned id = 0;
};

/// The ids that appear on the faces of the lower envelope over the plane z = 0; a face has positive area.
/// Throws what CGAL throws where one of its assertions fails.
std::set<unsigned> lowest(const std::vector<EnvelopeTriangle>& surfaces);

}  // namespace provis::test
