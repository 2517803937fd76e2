#include "src/point/parts.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory>

#include "provis/error.hpp"
#include "src/point/cover_grid.hpp"
#include "src/scene/parallel.hpp"

namespace provis {
namespace {

constexpr std::size_t chunk_size = 8192;
constexpr int finest_cells = 1024;
constexpr int most_parts = 64;  ///< in each direction
/// Small scenes are cut too, so that threads have something to share.
std::size_t triangles_a_part(std::size_t n) { return std::clamp<std::size_t>(n / 64, 4, 128); }

constexpr std::size_t extent_classes = 4;
constexpr int precise_parts = 4;  ///< a triangle that reaches over more is held against each part

std::size_t chunk_count(std::size_t n) { return (n + chunk_size - 1) / chunk_size; }

/// Runs body(chunk, begin, end) over [0, n).
template <class Body>
void for_chunks(std::size_t n, const Context& context, const Body& body) {
  parallel_for(chunk_count(n), [&](std::size_t chunk) {
    if (context.cancelled()) return;
    body(chunk, chunk * chunk_size, std::min(n, (chunk + 1) * chunk_size));
  });
  if (context.cancelled()) throw Error(Error::Code::cancelled, "point", "interrupted");
}

/// The power of two next to the square root of n / each, at most `most`.
int side_for(std::size_t n, std::size_t each, int most) {
  int side = 1;
  while (side < most && static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * each < n) side *= 2;
  return side;
}

/// From covers that reach over many cells to those that hardly cover one; extent_classes if it covers none.
std::size_t extent_class(float cells) {
  std::size_t k = 0;
  for (float most = 128; k < extent_classes && cells < most; most /= 4) ++k;
  return k;
}

/// A distance typical of the scene, as seen from the eye: a few vertices are enough.
double typical_distance(const Scene& scene, const Vec3d& eye) {
  const auto vertices = scene.vertices();
  double most = 0;
  for (std::size_t k = 0; k < vertices.size(); k += vertices.size() / 64 + 1)
    most = std::max(most, largest(vertices[k] - eye));
  return most > 0x1p-200 && most < 0x1p200 ? most : 1;
}

/// Where a triangle may have hits.
struct Footprint {
  CellRange cells;
  float depth = 0;      ///< nothing of it is nearer
  bool placed = false;  ///< false: anywhere, at any depth
  float extent = 0;     ///< in cells, the smaller of both
};

}  // namespace

/// Two looks at every triangle: one that collects covers, one that asks what they hide.
class Partition {
 public:
  Partition(const Scene& scene, const ViewGeometry& geometry, const Window& window, const Context& context);

  Parts run();

 private:
  using Ids = std::vector<PrimitiveId>;

  void project();
  bool candidate(std::size_t t, Footprint& footprint) const;
  static bool holds_a_cell(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c);
  bool faces_away(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) const;
  bool make_cover(std::size_t t, Cover& cover) const;
  bool may_cover(std::size_t t, const Footprint& footprint) const;
  void add_cover(std::size_t t);
  template <class Visit>
  void for_parts_of(std::size_t t, const Visit& visit) const;
  void collect(Parts& parts) const;

  const ScreenPoint& corner(std::size_t t, int k) const {
    return points_[scene_.triangles()[t][static_cast<std::size_t>(k)]];
  }
  int cells_a_part() const { return cells_.side / parts_.side; }

  const Scene& scene_;
  const ViewGeometry& geometry_;
  const Context& context_;
  WindowGrid cells_, parts_;
  Screen screen_;
  WindowExtent extent_;
  std::unique_ptr<ScreenPoint[]> points_;
  std::vector<Ids> candidates_;                                    ///< by chunk of triangles
  std::array<std::vector<Ids>, extent_classes> covers_by_extent_;  ///< likewise
  CoverGrid covers_;
};

Partition::Partition(const Scene& scene, const ViewGeometry& geometry, const Window& window,
                     const Context& context)
    : scene_(scene),
      geometry_(geometry),
      context_(context),
      cells_{window, side_for(scene.triangles().size(), 1, finest_cells)},
      parts_{window, std::min(cells_.side, side_for(scene.triangles().size(),
                                                    triangles_a_part(scene.triangles().size()), most_parts))},
      screen_(geometry, cells_, typical_distance(scene, geometry.eye)),
      extent_(window),
      covers_(cells_) {
  if (!screen_.usable()) parts_.side = 1;
}

Parts Partition::run() {
  if (screen_.usable()) project();
  const std::size_t n = scene_.triangles().size();
  candidates_.resize(chunk_count(n));
  for (auto& lists : covers_by_extent_) lists.resize(chunk_count(n));
  for_chunks(n, context_, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    Footprint footprint;
    for (std::size_t t = begin; t < end; ++t) {
      if (!candidate(t, footprint)) continue;
      candidates_[chunk].push_back(static_cast<PrimitiveId>(t));
      if (const std::size_t k = extent_class(footprint.extent); k < extent_classes && may_cover(t, footprint))
        covers_by_extent_[k][chunk].push_back(static_cast<PrimitiveId>(t));
    }
  });
  // Large covers first: most of the others need not be looked at after that.
  for (const auto& lists : covers_by_extent_) {
    for_chunks(n, context_, [&](std::size_t chunk, std::size_t, std::size_t) {
      for (const PrimitiveId t : lists[chunk]) add_cover(t);
    });
    covers_.settle();
  }
  Parts parts;
  parts.grid_ = parts_;
  collect(parts);
  return parts;
}

