#pragma once
// Pictures of a visible set. They are sampled at pixel centres in float64: to look at, not to decide by.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "provis/scene.hpp"
#include "provis/segment.hpp"
#include "provis/view.hpp"
#include "provis/visible_set.hpp"

namespace provis {

/// 8-bit RGB, row 0 on top.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< width * height * 3
};

/// The view through one frame, each primitive of the set in a colour of its own, by id.
Image draw_view(const Scene& scene, const VisibleSet& set, const PointView& view, int frame, int width,
                int height);

/// The same view by status: what is visible in orange; what is hidden behind it as a grey-blue wash, and what
/// is undecided in green over both.
Image draw_statuses(const Scene& scene, const VisibleSet& set, const PointView& view, int frame, int width,
                    int height);

/// How one frame is drawn: draw_view or draw_statuses.
using DrawFrame = Image (*)(const Scene&, const VisibleSet&, const PointView&, int frame, int width,
                            int height);

/// Every frame of the view in one picture: a single frame fills it, six are laid out three by two.
Image draw_frames(const Scene& scene, const VisibleSet& set, const PointView& view, int width, int height,
                  DrawFrame draw = draw_view);

/// The scene from above (along -up of the first frame), visible and hidden primitives told apart and
/// the viewpoint marked with its window's outline.
Image draw_above(const Scene& scene, const VisibleSet& set, const PointView& view, int width, int height);

/// An epipolar-plane image: what a row of pixels sees over time, from left to right by column, from top to
/// bottom from 0 to 1.
///
/// Input:      pixels: of one row, from left to right, at least one
/// Returns:    at (x, y) what the pixel column in which (x + 1/2) / width lies sees at (y + 1/2) / height,
///             decided on the exact times; where several primitives are seen at once, the mean of their
///             colours
Image draw_over_time(const std::vector<PixelSights>& pixels, int width, int height);

/// Throws:     Error::output; no partial file is left behind
void write_png(const Image& image, const std::filesystem::path& file);

}  // namespace provis
