// The front door: checks what is asked, runs the frames one after another, adds up what they saw.

#include "provis/segment.hpp"

#include <chrono>
#include <cmath>
#include <ctime>
#include <mutex>
#include <optional>

#include "predicates/environment.hpp"
#include "predicates/on_triangle.hpp"
#include "provis/error.hpp"
#include "src/scene/parallel.hpp"
#include "src/segment/frame_task.hpp"
#include "src/segment/tally.hpp"
#include "src/segment/witnesses.hpp"

namespace provis {
namespace {

[[noreturn]] void refuse(const char* place, const std::string& what) {
  throw Error(Error::Code::usage, place, what);
}

constexpr int most_pixels = 16384;

template <template <Arithmetic> class Make>
FrameEngine for_policy(Arithmetic arithmetic) {
  switch (arithmetic) {
    case Arithmetic::doubles:
      return Make<Arithmetic::doubles>::engine;
    case Arithmetic::chain:
      return Make<Arithmetic::chain>::engine;
    case Arithmetic::mpfr:
      return Make<Arithmetic::mpfr>::engine;
    case Arithmetic::exact:
      return Make<Arithmetic::exact>::engine;
  }
  refuse("arithmetic", "unknown policy");
}

template <Arithmetic A>
struct Fast {
  static constexpr FrameEngine engine = &resolve_frame_fast<A>;
};

template <Arithmetic A>
struct Plain {
  static constexpr FrameEngine engine = &resolve_frame_plain<A>;
};

double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double largest_coordinate(const Vec3d& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

bool lies_on_occluder(const Scene& scene, const Vec3d& eye) {
  for (std::size_t t = 0; t < scene.triangles().size(); ++t)
    if (!(scene.triangle_flags()[t] & see_through) &&
        on_triangle(eye, scene.corner(t, 0), scene.corner(t, 1), scene.corner(t, 2)))
      return true;
  return false;
}

/// Says how far a query has come, from one thread at a time.
class Meter {
 public:
  Meter(const Context& context, double total) : context_(context), total_(total) {}
  void add(double share) {
    if (!context_.on_progress) return;
    const std::lock_guard lock(mutex_);
    done_ = std::min(total_, done_ + share);
    context_.on_progress({done_, total_});
  }
  void finish() { add(total_); }

 private:
  const Context& context_;
  double total_, done_ = 0;
  std::mutex mutex_;
};

SegmentSet run(const Scene& scene, const SegmentView& view, const SegmentOptions& options,
               const Context& context) {
  const bool fast = options.engine == SegmentEngine::fast;
  const FrameEngine engine =
      fast ? for_policy<Fast>(options.arithmetic) : for_policy<Plain>(options.arithmetic);
  const ClusterTree tree(scene);
  const double reach = std::max({tree.reach(), largest_coordinate(view.from), largest_coordinate(view.to)});
  const BlockedTimes blocked(scene, view.from, view.to);
  Meter meter(context, static_cast<double>(view.frames.size()));
  Tally tally(scene.primitive_count());
  for (std::size_t k = 0; k < view.frames.size(); ++k) {
    const PathGeometry path{view.from, view.to, view.frames[k], view.pixels};
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
  meter.finish();
  return set;
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

SegmentSet visible_from_segment(const Scene& scene, const SegmentView& view, const SegmentOptions& options,
                                const Context& context) {
  check(view);
  if (options.witnesses && options.arithmetic == Arithmetic::doubles)
    refuse("witnesses", "plain doubles prove nothing");
  if (!scene.spheres().empty())
    throw Error(Error::Code::unsupported, "scene",
                "spheres are not handled by from-segment queries: " + std::to_string(scene.spheres().size()) +
                    " of them");
  check_environment();
  const auto wall = std::chrono::steady_clock::now();
  const double cpu = cpu_seconds();
  SegmentSet set = on_threads(context, [&] { return run(scene, view, options, context); });
  set.set.answers = "R10";
  set.set.guarantee = options.arithmetic == Arithmetic::doubles ? Guarantee::sampled : Guarantee::exact;
  set.set.eye_on_primitive = view.from == view.to && lies_on_occluder(scene, view.from);
  set.set.stats.threads = thread_count(context);
  set.set.stats.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
  set.set.stats.cpu_seconds = cpu_seconds() - cpu;
  return set;
}

}  // namespace provis
