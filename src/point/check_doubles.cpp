// The engine of plain doubles, watched: the same branches, and beside each sign the exact one.

#include "provis/check_doubles.hpp"

#include <chrono>
#include <ctime>

#include "predicates/environment.hpp"
#include "provis/effects.hpp"
#include "provis/error.hpp"
#include "provis/point.hpp"
#include "src/point/engine.hpp"
#include "src/scene/parallel.hpp"

namespace provis {
namespace {

VisibleSet run_frames(const Scene& scene, const PointView& view, FrameEngine engine, const Context& context) {
  PointOptions options;
  options.arithmetic = Arithmetic::doubles;
  VisibleSet set;
  set.guarantee = Guarantee::sampled;
  set.status.assign(scene.primitive_count(), Status::hidden);
  // What one frame finds the next one does not look for: as without the check.
  std::vector<std::uint8_t> known(scene.primitive_count(), 0);
  ProgressMeter progress(context, static_cast<double>(view.frames.size()));
  Outcome total;
  for (std::size_t k = 0; k < view.frames.size(); ++k) {
    const Frame& frame = view.frames[k];
    ViewGeometry geometry = make_geometry(view.eye, frame, view.projection == Projection::parallel);
    geometry.checked = true;
    Outcome outcome =
        engine(scene, {geometry, static_cast<int>(k), frame.window, options, context, progress}, known);
    for (const Found& found : outcome.found) {
      known[found.primitive] = 1;
      set.status[found.primitive] = Status::visible;
    }
    total.add(std::move(outcome));
  }
  set.stats = total.stats;
  return set;
}

}  // namespace

VisibleSet check_doubles(const Scene& scene, const PointView& view, const Context& context) {
  check(view);
  check_environment();
  const EffectsPlan plan = plan_effects(scene, view.projection);
  if (plan.needs_effect(Effect::spheres))
    throw Error(Error::Code::unsupported, "scene", "doubles are checked for triangles only");
  const FrameEngine engine =
      doubles_engine({plan.needs_effect(Effect::see_through), plan.needs_effect(Effect::front_clip)});
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu_start = std::clock();
  VisibleSet set = on_threads(context, [&] { return run_frames(scene, view, engine, context); });
  set.stats.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  set.stats.cpu_seconds = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
  set.stats.threads = thread_count(context);
  set.stats.checked = true;
  return set;
}

}  // namespace provis
