#pragma once
// A rectangle of pixels that one task resolves: an envelope per pixel, and what they say in the end.

#include <algorithm>
#include <functional>
#include <unordered_map>

#include "provis/segment.hpp"
#include "src/segment/blocked.hpp"
#include "src/segment/envelope.hpp"
#include "src/segment/exact_event.hpp"

namespace provis {

/// Pixels from (column, row) on.
struct PixelRect {
  int column = 0, row = 0, width = 0, height = 0;
};

/// An open interval of time at a pixel in which a primitive is seen as R10° asks for.
struct Glimpse {
  Pixel at;
  ExactTime begin, end;
};

/// What one block saw of one primitive.
struct Sighted {
  PrimitiveId primitive = 0;
  std::uint64_t pixels = 0;
  double length = 0;
  bool inner = false;              ///< R10°
  std::optional<Glimpse> glimpse;  ///< the first one, where asked for
};

struct BlockOutcome {
  std::vector<Sighted> sighted;     ///< by first appearance
  std::vector<PixelSights> sights;  ///< row by row, where asked for
  SignCounts signs;
};

/// What a block is asked.
struct BlockTask {
  const Scene& scene;
  const PathGeometry& path;
  const BlockedTimes& blocked;
  int frame = 0;
  PixelRect area;
  bool lists = false, glimpses = false;
  std::uint64_t memory_bytes = 0;  ///< what the envelopes may take; 0 has no bound
};

template <Arithmetic A>
class Block {
 public:
  explicit Block(SignCounts& counts, const PathGeometry& path) : events_(path, counts) {}

  /// Resolves the whole path. feed(range) adds all facets that may be seen in the range; it ends early once
  /// `over_budget`, and is called again for each half.
  template <class Feed>
  void run(const BlockTask& task, const Feed& feed, BlockOutcome& outcome);

  /// The facet of a triangle, made when it is first asked for.
  std::uint32_t facet(PrimitiveId id);

  /// Adds a facet at some pixels, but for what the filter knows to be hidden; what is see-through waits until
  /// all occluders are there. The filter is asked whether the facet `hidden(k)` at pixel k, whether a
  /// `span` of it is, and told what `changed`.
  template <class Filter>
  void add(std::uint32_t facet, const PixelRect& pixels, Filter& filter) {
    if (misses(facets()[facet], window(pixels), range_.begin, range_.end)) return;
    if (facets()[facet].occludes) {
      add_now<true>(facet, pixels, filter);
    } else {
      waiting_.emplace_back(facet, pixels);
    }
  }
  void add(std::uint32_t facet, const PixelRect& pixels) {
    NoFilter none;
    add(facet, pixels, none);
  }

  bool over_budget() const { return task_->memory_bytes > 0 && bytes_ > budget() && divisible(); }

  const TimeRange& range() const { return range_; }
  const Envelope& envelope(std::size_t k) const { return envelopes_[k]; }
  const std::vector<MovingFacet>& facets() const { return events_.facets(); }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row - task_->area.row) * static_cast<std::size_t>(task_->area.width) +
           static_cast<std::size_t>(column - task_->area.column);
  }

 private:
  struct Member {
    std::uint32_t facet;
    bool on_edge;
    bool before_front;  ///< nearer than the occluders among the members
    friend bool operator==(const Member&, const Member&) = default;
  };
  /// From its begin to the next one's a pixel shows members_[first .. first + count).
  struct Sighting {
    Event begin;
    std::uint32_t first = 0, count = 0;
  };

  struct NoFilter {
    bool hidden(std::size_t) const { return false; }
    bool hidden(std::size_t, const Span&) const { return false; }
    void changed(std::size_t) const {}
  };

  template <class Feed>
  void resolve(const TimeRange& range, const Feed& feed);
  /// A few pieces per pixel are always allowed: parts without end would save nothing.
  std::uint64_t budget() const {
    return std::max<std::uint64_t>(task_->memory_bytes, 6 * centres_.size() * sizeof(Piece));
  }
  bool divisible() const { return range_.end - range_.begin > 0x1p-12; }
  template <bool occludes, class Filter>
  void add_now(std::uint32_t facet, const PixelRect& pixels, Filter& filter);
  void flatten();
  void collect(const Piece& piece);
  void report(BlockOutcome& outcome);
  void report_pixel(std::size_t k, std::vector<std::uint32_t>& last_seen, std::vector<Sighted>& by_facet,
                    std::vector<std::uint32_t>& order);
  PixelSights sights_of(std::size_t k) const;
  bool inner(const Sighting& s, const Member& m);
  void find_glimpse(const Pixel& at, const Event& begin, const Event& end, Sighted& sighted) const;
  double length(std::size_t k, const Event& begin, const Event& end) const;
  /// Of plain doubles the rounded time: what they take for an event need not be one.
  ExactTime exact(const Pixel& at, const Event& e) const {
    if constexpr (A == Arithmetic::doubles) return std::isfinite(e.t) ? ExactTime(e.t) : ExactTime(0);
    return exact_root(events_.path(), at, events_.motion(e));
  }
  /// From the first centre to the last.
  Window window(const PixelRect& r) const {
    const Centre &first = centres_[index(r.column, r.row)],
                 &last = centres_[index(r.column + r.width - 1, r.row + r.height - 1)];
    return {first.x, last.x, last.y, first.y};
  }
  Pixel pixel(std::size_t k) const {
    const auto w = static_cast<std::size_t>(task_->area.width);
    return {task_->area.column + static_cast<int>(k % w), task_->area.row + static_cast<int>(k / w)};
  }
  const Event& end_of(const std::vector<Sighting>& list, std::size_t s) const {
    return s + 1 < list.size() ? list[s + 1].begin : end_;
  }

  const BlockTask* task_ = nullptr;
  Events<A> events_;
  TimeRange range_;
  Event end_ = moment(1);
  std::vector<Centre> centres_;
  std::vector<Envelope> envelopes_;
  EnvelopeScratch scratch_;
  std::uint64_t bytes_ = 0;
  std::vector<std::pair<std::uint32_t, PixelRect>> waiting_;
  std::unordered_map<PrimitiveId, std::uint32_t> by_id_;
  bool again_ = false;  ///< facets may be there already
  std::vector<std::vector<Sighting>> lists_;
  std::vector<Member> members_, collected_;
};

