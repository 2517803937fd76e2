#pragma once
// A tree of boxes over the triangles of a scene: which of them may meet a segment.

#include <gmpxx.h>

#include <array>
#include <functional>
#include <vector>

#include "provis/scene.hpp"

namespace provis::test {

class BoxTree {
 public:
  explicit BoxTree(const SceneArrays& scene);

  /// Calls visit for every triangle that meets the closed segment and for some that do not, until it returns
  /// false. Rounding only ever adds triangles.
  void visit_segment(const Vec3<mpq_class>& from, const Vec3<mpq_class>& to,
                     const std::function<bool(PrimitiveId)>& visit) const;

 private:
  struct Range {
    double lo, hi;
  };
  using Box = std::array<Range, 3>;
  struct Node {
    Box box;
    std::uint32_t first, count;  // a leaf: triangles order_[first ...]; otherwise count is 0
    std::uint32_t second_child;  // the first child follows its parent
  };
  struct Segment {
    Box from, span;  // bounds on the start, and on the vector to the end
    Box hull;
  };

  static Range outward(const mpq_class& exact);
  static bool may_meet(const Box& box, const Segment& segment);
  std::uint32_t build(std::uint32_t first, std::uint32_t count);

  std::vector<Box> boxes_;
  std::vector<PrimitiveId> order_;
  std::vector<Node> nodes_;
};

}  // namespace provis::test
