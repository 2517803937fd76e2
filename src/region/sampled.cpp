// What a regular grid of viewpoints sees: the usual stand-in for the truth, for comparison.

#include <algorithm>

#include "predicates/environment.hpp"
#include "provis/cell.hpp"
#include "provis/error.hpp"
#include "provis/segment.hpp"
#include "src/region/lower.hpp"
#include "src/scene/parallel.hpp"
#include "src/scene/require_triangles.hpp"
#include "src/scene/stopwatch.hpp"
#include "src/segment/viewpoint_sampling.hpp"

namespace provis {
namespace {

constexpr int most_per_axis = 100;

/// Coordinate k of n from lo to hi, both included; one alone lies in the middle.
double on_grid(double lo, double hi, std::size_t k, int n) {
  const double share = n == 1 ? 0.5 : static_cast<double>(k) / (n - 1);
  return std::clamp(lo * (1 - share) + hi * share, lo, hi);
}

}  // namespace

CellSet sampled_from_cell(const Scene& scene, const ViewCell& cell, int per_axis, const PixelGrid& pixels,
                          const Context& context) {
  check(cell);
  const std::vector<Frame> frames = view_from(cell, cell.lower).frames;
  check(SegmentView{cell.lower, cell.upper, frames, pixels});
  if (per_axis < 1 || per_axis > most_per_axis)
    throw Error(Error::Code::usage, "grid", "1 to 100 viewpoints along each axis");
  require_triangles(scene, "cell queries");
  check_environment();
  const Stopwatch stopwatch;
  const auto n = static_cast<std::size_t>(per_axis);
  const auto viewpoint = [&](std::size_t k) {
    return Vec3d{on_grid(cell.lower.x, cell.upper.x, k % n, per_axis),
                 on_grid(cell.lower.y, cell.upper.y, k / n % n, per_axis),
                 on_grid(cell.lower.z, cell.upper.z, k / (n * n), per_axis)};
  };
  CellSet result;
  result.set.status = sampled_from_viewpoints(scene, n * n * n, viewpoint, frames, pixels, "cell", context);
  result.set.answers = "R9";
  result.set.guarantee = Guarantee::sampled;
  result.bounds.viewpoints_used = n * n * n;
  result.bounds.viewpoints = result.set.with(Status::visible).size();
  result.bounds.hidden = scene.primitive_count() - result.bounds.viewpoints;
  result.set.stats.threads = thread_count(context);
  stopwatch.read(result.set.stats);
  return result;
}

}  // namespace provis
