#include "provis/cell.hpp"

#include <algorithm>
#include <cmath>

#include "predicates/environment.hpp"
#include "provis/error.hpp"
#include "provis/level_of_detail.hpp"
#include "provis/point.hpp"
#include "src/lod/coarse_upper.hpp"
#include "src/lod/parts.hpp"
#include "src/offset/offset_space.hpp"
#include "src/region/contact.hpp"
#include "src/region/covered_cell.hpp"
#include "src/region/exact_samples.hpp"
#include "src/region/face_parts.hpp"
#include "src/region/lower.hpp"
#include "src/region/viewpoints.hpp"
#include "src/scene/parallel.hpp"
#include "src/scene/require_triangles.hpp"
#include "src/scene/stopwatch.hpp"

namespace provis {
namespace {

constexpr int most_pixels = 1024, most_viewpoints = 65536, most_directions = 256, most_refinements = 32,
              most_rays = 1'000'000;

[[noreturn]] void refuse(const char* place, const char* what) {
  throw Error(Error::Code::usage, place, what);
}

void check(const CellOptions& o) {
  const auto in = [](int n, int least, int most) { return least <= n && n <= most; };
  if (!in(o.pixels.width, 1, most_pixels) || !in(o.pixels.height, 1, most_pixels))
    refuse("cos-size", "a raster needs 1 to 1024 pixels each way");
  if (!in(o.refinements, 0, most_refinements)) refuse("refinements", "0 to 32");
  if (!in(o.viewpoints, 0, most_viewpoints)) refuse("viewpoints", "0 to 65536");
  if (!in(o.path_pixels, 0, most_pixels)) refuse("path-pixels", "0 to 1024");
  if (!in(o.directions, 0, most_directions)) refuse("directions", "0 to 256");
  if (!in(o.rays, 0, most_rays)) refuse("rays", "0 to 1000000");
}

void check_detail(const Scene& scene, const CellOptions& o) {
  if (!o.detail) return;
  if (o.method != CellMethod::bounds && o.method != CellMethod::cos)
    refuse("level of detail", "only 'bounds' and 'cos' have an upper set");
  if (o.detail->parts().full->hash() != scene.hash())
    refuse("level of detail", "it belongs to another scene");
}

/// One query on its way to the answer.
class Query {
 public:
  Query(const Scene& scene, const ViewCell& cell, const CellOptions& options, const Context& context)
      : scene_(scene),
        cell_(cell),
        options_(options),
        context_(context),
        lower_(scene, cell, context),
        meter_(context, options.method == CellMethod::bounds  ? 5
                        : options.method == CellMethod::lower ? 3
                                                              : 1) {}

  CellSet answer();

 private:
  void settle_contacts();
  void find_lower();
  void find_upper();
  offset::UpperSet upper_set(std::vector<char> wanted);
  void aim_at_undecided();
  void conclude();
  void take_samples();
  void count();

