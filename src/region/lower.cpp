#include "src/region/lower.hpp"

#include <algorithm>
#include <cmath>

#include "predicates/formulas.hpp"
#include "provis/error.hpp"
#include "src/region/dyadic_point.hpp"
#include "src/scene/on_occluder.hpp"

namespace provis {
namespace {

using offset::Face;

/// An occluder that lies in the face's plane and may overlap the rectangle: it blocks rays at their start
/// (R9), which the parallel view does not see.
bool lies_in(const Face& face, const Scene& scene, std::size_t t) {
  if (scene.triangle_flags()[t] & see_through) return false;
  for (int k = 0; k < 3; ++k)
    if (component(scene.corner(t, k), face.axis) != face.height) return false;
  for (int axis = 0; axis < 3; ++axis) {
    double lo = HUGE_VAL, hi = -HUGE_VAL;
    for (int k = 0; k < 3; ++k) {
      lo = std::min(lo, component(scene.corner(t, k), axis));
      hi = std::max(hi, component(scene.corner(t, k), axis));
    }
    if (hi < component(face.corners[0], axis) || lo > component(face.corners[2], axis)) return false;
  }
  return true;
}

bool is_blocked(const Face& face, const Scene& scene) {
  for (std::size_t t = 0; t < scene.triangles().size(); ++t)
    if (lies_in(face, scene, t)) return true;
  return false;
}

PointOptions with_witnesses() {
  PointOptions o;
  o.witnesses = true;
  return o;
}

}  // namespace

PointView offset_sample_view(const Face& face, double x, double y) {
  const int i = (face.axis + 1) % 3, j = (face.axis + 2) % 3;
  PointView v;
  v.projection = Projection::parallel;
  component(v.eye, face.axis) = face.height;
  Frame f{{},
          {},
          {},
          {component(face.corners[0], i), component(face.corners[2], i), component(face.corners[0], j),
           component(face.corners[2], j)}};
  component(f.right, i) = 1;
  component(f.up, j) = 1;
  component(f.forward, face.axis) = face.upper ? 1 : -1;
  component(f.forward, i) = x;
  component(f.forward, j) = y;
  v.frames = {f};
  return v;
}

bool has_area(const Face& f) {
  const int i = (f.axis + 1) % 3, j = (f.axis + 2) % 3;
  return component(f.corners[0], i) < component(f.corners[2], i) &&
         component(f.corners[0], j) < component(f.corners[2], j);
}

PointView view_from(const ViewCell& cell, const Vec3d& eye) {
  if (!cell.window) return omni(eye);
  return {eye, Projection::pinhole, {*cell.window}};
}

bool LowerSet::origin_is_free(const Witness& w) const {
  const DyadicPoint origin(w.origin);
  for (std::size_t t = 0; t < scene_.triangles().size(); ++t)
    if (!(scene_.triangle_flags()[t] & see_through) &&
        origin.lies_on(scene_.corner(t, 0), scene_.corner(t, 1), scene_.corner(t, 2)))
      return false;
  return true;
}

std::uint64_t LowerSet::keep(const VisibleSet& set, bool check_origins) {
  std::uint64_t fresh = 0;
  for (const Witness& w : set.witnesses) {
    if (holds(w.primitive) || (check_origins && !origin_is_free(w))) continue;
    witnesses_[w.primitive] = w;
    ++fresh;
  }
  return fresh;
}

std::uint64_t LowerSet::look_from(const std::vector<Vec3d>& viewpoints) {
  std::uint64_t fresh = 0;
  for (const Vec3d& v : viewpoints)
    fresh += keep(visible_from_point(scene_, view_from(cell_, v), with_witnesses(), context_), false);
  return fresh;
}

std::uint64_t LowerSet::look_along(int directions, std::uint64_t& samples) {
  if (cell_.window) return 0;
  std::uint64_t fresh = 0;
  for (const Face& face : offset::faces_of(cell_)) {
    if (!has_area(face) || is_blocked(face, scene_)) continue;
    for (int i = 0; i < directions; ++i)
      for (int j = 0; j < directions; ++j) {
        // Slopes whose angles are spread evenly over a half circle.
        const auto slope = [&](int k) {
          constexpr double pi = 3.141592653589793;
          return std::tan(pi * ((k + 0.5) / directions - 0.5));
        };
        ++samples;
        fresh += keep(visible_from_point(scene_, offset_sample_view(face, slope(i), slope(j)),
                                         with_witnesses(), context_),
                      true);
      }
  }
  return fresh;
}

bool LowerSet::look_at_contact(PrimitiveId id) {
  const Vec3d &a = scene_.corner(id, 0), &b = scene_.corner(id, 1), &c = scene_.corner(id, 2);
  const Vec3d n = cross(b - a, c - a);
  const double length = std::sqrt(dot(n, n)), size = std::sqrt(length);
  if (!(length > 0)) return false;
  const auto in_cell = [&](const Vec3d& p) {
    return p.x >= cell_.lower.x && p.x <= cell_.upper.x && p.y >= cell_.lower.y && p.y <= cell_.upper.y &&
           p.z >= cell_.lower.z && p.z <= cell_.upper.z;
  };
  constexpr int steps = 8;
  int attempts = 0;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; i + j < steps; ++j) {
      const Vec3d target = a + ((i + 0.31) / steps) * (b - a) + ((j + 0.37) / steps) * (c - a);
      if (!in_cell(target)) continue;
      for (const double side : {0x1p-8, -0x1p-8, 0x1p-20, -0x1p-20}) {
        const Vec3d eye = target + (side * size / length) * n;
        if (eye == target || !in_cell(eye) || on_occluder(scene_, eye)) continue;
        if (++attempts > 16) return false;
        PointView view = view_from(cell_, eye);
        if (!cell_.window) view = look_at({eye, target - eye, {0, 1, 0}, 1, 1, 1});
        keep(visible_from_point(scene_, view, with_witnesses(), context_), false);
        if (holds(id)) return true;
      }
    }
  return false;
}

}  // namespace provis
