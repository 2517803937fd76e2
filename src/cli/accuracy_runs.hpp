#pragma once
// The runs of `provis accuracy`: each way to answer is a child of its own, so that one that fails harms no
// other.

#include <string>
#include <vector>

#include "provis/scene.hpp"
#include "src/cli/limited_child.hpp"
#include "src/report/accuracy.hpp"

namespace provis {

struct Run;

/// What is asked, and how often.
struct AccuracyPlan {
  std::vector<std::string>
      query;  ///< what follows "provis point": the scene, and the options of scene and view
  Limits limits;
  int runs = 1;
  int threads = 0;
};

/// Every arithmetic policy, then every sampled method, the coarsest grid of samples first.
std::vector<Way> all_ways();

/// Runs the ways in turn, as often as planned, then the two that only serve to judge: doubles with every sign
/// checked, and the exact subdivision.
///
/// Input:      header: the scene and the view, which the children load again
/// Throws:     Error::cancelled; whatever else happens to a child is in the report
AccuracyReport run_accuracy(const AccuracyPlan& plan, const ResultHeader& header, const Scene& scene,
                            Run& run);

}  // namespace provis
