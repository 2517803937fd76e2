// Same input, same output, whatever the thread count; and a query that is told to stop stops.

#include <catch2/catch.hpp>

#include <atomic>

#include "provis/error.hpp"
#include "tests/point/answers.hpp"
#include "tests/support/generator.hpp"

namespace provis::test {
namespace {

VisibleSet run(const Case& c, int threads, bool witnesses, bool subdivision) {
  PointOptions options;
  options.witnesses = witnesses;
  options.subdivision = subdivision;
  Context context;
  context.threads = threads;
  return visible_from_point(Scene(c.arrays), c.view, options, context);
}

bool same(const Vec3<Dyadic>& a, const Vec3<Dyadic>& b) {
  const auto eq = [](const Dyadic& p, const Dyadic& q) {
    return p.mantissa == q.mantissa && p.exponent == q.exponent;
  };
  return eq(a.x, b.x) && eq(a.y, b.y) && eq(a.z, b.z);
}

void check_same(const VisibleSet& a, const VisibleSet& b) {
  REQUIRE(a.status == b.status);
  REQUIRE(a.eye_on_primitive == b.eye_on_primitive);
  REQUIRE(a.witnesses.size() == b.witnesses.size());
  for (std::size_t k = 0; k < a.witnesses.size(); ++k) {
    REQUIRE(a.witnesses[k].primitive == b.witnesses[k].primitive);
    REQUIRE(same(a.witnesses[k].origin, b.witnesses[k].origin));
    REQUIRE(same(a.witnesses[k].direction, b.witnesses[k].direction));
  }
  REQUIRE(a.subdivision.size() == b.subdivision.size());
  for (std::size_t k = 0; k < a.subdivision.size(); ++k) {
    REQUIRE(a.subdivision[k].frame == b.subdivision[k].frame);
    REQUIRE(a.subdivision[k].corners == b.subdivision[k].corners);
    REQUIRE(a.subdivision[k].area == b.subdivision[k].area);
    REQUIRE(a.subdivision[k].visible == b.subdivision[k].visible);
  }
}

}  // namespace

TEST_CASE("1, 2 and 7 threads give the same set, witnesses and cells on three scenes") {
  for (const int scene : {0, 1, 2}) {
    Case c = random_soup(static_cast<std::uint64_t>(scene) + 11, 1500);
    if (scene == 2) c.view = omni(c.view.eye);
    for (const bool proofs : {false, true}) {
      const VisibleSet one = run(c, 1, proofs, proofs);
      check_same(one, run(c, 2, proofs, proofs));
      check_same(one, run(c, 7, proofs, proofs));
    }
  }
}

TEST_CASE("a cancelled query throws, whichever thread notices") {
  const Case c = random_soup(5, 2000);
  std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  for (const int threads : {1, 2}) {
    context.threads = threads;
    try {
      visible_from_point(Scene(c.arrays), c.view, {}, context);
      FAIL("was not cancelled");
    } catch (const Error& e) {
      CHECK(e.code() == Error::Code::cancelled);
    }
  }
}

TEST_CASE("progress never decreases and ends at its total") {
  const Case c = random_soup(6, 1500);
  Context context;
  double last = 0, total = 0;
  bool monotone = true;
  context.on_progress = [&](const Progress& p) {
    monotone &= p.done >= last;
    last = p.done;
    total = p.total;
  };
  visible_from_point(Scene(c.arrays), c.view, {}, context);
  CHECK(monotone);
  CHECK(total == 1);
  CHECK(last == total);
}

}  // namespace provis::test
