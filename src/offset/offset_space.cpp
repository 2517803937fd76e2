#include "src/offset/offset_space.hpp"

#include <mutex>

#include "predicates/certain_sign.hpp"
#include "predicates/environment.hpp"
#include "src/offset/descent.hpp"
#include "src/scene/parallel.hpp"
#include "src/scene/stopwatch.hpp"

namespace provis::offset {
namespace {

/// What certain signs cost this thread from here on.
class SignTally {
 public:
  void read(OffsetStats& stats) const {
    stats.signs_interval = certain_signs.interval - before_.interval;
    stats.signs_exact = certain_signs.exact - before_.exact;
  }

 private:
  CertainSigns before_ = certain_signs;
};

Outlook look_out(const Scene& scene, const Seams& seams, const Face& face) {
  const RoundUp guard;
  const SignTally tally;
  const Stopwatch stopwatch;
  Outlook outlook(scene, seams, face);
  outlook.stats.seconds_build = stopwatch.seconds();
  tally.read(outlook.stats);
  return outlook;
}

}  // namespace

UpperSet reach(const Scene& scene, const ViewCell& cell, const std::vector<char>& wanted,
               const PixelGrid& pixels, int refinements, const Context& context, ProgressMeter& meter) {
  const Stopwatch building;
  const Seams seams = on_threads(context, [&] { return Seams(scene); });
  UpperSet set{std::vector<char>(wanted.size(), 0), {}};
  set.stats.seconds_build = building.seconds();
  const std::vector<Face> faces = faces_of(cell);
  std::vector<std::vector<Raster>> rasters;
  double raster_count = 0;
  for (const Face& f : faces) {
    rasters.push_back(rasters_of(cell, f, pixels));
    raster_count += static_cast<double>(rasters.back().size());
  }

  // A face's triangles and edges take much memory: they are made by the thread that first looks out of it.
  std::mutex joining;
  on_threads(context, [&] {
    parallel_queue(faces.size(), [&](std::size_t f) {
      const Outlook outlook = look_out(scene, seams, faces[f]);
      const auto resolve = [&](std::size_t k) {
        const RoundUp guard;
        const SignTally tally;
        Descent descent(outlook, rasters[f][k], wanted, refinements, context);
        descent.run();
        OffsetStats stats = descent.stats();
        tally.read(stats);
        meter.add(1 / raster_count);
        const std::lock_guard lock(joining);
        for (std::size_t id = 0; id < set.reached.size(); ++id) set.reached[id] |= descent.reached()[id];
        set.stats += stats;
      };
      parallel_within([&] { parallel_queue(rasters[f].size(), resolve); });
      const std::lock_guard lock(joining);
      set.stats += outlook.stats;
    });
  });
  return set;
}

}  // namespace provis::offset
