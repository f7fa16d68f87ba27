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
  explicit Quadrature(double relative_tolerance);

  /// ∫ f from a to b, Gauss–Kronrod 61 points, adaptive. Throws std::runtime_error if GSL reports a failure: it
  /// returns 0 for some, which would pass silently through an outer integral. The absolute tolerance is for integrals
  /// that may vanish.
  template <class F>
  [[nodiscard]] double operator()(F&& f, double a, double b, double absolute_tolerance = 0.0) {
    gsl_function function{[](double x, void* data) { return (*static_cast<std::remove_reference_t<F>*>(data))(x); },
                          const_cast<void*>(static_cast<const void*>(std::addressof(f)))};
    return integrate(function, a, b, absolute_tolerance);
  }

 private:
  [[nodiscard]] double integrate(gsl_function& function, double a, double b, double absolute_tolerance);

  struct Free {
    void operator()(gsl_integration_workspace* workspace) const { gsl_integration_workspace_free(workspace); }
  };
  std::unique_ptr<gsl_integration_workspace, Free> workspace_;
  double relative_tolerance_;
};

/// GSL reports through return values, never through abort(). Call once before threads start.
void silence_gsl();

}  // namespace goishi::verify
