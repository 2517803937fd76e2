#include "src/region/exact_samples.hpp"

#include <algorithm>

#include "src/region/dyadic_point.hpp"
#include "src/region/face_parts.hpp"
#include "src/region/samples.hpp"

namespace provis {

using offset::Face;

namespace {

constexpr int face_halvings = 8, proof_halvings = 6;

}  // namespace

/// Whether everything that the part shows has a proof then. A witness that starts on an occluder, which only
/// touches or cuts the face, proves nothing: another one is looked for in halves of the part.
bool ExactSamples::prove(const Face& part, const Vec3d& direction, int halvings) {
  bool all = true;
  for (Witness& w : queries_.ask(offset_sample_view(part, direction), true).witnesses) {
    std::optional<Witness>& proof = proofs_[w.primitive];
    if (proof) continue;
    if (on_occluder(scene_, w.origin))
      all = false;
    else
      proof = std::move(w);
  }
  if (all || halvings == 0) return all;
  const Face lower = part.half(halvings % 2, false), upper = part.half(halvings % 2, true);
  if (lower.corners == part.corners) return false;
  const bool first = prove(lower, direction, halvings - 1);
  return prove(upper, direction, halvings - 1) && first;
}

void ExactSamples::look_along(const Face& face, const std::vector<Face>& free, const Vec3d& direction) {
  bool open = false;
  for (const PrimitiveId id :
       queries_.ask(offset_sample_view(face, direction), false).with(Status::visible)) {
    shown_[id] = 1;
    open = open || !proofs_[id];
  }
  for (auto part = free.begin(); open && part != free.end(); ++part) prove(*part, direction, proof_halvings);
}

std::uint64_t ExactSamples::look(const PixelGrid& pixels, ProgressMeter& meter) {
  std::uint64_t samples = 0;
  const std::vector<Face> faces = offset::faces_of(cell_);
  for (const Face& face : faces) {
    const std::vector<Face> free = free_parts(scene_, face, face_halvings);
    std::vector<Vec3d> directions;
    for (const offset::Raster& raster : offset::rasters_of(cell_, face, pixels))
      for (const Vec3d& d : pixel_directions(face, raster)) directions.push_back(d);
    for (const Vec3d& d : directions) {
      look_along(face, free, d);
      meter.add(1 / static_cast<double>(directions.size() * faces.size()));
    }
    samples += directions.size();
  }
  return samples;
}

}  // namespace provis
