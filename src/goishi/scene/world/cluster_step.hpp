#pragma once
/// \file
/// A step of a cluster: where its stones touch, fast approaches by the impact law, all other contacts together, and whether
/// it rests.
///
/// Leapfrog: velocities are of the middles of steps, places of their ends, where contacts are found; between, a stone goes
/// straight and turns freely. A contact's velocity after the push shall close what there is of a gap in the step, with what
/// turning bodies change of it (J̇ v):
///
///     v_n⁺ >= −gap/h − b · n,   no slip: v_t⁺ = −b_t,   b = (h/2)(ω × ṙ + ω̇ × r of the first − of the second + (ṅ · v) n)

#include <cmath>
#include <goishi/scene/world/cluster_impulses.hpp>

namespace goishi::detail {

template <Ordered T>
class ClusterStep : private ClusterImpulses<T> {
  using Impulses = ClusterImpulses<T>;
  using Impulses::begin, Impulses::solve, Impulses::take, Impulses::take_with_rates, Impulses::remember,
      Impulses::meet_fast;
  using Impulses::contacts_, Impulses::h_, Impulses::is_closed, Impulses::far_off;

 public:
  /// What came of a step.
  enum class Outcome { goes_on, splits, leaves, rests };

  /// The stones to where they are now, with the velocities that they have.
  static void bring(World<T>& world, std::size_t c) {
    for (const std::size_t i : world.clusters[c].members) {
      Member<T>& member = world.members[i];
      member.state = world.state_at(member, world.now);
      member.time = world.now;
    }
  }

  /// A step from now on. `splits`: it has fallen apart, and `parts` are to go on from now. `leaves`: its only stone is held by
  /// no other any more, and its state is that of the present.
  [[nodiscard]] Outcome operator()(World<T>& world, std::size_t c) {
    bring(world, c);
    contacts_.collect(world, c);
    if (splits(world, c)) {
      return Outcome::splits;
    }
    if (leaves(world, c)) {
      return Outcome::leaves;
    }
    meet_fast(world);
    h_ = step_of(world);
    if (comes_to_rest(world, c)) {
      return Outcome::rests;
    }
    push(world, c);
    drift(world, c);
    ++world.counters.steps;
    world.counters.stone_steps += static_cast<long long>(world.clusters[c].members.size());
    return Outcome::goes_on;
  }

  /// The clusters that it has fallen into, but for itself.
  [[nodiscard]] const std::vector<std::size_t>& parts() const { return parts_; }

 private:
  // --- which stones are together

  [[nodiscard]] std::size_t root(std::size_t local) {
    while (parent_[local] != local) {
      local = parent_[local] = parent_[parent_[local]];
    }
    return local;
  }

  [[nodiscard]] bool splits(World<T>& world, std::size_t c) {
    const std::vector<std::size_t> stones = world.clusters[c].members;
    parent_.resize(stones.size());
    for (std::size_t k = 0; k < stones.size(); ++k) {
      parent_[k] = k;
    }
    for (const Row<T>& row : contacts_.sweeps.rows) {
      if (row.b != no_index) {
        const std::size_t a = root(row.a), b = root(row.b);
        (a < b ? parent_[b] : parent_[a]) = a < b ? a : b;
      }
    }
    parts_.clear();
    bool whole = true;
    for (std::size_t k = 0; k < stones.size(); ++k) {
      whole = whole && root(k) == 0;
    }
    if (whole) {
      return false;
    }
    own_.assign(stones.size(), no_index);
    own_[0] = c;
    world.clusters[c].members.clear();
    for (std::size_t k = 0; k < stones.size(); ++k) {
      const std::size_t first = root(k);
      if (own_[first] == no_index) {
        own_[first] = world.new_cluster();
        parts_.push_back(own_[first]);
      }
      world.clusters[own_[first]].members.push_back(stones[k]);
      world.members[stones[k]].cluster = own_[first];
    }
    return true;
  }

  [[nodiscard]] bool leaves(World<T>& world, std::size_t c) {
    const std::vector<std::size_t>& stones = world.clusters[c].members;
    Member<T>& member = world.members[stones.front()];
    if (1 < stones.size() || world.now < member.last_touch + *world.settings.leaving_time) {
      return false;
    }
    for (const RowSource<T>& source : contacts_.sources) {
      if (source.second != no_index) {
        return false;
      }
    }
    // Its velocity to the present: what gravity has given since, and the ground has taken.
    Sweeps<T>& sweeps = contacts_.sweeps;
    h_ = *world.settings.step;
    begin(world, c, T(world.now - member.nominal));
    for (std::size_t k = 0; k < sweeps.rows.size(); ++k) {
      sweeps.rows[k].bias = {T(0), T(0), is_closed(world, contacts_.sources[k]) ? T(0) : far_off(world)};
    }
    solve(world, T(1e-6), 100);
    take(world, c);
    for (const RowSource<T>& source : contacts_.sources) {
      if (source.contact.gap < T(0)) {
        member.state.p_WB = formula::plus(member.state.p_WB, T(-source.contact.gap), source.contact.n_W);
      }
    }
    return true;
  }

