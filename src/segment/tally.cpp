#include "src/segment/tally.hpp"

#include <tuple>

namespace provis {

void Tally::add(int frame, const BlockOutcome& outcome) {
  signs_ += outcome.signs;
  for (const Sighted& s : outcome.sighted) {
    pixels_[s.primitive] += s.pixels;
    length_[s.primitive] += s.length;
    if (s.inner) inner_[s.primitive] = 1;
    if (!s.glimpse) continue;
    const auto [place, fresh] = glimpses_.try_emplace(s.primitive, FrameGlimpse{frame, *s.glimpse});
    const auto key = [](const FrameGlimpse& g) {
      return std::tuple(g.frame, g.glimpse.at.row, g.glimpse.at.column);
    };
    const FrameGlimpse mine{frame, *s.glimpse};
    if (!fresh && key(mine) < key(place->second)) place->second = mine;
  }
}

void Tally::report(SegmentSet& set) const {
  set.set.status.assign(pixels_.size(), Status::hidden);
  for (std::size_t id = 0; id < pixels_.size(); ++id) {
    if (pixels_[id] == 0) continue;
    const auto primitive = static_cast<PrimitiveId>(id);
    set.set.status[id] = Status::visible;
    if (!inner_[id]) set.boundary.push_back(primitive);
    set.seen.push_back({primitive, pixels_[id], length_[id]});
  }
}

}  // namespace provis
