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
  std::string command;             ///< of the program: "point", "segment", "cell"
  std::vector<std::string> query;  ///< what follows it: the scene, and the options of scene and view
  std::vector<Way> ways;
  Limits limits;
  int runs = 1;
  int threads = 0;
};

/// Runs the ways in turn, as often as planned, then the two that only serve to judge: doubles with every sign
/// checked and, from a point, the exact subdivision. From a cell there are none, and all proofs together are
/// what each way is held against.
///
/// Input:      header: the scene and the query, which the children load again
/// Throws:     Error::cancelled; Error::internal if proofs contradict each other; whatever else happens to a
/// child is in the report
AccuracyReport run_accuracy(const AccuracyPlan& plan, const ResultHeader& header, const Scene& scene,
                            Run& run);

}  // namespace provis
