#include "src/report/accuracy_score.hpp"

#include <algorithm>
#include <cmath>

#include "provis/error.hpp"
#include "src/report/raster.hpp"

namespace provis {

namespace {

/// A convex polygon of rays (x, y, w), seen at (x / w, y / w).
using Polygon = std::vector<Vec3d>;

/// The part where the functional is not negative.
Polygon clipped(const Polygon& polygon, const Vec3d& functional) {
  Polygon inside;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec3d &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double at_a = dot(functional, a), at_b = dot(functional, b);
    if (at_a >= 0) inside.push_back(a);
    if ((at_a < 0) != (at_b < 0)) inside.push_back(at_a / (at_a - at_b) * (b - a) + a);
  }
  return inside;
}

double area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec3d &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    twice += (a.x * b.y - a.y * b.x) / (a.z * b.z);
  }
  return std::isfinite(twice) ? std::abs(twice) / 2 : 0;
}

/// The image of the triangle within the window. Between the borders w is positive by itself.
double projected_area(const Scene& scene, PrimitiveId id, const PointView& view, const Frame& frame) {
  const Raster raster(view.eye, view.projection, frame, 1, 1);
  Polygon polygon;
  for (int k = 0; k < 3; ++k) polygon.push_back(raster.to_frame(scene.corner(id, k)));
  if (raster.parallel()) {
    polygon = clipped(polygon, {0, 0, 1});
    for (Vec3d& p : polygon) p.z = 1;
  }
  const Window& w = frame.window;
  for (const Vec3d& border : {Vec3d{1, 0, -w.x0}, {-1, 0, w.x1}, {0, 1, -w.y0}, {0, -1, w.y1}})
    polygon = clipped(polygon, border);
  return area(polygon);
}

}  // namespace

std::vector<ImagePart> parts_of(std::vector<SubdivisionCell>&& cells) {
  std::vector<ImagePart> parts;
  for (SubdivisionCell& cell : cells) parts.push_back({cell.area_rounded, std::move(cell.visible)});
  return parts;
}

std::vector<ImagePart> projected_parts(const Scene& scene, const PointView& view,
                                       const std::vector<Status>& exact) {
  std::vector<ImagePart> parts;
  for (PrimitiveId id = 0; id < scene.triangles().size(); ++id) {
    if (exact[id] != Status::visible) continue;
    ImagePart& part = parts.emplace_back();
    part.visible = {id};
    for (const Frame& frame : view.frames) part.area += projected_area(scene, id, view, frame);
  }
  return parts;
}

std::vector<ImagePart> seen_parts(const std::vector<Seen>& seen) {
  std::vector<ImagePart> parts;
  for (const Seen& s : seen) parts.push_back({s.length, {s.primitive}});
  return parts;
}

std::vector<Status> united(const std::vector<const std::vector<Status>*>& proofs) {
  std::vector<Status> known = *proofs.front();
  for (const std::vector<Status>* proof : proofs)
    for (std::size_t id = 0; id < known.size(); ++id) {
      if ((*proof)[id] == Status::undecided || (*proof)[id] == known[id]) continue;
      if (known[id] != Status::undecided)
        throw Error(Error::Code::internal, "primitive " + std::to_string(id),
                    "proven to be visible, and proven to be hidden");
      known[id] = (*proof)[id];
    }
  return known;
}

SetExcess excess(const std::vector<Status>& upper, const std::vector<Status>& known) {
  SetExcess e;
  std::size_t visible = 0;
  for (std::size_t id = 0; id < known.size(); ++id) {
    visible += known[id] == Status::visible;
    e.possible += upper[id] != Status::hidden;
    e.beyond += upper[id] != Status::hidden && known[id] != Status::visible;
  }
  if (visible > 0) e.share = static_cast<double>(e.beyond) / static_cast<double>(visible);
  return e;
}

SetScore score(const std::vector<Status>& set, const std::vector<Status>& exact,
               const std::vector<ImagePart>& parts) {
  SetScore score;
  std::size_t visible = 0;
  for (std::size_t id = 0; id < exact.size(); ++id) {
    const bool is = exact[id] == Status::visible, said = set[id] == Status::visible;
    visible += is;
    score.wrong_in += said && exact[id] == Status::hidden;
    score.wrong_out += is && !said;
  }
  if (visible > 0) score.set_missed = static_cast<double>(score.wrong_out) / static_cast<double>(visible);
  double all = 0, missed = 0;
  for (const ImagePart& part : parts) {
    all += part.area;
    const bool shown = std::all_of(part.visible.begin(), part.visible.end(),
                                   [&](PrimitiveId id) { return set[id] == Status::visible; });
    if (!shown) missed += part.area;
  }
  if (all > 0) score.area_missed = missed / all;
  return score;
}

}  // namespace provis
