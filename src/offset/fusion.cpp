#include "src/offset/fusion.hpp"

#include <algorithm>

namespace provis::offset {

Mesh::Mesh(std::span<const Facet> facets, const Seams& seams) {
  struct Run {
    std::uint32_t from, to, facet, place;
    int way;
  };
  std::vector<Run> runs;
  first_.push_back(0);
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    std::uint32_t place = first_.back();
    const auto run = [&](std::uint32_t from, std::uint32_t to, int way) {
      runs.push_back({from, to, f, place++, way});
    };
    for (std::size_t k = 0; k < 3 && facets[f].occludes; ++k) {
      const std::uint32_t a = facets[f].v[k], b = facets[f].v[(k + 1) % 3];
      const int way = a < b ? 1 : -1;
      std::uint32_t last = std::min(a, b);
      for (const std::uint32_t m : seams.inside(facets[f].id, facets[f].edge[k])) {
        run(last, m, way);
        last = m;
      }
      run(last, std::max(a, b), way);
    }
    first_.push_back(place);
  }
  std::sort(runs.begin(), runs.end(), [](const Run& r, const Run& s) {
    return r.from != s.from ? r.from < s.from : r.to != s.to ? r.to < s.to : r.place < s.place;
  });
  edges_of_.resize(runs.size());
  for (const Run& r : runs) {
    if (edges_.empty() || edges_.back().v[0] != r.from || edges_.back().v[1] != r.to)
      edges_.push_back({{&seams.position(r.from), &seams.position(r.to)},
                        {r.from, r.to},
                        static_cast<std::uint32_t>(halves_.size()),
                        0});
    ++edges_.back().count;
    halves_.push_back({r.facet, r.way});
    edges_of_[r.place] = static_cast<std::uint32_t>(edges_.size() - 1);
  }
}

void Fusion::add(std::uint32_t facet) {
  members_.push_back(facet);
  for (const std::uint32_t e : mesh_.edges_of(facet)) {
    for (const Mesh::Half& h : mesh_.halves(e))
      if (h.facet == facet) net_[e] += h.way;
    touched_.push_back(e);
  }
}

}  // namespace provis::offset
