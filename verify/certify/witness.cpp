#include "verify/certify/witness.hpp"

#include <stdexcept>

namespace goishi::verify::certify {

namespace {

bool is_positive(const Ball& x) {
  return arb_is_positive(x.get()) != 0;
}

bool is_negative(const Ball& x) {
  return arb_is_negative(x.get()) != 0;
}

}  // namespace

StoneWitness witness_of(const CatalogueStone& entry, int bevel) {
  const Ball w = metres<Ball>(entry.width), h = metres<Ball>(entry.height), b = metres<Ball>(bevel);
  const Meridian meridian = bevel > 0 ? bevelled_meridian(w, h, b) : lens_meridian(w, h);
  const EnclosedIntegrals of = integrate_rigorously(meridian);
  const Ball density(entry.density);
  return {{{"bevel", b},
           {"width", w},
           {"height", h},
           {"outer_width", greatest_width(meridian)},
           {"volume", of.volume},
           {"surface_area", of.surface_area},
           {"density", density},
           {"mass", density * of.volume},
           {"axial", density * of.axial},
           {"transverse", density * of.transverse},
           {"axial_per_mass", of.axial / of.volume},
           {"transverse_per_mass", of.transverse / of.volume}}};
}

SpinWitness::SpinWitness(const CatalogueStone& entry, const Ball& gravity) : gravity_(gravity) {
  const Meridian meridian = lens_meridian(metres<Ball>(entry.width), metres<Ball>(entry.height));
  const EnclosedIntegrals of = integrate_rigorously(meridian);
  radius_ = meridian.sphere_radius;
  offset_ = meridian.sphere_offset;
  axial_ = of.axial / of.volume;
  transverse_ = of.transverse / of.volume;
}

Ball SpinWitness::threshold() const {
  const Ball left = Ball(1) - offset_ / radius_;
  return sqrt(gravity_ * offset_ * left * left / (transverse_ - axial_ * left));
}

Ball SpinWitness::settling_tilt(const Ball& spin) const {
  const Ball jellett = axial_ * spin * (offset_ - radius_);
  const auto excess = [&](const Ball& z) {
    const Ball arm = offset_ - radius_ * z;
    const Ball lever = transverse_ * radius_ * radius_ * (Ball(1) - z * z) + axial_ * arm * arm;
    return gravity_ * offset_ * lever * lever -
           jellett * jellett * (transverse_ * radius_ * radius_ * z + axial_ * radius_ * arm);
  };
  // Halved while the sign in the middle is decided.
  Ball low(0), high(1);
  if (!is_positive(excess(low)) || !is_negative(excess(high))) {
    throw std::runtime_error("no settling tilt: the spin is not above the threshold");
  }
  for (int i = 0; i < 60; ++i) {
    const Ball middle = (low + high) / Ball(2);
    const Ball sign = excess(middle);
    if (is_positive(sign)) {
      low = middle;
    } else if (is_negative(sign)) {
      high = middle;
    } else {
      break;
    }
  }
  Ball z;
  arb_union(z.get(), low.get(), high.get(), Ball::precision);
  const Ball tilt = atan2(sqrt(Ball(1) - z * z), z);
  return tilt * Ball(180) / atan2(Ball(0), Ball(-1));
}

}  // namespace goishi::verify::certify
