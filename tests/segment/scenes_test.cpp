// Real scenes: at a few pixels the engine's sights are compared with those of the oracle, which tries every
// triangle.

#include <catch2/catch.hpp>

#include <algorithm>
#include <iostream>

#include "tests/point/named_views.hpp"
#include "tests/segment/answers.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/random.hpp"

namespace provis::test {
namespace {

/// As many as the sanitizers leave time for.
int pixels_tried() { return static_cast<int>(std::min<std::uint64_t>(6, 1 + case_count(1) / 3)); }

/// From the published eye along and across its direction, by this many units.
SegmentView walk(const PointView& from, double ahead, double aside) {
  const Frame& f = from.frames.front();
  return {from.eye, from.eye + ahead * f.forward + aside * f.right, from.frames, {64, 36}};
}

void compare_pixels(const Scene& scene, const SegmentView& view, std::uint64_t seed) {
  std::vector<ExactSights> told;
  SegmentOptions options;
  options.on_pixel = [&](const PixelSights& p) { told.push_back(exact(p)); };
  const SegmentSet set = visible_from_segment(scene, view, options);
  REQUIRE(told.size() == static_cast<std::size_t>(view.pixels.width * view.pixels.height));

  const SegmentOracle oracle(scene.arrays(), view);
  Random random(seed);
  std::size_t sights = 0;
  for (int i = 0; i < pixels_tried(); ++i) {
    const Pixel p{0, random.between(0, view.pixels.width - 1), random.between(0, view.pixels.height - 1)};
    const ExactSights expected = oracle.sights(p);
    const ExactSights& found = told[static_cast<std::size_t>(p.row * view.pixels.width + p.column)];
    INFO("found " << text(found) << "\nexpected " << text(expected));
    REQUIRE(found == expected);
    sights += expected.sights.size();
    for (const ExactSight& s : expected.sights)
      for (const PrimitiveId id : s.visible) REQUIRE(set.set.status[id] == Status::visible);
  }
  std::cout << set.set.with(Status::visible).size() << " of " << scene.triangles().size() << " visible; "
            << pixels_tried() << " pixels with " << sights << " sights confirmed\n";
}

void compare(const std::string& name) {
  const auto file = shared_scene(name);
  if (!file) return;
  const Scene scene = load_scene(*file);
  const std::vector<NamedView> views = named_views(*file);
  REQUIRE_FALSE(views.empty());
  for (const NamedView& v : views) {
    INFO(name << ", view " << v.name);
    std::cout << name << ' ' << v.name << ": ";
    compare_pixels(scene, walk(v.view, 0.25, 2), 1);
    if (&v != &views.front()) continue;
    std::cout << name << ' ' << v.name << ", through walls: ";
    compare_pixels(scene, walk(v.view, 8, 0.5), 2);
  }
}

}  // namespace

TEST_CASE("sponza_dabrovic_a: sights at some pixels along walks") { compare("sponza_dabrovic_a"); }
TEST_CASE("quake_bsp_e1m1: sights at some pixels along walks") { compare("quake_bsp_e1m1"); }

}  // namespace provis::test
