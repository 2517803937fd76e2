#pragma once
// Sampling viewpoints: what single ones see at the pixel centres of some frames, united.

#include <functional>
#include <vector>

#include "provis/context.hpp"
#include "provis/scene.hpp"
#include "provis/view.hpp"
#include "provis/visible_set.hpp"

namespace provis {

/// viewpoint(k) for k below `count`; `place` is named by errors.
///
/// Guarantee:  none: plain float64. Visible or hidden, per primitive; the same for any number of threads
/// Throws:     Error::cancelled
std::vector<Status> sampled_from_viewpoints(const Scene& scene, std::size_t count,
                                            const std::function<Vec3d(std::size_t)>& viewpoint,
                                            const std::vector<Frame>& frames, const PixelGrid& pixels,
                                            const char* place, const Context& context);

}  // namespace provis
