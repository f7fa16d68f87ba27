#pragma once
/// \file
/// How a scene goes on: from one thing that is due to the next.

#include <goishi/impact/laws.hpp>
#include <goishi/scene/world/cluster_step.hpp>

namespace goishi::detail {

template <Ordered T>
class SceneCourse {
 public:
  World<T> world;

  /// Whatever is due up to a time; to the point where everything rests, if that is wanted. False if the work of a call is used up
  /// before.
  [[nodiscard]] bool run(const T& until, bool to_rest) {
    for (long long work = world.settings.most_work; !(to_rest && rests()); --work) {
      if (work <= 0) {
        return false;
      }
      const std::optional<Due<T>> due = world.agenda.next(until);
      if (!due) {
        world.now = until;
        return true;
      }
      world.now = due->time;
      switch (due->kind) {
        case DueKind::stretch:
          go_on(due->id);
          break;
        case DueKind::look:
          world.look(due->id, world.now);
          break;
        case DueKind::pair:
          if (world.pairs[due->id].touches) {
            touch(due->id);
          } else {
            world.check(due->id);
          }
          break;
        case DueKind::step:
          step(due->id);
          break;
      }
    }
    return true;
  }

  /// Whether nothing moves.
  [[nodiscard]] bool rests() {
    if (counted_ && 0 < awake_) {
      return false;
    }
    awake_ = 0;
    for (const Member<T>& member : world.members) {
      const bool still = member.keeper == Keeper::removed || world.is_asleep(member) ||
                         (member.keeper == Keeper::hand && !(T(0) < member.bounds.surface));
      awake_ += still ? 0 : 1;
    }
    counted_ = true;
    return awake_ == 0;
  }

  // --- who moves a stone

  /// A drop from a state on, or, of one that rests, the drop that it was.
  Drop<T>& take_up(std::size_t i, const State<T>& state) {
    Member<T>& member = world.members[i];
    member.past.time = world.now;
    // It is copied: what it is told is not kept.
    member.drop = world.drops.add(Drop<T>(member.stone, member.body, state, std::optional<Board<T>>(world.board),
                                          world.settings.drop, member.past));
    member.keeper = Keeper::drop;
    begin(i);
    return world.drops[member.drop];
  }

  /// A drop has another motion from now on.
  void begin(std::size_t i) {
    world.members[i].fresh = true;
    counted_ = false;
    world.agenda.set(DueKind::stretch, i, world.now);
  }

  /// Brings a stone's drop to the present.
  Drop<T>& present(std::size_t i) {
    Drop<T>& drop = world.drops[world.members[i].drop];
    drop.advance_to(world.now, sink_of(i, no_index));
    return drop;
  }

  /// A stone becomes a cluster of its own, or wakes that which it sleeps in. Its cluster is to go on from now.
  std::size_t to_cluster(std::size_t i) {
    Member<T>& member = world.members[i];
    counted_ = false;
    if (member.keeper == Keeper::cluster) {
      wake(member.cluster);
      return member.cluster;
    }
    member.state = world.state_at(member, world.now);
    if (member.keeper == Keeper::drop) {
      let_go(i, present(i).past());
    }
    member.keeper = Keeper::cluster;
    member.time = member.nominal = member.last_touch = world.now;
    member.v_rate = member.L_rate = Vec3<T>::Zero();
    member.cluster = world.new_cluster();
    for (ContactMemory<T>& memory : member.ground) {
      memory = {};
    }
    world.clusters[member.cluster].members.assign(1, i);
    world.clusters[member.cluster].end = world.now;
    world.agenda.set(DueKind::step, member.cluster, world.now);
    return member.cluster;
  }

  /// A cluster's step ends now, and it goes on from here.
  void wake(std::size_t c) {
    Cluster<T>& cluster = world.clusters[c];
    if (cluster.asleep) {
      cluster.asleep = false;
      cluster.wait = 0;
      cluster.next_wait = 1;
      counted_ = false;
      for (const std::size_t i : cluster.members) {
        Member<T>& member = world.members[i];
        member.time = member.nominal = member.last_touch = world.now;
        member.v_rate = member.L_rate = Vec3<T>::Zero();
      }
    } else {
      world.counters.cut_steps += world.now < cluster.end ? 1 : 0;
      ClusterStep<T>::bring(world, c);
    }
    cluster.end = world.now;
    world.agenda.set(DueKind::step, c, world.now);
  }

