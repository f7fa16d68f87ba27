/// ENCLOSURE: whole functions on balls, each of their choices proved by the balls.

#include <fmt/format.h>

#include <cmath>
#include <goishi/contact/stone_plane.hpp>
#include <goishi/mass/tensor.hpp>
#include <goishi/motion/free_flight.hpp>
#include <goishi/shape/surface.hpp>
#include <set>
#include <string>
#include <vector>

#include "verify/claims/checks.hpp"
#include "verify/claims/claims.hpp"
#include "verify/oracles/numbers/multiprecision.hpp"
#include "verify/oracles/numbers/ordered_ball.hpp"
#include "verify/samples/stone.hpp"

namespace goishi::verify {

namespace {

enum class Kind { sharp, bevelled, measured };

template <class T>
Stone<T> stone_of(const ShapeSample<double>& shape, Kind kind) {
  const T w(shape.width), h(shape.height), b(shape.bevel);
  switch (kind) {
    case Kind::sharp:
      return make_stone(w, h);
    case Kind::bevelled:
      return make_stone(w, h, b);
    case Kind::measured:
      break;
  }
  return make_measured_stone(w, h, b);
}

/// What the functions are asked, in doubles that are taken as exact.
struct Question {
  ShapeSample<double> shape;
  Kind kind;
  Vec3<double> direction;  // any length
  Vec3<double> point;
  Quat<double> attitude;  // any length
  bool needle;            // the flight's body has I_a = I_t / 10
};

/// What they answer: each number, in units of its natural scale, and the choices that were made.
template <class T>
struct Answer {
  std::vector<std::pair<std::string, T>> values;
  std::set<std::string> choices;
};

template <class T>
Vec3<T> as(const Vec3<double>& x) {
  return {T(x.x()), T(x.y()), T(x.z())};
}

template <class T>
class Asker {
 public:
  explicit Asker(const Question& question)
      : question_(question), stone_(stone_of<T>(question.shape, question.kind)), width_(question.shape.width) {}

  Answer<T> ask() {
    mass();
    surface();
    flight();
    return answer_;
  }

 private:
  void add(const std::string& name, const T& value, const T& scale) {
    answer_.values.emplace_back(name, value / scale);
  }
  void add(const std::string& name, const Vec3<T>& value, const T& scale) {
    for (int i = 0; i < 3; ++i) {
      add(name + "xyz"[i], value(i), scale);
    }
  }
  void choose(const std::string& choice) {
    constexpr const char* kinds[] = {"sharp", "bevelled", "measured"};
    answer_.choices.insert(std::string(kinds[static_cast<int>(question_.kind)]) + ", " + choice);
  }
  [[nodiscard]] Quat<T> attitude() const {
    const Quat<double>& q = question_.attitude;
    const T w(q.w()), x(q.x()), y(q.y()), z(q.z());
    const T length = scalar::sqrt(T(w * w + x * x + y * y + z * z));
    return Quat<T>(T(w / length), T(x / length), T(y / length), T(z / length));
  }

  void mass() {
    const MassProperties<T> body = mass_properties(stone_, Density<T>{T(2800)});
    const MassProperties<T> given = mass_properties(stone_, Mass<T>{T(5)});
    const Mat3<T> tensor = inertia_tensor(body, attitude(), as<T>(question_.point));
    add("1/width", width_ / stone_.width, T(1));  // a measured stone's may be far above the outer one
    add("outer width", outer_width(stone_), width_);
    add("P_x", stone_.joint_radius, width_);
    add("r₂/h", stone_.bevel_minor_radius, T(question_.shape.height));
    add("d/r", stone_.sphere_offset, stone_.sphere_radius);
    add("cos α", stone_.joint_cosine, T(1));
    add("sin α", stone_.joint_sine, T(1));
    add("V", body.volume, width_ * width_ * stone_.height);
    add("area", body.surface_area, width_ * width_);
    add("density", given.density * given.volume, T(5));
    add("I_a/m", given.moments.axial, T(5) * width_ * width_);
    add("I_t/m", given.moments_per_mass.transverse, width_ * width_);
    const T trace = tensor(0, 0) + tensor(1, 1) + tensor(2, 2);
    for (int i = 0; i < 9; ++i) {
      add(fmt::format("I_{}", i), tensor(i / 3, i % 3), trace);
    }
  }

