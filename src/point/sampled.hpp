#pragma once
// A regular grid of rays in every pixel: what is found is proven, and nothing more is promised.

#include "src/point/block_descent.hpp"
#include "src/point/findings.hpp"
#include "src/point/pixel_blocks.hpp"
#include "src/point/sampling_locations.hpp"

namespace provis {

template <Arithmetic A>
class SampledFrame {
 public:
  SampledFrame(const FrameQuery& query, const Facets& facets, SeenFacets& seen)
      : query_(query),
        facets_(facets),
        seen_(seen),
        x_(sample_coordinates(query.window.x0, query.window.x1, count(query.options.pixels.width))),
        y_(sample_coordinates(query.window.y0, query.window.y1, count(query.options.pixels.height))) {}

  Outcome run() const;

  // What the descent asks for. Memory is that of one block, whatever the number of samples.
  using Part = GridBox;
  bool takes(const GridBox& box, const std::vector<std::uint32_t>& list, DescentState) const {
    return list.empty() || box.within(block_side) ||
           (list.size() == 1 && covers(facets_.facets[list[0]], window(box)));
  }
  std::pair<GridBox, GridBox> halves(const GridBox& box, int) const { return provis::halves(box); }
  Window window(const GridBox& b) const { return {x_[b.x0], x_[b.x1 - 1], y_[b.y0], y_[b.y1 - 1]}; }
  double share() const { return 1; }
  Outcome operator()(const GridBox& box, const std::vector<std::uint32_t>& list) const;

 private:
  static constexpr std::size_t block_side = 32;

  std::size_t count(int pixels) const {
    return static_cast<std::size_t>(pixels) * static_cast<std::size_t>(query_.options.samples);
  }
  void look(SamplingLocations<A>& locations, const GridBox& box, std::uint32_t facet) const;

  const FrameQuery& query_;
  const Facets& facets_;
  SeenFacets& seen_;
  std::vector<double> x_, y_;
};

template <Arithmetic A>
Outcome SampledFrame<A>::run() const {
  Outcome outcome = BlockDescent(query_, facets_, *this).run({0, x_.size(), 0, y_.size()});
  const PixelGrid& pixels = query_.options.pixels;
  SamplingStats& stats = outcome.stats.sampling;
  stats.pixels = static_cast<std::uint64_t>(pixels.width) * static_cast<std::uint64_t>(pixels.height);
  stats.locations = x_.size() * y_.size();
  stats.most = stats.locations / stats.pixels;
  return outcome;
}

template <Arithmetic A>
Outcome SampledFrame<A>::operator()(const GridBox& box, const std::vector<std::uint32_t>& list) const {
  Outcome outcome;
  if (list.empty()) return outcome;
  const RoundingGuard<A> guard;
  Signs<A> signs(query_.geometry, outcome.stats.signs);
  Findings<A> findings(query_, facets_, seen_, outcome);
  if (list.size() == 1 && covers(facets_.facets[list[0]], window(box))) {
    findings.see(list[0], x_[box.x0], y_[box.y0]);
    return outcome;
  }
  PartLines<A> part(signs, facets_);
  LeafLines<A> lines(signs, facets_, part);
  SamplingLocations<A> locations(signs, facets_, lines);
  for (std::size_t y = box.y0; y < box.y1; ++y)
    for (std::size_t x = box.x0; x < box.x1; ++x) locations.add(x_[x], y_[y]);
  for (const std::uint32_t f : list) look(locations, box, f);
  locations.resolve([&](std::uint32_t k, std::uint32_t facet, Look look) {
    if (look == Look::visible) findings.see(facet, locations[k].x, locations[k].y);
  });
  return outcome;
}

/// Shows the facet to the locations of the block that lie in its box.
template <Arithmetic A>
void SampledFrame<A>::look(SamplingLocations<A>& locations, const GridBox& box, std::uint32_t facet) const {
  const Window& reach = facets_.facets[facet].box;
  for (std::size_t y = box.y0; y < box.y1; ++y) {
    if (y_[y] < reach.y0 || y_[y] > reach.y1) continue;
    for (std::size_t x = box.x0; x < box.x1; ++x)
      if (reach.x0 <= x_[x] && x_[x] <= reach.x1)
        locations.offer(static_cast<std::uint32_t>((y - box.y0) * box.width() + x - box.x0), facet);
  }
}

}  // namespace provis
