#pragma once
// The effects an engine is compiled for; what a query does not call for is not in its code.

namespace provis {

struct QueryEffects {
  bool see_through = true;  ///< some facets do not occlude
  bool front_clip = true;   ///< the eye is at infinity: facets may reach behind the window
};

}  // namespace provis
