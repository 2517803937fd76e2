#include "provis/point.hpp"

#include "predicates/environment.hpp"
#include "provis/check_doubles.hpp"
#include "provis/effects.hpp"
#include "provis/error.hpp"
#include "src/point/engine_paper.hpp"
#include "src/point/engine_sampling.hpp"
#include "src/scene/on_occluder.hpp"
#include "src/scene/parallel.hpp"
#include "src/scene/require_triangles.hpp"
#include "src/scene/stopwatch.hpp"

namespace provis {
namespace {

constexpr int most_pixels = 16384, most_samples = 256;

FrameEngine choose_engine(const PointOptions& options, QueryEffects effects) {
  if (options.method != Method::exact) return sampling_engine(options.arithmetic);
  if (options.engine == PointEngine::paper) return paper_engine(options.arithmetic);
  switch (options.arithmetic) {
    case Arithmetic::doubles:
      return doubles_engine(effects);
    case Arithmetic::chain:
      return chain_engine(effects);
    case Arithmetic::mpfr:
      return mpfr_engine();
    case Arithmetic::exact:
      return exact_engine();
  }
  throw Error(Error::Code::usage, "arithmetic", "unknown policy");
}

/// What a method claims; plain doubles claim nothing.
Guarantee guarantee_of(const PointOptions& options) {
  if (options.arithmetic == Arithmetic::doubles) return Guarantee::sampled;
  return options.method == Method::exact ? Guarantee::exact : Guarantee::aggressive;
}

void check(const PointOptions& options) {
  const auto refuse = [](const char* place, const char* what) {
    throw Error(Error::Code::usage, place, what);
  };
  if ((options.witnesses || options.subdivision) && options.arithmetic == Arithmetic::doubles)
    refuse("arithmetic", "plain doubles prove no witness and bound no cell");
  if (options.method == Method::exact && options.engine == PointEngine::fast) return;
  if (options.subdivision && options.method != Method::exact)
    refuse("method", "only the exact method makes a subdivision");
  const auto in = [](int n, int most) { return 1 <= n && n <= most; };
  if (!in(options.pixels.width, most_pixels) || !in(options.pixels.height, most_pixels))
    refuse("pixels", "a frame needs 1 to 16384 pixels each way");
  if (!in(options.samples, most_samples)) refuse("samples", "a pixel needs 1 to 256 samples each way");
}

/// A query and how it is answered.
struct Request {
  const Scene& scene;
  const PointView& view;
  const PointOptions& options;
  const Context& context;
  bool checked = false;  ///< plain doubles, with every sign decided exactly too
};

VisibleSet run_frames(const Request& request, FrameEngine engine) {
  const auto& [scene, view, options, context, checked] = request;
  VisibleSet set;
  set.guarantee = guarantee_of(options);
  set.status.assign(scene.primitive_count(),
                    options.method == Method::exact ? Status::hidden : Status::undecided);
  std::vector<std::uint8_t> known(scene.primitive_count(), 0);
  std::vector<Witness> witnesses(options.witnesses ? scene.primitive_count() : 0);
  ProgressMeter progress(context, static_cast<double>(view.frames.size()));

  Outcome total;
  for (std::size_t k = 0; k < view.frames.size(); ++k) {
    const Frame& frame = view.frames[k];
    ViewGeometry geometry = make_geometry(view.eye, frame, view.projection == Projection::parallel);
    geometry.checked = checked;
    Outcome outcome =
        engine(scene, {geometry, static_cast<int>(k), frame.window, options, context, progress}, known);
    for (std::size_t f = 0; f < outcome.found.size(); ++f) {
      const PrimitiveId id = outcome.found[f];
      if (known[id]) continue;
      known[id] = 1;
      set.status[id] = Status::visible;
      if (options.witnesses) witnesses[id] = make_witness(id, geometry, outcome.witnesses[f]);
    }
    outcome.found = {};
    outcome.witnesses = {};
    total.add(std::move(outcome));
  }
  if (options.witnesses)
    for (const PrimitiveId id : set.with(Status::visible)) set.witnesses.push_back(std::move(witnesses[id]));
  set.subdivision = std::move(total.cells);
  set.stats = total.stats;
  return set;
}

VisibleSet answer(const Request& request) {
  const auto& [scene, view, options, context, checked] = request;
  check(view);
  check(options);
  check_environment();
  const EffectsPlan plan = plan_effects(scene, view.projection);
  require_triangles(scene, "from-point queries");
  const FrameEngine engine =
      choose_engine(options, {plan.needs_effect(Effect::see_through), plan.needs_effect(Effect::front_clip)});
  const Stopwatch stopwatch;
  VisibleSet set = on_threads(request.context, [&] { return run_frames(request, engine); });
  set.eye_on_primitive = view.projection != Projection::parallel && on_occluder(scene, view.eye);
  set.stats.threads = thread_count(context);
  set.stats.checked = checked;
  stopwatch.read(set.stats);
  return set;
}

}  // namespace

VisibleSet visible_from_point(const Scene& scene, const PointView& view, const PointOptions& options,
                              const Context& context) {
  return answer({scene, view, options, context});
}

VisibleSet check_doubles(const Scene& scene, const PointView& view, const Context& context) {
  PointOptions options;
  options.arithmetic = Arithmetic::doubles;
  return answer({scene, view, options, context, true});
}

}  // namespace provis
