#include "verify/samples/flight_path.hpp"

#include <fmt/format.h>

#include <cmath>

#include "verify/samples/attitude.hpp"

namespace goishi::verify {

FlightPath<double> draw_path(Context& context, const Vec3<double>& p, const Vec3<double>& v, int i) {
  return {.p_W = p,
          .v_W = v,
          .a_W = {0.0, 0.0, -earth_gravity},
          .u_W = draw_unit(context),
          .k_W = draw_unit(context),
          .rate = i % 9 == 8 ? 0.0 : 1000.0 * draw_small(context, 4.0)};
}

Standing standing(const Hull<long double>& hull, const FlightPath<double>& path, long double t) {
  using Long3 = Vec3<long double>;
  const Long3 p =
      path.p_W.cast<long double>() + t * path.v_W.cast<long double>() + t * t / 2 * path.a_W.cast<long double>();
  const long double angle = static_cast<long double>(path.rate) * t / 2;
  const Long3 k = std::sin(angle) * path.k_W.cast<long double>().normalized();
  const Quat<long double> turn(std::cos(angle), k.x(), k.y(), k.z());
  return {hull, triple(p), triple(Long3(turn * path.u_W.cast<long double>().normalized()))};
}

Pose<double> pose_at(const FlightPath<double>& path, double t) {
  const Standing at = standing(Hull<long double>{}, path, static_cast<long double>(t));
  const auto vector = [](const Triple<long double>& v) {
    return Vec3<double>(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
  };
  return {.p_WB = vector(at.p), .q_WB = turn_between(Vec3<double>::UnitZ(), vector(at.u))};
}

std::string describe(const FlightPath<double>& path) {
  return fmt::format("p = {}, v = {}, a = {}, u = {}, k = {}, Ω = {:a}", describe(path.p_W), describe(path.v_W),
                     describe(path.a_W), describe(path.u_W), describe(path.k_W), path.rate);
}

}  // namespace goishi::verify
