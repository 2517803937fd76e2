#include "provis/topology.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <utility>
#include <vector>

#include "predicates/zero_area.hpp"
#include "src/scene/failure.hpp"
#include "src/scene/grouped.hpp"
#include "src/scene/parallel.hpp"
#include "src/scene/position_hash.hpp"

namespace provis {
namespace {

using Corners = std::array<std::uint32_t, 3>;  ///< ascending; three equal ones for a degenerate triangle

/// For each vertex one vertex of the same position, the same for all of them. Which one it is depends on
/// which thread came first; nothing that is counted does.
std::vector<std::uint32_t> equal_vertices(std::span<const Vec3d> vertices) {
  std::vector<std::uint32_t> equal(vertices.size());
  // Open addressing: a vertex and one, or 0 where empty; never more than three quarters full.
  std::vector<std::atomic<std::uint32_t>> slots(std::bit_ceil(vertices.size() + vertices.size() / 3 + 1));
  const std::size_t mask = slots.size() - 1;
  parallel_for(vertices.size(), [&](std::size_t v) {
    for (std::size_t s = position_hash(vertices[v]) & mask;; s = (s + 1) & mask) {
      std::uint32_t entry = slots[s].load(std::memory_order_relaxed);
      const auto own = static_cast<std::uint32_t>(v + 1);
      if (entry == 0 && slots[s].compare_exchange_strong(entry, own, std::memory_order_relaxed)) entry = own;
      if (entry != own && !(vertices[entry - 1] == vertices[v])) continue;
      equal[v] = entry - 1;
      return;
    }
  });
  return equal;
}

std::vector<Corners> sorted_corners(const Scene& scene) {
  const std::vector<std::uint32_t> equal = equal_vertices(scene.vertices());
  std::vector<Corners> corners(scene.triangles().size());
  parallel_for(corners.size(), [&](std::size_t t) {
    const auto& [i, j, k] = scene.triangles()[t];
    Corners c{equal[i], equal[j], equal[k]};
    std::ranges::sort(c);
    const bool distinct = c[0] != c[1] && c[1] != c[2];
    if (distinct && !zero_area(scene.corner(t, 0), scene.corner(t, 1), scene.corner(t, 2))) corners[t] = c;
  });
  return corners;
}

/// In a sorted group: how many different values, and how many that occur once.
struct Tally {
  std::size_t values = 0, different = 0, single = 0;

  template <class Value>
  void add(std::span<Value> group) {
    std::ranges::sort(group);
    values += group.size();
    for (auto i = group.begin(); i != group.end();) {
      const auto end = std::find_if(i, group.end(), [i](Value v) { return v != *i; });
      ++different;
      single += end - i == 1;
      i = end;
    }
  }

  friend Tally operator+(const Tally& a, const Tally& b) {
    return {a.values + b.values, a.different + b.different, a.single + b.single};
  }
};

template <class Value>
Tally tally(Grouped<Value> groups) {
  const auto add = [&groups](std::size_t begin, std::size_t end, Tally sum) {
    for (std::size_t key = begin; key < end; ++key) sum.add(groups.of(key));
    return sum;
  };
  return parallel_sum(groups.keys(), Tally{}, add, std::plus<>());
}

/// Triangles by their first corner; the other two make one number.
Tally tally_triangles(std::size_t vertices, const std::vector<Corners>& corners) {
  return tally(Grouped<std::uint64_t>(vertices, corners.size(), [&](std::size_t t, const auto& add) {
    const auto& [a, b, c] = corners[t];
    if (a != b) add(a, std::uint64_t{b} << 32 | c);
  }));
}

/// Edges by their first end.
Tally tally_edges(std::size_t vertices, const std::vector<Corners>& corners) {
  return tally(Grouped<std::uint32_t>(vertices, corners.size(), [&](std::size_t t, const auto& add) {
    const auto& [a, b, c] = corners[t];
    if (a == b) return;
    add(a, b);
    add(a, c);
    add(b, c);
  }));
}

void stop_if_cancelled(const Context& context) {
  if (context.cancelled()) throw Error(Error::Code::cancelled, "", "interrupted while counting edges");
}

}  // namespace

Topology topology(const Scene& scene, const Context& context) {
  const std::size_t vertices = scene.vertices().size();
  if (vertices > std::numeric_limits<std::uint32_t>::max())
    fail_unsupported("vertices", "more than 2^32 - 1 of them");
  return on_threads(context, [&] {
    const std::vector<Corners> corners = sorted_corners(scene);
    stop_if_cancelled(context);
    const Tally triangles = tally_triangles(vertices, corners);
    stop_if_cancelled(context);
    const Tally edges = tally_edges(vertices, corners);
    stop_if_cancelled(context);
    return Topology{triangles.values - triangles.different, edges.different, edges.single};
  });
}

}  // namespace provis
