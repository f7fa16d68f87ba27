#pragma once
/// \file
/// The variables of the contact phase, and the way between them and the state of the world.

#include <array>
#include <goishi/contact/stone_board.hpp>
#include <goishi/drop/equations/kinetics.hpp>
#include <goishi/drop/motion/stretch.hpp>
#include <goishi/drop/state/run.hpp>
#include <goishi/vector.hpp>
#include <limits>

namespace goishi::detail {

/// How far a stone in contact is from losing its support: by `gap` [m] its contact point is inside the playing surface; or on the
/// floor the stone is off the board's side, along a normal whose horizontal part is (n_x, n_y).
template <class T>
struct SupportLeft {
  T gap, n_x = T(0), n_y = T(0);
};

template <Ordered T>
struct ContactState : ContactFrame<T> {
  using ContactFrame<T>::feature, ContactFrame<T>::mode, ContactFrame<T>::level, ContactFrame<T>::origin;

  Variables<T> y = {};
  T noise = T(0);  // [m/s] a slip that counts as none

  /// From the run's state.
  void enter(const Run<T>& run, Feature which) {
    feature = which;
    level = run.level;
    const State<T>& state = run.state;
    rebase(state.q_WB);
    const Vec3<T> L = state.L_W / run.body.mass;
    y = {origin.x(), origin.y(), origin.z(), state.p_WB.x(), state.p_WB.y(), T(0),
         T(0),       L.x(),      L.y(),      L.z(),          T(0),           T(0)};
    const ContactPlace<T> now = place_of(run.contact_body, feature, y);
    // Round-off of what the slip is the difference of, and of a contact point that was told by its place.
    const T speed = run.scales.speed + size_of(T(state.v_WB.x()), T(state.v_WB.y()));
    const T turn = scalar::sqrt(formula::dot(now.w, now.w)) * state.p_WB.cwiseAbs().maxCoeff();
    noise = T(4) * std::numeric_limits<T>::epsilon() * (T(1000) * speed + turn);
    set_slip(run.contact_body, T(state.v_WB.x() + now.point.x()), T(state.v_WB.y() + now.point.y()));
  }

  /// Chooses the equations for a slip.
  void set_slip(const ContactBody<T>& body, const T& s_x, const T& s_y) {
    set_mode(body, noise < size_of(s_x, s_y), s_x, s_y);
  }

  /// The same, where it is known whether it slips.
  void set_mode(const ContactBody<T>& body, bool slips, const T& s_x, const T& s_y) {
    if (is_smooth(body)) {
      mode = ContactMode::gliding;
      y[at::slip] = s_x;
      y[at::direction] = s_y;
      return;
    }
    mode = slips ? ContactMode::sliding : ContactMode::rolling;
    y[at::slip] = slips ? size_of(s_x, s_y) : T(0);
    y[at::direction] = slips ? scalar::atan2(s_y, s_x) : T(0);
  }

  [[nodiscard]] static bool is_smooth(const ContactBody<T>& body) {
    return body.model != FrictionModel::dry || !(T(0) < body.friction);
  }

  [[nodiscard]] std::array<T, 2> slip() const { return slip_of(mode, y); }

  /// Carries the attitude from here on.
  void rebase(const Quat<T>& q) {
    this->q_origin = formula::reunited(q);
    origin = formula::symmetry_axis(this->q_origin);
    origin = detail::unit(origin);
  }

  /// Carries it from the present one, once the axis has gone far from where it was. True if so.
  [[nodiscard]] bool rebase_if_far() {
    if (!(origin.x() * y[at::u] + origin.y() * y[at::u + 1] + origin.z() * y[at::u + 2] < T(0.5))) {
      return false;
    }
    rebase(attitude_of<T>(*this, Vec3<T>(y[at::u], y[at::u + 1], y[at::u + 2]), y[at::spin]));
    y[at::spin] = T(0);
    return true;
  }

