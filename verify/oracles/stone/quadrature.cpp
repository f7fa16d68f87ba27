#include "verify/oracles/stone/quadrature.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace goishi::verify {

namespace {
constexpr std::size_t most_intervals = 1000;
}

Quadrature::Quadrature(double relative_tolerance)
    : workspace_(gsl_integration_workspace_alloc(most_intervals)), relative_tolerance_(relative_tolerance) {}

double Quadrature::integrate(gsl_function& function, double a, double b, double absolute_tolerance) {
  double result = 0.0;
  double error = 0.0;
  const int status = gsl_integration_qag(&function, a, b, absolute_tolerance, relative_tolerance_, most_intervals,
                                         GSL_INTEG_GAUSS61, workspace_.get(), &result, &error);
  // Round-off reached before the tolerance is no failure while the estimate stays near it.
  const double tolerance = std::max(absolute_tolerance, relative_tolerance_ * std::fabs(result));
  const bool good = status == GSL_SUCCESS || (status == GSL_EROUND && error <= 10.0 * tolerance);
  if (!good) {
    throw std::runtime_error(
        fmt::format("GSL quadrature on [{:g}, {:g}]: {} (error estimate {:g})", a, b, gsl_strerror(status), error));
  }
  return result;
}

void silence_gsl() {
  gsl_set_error_handler_off();
}

}  // namespace goishi::verify
