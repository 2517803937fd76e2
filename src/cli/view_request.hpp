#pragma once
// A from-point query as people state it, on the command line or in a file of named views.

#include <array>
#include <optional>
#include <string>

#include "provis/view.hpp"

namespace provis {

/// Whatever was stated; what was not is filled in by the defaults of the command line.
struct ViewRequest {
  Projection projection = Projection::pinhole;
  std::optional<Vec3d> eye, dir, look_at, right, up, forward;
  std::optional<Window> window;
  std::optional<double> fovy_degrees;
  std::optional<std::array<int, 2>> size;  ///< pixels; the aspect
};

/// The view that was meant. With right or forward the vectors and the window are taken verbatim; otherwise
/// a camera is built from dir or look-at, up, and either window or fovy and size. prefix stands before an
/// option's name in messages ("--").
///
/// Throws:     Error::usage for a request that says too little, too much, or nonsense
PointView build_view(const ViewRequest& request, const std::string& prefix);

}  // namespace provis
