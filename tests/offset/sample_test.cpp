// One sample of the camera offset space, exactly, against clipping over rational numbers.

#include <catch2/catch.hpp>

#include "src/region/lower.hpp"
#include "tests/support/cells.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/offset_sample.hpp"

namespace provis::test {

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
    const double x = random.between(-8, 8) / 4.0, y = random.between(-8, 8) / 4.0;
    INFO(describe(c, cell) << "\naxis " << face.axis << (face.upper ? " upper " : " lower ") << x << " "
                           << y);
    const std::vector<bool> expected = offset_sample(c.arrays, cell, face.axis, face.upper, x, y);
    const VisibleSet set = visible_from_point(Scene(c.arrays), offset_sample_view(face, x, y));
    for (std::size_t t = 0; t < expected.size(); ++t) {
      INFO("triangle " << t);
      REQUIRE((set.status[t] == Status::visible) == expected[t]);
      ++(expected[t] ? shown : not_shown);
    }
  }
  WARN(shown << " shown and " << not_shown << " not shown agreed");
  CHECK((shown > 0 && not_shown > 0));
}

}  // namespace provis::test
