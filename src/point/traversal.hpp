#pragma once
// The descent: halves a part of the window until a rectangle holds few facets, drops what certainly lies
// outside or behind, and resolves what is left.

#include <atomic>

#include "provis/point.hpp"
#include "src/point/arrangement.hpp"
#include "src/point/leaf_subdivision.hpp"
#include "src/point/outcome.hpp"
#include "src/point/patch.hpp"
#include "src/scene/progress_meter.hpp"

namespace provis {

/// One facet in the list of a rectangle.
struct Item {
  std::uint32_t facet = 0;
  std::uint8_t open = 0xf;  ///< lines of its cone that are not known to hold all of the rectangle
};

/// Facets already known to be visible. Shared by all threads where only the set is asked for; private to a
/// part of the window where the answer also says where each was seen, which must not depend on the threads.
class SeenFacets {
 public:
  explicit SeenFacets(std::size_t size) : flags_(size, 0) {}
  explicit SeenFacets(std::vector<std::uint8_t> known) : flags_(std::move(known)) {}
  bool get(std::uint32_t slot) { return ref(slot).load(std::memory_order_relaxed) != 0; }
  /// Returns whether it was new.
  bool set(std::uint32_t slot) { return ref(slot).exchange(1, std::memory_order_relaxed) == 0; }

 private:
  std::atomic_ref<std::uint8_t> ref(std::uint32_t slot) { return std::atomic_ref(flags_[slot]); }
  std::vector<std::uint8_t> flags_;
};

struct FrameQuery {
  const ViewGeometry& geometry;
  int frame = 0;
  Window window;
  const PointOptions& options;
  const Context& context;
  ProgressMeter& progress;
};

/// Looks at one part of the window, on one thread.
template <Arithmetic A, QueryEffects E>
class Traversal {
 public:
  /// seen: by primitive id where it is shared, else by index into the facets.
  Traversal(const FrameQuery& query, Signs<A>& signs, const Facets& facets, SeenFacets& seen, bool shared,
            Outcome& outcome)
      : query_(query),
        signs_(signs),
        facets_(facets),
        lines_(signs, facets),
        patch_(facets),
        seen_(seen),
        shared_(shared),
        outcome_(outcome) {}

  void run(const Window& part);

 private:
  static constexpr bool quick = A == Arithmetic::chain || A == Arithmetic::doubles;
  static constexpr std::size_t small_leaf = quick ? 128 : 32;  ///< one by one, facets cost the square of it
  static constexpr std::size_t large_leaf = quick ? 256 : 32;  ///< where few cells hide all the rest
  static constexpr std::size_t largest_patch = 192;            ///< of a rectangle that is about to be halved
  static constexpr std::size_t most_alone = 2;  ///< facets of a leaf that are decided one by one
  static constexpr int most_vain = 8;           ///< rays in a row that show nothing
  static constexpr int most_stalls = 3;         ///< halvings in a row that separate nothing
  /// Where a fan's vertex meets a halving line, one half keeps the whole fan for as long as there are
  /// numbers.
  static constexpr int most_depth = 40;

  using Items = std::vector<Item>;
  using Members = std::vector<std::uint32_t>;

  struct Descent {
    int depth = 0;
    int stalls = 0;  ///< halvings in a row that separate nothing
    int axis = 0;    ///< to be halved next
  };

  void descend(Items& items, const Window& window, const Descent& at);
  void narrow(const Window& window, Items& items) const;
  void cull_behind_cover(const Window& window, Items& items);
  void resolve(const Tile& tile, const Items& items);
  void resolve_quickly(Leaf<A, E>& leaf, const Tile& tile);
  Members open_after_glances(Leaf<A, E>& leaf);
  void share(Leaf<A, E>& leaf, LeafSubdivision<A, E>& subdivision);
  void decide(Leaf<A, E>& leaf, LeafSubdivision<A, E>& subdivision, std::uint32_t facet);
  void see_all(Leaf<A, E>& leaf, LeafSubdivision<A, E>& subdivision);
  void see(Leaf<A, E>& leaf, std::uint32_t facet, const FacetSight& sight);
  std::uint32_t slot(std::uint32_t facet) const { return shared_ ? facets_.facets[facet].id : facet; }

