#include "tests/support/segment_cases.hpp"

#include <algorithm>
#include <cmath>

#include "fmt/format.h"
#include "tests/support/families.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/knobs.hpp"
#include "tests/support/random.hpp"
#include "tests/support/triangles.hpp"
#include "tests/support/views.hpp"

namespace provis::test {

namespace {

/// Corners of a triangle of the scene.
struct Corners {
  Vec3d a, b, c;
};

/// The scene under construction and where its random choices come from.
struct Draft {
  SegmentCase& made;
  Random& random;

  Case& start() { return made.start; }
  Vec3d& eye() { return made.start.view.eye; }
  Frame& frame() { return made.start.view.frames.front(); }
  void name(const char* what) { made.start.name += what; }

  Corners any_triangle() {
    const SceneArrays& arrays = made.start.arrays;
    const Triangle& t = random.pick_from(arrays.triangles);
    return {arrays.vertices[t[0]], arrays.vertices[t[1]], arrays.vertices[t[2]]};
  }

  /// A point of the triangle's plane; exact where the corners are small multiples of a power of two.
  Vec3d in_plane_of(const Corners& t) {
    const double u = random.between(-4, 8), v = random.between(-4, 8);
    return t.a + (u / 4) * (t.b - t.a) + (v / 4) * (t.c - t.a);
  }
};

void zero_length(Draft& d) {
  d.name(" | no length");
  d.made.to = d.eye();
}

void anywhere(Draft& d) {
  d.name(" | anywhere");
  d.made.to = d.eye() + d.random.pick({0.5, 1.0, 2.0}) * d.random.lattice(3);
}

void through_a_vertex(Draft& d) {
  d.name(" | through a vertex");
  d.made.to = d.eye() + d.random.pick({1.0, 2.0, 4.0}) * (d.any_triangle().a - d.eye());
}

void through_a_triangle(Draft& d) {
  d.name(" | through a triangle");
  const Corners t = d.any_triangle();
  const Vec3d inside = t.a + 0.5 * (t.b - t.a) + 0.25 * (t.c - t.a);
  d.made.to = d.eye() + d.random.pick({1.0, 2.0, 4.0}) * (inside - d.eye());
}

void in_a_plane(Draft& d) {
  d.name(" | in a plane");
  const Corners t = d.any_triangle();
  d.eye() = d.in_plane_of(t);
  d.made.to = d.in_plane_of(t);
}

void along_an_edge(Draft& d) {
  d.name(" | along an edge");
  const Corners t = d.any_triangle();
  const Vec3d edge = t.b - t.a;
  d.eye() = t.a + d.random.pick({-1.0, -0.5, 0.0, 0.5}) * edge;
  d.made.to = t.a + d.random.pick({0.25, 1.0, 2.0}) * edge;
}

/// The camera looks at a corner and moves along an edge of it: that edge is in a pixel's plane, if the corner
/// is at a pixel's centre.
void beside_an_edge(Draft& d) {
  d.name(" | beside an edge");
  const Corners t = d.any_triangle();
  d.frame().forward = t.a - d.eye();
  d.made.to = d.eye() + d.random.pick({-1.0, 0.5, 1.0}) * (t.b - t.a);
}

/// The camera moves along the line in which two planes cross, while it looks at a point of that line.
void beside_a_crossing(Draft& d) {
  d.name(" | beside a crossing");
  const auto normal = [](const Corners& t) { return cross(t.b - t.a, t.c - t.a); };
  const Corners s = d.any_triangle(), t = d.any_triangle();
  const Vec3d line = cross(normal(s), normal(t));
  const double size = std::max({std::abs(line.x), std::abs(line.y), std::abs(line.z), 1.0});
  d.frame().forward = d.random.chance(50) ? s.a - d.eye() : -d.eye();
  d.made.to = d.eye() + std::exp2(-std::floor(std::log2(size))) * line;
}

/// The camera moves along one of its own rays, so that the pixel's plane is but a line.
void along_a_ray(Draft& d) {
  d.name(" | along a ray");
  const Frame& f = d.frame();
  const Vec3d ray = d.random.chance(60) ? f.forward : f.forward + 0.5 * f.right - 0.5 * f.up;
  d.made.to = d.eye() + d.random.pick({-2.0, 0.5, 1.0, 4.0}) * ray;
}

void sideways(Draft& d) {
  d.name(" | sideways");
  const Frame& f = d.frame();
  d.made.to = d.eye() + d.random.pick({-2.0, 1.0, 4.0}) * (d.random.chance(50) ? f.right : f.up);
}

/// The camera passes the scene from one side to the other and back.
void across_the_scene(Draft& d) {
  d.name(" | across");
  Vec3d& from = d.eye();
  from = d.random.lattice(2);
  from.z = d.random.between(3, 5);
  d.made.to = d.random.chance(50) ? -from : Vec3d{-from.x, from.y, from.z};
}

void choose_segment(Draft& d) {
  using Choice = void (*)(Draft&);
  const Choice choice =
      d.random.pick<Choice>({zero_length, anywhere, anywhere, through_a_vertex, through_a_triangle,
                             in_a_plane, along_an_edge, beside_an_edge, beside_an_edge, beside_a_crossing,
                             along_a_ray, sideways, across_the_scene, across_the_scene});
  choice(d);
  if (d.random.chance(10)) {
    d.name(" nudged");
    nudge(d.made.to, d.random);
  }
}

/// Odd sizes have a pixel whose centre is the window's.
void choose_pixels(Draft& d) {
  PixelGrid& pixels = d.made.pixels;
  if (d.start().view.frames.size() > 1) {
    pixels = {d.random.between(1, 2), d.random.between(1, 2)};
  } else if (d.random.chance(40)) {
    pixels = {d.random.pick({1, 3, 5}), d.random.pick({1, 3})};
  } else {
    pixels = {d.random.between(1, 6), d.random.between(1, 5)};
  }
}

bool is_sound(const Frame& f) {
  return dot(cross(f.right, f.up), f.forward) != 0 && f.window.x0 < f.window.x1 && f.window.y0 < f.window.y1;
}

/// Pinholes only; a forward vector that no longer fits gets other companions.
void mend_frames(Draft& d) {
  PointView& view = d.start().view;
  if (view.projection == Projection::parallel) view.projection = Projection::pinhole;
  for (Frame& f : view.frames) {
    if (f.forward == Vec3d{}) f.forward = {0, 0, -1};
    while (!is_sound(f)) {
      f.right = d.random.lattice(2);
      f.up = d.random.lattice(2);
      f.window = {};
    }
  }
}

/// Two triangles, or three, that cross in a line which the middle pixel looks at all the time: they tie,
/// inside.
void add_ties(Draft& d) {
  d.name(" ties");
  Frame& f = d.frame();
  f.window = {};
  d.made.pixels = {d.random.pick({1, 3}), d.random.pick({1, 3})};
  SceneArrays& scene = d.start().arrays;
  const Vec3d at = d.eye() + d.random.pick({0.5, 1.0, 2.0}) * f.forward;
  const Vec3d way = d.made.to == d.eye() ? d.random.lattice(2) : d.made.to - d.eye();
  const int count = d.random.between(2, 3);
  for (int i = 0; i < count; ++i) {
    const Vec3d slant = d.random.lattice(2);
    add_triangle(scene, at - 4.0 * way - slant, at + 4.0 * way - slant, at + slant,
                 d.random.chance(25) ? see_through : 0);
  }
}

/// Changes scene, eye and the segment's end together.
template <class Change>
void move_all(SegmentCase& c, const Change& change) {
  std::vector<Vec3d>& vertices = c.start.arrays.vertices;
  vertices.push_back(c.to);
  change(c.start);
  c.to = vertices.back();
  vertices.pop_back();
}

/// Products of three over- or underflow here.
void scale_far(Draft& d) {
  const double factor = d.random.pick({1e-150, 1e150, 0x1p-500, 0x1p500});
  move_all(d.made, [&](Case& c) {
    for (Vec3d& v : c.arrays.vertices) v = factor * v;
    c.view.eye = factor * c.view.eye;
  });
  d.start().name += fmt::format(" times {}", factor);
}

}  // namespace

SegmentCase generate_segment(std::uint64_t seed) {
  SegmentCase made;
  Random random(seed ^ 0x5e67e470000u);  // other scenes than generate() has
  Draft d{made, random};
  made.start.seed = seed;
  build_scene(made.start, random);
  disturb_scene(made.start, random);
  choose_view(made.start, random);
  choose_segment(d);
  choose_pixels(d);
  mend_frames(d);
  if (random.chance(8)) add_ties(d);
  if (random.chance(8)) {
    scale_far(d);
  } else {
    move_all(made, [&](Case& c) { move_case(c, random); });
  }
  return made;
}

std::string describe(const SegmentCase& c) {
  return describe(c.start) + fmt::format("to {:a} {:a} {:a}\npixels {} {}\n", c.to.x, c.to.y, c.to.z,
                                         c.pixels.width, c.pixels.height);
}

}  // namespace provis::test
