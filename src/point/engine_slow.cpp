// The slow policies are there to be compared with: one engine each, with every effect, is enough.

#include "src/point/engine.hpp"

namespace provis {

FrameEngine mpfr_engine() { return &resolve_frame<Arithmetic::mpfr, QueryEffects{}>; }

FrameEngine exact_engine() { return &resolve_frame<Arithmetic::exact, QueryEffects{}>; }

}  // namespace provis
