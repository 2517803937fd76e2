#pragma once
// Option values: text into numbers. Every complaint is Error::usage and names the option.

#include <array>
#include <cstdint>
#include <string>

#include "provis/vec3.hpp"
#include "provis/view.hpp"

namespace provis {

/// A finite float64, correctly rounded from its decimal or scientific notation.
double parse_number(const std::string& option, const std::string& text);

/// A decimal integer in [low, high].
std::uint64_t parse_whole(const std::string& option, const std::string& text, std::uint64_t low,
                          std::uint64_t high);

/// x,y,z
Vec3d parse_vec3(const std::string& option, const std::string& text);

/// x0,x1,y0,y1
Window parse_window(const std::string& option, const std::string& text);

/// WxH in pixels, each in [1, 16384]
std::array<int, 2> parse_size(const std::string& option, const std::string& text);

}  // namespace provis
