#pragma once
// From an arithmetic policy that is known when the program runs to one that is a template argument.

#include "provis/arithmetic.hpp"
#include "provis/error.hpp"

namespace provis {

/// What `make`, a callable with a policy as its template argument, makes of the policy.
template <class Make>
auto for_policy(Arithmetic arithmetic, const Make& make) {
  switch (arithmetic) {
    case Arithmetic::doubles:
      return make.template operator()<Arithmetic::doubles>();
    case Arithmetic::chain:
      return make.template operator()<Arithmetic::chain>();
    case Arithmetic::mpfr:
      return make.template operator()<Arithmetic::mpfr>();
    case Arithmetic::exact:
      return make.template operator()<Arithmetic::exact>();
  }
  throw Error(Error::Code::usage, "arithmetic", "unknown policy");
}

}  // namespace provis
