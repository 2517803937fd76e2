#include "src/segment/viewpoint_sampling.hpp"

#include <atomic>

#include "provis/error.hpp"
#include "src/scene/parallel.hpp"
#include "src/scene/progress_meter.hpp"
#include "src/segment/depth_buffer.hpp"

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

}  // namespace

std::vector<Status> sampled_from_viewpoints(const Scene& scene, std::size_t count,
                                            const std::function<Vec3d(std::size_t)>& viewpoint,
                                            const std::vector<Frame>& frames, const PixelGrid& pixels,
                                            const char* place, const Context& context) {
  const ClusterTree tree(scene);
  Found found(scene.triangles().size());
  ProgressMeter meter(context, static_cast<double>(count));
  on_threads(context, [&] {
    parallel_queue(count, [&](std::size_t k) {
      DepthBuffer buffer(pixels);
      const Vec3d eye = viewpoint(k);
      for (const Frame& frame : frames) {
        if (context.cancelled()) throw Error(Error::Code::cancelled, place, "interrupted");
        look(scene, tree, {eye, frame, pixels}, buffer, found);
      }
      meter.add(1);
    });
  });
  std::vector<Status> status(scene.primitive_count(), Status::hidden);
  for (std::size_t id = 0; id < found.size(); ++id)
    if (found[id] != 0) status[id] = Status::visible;
  return status;
}

}  // namespace provis
