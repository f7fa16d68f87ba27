#include "verify/certify/witness.hpp"

#include <stdexcept>

namespace goishi::verify::certify {

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

SpinningCap<Ball> spinning_cap(const CatalogueStone& entry, const Ball& gravity) {
  const Meridian meridian = lens_meridian(metres<Ball>(entry.width), metres<Ball>(entry.height));
  const EnclosedIntegrals of = integrate_rigorously(meridian);
  return {.r = meridian.sphere_radius,
          .d = meridian.sphere_offset,
          .axial = of.axial / of.volume,
          .transverse = of.transverse / of.volume,
          .gravity = gravity};
}

Ball settling_tilt(const SpinningCap<Ball>& stone, const Ball& spin) {
  const Ball jellett = stone.axial * spin * (stone.d - stone.r);
  Ball low(0), high(1);
  if (!stone.righting(low, jellett).is_positive() || !stone.righting(high, jellett).is_negative()) {
    throw std::runtime_error("no settling tilt: the spin is not above the threshold");
  }
  // Halved while the sign in the middle is decided.
  for (int i = 0; i < 60; ++i) {
    const Ball middle = (low + high) / Ball(2);
    const Ball sign = stone.righting(middle, jellett);
    if (sign.is_positive()) {
      low = middle;
    } else if (sign.is_negative()) {
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
