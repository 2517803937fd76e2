#pragma once
// The engine of Popescu et al.: sampled first, and iterated until everything is decided.

#include "src/point/engine.hpp"

namespace provis {

/// The engine of a policy.
FrameEngine paper_engine(Arithmetic arithmetic);

}  // namespace provis