void Partition::project() {
  const std::size_t n = scene_.vertices().size();
  points_ = std::make_unique_for_overwrite<ScreenPoint[]>(n);
  for_chunks(n, context_, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) points_[v] = screen_.project(scene_.vertices()[v]);
  });
}

/// Whether the triangle may have a hit in the window; where.
bool Partition::candidate(std::size_t t, Footprint& f) const {
  f = {{0, cells_.side - 1, 0, cells_.side - 1}, 0, false, static_cast<float>(cells_.side)};
  if (!screen_.usable()) return true;
  const ScreenPoint &a = corner(t, 0), &b = corner(t, 1), &c = corner(t, 2);
  if (a.code & b.code & c.code & beyond_any) return false;
  if ((a.code | b.code | c.code) & unplaced) return true;
  const auto side = static_cast<float>(cells_.side);
  const float x0 = std::min({a.x, b.x, c.x}) - Screen::margin,
              x1 = std::max({a.x, b.x, c.x}) + Screen::margin;
  const float y0 = std::min({a.y, b.y, c.y}) - Screen::margin,
              y1 = std::max({a.y, b.y, c.y}) + Screen::margin;
  if (x1 < 0 || y1 < 0 || x0 > side || y0 > side) return false;
  if ((scene_.triangle_flags()[t] & single_sided) && faces_away(a, b, c)) return false;
  const auto cell = [&](float at) { return static_cast<int>(std::clamp(at, 0.0f, side - 1)); };
  f.cells = {cell(x0), cell(x1), cell(y0), cell(y1)};
  f.depth = std::max({a.depth, b.depth, c.depth});
  f.placed = true;
  f.extent = std::min(std::min(x1, side) - std::max(x0, 0.0f), std::min(y1, side) - std::max(y0, 0.0f));
  return true;
}

/// Whether the triangle is large enough for the circle in a cell. Being wrong only costs a cover.
bool Partition::holds_a_cell(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) {
  const auto length = [](const ScreenPoint& p, const ScreenPoint& q) {
    return std::hypot(p.x - q.x, p.y - q.y);
  };
  const float twice_area = std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  return 2 * twice_area > length(a, b) + length(b, c) + length(c, a);
}

/// Certainly clockwise for the viewer.
bool Partition::faces_away(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) const {
  const double bx = double{b.x} - a.x, by = double{b.y} - a.y, cx = double{c.x} - a.x, cy = double{c.y} - a.y;
  // Each difference is off by two margins at most, each product by what that makes of it.
  constexpr double off = 2 * Screen::margin;
  const double slack = off * (std::fabs(bx) + std::fabs(by) + std::fabs(cx) + std::fabs(cy) + 2 * off);
  const double area = bx * cy - by * cx;
  return (geometry_.handedness == Sign::positive ? -area : area) < -slack * (1 + 0x1p-20);
}

bool Partition::make_cover(std::size_t t, Cover& cover) const {
  const Vec3d *a = &scene_.corner(t, 0), *b = &scene_.corner(t, 1), *c = &scene_.corner(t, 2);
  const Plane<Ball> plane = triangle_plane<Ball>(geometry_, *a, *b, *c);
  const bool back = plane.at_eye.value > plane.at_eye.radius;
  if (back && (scene_.triangle_flags()[t] & single_sided)) return false;
  if (!back && !(plane.at_eye.value < -plane.at_eye.radius)) return false;
  // Seen from behind, corners run anticlockwise in the window of a frame of positive handedness.
  if (back != (geometry_.handedness == Sign::positive)) std::swap(b, c);
  const FrameProjection& project = screen_.projection();
  const FramePoint p[3] = {project(*a), project(*b), project(*c)};
  for (int k = 0; k < 3; ++k) cover.edges[k] = edge_function(p[k], p[(k + 1) % 3], extent_);
  const Ball sign(back ? 1 : -1);
  cover.depth = depth_numerator(geometry_, {sign * plane.normal, sign * plane.offset, plane.at_eye}, extent_);
  cover.at_eye = sign * plane.at_eye;
  return true;
}

