#include "src/report/cell_query.hpp"

#include <fmt/format.h>

namespace provis {

std::vector<CellCount> counts_of(CellCounts& counts) {
  BoundStats& b = counts.bounds;
  OffsetStats& o = counts.offset;
  DetailStats& d = counts.detail;
  return {{"touching", &b.touching},
          {"viewpoints", &b.viewpoints},
          {"paths", &b.paths},
          {"samples", &b.samples},
          {"rays", &b.rays},
          {"boundary", &b.boundary},
          {"viewpoints_used", &b.viewpoints_used},
          {"paths_used", &b.paths_used},
          {"samples_used", &b.samples_used},
          {"rasters", &o.rasters},
          {"beams", &o.beams},
          {"lists", &o.lists},
          {"list_entries", &o.list_entries},
          {"list_most", &o.list_most},
          {"early_hidden", &o.early_hidden},
          {"resolved", &o.resolved},
          {"resolved_hidden", &o.resolved_hidden},
          {"refined", &o.refined},
          {"kept_seen", &o.kept_seen},
          {"kept_nothing_between", &o.kept_nothing_between},
          {"kept_open_edge", &o.kept_open_edge},
          {"kept_unusable", &o.kept_unusable},
          {"kept_too_many", &o.kept_too_many},
          {"facing_unknown", &o.facing_unknown},
          {"signs_interval", &o.signs_interval},
          {"signs_exact", &o.signs_exact},
          {"detail_objects", &d.objects},
          {"detail_candidates", &d.candidates},
          {"detail_whole", &d.whole},
          {"detail_dropped", &d.dropped},
          {"detail_triangles", &d.triangles}};
}

std::vector<CellSeconds> seconds_of(CellCounts& counts) {
  BoundStats& b = counts.bounds;
  OffsetStats& o = counts.offset;
  return {{"viewpoints", &b.seconds_viewpoints},
          {"paths", &b.seconds_paths},
          {"samples", &b.seconds_samples},
          {"upper", &b.seconds_upper},
          {"rays", &b.seconds_rays},
          {"verification", &counts.detail.seconds_verification},
          {"build", &o.seconds_build},
          {"lists", &o.seconds_lists},
          {"early_z", &o.seconds_early_z},
          {"resolve", &o.seconds_resolve}};
}

std::string cell_table(CellCounts counts) {
  std::string text;
  for (const CellCount& c : counts_of(counts)) text += fmt::format("{:<22}{:>14}\n", c.name, *c.value);
  text += fmt::format("{:<22}{:>14.2f}\n", "list_average", counts.offset.list_average());
  for (const CellSeconds& s : seconds_of(counts))
    text += fmt::format("{:<22}{:>14.3f} s\n", s.name, *s.value);
  return text;
}

PointView center_view(const ViewCell& cell) {
  const Vec3d center = 0.5 * cell.lower + 0.5 * cell.upper;
  if (!cell.window) return omni(center);
  return {center, Projection::pinhole, {*cell.window}};
}

}  // namespace provis
