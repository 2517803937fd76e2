// The floating-point environment: the canary, and what guards do to threads.

#include <catch2/catch.hpp>

#include <cfenv>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <thread>

#ifdef __SSE2__
#include <pmmintrin.h>
#include <xmmintrin.h>
#endif

#include "predicates/environment.hpp"
#include "predicates/signs.hpp"
#include "provis/error.hpp"

namespace provis::test {

TEST_CASE("environment: the canary is content in every rounding mode, and leaves it alone") {
  for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    CHECK_NOTHROW(check_environment());
    CHECK(std::fegetround() == mode);
  }
  std::fesetround(FE_TONEAREST);
}

#ifdef __SSE2__
TEST_CASE("environment: the canary refuses where subnormal numbers are flushed to zero") {
  const unsigned saved = _mm_getcsr();
  SECTION("results") { _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON); }
  SECTION("operands") { _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON); }
  bool refused = false;
  try {
    check_environment();
  } catch (const Error& e) {
    refused = e.code() == Error::Code::internal;
  }
  _mm_setcsr(saved);
  CHECK(refused);
}
#endif

TEST_CASE("environment: guards nest and restore") {
  CHECK_FALSE(rounds_up());
  {
    const RoundUp up;
    CHECK(rounds_up());
    {
      const RoundNearest nearest;
      CHECK_FALSE(rounds_up());
      CHECK(std::fegetround() == FE_TONEAREST);
    }
    CHECK(rounds_up());
  }
  CHECK_FALSE(rounds_up());
}

TEST_CASE("environment: a worker that exists already knows nothing of its master's rounding mode") {
  std::mutex mutex;
  std::condition_variable changed;
  bool asked = false, up_before = true, up_inside = false, up_after = true, canary = false;
  std::thread worker([&] {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return asked; });
    up_before = rounds_up();
    {
      const RoundUp guard;
      up_inside = rounds_up();
      check_environment();
      canary = true;
    }
    up_after = rounds_up();
  });
  {
    const RoundUp guard;
    {
      const std::lock_guard lock(mutex);
      asked = true;
    }
    changed.notify_one();
    worker.join();
    CHECK(rounds_up());
  }
  CHECK_FALSE(up_before);
  CHECK(up_inside);
  CHECK_FALSE(up_after);
  CHECK(canary);
}

TEST_CASE("environment: a worker's guard does not reach its master") {
  bool up = false;
  std::thread([&] {
    const RoundUp guard;
    up = rounds_up();
  }).join();
  CHECK(up);
  CHECK_FALSE(rounds_up());
}

TEST_CASE("environment: a new worker with a guard decides as its master does") {
  const ViewGeometry g = make_geometry({0, 0, 0}, Frame{}, false);
  const Vec3d a{1, 2, 3}, b{4, 5, 6}, c{5, 7, 9};  // edge-on: the interval tier is needed
  const auto facing = [&] {
    const RoundUp guard;
    SignCounts counts;
    return Signs<Arithmetic::chain>(g, counts).facing(a, b, c);
  };
  Sign elsewhere = Sign::positive;
  std::thread([&] { elsewhere = facing(); }).join();
  CHECK(elsewhere == Sign::zero);
  CHECK(facing() == Sign::zero);
}

TEST_CASE("environment: the interval tier refuses to work without its guard") {
  const ViewGeometry g = make_geometry({0, 0, 0}, Frame{}, false);
  SignCounts counts;
  Signs<Arithmetic::chain> signs(g, counts);
  CHECK_THROWS_AS(signs.facing({1, 2, 3}, {4, 5, 6}, {5, 7, 9}), Error);
}

TEST_CASE("environment: products and sums are not fused") {
  // fma(a, a, -fl(a a)) would be the rounding error of the product.
  volatile double a = 1 + std::numeric_limits<double>::epsilon();
  const double x = a, square = x * x;
  volatile double stored = square;
  CHECK(x * x - stored == 0);
}

}  // namespace provis::test
