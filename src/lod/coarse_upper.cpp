#include "src/lod/coarse_upper.hpp"

#include <algorithm>

#include "predicates/environment.hpp"
#include "src/lod/parts.hpp"
#include "src/offset/offset_space.hpp"
#include "src/scene/parallel.hpp"

namespace provis::lod {
namespace {

using Parts = LevelOfDetail::Parts;

/// What is settled of an object before any ray is looked at.
struct Place {
  bool asked = false;      ///< some primitive of it is wanted
  bool whole = false;      ///< the cell may be in its shell
  bool candidate = false;  ///< not hidden
  bool dropped = false;    ///< it has occluders, and the cell may be in what they were inscribed to
};

Place place(const Object& object, const ViewCell& cell, const Asked& asked) {
  const auto any = [&](const std::vector<char>& of) {
    return std::any_of(object.full.begin(), object.full.end(), [&](PrimitiveId id) { return of[id]; });
  };
  Place p;
  p.asked = any(asked.wanted);
  p.whole = object.shell.may_hold_part_of(cell);
  // What sees a primitive sees the shell before it, or starts inside.
  p.candidate = p.whole || any(asked.seen);
  p.dropped = object.solid && object.solid->may_hold_part_of(cell);
  return p;
}

std::vector<Place> places(const Parts& parts, const ViewCell& cell, const Asked& asked,
                          const Context& context) {
  std::vector<Place> all(parts.objects.size());
  on_threads(context, [&] {
    parallel_for(all.size(), [&](std::size_t k) {
      const RoundUp guard;
      all[k] = place(parts.objects[k], cell, asked);
    });
  });
  return all;
}

/// The scene in which is looked, and what each of its triangles stands for.
struct Substitute {
  SceneArrays arrays;
  std::vector<char> wanted;
  std::vector<std::uint32_t> object;  ///< by triangle; no_object where it stands for itself or occludes
  std::vector<PrimitiveId> full;      ///< by triangle: the one that stands for itself

  void add(const Scene& scene, PrimitiveId t, int flags, bool is_wanted, std::uint32_t of_object) {
    const auto first = static_cast<std::uint32_t>(arrays.vertices.size());
    for (int k = 0; k < 3; ++k) arrays.vertices.push_back(scene.corner(t, k));
    arrays.triangles.push_back({first, first + 1, first + 2});
    arrays.triangle_flags.push_back(static_cast<std::uint8_t>(flags));
    wanted.push_back(is_wanted);
    object.push_back(of_object);
    full.push_back(t);
  }
};

Substitute substitute(const Parts& parts, const std::vector<Place>& places, const Asked& asked) {
  Substitute s;
  for (PrimitiveId id = 0; id < parts.object_of.size(); ++id)
    if (parts.object_of[id] == no_object)
      s.add(*parts.full, id, parts.full->triangle_flags()[id], asked.wanted[id], no_object);
  for (std::uint32_t k = 0; k < places.size(); ++k) {
    const Object& o = parts.objects[k];
    if (o.solid && !places[k].dropped)
      for (const PrimitiveId id : o.occluders) s.add(*parts.occluders, id, 0, false, no_object);
    if (places[k].asked && !places[k].candidate)
      for (const PrimitiveId id : o.shell.triangles()) s.add(*parts.shell, id, see_through, true, k);
  }
  return s;
}

}  // namespace

CoarseUpper reach(const LevelOfDetail& detail, const ViewCell& cell, const Asked& asked,
                  const PixelGrid& pixels, int refinements, const Context& context, ProgressMeter& meter) {
  const Parts& parts = detail.parts();
  std::vector<Place> all = places(parts, cell, asked, context);
  const Substitute s = substitute(parts, all, asked);
  const offset::UpperSet coarse =
      offset::reach(Scene(s.arrays), cell, s.wanted, pixels, refinements, context, meter);

  CoarseUpper upper;
  upper.stats = coarse.stats;
  upper.reached.assign(asked.wanted.size(), 0);
  for (std::size_t t = 0; t < coarse.reached.size(); ++t) {
    if (!coarse.reached[t]) continue;
    if (s.object[t] == no_object)
      upper.reached[s.full[t]] = 1;
    else
      all[s.object[t]].candidate = true;
  }
  DetailStats& counts = upper.counts;
  counts.seconds_verification = parts.seconds;
  counts.objects = all.size();
  counts.triangles = s.wanted.size();
  for (std::size_t k = 0; k < all.size(); ++k) {
    counts.whole += all[k].whole;
    counts.candidates += all[k].candidate;
    counts.dropped += all[k].dropped;
    if (!all[k].candidate) continue;
    for (const PrimitiveId id : parts.objects[k].full) upper.reached[id] = asked.wanted[id];
  }
  return upper;
}

}  // namespace provis::lod
