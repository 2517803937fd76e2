#include "src/report/colors.hpp"

#include <algorithm>
#include <cmath>

namespace provis {

namespace {

// C. Wellons' "lowbias32": every bit of the id reaches every bit of the hash.
std::uint32_t mixed(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x7feb352dU;
  x ^= x >> 15;
  x *= 0x846ca68bU;
  x ^= x >> 16;
  return x;
}

// One channel of the HSV colour cone; offset is 5, 3, 1 for red, green, blue; hue in sixths of the circle.
double hsv_channel(double offset, double hue, double saturation, double value) {
  const double k = std::fmod(offset + hue, 6.0);
  return 255 * value * (1 - saturation * std::max(0.0, std::min({k, 4 - k, 1.0})));
}

}  // namespace

Color id_color(PrimitiveId id) {
  const std::uint32_t h = mixed(id + 1);
  const double hue = 6.0 * (h & 0xffffU) / 65536.0;
  const double saturation = 0.40 + 0.15 * (h >> 16 & 3U);
  const double value = 0.80 + 0.06 * (h >> 18 & 3U);
  return {hsv_channel(5, hue, saturation, value), hsv_channel(3, hue, saturation, value),
          hsv_channel(1, hue, saturation, value)};
}

double facing_shade(double cosine) { return 0.6 + 0.4 * std::min(1.0, std::abs(cosine)); }

Color blend(const Color& under, const Color& over, double opacity) {
  Color mix{};
  for (std::size_t c = 0; c < 3; ++c) mix[c] = under[c] + (over[c] - under[c]) * opacity;
  return mix;
}

Color scaled(const Color& color, double factor) {
  return {color[0] * factor, color[1] * factor, color[2] * factor};
}

std::array<std::uint8_t, 3> bytes(const Color& color) {
  std::array<std::uint8_t, 3> rounded{};
  for (std::size_t c = 0; c < 3; ++c) {
    rounded[c] = static_cast<std::uint8_t>(std::lround(std::clamp(color[c], 0.0, 255.0)));
  }
  return rounded;
}

}  // namespace provis
