// From-point sampling: what is seen at pixel centres from viewpoints along the path.

#include "predicates/environment.hpp"
#include "provis/error.hpp"
#include "provis/segment.hpp"
#include "src/scene/parallel.hpp"
#include "src/scene/require_triangles.hpp"
#include "src/scene/stopwatch.hpp"
#include "src/segment/viewpoint_sampling.hpp"

namespace provis {

SegmentSet sampled_along_segment(const Scene& scene, const SegmentView& view, int viewpoints,
                                 const Context& context) {
  check(view);
  if (viewpoints < 1) throw Error(Error::Code::usage, "viewpoints", "one or more");
  require_triangles(scene, "from-segment queries");
  check_environment();
  const Stopwatch stopwatch;
  const auto along = [&](std::size_t k) {
    const double t = (static_cast<double>(k) + 0.5) / viewpoints;
    return view.from + t * (view.to - view.from);
  };
  SegmentSet set;
  set.set.status = sampled_from_viewpoints(scene, static_cast<std::size_t>(viewpoints), along, view.frames,
                                           view.pixels, "segment", context);
  set.boundary = set.set.with(Status::visible);
  set.set.answers = "R10";
  set.set.guarantee = Guarantee::sampled;
  set.set.stats.threads = thread_count(context);
  stopwatch.read(set.set.stats);
  return set;
}

}  // namespace provis
