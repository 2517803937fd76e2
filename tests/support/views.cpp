#include "tests/support/views.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/support/knobs.hpp"

namespace provis::test {

namespace {

/// A triangle's corner a and its edges from there; coordinates are small multiples of powers of two before
/// nudges, so that points a + s u + t v lie in its plane exactly.
struct Patch {
  Vec3d a, u, v;
};

Patch any_patch(const Case& c, Random& random) {
  const Triangle& t = random.pick_from(c.arrays.triangles);
  const Vec3d& a = c.arrays.vertices[t[0]];
  return {a, c.arrays.vertices[t[1]] - a, c.arrays.vertices[t[2]] - a};
}

Vec3d choose_eye(Case& c, Random& random) {
  const Patch at = any_patch(c, random);
  switch (random.between(0, 11)) {
    case 0:
      c.name += " eye at vertex";
      return at.a;
    case 1:
      c.name += " eye on edge";
      return at.a + 0.5 * at.u;
    case 2:
      c.name += " eye on triangle";
      return at.a + 0.25 * at.u + 0.25 * at.v;
    case 3: {
      c.name += " eye in plane";
      const double s = random.between(-2, 2), t = random.between(-2, 2);
      return at.a + s * at.u + t * at.v;
    }
    case 4:
      c.name += " eye inside";
      return 0.5 * random.lattice(1);
    case 5:
    case 6:
    case 7:
      c.name += " eye at origin";
      return {0, 0, 0};
    case 8: {
      c.name += " eye by triangle";
      Vec3d eye = at.a + 0.25 * at.u + 0.5 * at.v;
      nudge(eye, random);
      return eye;
    }
    default: {
      c.name += " eye outside";
      Vec3d eye = random.lattice(3);
      eye.z = random.between(2, 6);
      return eye;
    }
  }
}

bool independent(const Frame& f) { return dot(cross(f.right, f.up), f.forward) != 0; }

/// A direction of small integers; half of the time it leads to a vertex of the scene.
Vec3d choose_direction(const Case& c, Random& random) {
  Vec3d d = random.lattice(3);
  if (random.chance(50)) {
    const Vec3d to = random.pick_from(c.arrays.vertices) - c.view.eye;
    d = {std::rint(to.x), std::rint(to.y), std::rint(to.z)};
  }
  return d == Vec3d{} ? Vec3d{0, 0, -1} : d;
}

/// Orthonormal and axis-aligned, of either handedness.
Frame axis_frame(Random& random) {
  std::array<Vec3d, 3> axes{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, -1}};
  if (random.chance(40)) random.shuffle(axes);
  for (Vec3d& axis : axes) {
    if (random.chance(15)) axis = -axis;
  }
  return {axes[0], axes[1], axes[2], {}};
}

Frame skew_frame(const Case& c, Random& random) {
  Frame f;
  do {
    f.forward = choose_direction(c, random);
    f.right = random.lattice(2);
    f.up = random.lattice(2);
  } while (!independent(f));
  return f;
}

/// Window coordinates of a point, rounded; nothing certain is needed of them.
std::array<double, 2> project(const Case& c, const Frame& f, const Vec3d& p) {
  const Vec3d d = p - c.view.eye;
  const double det = dot(cross(f.right, f.up), f.forward);
  const double x = dot(cross(d, f.up), f.forward) / det, y = dot(cross(f.right, d), f.forward) / det;
  const double depth = c.view.projection == Projection::parallel ? 1 : dot(cross(f.right, f.up), d) / det;
  return {x / depth, y / depth};
}

/// A window whose borders pass through the pictures of two vertices.
Window window_on_vertices(const Case& c, const Frame& f, Random& random) {
  const auto p = project(c, f, random.pick_from(c.arrays.vertices));
  const auto q = project(c, f, random.pick_from(c.arrays.vertices));
  Window w{std::min(p[0], q[0]), std::max(p[0], q[0]), std::min(p[1], q[1]), std::max(p[1], q[1])};
  // Without extent, or with a vertex in or behind the eye's plane, the borders are let go.
  if (!(w.x0 < w.x1 && std::isfinite(w.x0) && std::isfinite(w.x1))) w.x0 = -1, w.x1 = 1;
  if (!(w.y0 < w.y1 && std::isfinite(w.y0) && std::isfinite(w.y1))) w.y0 = -1, w.y1 = 1;
  return w;
}

Window tiny_window(const Case& c, const Frame& f, Random& random) {
  const auto p = project(c, f, random.pick_from(c.arrays.vertices));
  const double size = random.pick({0x1p-4, 0x1p-10, 0x1p-30});
  const double x = std::isfinite(p[0]) ? p[0] : 0, y = std::isfinite(p[1]) ? p[1] : 0;
  Window w{x - size, x + size, y - size, y + size};
  if (!(w.x0 < w.x1 && w.y0 < w.y1)) return {};
  return w;
}

Window choose_window(Case& c, const Frame& f, Random& random) {
  const bool parallel = c.view.projection == Projection::parallel;
  switch (random.between(0, 9)) {
    case 0:
      c.name += " window on vertices";
      return window_on_vertices(c, f, random);
    case 1:
      c.name += " tiny window";
      return tiny_window(c, f, random);
    case 2: {
      c.name += " off-centre";
      const double x = random.between(-2, 1), y = random.between(-2, 1);
      return {x, x + 1, y, y + 1.5};
    }
    case 3:
      c.name += " wide";
      return {-16, 16, -8, 8};
    case 4:
      return {-0.5, 0.5, -0.5, 0.5};
    case 5:
    case 6:
      return {-2, 2, -2, 2};
    default:
      return parallel ? Window{-4, 4, -4, 4} : Window{-1, 1, -1, 1};
  }
}

/// The window's plane stays before the scene, cuts through it or touches one of its vertices.
Vec3d choose_parallel_origin(const Case& c, const Vec3d& forward, Random& random) {
  const Vec3d& v = random.pick_from(c.arrays.vertices);
  switch (random.between(0, 2)) {
    case 0:
      return v;
    case 1:
      return 0.5 * random.lattice(2);
    default:
      return -8.0 * forward;
  }
}

/// Turns a view that looks away from the scene's middle around, mostly.
void face_scene(const Case& c, Frame& f, Random& random) {
  Vec3d middle;
  for (const Vec3d& v : c.arrays.vertices) middle = middle + v;
  const double count = static_cast<double>(c.arrays.vertices.size());
  const Vec3d ahead = (1 / count) * middle - c.view.eye;
  if (dot(ahead, f.forward) < 0 && random.chance(85)) f.forward = -f.forward;
}

void look_everywhere(Case& c) {
  c.view.projection = Projection::omni;
  const Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const Window w;
  c.view.frames = {{-z, y, x, w}, {z, y, -x, w}, {x, -z, y, w}, {x, z, -y, w}, {x, y, z, w}, {-x, y, -z, w}};
}

}  // namespace

void choose_view(Case& c, Random& random) {
  c.view.projection = random.pick({Projection::pinhole, Projection::pinhole, Projection::pinhole,
                                   Projection::pinhole, Projection::parallel, Projection::omni});
  c.view.eye = choose_eye(c, random);
  if (c.view.projection == Projection::omni) {
    c.name += " omni";
    look_everywhere(c);
    return;
  }
  const bool aligned = random.chance(60);
  const bool parallel = c.view.projection == Projection::parallel;
  Frame f = aligned ? axis_frame(random) : skew_frame(c, random);
  if (parallel) c.view.eye = choose_parallel_origin(c, f.forward, random);
  face_scene(c, f, random);
  c.name += parallel ? " parallel" : " pinhole";
  c.name += aligned ? "" : " skew";
  f.window = choose_window(c, f, random);
  c.view.frames = {f};
}

}  // namespace provis::test