/// For an eye at infinity nothing that reaches behind the window counts: its hits there are none.
bool Partition::may_cover(std::size_t t, const Footprint& f) const {
  if (!screen_.usable() || (scene_.triangle_flags()[t] & see_through)) return false;
  if (f.placed && !holds_a_cell(corner(t, 0), corner(t, 1), corner(t, 2))) return false;
  return !geometry_.at_infinity || (f.placed && f.depth < 0);
}

void Partition::add_cover(std::size_t t) {
  Footprint f;
  candidate(t, f);
  if (f.placed && covers_.hides(f.cells, f.depth)) return;
  Cover cover;
  if (make_cover(t, cover)) covers_.add(cover, screen_, f.cells);
}

/// Visits the parts in which the triangle may be seen, given that it is a candidate.
template <class Visit>
void Partition::for_parts_of(std::size_t t, const Visit& visit) const {
  Footprint f;
  if (!candidate(t, f)) return;
  if (f.placed && covers_.hides(f.cells, f.depth)) return;
  const int n = cells_a_part();
  const CellRange p{f.cells.i0 / n, f.cells.i1 / n, f.cells.j0 / n, f.cells.j1 / n};
  const int count = (p.i1 - p.i0 + 1) * (p.j1 - p.j0 + 1);
  if (count == 1) {
    visit(p.j0 * parts_.side + p.i0);
    return;
  }
  Cover cone;
  const bool precise = count > precise_parts && make_cover(t, cone);
  for (int j = p.j0; j <= p.j1; ++j)
    for (int i = p.i0; i <= p.i1; ++i) {
      const Window part = parts_.block(i, j, 1);
      if (precise && std::any_of(std::begin(cone.edges), std::end(cone.edges),
                                 [&](const WindowFunction& e) { return e.highest(part) < 0; }))
        continue;
      const CellRange both{std::max(f.cells.i0, i * n), std::min(f.cells.i1, i * n + n - 1),
                           std::max(f.cells.j0, j * n), std::min(f.cells.j1, j * n + n - 1)};
      if (f.placed && covers_.hides(both, f.depth)) continue;
      visit(j * parts_.side + i);
    }
}

/// Counts, then places: lists in id order whatever the threads do.
void Partition::collect(Parts& parts) const {
  const auto count = static_cast<std::size_t>(parts_.side) * static_cast<std::size_t>(parts_.side);
  // Groups of chunks, so that the table of counts stays small.
  const std::size_t chunks = candidates_.size(), groups = std::min<std::size_t>(chunks, 64);
  std::vector<std::vector<std::pair<std::uint32_t, PrimitiveId>>> placed(groups);
  std::vector<std::vector<std::size_t>> places(groups, std::vector<std::size_t>(count, 0));
  const auto of_group = [&](std::size_t g) { return g * chunks / std::max<std::size_t>(groups, 1); };
  parallel_for(groups, [&](std::size_t g) {
    for (std::size_t chunk = of_group(g); chunk < of_group(g + 1) && !context_.cancelled(); ++chunk)
      for (const PrimitiveId t : candidates_[chunk])
        for_parts_of(t, [&](int part) {
          placed[g].push_back({static_cast<std::uint32_t>(part), t});
          ++places[g][static_cast<std::size_t>(part)];
        });
  });
  if (context_.cancelled()) throw Error(Error::Code::cancelled, "point", "interrupted");

  parts.begins_.assign(count + 1, 0);
  std::size_t total = 0;
  for (std::size_t part = 0; part < count; ++part) {
    parts.begins_[part] = total;
    for (std::size_t g = 0; g < groups; ++g) total += std::exchange(places[g][part], total);
  }
  parts.begins_[count] = total;
  parts.members_.resize(total);
  parallel_for(groups, [&](std::size_t g) {
    for (const auto& [part, t] : placed[g]) parts.members_[places[g][part]++] = t;
  });
}

Parts make_parts(const Scene& scene, const ViewGeometry& geometry, const Window& window,
                 const Context& context) {
  return Partition(scene, geometry, window, context).run();
}

}  // namespace provis
