/// impact.json: impacts of a body on a fixed one, and of two bodies.

#include <fmt/format.h>

#include <cmath>
#include <concepts>
#include <goishi/impact/laws.hpp>
#include <goishi/motion/state.hpp>
#include <optional>

#include "verify/reference/draw.hpp"
#include "verify/reference/sections.hpp"
#include "verify/reference/stones.hpp"

namespace goishi::verify::reference {

namespace {

struct Striking {
  double mass, axial, transverse;
  std::array<double, 4> attitude;
  std::array<double, 3> velocity, spin;  // spin in B
  std::array<double, 3> arm;             // from the centre of mass to the contact, in W
};

struct Meeting {
  Striking first;
  std::optional<Striking> second;
  std::array<double, 3> normal;
  double restitution, friction;
  std::string about;
};

template <class T>
struct Struck {
  ImpactBody<T> body;
  RigidBody<T> rigid;
  Quat<T> q;

  explicit Struck(const Striking& of)
      : rigid(make_rigid_body(T(of.mass), Moments<T>{.axial = T(of.axial), .transverse = T(of.transverse)})),
        q(attitude_of<T>(of.attitude)) {
    body = {.mobility = make_mobility(T(of.mass), Moments<T>{.axial = T(of.axial), .transverse = T(of.transverse)}),
            .p_WB = -vector_of<T>(of.arm),
            .u_W = symmetry_axis(q),
            .v_WB = vector_of<T>(of.velocity),
            .L_W = formula::angular_momentum_W<T>(q, rigid, vector_of<T>(of.spin))};
  }
  [[nodiscard]] Vec3<T> spin(const BodyVelocity<T>& after) const {
    return formula::angular_velocity_B(State<T>{.p_WB = body.p_WB, .q_WB = q, .v_WB = after.v_WB, .L_W = after.L_W},
                                       rigid);
  }
};

/// Of the contact point, by the spin in the body's axes.
template <class T>
Vec3<T> contact_velocity(const Striking& of, const Struck<T>& struck, const BodyVelocity<T>& moves) {
  const Vec3<T> turning = struck.q * struck.spin(moves);
  return formula::plus(moves.v_WB, formula::cross(turning, vector_of<T>(of.arm)));
}

/// What the law promises: it leaves e times as fast as it came, and one that slid has friction's greatest impulse.
template <class T>
void require_law(const Meeting& of, const Vec3<T>& n, const Impulse<T>& impulse, const Vec3<T>& before,
                 const Vec3<T>& after) {
  if constexpr (std::same_as<T, OrderedBall>) {
    if (impulse.outcome == ImpactOutcome::separating) {
      return;
    }
    require_met(formula::dot(n, after), -(T(of.restitution) * formula::dot(n, before)), "the restitution");
    if (impulse.outcome == ImpactOutcome::slid) {
      const T along = formula::dot(n, impulse.impulse_W);
      const T across = formula::dot(impulse.impulse_W, impulse.impulse_W) - along * along;
      require_met(across, scalar::sq(T(T(of.friction) * along)), "the friction");
    }
  }
}

/// How fast the contact point of a body may be.
double speed_of(const Striking& of) {
  return length_of(of.velocity) + length_of(of.spin) * length_of(of.arm);
}

/// An impulse changes the velocity where it acts by no more than twice the speeds that meet: so does its part that turns.
template <class T>
void add_body(Answers<T>& answers, const std::string& prefix, const Striking& of, const Struck<T>& struck,
              const BodyVelocity<T>& after, double speed) {
  const double gyration = std::sqrt(std::fmin(of.axial, of.transverse) / of.mass);
  answers.push_back(answer(prefix + "velocity", after.v_WB, scale_of(speed)));
  answers.push_back(answer(prefix + "spin", struck.spin(after), scale_of(length_of(of.spin) + speed / gyration)));
}

template <class T>
Answers<T> impact_answers(const Meeting& of) {
  const Material<T> material{.restitution = T(of.restitution), .friction = T(of.friction)};
  const Vec3<T> n = direction_of<T>(of.normal), contact(T(0), T(0), T(0));
  const Struck<T> first(of.first);
  const auto of_impulse = [](const Impulse<T>& impulse, double scale) {
    return Answers<T>{word<T>("outcome", to_string(impulse.outcome)), answer("impulse", impulse.impulse_W, scale)};
  };
  if (!of.second) {
    const Impact<T> impact = resolve(ImpactLaw::chatterjee_ruina, material, contact, n, first.body);
    require_law(of, n, impact.impulse, contact_velocity<T>(of.first, first, {first.body.v_WB, first.body.L_W}),
                contact_velocity(of.first, first, impact.body));
    const double speed = 2.0 * speed_of(of.first);
    Answers<T> answers = of_impulse(impact.impulse, scale_of(of.first.mass * speed));
    add_body(answers, "", of.first, first, impact.body, speed);
    return answers;
  }
  const Struck<T> second(*of.second);
  const TwoBodyImpact<T> impact = resolve(ImpactLaw::chatterjee_ruina, material, contact, n, first.body, second.body);
  require_law<T>(of, n, impact.impulse,
                 formula::minus(contact_velocity<T>(of.first, first, {first.body.v_WB, first.body.L_W}),
                                contact_velocity<T>(*of.second, second, {second.body.v_WB, second.body.L_W})),
                 formula::minus(contact_velocity(of.first, first, impact.first),
                                contact_velocity(*of.second, second, impact.second)));
  const double speed = 2.0 * (speed_of(of.first) + speed_of(*of.second));
  Answers<T> answers = of_impulse(impact.impulse, scale_of(std::fmin(of.first.mass, of.second->mass) * speed));
  add_body(answers, "", of.first, first, impact.first, speed);
  add_body(answers, "other_", *of.second, second, impact.second, speed);
  return answers;
}

Striking draw_striking(Draw& draw, bool needle) {
  const double mass = draw.part(500, 2000, 1000), transverse = draw.part(500, 1500, 10000);
  Striking one{
      mass, transverse * (needle ? 0.125 : draw.part(1000, 1999, 1000)), transverse, draw.wholes<4>(99), {}, {}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    one.velocity[i] = draw.part(-1000, 1000, 1000);
    one.spin[i] = draw.part(-1000, 1000, 100);
    one.arm[i] = draw.part(-500, 500, 1000);
  }
  return one;
}

std::vector<Meeting> meetings() {
  constexpr std::array<double, 3> up = {0.0, 0.0, 1.0}, at_rest = {0.0, 0.0, 0.0};
  constexpr std::array<double, 4> level = {1.0, 0.0, 0.0, 0.0};
  const Striking flat{1.0, 0.125, 0.0625, level, {0.0, 0.0, -1.0}, at_rest, {0.0, 0.0, -0.25}};
  const auto changed = [](Striking one, auto&& change) {
    change(one);
    return one;
  };
  std::vector<Meeting> all;
  for (const double e : {0.0, 0.5, 1.0}) {
    all.push_back({flat, {}, up, e, 0.0, fmt::format("flat on a face, e = {}, no friction", e)});
    all.push_back({flat, {}, up, e, 0.25, fmt::format("flat on a face, e = {}", e)});
  }
  all.push_back({changed(flat, [](Striking& s) { s.velocity = {0.0, 0.0, 1.0}; }), {}, up, 0.5, 0.25, "it parts"});
  all.push_back({changed(flat, [](Striking& s) { s.velocity = {1.0, 0.0, 0.0}; }), {}, up, 0.5, 0.25, "it grazes"});
  all.push_back({changed(flat,
                         [](Striking& s) {
                           s.spin = {0.0, 0.0, 8.0};
                         }),
                 {},
                 up,
                 0.5,
                 0.25,
                 "a spin about the normal"});
  const Striking edge{1.0, 0.125, 0.0625, {1.0, 1.0, 1.0, 1.0}, {0.0, 0.0, -1.0}, at_rest, {0.0, 0.0, -0.5}};
  all.push_back({edge, {}, up, 0.5, 0.25, "on edge"});
  all.push_back({changed(edge,
                         [](Striking& s) {
                           s.arm = {0.25, 0.0, -0.5};
                         }),
                 {},
                 up,
                 0.5,
                 0.0,
                 "off its centre, no friction"});
  all.push_back({changed(edge,
                         [](Striking& s) {
                           s.arm = {0.25, 0.0, -0.5};
                         }),
                 {},
                 up,
                 0.5,
                 0.125,
                 "off its centre, slides"});
  all.push_back({changed(edge,
                         [](Striking& s) {
                           s.arm = {0.25, 0.0, -0.5};
                         }),
                 {},
                 up,
                 0.5,
                 4.0,
                 "off its centre, sticks"});
  all.push_back({changed(flat,
                         [](Striking& s) {
                           s.velocity = {1.0, 0.0, -1.0};
                         }),
                 {},
                 up,
                 0.5,
                 0.125,
                 "oblique, slides"});
  all.push_back({changed(flat,
                         [](Striking& s) {
                           s.velocity = {1.0, 0.0, -1.0};
                         }),
                 {},
                 up,
                 0.5,
                 1.0,
                 "oblique, sticks"});
  all.push_back({changed(flat,
                         [](Striking& s) {
                           s.axial = 0.0625;
                           s.velocity = {1.0, 0.0, -1.0};
                           s.spin = {0.0, 4.0, 0.0};
                         }),
                 {},
                 up,
                 0.5,
                 0.125,
                 "a ball, which slides"});
  const Striking below{2.0, 0.125, 0.0625, level, {0.0, 0.0, 1.0}, at_rest, {0.0, 0.0, 0.25}};
  all.push_back({flat, below, up, 0.5, 0.25, "two, face to face"});
  all.push_back(
      {flat, changed(below, [](Striking& s) { s.mass = 1.0; }), up, 1.0, 0.0, "two alike, e = 1, no friction"});
  Draw draw(6);
  constexpr std::array<double, 5> restitutions = {0.0, 0.25, 0.5, 0.75, 1.0};
  for (std::size_t i = 0; i < 90; ++i) {
    Meeting one{draw_striking(draw, i % 7 == 3),
                {},
                draw.wholes<3>(99),
                restitutions.at(i % 5),
                i % 9 == 0 ? 0.0 : draw.part(0, 2000, 1000),
                "any"};
    if (i % 3 == 2) {
      one.second = draw_striking(draw, false);
      one.about = "any two";
    }
    all.push_back(one);
  }
  return all;
}

void add_inputs(std::vector<Input>& inputs, const std::string& prefix, const Striking& of) {
  inputs.push_back(input(prefix + "mass", of.mass));
  inputs.push_back(input(prefix + "axial", of.axial));
  inputs.push_back(input(prefix + "transverse", of.transverse));
  inputs.push_back(input(prefix + "attitude", of.attitude));
  inputs.push_back(input(prefix + "velocity", of.velocity));
  inputs.push_back(input(prefix + "spin", of.spin));
  inputs.push_back(input(prefix + "arm", of.arm));
}

}  // namespace

Section impact_section() {
  Section section{
      .name = "impact",
      .about =
          "Impacts by the law of Chatterjee and Ruina (1998) with tangential restitution 0; without friction that is "
          "every law's: the approach is turned into e times itself",
      .inputs = {{"mass", "kg", ""},
                 {"axial", "kg m^2", "moment about the symmetry axis, the body's z"},
                 {"transverse", "kg m^2", "moment across it"},
                 {"attitude", "", "w, x, y, z of a quaternion of any length: normalise it; body to world"},
                 {"velocity", "m/s", "of the centre of mass before, in the world"},
                 {"spin", "rad/s", "angular velocity before, in the body's axes"},
                 {"arm", "m", "from the centre of mass to the contact, in the world"}},
      .quantities = {{.name = "outcome",
                      .unit = "",
                      .proof = Proof::word,
                      .about = "separating: no impulse; stuck: friction stayed below its limit; slid: it reached it"},
                     {.name = "impulse", .unit = "N s", .components = 3, .about = "on the body, in the world"},
                     {.name = "velocity", .unit = "m/s", .components = 3, .about = "of the centre of mass after"},
                     {.name = "spin", .unit = "rad/s", .components = 3, .about = "after, in the body's axes"},
                     {.name = "other_velocity", .unit = "m/s", .components = 3, .about = "of the second body"},
                     {.name = "other_spin", .unit = "rad/s", .components = 3, .about = "of the second body"}},
      .problems = {}};
  const std::vector<InputKind> first = section.inputs;
  for (const InputKind& kind : first) {
    section.inputs.push_back(
        {"other_" + kind.name, kind.unit, "the same of a second body; where there is none, what is met is fixed"});
  }
  section.inputs.push_back({"normal", "", "of any length: normalise it; out of the second body towards the first"});
  section.inputs.push_back({"restitution", "", "e"});
  section.inputs.push_back({"friction", "", "Coulomb's"});
  for (const Meeting& of : meetings()) {
    std::vector<Input> inputs;
    add_inputs(inputs, "", of.first);
    if (of.second) {
      add_inputs(inputs, "other_", *of.second);
    }
    inputs.push_back(input("normal", of.normal));
    inputs.push_back(input("restitution", of.restitution));
    inputs.push_back(input("friction", of.friction));
    section.problems.push_back(make_problem(numbered("impact", section.problems.size() + 1), of.about,
                                            std::move(inputs),
                                            [of]<class T>(std::type_identity<T>) { return impact_answers<T>(of); }));
  }
  return section;
}

}  // namespace goishi::verify::reference
