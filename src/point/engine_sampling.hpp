#pragma once
// The engines of the methods that look along rays.

#include "src/point/engine.hpp"

namespace provis {

/// The engine of a policy: Method::aggressive or Method::sampled, as the query's options say.
FrameEngine sampling_engine(Arithmetic arithmetic);

}  // namespace provis
