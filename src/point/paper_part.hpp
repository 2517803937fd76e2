#pragma once
// Algorithm 2 of Popescu et al. in one rectangle of the window: subdivision, classification, new sampling
// locations, until nothing is undecided.

#include "src/point/arrangement.hpp"
#include "src/point/block_descent.hpp"
#include "src/point/findings.hpp"
#include "src/point/fragment.hpp"
#include "src/point/paper_subdivision.hpp"
#include "src/point/sampling_locations.hpp"

namespace provis {

/// What all rectangles of a frame share.
template <Arithmetic A>
struct PaperFrameData {
  const FrameQuery& query;
  const Facets& facets;
  const WindowMap& map;
  SeenFacets& aggressive;   ///< the set to start from; not changed any more
  SeenFacets& found;        ///< visible beside those
  SeenFacets& found_first;  ///< those found by a first iteration
  SeenFacets& undecided;    ///< not decided by the first iteration of some rectangle
};

template <Arithmetic A>
class PaperPart {
 public:
  using List = std::vector<std::uint32_t>;

  /// list: every facet that may be seen in the rectangle, ascending.
  PaperPart(const PaperFrameData<A>& data, const Window& window, const List& list, Outcome& outcome)
      : data_(data),
        list_(list),
        outcome_(outcome),
        signs_(data.query.geometry, outcome.stats.signs),
        tile_(make_tile(signs_, window)),
        findings_(data.query, data.facets, data.found, outcome),
        part_(signs_, data.facets),
        leaf_(signs_, data.facets, part_, tile_, list),
        subdivision_(signs_, data.facets, part_, data.map, tile_) {}

  void run();

 private:
  void iterate(List& undecided);
  List unhidden(const List& undecided, SamplingLocations<A>& locations, List& unsampled);
  bool sample(const Cell& overlap, std::uint32_t nearest, SamplingLocations<A>& locations);
  List render(const List& undecided, SamplingLocations<A>& locations);
  void insert(std::uint32_t facet);
  void report();

