// Real scenes: small ones compared as a whole, large ones re-checked triangle by triangle without any code of
// the engine.

#include <catch2/catch.hpp>

#include <iostream>

#include "provis/witness.hpp"
#include "tests/point/answers.hpp"
#include "tests/point/named_views.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/random.hpp"
#include "tests/support/ray_check.hpp"

namespace provis::test {
namespace {

/// Fewer under sanitizers.
std::size_t sampled_hidden() { return std::min<std::size_t>(500, case_count(20)); }

/// Runs body(scene, view) for each published view, and for the whole sphere around the first one's eye.
template <class Body>
void for_views(const std::string& name, bool whole_sphere, const Body& body) {
  const auto file = shared_scene(name);
  if (!file) return;
  const Scene scene = load_scene(*file);
  std::vector<NamedView> views = named_views(*file);
  REQUIRE_FALSE(views.empty());
  if (whole_sphere) views.push_back({"omni", omni(views.front().view.eye)});
  for (const NamedView& v : views) {
    INFO(name << ", view " << v.name);
    const std::size_t visible = body(scene, v.view);
    std::cout << name << ' ' << v.name << ": " << visible << " of " << scene.triangles().size()
              << " visible, confirmed\n";
  }
}

void compare_whole(const std::string& name) {
  for_views(name, true, [](const Scene& scene, const PointView& view) {
    const VisibleSet set = visible_from_point(scene, view);
    REQUIRE(ids_of(visible_flags(set)) == ids_of(oracle_visible(scene, view)));
    return set.with(Status::visible).size();
  });
}

/// Each visible triangle has a rational ray that is tested against all triangles; of the hidden ones a
/// random choice is subtracted exactly.
void recheck(const std::string& name) {
  for_views(name, false, [](const Scene& scene, const PointView& view) {
    PointOptions options;
    options.witnesses = true;
    const VisibleSet set = visible_from_point(scene, view, options);
    REQUIRE(set.witnesses.size() == set.with(Status::visible).size());
    const RayChecker checker(scene, view);
    for (const Witness& w : set.witnesses) REQUIRE(checker.refuse(w) == "");
    REQUIRE(verify_witnesses(scene, view, set) == set.witnesses.size());

    std::vector<PrimitiveId> hidden = set.with(Status::hidden);
    Random random(2024);
    for (std::size_t k = 0; k < std::min(sampled_hidden(), hidden.size()); ++k)
      std::swap(hidden[k], hidden[k + random.below(hidden.size() - k)]);
    hidden.resize(std::min(sampled_hidden(), hidden.size()));
    for (const bool visible : subtract_check(scene, view, hidden)) REQUIRE_FALSE(visible);
    return set.witnesses.size();
  });
}

}  // namespace

TEST_CASE("bevy_cornell: full comparison") { compare_whole("bevy_cornell"); }
TEST_CASE("step_dm1: full comparison") { compare_whole("step_dm1"); }
TEST_CASE("godot_living_room: full comparison") { compare_whole("godot_living_room"); }
TEST_CASE("quake_bsp_dm4: full comparison") { compare_whole("quake_bsp_dm4"); }
TEST_CASE("step_as1: full comparison") { compare_whole("step_as1"); }
TEST_CASE("recast_dungeon: full comparison") { compare_whole("recast_dungeon"); }

TEST_CASE("sponza_dabrovic_a: re-check") { recheck("sponza_dabrovic_a"); }
TEST_CASE("sponza_dabrovic_b: re-check") { recheck("sponza_dabrovic_b"); }
TEST_CASE("quake_bsp_e1m1: re-check") { recheck("quake_bsp_e1m1"); }
TEST_CASE("ifc_duplex: re-check") { recheck("ifc_duplex"); }
TEST_CASE("vox_monu1: re-check") { recheck("vox_monu1"); }

TEST_CASE("larger scenes: re-check, nightly") {
  if (!nightly()) {
    std::cout << "skipped, runs only with PROVIS_NIGHTLY=1\n";
    return;
  }
  for (const char* name : {"ifc_mini_project", "ifc_office_a", "ifc_smiley_west", "quake_map_e3m4",
                           "godot_zdm2", "vox_maze", "vox_monu7", "m_igea"})
    recheck(name);
}

}  // namespace provis::test
