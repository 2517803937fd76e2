// Faces and rasters: together they hold almost every ray that leaves a cell.

#include <catch2/catch.hpp>

#include <cmath>

#include "predicates/environment.hpp"
#include "src/offset/face.hpp"
#include "src/offset/shaft.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/random.hpp"

namespace provis::test {
namespace {

using namespace provis::offset;

double at(const Vec3d& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/// How many rasters of the face hold a direction that leads beyond it.
int holding(const std::vector<Raster>& rasters, const Vec3d& d) {
  int n = 0;
  for (const Raster& r : rasters) {
    const Frame& f = r.frame;
    const double x = dot(f.right, d), y = dot(f.up, d), z = dot(f.forward, d);  // orthonormal
    const Window& w = f.window;
    n += z > 0 && x >= w.x0 * z && x <= w.x1 * z && y >= w.y0 * z && y <= w.y1 * z;
  }
  return n;
}

}  // namespace

TEST_CASE("the hemicube of a face holds every direction that leads beyond it, grazing ones too") {
  const ViewCell cell{{0, 0, 0}, {1, 2, 3}, {}};
  for (const Face& face : faces_of(cell)) {
    const std::vector<Raster> rasters = rasters_of(cell, face, {3, 5});
    REQUIRE(rasters.size() == 5);
    for (const std::uint64_t seed : seeds(20)) {
      Random random(seed);
      Vec3d d{random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5};
      double& out = face.axis == 0 ? d.x : face.axis == 1 ? d.y : d.z;
      out = (face.upper ? 1 : -1) * std::fabs(out) * random.pick({1.0, 0x1p-20, 0x1p-200, 0x1p-900});
      REQUIRE(holding(rasters, d) >= 1);
      out = -out;
      REQUIRE(holding(rasters, d) == 0);
    }
  }
}

TEST_CASE("pixels share their borders, which end where the window ends") {
  ViewCell cell{{0, 0, 0}, {1, 1, 1}, Frame{}};
  cell.window->window = {-0.3, 0.7, 1.1, 1.2};
  for (const Face& face : faces_of(cell))
    for (const Raster& r : rasters_of(cell, face, {7, 3})) {
      REQUIRE(r.columns.size() == 8);
      REQUIRE(r.rows.size() == 4);
      CHECK((r.columns.front() == -0.3 && r.columns.back() == 0.7));
      CHECK((r.rows.front() == 1.1 && r.rows.back() == 1.2));
      CHECK(std::is_sorted(r.columns.begin(), r.columns.end()));
    }
}

TEST_CASE("a window looks through those faces only that it leads out of") {
  ViewCell cell{{0, 0, 0}, {1, 1, 1}, Frame{}};  // along -z, 45 degrees to each side
  int through[3][2] = {};
  for (const Face& face : faces_of(cell))
    through[face.axis][face.upper] = static_cast<int>(rasters_of(cell, face, {4, 4}).size());
  CHECK((through[2][0] == 1 && through[2][1] == 0));
  CHECK((through[0][0] == 1 && through[0][1] == 1 && through[1][0] == 1 && through[1][1] == 1));
  cell.window->window = {0.25, 0.5, 0.25, 0.5};
  for (const Face& face : faces_of(cell))
    CHECK(rasters_of(cell, face, {4, 4}).empty() == (face.upper == (face.axis == 2)));
}

TEST_CASE("a flat cell is looked at from both sides, and from nowhere else") {
  const std::vector<Face> faces = faces_of({{0, 5, 0}, {1, 5, 1}, {}});
  REQUIRE(faces.size() == 2);
  CHECK((faces[0].axis == 1 && faces[1].axis == 1 && faces[0].upper != faces[1].upper));
}

TEST_CASE("every ray of a beam stays in its shaft, from all corners in all extreme directions") {
  const RoundUp guard;
  ViewCell cell{{-0.5, 0, 1}, {1, 2, 1.25}, {}};
  for (const bool limited : {false, true}) {
    if (limited) cell.window = Frame{{1, 0.5, 0}, {0, 1, 2}, {-1, 0, 3}, {-0.25, 1, 0.5, 0.75}};
    for (const Face& face : faces_of(cell))
      for (const Raster& raster : rasters_of(cell, face, {2, 3}))
        for (std::size_t i = 0; i + 1 < raster.columns.size(); ++i)
          for (std::size_t j = 0; j + 1 < raster.rows.size(); ++j) {
            const Window w{raster.columns[i], raster.columns[i + 1], raster.rows[j], raster.rows[j + 1]};
            const Shafts::Spaces spaces = Shafts(raster.frame).around(face, w);
            for (const Vec3d& o : face.corners)
              for (const double x : {w.x0, w.x1})
                for (const double y : {w.y0, w.y1}) {
                  const Frame& f = raster.frame;
                  const Point d = numbers<Interval>(f.forward) + Interval(x) * numbers<Interval>(f.right) +
                                  Interval(y) * numbers<Interval>(f.up);
                  const Interval& out = face.axis == 0 ? d.x : face.axis == 1 ? d.y : d.z;
                  if (face.upper ? out.sup() < 0 : out.inf() > 0) continue;  // back into the cell
                  for (const double distance : {0.0, 0.125, 7.0, 1e6})
                    for (const HalfSpace& h : spaces)
                      REQUIRE(height(h, numbers<Interval>(o) + Interval(distance) * d).sup() >= 0);
                }
          }
  }
}

TEST_CASE("what rays of a beam reach is never cut off") {
  for (const std::uint64_t seed : seeds(20)) {
    Random random(seed);
    const RoundUp guard;
    const ViewCell cell{{0, 0, 0}, {1 + random.unit(), 1, random.unit() + 0x1p-30}, {}};
    const std::vector<Face> faces = faces_of(cell);
    const Face& face = random.pick_from(faces);
    const std::vector<Raster> rasters = rasters_of(cell, face, {8, 8});
    const Raster& raster = random.pick_from(rasters);
    const auto i = random.below(raster.columns.size() - 1), j = random.below(raster.rows.size() - 1);
    const Window w{raster.columns[i], raster.columns[i + 1], raster.rows[j], raster.rows[j + 1]};
    const Shafts::Spaces spaces = Shafts(raster.frame).around(face, w);
    // A ray from the rectangle's middle in the middle of the directions, and a triangle around a point of it.
    const Vec3d from = 0.5 * (face.corners[0] + face.corners[2]);
    const Vec3d d = raster.frame.forward + (0.5 * (w.x0 + w.x1)) * raster.frame.right +
                    (0.5 * (w.y0 + w.y1)) * raster.frame.up;
    const Vec3d p = from + (0.1 + 5 * random.unit()) * d;
    const auto near = [&] { return p + random.lattice(3); };
    const Vec3d a = near(), b = near();
    const Vec3d c = 3.0 * p - a - b;  // so that p is the mean, but for rounding
    Polygon polygon = whole(a, b, c);
    for (const HalfSpace& h : spaces) polygon.clip(h);
    REQUIRE(polygon.size >= 3);
    REQUIRE_FALSE(misses(a, p, spaces));
    for (std::size_t k = 0; k < polygon.size; ++k)
      for (int axis = 0; axis < 3; ++axis) {
        const auto& x = axis == 0   ? polygon.corners[k].at.x
                        : axis == 1 ? polygon.corners[k].at.y
                                    : polygon.corners[k].at.z;
        REQUIRE(x.sup() - x.inf() < 1e-9 * (1 + std::fabs(at(p, axis)) + 10));
      }
  }
}

}  // namespace provis::test
