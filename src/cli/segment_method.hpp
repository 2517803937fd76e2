#pragma once
// The options that say how `provis segment` finds its answer.

#include <map>
#include <string>
#include <vector>

#include "provis/segment.hpp"

namespace CLI {
class App;
}

namespace provis {

struct SegmentMethod {
  std::string method = "exact", viewpoints, engine = "fast", arithmetic = "chain", threads = "0",
              memory = "0";
  bool check = false;

  void add_to(CLI::App& command);

  /// asked: options of output that were given, of those that need an exact answer or the time between
  /// viewpoints. Throws Error::usage where options do not go together.
  void validate(const std::vector<std::string>& asked) const;

  int thread_count() const;

  /// What can change the set.
  void record(std::map<std::string, std::string>& options) const;

  /// options: what is asked beside the set; how it is found is added.
  SegmentSet answer(const Scene& scene, const SegmentView& view, SegmentOptions options,
                    const Context& context) const;

 private:
  bool sampled() const { return method == "sampled"; }
};

}  // namespace provis
