/// flight.json: free flights, of bodies with a symmetry axis and without one.

#include "verify/reference/elliptic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <goishi/motion/elliptic_flight.hpp>
#include <goishi/motion/free_flight.hpp>

#include "verify/reference/draw.hpp"
#include "verify/reference/sections.hpp"
#include "verify/reference/stones.hpp"

namespace goishi::verify::reference {

namespace {

struct Flying {
  std::array<double, 3> moments;  // about Bx, By, Bz
  std::array<double, 4> attitude;
  std::array<double, 3> position, velocity, spin;  // spin in B
  std::array<double, 3> gravity;
  double time;
  std::string about;

  [[nodiscard]] bool symmetric() const { return !(moments[0] < moments[1]) && !(moments[1] < moments[0]); }
};

/// What an error of ε of the start grows to: 1 and the angles that are turned, and by what the way of the momentum near the
/// middle axis magnifies (`elliptic_flight` says how).
double turned(const Flying& body) {
  std::array<double, 3> L{}, I = body.moments;
  double energy2 = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    L[i] = I[i] * body.spin[i];
    energy2 += L[i] * body.spin[i];
  }
  const double size = length_of(L), time = std::fabs(body.time);
  if (body.symmetric()) {
    return 1.0 + size * time / I[0] + std::fabs(body.spin[2] * time * (1.0 - I[2] / I[0]));
  }
  std::ranges::sort(I);
  const double angle = 1.0 + size * time / I[0];
  if (!(0.0 < size)) {
    return angle;
  }
  const double s = std::fabs(1.0 - energy2 * I[1] / (size * size));
  const double lambda = size * std::sqrt((I[1] - I[0]) * (I[2] - I[1]) / (I[0] * I[2])) / I[1];
  return angle + std::min(1.0 / s, std::exp(lambda * time));
}

template <class T>
Answers<T> flight_answers(const Flying& of) {
  const RigidBody<T> body = make_rigid_body(T(1), vector_of<T>(of.moments));
  const Quat<T> q = attitude_of<T>(of.attitude);
  const State<T> start{.p_WB = vector_of<T>(of.position),
                       .q_WB = q,
                       .v_WB = vector_of<T>(of.velocity),
                       .L_W = formula::angular_momentum_W<T>(q, body, vector_of<T>(of.spin))};
  const Vec3<T> gravity = vector_of<T>(of.gravity);
  const Moments<T> moments{.axial = T(of.moments[2]), .transverse = T(of.moments[0])};
  const State<T> end = of.symmetric() ? free_flight(start, moments, gravity, T(of.time))
                                      : elliptic_flight(start, body, gravity, T(of.time));
  if constexpr (std::same_as<T, OrderedBall>) {
    require_met(formula::rotational_energy(start, body), formula::rotational_energy(end, body), "the energy");
    require_met(end.q_WB.squaredNorm(), T(1), "the length of the attitude");
  }
  const double t = std::fabs(of.time), turns = turned(of);
  const double most = std::max({of.moments[0], of.moments[1], of.moments[2]});
  return {answer("position", end.p_WB,
                 scale_of(length_of(of.position) + length_of(of.velocity) * t + length_of(of.gravity) * t * t / 2.0)),
          answer("velocity", end.v_WB, scale_of(length_of(of.velocity) + length_of(of.gravity) * t)),
          answer("attitude", end.q_WB, scale_of(turns)),
          answer("spin", formula::angular_velocity_B(end, body), scale_of(length_of(of.spin) * turns)),
          answer("angular_momentum", end.L_W, scale_of(length_of(of.spin) * most))};
}

constexpr std::array<double, 3> nowhere = {0.0, 0.0, 0.0};
constexpr std::array<double, 3> earth = {0.0, 0.0, -9.80665};
constexpr std::array<double, 4> upright = {1.0, 0.0, 0.0, 0.0};

std::vector<Flying> symmetric_flights() {
  std::vector<Flying> all;
  const auto spin = [&](std::array<double, 2> moments, std::array<double, 3> w, double time, const std::string& about,
                        std::array<double, 4> attitude = upright) {
    all.push_back({{moments[1], moments[1], moments[0]}, attitude, nowhere, nowhere, w, nowhere, time, about});
  };
  spin({2.0, 1.25}, {0.0, 0.0, 0.0}, 1.0, "at rest");
  spin({2.0, 1.25}, {1.0, 2.0, 8.0}, 0.0, "no time");
  spin({2.0, 1.25}, {0.0, 0.0, 100.0}, 1.0, "about the symmetry axis");
  spin({2.0, 1.25}, {0.0, 100.0, 0.0}, 1.0, "across the symmetry axis");
  spin({2.0, 1.25}, {1.0, 2.0, 8.0}, -10.0, "backwards");
  spin({2.0, 1.25}, {1.0, 2.0, 8.0}, 1e6, "for a long time");
  spin({2.0, 1.25}, {1e-9, 0.0, 1e-9}, 1.0, "slowly");
  spin({2.0, 2.0}, {3.0, -4.0, 12.0}, 10.0, "a ball");
  spin({2.0, 1.0}, {3.0, -4.0, 12.0}, 10.0, "a lamina, I_a = 2 I_t");
  spin({0.01, 1.0}, {3.0, -4.0, 12.0}, 10.0, "a needle, I_a = I_t/100");
  spin({2.0, 1.25}, {1e-6, 0.0, 100.0}, 10.0, "nearly about the symmetry axis");
  spin({2.0, 1.25}, {1.0, 2.0, 8.0}, 0.5, "upside down", {0.0, 1.0, 0.0, 0.0});
  spin({2.0, 1.25}, {1.0, 2.0, 8.0}, 0.5, "a third of a turn", {1.0, 1.0, 1.0, 1.0});
  all.push_back(
      {{1.25, 1.25, 2.0}, upright, {1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}, nowhere, earth, 10.0, "a throw, no spin"});
  Draw draw(4);
  for (int i = 0; i < 40; ++i) {
    const double transverse = draw.part(500, 1000, 1000), ratio = i % 4 == 3 ? 0.1 : 1.5;
    Flying one{{transverse, transverse, transverse * ratio + draw.part(0, 400, 1000) * transverse},
               draw.wholes<4>(99),
               draw.wholes<3>(9),
               draw.wholes<3>(9),
               draw.wholes<3>(50),
               earth,
               draw.part(-2000, 8000, 1000),
               "any"};
    all.push_back(one);
  }
  return all;
}

std::vector<Flying> asymmetric_flights() {
  std::vector<Flying> all;
  const std::array<double, 3> brick = {1.0, 2.0, 2.5};
  const auto spin = [&](std::array<double, 3> moments, std::array<double, 3> w, double time, const std::string& about,
                        std::array<double, 4> attitude = upright) {
    all.push_back({moments, attitude, nowhere, nowhere, w, nowhere, time, about});
  };
  spin(brick, {0.0, 0.0, 0.0}, 1.0, "no symmetry axis, at rest");
  spin(brick, {3.0, 0.0, 0.0}, 10.0, "about the axis of the least moment");
  spin(brick, {0.0, 3.0, 0.0}, 10.0, "about the middle axis, to the bit");
  spin(brick, {0.0, 0.0, -3.0}, 10.0, "about the axis of the greatest moment");
  spin(brick, {1e-3, 3.0, 1e-3}, 10.0, "flips about the middle axis");
  spin(brick, {1e-6, 3.0, 0.0}, 10.0, "begins to flip about the middle axis");
  spin(brick, {1.0, 0.0, 2.0}, 10.0, "across the middle axis");
  spin(brick, {1.0, 2.0, 0.0}, 10.0, "across the greatest axis");
  spin(brick, {0.0, 1.0, 2.0}, 10.0, "across the least axis");
  spin(brick, {1.0, 2.0, 3.0}, -10.0, "backwards");
  spin(brick, {1.0, 2.0, 3.0}, 1e4, "for a long time");
  spin({1.0, 1.0009765625, 1.001953125}, {1.0, 2.0, 3.0}, 10.0, "nearly a ball");
  spin({1.0, 1.0009765625, 1.75}, {1.0, 2.0, 3.0}, 10.0, "nearly with a symmetry axis");
  spin({1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}, 10.0, "a lamina");
  spin({2.5, 1.0, 2.0}, {1.0, 2.0, 3.0}, 10.0, "axes in another order");
  spin({2.0, 2.5, 1.0}, {-1.0, 2.0, -3.0}, 10.0, "axes in another order");
  spin({1.0, 2.0, 2.0}, {1.0, 2.0, 3.0}, 10.0, "a symmetry axis along x");
  spin({2.0, 1.0, 2.0}, {1.0, 2.0, 3.0}, 10.0, "a symmetry axis along y");
  spin(brick, {1.0, 2.0, 3.0}, 0.5, "a third of a turn", {1.0, 1.0, 1.0, 1.0});
  Draw draw(5);
  for (int i = 0; i < 40; ++i) {
    const double a = draw.part(500, 1000, 1000), b = draw.part(500, 1000, 1000);
    all.push_back({{a, b, (a + b) * draw.part(600, 990, 1000)},
                   draw.wholes<4>(99),
                   draw.wholes<3>(9),
                   draw.wholes<3>(9),
                   draw.wholes<3>(20),
                   earth,
                   draw.part(-1000, 3000, 1000),
                   "any, no symmetry axis"});
  }
  return all;
}

}  // namespace

