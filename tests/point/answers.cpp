#include "tests/point/answers.hpp"

namespace provis::test {

std::vector<bool> visible_flags(const VisibleSet& set) {
  std::vector<bool> flags;
  for (const Status s : set.status) flags.push_back(s == Status::visible);
  return flags;
}

std::vector<bool> engine_visible(const Case& c, Arithmetic arithmetic) {
  PointOptions options;
  options.arithmetic = arithmetic;
  return visible_flags(visible_from_point(Scene(c.arrays), c.view, options));
}

std::vector<PrimitiveId> ids_of(const std::vector<bool>& visible) {
  std::vector<PrimitiveId> ids;
  for (std::size_t i = 0; i < visible.size(); ++i)
    if (visible[i]) ids.push_back(static_cast<PrimitiveId>(i));
  return ids;
}

}  // namespace provis::test
