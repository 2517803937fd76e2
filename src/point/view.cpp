#include "provis/view.hpp"

#include <cmath>
#include <numbers>

#include "predicates/view_geometry.hpp"
#include "provis/error.hpp"

namespace provis {
namespace {

bool finite(const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

[[noreturn]] void refuse(const char* place, const std::string& what) {
  throw Error(Error::Code::usage, place, what);
}

/// Scaled by its largest component first, so that the length neither over- nor underflows.
Vec3d normalised(const Vec3d& v) {
  const double size = std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z)));
  const Vec3d s{v.x / size, v.y / size, v.z / size};
  const double length = std::sqrt(dot(s, s));
  return {s.x / length, s.y / length, s.z / length};
}

bool zero(const Vec3d& v) { return v == Vec3d{0, 0, 0}; }

/// Rounded, on purpose: a camera that a renderer would call parallel to its up vector is treated as such.
bool nearly_parallel(const Vec3d& a, const Vec3d& b) {
  const Vec3d c = cross(normalised(a), normalised(b));
  return dot(c, c) < 0x1p-80;
}

}  // namespace

PointView look_at(const LookAt& camera) {
  if (!finite(camera.eye)) refuse("eye", "not finite");
  if (!finite(camera.direction) || zero(camera.direction)) refuse("direction", "zero or not finite");
  if (!finite(camera.up) || zero(camera.up)) refuse("up", "zero or not finite");
  if (!(camera.fovy_degrees > 0 && camera.fovy_degrees < 180)) refuse("fovy", "outside (0, 180) degrees");
  if (camera.width < 1 || camera.height < 1) refuse("size", "must be at least 1x1");

  Frame f;
  f.forward = normalised(camera.direction);
  Vec3d up = camera.up;
  if (nearly_parallel(f.forward, up)) up = {0, 0, -1};
  if (nearly_parallel(f.forward, up)) up = {0, 1, 0};
  f.right = normalised(cross(f.forward, normalised(up)));
  f.up = cross(f.right, f.forward);
  const double h = std::tan(camera.fovy_degrees * (std::numbers::pi / 360));
  const double w = static_cast<double>(camera.width) / camera.height * h;
  f.window = {-w, w, -h, h};
  return {camera.eye, Projection::pinhole, {f}};
}

PointView omni(const Vec3d& eye) {
  const Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const Window square{-1, 1, -1, 1};
  return {eye,
          Projection::omni,
          {{z, y, x, square},
           {-z, y, -x, square},
           {x, z, y, square},
           {x, -z, -y, square},
           {-x, y, z, square},
           {x, y, -z, square}}};
}

void check(const PointView& view) {
  if (!finite(view.eye)) refuse("eye", "not finite");
  const std::size_t wanted = view.projection == Projection::omni ? 6 : 1;
  if (view.frames.size() != wanted)
    refuse("view", std::to_string(view.frames.size()) + " frames where the projection needs " +
                       std::to_string(wanted));
  for (const Frame& f : view.frames) {
    if (!finite(f.right) || !finite(f.up) || !finite(f.forward)) refuse("view", "a vector is not finite");
    const Window& w = f.window;
    if (!std::isfinite(w.x0) || !std::isfinite(w.x1) || !std::isfinite(w.y0) || !std::isfinite(w.y1))
      refuse("window", "not finite");
    if (!(w.x0 < w.x1) || !(w.y0 < w.y1)) refuse("window", "needs x0 < x1 and y0 < y1");
    make_geometry(view.eye, f, view.projection == Projection::parallel);
  }
}

}  // namespace provis
