#include "src/offset/side.hpp"

#include <algorithm>

namespace provis::offset {
namespace {

/// How far pairs of a face's and a polygon's corners lie on the wanted side.
class Grid {
 public:
  Grid(std::size_t columns) : columns_(columns) {}

  Interval& at(std::size_t row, std::size_t column) { return heights_[row][column]; }
  bool positive(std::size_t row, std::size_t column) const { return heights_[row][column].inf() > 0; }

  /// The pair that lies farthest on the wanted side; nothing if none does.
  std::optional<std::array<std::size_t, 2>> best() const;

  /// Whether the pair can be changed into every other one that may lie on the wanted side, one corner at a
  /// time and without leaving it.
  bool connected(const std::array<std::size_t, 2>& pair) const;

 private:
  std::array<std::array<Interval, Polygon::most>, 4> heights_;
  std::size_t columns_;
};

std::optional<std::array<std::size_t, 2>> Grid::best() const {
  std::array<std::size_t, 2> pair{};
  double most = 0;
  for (std::size_t r = 0; r < 4; ++r)
    for (std::size_t c = 0; c < columns_; ++c)
      if (heights_[r][c].inf() > most) {
        most = heights_[r][c].inf();
        pair = {r, c};
      }
  if (!(most > 0)) return std::nullopt;
  return pair;
}

bool Grid::connected(const std::array<std::size_t, 2>& pair) const {
  std::array<bool, 4> row{};
  std::array<bool, Polygon::most> column{};
  row[pair[0]] = true;
  column[pair[1]] = true;
  for (bool more = true; more;) {
    more = false;
    for (std::size_t r = 0; r < 4; ++r)
      for (std::size_t c = 0; c < columns_; ++c)
        if (positive(r, c) && row[r] != column[c]) {
          more = true;
          row[r] = true;
          column[c] = true;
        }
  }
  for (std::size_t r = 0; r < 4; ++r)
    for (std::size_t c = 0; c < columns_; ++c)
      if (heights_[r][c].sup() > 0 && !row[r] && !column[c]) return false;
  return true;
}

}  // namespace

bool Side::leaves_out(const Mesh::Edge& edge) const {
  const auto on_the_other = [&](std::size_t end) {
    if (edge.v[end] == line_.v[0] || edge.v[end] == line_.v[1]) return true;
    return std::all_of(face_.corners.begin(), face_.corners.end(), [&](const Vec3d& o) {
      return turn(*line_.ends[0], *line_.ends[1], *edge.ends[end], o) !=
             (positive_ ? Sign::positive : Sign::negative);
    });
  };
  return on_the_other(0) && on_the_other(1);
}

std::optional<Side::Segment> Side::some_segment(const Polygon& polygon) const {
  Grid grid(polygon.size);
  for (std::size_t r = 0; r < 4; ++r) {
    const Point o = numbers<Interval>(face_.corners[r]);
    for (std::size_t c = 0; c < polygon.size; ++c) {
      const Interval h = turn(*line_.ends[0], *line_.ends[1], polygon.corners[c].at, o);
      grid.at(r, c) = positive_ ? h : -h;
    }
  }
  const auto pair = grid.best();
  if (!pair || !grid.connected(*pair)) return std::nullopt;
  // The mean of all corners that the pair's viewpoint has on this side, and the mean of all viewpoints that
  // have that mean there.
  std::array<Interval, 4> sums;
  sums.fill(0);
  Segment s{{0, 0, 0}, {0, 0, 0}};
  double ends = 0, viewpoints = 0;
  for (std::size_t c = 0; c < polygon.size; ++c) {
    if (!grid.positive((*pair)[0], c)) continue;
    s.to = s.to + polygon.corners[c].at;
    ++ends;
    for (std::size_t r = 0; r < 4; ++r) sums[r] = sums[r] + grid.at(r, c);
  }
  for (std::size_t r = 0; r < 4; ++r) {
    if (!(sums[r].inf() > 0)) continue;
    s.from = s.from + numbers<Interval>(face_.corners[r]);
    ++viewpoints;
  }
  s.to = Interval(1) / Interval(ends) * s.to;
  s.from = Interval(1) / Interval(viewpoints) * s.from;
  return s;
}

}  // namespace provis::offset
