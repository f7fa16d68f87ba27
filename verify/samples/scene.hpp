#pragma once
/// \file
/// Scenes for the claims: stones, heaps that are about to fall, and what a state is, in long double by definitions that
/// share no formula with src/.

#include <goishi/mass/inertia.hpp>
#include <vector>

#include "compiled/scene.hpp"
#include "verify/samples/contact.hpp"
#include "verify/samples/drop.hpp"
#include "verify/suite/scalars.hpp"

namespace goishi::verify {

/// A stone and its body.
struct Piece {
  Specimen specimen;
  RigidBody<double> body;

  explicit Piece(Specimen of) : specimen(of), body(make_rigid_body(mass_properties(of.stone, Density{2800.0}))) {}
  [[nodiscard]] const Stone<double>& stone() const { return specimen.stone; }
};

/// Size 33 with a bevel of 1 mm, sharp, round, or any up to twice as wide.
[[nodiscard]] inline Piece draw_piece(Context& context, int i) {
  constexpr int kinds[] = {0, 1, 0, 3, 5};
  return Piece(draw_stone(context, kinds[i % 5]));
}

/// In any attitude.
[[nodiscard]] inline State<double> thrown(Context& context, const Piece& piece, const Vec3<double>& p, double speed,
                                          double spin) {
  const Quat<double> q = draw_attitude(context.random());
  const Vec3<double> w_B = context.uniform(0.0, spin) * draw_unit(context);
  return {.p_WB = p,
          .q_WB = q,
          .v_WB = context.uniform(0.0, speed) * draw_unit(context),
          .L_W = formula::angular_momentum_W(q, piece.body, w_B)};
}

/// At rest.
[[nodiscard]] inline State<double> set_down(const Vec3<double>& p, const Quat<double>& q = {1.0, 0.0, 0.0, 0.0}) {
  return {.p_WB = p, .q_WB = q, .v_WB = {0.0, 0.0, 0.0}, .L_W = {0.0, 0.0, 0.0}};
}

/// At the tolerance of a game.
[[nodiscard]] inline SceneSettings<double> game_settings() {
  SceneSettings<double> settings;
  settings.drop.tolerance = 1e-4;
  return settings;
}

/// With no gravity there is no time to take steps from.
[[nodiscard]] inline SceneSettings<double> weightless_settings() {
  SceneSettings<double> settings = game_settings();
  settings.drop.gravity = {0.0, 0.0, 0.0};
  settings.step = 1.0 / 480.0;
  settings.impact_speed = 5e-3;
  settings.leaving_time = 1e-2;
  return settings;
}

/// Puts stones over the middle of a scene's board, three by three in layers, where each has room to turn, thrown in any way.
inline void pour(Context& context, Scene<double>& scene, int count) {
  const double room = 0.0447;  // of twice the width of the widest and a little
  for (int i = 0; i < count; ++i) {
    const Piece piece = draw_piece(context, i);
    const double wide = piece.stone().width < 0.0224 ? 0.0226 : room;
    const Vec3<double> p(wide * (i % 3 - 1), wide * (i / 3 % 3 - 1), 0.03 + room * (i / 9));
    try {
      static_cast<void>(scene.add(piece.stone(), piece.body, thrown(context, piece, p, 0.2, 10.0)));
    } catch (const InvalidArgument&) {
      // A wide one beside it is in the way.
    }
  }
}

/// Size 33, sharp and not, two by two in layers, thrown so that they fall on each other.
inline void pile(Context& context, Scene<double>& scene, int count) {
  const double room = 0.0226;
  for (int i = 0; i < count; ++i) {
    const Piece piece(draw_stone(context, i % 2));
    const Vec3<double> p(room * (i % 2), room * (i / 2 % 2), 0.013 + room * (i / 4));
    static_cast<void>(scene.add(piece.stone(), piece.body, thrown(context, piece, p, 0.05, 5.0)));
  }
}

/// Stones of size 33 over the crossings of a board, some millimetres apart from it and askew, as if put down all at once.
inline void strew(Context& context, Scene<double>& scene, int across) {
  const Board<double>& board = scene.board();
  for (int i = 0; i < across * across; ++i) {
    const Piece piece(draw_stone(context, 1));
    const Vec3<double> p(board.spacing_x * (i % across - across / 2) + context.uniform(-2e-3, 2e-3),
                         board.spacing_y * (i / across - across / 2) + context.uniform(-2e-3, 2e-3),
                         context.uniform(0.012, 0.03));
    State<double> start = thrown(context, piece, p, 0.1, 5.0);
    const Vec3<double> lean = 0.3 * draw_unit(context);
    start.q_WB = Quat<double>(1.0, lean.x(), lean.y(), 0.0).normalized();
    try {
      static_cast<void>(scene.add(piece.stone(), piece.body, start));
    } catch (const InvalidArgument&) {
      // It would overlap a neighbour.
    }
  }
}

/// Energy and momenta of a stone.
struct Carried {
  Long energy;  // potential zero at the origin
  Long3 p, L;   // about the origin
};

[[nodiscard]] inline Carried carried_by(const State<double>& state, const RigidBody<double>& body,
                                        const Vec3<double>& gravity) {
  const Long m = body.mass;
  const Long3 v = state.v_WB.cast<Long>(), x = state.p_WB.cast<Long>(), L = state.L_W.cast<Long>();
  const Long3 u = state.q_WB.cast<Long>().normalized() * Long3(0, 0, 1);
  const Long along = L.dot(u), across = L.squaredNorm() - along * along;
  return {.energy =
              m * (v.squaredNorm() / 2 - gravity.cast<Long>().dot(x)) +
              (along * along / static_cast<Long>(body.moments.z()) + across / static_cast<Long>(body.moments.x())) / 2,
          .p = m * v,
          .L = m * x.cross(v) + L};
}

/// ω in W.
[[nodiscard]] inline Long3 turning_of(const State<double>& state, const RigidBody<double>& body) {
  const Long3 u = state.q_WB.cast<Long>().normalized() * Long3(0, 0, 1), L = state.L_W.cast<Long>();
  const Long along = L.dot(u);
  return (L - along * u) / static_cast<Long>(body.moments.x()) + along / static_cast<Long>(body.moments.z()) * u;
}

/// Of the point of the stone that is at p.
[[nodiscard]] inline Long3 velocity_at(const State<double>& state, const RigidBody<double>& body,
                                       const Vec3<double>& p) {
  return state.v_WB.cast<Long>() + turning_of(state, body).cross((p - state.p_WB).cast<Long>());
}

/// Of all stones.
[[nodiscard]] inline Carried carried_by(const Scene<double>& scene) {
  Carried sum{0, Long3::Zero(), Long3::Zero()};
  for (const StoneId id : scene.stones()) {
    const Carried one = carried_by(scene.state(id), scene.body(id), scene.settings().drop.gravity);
    sum.energy += one.energy;
    sum.p += one.p;
    sum.L += one.L;
  }
  return sum;
}

/// The least gap of two stones, and of one and the board   [m].
[[nodiscard]] inline double least_gap(const Scene<double>& scene) {
  double least = 1.0;
  const std::vector<StoneId> stones = scene.stones();
  std::vector<Pose<double>> poses;
  for (const StoneId id : stones) {
    const State<double> state = scene.state(id);
    poses.push_back({state.p_WB, state.q_WB});
    const double high = state.p_WB.z() - outer_width(scene.stone(id));
    least = std::fmin(least, high < 0.0 ? separation(scene.stone(id), poses.back(), scene.board()).gap : high);
    for (std::size_t j = 0; j + 1 < poses.size(); ++j) {
      const double far = (poses.back().p_WB - poses[j].p_WB).norm() -
                         (outer_width(scene.stone(id)) + outer_width(scene.stone(stones[j]))) / 2.0;
      least = std::fmin(
          least, far < 0.0 ? separation(scene.stone(id), poses.back(), scene.stone(stones[j]), poses[j]).gap : far);
    }
  }
  return least;
}

[[nodiscard]] inline bool is_same(const State<double>& a, const State<double>& b) {
  return a.p_WB == b.p_WB && a.q_WB.coeffs() == b.q_WB.coeffs() && a.v_WB == b.v_WB && a.L_W == b.L_W;
}

}  // namespace goishi::verify
