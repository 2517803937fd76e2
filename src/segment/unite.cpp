#include "src/segment/unite.hpp"

#include <algorithm>
#include <iterator>

namespace provis {
namespace {

std::vector<PrimitiveId> proven(const SegmentSet& s) {
  const std::vector<PrimitiveId> visible = s.set.with(Status::visible);
  std::vector<PrimitiveId> rest;
  std::set_difference(visible.begin(), visible.end(), s.boundary.begin(), s.boundary.end(),
                      std::back_inserter(rest));
  return rest;
}

/// Both lists are in id order; of equal ids both are kept, the first one first.
template <class Item>
std::vector<Item> merged(std::vector<Item>&& a, std::vector<Item>&& b) {
  std::vector<Item> all;
  std::merge(std::make_move_iterator(a.begin()), std::make_move_iterator(a.end()),
             std::make_move_iterator(b.begin()), std::make_move_iterator(b.end()), std::back_inserter(all),
             [](const Item& x, const Item& y) { return x.primitive < y.primitive; });
  return all;
}

}  // namespace

void unite(SegmentSet& all, SegmentSet&& more) {
  if (all.set.status.empty()) {
    all = std::move(more);
    return;
  }
  std::vector<PrimitiveId> certain;
  const std::vector<PrimitiveId> one = proven(all), other = proven(more);
  std::set_union(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(certain));
  for (std::size_t id = 0; id < all.set.status.size(); ++id)
    all.set.status[id] = std::max(all.set.status[id], more.set.status[id]);
  all.boundary.clear();
  const std::vector<PrimitiveId> visible = all.set.with(Status::visible);
  std::set_difference(visible.begin(), visible.end(), certain.begin(), certain.end(),
                      std::back_inserter(all.boundary));

  all.set.witnesses = merged(std::move(all.set.witnesses), std::move(more.set.witnesses));
  const auto same = [](const Witness& a, const Witness& b) { return a.primitive == b.primitive; };
  all.set.witnesses.erase(std::unique(all.set.witnesses.begin(), all.set.witnesses.end(), same),
                          all.set.witnesses.end());
  std::vector<Seen> seen;
  for (const Seen& s : merged(std::move(all.seen), std::move(more.seen))) {
    if (seen.empty() || seen.back().primitive != s.primitive) {
      seen.push_back(s);
    } else {
      seen.back().pixels += s.pixels;
      seen.back().length += s.length;
    }
  }
  all.seen = std::move(seen);
  all.set.eye_on_primitive |= more.set.eye_on_primitive;
  QueryStats& stats = all.set.stats;
  stats.seconds += more.set.stats.seconds;
  stats.cpu_seconds += more.set.stats.cpu_seconds;
  stats.signs += more.set.stats.signs;
}

}  // namespace provis
