#include "src/point/engine.hpp"

namespace provis {

FrameEngine doubles_engine(QueryEffects effects) { return select_engine<Arithmetic::doubles>(effects); }

}  // namespace provis
