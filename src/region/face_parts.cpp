#include "src/region/face_parts.hpp"

#include <algorithm>
#include <array>

#include "predicates/certain_sign.hpp"
#include "predicates/environment.hpp"
#include "predicates/formulas.hpp"

namespace provis {
namespace {

using offset::Face;

enum class Overlap { none, some, all };

/// A triangle in the plane of a face, by the two coordinates that differ there.
class FlatTriangle {
 public:
  FlatTriangle(const Scene& scene, std::size_t t, int axis)
      : p_{scene.corner(t, 0), scene.corner(t, 1), scene.corner(t, 2)},
        i_((axis + 1) % 3),
        j_((axis + 2) % 3),
        orientation_(turn(p_[0], p_[1], p_[2])) {}

  bool has_area() const { return orientation_ != Sign::zero; }

  /// How much of a rectangle in the same plane it covers. Two convex sets without common inner points are
  /// separated by an edge of one of them.
  Overlap with(const Face& face) const {
    for (const int axis : {i_, j_}) {
      const auto [lo, hi] =
          std::minmax({component(p_[0], axis), component(p_[1], axis), component(p_[2], axis)});
      if (hi <= component(face.corners[0], axis) || lo >= component(face.corners[2], axis))
        return Overlap::none;
    }
    bool all = true;
    for (std::size_t k = 0; k < 3; ++k) {
      bool some = false;
      for (const Vec3d& c : face.corners) {
        const Sign s = turn(p_[k], p_[(k + 1) % 3], c);
        some = some || s == orientation_;
        all = all && (s == orientation_ || s == Sign::zero);
      }
      if (!some) return Overlap::none;
    }
    return all ? Overlap::all : Overlap::some;
  }

 private:
  Sign turn(const Vec3d& a, const Vec3d& b, const Vec3d& c) const {
    return certain_sign([&]<class N>() {
      const N x(component(a, i_)), y(component(a, j_));
      return (N(component(b, i_)) - x) * (N(component(c, j_)) - y) -
             (N(component(b, j_)) - y) * (N(component(c, i_)) - x);
    });
  }

  std::array<Vec3d, 3> p_;
  int i_, j_;
  Sign orientation_;
};

std::vector<FlatTriangle> occluders_in(const Scene& scene, const Face& face) {
  std::vector<FlatTriangle> flat;
  for (std::size_t t = 0; t < scene.triangles().size(); ++t) {
    if (scene.triangle_flags()[t] & see_through) continue;
    const auto in_plane = [&](int k) { return component(scene.corner(t, k), face.axis) == face.height; };
    if (!in_plane(0) || !in_plane(1) || !in_plane(2)) continue;
    const FlatTriangle f(scene, t, face.axis);
    if (f.has_area() && f.with(face) != Overlap::none) flat.push_back(f);
  }
  return flat;
}

void collect(const Face& face, const std::vector<FlatTriangle>& occluders, int halvings,
             std::vector<Face>& parts) {
  std::vector<FlatTriangle> here;
  for (const FlatTriangle& f : occluders) {
    const Overlap overlap = f.with(face);
    if (overlap == Overlap::all) return;
    if (overlap == Overlap::some) here.push_back(f);
  }
  if (here.empty()) {
    parts.push_back(face);
    return;
  }
  if (halvings == 0) return;
  const Vec3d size = face.corners[2] - face.corners[0];
  const int edge = component(size, (face.axis + 1) % 3) >= component(size, (face.axis + 2) % 3) ? 0 : 1;
  for (const bool upper : {false, true}) {
    const Face half = face.half(edge, upper);
    if (half.corners == face.corners) return;
    collect(half, here, halvings - 1, parts);
  }
}

}  // namespace

bool has_area(const Face& f) {
  const int i = (f.axis + 1) % 3, j = (f.axis + 2) % 3;
  return component(f.corners[0], i) < component(f.corners[2], i) &&
         component(f.corners[0], j) < component(f.corners[2], j);
}

std::vector<Face> free_parts(const Scene& scene, const Face& face, int halvings) {
  const RoundUp guard;
  std::vector<Face> parts;
  collect(face, occluders_in(scene, face), halvings, parts);
  return parts;
}

}  // namespace provis
