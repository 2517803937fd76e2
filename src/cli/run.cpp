#include "src/cli/run.hpp"

#include "provis/error.hpp"

namespace provis {

void Run::stage(const std::string& what) {
  if (context.cancelled()) throw Error(Error::Code::cancelled, "", "interrupted while " + doing);
  doing = what;
}

}  // namespace provis
