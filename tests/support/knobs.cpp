#include "tests/support/knobs.hpp"

#include <cmath>
#include <utility>

namespace provis::test {

namespace {

double nudged(double value, Random& random) {
  switch (random.between(0, 3)) {
    case 0:
      return std::nextafter(value, HUGE_VAL);
    case 1:
      return std::nextafter(value, -HUGE_VAL);
    default:
      return value;
  }
}

void set_flags(Case& c, Random& random) {
  const int single = random.pick({0, 30, 100}), glass = random.pick({0, 0, 25});
  for (std::uint8_t& flags : c.arrays.triangle_flags) {
    flags = static_cast<std::uint8_t>((random.chance(single) ? single_sided : 0) |
                                      (random.chance(glass) ? see_through : 0));
  }
  if (single > 0) c.name += " single-sided";
  if (glass > 0) c.name += " see-through";
}

void turn_windings(Case& c, Random& random) {
  for (Triangle& t : c.arrays.triangles) {
    if (random.chance(50)) std::swap(t[0], t[1]);
  }
  c.name += " windings";
}

void nudge_vertices(Case& c, Random& random) {
  const int share = random.pick({10, 50});
  for (Vec3d& v : c.arrays.vertices) {
    if (random.chance(share)) nudge(v, random);
  }
  c.name += " nudged";
}

/// Triangles of zero area: a repeated index, equal corners, corners on a line.
void add_degenerate(Case& c, Random& random) {
  const auto any = [&] { return random.below(c.arrays.vertices.size()); };
  const std::uint32_t i = any(), j = any();
  const auto fresh = static_cast<std::uint32_t>(c.arrays.vertices.size());
  switch (random.between(0, 2)) {
    case 0:
      c.arrays.triangles.push_back({i, j, i});
      break;
    case 1:
      c.arrays.vertices.push_back(c.arrays.vertices[i]);
      c.arrays.triangles.push_back({i, j, fresh});
      break;
    default:
      c.arrays.vertices.push_back(c.arrays.vertices[j] + (c.arrays.vertices[j] - c.arrays.vertices[i]));
      c.arrays.triangles.push_back({i, j, fresh});
  }
  c.arrays.triangle_flags.push_back(0);
  c.name += " zero-area";
}

/// Copies of triangles that are there already, turned, so that every family has coincidences.
void add_copies(Case& c, Random& random) {
  const int copies = random.between(1, 3);
  for (int i = 0; i < copies; ++i) {
    Triangle t = random.pick_from(c.arrays.triangles);
    if (random.chance(50)) t = {t[1], t[2], t[0]};
    c.arrays.triangles.push_back(t);
    c.arrays.triangle_flags.push_back(0);
  }
  c.name += " copies";
}

template <class Change>
void for_each_position(Case& c, const Change& change) {
  for (Vec3d& v : c.arrays.vertices) change(v);
  change(c.view.eye);
}

void multiply(Case& c, double factor) {
  for_each_position(c, [&](Vec3d& v) { v = factor * v; });
  if (c.view.projection != Projection::parallel) return;
  for (Frame& frame : c.view.frames) {
    frame.right = factor * frame.right;
    frame.up = factor * frame.up;
  }
}

}  // namespace

void nudge(Vec3d& v, Random& random) {
  for (double* coordinate : {&v.x, &v.y, &v.z}) *coordinate = nudged(*coordinate, random);
}

void disturb_scene(Case& c, Random& random) {
  if (random.chance(20)) add_copies(c, random);
  if (random.chance(15)) add_degenerate(c, random);
  if (random.chance(25)) turn_windings(c, random);
  if (random.chance(50)) set_flags(c, random);
  if (random.chance(20)) nudge_vertices(c, random);
}

void move_case(Case& c, Random& random) {
  if (random.chance(20)) {
    const int exponent = random.between(-40, 40);
    multiply(c, std::ldexp(1.0, exponent));
    c.name += " scale 2^" + std::to_string(exponent);
  } else if (random.chance(20)) {
    const double factor = random.pick({1e-9, 1e-6, 1e-3, 0.1, 1.1, 1e3, 1e6, 1e9});
    multiply(c, factor);
    c.name += " scale " + std::to_string(factor);
  }
  if (random.chance(15)) {
    const double size = random.pick({0x1p10, 0x1p20, 1e6, 1e9});
    const Vec3d by = size * random.lattice(2);
    for_each_position(c, [&](Vec3d& v) { v = v + by; });
    c.name += " far";
  }
}

}  // namespace provis::test