  const FrameQuery& query_;
  Signs<A>& signs_;
  const Facets& facets_;
  PartLines<A> lines_;
  Patch patch_;
  SeenFacets& seen_;
  bool shared_;
  Outcome& outcome_;
  std::size_t leaf_size_ = small_leaf;  ///< as the last leaf that was shared suggests: neighbours are alike
};

inline std::pair<Window, Window> halves(const Window& w, int axis) {
  Window a = w, b = w;
  if (axis == 0)
    a.x1 = b.x0 = w.x0 / 2 + w.x1 / 2;
  else
    a.y1 = b.y0 = w.y0 / 2 + w.y1 / 2;
  return {a, b};
}

/// Alternately, but along the same axis again where a half is empty: across a window much wider than what is
/// seen in it, each halving of the other axis would double the work for nothing.
inline int next_axis(int axis, bool half_is_empty) { return half_is_empty ? axis : 1 - axis; }

/// Whether both halves have an extent: a window may be a few ulps wide.
inline bool proper(const std::pair<Window, Window>& h) {
  const auto ok = [](const Window& w) { return w.x0 < w.x1 && w.y0 < w.y1; };
  return ok(h.first) && ok(h.second);
}

template <Arithmetic A, QueryEffects E>
void Traversal<A, E>::run(const Window& part) {
  Items items(facets_.facets.size());
  for (std::uint32_t f = 0; f < items.size(); ++f) {
    const bool cut = E.front_clip && facets_.facets[f].cut;
    items[f] = {f, static_cast<std::uint8_t>(cut ? 0xf : 0x7)};
  }
  descend(items, part, {});
}

template <Arithmetic A, QueryEffects E>
void Traversal<A, E>::descend(Items& items, const Window& window, const Descent& at) {
  if (query_.context.cancelled()) throw Error(Error::Code::cancelled, "point", "interrupted");
  ++outcome_.stats.nodes;
  narrow(window, items);
  cull_behind_cover(window, items);
  const bool done =
      std::all_of(items.begin(), items.end(), [&](const Item& i) { return seen_.get(slot(i.facet)); });
  if (done && !query_.options.subdivision) return;

  const auto h = halves(window, at.axis);
  if (items.size() <= leaf_size_ || at.stalls >= most_stalls || at.depth >= most_depth || !proper(h)) {
    resolve(make_tile(signs_, window), items);
    return;
  }
  Items a, b;
  for (const Item& item : items) {
    const Window& box = facets_.facets[item.facet].box;
    if (overlap(box, h.first)) a.push_back(item);
    if (overlap(box, h.second)) b.push_back(item);
  }
  const bool stalled = 10 * std::min(a.size(), b.size()) > 9 * items.size();
  const bool half_is_empty = a.empty() || b.empty();
  items = {};
  const Descent next{at.depth + 1, stalled ? at.stalls + 1 : 0, next_axis(at.axis, half_is_empty)};
  descend(a, h.first, next);
  descend(b, h.second, next);
}

/// Drops facets that certainly have no hit in the window; notes which lines of their cones hold all of it.
template <Arithmetic A, QueryEffects E>
void Traversal<A, E>::narrow(const Window& window, Items& items) const {
  const auto outside = [&](Item& item) {
    const Facet& f = facets_.facets[item.facet];
    if (!overlap(f.box, window)) return true;
    for (int k = 0; k < 3; ++k) {
      if (!(item.open & (1 << k))) continue;
      if (f.inside[k].highest(window) < 0) return true;
      if (f.inside[k].lowest(window) > 0) item.open = static_cast<std::uint8_t>(item.open & ~(1 << k));
    }
    return false;
  };
  items.erase(std::remove_if(items.begin(), items.end(), outside), items.end());
}

/// Finds an occluder that covers the whole window, one that hides as much as any, and drops what it hides;
/// where no triangle does, a patch of several.
template <Arithmetic A, QueryEffects E>
void Traversal<A, E>::cull_behind_cover(const Window& window, Items& items) {
  const auto facet = [&](const Item& i) -> const Facet& { return facets_.facets[i.facet]; };
  const Facet* cover = nullptr;
  double best = -HUGE_VAL;
  for (const Item& item : items) {
    if (item.open != 0 || !facet(item).occludes) continue;
    if (const double lowest = facet(item).depth.lowest(window); lowest > best) {
      best = lowest;
      cover = &facet(item);
    }
  }
  if (cover != nullptr) {
    std::erase_if(items, [&](const Item& item) {
      return &facet(item) != cover && difference(cover->depth, facet(item).depth).lowest(window) > 0;
    });
    return;
  }
  if (items.size() <= leaf_size_ || items.size() > largest_patch) return;
  patch_.clear();
  for (const Item& item : items)
    if (facet(item).occludes && !(E.front_clip && facet(item).cut)) patch_.add(item.facet, window);
  best = patch_.cover(window);
  std::erase_if(items, [&](const Item& item) { return facet(item).depth.highest(window) < best; });
}

template <Arithmetic A, QueryEffects E>
void Traversal<A, E>::resolve(const Tile& tile, const Items& items) {
  ++outcome_.stats.leaves;
  Members members;
  for (const Item& i : items) members.push_back(i.facet);
  Leaf<A, E> leaf(signs_, facets_, lines_, tile, members);
  if constexpr (quick)
    resolve_quickly(leaf, tile);
  else
    for (const std::uint32_t f : members) {
      if (seen_.get(slot(f))) continue;
      const FacetSight sight = leaf.look(f);
      ++outcome_.stats.subtractions;
      if (sight.visible) see(leaf, f, sight);
    }
  if (query_.options.subdivision)
    Arrangement<A, E>(signs_, facets_, lines_, tile, members).report(query_.frame, outcome_.cells);
}

/// One ray each, and what is left one by one or, where that is much, all together.
template <Arithmetic A, QueryEffects E>
void Traversal<A, E>::resolve_quickly(Leaf<A, E>& leaf, const Tile& tile) {
  const Members open = open_after_glances(leaf);
  if (open.empty()) return;
  LeafSubdivision<A, E> subdivision(signs_, facets_, leaf.lines(), leaf.cutter(), tile);
  if (open.size() > most_alone && 3 * open.size() > leaf.members().size()) {
    share(leaf, subdivision);
    return;
  }
  for (const std::uint32_t f : open) decide(leaf, subdivision, f);
}

/// What lies at the back is mostly hidden: after some rays in a row that show nothing, none are tried.
template <Arithmetic A, QueryEffects E>
typename Traversal<A, E>::Members Traversal<A, E>::open_after_glances(Leaf<A, E>& leaf) {
  Members open;
  int vain = 0;
  for (const auto& [f, nearest] : leaf.members()) {
    if (seen_.get(slot(f))) continue;
    FacetSight sight;
    if (vain < most_vain && leaf.glance(f, sight)) {
      see(leaf, f, sight);
      vain = 0;
    } else {
      ++vain;
      open.push_back(f);
    }
  }
  return open;
}

/// Decides all members together.
template <Arithmetic A, QueryEffects E>
void Traversal<A, E>::share(Leaf<A, E>& leaf, LeafSubdivision<A, E>& subdivision) {
  for (const OrderedFacet& m : leaf.members()) {
    if (subdivision.too_many()) break;
    subdivision.insert(m);
  }
  // The cells of a subdivision must not depend on what other threads have seen by now.
  if (!query_.options.subdivision)
    leaf_size_ = 2 * subdivision.size() > leaf.members().size() ? small_leaf : large_leaf;
  outcome_.stats.subtractions += leaf.members().size();
  see_all(leaf, subdivision);
}

/// Decides one facet: takes away what the others hide of it.
template <Arithmetic A, QueryEffects E>
void Traversal<A, E>::decide(Leaf<A, E>& leaf, LeafSubdivision<A, E>& subdivision, std::uint32_t facet) {
  Members rivals = leaf.rivals(facet);
  if (FacetSight sight; leaf.glimpse(facet, rivals, sight)) {
    see(leaf, facet, sight);
    return;
  }
  ++outcome_.stats.subtractions;
  subdivision.restrict_to(facet);
  for (const std::uint32_t o : rivals)
    if (subdivision.too_many() || !subdivision.subtract(o)) break;
  see_all(leaf, subdivision);
}

/// What is seen in some cell.
template <Arithmetic A, QueryEffects E>
void Traversal<A, E>::see_all(Leaf<A, E>& leaf, LeafSubdivision<A, E>& subdivision) {
  subdivision.for_visible([&](std::uint32_t f, const auto& cell) {
    if (seen_.get(slot(f))) return;
    FacetSight sight;
    sight.visible = true;
    if (query_.options.witnesses) sight.cell = cell();
    see(leaf, f, sight);
  });
}

template <Arithmetic A, QueryEffects E>
void Traversal<A, E>::see(Leaf<A, E>& leaf, std::uint32_t facet, const FacetSight& sight) {
  if (sight.sampled) ++outcome_.stats.samples;
  if (!seen_.set(slot(facet))) return;
  outcome_.found.push_back(facets_.facets[facet].id);
  if (query_.options.witnesses) outcome_.witnesses.push_back(leaf.witness(facet, sight));
}

}  // namespace provis