  // --- the step

  /// How long a step may be: what is left of a gap's change after the second order, about c (ω h)³/6, shall be no more than
  /// twice the clearance.
  [[nodiscard]] T step_of(const World<T>& world) const {
    const Sweeps<T>& sweeps = contacts_.sweeps;
    const T& longest = *world.settings.step;
    T square(0), reach(0);
    for (const Mover<T>& mover : sweeps.movers) {
      square = scalar::max(square, formula::dot(mover.w, mover.w));
      reach = scalar::max(reach, mover.reach);
    }
    for (std::size_t k = 0; k < sweeps.rows.size(); ++k) {
      const Vec3<T> v = formula::minus(sweeps.velocity(sweeps.rows[k]), contacts_.sources[k].other_v);
      square = scalar::max(square, T(formula::dot(v, v) / scalar::sq(reach)));
    }
    const T angle = cube_root(T(T(12) * *world.settings.clearance / reach));
    const T step = square * scalar::sq(longest) <= scalar::sq(angle) ? longest : T(angle / scalar::sqrt(square));
    return scalar::max(step, T(longest / T(shortest_share)));
  }

  [[nodiscard]] static T cube_root(const T& x) {
    using std::cbrt;
    return T(cbrt(x));
  }

  /// Where the step leads too deep, it is taken again, with how contacts turn by the velocities found; then a shorter one.
  void push(World<T>& world, std::size_t c) {
    const T deepest = -T(4) * *world.settings.clearance, shortest = *world.settings.step / T(shortest_share);
    Sweeps<T>& sweeps = contacts_.sweeps;
    for (std::size_t k = 0; k < sweeps.rows.size(); ++k) {
      if (contacts_.sources[k].gap < deepest) {
        push_out(world, sweeps.rows[k], contacts_.sources[k]);
      }
    }
    for (int attempt = 0;; ++attempt) {
      for (std::size_t k = 0; k < sweeps.rows.size(); ++k) {
        contacts_.aim(world, k, h_, 0 < attempt);
      }
      begin(world, c, std::nullopt);
      solve(world, world.settings.solver_tolerance, most_sweeps);
      const bool bends = bends_too_far(world);
      if (!(shortest < h_) || !(bends || leads_too_deep(world))) {
        break;
      }
      h_ = attempt == 0 && !bends ? h_ : T(h_ / T(2));
      ++world.counters.retries;
    }
    take_with_rates(world, c);
    remember(world, h_);
  }

  /// Whether a gap is too deep in the middle of the step: g + v_n h/2 + b h/4, b as turning has it.
  [[nodiscard]] bool bends_too_far(const World<T>& world) const {
    const T lowest = -T(4) * *world.settings.clearance;
    for (std::size_t k = 0; k < contacts_.sources.size(); ++k) {
      const Row<T>& row = contacts_.sweeps.rows[k];
      const RowSource<T>& source = contacts_.sources[k];
      const T v = formula::dot(row.n, formula::minus(contacts_.sweeps.velocity(row), source.other_v));
      const T middle = source.gap + h_ / T(2) * (v + row.turning / T(2));
      if (middle < (source.gap < T(0) ? T(source.gap + lowest) : lowest)) {
        return true;
      }
    }
    return false;
  }

  /// Whether one is at the end.
  [[nodiscard]] bool leads_too_deep(const World<T>& world) const {
    const Sweeps<T>& sweeps = contacts_.sweeps;
    const T slack = T(2) * *world.settings.clearance;
    for (std::size_t k = 0; k < contacts_.sources.size(); ++k) {
      const T& gap = contacts_.sources[k].gap;
      const T lowest = (gap < T(0) ? gap : T(0)) - slack;
      // So slow that nothing bends by more than that.
      const T bend = sweeps.movers[sweeps.rows[k].a].reach * contacts_.turning_square(k);
      if (slack < bend * scalar::sq(h_) && contacts_.leads_below(world, k, h_, lowest)) {
        return true;
      }
    }
    return false;
  }

  /// Out of an overlap, by moving only.
  void push_out(World<T>& world, const Row<T>& row, RowSource<T>& source) {
    const T a = sweeps_mobility(row.a), b = row.b != no_index ? sweeps_mobility(row.b) : T(0);
    const T way = -source.gap / (a + b);
    Vec3<T>& p = world.members[source.first].state.p_WB;
    p = formula::plus(p, T(a * way), row.n);
    if (row.b != no_index) {
      Vec3<T>& other = world.members[source.second].state.p_WB;
      other = formula::plus(other, T(-(b * way)), row.n);
    }
    source.gap = T(0);
  }

  [[nodiscard]] const T& sweeps_mobility(std::size_t local) const {
    return contacts_.sweeps.movers[local].mobility.linear;
  }

  // --- rest