  void surface() {
    const Vec3<T> given = as<T>(question_.direction);
    const Vec3<T> n = given / scalar::sqrt(T(given.dot(given)));
    const Support<T> farthest = support(stone_, n);
    add("S", farthest.value, width_);
    add("support ", farthest.p_B, width_);
    choose("support: " + std::string(to_string(farthest.feature)));

    const Vec3<T> p = as<T>(question_.point);
    const T reach = T(2) * width_ + scalar::sqrt(T(p.dot(p)));
    const SurfacePoint<T> nearest = closest_point(stone_, p);
    add("distance", nearest.distance, reach);
    add("closest ", nearest.p_B, reach);
    // From the core to the point: well conditioned, as the normal alone is not next to a centre of curvature.
    const T from_core = nearest.distance + stone_.bevel_minor_radius;
    add("normal ", Vec3<T>(from_core * nearest.normal_B), reach);
    choose("closest point: " + std::string(to_string(nearest.feature)));

    const Pose<T> pose{.p_WB = p, .q_WB = attitude()};
    const Separation<T> touch = separation(stone_, pose, Plane<T>{.n_W = n, .offset = T(0)});
    add("gap", touch.gap, reach);
    add("surface gap", surface_gap(stone_, pose), reach);
    choose("gap: " + std::string(to_string(touch.feature)));
  }

  void flight() {
    const Moments<T> moments{.axial = question_.needle ? T(1) : T(5), .transverse = question_.needle ? T(10) : T(3)};
    const State<T> start{.p_WB = as<T>(question_.point),
                         .q_WB = attitude(),
                         .v_WB = as<T>(question_.direction),
                         .L_W = T(30) * as<T>(question_.direction)};
    const State<T> end = free_flight(start, moments, Vec3<T>(T(0), T(0), T(-10)), T(question_.shape.width));
    add("flown ", end.p_WB, T(10));
    const T phase(1.0 + 30.0 * question_.direction.norm() * question_.shape.width);  // no less than |L| t / I_a
    add("attitude ", Vec3<T>(end.q_WB.x(), end.q_WB.y(), end.q_WB.z()), phase);
    add("attitude w", end.q_WB.w(), phase);
    choose(question_.needle ? "flight: needle" : "flight: stone");
  }

