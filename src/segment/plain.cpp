// The paper's algorithm: every triangle, the hull of its projections over the path, an interval at each pixel
// of that, composited into the pixel's list.

#include "src/segment/rows.hpp"

namespace provis {
namespace {

/// Triangles that may be hit in each row of blocks, with the pixels where.
struct Footprints {
  std::vector<PixelRect> rects;  ///< by triangle

  Footprints(const FrameTask& task) : rects(task.scene.triangles().size()) {
    const PixelRect all{0, 0, task.path.pixels.width, task.path.pixels.height};
    constexpr std::size_t chunk = 1024;
    parallel_for((rects.size() + chunk - 1) / chunk, [&](std::size_t c) {
      for (std::size_t t = c * chunk; t < std::min(rects.size(), (c + 1) * chunk); ++t)
        rects[t] = task.projection.pixels(task.scene.corner(t, 0), task.scene.corner(t, 1),
                                          task.scene.corner(t, 2), {0, 1}, all);
    });
  }
};

}  // namespace

template <Arithmetic A>
void resolve_frame_plain(const FrameTask& task) {
  const Footprints footprints(task);
  resolve_rows<A>(task, task.path.pixels.width,
                  [&](Block<A>& block, const PixelRect& area, const TimeRange&) {
                    for (std::size_t t = 0; t < footprints.rects.size() && !block.over_budget(); ++t) {
                      PixelRect r = footprints.rects[t];
                      const int top = std::max(r.row, area.row),
                                bottom = std::min(r.row + r.height, area.row + area.height);
                      if (r.width == 0 || top >= bottom) continue;
                      r.row = top;
                      r.height = bottom - top;
                      block.add(block.facet(static_cast<PrimitiveId>(t)), r);
                    }
                  });
}

template void resolve_frame_plain<Arithmetic::doubles>(const FrameTask&);
template void resolve_frame_plain<Arithmetic::chain>(const FrameTask&);
template void resolve_frame_plain<Arithmetic::mpfr>(const FrameTask&);
template void resolve_frame_plain<Arithmetic::exact>(const FrameTask&);

}  // namespace provis
