#include "src/offset/resolver.hpp"

#include <algorithm>
#include <cmath>

#include "src/offset/target.hpp"

namespace provis::offset {

std::optional<Cover> Resolver::cover(const Beam& beam, const std::vector<Entry>& list) {
  // Where a window leads back into the cell too, only the rays that leave it count.
  const Interval& out = component(beam.ray, beam.face.axis);
  if (!(beam.face.upper ? out.inf() > 0 : out.sup() < 0)) return std::nullopt;
  const Point ahead = beam.viewpoint + beam.ray;
  const auto any = [](std::uint32_t) { return true; };
  const auto reaches = [&](const Mesh::Edge& e) { return !misses(*e.ends[0], *e.ends[1], beam.spaces); };
  std::size_t seeds = 0;
  for (const Entry& entry : list) {
    const Facet& f = facets_[entry.facet];
    if (!f.occludes || aims_at(f, beam.viewpoint, ahead) != true) continue;
    if (++seeds > most_seeds) break;
    const auto members = fusion_.grow(entry.facet, most_members, any, reaches);
    if (!members) continue;
    return Cover{farthest(*members, list), *members};
  }
  return std::nullopt;
}

/// Of what the members have in the beam; of all of a member that is not in the list.
double Resolver::farthest(const std::vector<std::uint32_t>& members, const std::vector<Entry>& list) {
  for (std::uint32_t k = 0; k < list.size(); ++k) place_[list[k].facet] = k;
  double far = -HUGE_VAL;
  for (const std::uint32_t m : members) {
    if (place_[m] < list.size() && list[place_[m]].facet == m) {
      far = std::max(far, list[place_[m]].far);
      continue;
    }
    for (const Vec3d* p : facets_[m].p) far = std::max(far, shafts_.depth(numbers<Interval>(*p)).sup());
  }
  return far;
}

bool Resolver::behind(const Cover& cover, const Entry& entry) const {
  if (entry.near > cover.far) return true;
  constexpr std::size_t few = 16;
  const Facet& facet = facets_[entry.facet];
  return cover.members.size() <= few &&
         std::all_of(cover.members.begin(), cover.members.end(), [&](std::uint32_t m) {
           if (m == entry.facet) return false;
           return entry.cut ? lies_beyond(facets_[m], Target{facet, *entry.cut})
                            : lies_beyond(facets_[m], facet);
         });
}

/// One entry against the occluders of its list.
class Resolver::Hiding {
 public:
  Hiding(Resolver& resolver, const Beam& beam, const std::vector<Entry>& list, const Entry& entry)
      : resolver_(resolver),
        facets_(resolver.facets_),
        beam_(beam),
        list_(list),
        entry_(entry),
        polygon_(polygon_of(entry, facets_[entry.facet])),
        target_{facets_[entry.facet], polygon_} {}

  Failure all();
  bool by_sides();

 private:
  bool usable(std::uint32_t m) const {
    return m != entry_.facet && (lies_beyond(facets_[m], target_) || boxes_apart(facets_[m], target_));
  }
  bool on_side(const Side& side);
  void try_line(const Mesh::Edge* line) {
    if (line && std::find(lines_.begin(), lines_.end(), line) == lines_.end()) lines_.push_back(line);
  }

  Resolver& resolver_;
  const std::vector<Facet>& facets_;
  const Beam& beam_;
  const std::vector<Entry>& list_;
  const Entry& entry_;
  Polygon polygon_;
  Target target_;
  std::vector<const Mesh::Edge*> lines_;  ///< that may divide the segments, the most promising first
};

/// All segments at once.
Failure Resolver::Hiding::all() {
  const Point to = inner_point(polygon_), from = beam_.viewpoint_towards(to);
  const auto may_cross = [&](const Mesh::Edge& e) { return may_be_crossed(e, beam_.face, target_); };
  std::size_t seeds = 0;
  Failure first = Failure::nothing_between;
  bool clear = target_.facet.faced && resolver_.shafts_.holds(beam_.directions, to - from);
  for (const Entry& occluder : list_) {
    if (occluder.near > entry_.far) break;  // the list is in order of least depth
    const Facet& f = facets_[occluder.facet];
    if (!f.opaque || occluder.facet == entry_.facet || (!f.occludes && !clear)) continue;
    const std::optional<bool> crossed = crosses(f, from, to);
    clear = clear && crossed == false;
    if (!f.occludes || crossed != true) continue;
    if (++seeds > most_seeds) break;
    Fusion& fusion = resolver_.fusion_;
    if (fusion.grow(
            occluder.facet, most_members, [&](std::uint32_t m) { return usable(m); }, may_cross))
      return Failure::none;
    try_line(fusion.open_edge());
    if (seeds == 1) first = fusion.failure();
  }
  return clear ? Failure::seen : first;
}

/// Those on either side of an edge that was in the way, each side by occluders of its own. Where two borders
/// run beside each other it may matter which of them divides: the one that was in the way here, or one that
/// ends what hides one side, and lies on the other.
bool Resolver::Hiding::by_sides() {
  for (std::size_t k = 0; k < std::min(lines_.size(), most_lines); ++k) {
    const bool one = on_side({beam_.face, *lines_[k], true}),
               other = on_side({beam_.face, *lines_[k], false});
    if (one && other) return true;
  }
  return false;
}

bool Resolver::Hiding::on_side(const Side& side) {
  const auto segment = side.some_segment(polygon_);
  if (!segment) return false;
  std::vector<const Mesh::Edge*> ends;  // of what hides this side, on the other side
  const auto may_cross = [&](const Mesh::Edge& e) {
    if (!may_be_crossed(e, beam_.face, target_)) return false;
    if (!side.leaves_out(e)) return true;
    ends.push_back(&e);
    return false;
  };
  std::size_t seeds = 0;
  for (const Entry& occluder : list_) {
    if (occluder.near > entry_.far) break;
    const Facet& f = facets_[occluder.facet];
    if (!f.occludes || occluder.facet == entry_.facet || crosses(f, segment->from, segment->to) != true)
      continue;
    if (++seeds > most_seeds) break;
    ends.clear();
    if (resolver_.fusion_.grow(
            occluder.facet, most_members, [&](std::uint32_t m) { return usable(m); }, may_cross)) {
      for (const Mesh::Edge* e : ends) try_line(e);
      return true;
    }
  }
  return false;
}

Failure Resolver::hide(const Beam& beam, const std::vector<Entry>& list, const Entry& entry, bool by_sides) {
  Hiding hiding(*this, beam, list, entry);
  const Failure failure = hiding.all();
  return by_sides && failure != Failure::seen && failure != Failure::none && hiding.by_sides() ? Failure::none
                                                                                               : failure;
}

}  // namespace provis::offset