  const Scene& scene_;
  const ViewCell& cell_;
  const CellOptions& options_;
  const Context& context_;
  LowerSet lower_;
  ProgressMeter meter_;  ///< one for viewpoints, paths, samples, the offset space and rays each
  std::vector<Contact> contacts_;
  CellSet result_;
};

void Query::settle_contacts() {
  contacts_.assign(scene_.primitive_count(), Contact::apart);
  on_threads(context_, [&] {
    parallel_for(scene_.triangles().size(), [&](std::size_t t) {
      if (context_.cancelled()) throw Error(Error::Code::cancelled, "cell", "interrupted");
      const RoundUp guard;
      contacts_[t] = contact(scene_, t, cell_);
    });
  });
}

void Query::find_lower() {
  const Stopwatch looking;
  const std::vector<Vec3d> viewpoints = free_viewpoints(scene_, cell_, options_.viewpoints, options_.seed);
  BoundStats& b = result_.bounds;
  b.viewpoints_used = viewpoints.size();
  b.viewpoints = lower_.look_from(viewpoints, meter_);
  b.seconds_viewpoints = looking.seconds();
  const Stopwatch along;
  b.paths = lower_.look_along_paths(options_.path_pixels, b.paths_used, meter_);
  b.seconds_paths = along.seconds();
  const Stopwatch sampling;
  b.samples = lower_.look_along(options_.directions, b.samples_used, meter_);
  b.seconds_samples = sampling.seconds();
}

void Query::find_upper() {
  const Stopwatch stopwatch;
  std::vector<char> wanted(scene_.primitive_count(), 0);
  for (PrimitiveId id = 0; id < wanted.size(); ++id)
    wanted[id] = contacts_[id] == Contact::apart && !lower_.holds(id);
  const offset::UpperSet upper = upper_set(std::move(wanted));
  for (PrimitiveId id = 0; id < upper.reached.size(); ++id)
    result_.set.status[id] = upper.reached[id] ? Status::undecided : Status::hidden;
  result_.offset = upper.stats;
  result_.bounds.seconds_upper = stopwatch.seconds();
}

offset::UpperSet Query::upper_set(std::vector<char> wanted) {
  if (!options_.detail)
    return offset::reach(scene_, cell_, wanted, options_.pixels, options_.refinements, context_, meter_);
  std::vector<char> seen(wanted.size(), 0);
  for (PrimitiveId id = 0; id < seen.size(); ++id) seen[id] = lower_.holds(id);
  lod::CoarseUpper upper = lod::reach(*options_.detail, cell_, {std::move(wanted), std::move(seen)},
                                      options_.pixels, options_.refinements, context_, meter_);
  result_.detail = upper.counts;
  return {std::move(upper.reached), upper.stats};
}

/// What is not proven hidden may just not have been found.
void Query::aim_at_undecided() {
  const Stopwatch stopwatch;
  const std::vector<PrimitiveId> open = result_.set.with(Status::undecided);
  BoundStats& b = result_.bounds;
  b.rays = lower_.aim_at(open, options_.rays, options_.seed, meter_);
  b.seconds_rays = stopwatch.seconds();
}

/// What R9 settles, then what has a witness.
void Query::conclude() {
  std::vector<Status>& status = result_.set.status;
  BoundStats& b = result_.bounds;
  std::vector<PrimitiveId> close;
  for (PrimitiveId id = 0; id < status.size(); ++id) {
    if (lower_.holds(id)) status[id] = Status::visible;
    if (contacts_[id] != Contact::visible) continue;
    status[id] = Status::visible;
    ++b.touching;
    if (!lower_.holds(id)) close.push_back(id);
  }
  lower_.look_at_contacts(close);
  for (PrimitiveId id = 0; id < status.size(); ++id)
    if (contacts_[id] == Contact::visible && !lower_.holds(id)) result_.unwitnessed.push_back(id);
  b.unwitnessed = result_.unwitnessed.size();
  for (PrimitiveId id = 0; id < status.size(); ++id)
    if (status[id] == Status::visible && lower_.holds(id))
      result_.set.witnesses.push_back(*lower_.witnesses()[id]);
  count();
  result_.set.stats = lower_.stats();
  Guarantee& g = result_.set.guarantee;
  switch (options_.method) {
    case CellMethod::lower:
      g = Guarantee::aggressive;
      break;
    case CellMethod::cos:
      g = Guarantee::conservative;
      break;
    case CellMethod::bounds:
    case CellMethod::cos_exact:
      g = b.undecided == 0 ? Guarantee::exact : Guarantee::bounds;
  }
}

void Query::count() {
  const std::vector<Status>& status = result_.set.status;
  const auto all = [&](Status s) {
    return static_cast<std::uint64_t>(std::count(status.begin(), status.end(), s));
  };
  result_.bounds.undecided = all(Status::undecided);
  result_.bounds.hidden = all(Status::hidden);
}

/// R10 instead of R9.
void Query::take_samples() {
  const std::vector<offset::Face> faces = offset::faces_of(cell_);
  if (!std::all_of(faces.begin(), faces.end(), has_area))
    throw Error(Error::Code::unsupported, "cell",
                "its camera offsets have no area: two of its edges need a length, or ask along a segment");
  const Stopwatch stopwatch;
  ExactSamples samples(scene_, cell_, context_);
  BoundStats& b = result_.bounds;
  b.samples_used = samples.look(options_.pixels, meter_);
  VisibleSet& set = result_.set;
  for (PrimitiveId id = 0; id < set.status.size(); ++id) {
    set.status[id] = samples.shows(id) ? Status::visible : Status::hidden;
    if (!samples.shows(id)) continue;
    if (samples.proof(id))
      set.witnesses.push_back(*samples.proof(id));
    else
      result_.boundary.push_back(id);
  }
  set.answers = "R10";
  set.stats = samples.stats();
  count();
  b.samples = set.witnesses.size();
  b.boundary = result_.boundary.size();
  b.seconds_samples = stopwatch.seconds();
}

CellSet Query::answer() {
  const Stopwatch stopwatch;
  result_.set.answers = "R9";
  result_.set.status.assign(scene_.primitive_count(), Status::undecided);
  if (options_.method == CellMethod::cos_exact) {
    take_samples();
  } else {
    if (lies_on_occluders(scene_, cell_))
      throw Error(Error::Code::unsupported, "cell", "all of it lies on occluders: it has no viewpoint");
    settle_contacts();
    if (options_.method != CellMethod::cos) find_lower();
    if (options_.method != CellMethod::lower) find_upper();
    if (options_.method == CellMethod::bounds) aim_at_undecided();
    conclude();
  }
  result_.set.stats.threads = thread_count(context_);
  stopwatch.read(result_.set.stats);
  return std::move(result_);
}

CellSet from_point(const Scene& scene, const ViewCell& cell, const Context& context) {
  PointOptions options;
  options.witnesses = true;
  CellSet result;
  result.set = visible_from_point(scene, view_from(cell, cell.lower), options, context);
  result.set.answers = "R9";
  result.bounds.viewpoints = result.set.witnesses.size();
  result.bounds.viewpoints_used = 1;
  result.bounds.hidden = scene.primitive_count() - result.set.witnesses.size();
  return result;
}

}  // namespace

OffsetStats& OffsetStats::operator+=(const OffsetStats& o) {
  rasters += o.rasters;
  beams += o.beams;
  lists += o.lists;
  list_entries += o.list_entries;
  list_most = std::max(list_most, o.list_most);
  early_hidden += o.early_hidden;
  resolved += o.resolved;
  resolved_hidden += o.resolved_hidden;
  refined += o.refined;
  kept_seen += o.kept_seen;
  kept_nothing_between += o.kept_nothing_between;
  kept_open_edge += o.kept_open_edge;
  kept_unusable += o.kept_unusable;
  kept_too_many += o.kept_too_many;
  facing_unknown += o.facing_unknown;
  signs_interval += o.signs_interval;
  signs_exact += o.signs_exact;
  seconds_build += o.seconds_build;
  seconds_lists += o.seconds_lists;
  seconds_early_z += o.seconds_early_z;
  seconds_resolve += o.seconds_resolve;
  return *this;
}

double OffsetStats::list_average() const {
  return lists == 0 ? 0 : static_cast<double>(list_entries) / static_cast<double>(lists);
}

ViewCell cell_around(const Vec3d& center, const Vec3d& edges) {
  return {center - 0.5 * edges, center + 0.5 * edges, {}};
}

void check(const ViewCell& cell) {
  const auto ordered = [](double lo, double hi) {
    return std::isfinite(lo) && std::isfinite(hi) && lo <= hi;
  };
  if (!ordered(cell.lower.x, cell.upper.x) || !ordered(cell.lower.y, cell.upper.y) ||
      !ordered(cell.lower.z, cell.upper.z))
    refuse("cell", "corners must be finite, and the lower one nowhere above the upper one");
  if (cell.window) check(PointView{cell.lower, Projection::pinhole, {*cell.window}});
}

CellSet visible_from_cell(const Scene& scene, const ViewCell& cell, const CellOptions& options,
                          const Context& context) {
  check(cell);
  check(options);
  check_environment();
  require_triangles(scene, "cell queries");
  check_detail(scene, options);
  if (cell.lower == cell.upper && options.method != CellMethod::cos_exact)
    return from_point(scene, cell, context);
  return Query(scene, cell, options, context).answer();
}

}  // namespace provis
