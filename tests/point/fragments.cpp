#include "tests/point/fragments.hpp"

#include <optional>

#include "src/point/pixel_blocks.hpp"
#include "tests/support/facet.hpp"

namespace provis::test {
namespace {

/// Whether the occluder is strictly nearer in some area of the fragment.
bool takes_something(const test::Facet& occluder, const test::Facet& fragment) {
  if (!occluder.occludes || !overlap(occluder.polygon.box(), fragment.polygon.box())) return false;
  WindowPolygon covered = fragment.polygon.clipped(
      make_line(fragment.denominator * occluder.nearness - occluder.denominator * fragment.nearness), +1);
  for (const Line& line : occluder.inside)
    if (!covered.empty()) covered = covered.clipped(line, +1);
  return !covered.empty();
}

}  // namespace

std::vector<bool> completely_visible_somewhere(const Case& c, const PixelGrid& grid) {
  std::vector<bool> found(c.arrays.triangles.size(), false);
  const CommonScale scale = scale_of(c.arrays, c.view);
  for (const Frame& frame : c.view.frames) {
    const std::vector<double> xs = pixel_borders(frame.window.x0, frame.window.x1, grid.width);
    const std::vector<double> ys = pixel_borders(frame.window.y0, frame.window.y1, grid.height);
    for (std::size_t x = 0; x + 1 < xs.size(); ++x)
      for (std::size_t y = 0; y + 1 < ys.size(); ++y) {
        Frame pixel = frame;
        pixel.window = {xs[x], xs[x + 1], ys[y], ys[y + 1]};
        const FrameView pixel_view(c.view, pixel, scale);
        std::vector<test::Facet> fragments;
        for (std::size_t t = 0; t < found.size(); ++t)
          if (auto f = pixel_view.facet(c.arrays, t)) fragments.push_back(std::move(*f));
        for (const test::Facet& f : fragments)
          if (!found[f.id] && std::none_of(fragments.begin(), fragments.end(), [&](const test::Facet& o) {
                return o.id != f.id && takes_something(o, f);
              }))
            found[f.id] = true;
      }
  }
  return found;
}

}  // namespace provis::test
