#include "tests/support/environment.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <numeric>
#include <stdexcept>

namespace provis::test {
namespace {

constexpr std::uint64_t default_cases = 5000;

std::uint64_t number(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

}  // namespace

std::uint64_t case_count(int share) {
  const std::uint64_t count = number("PROVIS_CASES", default_cases) * static_cast<std::uint64_t>(share) / 100;
  return std::max<std::uint64_t>(1, count);
}

std::vector<std::uint64_t> seeds(int share) {
  if (std::getenv("PROVIS_SEED") != nullptr) return {number("PROVIS_SEED", 0)};
  std::vector<std::uint64_t> all(case_count(share));
  std::iota(all.begin(), all.end(), std::uint64_t{0});
  return all;
}

bool nightly() { return number("PROVIS_NIGHTLY", 0) == 1; }

std::filesystem::path shared_scenes_folder() {
  const char* folder = std::getenv("PROVIS_SHARED");
  const std::filesystem::path shared = folder != nullptr ? folder : PROVIS_SOURCE_DIR "/../shared";
  return shared / "scenes";
}

std::optional<std::filesystem::path> shared_scene(const std::string& name) {
  const std::filesystem::path file = shared_scenes_folder() / (name + ".glb");
  if (std::filesystem::exists(file)) return file;
  if (number("PROVIS_REQUIRE_SCENES", 0) == 1)
    throw std::runtime_error("required scene is missing: " + file.string());
  static int skipped = 0;
  std::cout << "skipped (" << ++skipped << " so far), no such scene: " << file.string() << '\n';
  return std::nullopt;
}

}  // namespace provis::test
