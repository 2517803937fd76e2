#include "src/region/samples.hpp"

#include <cmath>

#include "predicates/certain_sign.hpp"
#include "predicates/environment.hpp"
#include "predicates/formulas.hpp"

namespace provis {
namespace {

using offset::Face;
using offset::Raster;

/// Whether the closed window holds a direction of positive depth.
bool in_window(const Frame& f, const Vec3d& d) {
  const RoundUp guard;
  const auto det = [](const Vec3d& a, const Vec3d& b, const Vec3d& c, double times, const Vec3d& e,
                      const Vec3d& g, const Vec3d& h) {
    return certain_sign([&]<class N>() {
      return dot(cross(numbers<N>(a), numbers<N>(b)), numbers<N>(c)) -
             N(times) * dot(cross(numbers<N>(e), numbers<N>(g)), numbers<N>(h));
    });
  };
  const Sign handed = det(f.right, f.up, f.forward, 0, f.right, f.up, f.forward);
  const auto at_least = [&](Sign s, Sign wanted) { return s == Sign::zero || s == wanted; };
  // x = det[d, up, forward] / det[right, up, d], and y likewise.
  const Window& w = f.window;
  return at_least(det(d, f.up, f.forward, w.x0, f.right, f.up, d), handed) &&
         at_least(det(d, f.up, f.forward, w.x1, f.right, f.up, d), -handed) &&
         at_least(det(f.right, d, f.forward, w.y0, f.right, f.up, d), handed) &&
         at_least(det(f.right, d, f.forward, w.y1, f.right, f.up, d), -handed);
}

}  // namespace

PointView offset_sample_view(const Face& face, const Vec3d& direction) {
  const int i = (face.axis + 1) % 3, j = (face.axis + 2) % 3;
  PointView v;
  v.projection = Projection::parallel;
  component(v.eye, face.axis) = face.height;
  Frame f{{},
          {},
          direction,
          {component(face.corners[0], i), component(face.corners[2], i), component(face.corners[0], j),
           component(face.corners[2], j)}};
  component(f.right, i) = 1;
  component(f.up, j) = 1;
  v.frames = {f};
  return v;
}

std::vector<Vec3d> pixel_directions(const Face& face, const Raster& raster) {
  const Frame& f = raster.frame;
  const Window& w = f.window;
  const std::size_t columns = raster.columns.size() - 1, rows = raster.rows.size() - 1;
  std::vector<Vec3d> all;
  // Times twice the number of pixels each way: whole numbers in a hemicube.
  const auto across = 2 * static_cast<double>(columns), down = 2 * static_cast<double>(rows);
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column) {
      const double x = across * w.x0 + static_cast<double>(2 * column + 1) * (w.x1 - w.x0),
                   y = down * w.y0 + static_cast<double>(2 * row + 1) * (w.y1 - w.y0);
      const Vec3d d = (across * down) * f.forward + (down * x) * f.right + (across * y) * f.up;
      const double out = component(d, face.axis);
      if ((face.upper ? out > 0 : out < 0) && in_window(f, d)) all.push_back(d);
    }
  return all;
}

std::vector<Vec3d> even_directions(const Face& face, int count) {
  const auto slope = [&](int k) {
    constexpr double pi = 3.141592653589793;
    return std::tan(pi * ((k + 0.5) / count - 0.5));
  };
  std::vector<Vec3d> all;
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) {
      Vec3d d;
      component(d, face.axis) = face.upper ? 1 : -1;
      component(d, (face.axis + 1) % 3) = slope(i);
      component(d, (face.axis + 2) % 3) = slope(j);
      all.push_back(d);
    }
  return all;
}

}  // namespace provis
