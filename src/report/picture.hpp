#pragma once
// Small things that every picture needs.

#include "provis/draw.hpp"
#include "src/report/colors.hpp"

namespace provis {

/// The largest picture, per side.
inline constexpr int max_image_side = 16384;

/// Background only. Throws Error::usage unless both sides are in [1, max_image_side].
Image blank_image(int width, int height);

void set_pixel(Image& image, int column, int row, const Color& color);

/// Copies part to (left, top); what falls outside is cut off.
void paste(Image& image, const Image& part, int left, int top);

/// Throws Error::usage unless the set has one status per primitive of the scene.
void require_match(const Scene& scene, const VisibleSet& set);

}  // namespace provis
