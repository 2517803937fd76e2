#pragma once
// The descent: halves the window until a rectangle holds few facets, drops what certainly lies outside or
// behind, and resolves what is left.

#include <atomic>
#include <mutex>

#include "provis/point.hpp"
#include "src/point/arrangement.hpp"
#include "src/point/guard.hpp"
#include "src/point/outcome.hpp"
#include "src/scene/parallel.hpp"

namespace provis {

/// One facet in the list of a rectangle.
struct Item {
  std::uint32_t facet = 0;
  std::uint32_t slot = 0;   ///< where `seen` is kept
  std::uint8_t open = 0xf;  ///< lines of its cone that are not known to hold all of the rectangle
};

/// Facets already known to be visible. Shared by all threads where only the set is asked for; private to a
/// part of the window where the answer also says where each was seen, which must not depend on the threads.
class Seen {
 public:
  explicit Seen(std::size_t size) : flags_(size, 0) {}
  bool get(std::uint32_t slot) { return ref(slot).load(std::memory_order_relaxed) != 0; }
  /// Returns whether it was new.
  bool set(std::uint32_t slot) { return ref(slot).exchange(1, std::memory_order_relaxed) == 0; }

 private:
  std::atomic_ref<std::uint8_t> ref(std::uint32_t slot) { return std::atomic_ref(flags_[slot]); }
  std::vector<std::uint8_t> flags_;
};

/// Reports progress for the whole query, from one thread at a time.
class ProgressMeter {
 public:
  ProgressMeter(const Context& context, double total) : context_(context), total_(total) {}
  void add(double share) {
    if (!context_.on_progress) return;
    const std::lock_guard lock(mutex_);
    done_ += share;
    context_.on_progress({done_, total_});
  }

 private:
  const Context& context_;
  double total_, done_ = 0;
  std::mutex mutex_;
};

struct FrameQuery {
  const ViewGeometry& geometry;
  int frame = 0;
  Window window;
  const PointOptions& options;
  const Context& context;
  ProgressMeter& progress;
};

template <Arithmetic A, QueryEffects E>
class Traversal {
 public:
  using FacetType = Facet<typename HotNumber<A>::type>;

  /// known: per primitive of the scene, whether it needs no further proof.
  Traversal(const FrameQuery& query, const Facets<A>& facets, const std::vector<std::uint8_t>& known)
      : query_(query), facets_(facets), known_(known), shared_(facets.facets.size()) {}

  Outcome run();

 private:
  static constexpr int task_depth = 8;  ///< 256 parts of the window, each one task
  static constexpr std::size_t leaf_size = 24;
  static constexpr int most_stalls = 3;  ///< halvings in a row that separate nothing
  /// Where a fan's vertex meets a halving line, one half keeps the whole fan for as long as there are
  /// numbers.
  static constexpr int most_depth = 48;

  using Items = std::vector<Item>;

  /// The state of one task: a part of the window looked at by one thread.
  struct Part {
    Signs<A> signs;
    Outcome& outcome;
    Seen& seen;
  };

  Outcome split_in_tasks(Items items, const Window& window, int depth);
  Outcome run_part(Items& items, const Window& window, int depth);
  void descend(Part& part, Items& items, const Window& window, int depth, int stalls);
  void narrow(Part& part, const Tile& tile, Items& items) const;
  void cull_behind_cover(Part& part, const Tile& tile, Items& items) const;
  bool behind(Signs<A>& signs, const Tile& tile, std::uint32_t cover, std::uint32_t facet) const;
  Items inside(Part& part, const Items& items, const Line& border) const;
  void resolve(Part& part, const Tile& tile, const Items& items);
  void decide(Part& part, Leaf<A, E>& leaf, const Item& item);

  /// Whether what is found, and where, must not depend on the order of work. Rounded signs make even the
  /// set depend on it.
  bool canonical() const { return query_.options.witnesses || A == Arithmetic::doubles; }

