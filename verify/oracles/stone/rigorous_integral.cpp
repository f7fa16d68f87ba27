#include "verify/oracles/stone/rigorous_integral.hpp"

#include <acb.h>
#include <acb_calc.h>

namespace goishi::verify {

namespace {

constexpr slong working_bits = 128;
constexpr slong goal_bits = 104;  // 31 digits

/// A complex ball that frees itself.
class Complex {
 public:
  Complex() { acb_init(value_); }
  explicit Complex(const Ball& x) : Complex() { acb_set_arb(value_, x.get()); }
  explicit Complex(int n) : Complex() { acb_set_si(value_, n); }
  Complex(const Complex& other) : Complex() { acb_set(value_, other.value_); }
  Complex& operator=(const Complex& other) {
    acb_set(value_, other.value_);
    return *this;
  }
  ~Complex() { acb_clear(value_); }

  friend Complex operator+(const Complex& x, const Complex& y) { return apply(acb_add, x, y); }
  friend Complex operator-(const Complex& x, const Complex& y) { return apply(acb_sub, x, y); }
  friend Complex operator*(const Complex& x, const Complex& y) { return apply(acb_mul, x, y); }

  [[nodiscard]] acb_ptr get() { return value_; }
  [[nodiscard]] acb_srcptr get() const { return value_; }

 private:
  static Complex apply(void (*function)(acb_t, const acb_t, const acb_t, slong), const Complex& x, const Complex& y) {
    Complex result;
    function(result.value_, x.value_, y.value_, working_bits);
    return result;
  }
  acb_t value_;
};

/// A point of an arc, and how fast it moves with the angle.
struct Place {
  Complex rho, z, length_rate, fall_rate;  // dℓ/dφ, −dz/dφ
};

/// An arc of the meridian, about (distance, top − radius), for angles from `from` on over a `span`.
struct Arc {
  Complex distance, top, radius, from, span;

  [[nodiscard]] Place at(const Complex& angle) const {
    Complex half, sine, cosine;
    acb_mul_2exp_si(half.get(), angle.get(), -1);
    acb_sin_cos(sine.get(), cosine.get(), half.get(), working_bits);
    const Complex twice = sine + sine;
    const Complex radial = radius * (twice * cosine);                           // r sin φ
    return {distance + radial, top - radius * (twice * sine), radius, radial};  // z = top − r (1 − cos φ)
  }
};

/// What is integrated over the angle: discs for the volume and both moments, rings for the area. Without the factor π.
using Integrand = Complex (*)(const Place&);

Complex volume_rate(const Place& at) {
  return at.rho * at.rho * at.fall_rate;
}
Complex area_rate(const Place& at) {
  return Complex(2) * at.rho * at.length_rate;
}
/// Twice a disc's ½ ρ².
Complex axial_rate(const Place& at) {
  const Complex square = at.rho * at.rho;
  return square * square * at.fall_rate;
}
/// Four times a disc's ¼ ρ² + z².
Complex transverse_rate(const Place& at) {
  const Complex square = at.rho * at.rho;
  return square * (square + Complex(4) * at.z * at.z) * at.fall_rate;
}

/// ∫ over the arc, as an integral from 0 to 1: exact end points, the span in the integrand.
Ball over(const Arc& arc, Integrand integrand) {
  if (acb_is_zero(arc.radius.get()) != 0) {
    return Ball(0);
  }
  struct Problem {
    const Arc& arc;
    Integrand integrand;
  } problem{arc, integrand};
  // Entire: there is nothing to refuse where Arb asks (order 1) for a function that is analytic.
  const auto evaluate = [](acb_ptr out, const acb_t x, void* data, slong, slong) {
    const auto& [along, rate] = *static_cast<const Problem*>(data);
    Complex share;
    acb_set(share.get(), x);
    const Complex value = rate(along.at(along.from + share * along.span)) * along.span;
    acb_set(out, value.get());
    return 0;
  };
  const Complex zero(0), one(1);
  Complex middle;
  acb_set_d(middle.get(), 0.5);
  evaluate(middle.get(), middle.get(), &problem, 0, working_bits);
  // With no absolute tolerance Arb would halve the interval for ever while its first enclosure holds zero.
  mag_t tolerance;
  mag_init(tolerance);
  acb_get_mag(tolerance, middle.get());
  mag_mul_2exp_si(tolerance, tolerance, -goal_bits);
  Complex result;
  acb_calc_integrate(result.get(), evaluate, &problem, zero.get(), one.get(), goal_bits, tolerance, nullptr,
                     working_bits);
  mag_clear(tolerance);
  Ball real;
  arb_set(real.get(), acb_realref(result.get()));
  return real;
}

Ball pi() {
  Ball result;
  arb_const_pi(result.get(), Ball::precision);
  return result;
}

}  // namespace

Meridian lens_meridian(const Ball& width, const Ball& height) {
  // The chord from pole to rim leaves the pole's tangent at half the angle by which the arc turns (Euclid III.32).
  const Ball slope = atan2(height, width);
  const Ball chord = sqrt(width * width + height * height) / Ball(2);
  const Ball radius = chord / (Ball(2) * sin(slope));
  const Ball turned = Ball(2) * slope;
  return {.height = height,
          .sphere_radius = radius,
          .sphere_offset = radius * cos(turned),
          .joint_angle = turned,
          .tube_distance = width / Ball(2),
          .tube_radius = Ball(0)};
}

Meridian bevelled_meridian(const Ball& width, const Ball& height, const Ball& bevel) {
  Meridian result = lens_meridian(width, height);
  // The arc is left where it has fallen by (h − b)/2 = r (1 − cos φ); the sphere's normal there meets the middle plane
  // in the centre of the circle that touches it from inside.
  const Ball half_angle_square = (height - bevel) / (Ball(4) * result.sphere_radius);  // sin² φ/2
  const Ball joint = Ball(2) * atan2(sqrt(half_angle_square), sqrt(Ball(1) - half_angle_square));
  const Ball to_centre = result.sphere_offset / cos(joint);
  result.joint_angle = joint;
  result.tube_distance = to_centre * sin(joint);
  result.tube_radius = result.sphere_radius - to_centre;
  result.bevelled = true;
  return result;
}

Ball greatest_width(const Meridian& meridian) {
  return Ball(2) * (meridian.tube_distance + meridian.tube_radius);
}

EnclosedIntegrals integrate_rigorously(const Meridian& meridian) {
  const Arc cap{.distance = Complex(0),
                .top = Complex(meridian.height / Ball(2)),
                .radius = Complex(meridian.sphere_radius),
                .from = Complex(0),
                .span = Complex(meridian.joint_angle)};
  const Arc band{.distance = Complex(meridian.tube_distance),
                 .top = Complex(meridian.tube_radius),
                 .radius = Complex(meridian.tube_radius),
                 .from = Complex(meridian.joint_angle),
                 .span = Complex(pi() / Ball(2) - meridian.joint_angle)};
  const auto whole = [&](Integrand integrand) {  // both halves
    const Ball upper = meridian.bevelled ? over(cap, integrand) + over(band, integrand) : over(cap, integrand);
    return Ball(2) * pi() * upper;
  };
  return {.volume = whole(volume_rate),
          .surface_area = whole(area_rate),
          .axial = whole(axial_rate) / Ball(2),
          .transverse = whole(transverse_rate) / Ball(4)};
}

}  // namespace goishi::verify
