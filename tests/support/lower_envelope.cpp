#include "tests/support/lower_envelope.hpp"

#include <CGAL/Cartesian.h>
#include <CGAL/Env_surface_data_traits_3.h>
#include <CGAL/Env_triangle_traits_3.h>
#include <CGAL/Gmpq.h>
#include <CGAL/envelope_3.h>

#include <list>

namespace provis::test {

namespace {

using Kernel = CGAL::Cartesian<CGAL::Gmpq>;
using TriangleTraits = CGAL::Env_triangle_traits_3<Kernel>;
using Traits = CGAL::Env_surface_data_traits_3<TriangleTraits, unsigned>;

Kernel::Point_3 point(const std::array<mpq_class, 3>& p) {
  const auto number = [](const mpq_class& v) { return CGAL::Gmpq(v.get_mpq_t()); };
  return Kernel::Point_3(number(p[0]), number(p[1]), number(p[2]));
}

}  // namespace

std::set<unsigned> lowest(const std::vector<EnvelopeTriangle>& surfaces) {
  std::list<Traits::Xy_monotone_surface_3> input;
  for (const EnvelopeTriangle& s : surfaces) {
    const TriangleTraits::Surface_3 triangle(point(s.corners[0]), point(s.corners[1]), point(s.corners[2]));
    input.emplace_back(triangle, s.id);
  }
  CGAL::Envelope_diagram_2<Traits> diagram;
  CGAL::lower_envelope_3(input.begin(), input.end(), diagram);
  std::set<unsigned> ids;
  for (auto face = diagram.faces_begin(); face != diagram.faces_end(); ++face) {
    for (auto s = face->surfaces_begin(); s != face->surfaces_end(); ++s) ids.insert(s->data());
  }
  return ids;
}

}  // namespace provis::test