  const FrameQuery& query_;
  const Facets<A>& facets_;
  const std::vector<std::uint8_t>& known_;
  Seen shared_;
};

inline std::pair<Window, Window> halves(const Window& w, int depth) {
  Window a = w, b = w;
  if (depth % 2 == 0)
    a.x1 = b.x0 = w.x0 / 2 + w.x1 / 2;
  else
    a.y1 = b.y0 = w.y0 / 2 + w.y1 / 2;
  return {a, b};
}

/// Whether both halves have an extent: a window may be a few ulps wide.
inline bool proper(const std::pair<Window, Window>& h) {
  const auto ok = [](const Window& w) { return w.x0 < w.x1 && w.y0 < w.y1; };
  return ok(h.first) && ok(h.second);
}

template <Arithmetic A, QueryEffects E>
Outcome Traversal<A, E>::run() {
  Items items(facets_.facets.size());
  for (std::uint32_t f = 0; f < items.size(); ++f) {
    const bool cut = E.front_clip && facets_.facets[f].cut;
    items[f] = {f, f, static_cast<std::uint8_t>(cut ? 0xf : 0x7)};
    if (known_[facets_.facets[f].id]) shared_.set(f);
  }
  return split_in_tasks(std::move(items), query_.window, 0);
}

/// Halves the window into tasks; what lies where is settled with the same tests as further down.
template <Arithmetic A, QueryEffects E>
Outcome Traversal<A, E>::split_in_tasks(Items items, const Window& window, int depth) {
  const auto split = halves(window, depth);
  if (depth == task_depth || items.size() <= leaf_size || !proper(split)) {
    Outcome outcome = run_part(items, window, depth);
    query_.progress.add(std::ldexp(1.0, -depth));
    return outcome;
  }
  const auto half = [&](const Window& w) {
    Items mine;
    Outcome outcome;
    {
      const RoundingGuard<A> guard;
      Part part{{query_.geometry, outcome.stats.signs}, outcome, shared_};
      const Tile tile = make_tile(part.signs, w);
      // Of the four borders only one is new.
      const std::size_t border =
          depth % 2 == 0 ? (w.x0 == window.x0 ? 2u : 0u) : (w.y0 == window.y0 ? 3u : 1u);
      mine = inside(part, items, tile.borders[border]);
      narrow(part, tile, mine);
      cull_behind_cover(part, tile, mine);
    }
    outcome.add(split_in_tasks(std::move(mine), w, depth + 1));
    return outcome;
  };
  Outcome a, b;
  parallel_invoke([&] { a = half(split.first); }, [&] { b = half(split.second); });
  a.add(std::move(b));
  return a;
}

template <Arithmetic A, QueryEffects E>
Outcome Traversal<A, E>::run_part(Items& items, const Window& window, int depth) {
  Outcome outcome;
  const RoundingGuard<A> guard;
  if (!canonical()) {
    Part part{{query_.geometry, outcome.stats.signs}, outcome, shared_};
    descend(part, items, window, depth, 0);
    return outcome;
  }
  Seen own(items.size());
  for (std::uint32_t k = 0; k < items.size(); ++k) {
    items[k].slot = k;
    if (known_[facets_.facets[items[k].facet].id]) own.set(k);
  }
  Part part{{query_.geometry, outcome.stats.signs}, outcome, own};
  descend(part, items, window, depth, 0);
  return outcome;
}

template <Arithmetic A, QueryEffects E>
void Traversal<A, E>::descend(Part& part, Items& items, const Window& window, int depth, int stalls) {
  if (query_.context.cancelled()) throw Error(Error::Code::cancelled, "point", "interrupted");
  ++part.outcome.stats.nodes;
  const Tile tile = make_tile(part.signs, window);
  narrow(part, tile, items);
  cull_behind_cover(part, tile, items);
  const bool done =
      std::all_of(items.begin(), items.end(), [&](const Item& i) { return part.seen.get(i.slot); });
  if (done && !query_.options.subdivision) return;

  const auto h = halves(window, depth);
  if (items.size() <= leaf_size || stalls >= most_stalls || depth >= most_depth || !proper(h)) {
    resolve(part, tile, items);
    return;
  }
  // The line between the halves, as a border of each.
  const bool by_x = depth % 2 == 0;
  Line low = tile.borders[by_x ? 2 : 3], high = tile.borders[by_x ? 0 : 1];
  low.at = high.at = by_x ? h.first.x1 : h.first.y1;
  low.approx = part.signs.shadow(low);
  high.approx = part.signs.shadow(high);
  Items a = inside(part, items, low), b = inside(part, items, high);
  const bool stalled = 10 * std::min(a.size(), b.size()) > 9 * items.size();
  items = {};
  descend(part, a, h.first, depth + 1, stalled ? stalls + 1 : 0);
  descend(part, b, h.second, depth + 1, stalled ? stalls + 1 : 0);
}

/// Drops facets that certainly have no hit in the tile; notes which lines of their cones hold all of it.
template <Arithmetic A, QueryEffects E>
void Traversal<A, E>::narrow(Part& part, const Tile& tile, Items& items) const {
  const auto outside = [&](Item& item) {
    const FacetType& f = facets_.facets[item.facet];
    for (int k = 0; k < 3; ++k) {
      if (!(item.open & (1 << k))) continue;
      int in = 0, out = 0;
      for (const Direction& c : tile.corners) {
        const auto s = part.signs.quick_side(f.edges[k], c);
        in += s == Sign::positive;
        out += s == Sign::negative;
      }
      if (out == 4) return true;
      if (in == 4) item.open = static_cast<std::uint8_t>(item.open & ~(1 << k));
    }
    return false;
  };
  items.erase(std::remove_if(items.begin(), items.end(), outside), items.end());
}

/// The items not certainly beyond the border.
template <Arithmetic A, QueryEffects E>
typename Traversal<A, E>::Items Traversal<A, E>::inside(Part& part, const Items& items,
                                                        const Line& border) const {
  Items out;
  for (const Item& item : items) {
    const FacetType& f = facets_.facets[item.facet];
    const bool beyond = std::all_of(std::begin(f.points), std::end(f.points), [&](std::uint32_t p) {
      return part.signs.quick_side(border, facets_.points[p].direction) == Sign::negative;
    });
    if (!beyond) out.push_back(item);
  }
  return out;
}

/// Whether the facet lies strictly behind the plane of the cover everywhere in the tile.
template <Arithmetic A, QueryEffects E>
bool Traversal<A, E>::behind(Signs<A>& signs, const Tile& tile, std::uint32_t cover,
                             std::uint32_t facet) const {
  const FacetType &c = facets_.facets[cover], &f = facets_.facets[facet];
  Line nearer;
  nearer.kind = LineKind::depth;
  nearer.first = c.corners;
  nearer.second = f.corners;
  nearer.approx = approximate(depth_line(signs.geometry(), c.plane, f.plane));
  return std::all_of(tile.corners.begin(), tile.corners.end(), [&](const Direction& corner) {
    return signs.quick_side(nearer, corner) == Sign::positive;
  });
}

/// Finds an occluder that covers the whole tile, the nearest where that is certain, and drops what it hides.
template <Arithmetic A, QueryEffects E>
void Traversal<A, E>::cull_behind_cover(Part& part, const Tile& tile, Items& items) const {
  const Item* cover = nullptr;
  for (const Item& item : items)
    if (item.open == 0 && facets_.facets[item.facet].occludes &&
        (cover == nullptr || behind(part.signs, tile, item.facet, cover->facet)))
      cover = &item;
  if (cover == nullptr) return;
  const std::uint32_t nearest = cover->facet;
  const auto hidden = [&](const Item& item) {
    return item.facet != nearest && behind(part.signs, tile, nearest, item.facet);
  };
  items.erase(std::remove_if(items.begin(), items.end(), hidden), items.end());
}

template <Arithmetic A, QueryEffects E>
void Traversal<A, E>::resolve(Part& part, const Tile& tile, const Items& items) {
  ++part.outcome.stats.leaves;
  std::vector<std::uint32_t> members;
  for (const Item& i : items) members.push_back(i.facet);
  Leaf<A, E> leaf(part.signs, facets_, tile, members);
  for (const Item& i : items)
    if (!part.seen.get(i.slot)) decide(part, leaf, i);
  if (query_.options.subdivision)
    Arrangement<A, E>(part.signs, facets_, tile, members).report(query_.frame, part.outcome.cells);
}

template <Arithmetic A, QueryEffects E>
void Traversal<A, E>::decide(Part& part, Leaf<A, E>& leaf, const Item& item) {
  const Sight sight = leaf.look(item.facet);
  ++(sight.sampled ? part.outcome.stats.samples : part.outcome.stats.subtractions);
  if (!sight.visible || !part.seen.set(item.slot)) return;
  Found& found = part.outcome.found.emplace_back();
  found.primitive = facets_.facets[item.facet].id;
  if (query_.options.witnesses) found.witness = leaf.witness(item.facet, sight);
}

}  // namespace provis