template <Arithmetic A>
template <class Feed>
void Block<A>::run(const BlockTask& task, const Feed& feed, BlockOutcome& outcome) {
  task_ = &task;
  events_.clear();
  by_id_.clear();
  again_ = false;
  members_.clear();
  const std::size_t n =
      static_cast<std::size_t>(task.area.width) * static_cast<std::size_t>(task.area.height);
  centres_.resize(n);
  for (std::size_t k = 0; k < n; ++k) centres_[k] = pixel_centre(events_.path(), pixel(k));
  if (envelopes_.size() < n) envelopes_.resize(n);
  if (lists_.size() < n) lists_.resize(n);
  for (std::size_t k = 0; k < n; ++k) lists_[k].clear();
  resolve({0, 1}, feed);
  report(outcome);
}

template <Arithmetic A>
template <class Feed>
void Block<A>::resolve(const TimeRange& range, const Feed& feed) {
  range_ = range;
  for (std::size_t k = 0; k < centres_.size(); ++k) envelopes_[k].clear(range);
  scratch_.also.clear();
  waiting_.clear();
  bytes_ = centres_.size() * sizeof(Piece);
  feed(range);
  for (const auto& [facet, pixels] : waiting_) {
    if (over_budget()) break;
    NoFilter none;
    add_now<false>(facet, pixels, none);
  }
  if (!over_budget()) {
    flatten();
    return;
  }
  if (!again_)
    for (std::uint32_t f = 0; f < facets().size(); ++f) by_id_.emplace(facets()[f].id, f);
  again_ = true;
  const double middle = range.begin + (range.end - range.begin) / 2;
  resolve({range.begin, middle}, feed);
  resolve({middle, range.end}, feed);
}

template <Arithmetic A>
template <bool occludes, class Filter>
void Block<A>::add_now(std::uint32_t facet, const PixelRect& pixels, Filter& filter) {
  for (int row = pixels.row; row < pixels.row + pixels.height; ++row) {
    std::size_t k = index(pixels.column, row);
    for (int column = pixels.column; column < pixels.column + pixels.width; ++column, ++k) {
      if (filter.hidden(k)) continue;
      const Pixel at{column, row};
      const std::optional<Span> span = events_.span(at, centres_[k], facet, range_);
      if (!span || filter.hidden(k, *span)) continue;
      const auto bytes = [&] {
        return envelopes_[k].pieces().size() * sizeof(Piece) + scratch_.also.size() * sizeof(Also);
      };
      const std::size_t before = bytes();
      const bool changed = occludes ? envelopes_[k].add_occluder(events_, at, *span, scratch_)
                                    : envelopes_[k].add_see_through(events_, at, *span, scratch_);
      if (!changed) continue;
      bytes_ += bytes() - before;
      filter.changed(k);
    }
  }
}

extern template class Block<Arithmetic::doubles>;
extern template class Block<Arithmetic::chain>;
extern template class Block<Arithmetic::mpfr>;
extern template class Block<Arithmetic::exact>;

}  // namespace provis
