#pragma once
// Changes to a segment's case after which the answer is the same, or follows.

#include <optional>

#include "tests/segment/answers.hpp"
#include "tests/support/transform.hpp"

namespace provis::test {

/// A changed case, and for each triangle of the original what became of it.
struct SegmentVariant {
  SegmentCase changed;
  std::vector<std::vector<PrimitiveId>> parts;
};

/// Applies one of the changes of transform.hpp to scene, eye, frames and the segment's end.
template <class Change>
std::optional<SegmentVariant> changed(const SegmentCase& c, const Change& change) {
  Case with_end = c.start;
  with_end.arrays.vertices.push_back(c.to);
  std::optional<Variant> v = change(with_end);
  if (!v) return {};
  const Vec3d to = v->changed.arrays.vertices.at(c.start.arrays.vertices.size());
  return SegmentVariant{{std::move(v->changed), to, c.pixels}, std::move(v->parts)};
}

/// The answer for the original that follows from the answer for the changed case.
Answer pull_back(const SegmentVariant& variant, const Answer& answer);

/// From its end back to its beginning.
SegmentCase reversed(const SegmentCase& c);

/// The answer that follows from the answer along the reversed segment.
Answer reversed(const Answer& answer);

/// The halves of a segment whose middle is exactly representable.
std::optional<std::pair<SegmentCase, SegmentCase>> halves(const SegmentCase& c);

/// The answer that follows from those for the halves.
Answer united(const Answer& first, const Answer& second);

}  // namespace provis::test
