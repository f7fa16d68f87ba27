/// IMPACT: Stronge's law in three dimensions: the slip turns; where it stops it stays, or starts again in another direction.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/samples/impact.hpp"

namespace goishi::verify {

namespace {

namespace odeint = boost::numeric::odeint;

using Long2 = Eigen::Matrix<long double, 2, 1>;

/// The contact of an impact that slips, in a frame whose last axis is the normal.
struct SlippingContact {
  Mat3<long double> frame, W;
  long double mu;

  SlippingContact(const Meeting& meeting, double friction) : mu(static_cast<long double>(friction)) {
    const Long3 a = meeting.n.unitOrthogonal();
    frame << a, meeting.n.cross(a), meeting.n;
    W = frame.transpose() * meeting.W * frame;
  }

  /// What would hold the contact, for each unit of normal impulse.
  [[nodiscard]] Long2 holding() const { return -W.topLeftCorner<2, 2>().inverse() * W.topRightCorner<2, 1>(); }
  /// The rates in the normal impulse where the contact slips in the direction s.
  [[nodiscard]] Long3 rate(const Long2& s) const { return W * Long3(-mu * s.x(), -mu * s.y(), 1); }

  struct Way {
    Long2 direction;
    long double growth;  // of the slip in the normal impulse
  };
  /// The directions that a slip keeps, looked for all the way round.
  [[nodiscard]] std::vector<Way> ways() const {
    const auto direction = [](long double phi) { return Long2(std::cos(phi), std::sin(phi)); };
    const auto turning = [&](long double phi) {
      const Long3 r = rate(direction(phi));
      return r.y() * std::cos(phi) - r.x() * std::sin(phi);
    };
    constexpr int parts = 720;
    constexpr long double part = 2 * std::numbers::pi_v<long double> / parts;
    std::vector<Way> found;
    for (int i = 0; i < parts; ++i) {
      long double low = part * i, high = part * (i + 1);
      const bool rises = turning(low) < 0;
      if (rises == (turning(high) < 0)) {
        continue;
      }
      for (int k = 0; k < 64; ++k) {
        const long double middle = (low + high) / 2;
        ((turning(middle) < 0) == rises ? low : high) = middle;
      }
      const Long2 s = direction(low);
      found.push_back({s, s.dot(rate(s).head<2>())});
    }
    return found;
  }
};

/// The impact in its normal impulse, by Odeint as long as the contact slips; where it stops, friction holds it, or the
/// slip starts again in the direction in which it grows.
class SlippingImpact {
 public:
  SlippingImpact(const Meeting& meeting, const Material<double>& material)
      : contact_(meeting, material.friction),
        given_back_(static_cast<long double>(material.restitution) * static_cast<long double>(material.restitution)) {
    const Long3 v = contact_.frame.transpose() * meeting.before;
    now_ = {v.x(), v.y(), v.z(), 0, 0};
    nothing_ = 1e-15L * v.norm();
    least_ = slip();
  }

  /// To its end; false if its steps run out.
  [[nodiscard]] bool run() {
    constexpr int most_pieces = 12;
    for (int piece = 0; piece < most_pieces; ++piece) {
      if (slip() <= nothing_ ? straight() : slide()) {
        return !gave_up_;
      }
    }
    return false;
  }

  /// The velocity in W.
  [[nodiscard]] Long3 v() const { return contact_.frame * Long3(now_[0], now_[1], now_[2]); }
  [[nodiscard]] long double normal_impulse() const { return now_[4]; }
  /// The least slip that there was.
  [[nodiscard]] long double least_slip() const { return least_; }
  /// In how many directions a slip could start where one had to; 1 if none had to.
  [[nodiscard]] int ways() const { return ways_; }
  /// How often a slip had to start from nothing.
  [[nodiscard]] int starts() const { return starts_; }

 private:
  // The velocity, the normal one last; the work of the normal force in this phase; the normal impulse.
  using Course = std::array<long double, 5>;

