/// Flights, of one stone and of many, every scheme, and whole drops.

#include <goishi/drop/drop.hpp>
#include <goishi/motion/elliptic_flight.hpp>
#include <goishi/motion/free_flight.hpp>
#include <goishi/motion/steppers.hpp>

#include "verify/bits/inputs.hpp"
#include "verify/bits/kinds.hpp"
#ifdef __GLIBCXX__
#include <goishi/motion/batch.hpp>
#endif

namespace goishi::verify::bits {

namespace {

template <class T>
void add_flight(Hash& hash, Random& random, int i) {
  const auto body = mass_properties(random.stone<T>(), Density<T>{T(2800)});
  const State<T> state = random.state<T>(body.moments);
  const T t = random.between<T>(-2, 2);
  add(hash, free_flight(state, body.moments, gravity_W<T>(), t));
  const Moments<T> needle{.axial = T(body.moments.transverse / T(100)), .transverse = body.moments.transverse};
  add(hash, free_flight(state, needle, gravity_W<T>(), t));
  const T x = random.between<T>(1, 1.5), y = random.between<T>(1, 1.5), z = random.between<T>(1, 2);
  const RigidBody<T> brick = make_rigid_body(T(0.01), Vec3<T>(formula::scaled(body.moments.axial, Vec3<T>(x, y, z))));
  const State<T> turned = elliptic_flight(state, brick, gravity_W<T>(), t);
  add(hash, turned);
  hash.add(formula::energy(turned, brick, gravity_W<T>()));
  const RigidBody<T> rigid = make_rigid_body(body);
  for (const SchemeInfo& scheme : schemes) {
    if (i % 4 == 0) {
      const auto [after, status, steps] =
          Stepper<T>(scheme.scheme, scheme.needs_symmetry ? rigid : brick).advance(state, T(0.01), 3);
      add(hash, after);
    }
  }
}

template <class T>
void add_batch(Hash& hash, Random& random) {
  constexpr int count = 101;
  std::vector<State<T>> states;
  std::vector<Moments<T>> moments;
  for (int i = 0; i < count; ++i) {
    moments.push_back(mass_properties(random.stone<T>(), Density<T>{T(2800)}).moments);
    states.push_back(random.state<T>(moments.back()));
  }
  const T t = random.between<T>(-1, 1);
#ifdef __GLIBCXX__  // in lanes
  StoneBatch<T> batch(count);
  for (std::size_t i = 0; i < count; ++i) {
    batch.set(i, states[i], moments[i]);
  }
  batch.fly(gravity_W<T>(), t);
  for (std::size_t i = 0; i < count; ++i) {
    add(hash, batch.get(i));
  }
#else  // as lanes would
  for (std::size_t i = 0; i < count; ++i) {
    add(hash, formula::free_flight(states[i], make_mobility(moments[i]), gravity_W<T>(), t));
  }
#endif
}

}  // namespace

void hash_flight(Hash& hash) {
  Random random(4);
  for (int i = 0; i < 900; ++i) {
    add_flight<double>(hash, random, i);
    add_flight<float>(hash, random, i);
  }
}

void hash_batch(Hash& hash) {
  Random random(5);
  for (int i = 0; i < 40; ++i) {
    add_batch<double>(hash, random);
    add_batch<float>(hash, random);
  }
}

void hash_drop(Hash& hash) {
  Random random(6);
  const Board<double> board = make_board<double>();
  for (int i = 0; i < 36; ++i) {
    const Stone<double> stone = i % 3 == 0 ? make_stone(0.022, 0.0092) : make_stone(0.022, 0.0092, 0.001);
    const auto body = mass_properties(stone, Density{2800.0});
    State<double> state = random.state<double>(body.moments);
    state.v_WB = formula::scaled(0.1, state.v_WB);
    state.p_WB.z() = random.between(0.02, 0.05);
    DropSettings<double> settings;
    settings.tolerance = i % 2 == 0 ? 1e-6 : 1e-4;
    settings.restitution = random.between(0.1, 0.7);
    settings.friction = random.between(0.1, 0.5);
    settings.law = static_cast<ImpactLaw>(i % 5 == 4 ? 2 : 0);
    settings.friction_model = i % 7 == 6 ? FrictionModel::coulomb_contensou : FrictionModel::dry;
    Drop<double> drop(stone, make_rigid_body(body), state, board, settings);
    drop.keep_motion();
    std::vector<Event<double>> events;
    drop.advance(5.0, events);
    hash.add(static_cast<int>(drop.status()));
    for (const Event<double>& event : events) {
      hash.add(static_cast<int>(event.kind));
      hash.add(event.time);
      hash.add(event.energy);
      add(hash, event.after);
      add(hash, event.impulse_W);
      add(hash, event.contact_W);
    }
    for (int k = 0; k < 200; ++k) {
      add(hash, drop.state_at(drop.time() * k / 200));
    }
  }
}

}  // namespace goishi::verify::bits
