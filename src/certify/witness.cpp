#include "provis/witness.hpp"

#include <fmt/format.h>

#include <atomic>

#include "predicates/environment.hpp"
#include "predicates/formulas.hpp"
#include "provis/error.hpp"
#include "src/certify/cell_rays.hpp"
#include "src/certify/exact_ray.hpp"
#include "src/certify/segment_rays.hpp"
#include "src/scene/parallel.hpp"

namespace provis {
namespace {

[[noreturn]] void reject(PrimitiveId id, const std::string& why) {
  throw Error(Error::Code::rejected, fmt::format("witness of primitive {}", id), why);
}

/// Whether the triangle shows this side to a ray whose sign of n·direction is given: the front looks
/// against the ray.
bool shows(const Scene& scene, std::size_t t, Sign along) {
  return !(scene.triangle_flags()[t] & single_sided) || along == Sign::negative;
}

/// Which rays belong to a view from a point.
class PointRays {
 public:
  explicit PointRays(const PointView& view) : view_(view) {
    for (const Frame& f : view.frames)
      frames_.push_back(make_geometry(view.eye, f, view.projection == Projection::parallel));
  }

  bool belongs(const ExactRay& ray) const;

 private:
  bool in_frame(const ExactRay& ray, std::size_t frame) const;

  const PointView& view_;
  std::vector<ViewGeometry> frames_;
};

/// What a ray has to show, whichever view it belongs to.
class WitnessChecker {
 public:
  explicit WitnessChecker(const Scene& scene) : scene_(scene), tree_(scene) {}

  void check(const ExactRay& ray, PrimitiveId target) const {
    check_hit(ray, target);
    check_free(ray, target);
  }

  /// Throws where the ray starts on an occluder.
  void check_start(const ExactRay& ray, PrimitiveId target) const;

 private:
  void check_hit(const ExactRay& ray, PrimitiveId target) const;
  void check_free(const ExactRay& ray, PrimitiveId target) const;
  bool blocks(const ExactRay& ray, std::size_t occluder, PrimitiveId target) const;