  /// Statics: from rest, do the contacts that are closed hold everything where it is?
  [[nodiscard]] bool comes_to_rest(World<T>& world, std::size_t c) {
    Cluster<T>& cluster = world.clusters[c];
    Sweeps<T>& sweeps = contacts_.sweeps;
    // No slower than what the solver's tolerance may leave.
    const T slow = scalar::max(T(T(0.2) * *world.settings.impact_speed),
                               T(world.settings.solver_tolerance * *world.settings.step * world.g));
    for (const Mover<T>& mover : sweeps.movers) {
      if (scalar::sq(slow) < formula::dot(mover.v, mover.v) ||
          scalar::sq(slow) < scalar::sq(mover.reach) * formula::dot(mover.w, mover.w)) {
        cluster.wait = 0;
        cluster.next_wait = 1;
        return false;
      }
    }
    if (0 < cluster.wait--) {
      return false;
    }
    for (const RowSource<T>& source : contacts_.sources) {
      if (T(0) < formula::dot(source.other_v, source.other_v)) {
        return false;  // a hand pushes it
      }
    }
    ++world.counters.rest_trials;
    const T& h = h_;
    const Vec3<T> gain = formula::scaled(h, world.settings.drop.gravity);
    for (Mover<T>& mover : sweeps.movers) {
      mover.free_v = gain;
      mover.free_w = Vec3<T>::Zero();
    }
    saved_.clear();
    for (std::size_t k = 0; k < sweeps.rows.size(); ++k) {
      Row<T>& row = sweeps.rows[k];
      saved_.push_back(row);
      contacts_.aim(world, k, h_, false);  // from the impulses of the last step
      row.bias = {T(0), T(0), is_closed(world, contacts_.sources[k]) ? T(0) : far_off(world)};
    }
    const bool solved = solve(world, T(1e-6), most_sweeps / 2);
    const T still = T(1e-4) * h * world.g;
    bool rests = solved;
    for (const Mover<T>& mover : sweeps.movers) {
      rests = rests && formula::dot(mover.v, mover.v) <= scalar::sq(still) &&
              scalar::sq(mover.reach) * formula::dot(mover.w, mover.w) <= scalar::sq(still);
    }
    if (!rests) {
      cluster.wait = cluster.next_wait;
      cluster.next_wait = cluster.next_wait < 16 ? 2 * cluster.next_wait : 16;
      sweeps.rows = saved_;
      for (std::size_t k = 0; k < cluster.members.size(); ++k) {
        const Member<T>& member = world.members[cluster.members[k]];
        Mover<T>& mover = sweeps.movers[k];
        mover.v = member.state.v_WB;
        mover.w = formula::turning(member.mobility, mover.u, member.state.L_W);
      }
      return false;
    }
    remember(world, h);
    cluster.asleep = true;
    world.agenda.remove(DueKind::step, c);
    for (const std::size_t i : cluster.members) {
      Member<T>& member = world.members[i];
      const State<T> before = member.state;
      member.state.v_WB = member.state.L_W = Vec3<T>::Zero();
      member.bounds = {};
      world.tell(i, no_index, EventKind::rest, before, member.state, [](Event<T>&) {});
    }
    return true;
  }

  // --- on

  /// The way up to the next step: its end is where one of the stones meets the ground, if that is before.
  void drift(World<T>& world, std::size_t c) {
    Cluster<T>& cluster = world.clusters[c];
    T length = h_;
    for (std::size_t k = 0; k < cluster.members.size(); ++k) {
      Member<T>& member = world.members[cluster.members[k]];
      member.nominal = world.now + h_ / T(2);
      const Mover<T>& mover = contacts_.sweeps.movers[k];
      const T centre = scalar::sqrt(formula::dot(mover.v, mover.v));
      const T speed = centre + member.reach * scalar::sqrt(formula::dot(mover.w, mover.w));
      world.bound_by(cluster.members[k], {centre, speed});
      length = meets_ground(world, member, speed, length);
    }
    cluster.end = world.now + length;
    world.agenda.set(DueKind::step, c, cluster.end);
    for (const std::size_t i : cluster.members) {
      for (const std::size_t k : world.members[i].pairs) {
        if (world.pairs[k].exact && !world.is_listed(world.pairs[k])) {
          world.ask(k);
        }
      }
    }
  }

  [[nodiscard]] T meets_ground(const World<T>& world, const Member<T>& member, const T& speed, T length) const {
    const T least = h_ / T(1000);
    const T height = member.state.p_WB.z() - member.reach;
    const auto meet = [&](bool listed, const T& level, const auto& ground) {
      if (listed || speed * length < height - level) {
        return;
      }
      const FlightPath<T> path = path_of(member.state, member.mobility, Vec3<T>(Vec3<T>::Zero()));
      const TimeOfImpact<T> hit = time_of_impact(member.stone, path, ground, length);
      if (hit.status == ImpactStatus::hit && hit.time < length) {
        length = hit.time < least ? least : hit.time;
      }
    };
    meet(member.ground[0].listed, T(0), world.board);
    meet(member.ground[1].listed, world.board.floor, floor_of(world.board));
    return length;
  }

  static constexpr int most_sweeps = 200;
  static constexpr int shortest_share = 32;  // of the step that is set
  std::vector<Row<T>> saved_;
  std::vector<std::size_t> parent_, own_, parts_;
};

}  // namespace goishi::detail
