#pragma once
// Occluders made of several triangles: a certified connected patch hides what no single triangle does.

#include <span>
#include <vector>

#include "src/point/facets.hpp"

namespace provis {

/// Decides whether facets together cover a rectangle of the window.
///
/// Every facet runs the same way round as seen by the viewer. So the number of facets of a set that cover a
/// ray changes only across an edge, and not across one that two facets of the set run along in opposite
/// directions. Where every edge that may reach into the rectangle has such a partner, the number is the same
/// everywhere in it; if it is one or more on one ray, the rectangle is covered, shared edges included, for
/// facets are closed. Partners are known from corner ids, never from coordinates.
class Patch {
 public:
  explicit Patch(const Facets& facets) : facets_(facets.facets) {}

  void clear();
  bool empty() const { return members_.empty(); }

  /// Adds an occluder that may reach into the rectangle, unless it certainly does not.
  void add(std::uint32_t facet, const Window& rectangle);

  /// Finds, among what was added, the connected patch that covers the rectangle and hides most: everything
  /// below the depth returned. -infinity if there is none.
  double cover(const Window& rectangle);

 private:
  struct Member {
    std::uint32_t facet;
    std::uint32_t patch;  ///< union-find
    double depth;         ///< nowhere in the rectangle farther
    bool kept = true;
  };
  struct Edge {
    std::uint64_t ends;  ///< both corner ids, the smaller first
    std::uint32_t member;
    bool forth;  ///< runs from the smaller id to the larger
  };

  void connect();
  bool drop_unmatched();
  std::uint32_t root(std::uint32_t member);
  bool holds_a_ray(const Facet& f, const Window& rectangle) const;

  const std::vector<Facet>& facets_;
  std::vector<Member> members_;
  std::vector<Edge> edges_;
};

}  // namespace provis