  [[nodiscard]] long double slip() const { return std::hypot(now_[0], now_[1]); }
  [[nodiscard]] long double to_come(const Course& x) const {
    return compressing_ ? x[2] : x[3] + given_back_ * compression_;
  }
  /// True if it was the last phase.
  [[nodiscard]] bool end_phase() {
    if (!compressing_) {
      return true;
    }
    compressing_ = false;
    compression_ = now_[3];
    now_[3] = 0;
    return to_come(now_) >= 0;
  }

  /// Until the phase ends (true if it was the last), or the slip is nothing.
  [[nodiscard]] bool slide() {
    using Stepper = odeint::runge_kutta_fehlberg78<Course, long double>;
    auto controlled = odeint::make_controlled(nothing_ / 100, 1e-16L, Stepper());
    const auto system = [this](const Course& x, Course& dxdt, long double) {
      const Long3 rate = contact_.rate(Long2(x[0], x[1]).normalized());
      dxdt = {rate.x(), rate.y(), rate.z(), x[2], 1};
    };
    long double p = 0, h = std::hypot(slip(), now_[2]) / contact_.W(2, 2);  // what stops all of it at once
    // Where there is no slip the rates jump: a step changes a part of it at most. A small one with little friction: the
    // rates all but depend on the normal impulse alone then, to which the stepper's estimate is blind.
    const int parts = contact_.mu < 0.1L ? 16 : 2;
    constexpr int most_steps = 3000;
    for (int steps = 0; steps < most_steps; ++steps) {
      h = std::min(h, slip() / contact_.rate(Long2(now_[0], now_[1]).normalized()).head<2>().norm() / parts);
      const Course before = now_;
      const long double tried = h;
      if (controlled.try_step(system, now_, p, h) == odeint::fail) {
        continue;
      }
      if (to_come(now_) >= 0) {
        // A step of the same method, its length halved until it ends on the zero.
        Stepper stepper;
        long double low = 0, high = tried;
        for (int i = 0; i < 70; ++i) {
          const long double middle = (low + high) / 2;
          stepper.do_step(system, before, 0.0L, now_, middle);
          (to_come(now_) < 0 ? low : high) = middle;
        }
        return end_phase();
      }
      least_ = std::min(least_, slip());
      if (slip() <= nothing_) {
        now_[0] = now_[1] = 0;
        return false;
      }
    }
    gave_up_ = true;
    return true;
  }

  /// From a contact that does not slip, at a constant rate to the end of the phase; true if it was the last.
  [[nodiscard]] bool straight() {
    const Long2 holding = contact_.holding();
    const bool holds = holding.norm() <= contact_.mu;
    Long3 r = contact_.W * Long3(holding.x(), holding.y(), 1);
    if (!holds) {
      ++starts_;
      ways_ = 0;
      for (const SlippingContact::Way& way : contact_.ways()) {
        if (way.growth > 0) {
          ++ways_;
          r = contact_.rate(way.direction);
        }
      }
    }
    const long double ahead = -to_come(now_), vn = now_[2];
    const long double p = compressing_ ? ahead / r.z() : (std::sqrt(vn * vn + 2 * r.z() * ahead) - vn) / r.z();
    now_ = {holds ? 0 : p * r.x(), holds ? 0 : p * r.y(), vn + p * r.z(), now_[3] + p * vn + p * p * r.z() / 2,
            now_[4] + p};
    return end_phase();
  }

