#pragma once
/// \file
/// The impulses of a cluster's step: fast approaches by the impact law, and what gravity and all contacts together give.

#include <goishi/impact/laws.hpp>
#include <goishi/scene/world/cluster_contacts.hpp>
#include <optional>

namespace goishi::detail {

template <Ordered T>
class ClusterImpulses {
 protected:
  [[nodiscard]] static bool is_closed(const World<T>& world, const RowSource<T>& source) {
    return source.gap <= T(2) * *world.settings.clearance;
  }

  /// A velocity that leaves a contact open.
  [[nodiscard]] static T far_off(const World<T>& world) { return T(1e3) * *world.settings.impact_speed; }

  /// Fast approaches of what touches, the fastest first, by the impact law: two bodies at a time.
  void meet_fast(World<T>& world) {
    Sweeps<T>& sweeps = contacts_.sweeps;
    const std::size_t most = 8 * sweeps.rows.size() + 8;
    for (std::size_t round = 0; round < most; ++round) {
      std::size_t fastest = no_index;
      T speed = *world.settings.impact_speed;
      for (std::size_t k = 0; k < sweeps.rows.size(); ++k) {
        const RowSource<T>& source = contacts_.sources[k];
        const bool recent =
            source.memory->last_impact < world.now && world.now < source.memory->last_impact + *world.settings.step;
        const T approach =
            formula::dot(sweeps.rows[k].n, formula::minus(source.other_v, sweeps.velocity(sweeps.rows[k])));
        if (speed < approach && is_closed(world, source) && !recent) {
          speed = approach;
          fastest = k;
        }
      }
      if (fastest == no_index) {
        return;
      }
      collide(world, fastest);
    }
  }

  void collide(World<T>& world, std::size_t k) {
    const Row<T>& row = contacts_.sweeps.rows[k];
    const RowSource<T>& source = contacts_.sources[k];
    Member<T>& first = world.members[source.first];
    Member<T>* second = source.second == no_index ? nullptr : &world.members[source.second];
    const Material<T> material{source.restitution, row.friction};
    const auto see_body = [&](const Member<T>& member, const Mover<T>& mover) {
      return ImpactBody<T>{member.mobility, member.state.p_WB, mover.u, member.state.v_WB, member.state.L_W};
    };
    Mover<T>& a = contacts_.sweeps.movers[row.a];
    const State<T> before = first.state;
    const ImpactBody<T> one = see_body(first, a);
    const ImpactBody<T> two = row.b != no_index ? see_body(*second, contacts_.sweeps.movers[row.b])
                                                : ImpactBody<T>{fixed_mobility<T>(), source.contact.p_other, a.u,
                                                                source.other_v, Vec3<T>::Zero()};
    const TwoBodyImpact<T> impact = resolve(world.settings.drop.law, material, source.contact.p_stone, row.n, one, two);
    source.memory->last_impact = world.now;
    const auto give = [&](std::size_t i, std::size_t other, Mover<T>& mover, const BodyVelocity<T>& after,
                          const State<T>& was, const T& sign) {
      Member<T>& member = world.members[i];
      member.state.v_WB = mover.v = mover.free_v = after.v_WB;
      member.state.L_W = after.L_W;
      mover.w = mover.free_w = formula::turning(member.mobility, mover.u, after.L_W);
      world.tell(i, other, EventKind::impact, was, member.state, [&](Event<T>& event) {
        event.impulse_W = formula::scaled(sign, impact.impulse.impulse_W);
        event.contact_W = source.contact.p_stone;
        event.normal_W = formula::scaled(sign, row.n);
        event.outcome = impact.impulse.outcome;
      });
    };
    give(source.first, source.second, a, impact.first, before, T(1));
    if (row.b != no_index) {
      const State<T> was = second->state;
      give(source.second, source.first, contacts_.sweeps.movers[row.b], impact.second, was, T(-1));
    } else if (second != nullptr) {
      second->work = second->work + formula::dot(impact.impulse.impulse_W, source.other_v);
    }
    if (second != nullptr) {
      ++world.counters.pair_impacts;
      first.last_touch = world.now;
      second->last_touch = world.now;
    }
  }

