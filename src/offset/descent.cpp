#include "src/offset/descent.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "provis/error.hpp"

namespace provis::offset {
namespace {

/// Adds the time until it is gone.
class Timer {
 public:
  explicit Timer(double& sum) : sum_(sum) {}
  ~Timer() { sum_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

 private:
  double& sum_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// As many as would make a list short if each shared it among two, and two more.
int halvings_for(std::size_t entries, std::size_t shorter) {
  int n = 2;
  for (; entries > shorter; entries /= 2) ++n;
  return n;
}

std::ptrdiff_t count_wanted(const std::vector<Entry>& list) {
  return std::count_if(list.begin(), list.end(), [](const Entry& e) { return e.wanted; });
}

}  // namespace

Window Descent::window(const Block& b) const {
  const auto at = [](const std::vector<double>& borders, int i) {
    return borders[static_cast<std::size_t>(i)];
  };
  return {at(raster_.columns, b.column0), at(raster_.columns, b.column1), at(raster_.rows, b.row0),
          at(raster_.rows, b.row1)};
}

void Descent::run() {
  ++stats_.rasters;
  const Block all{0, static_cast<int>(raster_.columns.size()) - 1, 0,
                  static_cast<int>(raster_.rows.size()) - 1};
  const Beam beam(outlook_.face, raster_, shafts_, window(all));
  std::vector<Entry> list;
  for (std::uint32_t f = 0; f < outlook_.facets.all.size(); ++f) {
    Entry e;
    e.facet = f;
    e.wanted = wanted_[facet(e).id];
    measure(e, polygon_of(e, facet(e)));
    if (cut(e, beam.spaces)) list.push_back(std::move(e));
  }
  halve(all, outlook_.face, std::move(list), {0, 0}, refinements_);
}

void Descent::measure(Entry& e, const Polygon& polygon) const {
  e.near = HUGE_VAL;
  e.far = -HUGE_VAL;
  for (std::size_t k = 0; k < polygon.size; ++k) {
    const Interval d = shafts_.depth(polygon.corners[k].at);
    e.near = std::min(e.near, d.inf());
    e.far = std::max(e.far, d.sup());
  }
}

/// Leaves what lies in the half spaces; false if nothing does. Most triangles are not cut.
bool Descent::cut(Entry& e, std::span<const HalfSpace> spaces) const {
  Polygon changed;
  if (!e.cut) changed = polygon_of(e, facet(e));
  const Polygon* now = e.cut ? e.cut.get() : &changed;
  bool any = false;
  for (const HalfSpace& h : spaces) {
    Polygon::Outside outside = now == &changed ? changed.clip(h) : now->outside(h);
    if (outside == Polygon::Outside::some && now != &changed) {
      changed = *now;
      now = &changed;
      outside = changed.clip(h);
    }
    if (outside == Polygon::Outside::all) return false;
    any = any || outside == Polygon::Outside::some;
  }
  if (!any) return true;
  measure(e, changed);
  e.cut = new CutPolygon(changed);
  return true;
}

/// What of the list lies in the half spaces, in order of least depth. Those of a beam in which the list lies
/// already need not be named.
std::vector<Entry> Descent::part(std::span<const HalfSpace> cuts, const std::vector<Entry>& list) {
  const Timer timer(stats_.seconds_lists);
  std::vector<Entry> in;
  for (const Entry& whole : list) {
    Entry e = whole;
    if (cut(e, cuts)) in.push_back(std::move(e));
  }
  std::sort(in.begin(), in.end(), [](const Entry& a, const Entry& b) {
    return a.near != b.near ? a.near < b.near : a.facet < b.facet;
  });
  return in;
}

void Descent::forget_known(std::vector<Entry>& list) const {
  for (Entry& e : list) e.wanted = e.wanted && wanted_[facet(e).id];
}

/// Early z: what lies behind occluders that cover the whole beam is gone.
void Descent::drop_covered(const Beam& beam, std::vector<Entry>& list) {
  const Timer timer(stats_.seconds_early_z);
  const auto cover = resolver_.cover(beam, list);
  if (!cover) return;
  const std::size_t before = list.size();
  std::erase_if(list, [&](const Entry& e) { return resolver_.behind(*cover, e); });
  stats_.early_hidden += before - list.size();
}

/// What is proven to be hidden in the beam is no longer wanted in it; it leaves a long list, as what it would
/// hide is mostly hidden by others too. What is seen is wanted nowhere any more. Returns how much is hidden.
std::uint64_t Descent::resolve(const Beam& beam, std::vector<Entry>& list, bool by_sides) {
  const Timer timer(stats_.seconds_resolve);
  const Shadows shadows(beam, list, outlook_.facets.all);
  std::uint64_t hidden = 0;
  for (Entry& e : list) {
    if (!e.wanted) continue;
    e.failure = resolver_.hide(beam, shadows, e, by_sides);
    if (e.failure == Failure::seen) keep(e);
    if (e.failure == Failure::none) {
      e.wanted = false;
      ++hidden;
    }
  }
  if (list.size() > short_list)
    std::erase_if(list, [](const Entry& e) { return e.failure == Failure::none; });
  return hidden;
}

void Descent::count(Failure f) {
  switch (f) {
    case Failure::none:
      break;
    case Failure::seen:
      ++stats_.kept_seen;
      break;
    case Failure::nothing_between:
      ++stats_.kept_nothing_between;
      break;
    case Failure::open_edge:
      ++stats_.kept_open_edge;
      break;
    case Failure::unusable:
      ++stats_.kept_unusable;
      break;
    case Failure::too_many:
      ++stats_.kept_too_many;
  }
}

void Descent::keep(Entry& e) {
  count(e.failure);
  reached_[facet(e).id] = 1;
  wanted_[facet(e).id] = 0;
  e.wanted = false;
}

/// refinements: how often the beam of a pixel is halved further. One of them is spent earlier where many
/// entries meet a beam that is mostly as wide as the face: pixels beside each other would show them all
/// again.
void Descent::halve(const Block& block, const Face& face, std::vector<Entry> list, Cuts cuts,
                    int refinements) {
  if (context_.cancelled()) throw Error(Error::Code::cancelled, "cell", "interrupted");
  ++stats_.beams;
  const Beam beam(face, raster_, shafts_, window(block));
  list = part(cuts.of(beam), list);
  forget_known(list);
  if (count_wanted(list) == 0) return;
  drop_covered(beam, list);
  if (block.is_pixel())
    return shorten(beam, std::move(list), halvings_for(list.size(), long_list), refinements);
  if (count_wanted(list) <= few_wanted || (list.size() <= largest_list && spread(beam, list) <= most_spread))
    resolve(beam, list, false);
  if (count_wanted(list) == 0) return;
  if (refinements > 0 && list.size() > short_list) {
    const Edge widest = widest_edge(beam, middle_depth(list));
    if (widest < columns) {
      halve(block, face.half(static_cast<int>(widest), false), list, {}, refinements - 1);
      return halve(block, face.half(static_cast<int>(widest), true), std::move(list), {}, refinements - 1);
    }
  }
  Block first = block, second = block;
  const bool across = block.column1 - block.column0 >= block.row1 - block.row0;
  if (across)
    first.column1 = second.column0 = (block.column0 + block.column1) / 2;
  else
    first.row1 = second.row0 = (block.row0 + block.row1) / 2;
  halve(first, face, list, {across ? Shafts::left : Shafts::below, 1}, refinements);
  halve(second, face, std::move(list), {across ? Shafts::right : Shafts::above, 1}, refinements);
}

/// In a pixel each entry is held against the others, which takes the square of their number: a list that is
/// too long for that is shared among parts of the pixel first.
void Descent::shorten(const Beam& beam, std::vector<Entry> list, int left, int refinements) {
  if (list.size() <= long_list || left == 0) return look_at_pixel(beam, std::move(list), refinements);
  for (const Half& half : halves(beam, middle_depth(list))) {
    std::vector<Entry> in = part(half.cuts.of(half.beam), list);
    forget_known(in);
    if (count_wanted(in) == 0) continue;
    drop_covered(half.beam, in);
    if (count_wanted(in) <= few_wanted) resolve(half.beam, in, false);
    if (count_wanted(in) != 0) shorten(half.beam, std::move(in), left - 1, refinements);
  }
}

void Descent::look_at_pixel(const Beam& beam, std::vector<Entry> list, int refinements) {
  const auto asked = static_cast<std::uint64_t>(count_wanted(list));
  ++stats_.lists;
  stats_.list_entries += list.size();
  stats_.list_most = std::max<std::uint64_t>(stats_.list_most, list.size());
  stats_.resolved += asked;
  stats_.resolved_hidden += resolve(beam, list, false);
  refine(beam, std::move(list), refinements);
}

double Descent::least_depth(const std::vector<Entry>& list) {
  double depth = HUGE_VAL;
  for (const Entry& e : list)
    if (e.wanted) depth = std::min(depth, e.near);
  return depth;
}

/// How much wider a beam gets by its directions than it is at the face, where it meets half of the list.
double Descent::spread(const Beam& beam, const std::vector<Entry>& list) const {
  const std::array<double, 4> w = widths(beam, middle_depth(list));
  return std::max(w[columns], w[rows]) / std::max(w[face_i], w[face_j]);
}

/// How wide the rays of a beam are spread at a depth by each of its edges.
std::array<double, 4> Descent::widths(const Beam& beam, double depth) const {
  const Vec3d size = beam.face.corners[2] - beam.face.corners[0];
  const Window& w = beam.directions;
  const double reach = depth - shafts_.depth(beam.viewpoint).inf();
  const int i = (beam.face.axis + 1) % 3, j = (beam.face.axis + 2) % 3;
  return {component(size, i), component(size, j), reach * (w.x1 - w.x0), reach * (w.y1 - w.y0)};
}

Descent::Edge Descent::widest_edge(const Beam& beam, double depth) const {
  const std::array<double, 4> w = widths(beam, depth);
  return static_cast<Edge>(std::max_element(w.begin(), w.end()) - w.begin());
}

/// Halves a beam where its shaft is widest at a depth: one of two edges of the face, or one of two ranges of
/// directions.
std::array<Descent::Half, 2> Descent::halves(const Beam& beam, double depth) const {
  const Edge widest = widest_edge(beam, depth);
  const Window& w = beam.directions;
  const auto half = [&](bool upper) -> Half {
    if (widest < columns)
      return {Beam(beam.face.half(static_cast<int>(widest), upper), raster_, shafts_, w), {}};
    Window h = w;
    if (widest == columns) {
      (upper ? h.x0 : h.x1) = 0.5 * w.x0 + 0.5 * w.x1;
      return {Beam(beam.face, raster_, shafts_, h), {upper ? Shafts::right : Shafts::left, 1}};
    }
    (upper ? h.y0 : h.y1) = 0.5 * w.y0 + 0.5 * w.y1;
    return {Beam(beam.face, raster_, shafts_, h), {upper ? Shafts::above : Shafts::below, 1}};
  };
  return {half(false), half(true)};
}

void Descent::refine(const Beam& beam, std::vector<Entry> list, int refinements) {
  forget_known(list);
  if (count_wanted(list) == 0) return;
  if (refinements == 0) {
    for (Entry& e : list)
      if (e.wanted) keep(e);
    return;
  }
  for (const Half& half : halves(beam, least_depth(list))) {
    ++stats_.refined;
    std::vector<Entry> in = part(half.cuts.of(half.beam), list);
    forget_known(in);
    if (count_wanted(in) == 0) continue;
    drop_covered(half.beam, in);
    resolve(half.beam, in, in.size() <= short_list);
    refine(half.beam, std::move(in), refinements - 1);
  }
}

}  // namespace provis::offset
