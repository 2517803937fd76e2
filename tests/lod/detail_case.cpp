#include "tests/lod/detail_case.hpp"

#include "predicates/formulas.hpp"

namespace provis::test {
namespace {

std::vector<IdRange> range(const AddedIds& ids) {
  if (ids.count == 0) return {};
  return {{ids.first, ids.first + ids.count - 1}};
}

SolidBox grown(const SolidBox& box, double by) {
  const Vec3d d{by, by, by};
  return {box.lower - d, box.upper + d};
}

/// Far enough from each other, as a rule, to leave room for a cell.
Vec3d spread(Random& random) { return 2.0 * random.lattice(4); }

/// A box with cut faces: the occluder's large triangles lie on its small ones.
DetailSoup any_box(Random& random) {
  const Vec3d p = spread(random);
  Vec3d size{double(random.between(1, 3)), double(random.between(1, 3)), double(random.between(1, 3))};
  // Now and then a wall.
  if (random.chance(30)) size = random.pick({Vec3d{8, 8, 1}, Vec3d{1, 8, 8}, Vec3d{8, 1, 8}});
  const SolidBox box{p, p + size};
  DetailSoup s;
  s.full = box_solid(box, 1, random);
  s.occluders = box_solid(random.chance(60) ? box : grown(box, -0.25));
  s.shell = box_solid(random.chance(50) ? box : grown(box, random.pick({0.0, 0.125, 0.5})));
  return s;
}

DetailSoup any_ball(Random& random) {
  const Vec3d center = spread(random);
  const double radius = random.between(1, 2);
  DetailSoup s;
  s.full = random.chance(50) ? ball(center, radius, 1) : octahedron(center, radius);
  s.occluders = random.chance(50) ? s.full : scaled(octahedron(center, radius), center, 0.75);
  s.shell = random.chance(40) ? s.full : box_solid(around(s.full));
  if (random.chance(30)) s.shell = scaled(s.full, center, 1.25);
  return s;
}

/// A wall across the scene, with everything beyond it hidden from most cells before it.
DetailSoup long_wall(Random& random) {
  constexpr double reach = 24;
  const int axis = random.between(0, 2);
  SolidBox box{{-reach, -reach, -reach}, {reach, reach, reach}};
  component(box.lower, axis) = random.between(-3, 3);
  component(box.upper, axis) = component(box.lower, axis) + 1;
  return {box_solid(box, 1, random), box_solid(random.chance(50) ? box : grown(box, -0.25)), box_solid(box),
          random.pick<std::uint8_t>({0, single_sided})};
}

DetailSoup any_object(Random& random) {
  const auto one = [&] { return random.chance(60) ? any_box(random) : any_ball(random); };
  DetailSoup s = one();
  if (random.chance(30)) {
    const DetailSoup other = one();
    s.full = joined(std::move(s.full), other.full);
    s.occluders = joined(std::move(s.occluders), other.occluders);
    s.shell = joined(std::move(s.shell), other.shell);
  }
  s.flags = random.chance(50) ? single_sided : 0;
  if (random.chance(15)) s.occluders.clear();
  if (random.chance(10)) {
    s.flags |= see_through;
    s.occluders.clear();
  }
  // Two-sided, which way it is turned does not matter.
  if (!(s.flags & single_sided) && random.chance(20)) s.full = reversed(std::move(s.full));
  if (random.chance(20)) s.shell = reversed(std::move(s.shell));
  // An open part of the surface needs no neighbours where nothing hides.
  if (s.occluders.empty() && random.chance(50)) s.full.pop_back();
  return s;
}

}  // namespace

void add(DetailCase& c, const std::string& name, const DetailSoup& s) {
  const AddedIds full = add(c.full.arrays, s.full, s.flags),
                 occluders = add(c.occluders, s.occluders, single_sided), shell = add(c.shell, s.shell, 0);
  c.objects.push_back({name, range(full), range(occluders), range(shell)});
}

DetailCase detail_case(std::uint64_t seed) {
  Random random(seed);
  DetailCase c;
  c.full.name = "detail";
  c.full.seed = seed;
  for (int n = random.between(1, 5), k = 0; k < n; ++k)
    add(c, "object " + std::to_string(k), any_object(random));
  for (int n = random.between(0, 2); n > 0; --n) add(c, "wall " + std::to_string(n), long_wall(random));
  for (int n = random.between(0, 4); n > 0; --n)
    add(c.full.arrays, {Corners{spread(random), spread(random), spread(random)}},
        random.pick<std::uint8_t>({0, 0, single_sided, see_through}));
  c.full.view = omni(random.lattice(5));
  return c;
}

}  // namespace provis::test
