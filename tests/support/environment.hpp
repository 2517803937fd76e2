#pragma once
// What the environment tells the tests: how many cases, which seed to replay, where the real scenes are.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace provis::test {

/// `share` percent of PROVIS_CASES (5000 where it is not set), at least 1.
std::uint64_t case_count(int share = 100);

/// The seeds of a run: 0, 1, ... case_count(share) - 1, or PROVIS_SEED alone, to replay a failure.
std::vector<std::uint64_t> seeds(int share = 100);

/// Whether PROVIS_NIGHTLY=1 asks for what takes too long for every run.
bool nightly();

/// The file of a real scene in PROVIS_SHARED (default ../shared beside the project). Where it is absent the
/// reason is printed and counted, and nothing is returned; under PROVIS_REQUIRE_SCENES=1 that is a failure.
std::optional<std::filesystem::path> shared_scene(const std::string& name);

/// The folder that holds the real scenes and their views.json, whether it is there or not.
std::filesystem::path shared_scenes_folder();

}  // namespace provis::test