  SlippingContact contact_;
  long double given_back_, compression_ = 0, nothing_ = 0, least_ = 0;
  bool compressing_ = true, gave_up_ = false;
  int ways_ = 1, starts_ = 0;
  Course now_;
};

/// What slips, of a velocity at the contact.
Long3 slip_of(const Meeting& meeting, const Long3& v) {
  return v - meeting.n.dot(v) * meeting.n;
}

long double angle_between(const Long3& a, const Long3& b) {
  return std::acos(std::clamp(a.dot(b) / (a.norm() * b.norm()), -1.0L, 1.0L));
}

/// A slip that goes below this part of itself is one that stops.
constexpr long double nearly_none = 1e-6L;

// --- IMPACT-7

Measurement measure_turning(Context& context) {
  Checks checks;
  int given_up = 0;
  long double turned = 0;
  const auto count = static_cast<std::uint64_t>(context.samples(200, 2000));
  for (int i = 0; checks["velocity"].cases() < count; ++i) {
    Encounter met = draw_encounter(context, i);
    met.material.friction =
        std::min(i % 3 == 0 ? std::pow(10.0, context.uniform(-6.0, 0.0)) : met.material.friction, 3.0);
    const Meeting meeting(met);
    if (!(meeting.before.dot(meeting.n) < -0.05L * meeting.before.norm())) {
      continue;
    }
    SlippingImpact impact(meeting, met.material);
    if (!impact.run()) {
      ++given_up;
      continue;
    }
    const Long3 slip = slip_of(meeting, meeting.before);
    if (!(impact.least_slip() > nearly_none * slip.norm())) {
      continue;
    }
    const TwoBodyImpact<double> found = strike(met, ImpactLaw::stronge);
    const BodyVelocity<double> first{context.produced(found.first.v_WB), found.first.L_W};
    const auto describe_it = [&] { return describe(met, ImpactLaw::stronge); };
    // Past next to no slip the direction turns at once: it is known as well as that slip.
    const double allowed = meeting.scale * (1.0 + 1e-3 * as_double(slip.norm() / impact.least_slip()));
    checks["velocity"].see(as_double((meeting.velocity(first, found.second) - impact.v()).norm()), allowed,
                           describe_it);
    const auto told = static_cast<long double>(context.produced(found.impulse.normal));
    const long double off = std::fabs(told - impact.normal_impulse()) * meeting.n.dot(meeting.W * meeting.n);
    checks["impulse"].see(as_double(off), allowed, describe_it);
    turned = std::max(turned, angle_between(slip, slip_of(meeting, impact.v())));
  }
  return checks.measurement(
      {{"the slip turned by up to", fmt::format("{:.0f}°", as_double(turned) * 180.0 / std::numbers::pi)},
       {"left out: the witness's steps ran out", fmt::format("{}", given_up)}});
}

// --- IMPACT-9

/// The contact is to move so; the first body's centre makes up for what there is.
void set_contact_velocity(Encounter& met, const Long3& v) {
  met.first.state.v_WB += (v - Meeting(met).before).cast<double>();
}

/// An impact with as little slip as friction can take away.
Encounter draw_stopping(Context& context, int i) {
  Encounter met = draw_encounter(context, i);
  met.material.friction = context.uniform(0.02, 3.0);
  const double share = met.material.friction * std::pow(10.0, context.uniform(-3.0, 0.3));
  const Vec3<double> v = share * met.n_W.cross(draw_unit(context)) - context.uniform(0.2, 1.0) * met.n_W;
  set_contact_velocity(met, v.cast<long double>());
  return met;
}

/// An impact of two stones whose slip goes through nothing, or nearly so, where friction cannot hold it: in one of the
/// directions that it keeps, it falls.
std::optional<Encounter> draw_passing(Context& context, int i) {
  Encounter met = draw_encounter(context, 2 * i + 1);
  const double needed = static_cast<double>(SlippingContact(Meeting(met), 0.0).holding().norm());
  met.material.friction = needed * (i % 4 == 0 ? 0.98 : context.uniform(0.05, 0.98));
  const Meeting meeting(met);
  const SlippingContact contact(meeting, met.material.friction);
  const long double fastest = static_cast<long double>(context.uniform(0.2, 1.0));
  for (const SlippingContact::Way& way : contact.ways()) {
    if (way.growth < -0.01L * contact.W(2, 2)) {
      // It is nothing some way into the compression.
      const long double p = fastest / contact.W(2, 2) * static_cast<long double>(context.uniform(0.1, 0.9));
      const Long2 s = -way.growth * p * way.direction;
      set_contact_velocity(met, contact.frame * Long3(s.x(), s.y(), -fastest));
      return met;
    }
  }
  return std::nullopt;
}

Measurement measure_stopping(Context& context) {
  Checks checks;
  int stopped = 0, passed = 0, given_up = 0, starts = 0;
  long double turned = 0;
  const auto see = [&](const Encounter& met, const char* name) {
    const Meeting meeting(met);
    SlippingImpact impact(meeting, met.material);
    const Long3 slip = slip_of(meeting, meeting.before);
    if (!impact.run()) {
      ++given_up;
      return false;
    }
    if (impact.least_slip() > nearly_none * slip.norm()) {
      return false;
    }
    const TwoBodyImpact<double> found = strike(met, ImpactLaw::stronge);
    const BodyVelocity<double> first{context.produced(found.first.v_WB), found.first.L_W};
    const auto describe_it = [&] { return describe(met, ImpactLaw::stronge); };
    checks[name].see(as_double((meeting.velocity(first, found.second) - impact.v()).norm()), meeting.scale,
                     describe_it);
    see_choice(checks["ways"], impact.ways() == 1, describe_it);
    starts += impact.starts();
    if (const Long3 after = slip_of(meeting, impact.v()); after.norm() > 0) {
      turned = std::max(turned, angle_between(slip, after));
    }
    return true;
  };
  const int count = context.samples(300, 4000);
  for (int i = 0; stopped < count && i < 100 * count; ++i) {
    stopped += see(draw_stopping(context, i), "stopped") ? 1 : 0;
  }
  for (int i = 0; passed < count && i < 100 * count; ++i) {
    if (const std::optional<Encounter> met = draw_passing(context, i)) {
      passed += see(*met, "passed") ? 1 : 0;
    }
  }
  return checks.measurement({{"turned by up to", fmt::format("{:.0f}°", as_double(turned) * 180.0 / std::numbers::pi)},
                             {"slips that started from exactly nothing", fmt::format("{}", starts)},
                             {"left out: the witness's steps ran out", fmt::format("{}", given_up)}});
}

}  // namespace

std::vector<Claim> impact_slip_claims() {
  return {
      {.id = "IMPACT-7",
       .statement = "Stronge's law out of the plane, where the slip turns and does not stop: velocity and impulse are "
                    "those of its equations, with friction up to 3.",
       .function = "resolve, stronge; slip_series",
       .family = OracleFamily::integration,
       .oracle = "Odeint's Runge–Kutta–Fehlberg 7(8) in long double, in the normal impulse",
       .checks = {within("velocity", 1e-14, "of the contact's velocity, centre and spin added up",
                         "round-off of the velocity, more past next to no slip; measured 2026-11-30 with 30 seeds: up "
                         "to 2.9e-15",
                         epsilon),
                  within("impulse", 1e-14, "of the contact's velocity, centre and spin added up",
                         "the same, of what it changes of the normal one; measured 2026-11-30 with 30 seeds: up to "
                         "2.2e-15",
                         epsilon)},
       .measure = measure_turning},
      {.id = "IMPACT-9",
       .statement = "Stronge's law out of the plane, where the slip stops: friction holds the contact, or, where it "
                    "cannot, the slip starts again in the one direction that it keeps.",
       .function = "resolve, stronge",
       .family = OracleFamily::integration,
       .oracle = "Odeint's Runge–Kutta–Fehlberg 7(8) in long double until the slip is 1e-15 of the velocity; the new "
                 "direction looked for all the way round",
       .checks =
           {within("stopped", 2e-14, "of the contact's velocity, centre and spin added up",
                   "round-off of the velocity; measured 2026-11-30 with 60 seeds: up to 3.8e-15", epsilon),
            within("passed", 2e-14, "of the contact's velocity, centre and spin added up",
                   "round-off of the velocity; measured 2026-11-30 with 60 seeds, and in the full tier: up to 3.9e-15",
                   epsilon),
            none("ways", "starts with no direction, or more than one")},
       .measure = measure_stopping},
  };
}

}  // namespace goishi::verify