  /// Two clusters become one.
  void merge(std::size_t a, std::size_t b) {
    if (a == b) {
      return;
    }
    const std::size_t into = world.clusters[a].members.size() < world.clusters[b].members.size() ? b : a;
    const std::size_t from = into == a ? b : a;
    for (const std::size_t i : world.clusters[from].members) {
      world.members[i].cluster = into;
      world.clusters[into].members.push_back(i);
    }
    world.drop_cluster(from);
    ++world.counters.joins;
  }

  /// Takes a stone out of what moves it; it keeps its present state.
  void take_out(std::size_t i) {
    Member<T>& member = world.members[i];
    member.state = world.state_at(member, world.now);
    member.time = world.now;
    counted_ = false;
    if (member.keeper == Keeper::drop) {
      let_go(i, present(i).past());
    } else if (member.keeper == Keeper::cluster) {
      const std::size_t c = member.cluster;
      wake(c);
      std::vector<std::size_t>& stones = world.clusters[c].members;
      stones.erase(std::find(stones.begin(), stones.end(), i));
      if (stones.empty()) {
        world.drop_cluster(c);
      }
    }
    member.keeper = Keeper::rest;
  }

  /// Where events of a stone go.
  [[nodiscard]] auto sink_of(std::size_t i, std::size_t other) { return Told{world, i, other}; }

 private:
  /// A drop's events as those of a scene.
  struct Told {
    World<T>& world;
    std::size_t i, other;
    void operator()(const Event<T>& event) const {
      if (world.sink) {
        SceneEvent<T> told{.stone = StoneId(i), .other = {}, .event = event};
        if (other != no_index) {
          told.other = StoneId(other);
        }
        world.sink(told);
      }
    }
  };

  void let_go(std::size_t i, const DropPast<T>& past) {
    Member<T>& member = world.members[i];
    member.past = past;
    world.drops.remove(member.drop);
    member.drop = no_index;
    world.agenda.remove(DueKind::stretch, i);
  }

  // --- what is due

  void go_on(std::size_t i) {
    Member<T>& member = world.members[i];
    if (member.keeper == Keeper::hand) {
      halt(i);
      return;
    }
    Drop<T>& drop = world.drops[member.drop];
    const DropStatus status = drop.advance_to(world.now, sink_of(i, no_index));
    ++world.counters.stretches;
    if (status == DropStatus::rest || status == DropStatus::rest_leaning) {
      member.state = drop.state();
      member.status = status;
      let_go(i, drop.past());
      member.keeper = Keeper::rest;
      member.bounds = {};
      counted_ = false;
      if (member.fresh) {  // what comes near has not been asked since it left a cluster
        member.fresh = false;
        world.turn(i);
      }
      return;
    }
    if (status != DropStatus::moving && status != DropStatus::flies_on) {
      static_cast<void>(to_cluster(i));  // what its equations do not pass, steps do
      return;
    }
    const SpeedBounds<T> bounds = speed_bounds(drop, member.reach, member.lever, member.mobility, world.now);
    world.bound_by(i, bounds);
    if (member.fresh) {
      member.fresh = false;
      world.turn(i);
    }
    world.agenda.set(DueKind::stretch, i, bounds.until);
  }

  /// A hand has come to the end of its way.
  void halt(std::size_t i) {
    Member<T>& member = world.members[i];
    member.state = world.state_at(member, world.now);
    member.time = world.now;
    member.state.v_WB = member.state.L_W = member.w_W = Vec3<T>::Zero();
    member.hand_end = std::numeric_limits<T>::infinity();
    member.bounds = {};
    counted_ = false;
    world.turn(i);
  }

  void step(std::size_t c) {
    switch (step_(world, c)) {
      case ClusterStep<T>::Outcome::splits:
        for (const std::size_t part : step_.parts()) {
          world.agenda.set(DueKind::step, part, world.now);
        }
        world.agenda.set(DueKind::step, c, world.now);
        break;
      case ClusterStep<T>::Outcome::leaves: {
        const std::size_t i = world.clusters[c].members.front();
        world.drop_cluster(c);
        world.members[i].cluster = no_index;
        take_up(i, world.members[i].state);
        break;
      }
      case ClusterStep<T>::Outcome::rests:
        counted_ = false;
        for (const std::size_t i : world.clusters[c].members) {
          world.turn(i);
        }
        break;
      case ClusterStep<T>::Outcome::goes_on:
        break;
    }
  }

  // --- two stones touch

