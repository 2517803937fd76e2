#pragma once
// The answer to a query: a status per primitive and what stands behind it (R11).

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "provis/arithmetic.hpp"
#include "provis/scene.hpp"
#include "provis/vec3.hpp"

namespace provis {

enum class Status : std::uint8_t { hidden, undecided, visible };

enum class Guarantee {
  exact,         ///< nothing is undecided
  aggressive,    ///< what is called visible is visible
  conservative,  ///< what is called hidden is hidden
  bounds,        ///< both, with a gap between them
  sampled,       ///< neither; for comparison only
};

std::string_view name(Status status);
std::string_view name(Guarantee guarantee);

/// An exact number mantissa * 2^exponent; the mantissa is a decimal integer of any length.
struct Dyadic {
  std::string mantissa = "0";
  long exponent = 0;
};

/// A proof that one primitive is visible: a ray that hits it in its relative interior while every
/// occluder outside its plane misses the closed segment from origin to hit (R11).
struct Witness {
  PrimitiveId primitive = 0;
  Vec3<Dyadic> origin;     ///< the eye, or a point of the window for a parallel projection
  Vec3<Dyadic> direction;  ///< of any length but zero
};

/// One convex cell of the visibility subdivision.
struct SubdivisionCell {
  int frame = 0;               ///< index into the view's frames
  std::vector<Vec3d> corners;  ///< (x, y, 0) in window coordinates, rounded for display
  std::string area;            ///< exact, "p/q" in window units
  double area_rounded = 0;
  std::vector<PrimitiveId> visible;  ///< ascending; empty for background
};

/// Where the sampled methods looked. A frame's pixels are those of PixelGrid.
struct SamplingStats {
  std::uint64_t pixels = 0;     ///< of all frames; 0 where nothing was sampled
  std::uint64_t locations = 0;  ///< rays, of all pixels
  std::uint64_t most = 0;       ///< rays of the pixel that has most

  SamplingStats& operator+=(const SamplingStats& other);
};

/// How PointEngine::paper came to its answer. A primitive counts once for each frame that it may be seen in.
struct IterationStats {
  std::uint64_t aggressive = 0;             ///< visible by the aggressive method
  std::uint64_t undecided = 0;              ///< all others, before the first iteration
  std::uint64_t visible = 0;                ///< in the end
  std::uint64_t visible_after_first = 0;    ///< after the first iteration
  std::uint64_t undecided_after_first = 0;  ///< likewise
  std::uint64_t iterations = 0;             ///< 0 where another engine answered, or nothing had to be decided
  std::uint64_t subtracted = 0;             ///< decided exactly one by one where no location could decide
  double area = 0;                          ///< of all windows, in window units, rounded
  double area_missed = 0;  ///< where an occluder is seen that the aggressive method did not find, rounded

  IterationStats& operator+=(const IterationStats& other);
};

/// Costs of a query. The only part of a result that may differ between runs.
struct QueryStats {
  double seconds = 0;      ///< wall clock, from the scene in memory to the finished set
  double cpu_seconds = 0;  ///< of all threads
  int threads = 0;
  std::uint64_t peak_bytes = 0;  ///< resident at most, beyond the scene; 0 where nobody measured it
  SignCounts signs;
  bool checked = false;            ///< signs.wrong was counted (check_doubles.hpp)
  std::uint64_t nodes = 0;         ///< rectangles of the window that were looked at
  std::uint64_t leaves = 0;        ///< rectangles that were resolved exactly
  std::uint64_t samples = 0;       ///< primitives found visible by one certified sample
  std::uint64_t subtractions = 0;  ///< primitives decided by exact subtraction
  SamplingStats sampling;
  IterationStats iteration;
};

/// Status per primitive, in id order, with its guarantee.
struct VisibleSet {
  std::vector<Status> status;  ///< size: the scene's primitive count
  Guarantee guarantee = Guarantee::exact;
  std::string answers = "R7";                ///< the rule of semantics that is answered
  bool eye_on_primitive = false;             ///< the eye lies on an occluding primitive (R7)
  std::vector<Witness> witnesses;            ///< where asked for: one per visible primitive, in id order
  std::vector<SubdivisionCell> subdivision;  ///< where asked for
  QueryStats stats;

  std::vector<PrimitiveId> with(Status wanted) const;
};

}  // namespace provis
