#pragma once
// The facets of a small rectangle in the order in which they can hide each other.

#include <algorithm>
#include <cmath>
#include <vector>

#include "src/point/facets.hpp"

namespace provis {

struct OrderedFacet {
  std::uint32_t facet = 0;
  double nearest = 0;  ///< no hit of it in the rectangle has a greater depth
};

/// Occluders first, by the nearest that they may come; what does not occlude follows.
inline std::vector<OrderedFacet> front_to_back(const std::vector<Facet>& facets,
                                               const std::vector<std::uint32_t>& members, const Window& w) {
  std::vector<OrderedFacet> order;
  order.reserve(members.size());
  for (const std::uint32_t m : members) {
    const Facet& f = facets[m];
    const double nearest = f.depth.highest(intersection(f.box, w));
    order.push_back({m, nearest == nearest ? nearest : HUGE_VAL});
  }
  std::sort(order.begin(), order.end(), [&](const OrderedFacet& a, const OrderedFacet& b) {
    const bool first = facets[a.facet].occludes, second = facets[b.facet].occludes;
    if (first != second) return first;
    return a.nearest != b.nearest ? a.nearest > b.nearest : a.facet < b.facet;
  });
  return order;
}

}  // namespace provis
