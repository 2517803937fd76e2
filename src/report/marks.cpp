#include "src/report/marks.hpp"

#include <algorithm>
#include <cmath>

#include "src/report/picture.hpp"

namespace provis {

namespace {

// Cuts the segment to the picture (Liang and Barsky), so that a far end costs nothing. False if it misses.
bool clip(PixelPoint& from, PixelPoint& to, int width, int height) {
  const PixelPoint start = from, step = {to[0] - from[0], to[1] - from[1]};
  const double limit[2] = {static_cast<double>(width), static_cast<double>(height)};
  double first = 0, last = 1;
  for (std::size_t k = 0; k < 2; ++k) {
    if (!std::isfinite(start[k]) || !std::isfinite(step[k])) return false;
    if (step[k] == 0) {
      if (start[k] < 0 || start[k] > limit[k]) return false;
      continue;
    }
    const double a = -start[k] / step[k], b = (limit[k] - start[k]) / step[k];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (first > last) return false;
  from = {start[0] + first * step[0], start[1] + first * step[1]};
  to = {start[0] + last * step[0], start[1] + last * step[1]};
  return true;
}

}  // namespace

std::vector<std::size_t> pixels_under(const PixelPoint& from, const PixelPoint& to, int width, int height) {
  std::vector<std::size_t> pixels;
  PixelPoint a = from, b = to;
  if (!clip(a, b, width, height)) return pixels;
  const int steps = 1 + static_cast<int>(std::max(std::abs(b[0] - a[0]), std::abs(b[1] - a[1])));
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const int column = std::clamp(static_cast<int>(a[0] + t * (b[0] - a[0])), 0, width - 1);
    const int row = std::clamp(static_cast<int>(a[1] + t * (b[1] - a[1])), 0, height - 1);
    const std::size_t pixel =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
    if (pixels.empty() || pixels.back() != pixel) pixels.push_back(pixel);
  }
  return pixels;
}

void draw_line(Image& image, const PixelPoint& from, const PixelPoint& to, const Color& color) {
  for (std::size_t pixel : pixels_under(from, to, image.width, image.height)) {
    const int column = static_cast<int>(pixel % static_cast<std::size_t>(image.width));
    const int row = static_cast<int>(pixel / static_cast<std::size_t>(image.width));
    set_pixel(image, column, row, color);
    set_pixel(image, std::min(column + 1, image.width - 1), row, color);
    set_pixel(image, column, std::min(row + 1, image.height - 1), color);
  }
}

void draw_ring(Image& image, const PixelPoint& center, double inner, double outer, const Color& color) {
  const auto begin = [&](double c, int size) {
    return static_cast<int>(std::clamp(std::floor(c - outer), 0.0, static_cast<double>(size)));
  };
  const auto end = [&](double c, int size) {
    return static_cast<int>(std::clamp(std::ceil(c + outer) + 1, 0.0, static_cast<double>(size)));
  };
  for (int row = begin(center[1], image.height); row < end(center[1], image.height); ++row) {
    for (int column = begin(center[0], image.width); column < end(center[0], image.width); ++column) {
      const double distance = std::hypot(column + 0.5 - center[0], row + 0.5 - center[1]);
      if (distance >= inner && distance <= outer) set_pixel(image, column, row, color);
    }
  }
}

}  // namespace provis