  const Scene& scene_;
  BoxTree tree_;
};

bool PointRays::belongs(const ExactRay& ray) const {
  for (std::size_t f = 0; f < frames_.size(); ++f)
    if (in_frame(ray, f)) return true;
  return false;
}

bool PointRays::in_frame(const ExactRay& ray, std::size_t frame) const {
  using N = ExactNumber;
  const ViewGeometry& g = frames_[frame];
  const Vec3<N> from_eye = ray.origin() - numbers<N>(g.eye);
  const auto zero = [](const Vec3<N>& v) { return sign_of(dot(v, v)) == Sign::zero; };
  if (g.at_infinity) {
    // The ray runs forward and starts on the plane of the window.
    const Vec3<N> forward = numbers<N>(g.forward);
    if (!zero(cross(ray.direction(), forward)) || sign_of(dot(ray.direction(), forward)) != Sign::positive)
      return false;
    if (sign_of(dot(window_plane<N>(g).normal, from_eye)) != Sign::zero) return false;
  } else if (!zero(from_eye)) {
    return false;
  }
  return passes_window(g, view_.frames[frame].window,
                       g.at_infinity ? sheared(g, from_eye, 1) : ray.direction());
}

void WitnessChecker::check_hit(const ExactRay& ray, PrimitiveId target) const {
  if (target >= scene_.triangles().size()) reject(target, "not a triangle of the scene");
  const Passage p = ray.passage(scene_.corner(target, 0), scene_.corner(target, 1), scene_.corner(target, 2));
  if (p.along == Sign::zero || p.reach != p.along)
    reject(target, "the ray does not reach the triangle's plane");
  for (const Sign s : p.passes)
    if (s != p.along) reject(target, "the ray misses the triangle's relative interior");
  if (!shows(scene_, target, p.along)) reject(target, "the ray meets the side that is not there");
}

void WitnessChecker::check_free(const ExactRay& ray, PrimitiveId target) const {
  tree_.any([&](const Box& box) { return ray.may_meet(box); },
            [&](std::uint32_t t) {
              if (t != target && blocks(ray, t, target))
                reject(target, fmt::format("triangle {} is in the way", t));
              return false;
            });
}

bool WitnessChecker::blocks(const ExactRay& ray, std::size_t occluder, PrimitiveId target) const {
  if (scene_.triangle_flags()[occluder] & see_through) return false;
  const Passage p =
      ray.passage(scene_.corner(occluder, 0), scene_.corner(occluder, 1), scene_.corner(occluder, 2));
  // A plane that holds the origin of a finite eye has reach zero and no hits (R6); at distance zero an eye
  // at infinity sees nothing either.
  if (p.along == Sign::zero || p.reach != p.along || !shows(scene_, occluder, p.along)) return false;
  for (const Sign s : p.passes)
    if (s == -p.along) return false;
  return ray.compare(scene_, occluder, target) != Sign::negative && !coplanar(scene_, occluder, target);
}

void WitnessChecker::check_start(const ExactRay& ray, PrimitiveId target) const {
  tree_.any([&](const Box& box) { return ray.may_meet(box); },
            [&](std::uint32_t t) {
              if (!(scene_.triangle_flags()[t] & see_through) &&
                  ray.starts_on(scene_.corner(t, 0), scene_.corner(t, 1), scene_.corner(t, 2)))
                reject(target, fmt::format("the viewpoint lies on triangle {}", t));
              return false;
            });
}

/// Checks each witness on threads; `exempt` holds visible primitives that need none.
template <class Check>
std::size_t verify(const Scene& scene, const VisibleSet& set, const std::vector<PrimitiveId>& exempt,
                   const Context& context, const Check& check) {
  check_environment();
  std::vector<std::uint8_t> has(scene.primitive_count(), 0);
  for (const PrimitiveId id : exempt)
    if (id < has.size()) has[id] = 1;
  for (const Witness& w : set.witnesses)
    if (w.primitive < has.size()) has[w.primitive] = 1;
  for (const PrimitiveId id : set.with(Status::visible))
    if (id >= has.size() || !has[id]) reject(id, "called visible without a witness");

  on_threads(context, [&] {
    parallel_for(set.witnesses.size(), [&](std::size_t k) {
      if (context.cancelled()) throw Error(Error::Code::cancelled, "witnesses", "interrupted");
      const RoundUp guard;
      check(set.witnesses[k]);
    });
  });
  return set.witnesses.size();
}

}  // namespace

std::size_t verify_witnesses(const Scene& scene, const PointView& view, const VisibleSet& set,
                             const Context& context) {
  check(view);
  const PointRays rays(view);
  const WitnessChecker checker(scene);
  return verify(scene, set, {}, context, [&](const Witness& w) {
    const ExactRay ray(w);
    if (!rays.belongs(ray)) reject(w.primitive, "the ray does not belong to the view");
    checker.check(ray, w.primitive);
  });
}

std::size_t verify_witnesses(const Scene& scene, const SegmentView& view, const SegmentSet& set,
                             const Context& context) {
  check(view);
  const WitnessChecker checker(scene);
  return verify(scene, set.set, set.boundary, context, [&](const Witness& w) {
    const ExactRay ray(w);
    if (!belongs(ray, view)) reject(w.primitive, "the ray does not belong to the view");
    if (!(view.from == view.to)) checker.check_start(ray, w.primitive);
    checker.check(ray, w.primitive);
  });
}

std::size_t verify_witnesses(const Scene& scene, const ViewCell& cell, const CellSet& result,
                             const Context& context) {
  check(cell);
  const WitnessChecker checker(scene);
  std::vector<PrimitiveId> exempt = result.unwitnessed;
  exempt.insert(exempt.end(), result.boundary.begin(), result.boundary.end());
  return verify(scene, result.set, exempt, context, [&](const Witness& w) {
    const ExactRay ray(w);
    if (!belongs(ray, cell)) reject(w.primitive, "the ray does not belong to the cell");
    if (!(cell.lower == cell.upper)) checker.check_start(ray, w.primitive);
    checker.check(ray, w.primitive);
  });
}

}  // namespace provis
