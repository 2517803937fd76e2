// From-point sampling: what is seen at pixel centres from viewpoints along the path, one after another,
// united.

#include <atomic>

#include "predicates/environment.hpp"
#include "provis/error.hpp"
#include "provis/segment.hpp"
#include "src/scene/parallel.hpp"
#include "src/scene/progress_meter.hpp"
#include "src/scene/stopwatch.hpp"
#include "src/segment/depth_buffer.hpp"
#include "src/segment/frame_task.hpp"

namespace provis {
namespace {

using Found = std::vector<std::atomic<std::uint8_t>>;

/// visit(triangle, silhouette) for all triangles that may be in the picture.
template <class Wanted, class Visit>
void for_each(const Scene& scene, const ClusterTree& tree, const PixelView& view, const Wanted& wanted,
              const Visit& visit) {
  const auto look_at = [&](PrimitiveId t) {
    if (!wanted(t)) return;
    const bool single = (scene.triangle_flags()[t] & single_sided) != 0;
    const auto s = view.silhouette(scene.corner(t, 0), scene.corner(t, 1), scene.corner(t, 2), single);
    if (s) visit(t, *s);
  };
  const auto descend = [&](const auto& self, std::uint32_t level, std::uint32_t cluster) -> void {
    if (view.misses(tree.box(level, cluster))) return;
    if (level == 0) {
      tree.for_triangles(cluster, look_at);
      return;
    }
    for (const std::uint32_t child : {2 * cluster, 2 * cluster + 1})
      if (child < tree.size(level - 1)) self(self, level - 1, child);
  };
  if (tree.levels() > 0) descend(descend, tree.levels() - 1, 0);
}

/// Occluders first; then whatever is not behind them, but for what was found before.
void look(const Scene& scene, const ClusterTree& tree, const PixelView& view, DepthBuffer& buffer,
          Found& found) {
  buffer.clear();
  for_each(
      scene, tree, view, [&](PrimitiveId t) { return !(scene.triangle_flags()[t] & see_through); },
      [&](PrimitiveId, const Silhouette& s) { buffer.add(s); });
  buffer.finish();
  for_each(
      scene, tree, view, [&](PrimitiveId t) { return found[t].load(std::memory_order_relaxed) == 0; },
      [&](PrimitiveId t, const Silhouette& s) {
        if (buffer.shows(s)) found[t].store(1, std::memory_order_relaxed);
      });
}

void sample(const Scene& scene, const SegmentView& view, int viewpoints, const Context& context,
            SegmentSet& set) {
  const ClusterTree tree(scene);
  Found found(scene.triangles().size());
  ProgressMeter meter(context, viewpoints);
  parallel_queue(static_cast<std::size_t>(viewpoints), [&](std::size_t k) {
    const double t = (static_cast<double>(k) + 0.5) / viewpoints;
    DepthBuffer buffer(view.pixels);
    for (const Frame& frame : view.frames) {
      if (context.cancelled()) throw Error(Error::Code::cancelled, "segment", "interrupted");
      look(scene, tree, {view.from + t * (view.to - view.from), frame, view.pixels}, buffer, found);
    }
    meter.add(1);
  });
  set.set.status.assign(scene.primitive_count(), Status::hidden);
  for (std::size_t id = 0; id < found.size(); ++id)
    if (found[id] != 0) set.set.status[id] = Status::visible;
}

}  // namespace

SegmentSet sampled_along_segment(const Scene& scene, const SegmentView& view, int viewpoints,
                                 const Context& context) {
  check(view);
  if (viewpoints < 1) throw Error(Error::Code::usage, "viewpoints", "one or more");
  require_triangles(scene);
  check_environment();
  const Stopwatch stopwatch;
  SegmentSet set;
  on_threads(context, [&] { sample(scene, view, viewpoints, context, set); });
  set.boundary = set.set.with(Status::visible);
  set.set.answers = "R10";
  set.set.guarantee = Guarantee::sampled;
  set.set.stats.threads = thread_count(context);
  stopwatch.read(set.set.stats);
  return set;
}

}  // namespace provis
