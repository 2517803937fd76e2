#pragma once
// What the certain signs of one part of the window are asked of, made when first needed: most facets are
// decided without.

#include <unordered_map>

#include "src/point/facets.hpp"

namespace provis {

/// An input point in the image.
struct ImagePoint {
  Direction direction;
  Sign side =
      Sign::positive;  ///< of the image: negative or zero where the point is not in front of the frame
};

/// Values by index, each made once and never moved.
template <class Value>
class MadeOnce {
 public:
  template <class Make>
  const Value& get(std::uint32_t index, const Make& make) {
    const auto [place, fresh] = values_.try_emplace(index);
    if (fresh) make(place->second);
    return place->second;
  }

 private:
  std::unordered_map<std::uint32_t, Value> values_;
};

template <Arithmetic A>
class ImagePoints {
 public:
  ImagePoints(Signs<A>& signs, const std::vector<const Vec3d*>& positions)
      : signs_(signs), positions_(positions) {
    image_.kind = LineKind::image;
    image_.approx = signs.shadow(image_);
  }

  const ImagePoint& operator[](std::uint32_t id) {
    return points_.get(id, [&](ImagePoint& p) {
      p.direction.kind = DirectionKind::point;
      p.direction.point = positions_[id];
      p.direction.point_id = id;
      p.direction.approx = signs_.shadow(p.direction);
      // For an eye at infinity every point lies in the image.
      if (!signs_.geometry().at_infinity) p.side = signs_.side(image_, p.direction);
    });
  }

 private:
  Signs<A>& signs_;
  const std::vector<const Vec3d*>& positions_;
  Line image_;
  MadeOnce<ImagePoint> points_;
};

/// The edges and the plane of a facet, as the chain wants them.
template <Arithmetic A>
struct FacetLines {
  Line edges[3];  ///< positive inside
  Plane<typename HotNumber<A>::type> plane;
};

template <Arithmetic A>
class PartLines {
 public:
  PartLines(Signs<A>& signs, const Facets& facets)
      : points(signs, facets.positions), signs_(signs), facets_(facets.facets) {}

  const FacetLines<A>& of(std::uint32_t facet) {
    return lines_.get(facet, [&](FacetLines<A>& lines) { make(facets_[facet], lines); });
  }

  ImagePoints<A> points;

 private:
  void make(const Facet& f, FacetLines<A>& lines) const;

  Signs<A>& signs_;
  const std::vector<Facet>& facets_;
  MadeOnce<FacetLines<A>> lines_;
};

template <Arithmetic A>
void PartLines<A>::make(const Facet& f, FacetLines<A>& lines) const {
  for (std::size_t k = 0; k < 3; ++k) {
    Line& e = lines.edges[k];
    e.kind = LineKind::edge;
    e.first.p[0] = f.corners.p[k];
    e.first.p[1] = f.corners.p[(k + 1) % 3];
    e.points[0] = f.points[k];
    e.points[1] = f.points[(k + 1) % 3];
    e.approx = signs_.shadow(e);
  }
  lines.plane = triangle_plane<typename HotNumber<A>::type>(signs_.geometry(), *f.corners.p[0],
                                                            *f.corners.p[1], *f.corners.p[2]);
}

}  // namespace provis
