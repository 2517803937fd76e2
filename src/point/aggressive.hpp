#pragma once
// Algorithm 1 of Popescu et al. on one block of pixels: every facet with a completely visible fragment is
// found, and what is found is proven (README.md has the argument).

#include "src/point/block_descent.hpp"
#include "src/point/findings.hpp"
#include "src/point/fragment.hpp"
#include "src/point/leaf.hpp"
#include "src/point/pixel_blocks.hpp"
#include "src/point/sampling_locations.hpp"

namespace provis {

/// The pixels of one frame, by their borders.
struct PixelBorders {
  std::vector<double> x, y;

  PixelBorders(const Window& w, const PixelGrid& pixels)
      : x(pixel_borders(w.x0, w.x1, pixels.width)), y(pixel_borders(w.y0, w.y1, pixels.height)) {}
  GridBox grid() const { return {0, x.size() - 1, 0, y.size() - 1}; }
  Window window(const GridBox& b) const { return {x[b.x0], x[b.x1], y[b.y0], y[b.y1]}; }
};

template <Arithmetic A>
class AggressiveBlock {
 public:
  /// list: every facet that may be seen in the block, ascending.
  AggressiveBlock(Signs<A>& signs, const Facets& facets, const PixelBorders& borders, const GridBox& box,
                  const std::vector<std::uint32_t>& list)
      : signs_(signs),
        facets_(facets),
        borders_(borders),
        box_(box),
        list_(list),
        tile_(make_tile(signs, borders.window(box))),
        part_(signs, facets),
        cutter_(signs, facets, part_, tile_, nobody_),
        locations_(signs, facets, cutter_.lines()),
        pixels_(box.width() * box.height()) {}

  void run(Findings<A>& findings);

 private:
  using Leaf = provis::Leaf<A, QueryEffects{}>;

  struct Pixel {
    std::uint32_t last = no_id;    ///< its locations are linked, the last one first
    std::uint32_t center = no_id;  ///< the first one
    std::uint32_t count = 0;
  };
  /// A fragment that no location is known to be inside of, or to prove.
  struct Fragment {
    std::size_t x, y;
    std::uint32_t facet;
  };

  Pixel& pixel(std::size_t x, std::size_t y) { return pixels_[(y - box_.y0) * box_.width() + x - box_.x0]; }
  Window window(std::size_t x, std::size_t y) const { return borders_.window({x, x + 1, y, y + 1}); }
  template <class Visit>
  void for_pixels_of(const Facet& f, const Visit& visit) const;
  void add_location(std::size_t x, std::size_t y, const Vec3d& at);
  void add_centers();
  void render(std::uint32_t from);
  void sample_fragment(std::uint32_t facet, std::size_t x, std::size_t y);
  bool sampled(std::uint32_t facet, const Pixel& p) const;
  bool hidden_by_center(std::uint32_t facet, const Pixel& p, const Vec3d& at) const;
  void sample_thin_fragment(std::uint32_t facet, std::size_t x, std::size_t y);
  void resolve(Findings<A>& findings);
  void decide_unproven(Findings<A>& findings);
  void count(QueryStats& stats) const;

