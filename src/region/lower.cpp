#include "src/region/lower.hpp"

#include <algorithm>

#include "provis/error.hpp"
#include "provis/segment.hpp"
#include "src/region/cell_paths.hpp"
#include "src/region/dyadic_point.hpp"
#include "src/region/face_parts.hpp"
#include "src/region/random_rays.hpp"
#include "src/region/samples.hpp"
#include "src/scene/on_occluder.hpp"
#include "src/scene/parallel.hpp"

namespace provis {

using offset::Face;

PointView view_from(const ViewCell& cell, const Vec3d& eye) {
  if (!cell.window) return omni(eye);
  return {eye, Projection::pinhole, {*cell.window}};
}

std::uint64_t LowerSet::keep(const VisibleSet& set, bool check_origins) {
  std::uint64_t fresh = 0;
  for (const Witness& w : set.witnesses) {
    if (holds(w.primitive) || (check_origins && on_occluder(scene_, w.origin))) continue;
    witnesses_[w.primitive] = w;
    ++fresh;
  }
  return fresh;
}

std::uint64_t LowerSet::look_from(const std::vector<Vec3d>& viewpoints, ProgressMeter& meter) {
  std::uint64_t fresh = 0;
  for (const Vec3d& v : viewpoints) {
    fresh += keep(queries_.ask(view_from(cell_, v), true), false);
    meter.add(1 / static_cast<double>(viewpoints.size()));
  }
  return fresh;
}

std::uint64_t LowerSet::look_along_paths(int pixels, std::uint64_t& paths, ProgressMeter& meter) {
  if (pixels == 0) return 0;
  SegmentOptions options;
  options.witnesses = true;
  std::uint64_t fresh = 0;
  const auto all = edges_and_diagonals(cell_);
  for (const auto& [from, to] : all) {
    const SegmentView view{from, to, view_from(cell_, from).frames, {pixels, pixels}};
    fresh += keep(visible_from_segment(scene_, view, options, queries_.context()).set, true);
    ++paths;
    meter.add(1 / static_cast<double>(all.size()));
  }
  return fresh;
}

std::uint64_t LowerSet::look_along(int directions, std::uint64_t& samples, ProgressMeter& meter) {
  if (directions == 0) return 0;
  constexpr int halvings = 4;
  std::uint64_t fresh = 0;
  const std::vector<Face> faces = offset::faces_of(cell_);
  for (const Face& face : faces) {
    meter.add(1 / static_cast<double>(faces.size()));
    if (!has_area(face)) continue;
    const std::vector<Face> parts = free_parts(scene_, face, halvings);
    for (const Vec3d& d : sample_directions(face, directions))
      for (const Face& part : parts) {
        ++samples;
        fresh += keep(queries_.ask(offset_sample_view(part, d), true), true);
      }
  }
  return fresh;
}

/// Spread over the half sphere, or over the window.
std::vector<Vec3d> LowerSet::sample_directions(const Face& face, int count) const {
  if (!cell_.window) return even_directions(face, count);
  std::vector<Vec3d> all;
  for (const offset::Raster& r : offset::rasters_of(cell_, face, {count, count}))
    for (const Vec3d& d : pixel_directions(face, r)) all.push_back(d);
  return all;
}

std::uint64_t LowerSet::aim_at(const std::vector<PrimitiveId>& ids, int rays, std::uint64_t seed,
                               ProgressMeter& meter) {
  if (ids.empty() || rays == 0) return 0;
  const Context& context = queries_.context();
  const RandomRays random(scene_, cell_);
  on_threads(context, [&] {
    parallel_for(ids.size(), [&](std::size_t k) {
      if (context.cancelled()) throw Error(Error::Code::cancelled, "cell", "interrupted");
      witnesses_[ids[k]] = random.aim_at(ids[k], rays, seed);
      meter.add(1 / static_cast<double>(ids.size()));
    });
  });
  return static_cast<std::uint64_t>(
      std::count_if(ids.begin(), ids.end(), [&](PrimitiveId id) { return holds(id); }));
}

void LowerSet::look_at_contacts(const std::vector<PrimitiveId>& ids) {
  if (ids.empty()) return;
  const Context& context = queries_.context();
  const RandomRays rays(scene_, cell_);
  on_threads(context, [&] {
    parallel_for(ids.size(), [&](std::size_t k) {
      if (context.cancelled()) throw Error(Error::Code::cancelled, "cell", "interrupted");
      witnesses_[ids[k]] = rays.from_close_by(ids[k]);
    });
  });
}

}  // namespace provis