  /// Takes angles back that have gone round, which would lose digits.
  void unwind() {
    if (mode == ContactMode::sliding) {
      unwind(y[at::direction], T(T(2) * scalar::pi<T>()));
    }
    unwind(y[at::spin], T(T(4) * scalar::pi<T>()));  // the attitude goes by half of it
  }

  /// To the run's state.
  void update(Run<T>& run) const {
    const ContactPlace<T> now = place_of(run.contact_body, feature, y);
    run.state = state_of<T>(*this, y, now, run.body.mass);
    run.contact_W = run.state.p_WB + now.r;
  }

  /// What an event at the present variables tells of the contact.
  void fill(const Run<T>& run, Event<T>& event) const {
    event.contact_W = run.contact_W;
    event.normal_W = {T(0), T(0), T(1)};
    event.feature = feature;
  }

  /// An event at the present variables.
  void note(Run<T>& run, EventKind kind) const {
    if (run.sink) {
      update(run);
    }
    run.record(kind, run.state, [&](Event<T>& event) { fill(run, event); });
  }

  /// What is left of the support where the stone is at (p_x, p_y).
  [[nodiscard]] SupportLeft<T> support_left(const Run<T>& run, const ContactPlace<T>& now, const T& p_x,
                                            const T& p_y) const {
    const Board<T>& board = *run.board;
    if (!(level < T(0))) {
      const T across = board.half_width - scalar::abs<T>(p_x + now.r.x());
      const T along = board.half_length - scalar::abs<T>(p_y + now.r.y());
      return {across < along ? across : along};
    }
    const T across = scalar::abs<T>(p_x) - board.half_width, along = scalar::abs<T>(p_y) - board.half_length;
    const T over = (across < along ? along : across) - run.reach;
    if (T(0) < over) {
      return across < along ? SupportLeft<T>{over, T(0), p_y < T(0) ? T(-1) : T(1)}
                            : SupportLeft<T>{over, p_x < T(0) ? T(-1) : T(1), T(0)};
    }
    const Vec3<T> p(p_x, p_y, T(level + now.height));
    const Separation<T> found =
        separation(Placed<T>{run.stone, p, Vec3<T>(now.u / scalar::sqrt(formula::dot(now.u, now.u)))}, board);
    return {found.gap, found.n_W.x(), found.n_W.y()};
  }

  /// Whether a turning is so fast that it has a direction.
  [[nodiscard]] static bool turns(const Run<T>& run, const Vec3<T>& w) {
    const T share = T(0.01) * run.settings.tolerance;
    return scalar::sq(T((share < T(1e-11) ? T(1e-11) : share) * run.scales.frequency)) < formula::dot(w, w);
  }

  [[nodiscard]] static T size_of(const T& x, const T& y) { return scalar::sqrt(T(scalar::sq(x) + scalar::sq(y))); }

 private:
  static void unwind(T& angle, const T& turn) {
    if (turn < angle || angle < -turn) {
      const T turns = angle / turn;
      using std::trunc;
      angle = angle - T(trunc(turns)) * turn;
    }
  }
};

/// Takes |u| back to 1.
template <Ordered T>
void reunite(Variables<T>& y) {
  const T size = scalar::sqrt(T(scalar::sq(y[at::u]) + scalar::sq(y[at::u + 1]) + scalar::sq(y[at::u + 2])));
  for (std::size_t i = at::u; i < at::u + 3; ++i) {
    y[i] = y[i] / size;
  }
}

/// What a contact does next, up to a time at which it is looked at again.
template <class T>
struct Ahead {
  T length = T(0);       // [s]
  Variables<T> to = {};  // the variables then
  bool known = false;    // whether `along` is
  Interpolant<T, variables> along = {};
  std::optional<Ledger<T>> ledger;

  /// Straight there, from y; velocities too.
  void straight(const Variables<T>& y) {
    along = {};
    along.c[0] = y;
    for (std::size_t i = 0; i < variables; ++i) {
      along.c[1][i] = to[i] - y[i];
    }
    known = true;
    ledger.reset();
  }
};

}  // namespace goishi::detail