  /// Every stone's velocity after gravity has acted for a time, its own `since` if none is given.
  void begin(World<T>& world, std::size_t c, const std::optional<T>& weight) {
    const std::vector<std::size_t>& stones = world.clusters[c].members;
    for (std::size_t k = 0; k < stones.size(); ++k) {
      const Member<T>& member = world.members[stones[k]];
      Mover<T>& mover = contacts_.sweeps.movers[k];
      const T time = weight ? *weight : T(world.now + h_ / T(2) - member.nominal);
      mover.free_v = formula::plus(member.state.v_WB, time, world.settings.drop.gravity);
      mover.free_w = formula::turning(member.mobility, mover.u, member.state.L_W);
    }
  }

  bool solve(World<T>& world, const T& share, int sweeps) {
    return contacts_.sweeps.solve(T(share * h_ * world.g), sweeps, world.counters);
  }

  /// The stones' velocities from the rows' impulses.
  void take(World<T>& world, std::size_t c) {
    const std::vector<std::size_t>& stones = world.clusters[c].members;
    Sweeps<T>& sweeps = contacts_.sweeps;
    for (std::size_t k = 0; k < stones.size(); ++k) {
      world.members[stones[k]].state.v_WB = sweeps.movers[k].v;
    }
    for (const Row<T>& row : sweeps.rows) {
      const Vec3<T> P = row.in_world(row.p);
      Vec3<T>& L = world.members[stones[row.a]].state.L_W;
      L = formula::plus(L, formula::plus(formula::cross(row.ra, P), row.torque));
      if (row.b != no_index) {
        Vec3<T>& other = world.members[stones[row.b]].state.L_W;
        other = formula::minus(other, formula::plus(formula::cross(row.rb, P), row.torque));
      }
    }
  }

  /// The same, and how fast the velocities change: not at all where they jump, as of a blow.
  void take_with_rates(World<T>& world, std::size_t c) {
    const std::vector<std::size_t>& stones = world.clusters[c].members;
    before_.clear();
    for (const std::size_t i : stones) {
      before_.push_back({world.members[i].state.v_WB, world.members[i].state.L_W});
    }
    take(world, c);
    for (std::size_t k = 0; k < stones.size(); ++k) {
      Member<T>& member = world.members[stones[k]];
      const Mover<T>& mover = contacts_.sweeps.movers[k];
      const T time = world.now + h_ / T(2) - member.nominal;
      if (time < h_ / T(4)) {
        continue;  // the last step's tell more
      }
      const Vec3<T> dv = formula::minus(member.state.v_WB, before_[k].v_WB),
                    dL = formula::minus(member.state.L_W, before_[k].L_W),
                    dw = formula::turning(mover.mobility, mover.u, dL);
      const T most = scalar::sq(T(T(4) * world.g * time));
      const bool jumps = most < formula::dot(dv, dv) || most < scalar::sq(member.reach) * formula::dot(dw, dw);
      const T over = jumps ? T(0) : T(T(1) / time);
      member.v_rate = formula::scaled(over, dv);
      member.L_rate = formula::scaled(over, dL);
    }
  }

  /// What the next step has to know of the contacts.
  void remember(World<T>& world, const T& weight) {
    for (std::size_t k = 0; k < contacts_.sources.size(); ++k) {
      const Row<T>& row = contacts_.sweeps.rows[k];
      const RowSource<T>& source = contacts_.sources[k];
      ContactMemory<T>& memory = *source.memory;
      memory.time = world.now;
      memory.weight = weight;
      memory.p = source.contact.p_stone;
      memory.n = row.n;
      memory.ra = row.ra;
      memory.rb = row.rb;
      memory.impulse = row.in_world(row.p);
      memory.torque = row.torque;
      if (source.second != no_index && T(0) < row.p.z()) {
        Member<T>&one = world.members[source.first], &two = world.members[source.second];
        one.last_touch = two.last_touch = world.now;
        if (two.keeper == Keeper::hand) {
          two.work = two.work + formula::dot(memory.impulse, source.other_v) + formula::dot(row.torque, row.other_w);
        }
      }
    }
  }

  T h_ = T(0);  // [s] of the step at work
  ClusterContacts<T> contacts_;
  std::vector<BodyVelocity<T>> before_;
};

}  // namespace goishi::detail
