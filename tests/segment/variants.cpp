#include "tests/segment/variants.hpp"

#include <algorithm>
#include <iterator>

namespace provis::test {

namespace {

using Ids = std::vector<PrimitiveId>;

void sort_unique(Ids& ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

Ids difference_of(const Ids& all, const Ids& without) {
  Ids rest;
  std::set_difference(all.begin(), all.end(), without.begin(), without.end(), std::back_inserter(rest));
  return rest;
}

Ids union_of(const Ids& a, const Ids& b) {
  Ids both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

Ids proper_of(const Answer& a) { return difference_of(a.visible, a.boundary); }

}  // namespace

Answer pull_back(const SegmentVariant& variant, const Answer& answer) {
  std::vector<PrimitiveId> origin(variant.changed.start.arrays.triangles.size());
  for (PrimitiveId id = 0; id < variant.parts.size(); ++id)
    for (const PrimitiveId part : variant.parts[id]) origin.at(part) = id;
  const auto named = [&](const Ids& ids) {
    Ids out;
    for (const PrimitiveId id : ids) out.push_back(origin.at(id));
    sort_unique(out);
    return out;
  };
  Answer back{named(answer.visible), {}, {}};
  back.boundary = difference_of(back.visible, named(proper_of(answer)));
  for (ExactSights pixel : answer.pixels) {
    for (ExactSight& s : pixel.sights) s.visible = named(s.visible);
    back.pixels.push_back(joined(pixel));
  }
  return back;
}

SegmentCase reversed(const SegmentCase& c) {
  SegmentCase back = c;
  std::swap(back.start.view.eye, back.to);
  back.start.name += " | reversed";
  return back;
}

Answer reversed(const Answer& answer) {
  Answer back = answer;
  for (ExactSights& pixel : back.pixels) {
    std::reverse(pixel.sights.begin(), pixel.sights.end());
    for (ExactSight& s : pixel.sights) {
      const Rational from = 1 - s.to, to = 1 - s.from;
      s.from = from;
      s.to = to;
    }
  }
  return back;
}

std::optional<std::pair<SegmentCase, SegmentCase>> halves(const SegmentCase& c) {
  const std::optional<Vec3d> middle = eye_at(c.view(), Rational(1, 2));
  if (!middle) return {};
  SegmentCase first = c, second = c;
  first.to = second.start.view.eye = *middle;
  return std::pair(first, second);
}

Answer united(const Answer& first, const Answer& second) {
  Answer whole;
  whole.visible = union_of(first.visible, second.visible);
  whole.boundary = difference_of(whole.visible, union_of(proper_of(first), proper_of(second)));
  for (std::size_t p = 0; p < first.pixels.size(); ++p) {
    ExactSights pixel = first.pixels[p];
    const std::size_t half = pixel.sights.size();
    const std::vector<ExactSight>& rest = second.pixels.at(p).sights;
    pixel.sights.insert(pixel.sights.end(), rest.begin(), rest.end());
    for (std::size_t i = 0; i < pixel.sights.size(); ++i) {
      ExactSight& s = pixel.sights[i];
      s.from = (s.from + (i < half ? 0 : 1)) / 2;
      s.to = (s.to + (i < half ? 0 : 1)) / 2;
    }
    whole.pixels.push_back(joined(pixel));
  }
  return whole;
}

}  // namespace provis::test
