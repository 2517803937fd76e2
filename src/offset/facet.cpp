#include "src/offset/facet.hpp"

#include <algorithm>

#include "predicates/certain_sign.hpp"
#include "predicates/plane_side.hpp"
#include "predicates/zero_area.hpp"

namespace provis::offset {
namespace {

/// On which sides of a triangle's plane the corners of a face lie.
struct Sides {
  bool front = false, back = false;
};

Sides sides(const Face& face, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  Sides s;
  for (const Vec3d& o : face.corners) {
    const Sign h = plane_side(a, b, c, o);
    s.front = s.front || h == Sign::positive;
    s.back = s.back || h == Sign::negative;
  }
  return s;
}

Facet make_facet(const Scene& scene, const Seams& seams, std::size_t t) {
  Facet f;
  f.id = static_cast<PrimitiveId>(t);
  for (std::size_t k = 0; k < 3; ++k) {
    f.p[k] = &scene.corner(t, static_cast<int>(k));
    f.v[k] = seams.vertex(scene.triangles()[t][k]);
  }
  return f;
}

}  // namespace

Facets facets_of(const Scene& scene, const Seams& seams, const Face& face) {
  Facets facets;
  for (std::size_t t = 0; t < scene.triangles().size(); ++t) {
    Facet f = make_facet(scene, seams, t);
    if (!(std::max({face.beyond(*f.p[0]), face.beyond(*f.p[1]), face.beyond(*f.p[2])}) > 0)) continue;
    if (zero_area(*f.p[0], *f.p[1], *f.p[2])) continue;
    const std::uint8_t flags = scene.triangle_flags()[t];
    const Sides seen = sides(face, *f.p[0], *f.p[1], *f.p[2]);
    if (!seen.front && (!seen.back || (flags & single_sided))) continue;
    f.faced = seen.front != seen.back;
    f.opaque = !(flags & see_through);
    f.occludes = f.faced && f.opaque;
    if (!f.faced && f.opaque) ++facets.facing_unknown;
    // A front runs counter-clockwise, which is the negative orientation (predicates/README.md).
    if (seen.front) {
      std::swap(f.p[1], f.p[2]);
      std::swap(f.v[1], f.v[2]);
      f.edge = {2, 1, 0};
    }
    facets.all.push_back(f);
  }
  return facets;
}

Sign beyond(const Facet& f, const Vec3d& p) { return plane_side(*f.p[0], *f.p[1], *f.p[2], p); }

std::optional<Sign> beyond(const Facet& f, const Point& p) {
  return sign_of(plane_height(*f.p[0], *f.p[1], *f.p[2], p));
}

Sign turn(const Vec3d& a, const Vec3d& b, const Vec3d& p, const Vec3d& o) {
  return certain_sign([&]<class N>() {
    const Vec3<N> eye = numbers<N>(o);
    return dot(cross(numbers<N>(a) - eye, numbers<N>(b) - eye), numbers<N>(p) - eye);
  });
}

Interval turn(const Vec3d& a, const Vec3d& b, const Point& p, const Point& o) {
  return dot(cross(numbers<Interval>(a) - o, numbers<Interval>(b) - o), p - o);
}

}  // namespace provis::offset
