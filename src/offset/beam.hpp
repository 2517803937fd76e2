#pragma once
// The rays of one rectangle of pixels: what they may hit, and what is proven to hide it.

#include <boost/smart_ptr/intrusive_ptr.hpp>
#include <boost/smart_ptr/intrusive_ref_counter.hpp>
#include <optional>
#include <vector>

#include "src/offset/fusion.hpp"

namespace provis::offset {

/// A part of a triangle, shared by the lists of one thread.
struct CutPolygon : Polygon, boost::intrusive_ref_counter<CutPolygon, boost::thread_unsafe_counter> {
  explicit CutPolygon(const Polygon& p) : Polygon(p) {}
};

/// A triangle that rays of a beam may hit.
struct Entry {
  std::uint32_t facet = 0;
  bool wanted = false;                         ///< still to be decided; all others are here to occlude
  Failure failure = Failure::nothing_between;  ///< of the last attempt to hide it
  double near = 0, far = 0;                    ///< bounds on the depth of what lies in the beam
  boost::intrusive_ptr<const CutPolygon> cut;  ///< what lies in the beam; null for the whole triangle
};

/// What of the entry lies in its beam.
Polygon polygon_of(const Entry& entry, const Facet& facet);

/// Rays from a rectangle of viewpoints in a rectangle of directions.
struct Beam {
  Face face;  ///< the viewpoints: a face or a part of one
  Window directions;
  Shafts::Spaces spaces;
  Point viewpoint{0, 0, 0};  ///< inside the face
  Point ray{0, 0, 0};        ///< inside the directions

  Beam(const Face& viewpoints, const Raster& raster, const Shafts& shafts, const Window& window);
};

/// Occluders that together cover a beam: every ray of it meets one of them.
struct Cover {
  double far = 0;  ///< at no greater depth than this
  std::vector<std::uint32_t> members;
};

/// One worker's view of a face.
class Resolver {
 public:
  Resolver(const std::vector<Facet>& facets, const Mesh& mesh, const Shafts& shafts)
      : facets_(facets), fusion_(mesh), shafts_(shafts), place_(facets.size(), 0) {}

  /// Fused occluders that cover the whole beam: the nearest that is found.
  std::optional<Cover> cover(const Beam& beam, const std::vector<Entry>& list);

  /// Whether the entry certainly lies behind the cover, wherever a ray of the beam hits both.
  bool behind(const Cover& cover, const Entry& entry) const;

  /// Failure::none if some occluders of the list certainly come before the entry on all rays of the beam that
  /// hit it; Failure::seen if one such ray certainly meets nothing before it, so that no part of the beam can
  /// hide it; otherwise what stood in the way of the nearest that came into question.
  Failure hide(const Beam& beam, const std::vector<Entry>& list, const Entry& entry);

 private:
  Point viewpoint_towards(const Beam& beam, const Point& to) const;
  /// What is to be hidden.
  struct Target {
    const Facet& facet;
    const Polygon& polygon;
  };
  static bool lies_beyond(const Facet& occluder, const Target& target);
  static bool lies_beyond(const Facet& occluder, const Facet& facet);
  double farthest(const std::vector<std::uint32_t>& members, const std::vector<Entry>& list);
  static bool boxes_apart(const Facet& occluder, const Target& target);
  static bool may_be_crossed(const Mesh::Edge& edge, const Face& face, const Target& target);
  static std::optional<Sign> turn_of(const Mesh::Edge& edge, const Facet& facet, const Corner& corner,
                                     const Vec3d& viewpoint);
  /// Whether the line passes through the triangle's interior; nullopt where that is not certain.
  std::optional<bool> aims_at(const Facet& facet, const Point& from, const Point& to) const;
  /// The same for the segment.
  std::optional<bool> crosses(const Facet& facet, const Point& from, const Point& to) const;

  static constexpr std::size_t most_members = 256, most_seeds = 8;

  const std::vector<Facet>& facets_;
  Fusion fusion_;
  const Shafts& shafts_;
  std::vector<std::uint32_t> place_;  ///< by facet: where it is in the list at hand, if it is
};

}  // namespace provis::offset
