// Three triangles before an eye at the origin: one in front, one right behind it, one beside them.

#include <cstdio>
#include <provis/point.hpp>

int main() {
  provis::SceneArrays arrays;
  arrays.vertices = {{-1, -1, -2}, {1, -1, -2}, {0, 1, -2},   // in front
                     {-1, -1, -3}, {1, -1, -3}, {0, 1, -3},   // smaller to the eye, and behind it
                     {2, -1, -3},  {3, -1, -3}, {2, 1, -3}};  // beside both
  arrays.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  arrays.triangle_flags.assign(arrays.triangles.size(), 0);
  const provis::Scene scene(std::move(arrays));

  const provis::VisibleSet set = provis::visible_from_point(scene, provis::omni({0, 0, 0}));

  for (const provis::PrimitiveId id : set.with(provis::Status::visible)) std::printf("%u\n", id);
  const std::vector<provis::PrimitiveId> expected{0, 2};
  const bool right =
      set.guarantee == provis::Guarantee::exact && set.with(provis::Status::visible) == expected;
  if (!right) std::fprintf(stderr, "expected exactly the triangles 0 and 2\n");
  return right ? 0 : 1;
}
