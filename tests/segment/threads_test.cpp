// Same input, same output, whatever the thread count; and a query that is told to stop stops.

#include <catch2/catch.hpp>

#include <atomic>

#include "provis/error.hpp"
#include "tests/segment/answers.hpp"
#include "tests/support/generator.hpp"

namespace provis::test {
namespace {

SegmentCase soup(std::uint64_t seed) {
  SegmentCase c;
  c.start = random_soup(seed, 800);
  c.to = c.start.view.eye + Vec3d{1, 0.5, -0.25};
  c.pixels = {24, 16};
  return c;
}

struct Run {
  Answer answer;
  SegmentSet set;
};

Run run(const SegmentCase& c, int threads, const SegmentOptions& options) {
  Context context;
  context.threads = threads;
  Run r;
  r.answer = engine_answer(c, options, context, &r.set);
  return r;
}

bool same(const Vec3<Dyadic>& a, const Vec3<Dyadic>& b) {
  const auto eq = [](const Dyadic& p, const Dyadic& q) {
    return p.mantissa == q.mantissa && p.exponent == q.exponent;
  };
  return eq(a.x, b.x) && eq(a.y, b.y) && eq(a.z, b.z);
}

void check_same(const Run& a, const Run& b) {
  REQUIRE(difference(a.answer, b.answer) == "");
  REQUIRE(a.set.seen.size() == b.set.seen.size());
  for (std::size_t k = 0; k < a.set.seen.size(); ++k) {
    REQUIRE(a.set.seen[k].primitive == b.set.seen[k].primitive);
    REQUIRE(a.set.seen[k].pixels == b.set.seen[k].pixels);
  }
  REQUIRE(a.set.set.witnesses.size() == b.set.set.witnesses.size());
  for (std::size_t k = 0; k < a.set.set.witnesses.size(); ++k) {
    const Witness &v = a.set.set.witnesses[k], &w = b.set.set.witnesses[k];
    REQUIRE(v.primitive == w.primitive);
    REQUIRE((same(v.origin, w.origin) && same(v.direction, w.direction)));
  }
}

void check_same_lengths(const Run& a, const Run& b) {
  for (std::size_t k = 0; k < a.set.seen.size(); ++k)
    REQUIRE(a.set.seen[k].length == b.set.seen.at(k).length);
}

}  // namespace

TEST_CASE("1, 2 and 7 threads give the same sets, sights, measures and witnesses along a segment") {
  for (const std::uint64_t seed : {21u, 22u}) {
    const SegmentCase c = soup(seed);
    for (const SegmentEngine engine : {SegmentEngine::fast, SegmentEngine::plain}) {
      for (const std::uint64_t bytes : {std::uint64_t{0}, std::uint64_t{100000}}) {
        SegmentOptions options;
        options.engine = engine;
        options.memory_bytes = bytes;
        options.witnesses = true;
        const Run one = run(c, 1, options);
        for (const int threads : {2, 7}) {
          const Run other = run(c, threads, options);
          check_same(one, other);
          check_same_lengths(one, other);  // bit for bit
        }
      }
    }
  }
}

TEST_CASE("both engines, cut by memory or not, give the same answer and witnesses on soups") {
  for (const std::uint64_t seed : {23u, 24u}) {
    const SegmentCase c = soup(seed);
    SegmentOptions options;
    options.witnesses = true;
    const Run fast = run(c, 0, options);
    options.engine = SegmentEngine::plain;
    const Run plain = run(c, 0, options);
    check_same(fast, plain);
    options.memory_bytes = 50000;
    REQUIRE(difference(run(c, 0, options).answer, fast.answer) == "");
  }
}

TEST_CASE("a cancelled query along a segment throws, whichever thread notices") {
  const SegmentCase c = soup(25);
  std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  for (const int threads : {1, 2}) {
    context.threads = threads;
    try {
      visible_from_segment(Scene(c.start.arrays), c.view(), {}, context);
      FAIL("was not cancelled");
    } catch (const Error& e) {
      CHECK(e.code() == Error::Code::cancelled);
    }
  }
}

}  // namespace provis::test
