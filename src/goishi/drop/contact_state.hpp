#pragma once
/// \file
/// The variables of the contact phase, and the way between them and the state of the world.

#include <array>
#include <goishi/contact/stone_board.hpp>
#include <goishi/drop/kinetics.hpp>
#include <goishi/drop/run.hpp>
#include <limits>

namespace goishi::detail {

/// Which equations hold: no slip, dry slip, slip under a smooth law of friction or none.
enum class ContactMode { rolling, sliding, gliding };

template <Ordered T>
class ContactState {
 public:
  explicit ContactState(Run<T>& the_run) : run(the_run), body(the_run.contact_body), scales(the_run.scales) {}

  /// From the run's state.
  void enter(Feature which) {
    feature = which;
    const State<T>& state = run.state;
    rebase(state.q_WB);
    const Vec3<T> L = state.L_W / run.body.mass;
    y = {origin.x(), origin.y(), origin.z(), state.p_WB.x(), state.p_WB.y(), T(0),
         T(0),       L.x(),      L.y(),      L.z(),          T(0),           T(0)};
    const Kinetics<T> now = kinetics(body, feature, y);
    // Round-off of what the slip is the difference of, and of a contact point that was told by its place.
    const T speed = scales.speed + size_of(T(state.v_WB.x()), T(state.v_WB.y()));
    const T turn = scalar::sqrt(formula::dot(now.w, now.w)) * state.p_WB.cwiseAbs().maxCoeff();
    noise = T(4) * std::numeric_limits<T>::epsilon() * (T(1000) * speed + turn);
    set_slip(T(state.v_WB.x() + now.point.x()), T(state.v_WB.y() + now.point.y()));
  }

  /// Chooses the equations for a slip.
  void set_slip(const T& s_x, const T& s_y) { set_mode(noise < size_of(s_x, s_y), s_x, s_y); }

  /// The same, where it is known whether it slips.
  void set_mode(bool slips, const T& s_x, const T& s_y) {
    if (is_smooth()) {
      mode = ContactMode::gliding;
      y[at::slip] = s_x;
      y[at::direction] = s_y;
      return;
    }
    mode = slips ? ContactMode::sliding : ContactMode::rolling;
    y[at::slip] = slips ? size_of(s_x, s_y) : T(0);
    y[at::direction] = slips ? scalar::atan2(s_y, s_x) : T(0);
  }

  [[nodiscard]] bool is_smooth() const { return body.model != FrictionModel::dry || !(T(0) < body.friction); }

  /// The attitude is the one of the last `rebase`, carried with the axis by the shortest rotation, and turned about the
  /// axis by the spin angle.
  void rebase(const Quat<T>& q) {
    q_origin = formula::reunited(q);
    origin = formula::symmetry_axis(q_origin);
    origin = origin / origin.norm();
  }

  [[nodiscard]] Quat<T> attitude() const {
    const Vec3<T> u = Vec3<T>(y[at::u], y[at::u + 1], y[at::u + 2]).normalized();
    return formula::reunited(formula::carried_attitude(origin, q_origin, u, y[at::spin]));
  }

  /// Takes |u| back to 1, and angles that have gone round, which would lose digits.
  void normalize() {
    const T size = scalar::sqrt(T(scalar::sq(y[at::u]) + scalar::sq(y[at::u + 1]) + scalar::sq(y[at::u + 2])));
    for (std::size_t i = at::u; i < at::u + 3; ++i) {
      y[i] = y[i] / size;
    }
    if (mode == ContactMode::sliding) {
      unwind(y[at::direction], T(T(2) * scalar::pi<T>()));
    }
    unwind(y[at::spin], T(T(4) * scalar::pi<T>()));  // the attitude goes by half of it
  }

  static void unwind(T& angle, const T& turn) {
    if (turn < angle || angle < -turn) {
      const T turns = angle / turn;
      using std::trunc;
      angle = angle - T(trunc(turns)) * turn;
    }
  }

  /// To the run's state.
  void update_state() {
    normalize();
    const Kinetics<T> now = kinetics(body, feature, y);
    const std::array<T, 2> s = slip();
    run.state.p_WB = {y[at::x], y[at::y], T(run.level + now.height)};
    run.state.q_WB = attitude();
    run.state.v_WB = formula::centre_velocity(now, s[0], s[1]);
    run.state.L_W = run.body.mass * now.L;
    run.contact_W = run.state.p_WB + now.r;
  }

  /// An event at the present state.
  Event<T>& note(EventKind kind) {
    update_state();
    Event<T>& event = run.record(kind, run.state);
    event.contact_W = run.contact_W;
    event.normal_W = {T(0), T(0), T(1)};
    event.feature = feature;
    return event;
  }

  /// The slip as a vector along the plane.
  [[nodiscard]] std::array<T, 2> slip() const {
    if (mode == ContactMode::sliding) {
      return {T(y[at::slip] * scalar::cos(y[at::direction])), T(y[at::slip] * scalar::sin(y[at::direction]))};
    }
    return {y[at::slip], y[at::direction]};
  }

  [[nodiscard]] bool carried_far() const {
    return origin.x() * y[at::u] + origin.y() * y[at::u + 1] + origin.z() * y[at::u + 2] < T(0.5);
  }

  /// How far the contact point is inside the playing surface, or the stone from the board's side   [m].
  [[nodiscard]] T support_guard(const Kinetics<T>& now, const Variables<T>& where) const {
    const auto magnitude = [](const T& x) { return x < T(0) ? T(-x) : x; };
    const Board<T>& board = *run.board;
    if (!(run.level < T(0))) {
      const T across = board.half_width - magnitude(where[at::x] + now.r.x());
      const T along = board.half_length - magnitude(where[at::y] + now.r.y());
      return across < along ? across : along;
    }
    const T across = magnitude(where[at::x]) - board.half_width, along = magnitude(where[at::y]) - board.half_length;
    const T over = (across < along ? along : across) - run.reach;
    if (T(0) < over) {
      return over;
    }
    const Vec3<T> p(where[at::x], where[at::y], T(run.level + now.height));
    return separation(Placed<T>{run.stone, p, Vec3<T>(now.u / scalar::sqrt(formula::dot(now.u, now.u)))}, board).gap;
  }

  /// Whether a turning is so fast that it has a direction.
  [[nodiscard]] bool turns(const Vec3<T>& w) const {
    const T share = T(0.01) * run.settings.tolerance;
    return scalar::sq(T((share < T(1e-11) ? T(1e-11) : share) * scales.frequency)) < formula::dot(w, w);
  }

  [[nodiscard]] static T size_of(const T& x, const T& y) { return scalar::sqrt(T(scalar::sq(x) + scalar::sq(y))); }

  Run<T>& run;
  const ContactBody<T>& body;
  ContactScales<T> scales;
  Feature feature = Feature::rim;
  ContactMode mode = ContactMode::rolling;
  T noise = T(0);  // [m/s] a slip that counts as none
  Variables<T> y = {};
  Vec3<T> origin = Vec3<T>::Zero();  // the axis at the last `rebase`
  Quat<T> q_origin;                  // the attitude then
};

}  // namespace goishi::detail
