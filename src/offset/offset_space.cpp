#include "src/offset/offset_space.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <span>

#include "predicates/certain_sign.hpp"
#include "predicates/environment.hpp"
#include "provis/error.hpp"
#include "src/offset/resolver.hpp"
#include "src/scene/parallel.hpp"
#include "src/scene/stopwatch.hpp"

namespace provis::offset {
namespace {

/// What certain signs cost this thread from here on.
class SignTally {
 public:
  void read(OffsetStats& stats) const {
    stats.signs_interval = certain_signs.interval - before_.interval;
    stats.signs_exact = certain_signs.exact - before_.exact;
  }

 private:
  CertainSigns before_ = certain_signs;
};

/// One face with everything that its rasters share.
struct Outlook {
  Face face;
  Facets facets;
  Mesh mesh;
  OffsetStats stats;

  Outlook(const Scene& scene, const Seams& seams, const Face& f)
      : face(f), facets(facets_of(scene, seams, face)), mesh(facets.all, seams) {
    stats.facing_unknown = facets.facing_unknown;
  }
};

Outlook look_out(const Scene& scene, const Seams& seams, const Face& face) {
  const RoundUp guard;
  const SignTally tally;
  const Stopwatch stopwatch;
  Outlook outlook(scene, seams, face);
  outlook.stats.seconds_build = stopwatch.seconds();
  tally.read(outlook.stats);
  return outlook;
}

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

/// Halves one raster down to its pixels, and what is left undecided there some times more.
class Descent {
 public:
  Descent(const Outlook& outlook, const Raster& raster, std::vector<char> wanted, int refinements,
          const Context& context)
      : outlook_(outlook),
        raster_(raster),
        shafts_(raster.frame),
        resolver_(outlook.facets.all, outlook.mesh, shafts_),
        wanted_(std::move(wanted)),
        reached_(wanted_.size(), 0),
        refinements_(refinements),
        context_(context) {}

  void run();

  const std::vector<char>& reached() const { return reached_; }
  const OffsetStats& stats() const { return stats_; }

 private:
  /// Pixels of the raster, from the first up to the last.
  struct Block {
    int column0, column1, row0, row1;

    bool is_pixel() const { return column1 - column0 == 1 && row1 - row0 == 1; }
  };

  Window window(const Block& b) const;
  std::vector<Entry> part(std::span<const HalfSpace> cuts, const std::vector<Entry>& list);
  void halve(const Block& block, std::vector<Entry> list, std::optional<std::size_t> cut);
  void refine(const Beam& beam, std::vector<Entry> list, int left);
  /// A half of a beam, and the half spaces that the whole does not lie in.
  struct Half {
    Beam beam;
    std::size_t first = 0, count = Shafts::count;
    std::span<const HalfSpace> cuts() const { return std::span(beam.spaces).subspan(first, count); }
  };
  std::array<Half, 2> halves(const Beam& beam, double depth) const;
  void look_at_pixel(const Beam& beam, std::vector<Entry> list);
  void shorten(const Beam& beam, std::vector<Entry> list, int left);
  static double least_depth(const std::vector<Entry>& list);
  static double middle_depth(const std::vector<Entry>& list) { return list[list.size() / 2].near; }
  void drop_covered(const Beam& beam, std::vector<Entry>& list);
  std::uint64_t resolve(const Beam& beam, std::vector<Entry>& list, bool by_sides);
  void keep(Entry& entry);
  void count(Failure f);
  void measure(Entry& entry, const Polygon& polygon) const;
  bool cut(Entry& entry, std::span<const HalfSpace> spaces) const;
  void forget_known(std::vector<Entry>& list) const;
  const Facet& facet(const Entry& e) const { return outlook_.facets.all[e.facet]; }

  static constexpr std::ptrdiff_t few_wanted = 4;
  static constexpr std::size_t long_list = 2048, short_list = 128;

