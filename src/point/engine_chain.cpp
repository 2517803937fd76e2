#include "src/point/engine.hpp"

namespace provis {

FrameEngine chain_engine(QueryEffects effects) { return select_engine<Arithmetic::chain>(effects); }

}  // namespace provis
