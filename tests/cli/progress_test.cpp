// The progress line's text.

#include "src/cli/progress.hpp"

#include <catch2/catch.hpp>

using namespace provis;

TEST_CASE("rate and time left follow from what was done so far") {
  CHECK(progress_text({25, 100}, 5) == "25.0 %, 5.0 %/s, 15 s left");
  CHECK(progress_text({100, 100}, 5) == "100.0 %, 20.0 %/s, 0 s left");
}

TEST_CASE("nothing is foretold from nothing") {
  CHECK(progress_text({0, 100}, 5) == "0.0 %");
  CHECK(progress_text({25, 100}, 0) == "25.0 %");
  CHECK(progress_text({0, 0}, 0) == "100.0 %");
}
