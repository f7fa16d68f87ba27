/// drop.json: the first links of a drop: flight, first touch, impulse, how the stone leaves.

#include <cmath>
#include <stdexcept>

#include "compiled/drop.hpp"
#include "verify/reference/bracket.hpp"
#include "verify/reference/draw.hpp"
#include "verify/reference/sections.hpp"

namespace goishi::verify::reference {

namespace {

struct Dropped {
  Mover stone;
  double density, restitution, friction;
  std::array<double, 3> gravity;
  std::string about;

  /// Over the plane z = 0.
  [[nodiscard]] Encounter encounter() const {
    Encounter one;
    one.first = stone;
    one.gravity = gravity;
    one.about = about;
    return one;
  }
};

/// The stone touched the plane: where, how, and what followed.
template <class T>
struct FirstLinks {
  T time;
  State<T> touching, leaving;
  Vec3<T> contact_W, impulse_W;
  std::string_view outcome;
};

template <class T>
MassProperties<T> weighed(const Dropped& of, const Stone<T>& stone) {
  return mass_properties(stone, Density<T>{T(of.density)});
}

/// The library's drop, to its first impact.
FirstLinks<double> computed_links(const Dropped& of) {
  const Stone<double> stone = stone_of<double>(of.stone.shape);
  const RigidBody<double> body = make_rigid_body(weighed(of, stone));
  DropSettings<double> settings;
  settings.restitution = of.restitution;
  settings.friction = of.friction;
  settings.gravity = vector_of<double>(of.gravity);
  settings.maximum_impacts = 1;
  const DropResult<double> fall = drop(stone, body, state_of(of.stone, body), settings);
  for (const Event<double>& event : fall.events) {
    if (event.kind == EventKind::impact || event.kind == EventKind::contact) {
      return {event.time, event.before, event.after, event.contact_W, event.impulse_W, to_string(event.outcome)};
    }
  }
  throw std::runtime_error("the stone touches nothing");
}

/// The same by the same formulas, link by link, from the enclosed time of the touch on.
FirstLinks<OrderedBall> enclosed_links(const Dropped& of) {
  using Enclosed = OrderedBall;
  const std::optional<Enclosed> time = enclosed_touch(of.encounter());
  if (!time) {
    throw std::runtime_error("the stone touches nothing");
  }
  const Stone<Enclosed> stone = stone_of<Enclosed>(of.stone.shape);
  const MassProperties<Enclosed> properties = weighed(of, stone);
  const RigidBody<Enclosed> body = body_of(properties);
  const State<Enclosed> touching = formula::free_flight(state_of(of.stone, body), formula::mobility(properties.moments),
                                                        vector_of<Enclosed>(of.gravity), *time);
  const Vec3<Enclosed> axis = formula::symmetry_axis(touching.q_WB), up(Enclosed(0), Enclosed(0), Enclosed(1));
  const Separation<Enclosed> contact =
      detail::separation_along(detail::Placed<Enclosed>{stone, touching.p_WB, axis}, up, Enclosed(0));
  const ImpactBody<Enclosed> striking{.mobility = formula::mobility(body.mass, properties.moments),
                                      .p_WB = touching.p_WB,
                                      .u_W = axis,
                                      .v_WB = touching.v_WB,
                                      .L_W = touching.L_W};
  // As `resolve`, but that the axis's length is known to fewer digits than it asks for: to those of the time.
  const Vec3<Enclosed> r = formula::minus(contact.p_stone, striking.p_WB);
  const Impulse<Enclosed> impulse = detail::impulse_of(
      ImpactLaw::chatterjee_ruina, Material<Enclosed>{Enclosed(of.restitution), Enclosed(of.friction)}, up,
      formula::point_velocity(striking, r),
      [&](const Vec3<Enclosed>& p) { return formula::response(striking.mobility, axis, r, p); },
      [&] { return formula::contact_matrix(striking.mobility, axis, r); });
  const BodyVelocity<Enclosed> after = formula::pushed(striking, r, impulse.impulse_W);
  State<Enclosed> leaving = touching;
  leaving.v_WB = after.v_WB;
  leaving.L_W = after.L_W;
  return {*time, touching, leaving, contact.p_stone, impulse.impulse_W, to_string(impulse.outcome)};
}

/// Lengths, times and speeds in which a drop's numbers are added and taken off.
struct Scales {
  double time, size, turned, impulse, speed, spin;
};

Scales scales_of(const Dropped& of) {
  const FirstLinks<double> links = computed_links(of);
  const RigidBody<double> body = body_of(weighed(of, stone_of<double>(of.stone.shape)));
  const double t = links.time, w = of.stone.shape.width, spin = length_of(of.stone.spin);
  const double fastest = length_of(of.stone.velocity) + length_of(of.gravity) * t;
  const double closing = std::fabs(World<double>(of.encounter()).gap_along({0.0, 0.0, 1.0})(t).rate);
  const double way = w + length_of(of.stone.position) + fastest * t;
  const double time = std::fmax(t, way / closing);
  // The time's own round-off moves and turns what flies; what is turned meets the plane elsewhere.
  const double turned = 1.0 + spin * time, speed = (fastest + spin * w) * turned;
  const double after = formula::angular_velocity_B(links.leaving, body).norm();
  return {.time = time,
          .size = way + fastest * time,
          .turned = turned,
          .impulse = body.mass * speed,
          .speed = speed,
          .spin = (spin + after) * turned + speed / w};
}

template <class T>
Answers<T> drop_answers(const Dropped& of, const FirstLinks<T>& links, const Scales& scales) {
  const RigidBody<T> body = body_of(weighed(of, stone_of<T>(of.stone.shape)));
  return {answer("time", links.time, scale_of(scales.time)),
          answer("point", links.contact_W, scale_of(scales.size + of.stone.shape.width * scales.turned)),
          answer("position", links.touching.p_WB, scale_of(scales.size)),
          answer("attitude", links.touching.q_WB, scale_of(scales.turned)),
          word<T>("outcome", links.outcome),
          answer("impulse", links.impulse_W, scale_of(scales.impulse)),
          answer("velocity", links.leaving.v_WB, scale_of(scales.speed)),
          answer("spin", formula::angular_velocity_B(links.leaving, body), scale_of(scales.spin))};
}

std::vector<Dropped> drops() {
  constexpr std::array<double, 3> earth = {0.0, 0.0, -9.80665};
  std::vector<Shape> shapes = some_shapes();
  std::erase_if(shapes, [](const Shape& shape) { return shape.width > 0.1; });
  std::vector<Dropped> all;
  Draw draw(13);
  for (const Shape& shape : shapes) {
    const auto add = [&](Mover mover, double e, double mu, const std::string& about) {
      mover.shape = shape;
      all.push_back({mover, 2800.0, e, mu, earth, shape.about + about});
    };
    const std::array<double, 3> above = {0.0, 0.0, 0.05};
    add({.shape = shape, .position = above}, 0.5, 0.25, ", flat");
    add({.shape = shape, .position = above, .attitude = {0.0, 1.0, 0.0, 0.0}}, 0.0, 0.25, ", upside down, e = 0");
    add({.shape = shape, .position = above, .attitude = {1.0, 1.0, 1.0, 1.0}}, 0.5, 0.25, ", on edge");
    add({.shape = shape, .position = above, .attitude = {4.0, 1.0, 0.0, 0.0}}, 0.5, 0.0, ", tilted, no friction");
    add({.shape = shape, .position = above, .attitude = {4.0, 1.0, 0.0, 0.0}}, 1.0, 0.25, ", tilted, e = 1");
    for (int i = 0; i < 6; ++i) {
      add({.shape = shape,
           .position = {draw.part(-100, 100, 1000), draw.part(-100, 100, 1000), draw.part(30, 150, 1000)},
           .attitude = draw.wholes<4>(9),
           .velocity = {draw.part(-10, 10, 10), draw.part(-10, 10, 10), draw.part(-10, 10, 10)},
           .spin = draw.wholes<3>(i < 3 ? 10 : 60)},
          draw.part(0, 10, 10), draw.part(0, 10, 10), "");
    }
  }
  return all;
}

}  // namespace

Section drop_section() {
  Section section{
      .name = "drop",
      .about =
          "A stone that falls on the plane z = 0: when and where it first touches, and how it leaves, by the law of "
          "impact.json",
      .inputs = shape_inputs(),
      .quantities =
          {{.name = "time", .unit = "s", .proof = Proof::root, .about = "of the first touch"},
           {.name = "point", .unit = "m", .components = 3, .proof = Proof::root, .about = "that touches then"},
           {.name = "position", .unit = "m", .components = 3, .proof = Proof::root, .about = "of the centre then"},
           {.name = "attitude",
            .unit = "",
            .components = 4,
            .proof = Proof::root,
            .about = "then: unit; w, x, y, z",
            .either_sign = true},
           {.name = "outcome", .unit = "", .proof = Proof::word, .about = "stuck or slid, as in impact.json"},
           {.name = "impulse", .unit = "N s", .components = 3, .proof = Proof::root, .about = "on the stone"},
           {.name = "velocity",
            .unit = "m/s",
            .components = 3,
            .proof = Proof::root,
            .about = "of the centre after it"},
           {.name = "spin",
            .unit = "rad/s",
            .components = 3,
            .proof = Proof::root,
            .about = "after it, in the body's axes"}},
      .problems = {}};
  section.inputs.push_back({"density", "kg/m^3", "uniform"});
  section.inputs.push_back({"position", "m", "of the centre at the start"});
  section.inputs.push_back({"attitude", "", "w, x, y, z of a quaternion of any length: normalise it; body to world"});
  section.inputs.push_back({"velocity", "m/s", "of the centre at the start"});
  section.inputs.push_back({"spin", "rad/s", "angular velocity at the start, in the body's axes"});
  section.inputs.push_back({"gravity", "m/s^2", ""});
  section.inputs.push_back({"restitution", "", "e"});
  section.inputs.push_back({"friction", "", "Coulomb's"});
  for (const Dropped& of : drops()) {
    std::vector<Input> inputs = inputs_of(of.stone.shape);
    inputs.push_back(input("density", of.density));
    inputs.push_back(input("position", of.stone.position));
    inputs.push_back(input("attitude", of.stone.attitude));
    inputs.push_back(input("velocity", of.stone.velocity));
    inputs.push_back(input("spin", of.stone.spin));
    inputs.push_back(input("gravity", of.gravity));
    inputs.push_back(input("restitution", of.restitution));
    inputs.push_back(input("friction", of.friction));
    section.problems.push_back(
        {.id = numbered("drop", section.problems.size() + 1),
         .about = of.about,
         .inputs = std::move(inputs),
         .enclose =
             [of] {
               return common(every_outcome([&] { return drop_answers(of, enclosed_links(of), scales_of(of)); }));
             },
         .compute = [of] { return drop_answers(of, computed_links(of), scales_of(of)); }});
  }
  return section;
}

}  // namespace goishi::verify::reference
