#pragma once
// Order of events and of depths at a pixel, certain: float64 with an error bound first, then what structure
// knows, then the tiers of the chain.

#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "predicates/path_signs.hpp"
#include "src/segment/event.hpp"

namespace provis {

class SignCheck;

/// The facets of a group of pixels of one frame, and what has been asked about them.
template <Arithmetic A>
class Events {
 public:
  Events(const PathGeometry& path, SignCounts& counts);
  ~Events();

  const PathGeometry& path() const { return signs_.geometry(); }
  const std::vector<MovingFacet>& facets() const { return facets_; }
  std::uint32_t add(MovingFacet facet);
  void clear();

  /// Where the facet is hit within the range; nothing where that is nowhere or for a moment only.
  std::optional<Span> span(const Pixel& at, const Centre& centre, std::uint32_t facet,
                           const TimeRange& range);

  /// The sign of a - b.
  Sign compare(const Pixel& at, const Event& a, const Event& b) {
    const double d = a.t - b.t, unsure = (a.error + b.error) * slack;
    if (filtered && (d > unsure || d < -unsure)) {
      signs_.count(Predicate::event_order, Tier::filter);
      if constexpr (A == Arithmetic::doubles)
        if (check_) [[unlikely]]
          watch_order(at, a, b, sign_of(d));
      return sign_of(d);
    }
    return slow_compare(at, a, b);
  }

  /// The sign of a's distance less b's at the event.
  Sign compare_depth(const Pixel& at, const Shown& a, const Shown& b, const Event& when) {
    const double d = a.depth(when.t) - b.depth(when.t);
    const double unsure =
        (a.depth_error + b.depth_error + std::fabs(a.depth_slope - b.depth_slope) * when.error) * slack;
    if (filtered && (d > unsure || d < -unsure)) {
      signs_.count(Predicate::event_order, Tier::filter);
      if constexpr (A == Arithmetic::doubles)
        if (check_) [[unlikely]]
          watch_depth(at, a, b, when, sign_of(d));
      return sign_of(d);
    }
    return slow_compare_depth(at, a, b, when);
  }

  /// The same event, and the same facet, with nothing believed of them but what they are: the sign of the
  /// slope, or the side, is certain, and the numbers are not used. Zero where there is no such event, or no
  /// hit.
  Event restated(const Pixel& at, const Event& e);
  Shown restated(const Pixel& at, const Shown& s);

  /// Where the planes of two facets cross, given that they do so at one moment, before which the sign of the
  /// first distance less the second is given.
  Event crossing(const Pixel& at, const Shown& a, const Shown& b, Sign first);

  /// Whether two facets lie in one plane.
  bool coplanar(std::uint32_t a, std::uint32_t b);

  Motion motion(const Event& e) const;

 private:
  static constexpr bool filtered = A == Arithmetic::chain || A == Arithmetic::doubles;
  /// For the roundings of a bound itself.
  static constexpr double slack = 1 + 0x1p-20;
  /// What a filter may doubt: nothing for plain doubles.
  static double doubt(double error) { return A == Arithmetic::doubles ? 0 : error; }

  enum class Look { miss, hit, unclear };
  Look quick_span(const Centre& c, std::uint32_t facet, const TimeRange& range, Span& span) const;
  std::optional<Span> slow_span(const Pixel& at, std::uint32_t facet, const TimeRange& range);
  void place(const Pixel& at, Event& e) const;
  void set_depth(const Pixel& at, Shown& shown) const;

  Sign slow_compare(const Pixel& at, const Event& a, const Event& b);
  Sign slow_compare_depth(const Pixel& at, const Shown& a, const Shown& b, const Event& when);
  std::optional<Sign> known_order(const Event& a, const Event& b);
  bool meet_at(const Event& when, std::uint32_t a, std::uint32_t b);
  bool in_plane(const Vec3d& p, std::uint32_t facet);
  bool edge_in_plane(std::uint32_t owner, int edge, std::uint32_t facet);
  bool same_line(std::uint32_t a, int edge_a, std::uint32_t b, int edge_b);
  void watch_order(const Pixel& at, const Event& a, const Event& b, Sign taken);
  void watch_depth(const Pixel& at, const Shown& a, const Shown& b, const Event& when, Sign taken);
  template <class Decide>
  bool remembered(std::uint64_t kind, std::uint64_t a, std::uint64_t b, const Decide& decide);

  PathSigns<A> signs_;
  std::vector<MovingFacet> facets_;
  std::unordered_map<std::uint64_t, bool> memory_;
  std::unique_ptr<SignCheck> check_;  ///< PathGeometry::checked
};

extern template class Events<Arithmetic::doubles>;
extern template class Events<Arithmetic::chain>;
extern template class Events<Arithmetic::mpfr>;
extern template class Events<Arithmetic::exact>;

}  // namespace provis