  const Outlook& outlook_;
  const Raster& raster_;
  Shafts shafts_;
  Resolver resolver_;
  std::vector<char> wanted_, reached_;
  int refinements_;
  OffsetStats stats_;
  const Context& context_;
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
  halve(all, std::move(list), std::nullopt);
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

/// What is proven to be hidden in the beam is no longer wanted in it; what is seen, nowhere. Returns how much
/// is hidden.
std::uint64_t Descent::resolve(const Beam& beam, std::vector<Entry>& list, bool by_sides) {
  const Timer timer(stats_.seconds_resolve);
  std::uint64_t hidden = 0;
  for (Entry& e : list) {
    if (!e.wanted) continue;
    e.failure = resolver_.hide(beam, list, e, by_sides);
    if (e.failure == Failure::seen) keep(e);
    if (e.failure == Failure::none) {
      e.wanted = false;
      ++hidden;
    }
  }
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

/// The list lies in the block before, which reaches beyond one border: the half space `cut`.
void Descent::halve(const Block& block, std::vector<Entry> list, std::optional<std::size_t> cut) {
  if (context_.cancelled()) throw Error(Error::Code::cancelled, "cell", "interrupted");
  ++stats_.beams;
  const Beam beam(outlook_.face, raster_, shafts_, window(block));
  using Cuts = std::span<const HalfSpace>;
  list = part(cut ? Cuts(&beam.spaces[*cut], 1) : Cuts(), list);
  forget_known(list);
  if (count_wanted(list) == 0) return;
  drop_covered(beam, list);
  if (block.is_pixel()) return shorten(beam, std::move(list), halvings_for(list.size(), long_list));
  if (count_wanted(list) <= few_wanted) resolve(beam, list, false);
  if (count_wanted(list) == 0) return;
  Block first = block, second = block;
  const bool across = block.column1 - block.column0 >= block.row1 - block.row0;
  if (across)
    first.column1 = second.column0 = (block.column0 + block.column1) / 2;
  else
    first.row1 = second.row0 = (block.row0 + block.row1) / 2;
  halve(first, list, across ? Shafts::left : Shafts::below);
  halve(second, std::move(list), across ? Shafts::right : Shafts::above);
}

/// In a pixel each entry is held against the others, which takes the square of their number: a list that is
/// too long for that is shared among parts of the pixel first.
void Descent::shorten(const Beam& beam, std::vector<Entry> list, int left) {
  if (list.size() <= long_list || left == 0) return look_at_pixel(beam, std::move(list));
  for (const Half& half : halves(beam, middle_depth(list))) {
    std::vector<Entry> in = part(half.cuts(), list);
    forget_known(in);
    if (count_wanted(in) == 0) continue;
    drop_covered(half.beam, in);
    if (count_wanted(in) <= few_wanted) resolve(half.beam, in, false);
    if (count_wanted(in) != 0) shorten(half.beam, std::move(in), left - 1);
  }
}

void Descent::look_at_pixel(const Beam& beam, std::vector<Entry> list) {
  const auto asked = static_cast<std::uint64_t>(count_wanted(list));
  ++stats_.lists;
  stats_.list_entries += list.size();
  stats_.list_most = std::max<std::uint64_t>(stats_.list_most, list.size());
  stats_.resolved += asked;
  stats_.resolved_hidden += resolve(beam, list, false);
  refine(beam, std::move(list), refinements_);
}

double Descent::least_depth(const std::vector<Entry>& list) {
  double depth = HUGE_VAL;
  for (const Entry& e : list)
    if (e.wanted) depth = std::min(depth, e.near);
  return depth;
}

/// Halves a beam where its shaft is widest at a depth: one of two edges of the face, or one of two ranges of
/// directions.
std::array<Descent::Half, 2> Descent::halves(const Beam& beam, double depth) const {
  const Vec3d size = beam.face.corners[2] - beam.face.corners[0];
  const Window& w = beam.directions;
  const double reach = depth - shafts_.depth(beam.viewpoint).inf();
  const int i = (beam.face.axis + 1) % 3, j = (beam.face.axis + 2) % 3;
  const double widths[4] = {component(size, i), component(size, j), reach * (w.x1 - w.x0),
                            reach * (w.y1 - w.y0)};
  const auto widest = std::max_element(widths, widths + 4) - widths;
  const auto half = [&](bool upper) -> Half {
    if (widest < 2) return {Beam(beam.face.half(static_cast<int>(widest), upper), raster_, shafts_, w)};
    Window h = w;
    if (widest == 2) {
      (upper ? h.x0 : h.x1) = 0.5 * w.x0 + 0.5 * w.x1;
      return {Beam(beam.face, raster_, shafts_, h), upper ? Shafts::right : Shafts::left, 1};
    }
    (upper ? h.y0 : h.y1) = 0.5 * w.y0 + 0.5 * w.y1;
    return {Beam(beam.face, raster_, shafts_, h), upper ? Shafts::above : Shafts::below, 1};
  };
  return {half(false), half(true)};
}

void Descent::refine(const Beam& beam, std::vector<Entry> list, int left) {
  forget_known(list);
  if (count_wanted(list) == 0) return;
  if (left == 0) {
    for (Entry& e : list)
      if (e.wanted) keep(e);
    return;
  }
  for (const Half& half : halves(beam, least_depth(list))) {
    ++stats_.refined;
    std::vector<Entry> in = part(half.cuts(), list);
    forget_known(in);
    if (count_wanted(in) == 0) continue;
    drop_covered(half.beam, in);
    resolve(half.beam, in, in.size() <= short_list);
    refine(half.beam, std::move(in), left - 1);
  }
}

}  // namespace

UpperSet reach(const Scene& scene, const ViewCell& cell, const std::vector<char>& wanted,
               const PixelGrid& pixels, int refinements, const Context& context, ProgressMeter& meter) {
  const Stopwatch building;
  const Seams seams = on_threads(context, [&] { return Seams(scene); });
  UpperSet set{std::vector<char>(wanted.size(), 0), {}};
  set.stats.seconds_build = building.seconds();
  const std::vector<Face> faces = faces_of(cell);
  std::vector<std::vector<Raster>> rasters;
  double raster_count = 0;
  for (const Face& f : faces) {
    rasters.push_back(rasters_of(cell, f, pixels));
    raster_count += static_cast<double>(rasters.back().size());
  }

  // A face's triangles and edges take much memory: they are made by the thread that first looks out of it.
  std::mutex joining;
  on_threads(context, [&] {
    parallel_queue(faces.size(), [&](std::size_t f) {
      const Outlook outlook = look_out(scene, seams, faces[f]);
      const auto resolve = [&](std::size_t k) {
        const RoundUp guard;
        const SignTally tally;
        Descent descent(outlook, rasters[f][k], wanted, refinements, context);
        descent.run();
        OffsetStats stats = descent.stats();
        tally.read(stats);
        meter.add(1 / raster_count);
        const std::lock_guard lock(joining);
        for (std::size_t id = 0; id < set.reached.size(); ++id) set.reached[id] |= descent.reached()[id];
        set.stats += stats;
      };
      parallel_within([&] { parallel_queue(rasters[f].size(), resolve); });
      const std::lock_guard lock(joining);
      set.stats += outlook.stats;
    });
  });
  return set;
}

}  // namespace provis::offset
