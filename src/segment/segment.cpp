// The front door: checks what is asked, runs the frames one after another, adds up what they saw.

#include "provis/segment.hpp"

#include <cmath>

#include "predicates/approx.hpp"
#include "predicates/environment.hpp"
#include "predicates/for_policy.hpp"
#include "provis/check_doubles.hpp"
#include "provis/error.hpp"
#include "src/scene/on_occluder.hpp"
#include "src/scene/parallel.hpp"
#include "src/scene/progress_meter.hpp"
#include "src/scene/require_triangles.hpp"
#include "src/scene/stopwatch.hpp"
#include "src/segment/frame_task.hpp"
#include "src/segment/tally.hpp"
#include "src/segment/witnesses.hpp"

namespace provis {
namespace {

[[noreturn]] void refuse(const char* place, const std::string& what) {
  throw Error(Error::Code::usage, place, what);
}

constexpr int most_pixels = 16384;

FrameEngine choose_engine(const SegmentOptions& options) {
  return for_policy(options.arithmetic, [&]<Arithmetic A>() -> FrameEngine {
    return options.engine == SegmentEngine::fast ? &resolve_frame_fast<A> : &resolve_frame_plain<A>;
  });
}

SegmentSet run(const Scene& scene, const SegmentView& view, const SegmentOptions& options,
               const Context& context, bool checked) {
  const FrameEngine engine = choose_engine(options);
  const ClusterTree tree(scene);
  const double reach = std::max({tree.reach(), largest(view.from), largest(view.to)});
  const BlockedTimes blocked(scene, view.from, view.to);
  const auto frames = static_cast<double>(view.frames.size());
  ProgressMeter meter(context, frames);
  Tally tally(scene.primitive_count());
  for (std::size_t k = 0; k < view.frames.size(); ++k) {
    if (options.only && options.only->frame != static_cast<int>(k)) continue;
    const PathGeometry path{view.from, view.to, view.frames[k], view.pixels, checked};
    const PathProjection projection(path, reach);
    const int frame = static_cast<int>(k);
    engine({scene, path, projection, blocked, &tree, options, context, frame,
            [&](BlockOutcome&& outcome) { tally.add(frame, outcome); },
            [&](double share) { meter.add(share); }});
  }
  SegmentSet set;
  tally.report(set);
  set.set.stats.signs = tally.signs();
  if (options.witnesses)
    set.set.witnesses = make_witnesses(scene, view, tree, blocked, tally.glimpses(), context);
  meter.add(frames);  // shares are rounded
  return set;
}

void check(const PixelRow& only, const SegmentView& view) {
  const auto frames = static_cast<int>(view.frames.size());
  if (only.frame < 0 || only.frame >= frames)
    refuse("frame", "is " + std::to_string(only.frame) + ", of " + std::to_string(frames));
  if (only.row < 0 || only.row >= view.pixels.height)
    refuse("row", "is " + std::to_string(only.row) + ", of " + std::to_string(view.pixels.height));
}

}  // namespace

BlockTask FrameTask::block(const PixelRect& area) const {
  const auto threads = static_cast<std::uint64_t>(thread_count(context));
  const std::uint64_t share =
      options.memory_bytes == 0 ? 0 : std::max<std::uint64_t>(1, options.memory_bytes / threads);
  return {scene, path, blocked, frame, area, static_cast<bool>(options.on_pixel), options.witnesses, share};
}

void check(const SegmentView& view) {
  for (const auto& [place, point] : {std::pair("from", view.from), std::pair("to", view.to)})
    if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z))
      refuse(place, "not finite");
  if (view.frames.empty()) refuse("view", "has no frame");
  for (const Frame& f : view.frames) check(PointView{view.from, Projection::pinhole, {f}});
  const auto out = [](int n) { return n < 1 || n > most_pixels; };
  if (out(view.pixels.width) || out(view.pixels.height)) refuse("size", "each way 1 to 16384 pixels");
}

namespace {

SegmentSet answer(const Scene& scene, const SegmentView& view, const SegmentOptions& options,
                  const Context& context, bool checked) {
  check(view);
  if (options.only) check(*options.only, view);
  if (options.witnesses && options.arithmetic == Arithmetic::doubles)
    refuse("witnesses", "plain doubles prove nothing");
  require_triangles(scene, "from-segment queries");
  check_environment();
  const Stopwatch stopwatch;
  SegmentSet set = on_threads(context, [&] { return run(scene, view, options, context, checked); });
  set.set.answers = "R10";
  set.set.guarantee = options.arithmetic == Arithmetic::doubles ? Guarantee::sampled : Guarantee::exact;
  set.set.eye_on_primitive = view.from == view.to && on_occluder(scene, view.from);
  set.set.stats.threads = thread_count(context);
  set.set.stats.checked = checked;
  stopwatch.read(set.set.stats);
  return set;
}

}  // namespace

SegmentSet visible_from_segment(const Scene& scene, const SegmentView& view, const SegmentOptions& options,
                                const Context& context) {
  return answer(scene, view, options, context, false);
}

SegmentSet check_doubles(const Scene& scene, const SegmentView& view, const Context& context) {
  SegmentOptions options;
  options.arithmetic = Arithmetic::doubles;
  return answer(scene, view, options, context, true);
}

}  // namespace provis
