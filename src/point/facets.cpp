#include "src/point/facets.hpp"

#include <algorithm>

#include "src/point/guard.hpp"
#include "src/point/weld.hpp"
#include "src/scene/parallel.hpp"

namespace provis {
namespace {

constexpr std::size_t chunk_size = 4096;

template <Arithmetic A>
class FacetMaker {
 public:
  FacetMaker(Signs<A>& signs, const Scene& scene, const Window& window)
      : signs_(signs), scene_(scene), window_(window), extent_(window), project_(signs.geometry()) {}

  /// Whether triangle t can have hits; if so, everything about it but the ids of its corners.
  bool make(std::size_t t, Facet& f);

 private:
  bool orient(std::size_t t, Facet& f);
  bool reaches_beyond_window(Facet& f);
  void place(Facet& f) const;

  Signs<A>& signs_;
  const Scene& scene_;
  Window window_;
  WindowExtent extent_;
  FrameProjection project_;
};

template <Arithmetic A>
bool FacetMaker<A>::make(std::size_t t, Facet& f) {
  if (!orient(t, f)) return false;
  if (signs_.geometry().at_infinity && !reaches_beyond_window(f)) return false;
  place(f);
  return overlap(f.box, window_) &&
         std::none_of(std::begin(f.inside), std::end(f.inside),
                      [&](const WindowFunction& e) { return e.highest(window_) < 0; });
}

template <Arithmetic A>
bool FacetMaker<A>::orient(std::size_t t, Facet& f) {
  const Vec3d *a = &scene_.corner(t, 0), *b = &scene_.corner(t, 1), *c = &scene_.corner(t, 2);
  const Sign facing = signs_.facing(*a, *b, *c);
  if (facing == Sign::zero) return false;
  const std::uint8_t flags = scene_.triangle_flags()[t];
  if (facing == Sign::positive && (flags & single_sided)) return false;
  f.id = static_cast<PrimitiveId>(t);
  f.occludes = !(flags & see_through);
  f.corners = facing == Sign::positive ? Corners{{a, b, c}} : Corners{{a, c, b}};
  return true;
}

template <Arithmetic A>
bool FacetMaker<A>::reaches_beyond_window(Facet& f) {
  int before = 0, behind = 0;
  for (const Vec3d* p : f.corners.p) {
    const Sign s = signs_.front(*p);
    before += s == Sign::positive;
    behind += s == Sign::negative;
  }
  f.cut = behind > 0;
  return before > 0;
}

template <Arithmetic A>
void FacetMaker<A>::place(Facet& f) const {
  const ViewGeometry& g = signs_.geometry();
  FramePoint p[3];
  f.box = {HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
  for (int k = 0; k < 3; ++k) {
    p[k] = project_(*f.corners.p[k]);
    const WindowPlace at = window_place(p[k]);
    // An infinite error makes the box infinite.
    const double x = at.error < HUGE_VAL ? at.x : 0, y = at.error < HUGE_VAL ? at.y : 0;
    f.box.x0 = std::min(f.box.x0, x - at.error);
    f.box.x1 = std::max(f.box.x1, x + at.error);
    f.box.y0 = std::min(f.box.y0, y - at.error);
    f.box.y1 = std::max(f.box.y1, y + at.error);
  }
  // Corners with at_eye > 0 run anticlockwise in the window of a frame of positive handedness.
  const bool anticlockwise = g.handedness == Sign::positive;
  for (int k = 0; k < 3; ++k) {
    const FramePoint &a = p[k], &b = p[(k + 1) % 3];
    f.inside[k] = anticlockwise ? edge_function(a, b, extent_) : edge_function(b, a, extent_);
  }
  f.depth =
      depth_function(g, triangle_plane<Ball>(g, *f.corners.p[0], *f.corners.p[1], *f.corners.p[2]), extent_);
}

void weld_corners(Facets& facets) {
  Weld weld(facets.facets.size());
  for (Facet& f : facets.facets)
    for (int k = 0; k < 3; ++k) f.points[k] = weld.id(f.corners.p[k]);
  facets.positions = weld.positions();
}

}  // namespace

template <Arithmetic A>
Facets make_facets(Signs<A>& signs, const Scene& scene, const Window& window,
                   std::span<const PrimitiveId> ids) {
  Facets result;
  FacetMaker<A> maker(signs, scene, window);
  Facet f;
  for (const PrimitiveId t : ids)
    if (maker.make(t, f)) result.facets.push_back(f);
  weld_corners(result);
  return result;
}

template <Arithmetic A>
Facets make_facets(const Scene& scene, const ViewGeometry& geometry, const Window& window,
                   const Context& context, SignCounts& counts) {
  const std::size_t n = scene.triangles().size(), chunks = (n + chunk_size - 1) / chunk_size;
  std::vector<std::vector<Facet>> made(chunks);
  std::vector<SignCounts> chunk_counts(chunks);
  parallel_for(chunks, [&](std::size_t chunk) {
    if (context.cancelled()) return;
    const RoundingGuard<A> guard;
    Signs<A> signs(geometry, chunk_counts[chunk]);
    FacetMaker<A> maker(signs, scene, window);
    Facet f;
    for (std::size_t t = chunk * chunk_size; t < std::min(n, (chunk + 1) * chunk_size); ++t)
      if (maker.make(t, f)) made[chunk].push_back(f);
  });
  Facets result;
  for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
    counts += chunk_counts[chunk];
    result.facets.insert(result.facets.end(), made[chunk].begin(), made[chunk].end());
    made[chunk] = {};
  }
  weld_corners(result);
  return result;
}

template Facets make_facets(Signs<Arithmetic::doubles>&, const Scene&, const Window&,
                            std::span<const PrimitiveId>);
template Facets make_facets(Signs<Arithmetic::chain>&, const Scene&, const Window&,
                            std::span<const PrimitiveId>);
template Facets make_facets(Signs<Arithmetic::mpfr>&, const Scene&, const Window&,
                            std::span<const PrimitiveId>);
template Facets make_facets(Signs<Arithmetic::exact>&, const Scene&, const Window&,
                            std::span<const PrimitiveId>);

template Facets make_facets<Arithmetic::doubles>(const Scene&, const ViewGeometry&, const Window&,
                                                 const Context&, SignCounts&);
template Facets make_facets<Arithmetic::chain>(const Scene&, const ViewGeometry&, const Window&,
                                               const Context&, SignCounts&);
template Facets make_facets<Arithmetic::mpfr>(const Scene&, const ViewGeometry&, const Window&,
                                              const Context&, SignCounts&);
template Facets make_facets<Arithmetic::exact>(const Scene&, const ViewGeometry&, const Window&,
                                               const Context&, SignCounts&);

}  // namespace provis
