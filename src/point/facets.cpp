#include "src/point/facets.hpp"

#include <algorithm>

#include "src/point/guard.hpp"
#include "src/point/tile.hpp"
#include "src/point/weld.hpp"
#include "src/scene/parallel.hpp"

namespace provis {
namespace {

constexpr std::size_t chunk_size = 4096;

template <Arithmetic A>
using Hot = typename HotNumber<A>::type;

/// The sign side of a point that lies in no frame's image is never asked for: it bounds no cell.
template <Arithmetic A>
ImagePoint image_point(Signs<A>& signs, const Line& image, const Vec3d* position, std::uint32_t id) {
  ImagePoint p;
  p.direction.kind = DirectionKind::point;
  p.direction.point = position;
  p.direction.point_id = id;
  p.direction.approx = signs.shadow(p.direction);
  if (!signs.geometry().at_infinity) p.side = signs.side(image, p.direction);
  return p;
}

/// Certainly outside: all three corners beyond one border of the window.
template <Arithmetic A>
bool outside(Signs<A>& signs, const Tile& window, const Corners& corners) {
  Direction d[3];
  for (int k = 0; k < 3; ++k) {
    d[k].kind = DirectionKind::point;
    d[k].point = corners.p[k];
    d[k].approx = signs.shadow(d[k]);
  }
  return std::any_of(window.borders.begin(), window.borders.end(), [&](const Line& border) {
    return std::all_of(d, d + 3,
                       [&](const Direction& c) { return signs.quick_side(border, c) == Sign::negative; });
  });
}

/// Whether triangle t can have hits; if so, its corners in the order in which it is a positive cone.
template <Arithmetic A>
bool accept(Signs<A>& signs, const Scene& scene, const Tile& window, std::size_t t, Facet<Hot<A>>& f) {
  const Vec3d *a = &scene.corner(t, 0), *b = &scene.corner(t, 1), *c = &scene.corner(t, 2);
  if (outside(signs, window, {{a, b, c}})) return false;
  const Sign facing = signs.facing(*a, *b, *c);
  if (facing == Sign::zero) return false;
  const std::uint8_t flags = scene.triangle_flags()[t];
  if (facing == Sign::positive && (flags & single_sided)) return false;

  f.id = static_cast<PrimitiveId>(t);
  f.occludes = !(flags & see_through);
  f.corners = facing == Sign::positive ? Corners{{a, b, c}} : Corners{{a, c, b}};
  if (signs.geometry().at_infinity) {
    int before = 0, behind = 0;
    for (const Vec3d* p : f.corners.p) {
      const Sign s = signs.front(*p);
      before += s == Sign::positive;
      behind += s == Sign::negative;
    }
    if (before == 0) return false;
    f.cut = behind > 0;
  }
  return true;
}

template <Arithmetic A>
void complete(const Signs<A>& signs, Facet<Hot<A>>& f) {
  for (int k = 0; k < 3; ++k) {
    Line& e = f.edges[k];
    e.kind = LineKind::edge;
    e.first.p[0] = f.corners.p[k];
    e.first.p[1] = f.corners.p[(k + 1) % 3];
    e.points[0] = f.points[k];
    e.points[1] = f.points[(k + 1) % 3];
    e.approx = signs.shadow(e);
  }
  f.plane = triangle_plane<Hot<A>>(signs.geometry(), *f.corners.p[0], *f.corners.p[1], *f.corners.p[2]);
}

/// Runs body(signs, range) over [0, n) in fixed chunks, in parallel, and adds up the counts.
template <Arithmetic A, class Body>
void for_chunks(std::size_t n, const ViewGeometry& geometry, const Context& context, SignCounts& counts,
                const Body& body) {
  const std::size_t chunks = (n + chunk_size - 1) / chunk_size;
  std::vector<SignCounts> chunk_counts(chunks);
  parallel_for(chunks, [&](std::size_t chunk) {
    if (context.cancelled()) return;
    const RoundingGuard<A> guard;
    Signs<A> signs(geometry, chunk_counts[chunk]);
    body(signs, chunk, chunk * chunk_size, std::min(n, (chunk + 1) * chunk_size));
  });
  for (const SignCounts& c : chunk_counts) counts += c;
}

}  // namespace

template <Arithmetic A>
Facets<A> make_facets(const Scene& scene, const ViewGeometry& geometry, const Window& window,
                      const Context& context, SignCounts& counts) {
  const std::size_t n = scene.triangles().size();
  std::vector<std::vector<Facet<Hot<A>>>> accepted((n + chunk_size - 1) / chunk_size);
  for_chunks<A>(n, geometry, context, counts,
                [&](Signs<A>& signs, std::size_t chunk, std::size_t begin, std::size_t end) {
                  const Tile whole = make_tile(signs, window);
                  Facet<Hot<A>> f;
                  for (std::size_t t = begin; t < end; ++t)
                    if (accept(signs, scene, whole, t, f)) accepted[chunk].push_back(f);
                });

  Facets<A> result;
  for (auto& chunk : accepted) {
    result.facets.insert(result.facets.end(), chunk.begin(), chunk.end());
    chunk = {};
  }
  Weld weld(result.facets.size());
  for (Facet<Hot<A>>& f : result.facets)
    for (int k = 0; k < 3; ++k) f.points[k] = weld.id(f.corners.p[k]);

  result.points.resize(weld.positions().size());
  for_chunks<A>(result.points.size(), geometry, context, counts,
                [&](Signs<A>& signs, std::size_t, std::size_t begin, std::size_t end) {
                  const Line image = make_image_line(signs);
                  for (std::size_t p = begin; p < end; ++p)
                    result.points[p] =
                        image_point(signs, image, weld.positions()[p], static_cast<std::uint32_t>(p));
                });
  for_chunks<A>(result.facets.size(), geometry, context, counts,
                [&](Signs<A>& signs, std::size_t, std::size_t begin, std::size_t end) {
                  for (std::size_t f = begin; f < end; ++f) complete(signs, result.facets[f]);
                });
  return result;
}

template Facets<Arithmetic::doubles> make_facets(const Scene&, const ViewGeometry&, const Window&,
                                                 const Context&, SignCounts&);
template Facets<Arithmetic::chain> make_facets(const Scene&, const ViewGeometry&, const Window&,
                                               const Context&, SignCounts&);
template Facets<Arithmetic::mpfr> make_facets(const Scene&, const ViewGeometry&, const Window&,
                                              const Context&, SignCounts&);
template Facets<Arithmetic::exact> make_facets(const Scene&, const ViewGeometry&, const Window&,
                                               const Context&, SignCounts&);

}  // namespace provis
