#include "src/offset/resolver.hpp"

#include <algorithm>
#include <cmath>

#include "src/offset/sight_line.hpp"
#include "src/offset/target.hpp"

namespace provis::offset {

std::optional<Cover> Resolver::cover(const Beam& beam, const std::vector<Entry>& list) {
  // Where a window leads back into the cell too, only the rays that leave it count.
  const Interval& out = component(beam.ray, beam.face.axis);
  if (!(beam.face.upper ? out.inf() > 0 : out.sup() < 0)) return std::nullopt;
  const SightLine middle(beam.viewpoint, beam.viewpoint + beam.ray);
  const auto any = [](std::uint32_t) { return true; };
  const auto reaches = [&](const Mesh::Edge& e) { return !misses(*e.ends[0], *e.ends[1], beam.spaces); };
  std::size_t seeds = 0;
  for (const Entry& entry : list) {
    const Facet& f = facets_[entry.facet];
    if (!f.occludes || middle.aims_at(f) != true) continue;
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
           return entry.cut ? lies_beyond(facets_[m], facet, *entry.cut) : lies_beyond(facets_[m], facet);
         });
}

/// One entry against the occluders of its list.
class Resolver::Hiding {
 public:
  Hiding(Resolver& resolver, const Beam& beam, const Shadows& shadows, const Entry& entry)
      : resolver_(resolver),
        facets_(resolver.facets_),
        beam_(beam),
        shadows_(shadows),
        entry_(entry),
        polygon_(polygon_of(entry, facets_[entry.facet])),
        target_(facets_[entry.facet], polygon_, beam.face) {}

  Failure all();
  bool by_sides();

 private:
  bool usable(std::uint32_t m) const {
    return m != entry_.facet && (target_.box_apart_from(facets_[m]) || target_.lies_beyond(facets_[m]));
  }
  /// Whether what grows from the seed hides the target, as far as edges may be crossed.
  template <class MayCross>
  bool hides(std::uint32_t seed, const MayCross& may_cross) {
    const auto usable = [&](std::uint32_t m) { return this->usable(m); };
    return resolver_.fusion_.grow(seed, most_members, usable, may_cross).has_value();
  }
  bool on_side(const Side& side);
  void try_line(const Mesh::Edge* line) {
    if (line && std::find(lines_.begin(), lines_.end(), line) == lines_.end()) lines_.push_back(line);
  }

  Resolver& resolver_;
  const std::vector<Facet>& facets_;
  const Beam& beam_;
  const Shadows& shadows_;
  const Entry& entry_;
  Polygon polygon_;
  Target target_;
  std::vector<const Mesh::Edge*> lines_;  ///< that may divide the segments, the most promising first
};

/// All segments at once.
Failure Resolver::Hiding::all() {
  const Point to = inner_point(polygon_), from = beam_.viewpoint_towards(to);
  const SightLine sight(from, to);
  const auto may_cross = [&](const Mesh::Edge& e) { return target_.may_meet(e); };
  // What hid the last triangle often hides this one.
  std::uint32_t& last = resolver_.last_seed_;
  if (last < facets_.size() && sight.crosses(facets_[last]) == true && hides(last, may_cross))
    return Failure::none;
  std::size_t seeds = 0;
  bool clear = target_.facet().faced && resolver_.shafts_.holds(beam_.directions, to - from), hidden = false;
  Failure first = Failure::nothing_between;
  shadows_.along(from, to, entry_.far, [&](std::uint32_t occluder) {
    const Facet& f = facets_[occluder];
    if (occluder == entry_.facet || (!f.occludes && !clear)) return false;
    const std::optional<bool> crossed = sight.crosses(f);
    clear = clear && crossed == false;
    if (!f.occludes || crossed != true) return false;
    if (++seeds > most_seeds) return true;
    hidden = hides(occluder, may_cross);
    if (hidden) {
      last = occluder;
      return true;
    }
    try_line(resolver_.fusion_.open_edge());
    if (seeds == 1) first = resolver_.fusion_.failure();
    return false;
  });
  return hidden ? Failure::none : clear ? Failure::seen : first;
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
  const SightLine sight(segment->from, segment->to);
  std::vector<const Mesh::Edge*> ends;  // of what hides this side, on the other side
  const auto may_cross = [&](const Mesh::Edge& e) {
    if (!target_.may_meet(e)) return false;
    if (!side.leaves_out(e)) return true;
    ends.push_back(&e);
    return false;
  };
  std::size_t seeds = 0;
  bool hidden = false;
  shadows_.along(segment->from, segment->to, entry_.far, [&](std::uint32_t occluder) {
    const Facet& f = facets_[occluder];
    if (!f.occludes || occluder == entry_.facet || sight.crosses(f) != true) return false;
    if (++seeds > most_seeds) return true;
    ends.clear();
    hidden = hides(occluder, may_cross);
    return hidden;
  });
  if (hidden)
    for (const Mesh::Edge* e : ends) try_line(e);
  return hidden;
}

Failure Resolver::hide(const Beam& beam, const Shadows& shadows, const Entry& entry, bool by_sides) {
  Hiding hiding(*this, beam, shadows, entry);
  const Failure failure = hiding.all();
  return by_sides && failure != Failure::seen && failure != Failure::none && hiding.by_sides() ? Failure::none
                                                                                               : failure;
}

}  // namespace provis::offset
