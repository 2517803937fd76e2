#include "src/segment/hiding.hpp"

#include <cmath>

namespace provis {

Hiding::Hiding(const PathProjection& projection, const PathGeometry& path, const Frustum& frustum,
               const PixelRect& area)
    : frustum_(frustum),
      viewpoint_at_zero_(dot(projection.row_z(), path.from)),
      viewpoint_slope_(dot(projection.row_z(), path.to - path.from)),
      determinant_(projection.determinant()),
      skew_(projection.skew()),
      margin_(projection.margin()),
      parts_per_time_(Frustum::parts / (frustum.time(Frustum::parts) - frustum.time(0))),
      pixels_(static_cast<std::size_t>(area.width) * static_cast<std::size_t>(area.height)),
      changed_(pixels_.size(), 0) {
  block_.fill(HUGE_VAL);
  for (Bounds& b : pixels_) b.fill(HUGE_VAL);
}

double Hiding::farthest(const Shown& s, double t) const {
  const double depth = s.depth(t) + s.depth_error;
  return viewpoint_at_zero_ + t * viewpoint_slope_ + determinant_ * (depth + std::fabs(depth) * skew_) +
         margin_;
}

double Hiding::nearest(const Shown& s, double t) const {
  const double depth = s.depth(t) - s.depth_error;
  return viewpoint_at_zero_ + t * viewpoint_slope_ + determinant_ * (depth - std::fabs(depth) * skew_) -
         margin_;
}

/// The part that holds a moment, or a neighbour of it.
int Hiding::part_of(double t) const {
  const double k = (t - frustum_.time(0)) * parts_per_time_;
  return k > 0 ? static_cast<int>(std::min(k, Frustum::parts - 1.0)) : 0;
}

bool Hiding::hides_at(std::size_t pixel, const Span& span) const {
  const double begin = span.begin.t - span.begin.error, end = span.end.t + span.end.error;
  PartRange parts{part_of(begin), part_of(end)};
  while (parts.first > 0 && frustum_.time(parts.first) >= begin) --parts.first;
  while (parts.last + 1 < Frustum::parts && frustum_.time(parts.last + 1) <= end) ++parts.last;
  const double first = nearest(span.shown, begin), last = nearest(span.shown, end);
  // Neither may be NaN: an unknown distance hides nothing.
  return first > -HUGE_VAL && last > -HUGE_VAL && beyond(pixels_[pixel], std::min(first, last), parts);
}

/// Fronts are linear in time, so the farthest hit of a piece in a part lies at one of its ends there.
void Hiding::bound(const Envelope& envelope, Bounds& bounds) const {
  bounds.fill(-HUGE_VAL);
  const std::vector<Piece>& pieces = envelope.pieces();
  int part = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const Event &begin = pieces[k].begin, &end = envelope.end_of(k);
    const Shown& s = pieces[k].front;
    // What the events' errors make of the ends is added to the interval, and so to both parts next to it.
    const double from = begin.t - begin.error, to = end.t + end.error;
    while (part > 0 && frustum_.time(part) >= from) --part;
    for (; part < Frustum::parts && frustum_.time(part) <= to; ++part) {
      const double low = std::max(frustum_.time(part), from), high = std::min(frustum_.time(part + 1), to);
      const auto p = static_cast<std::size_t>(part);
      if (low > high) continue;
      const double far = s.facet == no_facet ? HUGE_VAL : std::max(farthest(s, low), farthest(s, high));
      bounds[p] = std::max(bounds[p], far == far ? far : HUGE_VAL);
    }
    if (part >= Frustum::parts) part = Frustum::parts - 1;
  }
}

}  // namespace provis
