#pragma once
// Colours of the pictures. Tests rely on these formulas; they are stated in README.md.

#include <array>
#include <cstdint>

#include "provis/scene.hpp"

namespace provis {

/// Red, green, blue in [0, 255], not yet rounded.
using Color = std::array<double, 3>;

inline constexpr Color background_color = {232, 232, 232};
inline constexpr Color hidden_color = {118, 138, 168};       ///< grey-blue
inline constexpr Color visible_low_color = {196, 74, 20};    ///< warm, dark at the bottom of the scene
inline constexpr Color visible_high_color = {255, 178, 74};  ///< warm, light at its top
inline constexpr Color visible_wall_color = {150, 44, 0};    ///< what is visible and seen edge-on
inline constexpr Color undecided_color = {20, 150, 110};     ///< green
inline constexpr Color eye_color = {20, 40, 160};

inline constexpr double see_through_opacity = 0.4;

/// A colour of its own for each id: neighbouring ids get unlike hues.
Color id_color(PrimitiveId id);

/// The gentle facing term: 1 seen straight on, 0.6 edge-on.
double facing_shade(double cosine);

/// over seen through opacity in [0, 1] before under.
Color blend(const Color& under, const Color& over, double opacity);

Color scaled(const Color& color, double factor);

/// Rounded to the nearest byte.
std::array<std::uint8_t, 3> bytes(const Color& color);

}  // namespace provis
