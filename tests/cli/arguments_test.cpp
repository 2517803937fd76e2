// Numbers as option values.

#include "src/cli/arguments.hpp"

#include <catch2/catch.hpp>

#include "provis/error.hpp"

using namespace provis;

namespace {

template <class Parse>
void refused(Parse parse) {
  try {
    parse();
    FAIL("was taken");
  } catch (const Error& error) {
    CHECK(error.code() == Error::Code::usage);
    CHECK_THAT(error.what(), Catch::StartsWith("--it: expected "));
  }
}

}  // namespace

TEST_CASE("numbers are read to the last bit") {
  CHECK(parse_number("--it", "0.1") == 0.1);
  CHECK(parse_number("--it", "+1e-8") == 1e-8);
  CHECK(parse_number("--it", "-5e-324") == -5e-324);
  CHECK(parse_vec3("--it", "-1,.5,1e300") == Vec3d{-1, 0.5, 1e300});
  CHECK(parse_window("--it", "-1,1,-0.5,0.5") == Window{-1, 1, -0.5, 0.5});
  CHECK(parse_whole("--it", "18446744073709551615", 0, ~std::uint64_t{0}) == ~std::uint64_t{0});
  CHECK(parse_size("--it", "1x16384") == std::array<int, 2>{1, 16384});
}

TEST_CASE("what is no finite number is refused with the option's name") {
  for (const char* text : {"", "x", "nan", "inf", "-inf", "1e999", "1 ", " 1", "1,2", "0x10"}) {
    refused([&] { parse_number("--it", text); });
  }
  for (const char* text : {"1,2", "1,2,3,4", "1,,3", "1,2,", ",1,2", "1,2,nan", "1;2;3"}) {
    refused([&] { parse_vec3("--it", text); });
  }
  refused([] { parse_window("--it", "0,1,0"); });
  for (const char* text : {"-1", "1.5", "5000", "99999999999999999999"}) {
    refused([&] { parse_whole("--it", text, 0, 4096); });
  }
  for (const char* text : {"10", "10x", "x10", "0x10", "10x16385", "-1x5", "10X10", "1x2x3"}) {
    refused([&] { parse_size("--it", text); });
  }
}
