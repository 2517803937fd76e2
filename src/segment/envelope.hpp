#pragma once
// What one pixel sees along the path: the lower envelope of line segments over time.

#include <algorithm>
#include <vector>

#include "src/segment/events.hpp"

namespace provis {

inline constexpr std::uint32_t no_more = std::numeric_limits<std::uint32_t>::max();

/// From its begin to the next one's, or to the end of the range, the nearest occluder is `front`; `also`
/// leads through what is visible besides.
struct Piece {
  Event begin;
  Shown front;
  std::uint32_t also = no_more;
};

/// One more facet that is visible in a piece: an occluder at the same distance, or see-through before it.
struct Also {
  std::uint32_t facet = no_facet;
  bool on_edge = false;
  bool before_front = false;  ///< nearer than the occluder, if there is one
  std::uint32_t next = no_more;
};

/// What the pixels of a group share while their envelopes grow.
struct EnvelopeScratch {
  std::vector<Also> also;
  std::vector<Piece> next;
};

class Envelope {
 public:
  void clear(const TimeRange& range) {
    pieces_.assign(1, {moment(range.begin), {}, no_more});
    end_ = moment(range.end);
  }

  const std::vector<Piece>& pieces() const { return pieces_; }
  const Event& end_of(std::size_t piece) const {
    return piece + 1 < pieces_.size() ? pieces_[piece + 1].begin : end_;
  }

  /// Adds an occluder where it is nearest, and says whether it is anywhere. All occluders come before
  /// anything see-through.
  template <Arithmetic A>
  bool add_occluder(Events<A>& events, const Pixel& at, const Span& span, EnvelopeScratch& scratch) {
    return add<A, true>(events, at, span, scratch);
  }

  /// Adds what occludes nothing where no occluder is nearer.
  template <Arithmetic A>
  bool add_see_through(Events<A>& events, const Pixel& at, const Span& span, EnvelopeScratch& scratch) {
    return add<A, false>(events, at, span, scratch);
  }

 private:
  /// The part of a piece in which a facet is seen, and whether only as one of several.
  struct Verdict {
    bool seen = false, tie = false;
    Event begin, end;
    bool whole_begin = true, whole_end = true;  ///< it reaches the ends that were asked about
  };

  template <Arithmetic A, bool occludes>
  bool add(Events<A>& events, const Pixel& at, const Span& span, EnvelopeScratch& scratch);
  template <Arithmetic A>
  static Verdict judge(Events<A>& events, const Pixel& at, const Shown& shown, const Piece& piece,
                       const Event& begin, const Event& end);
  template <Arithmetic A>
  std::size_t first_overlap(Events<A>& events, const Pixel& at, const Event& begin) const;
  static void push(std::vector<Piece>& pieces, const Event& begin, const Shown& front, std::uint32_t also);

  std::vector<Piece> pieces_;
  Event end_;
};

/// The last piece that begins at the event or before.
template <Arithmetic A>
std::size_t Envelope::first_overlap(Events<A>& events, const Pixel& at, const Event& begin) const {
  std::size_t low = 0, high = pieces_.size();
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    if (events.compare(at, pieces_[middle].begin, begin) == Sign::positive) {
      high = middle;
    } else {
      low = middle;
    }
  }
  return low;
}

template <Arithmetic A>
Envelope::Verdict Envelope::judge(Events<A>& events, const Pixel& at, const Shown& shown, const Piece& piece,
                                  const Event& begin, const Event& end) {
  if (piece.front.facet == no_facet) return {true, false, begin, end};
  const Sign first = events.compare_depth(at, shown, piece.front, begin),
             last = events.compare_depth(at, shown, piece.front, end);
  if (first == Sign::zero && last == Sign::zero) return {true, true, begin, end};
  if (first != Sign::positive && last != Sign::positive) return {true, false, begin, end};
  if (first != Sign::negative && last != Sign::negative) return {};
  const Event crossing = events.crossing(at, shown, piece.front, first);
  return first == Sign::negative ? Verdict{true, false, begin, crossing, true, false}
                                 : Verdict{true, false, crossing, end, false, true};
}

inline void Envelope::push(std::vector<Piece>& pieces, const Event& begin, const Shown& front,
                           std::uint32_t also) {
  if (!pieces.empty() && pieces.back().front.facet == front.facet && pieces.back().also == also) return;
  pieces.push_back({begin, front, also});
}

template <Arithmetic A, bool occludes>
bool Envelope::add(Events<A>& events, const Pixel& at, const Span& span, EnvelopeScratch& scratch) {
  const std::size_t first = first_overlap(events, at, span.begin);
  bool changed = false;
  std::vector<Piece>& next = scratch.next;  // what takes the place of pieces kept to k
  std::size_t k = first, kept = first;
  for (; k < pieces_.size(); ++k) {
    const Piece& piece = pieces_[k];
    if (k > first && events.compare(at, piece.begin, span.end) != Sign::negative) break;
    const Event& piece_end = end_of(k);
    const bool from_begin = k > first || events.compare(at, piece.begin, span.begin) == Sign::zero;
    const bool to_end = events.compare(at, piece_end, span.end) != Sign::positive;
    const Verdict v = judge(events, at, span.shown, piece, from_begin ? piece.begin : span.begin,
                            to_end ? piece_end : span.end);
    if (!v.seen) {
      if (changed) push(next, piece.begin, piece.front, piece.also);
      continue;
    }
    if (!changed) {
      next.clear();
      kept = k;
      changed = true;
    }
    if (!from_begin || !v.whole_begin) push(next, piece.begin, piece.front, piece.also);
    if (occludes && !v.tie) {
      push(next, v.begin, span.shown, no_more);
    } else {
      scratch.also.push_back({span.shown.facet, span.shown.on_edge, !v.tie, piece.also});
      push(next, v.begin, piece.front, static_cast<std::uint32_t>(scratch.also.size() - 1));
    }
    if (!to_end || !v.whole_end) push(next, v.end, piece.front, piece.also);
  }
  if (!changed) return false;
  // No piece beside those replaced shows this facet, so nothing there becomes one with its neighbour.
  const auto begin = pieces_.begin() + static_cast<std::ptrdiff_t>(kept);
  const std::size_t common = std::min(next.size(), k - kept);
  const auto split = next.begin() + static_cast<std::ptrdiff_t>(common);
  const auto end = std::copy(next.begin(), split, begin);
  if (common < next.size()) {
    pieces_.insert(end, split, next.end());
  } else {
    pieces_.erase(end, begin + static_cast<std::ptrdiff_t>(k - kept));
  }
  return true;
}

}  // namespace provis
