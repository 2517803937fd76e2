// A program of its own: reads a case on standard input, computes with CGAL's lower_envelope_3 what is
// visible, and prints "answered" and the ids. It shares the reader of cases with the oracle, and no geometry.
// Cases of more than 2000 triangles, or of more than its argument says, are refused.

#include <algorithm>
#include <exception>
#include <iostream>
#include <set>
#include <string>
#include <vector>

#include "tests/support/case.hpp"
#include "tests/support/lower_envelope.hpp"

namespace provis::test {

namespace {

using Number = mpq_class;
using Vector = Vec3<Number>;

Vector exact(const Vec3d& v) { return {v.x, v.y, v.z}; }

Number determinant(const Vector& a, const Vector& b, const Vector& c) { return dot(cross(a, b), c); }

/// A convex polygon in coordinates (x, y, w) along a frame's right, up and forward vectors, seen from the
/// eye.
using Ring = std::vector<Vector>;

/// The part of a convex ring where the function is >= 0.
template <class Function>
Ring cut(const Ring& ring, const Function& f) {
  Ring part;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector &p = ring[i], &q = ring[(i + 1) % ring.size()];
    const Number at_p = f(p), at_q = f(q);
    if (at_p >= 0) part.push_back(p);
    if (at_p * at_q < 0) part.push_back(p + Number(at_p / (at_p - at_q)) * (q - p));
  }
  return part;
}

/// A frame of a view; maps space so that the eye's rays become vertical lines and nearer becomes lower.
class FrameMap {
 public:
  FrameMap(const PointView& view, const Frame& frame)
      : parallel_(view.projection == Projection::parallel),
        eye_(exact(view.eye)),
        right_(exact(frame.right)),
        up_(exact(frame.up)),
        forward_(exact(frame.forward)),
        window_(frame.window) {}

  /// What the window shows of triangle t, mapped and cut into triangles; nothing where it is edge-on or
  /// culled.
  std::vector<EnvelopeTriangle> surfaces(const SceneArrays& scene, PrimitiveId t) const;

 private:
  Vector along_frame(const Vector& d) const {
    const Number det = determinant(right_, up_, forward_);
    return {Number(determinant(d, up_, forward_) / det), Number(determinant(right_, d, forward_) / det),
            Number(determinant(right_, up_, d) / det)};
  }

  Ring cut_to_window(Ring ring) const;

  std::array<Number, 3> mapped(const Vector& p) const {
    if (parallel_) return {p.x, p.y, p.z};
    return {Number(p.x / p.z), Number(p.y / p.z), Number(-1 / p.z)};
  }

  bool parallel_;
  Vector eye_, right_, up_, forward_;
  Window window_;
};

std::vector<EnvelopeTriangle> FrameMap::surfaces(const SceneArrays& scene, PrimitiveId t) const {
  Vector at[3];
  for (std::size_t k = 0; k < 3; ++k) at[k] = exact(scene.vertices[scene.triangles[t][k]]) - eye_;
  const Number facing = dot(cross(at[1] - at[0], at[2] - at[0]), parallel_ ? forward_ : at[0]);
  const bool culled = (scene.triangle_flags[t] & single_sided) != 0 && facing > 0;
  if (facing == 0 || culled) return {};

  const Ring ring = cut_to_window({along_frame(at[0]), along_frame(at[1]), along_frame(at[2])});
  std::vector<EnvelopeTriangle> fan;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const std::array<Number, 3> a = mapped(ring[0]), b = mapped(ring[i]), c = mapped(ring[i + 1]);
    const Number area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (area != 0) fan.push_back({{a, b, c}, t});
  }
  return fan;
}

// A finite eye's window is a pyramid, which lies in w >= 0 and holds w = 0 at its apex only; the apex is the
// eye, which lies on no triangle that gets here. An eye at infinity has a box without end, from w = 0 on;
// what lies in w = 0 altogether is not ahead of the rays (R6).
Ring FrameMap::cut_to_window(Ring ring) const {
  const auto depth = [&](const Vector& p) { return parallel_ ? Number(1) : p.z; };
  ring = cut(ring, [&](const Vector& p) { return Number(p.x - window_.x0 * depth(p)); });
  ring = cut(ring, [&](const Vector& p) { return Number(window_.x1 * depth(p) - p.x); });
  ring = cut(ring, [&](const Vector& p) { return Number(p.y - window_.y0 * depth(p)); });
  ring = cut(ring, [&](const Vector& p) { return Number(window_.y1 * depth(p) - p.y); });
  if (!parallel_) return ring;
  ring = cut(ring, [](const Vector& p) { return p.z; });
  const bool ahead = std::any_of(ring.begin(), ring.end(), [](const Vector& p) { return p.z > 0; });
  return ahead ? ring : Ring{};
}

/// Adds what is visible through one frame. A see-through triangle is visible iff it shows up among the
/// occluders when it is added to them alone.
void look_through(const SceneArrays& scene, const FrameMap& map, std::set<unsigned>& visible) {
  std::vector<EnvelopeTriangle> occluders;
  std::vector<std::vector<EnvelopeTriangle>> see_through_ones;
  for (PrimitiveId t = 0; t < scene.triangles.size(); ++t) {
    const std::vector<EnvelopeTriangle> shown = map.surfaces(scene, t);
    if (shown.empty()) continue;
    if ((scene.triangle_flags[t] & see_through) != 0) {
      see_through_ones.push_back(shown);
    } else {
      occluders.insert(occluders.end(), shown.begin(), shown.end());
    }
  }
  visible.merge(lowest(occluders));
  for (const std::vector<EnvelopeTriangle>& one : see_through_ones) {
    std::vector<EnvelopeTriangle> with_it = occluders;
    with_it.insert(with_it.end(), one.begin(), one.end());
    if (lowest(with_it).count(one.front().id) != 0) visible.insert(one.front().id);
  }
}

void answer(std::istream& in, std::ostream& out, std::size_t most_triangles) {
  const Case c = read_text(in);
  if (!c.arrays.spheres.empty() || c.arrays.triangles.size() > most_triangles) {
    out << "refused spheres or more than " << most_triangles << " triangles\n";
    return;
  }
  std::set<unsigned> visible;
  for (const Frame& frame : c.view.frames) look_through(c.arrays, FrameMap(c.view, frame), visible);
  out << "answered";
  for (const unsigned id : visible) out << " " << id;
  out << " end\n";
}

}  // namespace

}  // namespace provis::test

int main(int argc, char** argv) try {
  provis::test::answer(std::cin, std::cout, argc > 1 ? std::stoul(argv[1]) : 2000);
  return 0;
} catch (const std::exception& e) {
  std::cerr << e.what() << "\n";
  return 3;
}
