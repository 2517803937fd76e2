// Samples of the camera offset space, exactly, against clipping over rational numbers.

#include <catch2/catch.hpp>

#include <algorithm>

#include "provis/error.hpp"
#include "provis/point.hpp"
#include "provis/witness.hpp"
#include "src/region/face_parts.hpp"
#include "src/region/samples.hpp"
#include "tests/support/cells.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/offset_sample.hpp"

namespace provis::test {
namespace {

constexpr PixelGrid few_pixels{2, 1};

CellSet exact_samples(const Case& c, const ViewCell& cell) {
  CellOptions options;
  options.method = CellMethod::cos_exact;
  options.pixels = few_pixels;
  Context context;
  context.threads = 1;  // samples of small scenes are over before a second thread wakes
  return visible_from_cell(Scene(c.arrays), cell, options, context);
}

bool two_edges(const ViewCell& cell) {
  const Vec3d size = cell.upper - cell.lower;
  return (size.x > 0) + (size.y > 0) + (size.z > 0) >= 2;
}

}  // namespace

TEST_CASE("a sample shows what clipping in the offset rectangle leaves over") {
  std::size_t shown = 0, not_shown = 0;
  for (const std::uint64_t seed : seeds(20)) {
    const Case c = generate(seed);
    Random random(seed + 3);
    ViewCell cell = any_cell(c, random);
    cell.window.reset();
    const auto faces = offset::faces_of(cell);
    const offset::Face& face = random.pick_from(faces);
    if (!has_area(face)) continue;
    const double x = random.between(-8, 8) / 4.0, y = random.between(-8, 8) / 4.0, out = face.upper ? 1 : -1;
    const Vec3d d = face.axis == 0 ? Vec3d{out, x, y} : face.axis == 1 ? Vec3d{y, out, x} : Vec3d{x, y, out};
    INFO(describe(c, cell) << "\naxis " << face.axis << (face.upper ? " upper " : " lower ") << x << " "
                           << y);
    const std::vector<Shown> expected = offset_sample(c.arrays, cell, face.axis, face.upper, {d.x, d.y, d.z});
    const VisibleSet set = visible_from_point(Scene(c.arrays), offset_sample_view(face, d));
    for (std::size_t t = 0; t < expected.size(); ++t) {
      INFO("triangle " << t);
      REQUIRE((set.status[t] == Status::visible) == (expected[t] != Shown::nothing));
      ++(expected[t] != Shown::nothing ? shown : not_shown);
    }
  }
  WARN(shown << " shown and " << not_shown << " not shown agreed");
  CHECK((shown > 0 && not_shown > 0));
}

TEST_CASE("all samples of a cell show what clipping leaves over, and prove what lies on no occluder") {
  std::size_t shown = 0, not_shown = 0, boundary = 0, not_found = 0, cells = 0;
  for (const std::uint64_t seed : seeds(25)) {
    const Case c = generate(seed);
    Random random(seed + 11);
    const ViewCell cell = any_cell(c, random);
    if (!two_edges(cell)) continue;
    INFO(describe(c, cell));
    const std::vector<Shown> expected = offset_samples(c.arrays, cell, few_pixels);
    const CellSet set = exact_samples(c, cell);
    REQUIRE(set.set.answers == "R10");
    REQUIRE(set.set.guarantee == Guarantee::exact);
    std::vector<PrimitiveId> unproven;
    for (PrimitiveId t = 0; t < expected.size(); ++t) {
      INFO("triangle " << t);
      REQUIRE((set.set.status[t] == Status::visible) == (expected[t] != Shown::nothing));
      ++(expected[t] != Shown::nothing ? shown : not_shown);
      if (expected[t] == Shown::on_occluders) unproven.push_back(t);
    }
    REQUIRE(std::includes(set.boundary.begin(), set.boundary.end(), unproven.begin(), unproven.end()));
    REQUIRE(verify_witnesses(Scene(c.arrays), cell, set) + set.boundary.size() ==
            set.set.with(Status::visible).size());
    boundary += unproven.size();
    not_found += set.boundary.size() - unproven.size();
    ++cells;
  }
  WARN(shown << " shown and " << not_shown << " not shown agreed in " << cells << " cells; " << boundary
             << " at the boundary, " << not_found << " more without a witness");
  if (seeds(25).size() > 100) {
    CHECK((shown > 0 && not_shown > 0 && boundary > 0));
    // Slivers between occluders in the face's plane that hold no rectangle between float64 numbers.
    CHECK(20 * not_found < shown);
  }
}

TEST_CASE("cells without a face of some area have no samples") {
  SceneArrays none;
  for (const Vec3d& edges : {Vec3d{0, 0, 0}, Vec3d{1, 0, 0}, Vec3d{0, 0, 1}}) {
    CellOptions options;
    options.method = CellMethod::cos_exact;
    CHECK_THROWS_AS(visible_from_cell(Scene(none), cell_around({0, 0, 0}, edges), options), Error);
  }
}

}  // namespace provis::test