Section flight_section() {
  Section section{
      .name = "flight",
      .about = "Free flights: a parabola, and a rotation without torque",
      .inputs = {{"moments", "kg m^2",
                  "principal moments about the body's x, y and z axis, through the centre of mass"},
                 {"position", "m", "of the centre of mass at the start, in the world"},
                 {"attitude", "",
                  "w, x, y, z of a quaternion of any length: normalise it; body to world, at the start"},
                 {"velocity", "m/s", "of the centre of mass at the start, in the world"},
                 {"spin", "rad/s", "angular velocity at the start, in the body's axes"},
                 {"gravity", "m/s^2", "in the world"},
                 {"time", "s", "of flight"}},
      .quantities =
          {{.name = "position", .unit = "m", .components = 3, .about = "at the end, as all"},
           {.name = "velocity", .unit = "m/s", .components = 3, .about = ""},
           {.name = "attitude", .unit = "", .components = 4, .about = "unit; w, x, y, z", .either_sign = true},
           {.name = "spin", .unit = "rad/s", .components = 3, .about = "in the body's axes"},
           {.name = "angular_momentum",
            .unit = "kg m^2/s",
            .components = 3,
            .about = "in the world; it stays what it was"}},
      .problems = {}};
  std::vector<Flying> flights = symmetric_flights();
  for (const Flying& other : asymmetric_flights()) {
    flights.push_back(other);
  }
  for (const Flying& of : flights) {
    section.problems.push_back(make_problem(
        numbered("flight", section.problems.size() + 1), of.about,
        {input("moments", of.moments), input("position", of.position), input("attitude", of.attitude),
         input("velocity", of.velocity), input("spin", of.spin), input("gravity", of.gravity), input("time", of.time)},
        [of]<class T>(std::type_identity<T>) { return flight_answers<T>(of); }));
  }
  return section;
}

}  // namespace goishi::verify::reference
