#include "src/segment/block.hpp"

#include <algorithm>

namespace provis {

template <Arithmetic A>
std::uint32_t Block<A>::facet(PrimitiveId id) {
  if (again_) {
    const auto [place, fresh] = by_id_.try_emplace(id, static_cast<std::uint32_t>(facets().size()));
    if (!fresh) return place->second;
  }
  return events_.add(make_facet(task_->scene, id, events_.path()));
}

/// All that is visible in a piece, by id.
template <Arithmetic A>
void Block<A>::collect(const Piece& piece) {
  collected_.clear();
  if (piece.front.facet != no_facet) collected_.push_back({piece.front.facet, piece.front.on_edge, false});
  if (piece.also == no_more) return;
  for (std::uint32_t a = piece.also; a != no_more; a = scratch_.also[a].next)
    collected_.push_back({scratch_.also[a].facet, scratch_.also[a].on_edge, scratch_.also[a].before_front});
  std::sort(collected_.begin(), collected_.end(),
            [&](const Member& a, const Member& b) { return facets()[a.facet].id < facets()[b.facet].id; });
}

/// Appends the envelopes to the pixels' lists; equal neighbours become one.
template <Arithmetic A>
void Block<A>::flatten() {
  for (std::size_t k = 0; k < centres_.size(); ++k) {
    std::vector<Sighting>& list = lists_[k];
    for (const Piece& piece : envelopes_[k].pieces()) {
      collect(piece);
      const auto last = [&] { return members_.begin() + static_cast<std::ptrdiff_t>(list.back().first); };
      if (!list.empty() && list.back().count == collected_.size() &&
          std::equal(collected_.begin(), collected_.end(), last()))
        continue;
      list.push_back({piece.begin, static_cast<std::uint32_t>(members_.size()),
                      static_cast<std::uint32_t>(collected_.size())});
      members_.insert(members_.end(), collected_.begin(), collected_.end());
    }
  }
}

template <Arithmetic A>
void Block<A>::report(BlockOutcome& outcome) {
  end_ = moment(1);
  std::vector<std::uint32_t> last_seen(facets().size(), no_more), order;
  std::vector<Sighted> by_facet(facets().size());
  for (std::size_t k = 0; k < centres_.size(); ++k) {
    report_pixel(k, last_seen, by_facet, order);
    if (task_->lists) outcome.sights.push_back(sights_of(k));
  }
  outcome.sighted.reserve(order.size());
  for (const std::uint32_t f : order) outcome.sighted.push_back(std::move(by_facet[f]));
}

template <Arithmetic A>
void Block<A>::report_pixel(std::size_t k, std::vector<std::uint32_t>& last_seen,
                            std::vector<Sighted>& by_facet, std::vector<std::uint32_t>& order) {
  const std::vector<Sighting>& list = lists_[k];
  for (std::size_t s = 0; s < list.size(); ++s) {
    const Event& end = end_of(list, s);
    for (std::uint32_t m = list[s].first; m < list[s].first + list[s].count; ++m) {
      const Member& member = members_[m];
      Sighted& sighted = by_facet[member.facet];
      if (last_seen[member.facet] == no_more) {
        sighted.primitive = facets()[member.facet].id;
        order.push_back(member.facet);
      }
      if (last_seen[member.facet] != k) ++sighted.pixels;
      last_seen[member.facet] = static_cast<std::uint32_t>(k);
      sighted.length += length(k, list[s].begin, end);
      if (!sighted.inner && inner(list[s], member)) find_glimpse(pixel(k), list[s].begin, end, sighted);
    }
  }
}

/// Of the path, between two events: to 2^-30. Float64 knows nearly all events as well as that.
template <Arithmetic A>
double Block<A>::length(std::size_t k, const Event& begin, const Event& end) const {
  if constexpr (A != Arithmetic::doubles)
    if (!(begin.error + end.error < 0x1p-31))
      return CGAL::to_double(exact(pixel(k), end) - exact(pixel(k), begin));
  return std::max(0.0, end.t - begin.t);
}

/// R10°, but for where the viewpoints lie: the triangle's relative interior is hit, and what else is hit
/// there and hides lies in its plane. What is hit at single moments does not matter.
template <Arithmetic A>
bool Block<A>::inner(const Sighting& s, const Member& m) {
  if (m.on_edge || m.before_front) return !m.on_edge;
  for (std::uint32_t k = s.first; k < s.first + s.count; ++k) {
    const std::uint32_t other = members_[k].facet;
    if (other != m.facet && facets()[other].occludes && !events_.coplanar(other, m.facet)) return false;
  }
  return true;
}

template <Arithmetic A>
void Block<A>::find_glimpse(const Pixel& at, const Event& begin, const Event& end, Sighted& sighted) const {
  if (task_->blocked.empty() && !task_->glimpses) {
    sighted.inner = true;
    return;
  }
  const auto free = task_->blocked.first_gap(exact(at, begin), exact(at, end));
  if (!free) return;
  sighted.inner = true;
  if (task_->glimpses) sighted.glimpse = Glimpse{at, free->first, free->second};
}

template <Arithmetic A>
PixelSights Block<A>::sights_of(std::size_t k) const {
  const Pixel at = pixel(k);
  PixelSights result{task_->frame, at.column, at.row, {}};
  std::string begin;
  for (std::size_t s = 0; s < lists_[k].size(); ++s) {
    if (s == 0) begin = text(exact(at, lists_[k][s].begin));
    Sight sight;
    sight.from = std::move(begin);
    sight.to = begin = text(exact(at, end_of(lists_[k], s)));
    for (std::uint32_t m = lists_[k][s].first; m < lists_[k][s].first + lists_[k][s].count; ++m)
      sight.visible.push_back(facets()[members_[m].facet].id);
    result.sights.push_back(std::move(sight));
  }
  return result;
}

template class Block<Arithmetic::doubles>;
template class Block<Arithmetic::chain>;
template class Block<Arithmetic::mpfr>;
template class Block<Arithmetic::exact>;

}  // namespace provis
