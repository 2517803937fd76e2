// Output-sensitive: clusters are visited front to back for each block of pixels, and what lies behind what is
// known to hide it, in every part of the path that it can be hit in, is not looked at.

#include <queue>

#include "src/segment/frustum.hpp"
#include "src/segment/hiding.hpp"
#include "src/segment/rows.hpp"

namespace provis {
namespace {

struct Entry {
  double nearest = 0;
  std::uint32_t level = 0, cluster = 0;
  PartRange parts;

  /// The queue hands out the nearest first; the rest of the order only has to be the same every time.
  friend bool operator<(const Entry& a, const Entry& b) {
    if (a.nearest != b.nearest) return a.nearest > b.nearest;
    return a.level != b.level ? a.level > b.level : a.cluster > b.cluster;
  }
};

/// What a block need not look at, of one triangle.
struct Filter {
  Hiding& hiding;
  double nearest;
  PartRange parts;

  bool hidden(std::size_t pixel) const { return hiding.hides_at(pixel, nearest, parts); }
  bool hidden(std::size_t pixel, const Span& span) const { return hiding.hides_at(pixel, span); }
  void changed(std::size_t pixel) { hiding.changed(pixel); }
};

/// One visit of the tree for one block.
template <Arithmetic A>
class Visit {
 public:
  Visit(const FrameTask& task, Block<A>& block, const PixelRect& area, const TimeRange& range)
      : task_(task),
        block_(block),
        area_(area),
        frustum_(task.projection, task.path, area, range),
        hiding_(task.projection, task.path, frustum_, area) {}

  void run() {
    const ClusterTree& tree = *task_.tree;
    if (tree.levels() == 0) return;
    enter(tree.levels() - 1, 0);
    while (!queue_.empty() && !block_.over_budget()) {
      const Entry e = queue_.top();
      queue_.pop();
      if (hiding_.hides(e.nearest, e.parts)) continue;
      if (e.level == 0) {
        tree.for_triangles(e.cluster, [&](PrimitiveId t) { look_at(t); });
        if (added_ >= next_refresh_) {
          hiding_.refresh(block_);
          next_refresh_ = added_ + std::max(least_between, added_ / 6);
        }
        continue;
      }
      for (const std::uint32_t child : {2 * e.cluster, 2 * e.cluster + 1})
        if (child < tree.size(e.level - 1)) enter(e.level - 1, child);
    }
  }

 private:
  /// Facets that are added before bounds are taken again: more of them once there are many.
  static constexpr int least_between = 16;

  void enter(std::uint32_t level, std::uint32_t cluster) {
    const ClusterBox& box = task_.tree->box(level, cluster);
    const PartRange parts = frustum_.touched(box);
    if (parts.empty()) return;
    const double nearest = frustum_.nearest(box);
    if (!hiding_.hides(nearest, parts)) queue_.push({nearest, level, cluster, parts});
  }

  void look_at(PrimitiveId t) {
    const Vec3d &a = task_.scene.corner(t, 0), &b = task_.scene.corner(t, 1), &c = task_.scene.corner(t, 2);
    const PartRange parts = frustum_.touched(a, b, c);
    if (parts.empty()) return;
    const double nearest = frustum_.nearest(a, b, c);
    if (hiding_.hides(nearest, parts)) return;
    const PixelRect pixels =
        task_.projection.pixels(a, b, c, {frustum_.time(parts.first), frustum_.time(parts.last + 1)}, area_);
    if (pixels.width == 0) return;
    Filter filter{hiding_, nearest, parts};
    block_.add(block_.facet(t), pixels, filter);
    ++added_;
  }

  const FrameTask& task_;
  Block<A>& block_;
  const PixelRect& area_;
  Frustum frustum_;
  Hiding hiding_;
  std::priority_queue<Entry> queue_;
  int added_ = 0, next_refresh_ = least_between;
};

}  // namespace

template <Arithmetic A>
void resolve_frame_fast(const FrameTask& task) {
  resolve_rows<A>(task, block_side, [&](Block<A>& block, const PixelRect& area, const TimeRange& range) {
    Visit<A>(task, block, area, range).run();
  });
}

template void resolve_frame_fast<Arithmetic::doubles>(const FrameTask&);
template void resolve_frame_fast<Arithmetic::chain>(const FrameTask&);
template void resolve_frame_fast<Arithmetic::mpfr>(const FrameTask&);
template void resolve_frame_fast<Arithmetic::exact>(const FrameTask&);

}  // namespace provis