  const PaperFrameData<A>& data_;
  const List& list_;
  Outcome& outcome_;
  Signs<A> signs_;
  const Tile tile_;
  Findings<A> findings_;
  PartLines<A> part_;
  Leaf<A, QueryEffects{}> leaf_;  ///< of all facets, for what no location decides
  PaperSubdivision<A> subdivision_;
};

template <Arithmetic A>
void PaperPart<A>::run() {
  List undecided;
  for (const std::uint32_t f : list_)
    if (!data_.aggressive.get(f)) undecided.push_back(f);
  if (!undecided.empty()) {
    for (const std::uint32_t f : list_)
      if (data_.aggressive.get(f) && data_.facets.facets[f].occludes) subdivision_.insert(f, false);
    IterationStats& stats = outcome_.stats.iteration;
    while (!undecided.empty()) {
      iterate(undecided);
      if (++stats.iterations > 1) continue;
      for (const std::uint32_t f : list_)
        if (findings_.seen_here(f)) data_.found_first.set(f);
      for (const std::uint32_t f : undecided) data_.undecided.set(f);
    }
    stats.area_missed += subdivision_.area_missed();
  }
  if (data_.query.options.subdivision) report();
}

/// Drops what the subdivision hides and finds some of the rest; what is left is looked at again. A round that
/// finds nothing, and a facet that no certain location sees, is decided exactly instead, so that this ends.
template <Arithmetic A>
void PaperPart<A>::iterate(List& undecided) {
  SamplingLocations<A> locations(signs_, data_.facets, subdivision_.lines());
  List singles;
  undecided = unhidden(undecided, locations, singles);
  const List found = render(undecided, locations);
  if (found.empty()) singles = undecided;
  for (const std::uint32_t f : found) {
    findings_.see(f, leaf_);
    insert(f);
  }
  for (const std::uint32_t f : singles) {
    if (findings_.seen_here(f)) continue;
    ++outcome_.stats.iteration.subtracted;
    if (findings_.decide(leaf_, f)) insert(f);
  }
  std::erase_if(undecided, [&](std::uint32_t f) {
    return findings_.seen_here(f) || std::binary_search(singles.begin(), singles.end(), f);
  });
}

/// Those that the subdivision does not hide. Each of them gets locations where it is not hidden; those for
/// which none is certain go to `unsampled`, too.
template <Arithmetic A>
typename PaperPart<A>::List PaperPart<A>::unhidden(const List& undecided, SamplingLocations<A>& locations,
                                                   List& unsampled) {
  List rest;
  for (const std::uint32_t f : undecided) {
    bool hidden = true, sampled = false;
    subdivision_.for_unhidden(f, [&](const Cell& overlap, std::uint32_t nearest) {
      hidden = false;
      sampled |= sample(overlap, nearest, locations);
    });
    if (hidden) continue;
    rest.push_back(f);
    if (!sampled) unsampled.push_back(f);
  }
  outcome_.stats.sampling.locations += locations.size();
  return rest;
}

/// Places near the corners of what is not hidden, or in its middle; returns whether there is one.
template <Arithmetic A>
bool PaperPart<A>::sample(const Cell& overlap, std::uint32_t nearest, SamplingLocations<A>& locations) {
  constexpr double inwards = 1.0 / 16;
  const auto add = [&](const Vec3d& at) {
    const std::uint32_t k = locations.add(at.x, at.y);
    // Inside a cell of the subdivision no occluder that it was made of comes before the nearest one.
    if (nearest != no_id) locations.offer(k, nearest);
  };
  const Vec3d middle = middle_of(signs_, overlap);
  bool any = false;
  for (const Direction& v : overlap.vertices) {
    const Vec3d at = (1 - inwards) * window_coordinates(signs_.geometry(), v.approx.v) + inwards * middle;
    if (!quickly_inside(signs_, overlap, at)) continue;
    add(at);
    any = true;
  }
  if (any) return true;
  if (!certainly_inside(signs_, overlap, middle)) return false;
  add(middle);
  return true;
}

/// The undecided facets that are seen at the locations, ascending.
template <Arithmetic A>
typename PaperPart<A>::List PaperPart<A>::render(const List& undecided, SamplingLocations<A>& locations) {
  for (const std::uint32_t f : undecided) {
    const Window& box = data_.facets.facets[f].box;
    for (std::uint32_t k = 0; k < locations.size(); ++k)
      if (box.x0 <= locations[k].x && locations[k].x <= box.x1 && box.y0 <= locations[k].y &&
          locations[k].y <= box.y1)
        locations.offer(k, f);
  }
  List found;
  locations.resolve([&](std::uint32_t, std::uint32_t f, Look look) {
    if (look == Look::visible && std::binary_search(undecided.begin(), undecided.end(), f))
      found.push_back(f);
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

template <Arithmetic A>
void PaperPart<A>::insert(std::uint32_t facet) {
  if (data_.facets.facets[facet].occludes) subdivision_.insert(facet, true);
}

/// The subdivision of everything visible here, with exact areas.
template <Arithmetic A>
void PaperPart<A>::report() {
  List visible;
  for (const std::uint32_t f : list_)
    if (data_.aggressive.get(f) || findings_.seen_here(f)) visible.push_back(f);
  Arrangement<A, QueryEffects{}>(signs_, data_.facets, part_, tile_, visible)
      .report(data_.query.frame, outcome_.cells);
}

/// Algorithm 2 on a whole frame, after Algorithm 1.
template <Arithmetic A>
class PaperFrame {
 public:
  explicit PaperFrame(const PaperFrameData<A>& data) : data_(data) {}

  Outcome run() const { return BlockDescent(data_.query, data_.facets, *this).run(data_.query.window); }

  // What the descent asks for.
  using Part = Window;
  bool takes(const Window& window, const std::vector<std::uint32_t>& list, DescentState at) const;
  std::pair<Window, Window> halves(const Window& window, int axis) const {
    return provis::halves(window, axis);
  }
  Window window(const Window& window) const { return window; }
  double share() const { return 0.5; }
  Outcome operator()(const Window& window, const std::vector<std::uint32_t>& list) const {
    Outcome outcome;
    const RoundingGuard<A> guard;
    ++outcome.stats.leaves;
    PaperPart<A>(data_, window, list, outcome).run();
    return outcome;
  }

 private:
  static constexpr std::size_t few = 32, few_visible = 12, many = 256;
  static constexpr int most_stalls = 3, most_depth = 48;

  const PaperFrameData<A>& data_;
};

/// Inserting k facets costs about k^2, classifying the others much less.
template <Arithmetic A>
bool PaperFrame<A>::takes(const Window& window, const std::vector<std::uint32_t>& list,
                          DescentState at) const {
  if (list.size() <= few || at.stalls >= most_stalls || at.depth >= most_depth ||
      !proper(halves(window, at.axis)))
    return true;
  const auto visible = static_cast<std::size_t>(
      std::count_if(list.begin(), list.end(), [&](std::uint32_t f) { return data_.aggressive.get(f); }));
  if (visible == list.size()) return !data_.query.options.subdivision;
  return visible <= few_visible && list.size() <= many;
}

}  // namespace provis
