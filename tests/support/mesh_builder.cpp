#include "tests/support/mesh_builder.hpp"

#include <algorithm>

namespace provis::test {

std::uint32_t MeshBuilder::vertex(const Vec3d& p) {
  std::vector<Vec3d>& all = arrays_.vertices;
  const auto known = share_ ? std::find(all.begin(), all.end(), p) : all.end();
  const auto index = static_cast<std::uint32_t>(known - all.begin());
  if (known == all.end()) all.push_back(p);
  return index;
}

void MeshBuilder::triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const std::uint32_t i = vertex(a), j = vertex(b), k = vertex(c);
  arrays_.triangles.push_back({i, j, k});
  arrays_.triangle_flags.push_back(0);
}

void MeshBuilder::quad(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  if (random_.chance(50)) {
    triangle(a, b, c);
    triangle(a, c, d);
  } else {
    triangle(b, c, d);
    triangle(b, d, a);
  }
}

void MeshBuilder::box(const Vec3d& lo, const Vec3d& hi, unsigned faces) {
  const Vec3d x{hi.x - lo.x, 0, 0}, y{0, hi.y - lo.y, 0}, z{0, 0, hi.z - lo.z};
  if (faces & 1u) parallelogram(lo, z, y);
  if (faces & 2u) parallelogram(lo + x, y, z);
  if (faces & 4u) parallelogram(lo, x, z);
  if (faces & 8u) parallelogram(lo + y, z, x);
  if (faces & 16u) parallelogram(lo, y, x);
  if (faces & 32u) parallelogram(lo + z, x, y);
}

}  // namespace provis::test
