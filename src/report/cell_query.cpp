#include "src/report/cell_query.hpp"

#include "provis/result_file.hpp"

namespace provis {

std::vector<CellCount> counts_of(BoundStats& b, OffsetStats& o) {
  return {{"touching", &b.touching},
          {"viewpoints", &b.viewpoints},
          {"samples", &b.samples},
          {"viewpoints_used", &b.viewpoints_used},
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
          {"kept_nothing_between", &o.kept_nothing_between},
          {"kept_open_edge", &o.kept_open_edge},
          {"kept_unusable", &o.kept_unusable},
          {"kept_too_many", &o.kept_too_many},
          {"facing_unknown", &o.facing_unknown}};
}

PointView center_view(const ViewCell& cell) {
  const Vec3d center = 0.5 * cell.lower + 0.5 * cell.upper;
  if (!cell.window) return omni(center);
  return {center, Projection::pinhole, {*cell.window}};
}

}  // namespace provis
