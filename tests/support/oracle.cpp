#include "tests/support/oracle.hpp"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <thread>
#include <utility>

#include "tests/support/facet.hpp"
#include "tests/support/window_polygon.hpp"

namespace provis::test {

namespace {

/// Decides one triangle: its polygon minus, for each occluder, the part where that occluder is nearer.
class Subtraction {
 public:
  Subtraction(const Facet& target, std::vector<const Facet*> occluders, Plant plant)
      : target_(target), occluders_(std::move(occluders)), nearer_(occluders_.size()), plant_(plant) {}

  /// A piece of the target that no occluder takes away, or an empty polygon.
  WindowPolygon leftover() { return survivor(target_.polygon, 0); }

 private:
  /// A part of the piece, with positive area, that remains after occluder `first` and all that follow.
  WindowPolygon survivor(const WindowPolygon& piece, std::size_t first);

  /// The lines within whose common inside occluder k is hit, strictly nearer than the target.
  std::vector<Line> region_of(std::size_t k);

  bool is_empty(const WindowPolygon& piece) const {
    return piece.empty() || (plant_ == Plant::use_an_epsilon && piece.rounded_area() < 1e-9);
  }

  const Facet& target_;
  std::vector<const Facet*> occluders_;
  std::vector<std::optional<Line>> nearer_;
  Plant plant_;
  bool forgot_one_ = false;
};

WindowPolygon Subtraction::survivor(const WindowPolygon& piece, std::size_t first) {
  if (is_empty(piece)) return {};
  for (std::size_t k = first; k < occluders_.size(); ++k) {
    if (!overlap(piece.box(), occluders_[k]->polygon.box())) continue;
    WindowPolygon covered = piece;
    std::vector<WindowPolygon> outside;
    for (const Line& line : region_of(k)) {
      outside.push_back(covered.clipped(line, -1));
      covered = covered.clipped(line, +1);
      if (covered.empty()) break;
    }
    if (covered.empty()) continue;  // this occluder takes nothing away
    if (plant_ == Plant::drop_an_occluder && !std::exchange(forgot_one_, true)) continue;
    for (const WindowPolygon& rest : outside) {
      if (WindowPolygon left = survivor(rest, k + 1); !left.empty()) return left;
    }
    return {};
  }
  return piece;
}

std::vector<Line> Subtraction::region_of(std::size_t k) {
  const Facet& occluder = *occluders_[k];
  if (!nearer_[k]) {
    Integer3 lead = target_.denominator * occluder.nearness - occluder.denominator * target_.nearness;
    const bool tied_everywhere = lead == Integer3{};
    if (tied_everywhere && plant_ == Plant::flip_a_tie) lead.z = 1;
    nearer_[k] = make_line(std::move(lead));
  }
  std::vector<Line> region{*nearer_[k]};
  region.insert(region.end(), occluder.inside.begin(), occluder.inside.end());
  return region;
}

/// Occluders that may be nearer than the target somewhere, those that may cover most of it first. Leaving
/// out the others and the order save time and cannot change the answer.
std::vector<const Facet*> worth_subtracting(const Facet& target, const std::vector<Facet>& facets) {
  std::vector<std::pair<double, const Facet*>> found;
  for (const Facet& o : facets) {
    if (!o.occludes || &o == &target || !overlap(o.polygon.box(), target.polygon.box())) continue;
    if (o.nearness_bounds.hi <= target.nearness_bounds.lo) continue;
    found.emplace_back(overlap_area(o.polygon.box(), target.polygon.box()), &o);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<const Facet*> order;
  for (const auto& [area, facet] : found) order.push_back(facet);
  return order;
}

template <class Job>
void run_in_parallel(std::size_t count, int threads, const Job& job) {
  std::size_t workers = threads > 0 ? static_cast<std::size_t>(threads) : std::thread::hardware_concurrency();
  workers = std::clamp<std::size_t>(workers, 1, count / 64 + 1);
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) job(i);
  };
  std::vector<std::thread> others;
  for (std::size_t w = 1; w < workers; ++w) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
}

/// Facets of one frame in id order; those that no ray of the window hits are left out.
std::vector<Facet> facets_of(const SceneArrays& scene, const FrameView& frame, int threads) {
  std::vector<std::optional<Facet>> all(scene.triangles.size());
  run_in_parallel(all.size(), threads, [&](std::size_t t) { all[t] = frame.facet(scene, t); });
  std::vector<Facet> hit;
  for (std::optional<Facet>& facet : all) {
    if (facet) hit.push_back(std::move(*facet));
  }
  return hit;
}

/// What is left of each wanted triangle in one frame; found[id] is kept where it is not empty already.
void look_through(const SceneArrays& scene, const FrameView& frame, const std::vector<char>& wanted,
                  Plant plant, int threads, std::vector<std::optional<Witness>>& found) {
  const std::vector<Facet> facets = facets_of(scene, frame, threads);
  run_in_parallel(facets.size(), threads, [&](std::size_t i) {
    const Facet& target = facets[i];
    if (!wanted[target.id] || found[target.id]) return;
    Subtraction subtraction(target, worth_subtracting(target, facets), plant);
    const WindowPolygon left = subtraction.leftover();
    if (!left.empty()) found[target.id] = frame.ray_through(left.dyadic_inner_point(), target.id);
  });
}

/// Per triangle a witness, for those among the wanted that are visible.
std::vector<std::optional<Witness>> decide(const SceneArrays& scene, const PointView& view,
                                           std::span<const PrimitiveId> ids, Plant plant, int threads) {
  if (!scene.spheres.empty()) throw std::logic_error("the oracle takes no spheres");
  std::vector<char> wanted(scene.triangles.size(), 0);
  for (const PrimitiveId id : ids) wanted.at(id) = 1;
  std::vector<std::optional<Witness>> found(scene.triangles.size());
  const CommonScale scale = scale_of(scene, view);
  for (const Frame& frame : view.frames) {
    look_through(scene, FrameView(view, frame, scale), wanted, plant, threads, found);
  }
  return found;
}

std::vector<PrimitiveId> all_ids(const SceneArrays& scene) {
  std::vector<PrimitiveId> all(scene.triangles.size());
  std::iota(all.begin(), all.end(), PrimitiveId{0});
  return all;
}

}  // namespace

std::vector<bool> oracle_visible(const SceneArrays& scene, const PointView& view, Plant plant, int threads) {
  std::vector<bool> answer;
  for (const auto& witness : decide(scene, view, all_ids(scene), plant, threads)) {
    answer.push_back(witness.has_value());
  }
  return answer;
}

std::vector<bool> subtract_check(const SceneArrays& scene, const PointView& view,
                                 std::span<const PrimitiveId> ids, int threads) {
  const std::vector<std::optional<Witness>> found = decide(scene, view, ids, Plant::none, threads);
  std::vector<bool> answer;
  for (const PrimitiveId id : ids) answer.push_back(found[id].has_value());
  return answer;
}

std::vector<Witness> oracle_witnesses(const SceneArrays& scene, const PointView& view, int threads) {
  std::vector<Witness> witnesses;
  for (std::optional<Witness>& witness : decide(scene, view, all_ids(scene), Plant::none, threads)) {
    if (witness) witnesses.push_back(std::move(*witness));
  }
  return witnesses;
}

}  // namespace provis::test
