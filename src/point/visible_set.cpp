#include "provis/visible_set.hpp"

#include <algorithm>

namespace provis {

SamplingStats& SamplingStats::operator+=(const SamplingStats& other) {
  pixels += other.pixels;
  locations += other.locations;
  most = std::max(most, other.most);
  return *this;
}

IterationStats& IterationStats::operator+=(const IterationStats& other) {
  aggressive += other.aggressive;
  undecided += other.undecided;
  visible += other.visible;
  visible_after_first += other.visible_after_first;
  undecided_after_first += other.undecided_after_first;
  iterations = std::max(iterations, other.iterations);
  subtracted += other.subtracted;
  area += other.area;
  area_missed += other.area_missed;
  return *this;
}

std::string_view name(Status status) {
  switch (status) {
    case Status::hidden:
      return "hidden";
    case Status::undecided:
      return "undecided";
    case Status::visible:
      return "visible";
  }
  return "?";
}

std::string_view name(Guarantee guarantee) {
  switch (guarantee) {
    case Guarantee::exact:
      return "exact";
    case Guarantee::aggressive:
      return "aggressive";
    case Guarantee::conservative:
      return "conservative";
    case Guarantee::bounds:
      return "bounds";
    case Guarantee::sampled:
      return "sampled";
  }
  return "?";
}

std::vector<PrimitiveId> VisibleSet::with(Status wanted) const {
  std::vector<PrimitiveId> ids;
  for (std::size_t id = 0; id < status.size(); ++id)
    if (status[id] == wanted) ids.push_back(static_cast<PrimitiveId>(id));
  return ids;
}

}  // namespace provis
