#include "src/lod/open_edge.hpp"

#include <algorithm>

namespace provis::lod {
namespace {

/// A piece of an edge between neighbouring vertices; from < to.
struct Piece {
  std::uint32_t from, to;
  PrimitiveId triangle;
  int way;  ///< +1 where the triangle runs from `from` to `to`

  friend bool operator<(const Piece& p, const Piece& q) {
    return p.from != q.from ? p.from < q.from : p.to != q.to ? p.to < q.to : p.triangle < q.triangle;
  }
};

}  // namespace

std::optional<OpenEdge> open_edge(const Chain& chain, const offset::Seams& seams) {
  std::vector<Piece> pieces;
  for (const PrimitiveId t : chain.triangles()) {
    const Triangle& corners = chain.scene().triangles()[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = seams.vertex(corners[k]), b = seams.vertex(corners[(k + 1) % 3]);
      const int way = a < b ? 1 : -1;
      std::uint32_t last = std::min(a, b);
      for (const std::uint32_t m : seams.inside(t, k)) {
        pieces.push_back({last, m, t, way});
        last = m;
      }
      pieces.push_back({last, std::max(a, b), t, way});
    }
  }
  std::sort(pieces.begin(), pieces.end());
  for (auto i = pieces.begin(); i != pieces.end();) {
    int sum = 0;
    auto end = i;
    for (; end != pieces.end() && end->from == i->from && end->to == i->to; ++end) sum += end->way;
    if (sum != 0) return OpenEdge{i->triangle, seams.position(i->from), seams.position(i->to)};
    i = end;
  }
  return std::nullopt;
}

}  // namespace provis::lod
