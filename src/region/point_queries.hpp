#pragma once
// From-point queries as a part of a larger one.

#include "provis/point.hpp"

namespace provis {

/// Exact sets of one scene, and what they cost together.
class PointQueries {
 public:
  PointQueries(const Scene& scene, const Context& context) : scene_(scene), context_(context) {
    context_.on_progress = nullptr;  // progress is that of the larger query
  }

  VisibleSet ask(const PointView& view, bool witnesses) {
    PointOptions options;
    options.witnesses = witnesses;
    VisibleSet set = visible_from_point(scene_, view, options, context_);
    stats_.signs += set.stats.signs;
    stats_.nodes += set.stats.nodes;
    stats_.leaves += set.stats.leaves;
    stats_.samples += set.stats.samples;
    stats_.subtractions += set.stats.subtractions;
    return set;
  }

  const Context& context() const { return context_; }

  /// Times and threads are left out.
  const QueryStats& stats() const { return stats_; }

 private:
  const Scene& scene_;
  Context context_;
  QueryStats stats_;
};

}  // namespace provis