  Signs<A>& signs_;
  const Facets& facets_;
  const PixelBorders& borders_;
  const GridBox box_;
  const std::vector<std::uint32_t>& list_;
  const std::vector<std::uint32_t> nobody_;
  const Tile tile_;
  PartLines<A> part_;
  Leaf cutter_;  ///< of no members: it only cuts cells
  SamplingLocations<A> locations_;
  std::vector<Pixel> pixels_;
  std::vector<Fragment> unproven_;
};

template <Arithmetic A>
void AggressiveBlock<A>::run(Findings<A>& findings) {
  add_centers();
  render(0);  // pass 1
  const auto centers = static_cast<std::uint32_t>(locations_.size());
  for (const std::uint32_t f : list_)  // pass 2
    for_pixels_of(facets_.facets[f], [&](std::size_t x, std::size_t y) { sample_fragment(f, x, y); });
  render(centers);  // pass 3
  resolve(findings);
  decide_unproven(findings);
  count(findings.stats());
}

/// Calls visit(x, y) for the pixels of the block in which the facet may have hits.
template <Arithmetic A>
template <class Visit>
void AggressiveBlock<A>::for_pixels_of(const Facet& f, const Visit& visit) const {
  const auto range = [](const std::vector<double>& at, std::size_t begin, std::size_t end, double lo,
                        double hi) {
    while (begin < end && at[begin + 1] < lo) ++begin;
    while (begin < end && at[end - 1] > hi) --end;
    return std::pair(begin, end);
  };
  const auto [x0, x1] = range(borders_.x, box_.x0, box_.x1, f.box.x0, f.box.x1);
  const auto [y0, y1] = range(borders_.y, box_.y0, box_.y1, f.box.y0, f.box.y1);
  for (std::size_t y = y0; y < y1; ++y)
    for (std::size_t x = x0; x < x1; ++x)
      if (!separated(f, window(x, y))) visit(x, y);
}

template <Arithmetic A>
void AggressiveBlock<A>::add_location(std::size_t x, std::size_t y, const Vec3d& at) {
  Pixel& p = pixel(x, y);
  const std::uint32_t k = locations_.add(at.x, at.y);
  locations_[k].next = p.last;
  p.last = k;
  ++p.count;
}

/// Strictly inside, so that what is seen there is seen within the pixel. A pixel of one ulp has no middle.
inline bool inside(const Window& w, const Vec3d& at) {
  return w.x0 < at.x && at.x < w.x1 && w.y0 < at.y && at.y < w.y1;
}

template <Arithmetic A>
void AggressiveBlock<A>::add_centers() {
  for (std::size_t y = box_.y0; y < box_.y1; ++y)
    for (std::size_t x = box_.x0; x < box_.x1; ++x) {
      const Window w = window(x, y);
      const Vec3d middle{w.x0 / 2 + w.x1 / 2, w.y0 / 2 + w.y1 / 2, 0};
      if (!inside(w, middle)) continue;
      add_location(x, y, middle);
      pixel(x, y).center = pixel(x, y).last;
    }
}

/// Shows every facet to the locations numbered `from` and above.
template <Arithmetic A>
void AggressiveBlock<A>::render(std::uint32_t from) {
  for (const std::uint32_t f : list_)
    for_pixels_of(facets_.facets[f], [&](std::size_t x, std::size_t y) {
      for (std::uint32_t k = pixel(x, y).last; k != no_id && k >= from; k = locations_[k].next)
        locations_.offer(k, f);
    });
}

/// Whether a location of the pixel is certainly inside the facet.
template <Arithmetic A>
bool AggressiveBlock<A>::sampled(std::uint32_t facet, const Pixel& p) const {
  const Facet& f = facets_.facets[facet];
  for (std::uint32_t k = p.last; k != no_id; k = locations_[k].next)
    if (hit(f, locations_[k].x, locations_[k].y) == Hit::inside) return true;
  return false;
}

/// Whether the occluder seen at the pixel's centre certainly hides the facet at another place, so that the
/// fragment is not completely visible.
template <Arithmetic A>
bool AggressiveBlock<A>::hidden_by_center(std::uint32_t facet, const Pixel& p, const Vec3d& at) const {
  if (p.center == no_id || locations_[p.center].reached_by == no_id) return false;
  const Facet &o = facets_.facets[locations_[p.center].reached_by], &f = facets_.facets[facet];
  return hit(o, at.x, at.y) == Hit::inside &&
         f.depth.at(at.x, at.y) + f.depth.error < o.depth.at(at.x, at.y) - o.depth.error;
}

template <Arithmetic A>
void AggressiveBlock<A>::sample_fragment(std::uint32_t facet, std::size_t x, std::size_t y) {
  const Facet& f = facets_.facets[facet];
  const Pixel& p = pixel(x, y);
  if (sampled(facet, p)) return;
  const Window w = window(x, y);
  const Vec3d at = middle_of_fragment(f, w);
  if (!inside(w, at) || hit(f, at.x, at.y) != Hit::inside)
    sample_thin_fragment(facet, x, y);
  else if (!hidden_by_center(facet, p, at))
    add_location(x, y, at);
}

/// A fragment, perhaps none, in which rounded numbers found no certain place.
template <Arithmetic A>
void AggressiveBlock<A>::sample_thin_fragment(std::uint32_t facet, std::size_t x, std::size_t y) {
  const Window w = window(x, y);
  const Tile tile = make_tile(signs_, w);
  Region cone;
  cutter_.lines().template append_cone<true>(facet, cone);
  std::vector<Cell> ignored;
  const Cell cell = cutter_.cut(make_cell(tile, signs_.geometry().handedness), cone, ignored);
  if (cell.empty()) return;
  const Vec3d at = middle_of(signs_, cell);
  if (!inside(w, at) || !certainly_inside(signs_, cell, at))
    unproven_.push_back({x, y, facet});
  else if (!hidden_by_center(facet, pixel(x, y), at))
    add_location(x, y, at);
}

template <Arithmetic A>
void AggressiveBlock<A>::resolve(Findings<A>& findings) {
  std::vector<std::pair<std::size_t, std::size_t>> pixel_of(locations_.size());
  for (std::size_t y = box_.y0; y < box_.y1; ++y)
    for (std::size_t x = box_.x0; x < box_.x1; ++x)
      for (std::uint32_t k = pixel(x, y).last; k != no_id; k = locations_[k].next) pixel_of[k] = {x, y};
  locations_.resolve([&](std::uint32_t k, std::uint32_t facet, Look look) {
    if (look == Look::visible && !findings.needs_leaf())
      findings.see(facet, locations_[k].x, locations_[k].y);
    else if (look != Look::hidden)
      unproven_.push_back({pixel_of[k].first, pixel_of[k].second, facet});
  });
}

/// What rounded places could not prove is decided exactly, in its own pixel.
template <Arithmetic A>
void AggressiveBlock<A>::decide_unproven(Findings<A>& findings) {
  std::erase_if(unproven_, [&](const Fragment& f) { return findings.seen_here(f.facet); });
  std::stable_sort(unproven_.begin(), unproven_.end(), [](const Fragment& a, const Fragment& b) {
    return std::pair(a.y, a.x) < std::pair(b.y, b.x);
  });
  for (auto f = unproven_.begin(); f != unproven_.end();) {
    const std::size_t x = f->x, y = f->y;
    const Tile tile = make_tile(signs_, window(x, y));
    const std::vector<std::uint32_t> members = overlapping(facets_, list_, tile.window);
    Leaf leaf(signs_, facets_, part_, tile, members);
    for (; f != unproven_.end() && f->x == x && f->y == y; ++f)
      if (!findings.seen_here(f->facet)) findings.decide(leaf, f->facet);
  }
}

template <Arithmetic A>
void AggressiveBlock<A>::count(QueryStats& stats) const {
  stats.sampling.pixels += pixels_.size();
  stats.sampling.locations += locations_.size();
  for (const Pixel& p : pixels_) stats.sampling.most = std::max<std::uint64_t>(stats.sampling.most, p.count);
}

/// Algorithm 1 on a whole frame.
template <Arithmetic A>
class AggressiveFrame {
 public:
  AggressiveFrame(const FrameQuery& query, const Facets& facets, SeenFacets& seen)
      : query_(query), facets_(facets), seen_(seen), borders_(query.window, query.options.pixels) {}

  Outcome run() const { return BlockDescent(query_, facets_, *this).run(borders_.grid()); }

  // What the descent asks for.
  using Part = GridBox;
  bool takes(const GridBox& box, const std::vector<std::uint32_t>&, DescentState) const {
    return box.within(block_side);
  }
  std::pair<GridBox, GridBox> halves(const GridBox& box, int) const { return provis::halves(box); }
  Window window(const GridBox& box) const { return borders_.window(box); }
  double share() const { return query_.options.method == Method::aggressive ? 1 : 0.5; }
  Outcome operator()(const GridBox& box, const std::vector<std::uint32_t>& list) const {
    Outcome outcome;
    const RoundingGuard<A> guard;
    Signs<A> signs(query_.geometry, outcome.stats.signs);
    Findings<A> findings(query_, facets_, seen_, outcome);
    AggressiveBlock<A>(signs, facets_, borders_, box, list).run(findings);
    return outcome;
  }

 private:
  static constexpr std::size_t block_side = 16;

  const FrameQuery& query_;
  const Facets& facets_;
  SeenFacets& seen_;
  PixelBorders borders_;
};

}  // namespace provis
