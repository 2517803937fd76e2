#include "src/point/patch.hpp"

#include <algorithm>

namespace provis {

void Patch::clear() {
  members_.clear();
  edges_.clear();
}

void Patch::add(std::uint32_t facet, const Window& rectangle) {
  const Facet& f = facets_[facet];
  if (!overlap(f.box, rectangle)) return;
  bool open[3];
  for (int k = 0; k < 3; ++k) {
    if (f.inside[k].highest(rectangle) < 0) return;
    open[k] = !(f.inside[k].lowest(rectangle) > 0);
  }
  const auto member = static_cast<std::uint32_t>(members_.size());
  members_.push_back({facet, member, f.depth.lowest(rectangle)});
  for (int k = 0; k < 3; ++k)
    if (open[k]) {
      const std::uint64_t from = f.points[k], to = f.points[(k + 1) % 3];
      edges_.push_back({std::min(from, to) << 32 | std::max(from, to), member, from < to});
    }
}

std::uint32_t Patch::root(std::uint32_t m) {
  while (members_[m].patch != m) m = members_[m].patch = members_[members_[m].patch].patch;
  return m;
}

/// Takes out the facets of edges that have no partner; whether there were any. Edges are sorted.
bool Patch::drop_unmatched() {
  bool dropped = false;
  for (std::size_t begin = 0, end; begin < edges_.size(); begin = end) {
    end = begin;
    std::size_t forth = 0;
    for (; end < edges_.size() && edges_[end].ends == edges_[begin].ends; ++end) forth += edges_[end].forth;
    if (2 * forth == end - begin) continue;
    for (std::size_t e = begin; e < end; ++e) members_[edges_[e].member].kept = false;
    dropped = true;
  }
  if (dropped) std::erase_if(edges_, [&](const Edge& e) { return !members_[e.member].kept; });
  return dropped;
}

/// Joins what shares an edge, once every edge has its partner.
void Patch::connect() {
  for (std::size_t e = 1; e < edges_.size(); ++e) {
    if (edges_[e].ends != edges_[e - 1].ends) continue;
    const std::uint32_t a = root(edges_[e - 1].member), b = root(edges_[e].member);
    members_[a].patch = b;
    members_[b].depth = std::min(members_[a].depth, members_[b].depth);
  }
}

bool Patch::holds_a_ray(const Facet& f, const Window& r) const {
  const Window both = intersection(f.box, r);
  for (const double s : {0.5, 0.25, 0.75, 0.0, 1.0})
    for (const double t : {0.5, 0.25, 0.75, 0.0, 1.0}) {
      const double x = std::clamp(both.x0 + s * (both.x1 - both.x0), r.x0, r.x1);
      const double y = std::clamp(both.y0 + t * (both.y1 - both.y0), r.y0, r.y1);
      if (std::all_of(std::begin(f.inside), std::end(f.inside),
                      [&](const WindowFunction& e) { return e.at(x, y) > e.error; }))
        return true;
    }
  return false;
}

double Patch::cover(const Window& rectangle) {
  std::sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) { return a.ends < b.ends; });
  while (drop_unmatched()) {
  }
  connect();
  double best = -HUGE_VAL;
  for (std::uint32_t m = 0; m < members_.size(); ++m) {
    const double depth = members_[root(m)].depth;
    if (members_[m].kept && depth > best && holds_a_ray(facets_[members_[m].facet], rectangle)) best = depth;
  }
  return best;
}

}  // namespace provis
