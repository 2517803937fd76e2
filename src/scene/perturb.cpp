#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "provis/error.hpp"
#include "provis/scene.hpp"
#include "src/scene/random.hpp"

namespace provis {
namespace {

/// A bijection in which every input bit reaches every output bit.
std::uint64_t mix(std::uint64_t z) { return Random(z).next(); }

/// -0 and +0 are one position.
std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x == 0 ? 0.0 : x); }

/// By a number from [-delta, delta) each way, one of 2^53 equally spaced ones before the product is rounded.
Vec3d moved(const Vec3d& p, double delta, std::uint64_t seed) {
  const std::uint64_t h = mix(mix(mix(mix(seed) ^ bits(p.x)) ^ bits(p.y)) ^ bits(p.z));
  const auto offset = [&](std::uint64_t k) { return delta * Random(h ^ k).signed_unit(); };
  return {p.x + offset(1), p.y + offset(2), p.z + offset(3)};
}

double largest_coordinate(const Scene& scene) {
  double largest = 0;
  const auto add = [&largest](const Vec3d& p) {
    largest = std::fmax(largest, std::fmax(std::fabs(p.x), std::fmax(std::fabs(p.y), std::fabs(p.z))));
  };
  for (const Vec3d& vertex : scene.vertices()) add(vertex);
  for (const Sphere& sphere : scene.spheres()) add(sphere.center);
  return largest;
}

void check_delta(double delta, double largest) {
  const auto fail = [](const std::string& what) { throw Error(Error::Code::usage, "--perturb", what); };
  if (!std::isfinite(delta) || delta < 0) fail(fmt::format("{} is no distance", delta));
  // The ulp of the largest finite number is the gap below it; there is none above.
  const double below = std::nextafter(largest, 0.0);
  const double above = std::nextafter(largest, std::numeric_limits<double>::infinity());
  const double ulp = std::isfinite(above) ? above - largest : largest - below;
  if (delta < ulp)
    fail(fmt::format("{} is below one ulp ({}) of the largest coordinate {}", delta, ulp, largest));
  if (!std::isfinite(largest + delta))
    fail(fmt::format("{} moves the coordinate {} out of range", delta, largest));
}

}  // namespace

Scene perturb(const Scene& scene, double delta, std::uint64_t seed) {
  check_delta(delta, largest_coordinate(scene));
  SceneArrays arrays = scene.arrays();
  for (Vec3d& vertex : arrays.vertices) vertex = moved(vertex, delta, seed);
  for (Sphere& sphere : arrays.spheres) sphere.center = moved(sphere.center, delta, seed);
  return Scene(std::move(arrays));
}

}  // namespace provis
