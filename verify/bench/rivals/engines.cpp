#include "verify/bench/rivals/engine.hpp"

namespace goishi::verify::bench::rivals {

std::vector<Engine> engines() {
  return {
#ifdef GOISHI_HAS_BULLET
      bullet(),
#endif
#ifdef GOISHI_HAS_ODE
      ode(),
#endif
#ifdef GOISHI_HAS_SICONOS
      siconos(),
#endif
#ifdef GOISHI_HAS_SIMBODY
      simbody(),
#endif
  };
}

}  // namespace goishi::verify::bench::rivals
