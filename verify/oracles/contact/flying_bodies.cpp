#include "verify/oracles/contact/flying_bodies.hpp"

#include <algorithm>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cstddef>
#include <limits>

namespace goishi::verify {

namespace {

namespace odeint = boost::numeric::odeint;

using Real = long double;
using Phase = std::vector<Real>;  // of each body p, v, q (w, x, y, z), ω in B

constexpr std::size_t of_one = 13;
constexpr Real tolerance = 1e-16L;  // of a step, absolute and relative: m, m/s, rad, rad/s

class Flight {
 public:
  explicit Flight(const std::vector<FlyingBody>& bodies) : bodies_(&bodies) {
    for (const FlyingBody& body : bodies) {
      for (const auto& part : {body.p, body.v}) {
        y_.insert(y_.end(), part.begin(), part.end());
      }
      y_.insert(y_.end(), body.attitude.begin(), body.attitude.end());
      y_.insert(y_.end(), body.spin.begin(), body.spin.end());
    }
  }

  void advance(Real time) {
    if (time <= t_) {
      return;
    }
    const auto system = [this](const Phase& y, Phase& rate, Real) { derive(y, rate); };
    odeint::integrate_adaptive(
        odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_fehlberg78<Phase, Real>()), system, y_, t_,
        time, time - t_);
    t_ = time;
  }

  [[nodiscard]] Real time() const { return t_; }

  [[nodiscard]] FlyingPlaces places() const {
    FlyingPlaces result;
    for (std::size_t k = 0; k < bodies_->size(); ++k) {
      const Real* const y = &y_[of_one * k];
      const Real w = y[6], x = y[7], v = y[8], z = y[9], size = w * w + x * x + v * v + z * z;
      result.push_back(
          {{y[0], y[1], y[2]},
           {2 * (x * z + w * v) / size, 2 * (v * z - w * x) / size, (w * w - x * x - v * v + z * z) / size}});
    }
    return result;
  }

 private:
  /// ṗ = v, v̇ = a, q̇ = ½ q (0, ω), and I ω̇ = (I ω) × ω by components.
  void derive(const Phase& y, Phase& rate) const {
    for (std::size_t k = 0; k < bodies_->size(); ++k) {
      const FlyingBody& body = (*bodies_)[k];
      const Real* const in = &y[of_one * k];
      Real* const out = &rate[of_one * k];
      const Real w = in[6], x = in[7], v = in[8], z = in[9], p = in[10], q = in[11], r = in[12];
      for (std::size_t i = 0; i < 3; ++i) {
        out[i] = in[3 + i];
        out[3 + i] = body.a[i];
      }
      out[6] = -(x * p + v * q + z * r) / 2;
      out[7] = (w * p + v * r - z * q) / 2;
      out[8] = (w * q + z * p - x * r) / 2;
      out[9] = (w * r + x * q - v * p) / 2;
      out[10] = (body.transverse - body.axial) * q * r / body.transverse;
      out[11] = (body.axial - body.transverse) * r * p / body.transverse;
      out[12] = 0;
    }
  }

  const std::vector<FlyingBody>* bodies_;
  Phase y_;
  Real t_ = 0;
};

}  // namespace

FlyingEvent first_event(const std::vector<FlyingBody>& bodies, const Gap& gap, Real end, Real step) {
  FlyingEvent event;
  event.least = std::numeric_limits<Real>::infinity();
  Flight flight(bodies), last = flight;
  while (true) {
    const Real now = gap(flight.places());
    if (now < 0) {
      break;
    }
    event.least = std::min(event.least, now);
    if (flight.time() >= end) {
      return event;
    }
    last = flight;
    flight.advance(std::min(end, flight.time() + step));
  }
  event.found = true;
  event.time = flight.time();
  for (int i = 0; i < 60 && last.time() < event.time; ++i) {
    Flight middle = last;
    middle.advance((last.time() + event.time) / 2);
    if (gap(middle.places()) < 0) {
      event.time = middle.time();
    } else {
      last = middle;
    }
  }
  return event;
}

FlyingPlaces places_at(const std::vector<FlyingBody>& bodies, Real time) {
  Flight flight(bodies);
  flight.advance(time);
  return flight.places();
}

}  // namespace goishi::verify
