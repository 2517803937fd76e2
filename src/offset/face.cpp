#include "src/offset/face.hpp"

#include "predicates/certain_sign.hpp"
#include "predicates/environment.hpp"
#include "predicates/formulas.hpp"

namespace provis::offset {
namespace {

Vec3d unit(int axis, double length) {
  Vec3d v;
  component(v, axis) = length;
  return v;
}

/// Never decreasing; the first and the last are the ends themselves.
std::vector<double> borders(double from, double to, int count) {
  std::vector<double> b;
  const double step = (to - from) / count;
  for (int i = 0; i < count; ++i) b.push_back(std::min(from + i * step, to));
  b.push_back(to);
  return b;
}

Raster make_raster(const Frame& frame, int columns, int rows) {
  const Window& w = frame.window;
  return {frame, borders(w.x0, w.x1, columns), borders(w.y0, w.y1, rows)};
}

Face make_face(const ViewCell& cell, int axis, bool upper) {
  Face f{axis, upper, component(upper ? cell.upper : cell.lower, axis), {}};
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  for (std::size_t k = 0; k < 4; ++k) {
    component(f.corners[k], axis) = f.height;
    component(f.corners[k], i) = component(k == 1 || k == 2 ? cell.upper : cell.lower, i);
    component(f.corners[k], j) = component(k >= 2 ? cell.upper : cell.lower, j);
  }
  return f;
}

/// Whether some direction of the window leads beyond the face: then a corner's does.
bool leads_beyond(const Frame& f, const Face& face) {
  const RoundUp guard;
  for (const double x : {f.window.x0, f.window.x1})
    for (const double y : {f.window.y0, f.window.y1}) {
      const Sign s = certain_sign([&]<class N>() {
        return N(component(f.forward, face.axis)) + N(x) * N(component(f.right, face.axis)) +
               N(y) * N(component(f.up, face.axis));
      });
      if (s == (face.upper ? Sign::positive : Sign::negative)) return true;
    }
  return false;
}

}  // namespace

double Face::beyond(const Vec3d& p) const {
  return upper ? component(p, axis) - height : height - component(p, axis);
}

Face Face::half(int edge, bool upper_half) const {
  const int along = (axis + 1 + edge) % 3;
  const double lo = component(corners[0], along), hi = component(corners[2], along),
               middle = 0.5 * lo + 0.5 * hi;
  Face f = *this;
  if (!(lo < middle && middle < hi)) return f;
  for (Vec3d& c : f.corners)
    if (double& x = component(c, along); x == (upper_half ? lo : hi)) x = middle;
  return f;
}

std::vector<Face> faces_of(const ViewCell& cell) {
  for (int axis = 0; axis < 3; ++axis)
    if (component(cell.lower, axis) == component(cell.upper, axis))
      return {make_face(cell, axis, false), make_face(cell, axis, true)};
  std::vector<Face> faces;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) faces.push_back(make_face(cell, axis, upper));
  return faces;
}

std::vector<Raster> rasters_of(const ViewCell& cell, const Face& face, const PixelGrid& pixels) {
  if (cell.window) {
    if (!leads_beyond(*cell.window, face)) return {};
    return {make_raster(*cell.window, pixels.width, pixels.height)};
  }
  const Vec3d out = unit(face.axis, face.upper ? 1 : -1);
  const int i = (face.axis + 1) % 3, j = (face.axis + 2) % 3;
  std::vector<Raster> rasters{
      make_raster({unit(i, 1), unit(j, 1), out, {-1, 1, -1, 1}}, pixels.width, pixels.height)};
  // To the side a raster's half leads beyond the face: x is the share of the way out.
  for (const int side : {i, j})
    for (const double sign : {-1.0, 1.0})
      rasters.push_back(make_raster({out, unit(side == i ? j : i, 1), unit(side, sign), {0, 1, -1, 1}},
                                    (pixels.width + 1) / 2, pixels.height));
  return rasters;
}

}  // namespace provis::offset
