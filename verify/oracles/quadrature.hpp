#pragma once
/// \file
/// GSL's adaptive quadrature, with the status of every call checked.

#include <gsl/gsl_integration.h>

#include <memory>
#include <type_traits>

namespace goishi::verify {

/// One adaptive integrator; nested integrals take one each.
class Quadrature {
 public:
  /// The absolute tolerance is for integrals that may vanish.
  explicit Quadrature(double relative_tolerance, double absolute_tolerance = 0.0);

  /// ∫ f from a to b, Gauss–Kronrod 61 points, adaptive. Throws std::runtime_error if GSL reports a failure: it
  /// returns 0 for some, which would pass silently through an outer integral.
  template <class F>
  [[nodiscard]] double operator()(F&& f, double a, double b) {
    gsl_function function{[](double x, void* data) { return (*static_cast<std::remove_reference_t<F>*>(data))(x); },
                          const_cast<void*>(static_cast<const void*>(std::addressof(f)))};
    return integrate(function, a, b);
  }

 private:
  [[nodiscard]] double integrate(gsl_function& function, double a, double b);

  struct Free {
    void operator()(gsl_integration_workspace* workspace) const { gsl_integration_workspace_free(workspace); }
  };
  std::unique_ptr<gsl_integration_workspace, Free> workspace_;
  double relative_tolerance_;
  double absolute_tolerance_;
};

/// GSL reports through return values, never through abort(). Call once before threads start.
void silence_gsl();

}  // namespace goishi::verify
