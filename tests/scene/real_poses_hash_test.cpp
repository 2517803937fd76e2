// Published scenes, posed by their animations, have the hashes that a second evaluator, reference_loader.py,
// computes.
#include <catch2/catch.hpp>

#include "tests/scene/expected.hpp"
#include "tests/support/environment.hpp"

namespace provis {
namespace {

TEST_CASE("poses of published scenes have the hashes of the second evaluator") {
  for (const auto& line : expected_lines("real_poses.txt")) {
    REQUIRE(line.size() == 5);
    const auto file = test::shared_scene(line[0]);
    if (!file) continue;
    LoadOptions options;
    options.animation = line[1];
    options.time = std::stod(line[2]);
    CAPTURE(line[0], line[1], line[2]);
    const Scene scene = load_scene(*file, options);
    CHECK(scene.triangles().size() == std::stoull(line[3]));
    CHECK(scene.hash() == line[4]);
  }
}

}  // namespace
}  // namespace provis
