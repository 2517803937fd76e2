#pragma once
// A result with something in every member, filled by hand.

#include <string>

#include "provis/result_file.hpp"

namespace provis {

inline ResultFile example_result() {
  ResultFile result;
  ResultHeader& header = result.header;
  header.scene_file = "../scenes/a \"house\".glb";
  header.scene_hash = std::string(64, 'a');
  header.triangles = 5;
  header.spheres = 1;
  header.left_out = {{"line 12", "face 1 uses vertex 7 of 3"},
                     {"meshes[0].primitives[\"1\"]", "a \n reason"}};
  header.view.eye = {0.1, -0.0, 1.0 / 3};
  header.view.frames = {
      Frame{{1, 1e-300, 0}, {0, 1e22, 5e-324}, {0, 0, -1.7976931348623157e308}, {-1.5, 0.1, -0.2, 0.7}}};
  header.options = {
      {"sides", "material"},   {"opacity", "all"}, {"method", "exact"}, {"perturb", "1e-08"},
      {"arithmetic", "chain"}, {"seed", "7"},      {"time", "0.1"},     {"animation", "w\u00e4lk \"2\""}};
  VisibleSet& set = result.set;
  set.status = {Status::visible,   Status::hidden, Status::visible,
                Status::undecided, Status::hidden, Status::visible};
  set.guarantee = Guarantee::bounds;
  set.eye_on_primitive = true;
  set.witnesses = {
      {2, {{"-123456789012345678901234567890", -70}, {"0", 0}, {"1", 12}}, {{"1", 0}, {"5", -3}, {"-7", 1}}}};
  set.subdivision = {{0, {{-1.5, -0.2, 0}, {0.1, -0.2, 0}, {0.1, 0.7, 0}}, "36/25", 1.44, {0, 2}},
                     {0, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, "1/2", 0.5, {}}};
  set.stats.seconds = 0.125;
  set.stats.cpu_seconds = 0.25;
  set.stats.threads = 2;
  set.stats.nodes = 10;
  set.stats.leaves = 11;
  set.stats.samples = 12;
  set.stats.subtractions = 13;
  set.stats.sampling = {4, 10, 6};
  set.stats.iteration = {30, 70, 40, 36, 7, 3, 2, 8, 0.5};
  set.stats.signs.at(Predicate::turn, Tier::exact) = 123456789012345ULL;
  set.stats.peak_bytes = 14;
  set.stats.checked = true;
  set.stats.signs.wrong_of(Predicate::nearer) = 15;
  return result;
}

}  // namespace provis