  void touch(std::size_t k) {
    PairRecord<T>& pair = world.pairs[k];
    pair.touches = false;
    const std::size_t i = pair.first, j = pair.second;
    Member<T>&a = world.members[i], &b = world.members[j];
    if (world.share_cluster(a, b)) {
      wake(a.cluster);  // its step sees how fast they meet
      return;
    }
    const State<T> one = world.state_at(a, world.now), two = world.state_at(b, world.now);
    const Vec3<T> u1 = symmetry_axis(one.q_WB), u2 = symmetry_axis(two.q_WB);
    const Separation<T> contact = separation(Placed<T>{a.stone, one.p_WB, u1}, Placed<T>{b.stone, two.p_WB, u2});
    ++world.counters.separations;
    const auto body = [&](const Member<T>& member, const State<T>& state, const Vec3<T>& u, const Vec3<T>& p) {
      if (member.keeper != Keeper::hand) {
        return ImpactBody<T>{member.mobility, state.p_WB, u, state.v_WB, state.L_W};
      }
      const Vec3<T> v = formula::plus(state.v_WB, formula::cross(member.w_W, formula::minus(p, state.p_WB)));
      return ImpactBody<T>{fixed_mobility<T>(), state.p_WB, u, v, Vec3<T>::Zero()};
    };
    const ImpactBody<T> first = body(a, one, u1, contact.p_stone), second = body(b, two, u2, contact.p_stone);
    const auto point = [&](const ImpactBody<T>& of) {
      return formula::point_velocity(of, formula::minus(contact.p_stone, of.p_WB));
    };
    const T approach = formula::dot(contact.n_W, formula::minus(point(second), point(first)));
    const bool recent = world.now < pair.contact.last_impact + *world.settings.step;
    if (recent || !(*world.settings.impact_speed < approach)) {
      join(i, j);
      return;
    }
    const Material<T> material{world.settings.restitution, world.settings.friction};
    const TwoBodyImpact<T> impact =
        resolve(world.settings.drop.law, material, contact.p_stone, contact.n_W, first, second);
    pair.contact.last_impact = world.now;
    ++world.counters.pair_impacts;
    Separation<T> other_way = contact;
    other_way.n_W = Vec3<T>(-contact.n_W);
    other_way.p_stone = contact.p_other;
    Impulse<T> opposite = impact.impulse;
    opposite.impulse_W = Vec3<T>(-opposite.impulse_W);
    give(i, j, contact, impact.impulse, impact.first);
    give(j, i, other_way, opposite, impact.second);
  }

  /// An impact's part of one stone.
  void give(std::size_t i, std::size_t other, const Separation<T>& contact, const Impulse<T>& impulse,
            const BodyVelocity<T>& after) {
    Member<T>& member = world.members[i];
    switch (member.keeper) {
      case Keeper::drop:
        present(i).collide(contact, impulse, after, sink_of(i, other));
        begin(i);
        break;
      case Keeper::rest:
        take_up(i, member.state).collide(contact, impulse, after, sink_of(i, other));
        break;
      case Keeper::cluster: {
        wake(member.cluster);
        const State<T> before = member.state;
        member.state.v_WB = after.v_WB;
        member.state.L_W = after.L_W;
        member.last_touch = world.now;
        world.tell(i, other, EventKind::impact, before, member.state, [&](Event<T>& event) {
          event.impulse_W = impulse.impulse_W;
          event.outcome = impulse.outcome;
          note_contact(event, contact);
        });
        break;
      }
      case Keeper::hand: {
        const Vec3<T> arm = formula::minus(contact.p_stone, world.state_at(member, world.now).p_WB);
        const Vec3<T> v = formula::plus(member.state.v_WB, formula::cross(member.w_W, arm));
        member.work = member.work - formula::dot(impulse.impulse_W, v);
        world.turn(i);
        break;
      }
      case Keeper::removed:
        break;
    }
  }

  /// Two stones stay together for a while.
  void join(std::size_t i, std::size_t j) {
    const bool hand1 = world.members[i].keeper == Keeper::hand, hand2 = world.members[j].keeper == Keeper::hand;
    for (const std::size_t one : {i, j}) {
      const std::size_t other = one == i ? j : i;
      if (world.members[one].keeper != Keeper::hand) {
        const bool joins = world.members[one].keeper != Keeper::cluster;
        static_cast<void>(to_cluster(one));
        if (joins) {
          world.tell(one, other, EventKind::contact, world.members[one].state);
        }
      }
    }
    if (!hand1 && !hand2) {
      const std::size_t c = world.members[i].cluster, d = world.members[j].cluster;
      merge(c, d);
      world.agenda.set(DueKind::step, world.members[i].cluster, world.now);
    }
  }

  ClusterStep<T> step_;
  std::size_t awake_ = 0;
  bool counted_ = false;
};

}  // namespace goishi::detail
