// A regular grid of rays: what it finds is visible, whatever it misses.

#include <catch2/catch.hpp>

#include "tests/point/answers.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/ray_check.hpp"

namespace provis::test {
namespace {

VisibleSet sampled(const Case& c, const PixelGrid& pixels, int samples, int threads = 0) {
  PointOptions options;
  options.method = Method::sampled;
  options.pixels = pixels;
  options.samples = samples;
  options.witnesses = c.view.projection != Projection::parallel;
  Context context;
  context.threads = threads;
  return visible_from_point(Scene(c.arrays), c.view, options, context);
}

}  // namespace

TEST_CASE("the sampled set is a part of the oracle's on every generated case, and every witness holds") {
  for (const std::uint64_t seed : seeds(20)) {
    const Case c = generate(seed);
    INFO(describe(c));
    const VisibleSet set = sampled(c, {4, 3}, 1 + static_cast<int>(seed % 3));
    REQUIRE(set.guarantee == Guarantee::aggressive);
    const std::vector<bool> found = visible_flags(set), visible = oracle_visible(c.arrays, c.view);
    for (std::size_t t = 0; t < found.size(); ++t) REQUIRE((!found[t] || visible[t]));
    const RayChecker checker(c.arrays, c.view);
    for (const Witness& w : set.witnesses) REQUIRE(checker.refuse(w) == "");
  }
}

TEST_CASE("n x n samples of a pixel are the samples of n times the pixels each way") {
  const Case c = random_soup(8, 400);
  const VisibleSet fine = sampled(c, {40, 40}, 1), coarse = sampled(c, {10, 10}, 4);
  CHECK(fine.status == coarse.status);
  CHECK(coarse.stats.sampling.pixels == 100);
  CHECK(coarse.stats.sampling.locations == 1600);
  CHECK(coarse.stats.sampling.most == 16);
}

TEST_CASE("65536 samples in each pixel, and threads change nothing") {
  const Case c = random_soup(9, 60);
  const VisibleSet one = sampled(c, {4, 4}, 256, 1), two = sampled(c, {4, 4}, 256, 2);
  CHECK(one.status == two.status);
  CHECK(one.stats.sampling.most == 65536);
  // In general position a megasample finds what is not tiny.
  CHECK(one.with(Status::visible).size() * 10 > 9 * ids_of(oracle_visible(c.arrays, c.view)).size());
}

}  // namespace provis::test