  Question question_;
  Stone<T> stone_;
  T width_;
  Answer<T> answer_;
};

/// Above, below and beside each kind of an ordinary stone: every choice there is.
std::vector<Question> plain_questions() {
  std::vector<Question> questions;
  for (const Kind kind : {Kind::sharp, Kind::bevelled, Kind::measured}) {
    for (const Vec3<double>& way :
         {Vec3<double>(0.1, 0.05, 1.0), Vec3<double>(0.1, 0.05, -1.0), Vec3<double>(1.0, 0.2, 0.05)}) {
      questions.push_back({.shape = {.width = 0.022, .height = 0.0088, .bevel = 0.001},
                           .kind = kind,
                           .direction = way,
                           .point = 0.03 * way,
                           .attitude = {1.0, 0.01, 0.02, 0.5},
                           .needle = 0.0 < way.z()});
    }
  }
  return questions;
}

Question draw_question(std::mt19937_64& random, int i) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Question question{.shape = draw_shape<double>(random, i),
                    .kind = static_cast<Kind>(i % 3),
                    .direction = {normal(random), normal(random), normal(random)},
                    .point = {normal(random), normal(random), normal(random)},
                    .attitude = draw_attitude(random),
                    .needle = i % 2 == 0};
  const double aspect = question.shape.height / question.shape.width;
  switch (i / 3 % 4) {
    case 0:  // nearly flat: the caps of thin stones
      question.direction.head<2>() *= aspect * unit(random);
      question.point = {unit(random) / 4.0, unit(random) / 4.0, normal(random) * question.shape.height};
      break;
    case 1:  // the middle plane, the axis
      question.point.z() = 0.0;
      question.direction.head<2>() *= i % 2 == 0 ? 0.0 : 1.0;
      break;
    case 2:
      question.point.head<2>() *= 0.0;
      question.direction.z() = 0.0;
      break;
    default:
      break;
  }
  return question;
}

/// A ball flight_ball a number of 50 digits: ± 1e-40 (1 + |x|) for its own roundings, x in units of its scale. Flights of
/// some hundred radians, and distances from far points, lose ten.
Ball flight_ball(const Digits50& value) {
  Ball ball = Ball::from_decimal(value.str(55, std::ios_base::scientific));
  const Ball error = Ball::from_decimal("1e-40");
  Ball magnitude;
  arb_abs(magnitude.get(), ball.get());
  arb_add_error(ball.get(), (error * (Ball(1) + magnitude)).get());
  return ball;
}

constexpr int kinds = 3;

Measurement measure_flight_containment(Context& context) {
  Checks checks;
  std::set<std::string> choices;
  std::vector<Question> questions = plain_questions();
  for (int i = 0; i < context.samples(120, 250); ++i) {
    questions.push_back(draw_question(context.random(), i));
  }
  for (const Question& question : questions) {
    const auto outcomes = every_outcome([&] { return Asker<OrderedBall>(question).ask(); });
    see_choice(checks["choices"], outcomes.size() == 1, [&] { return "not proved, " + describe(question.shape); });
    const auto numbers = Asker<Digits50>(question).ask();
    const auto& balls = outcomes.front();
    for (std::size_t k = 0; k < numbers.values.size(); ++k) {
      const Ball& enclosure = balls.values[k].second.ball();
      const bool met =
          enclosure.is_finite() && flight_ball(context.produced(numbers.values[k].second)).overlaps(enclosure);
      see_choice(checks["enclosures"], met, [&] { return numbers.values[k].first + ", " + describe(question.shape); });
    }
    see_choice(checks["choices"], balls.choices == numbers.choices,
               [&] { return "others in 50 digits, " + describe(question.shape); });
    choices.insert(balls.choices.begin(), balls.choices.end());
  }
  // Three features in each of support, closest point and gap; two flights.
  const auto missing = static_cast<double>(kinds * 11) - static_cast<double>(choices.size());
  checks["choices"].see(missing, [] { return "never made"; });
  return checks.measurement({{"choices made", fmt::format("{}", choices.size())}});
}

Measurement measure_flight_width(Context& context) {
  Worst worst;
  for (int i = 0; i < context.samples(120, 250); ++i) {
    const Question question = draw_question(context.random(), i);
    for (const auto& [name, value] : Asker<OrderedBall>(question).ask().values) {
      Ball radius;
      arb_get_rad_arb(radius.get(), value.ball().get());
      worst.see(value.ball().is_finite() ? static_cast<double>(radius) : NAN,
                [&, &name = name] { return name + ", " + describe(question.shape); });
    }
  }
  return worst.measurement();
}

}  // namespace

std::vector<Claim> enclosure_branch_claims() {
  return {
      {.id = "ENCLOSURE-3",
       .statement =
           "Whole functions on balls (stones sharp, bevelled and measured; mass, tensor; support, closest point, gap; "
           "free flight) meet themselves in 50 digits, each of their choices proved by the balls and each made.",
       .function = "make_stone, mass_properties, inertia_tensor, support, closest_point, separation, free_flight",
       .family = OracleFamily::rounding,
       .oracle = "Boost.Multiprecision, 50 digits, ± 1e-40 (1 + |x|) for its own roundings",
       .checks = {within("enclosures", 0.0, "enclosures missed",
                         "an enclosure meets the 50-digit value or it does not"),
                  none("choices", "choices not proved, not the same in 50 digits, or never made")},
       .measure = measure_flight_containment},
      {.id = "ENCLOSURE-4",
       .statement = "These enclosures are narrow, over the whole domain.",
       .function = "the same, on balls",
       .family = OracleFamily::rounding,
       .oracle = "the balls' own radii",
       .checks = {{.unit = "of the value's scale",
                   .bound = 1e-74,
                   .reason = "2⁻²⁵⁶ = 9e-78 a step",
                   .resolution = 1e-77,
                   .counts = true}},
       .measure = measure_flight_width},
  };
}

}  // namespace goishi::verify
