#pragma once
// Puts scenes together from triangles, quadrilaterals and boxes.

#include <vector>

#include "provis/scene.hpp"
#include "tests/support/random.hpp"

namespace provis::test {

/// Collects triangles. Equal corners share one vertex or get their own, as told.
class MeshBuilder {
 public:
  MeshBuilder(Random& random, bool share_vertices) : random_(random), share_(share_vertices) {}

  void triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c);

  /// Two triangles along a diagonal chosen at random; corners in order, counter-clockwise from the front.
  void quad(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d);

  /// The parallelogram at `corner` with front side u x v.
  void parallelogram(const Vec3d& corner, const Vec3d& u, const Vec3d& v) {
    quad(corner, corner + u, corner + u + v, corner + v);
  }

  /// Six faces with fronts outside; some may be left out: bit k of `faces` keeps face -x, +x, -y, +y, -z, +z.
  void box(const Vec3d& lo, const Vec3d& hi, unsigned faces = 63);

  std::size_t size() const { return arrays_.triangles.size(); }
  const SceneArrays& arrays() const { return arrays_; }
  SceneArrays& arrays() { return arrays_; }
  Random& random() { return random_; }

 private:
  std::uint32_t vertex(const Vec3d& p);

  Random& random_;
  bool share_;
  SceneArrays arrays_;
};

}  // namespace provis::test
