#pragma once
/// \file
/// The contacts of a cluster where its stones are now, as rows for the solver.

#include <goishi/scene/cluster/sweeps.hpp>
#include <goishi/scene/world/world.hpp>
#include <vector>

namespace goishi::detail {

/// Where a row comes from.
template <class T>
struct RowSource {
  ContactMemory<T>* memory;
  std::size_t first, second;  // stones; no second: the ground
  T gap;                      // [m] less the clearance
  Separation<T> contact;
  Vec3<T> other_v;  // of a second that moves by itself, at the contact
  T restitution;
  bool known;  // in the last step, too
};

template <Ordered T>
class ClusterContacts {
 public:
  Sweeps<T> sweeps;                   // with a row for each
  std::vector<RowSource<T>> sources;  // likewise

  /// Of stones that are where they are now.
  void collect(World<T>& world, std::size_t c) {
    sweeps.clear();
    sources.clear();
    const std::vector<std::size_t>& stones = world.clusters[c].members;
    for (std::size_t local = 0; local < stones.size(); ++local) {
      Member<T>& member = world.members[stones[local]];
      member.local = local;
      const Vec3<T> u = symmetry_axis(member.state.q_WB);
      const Vec3<T> w = formula::turning(member.mobility, u, member.state.L_W);
      sweeps.movers.push_back({member.mobility, u, member.state.v_WB, w, member.state.v_WB, w, member.reach});
    }
    for (const std::size_t i : stones) {
      touch_ground(world, i);
      for (const std::size_t k : world.members[i].pairs) {
        touch_stone(world, i, k);
      }
    }
  }

  /// Where a stone will be, with the velocities that it has in the solver: straight on, and turning freely.
  [[nodiscard]] static Placed<T> placed_after(const Member<T>& member, const Mover<T>& mover, const T& t) {
    const T axial = mover.mobility.transverse + mover.mobility.axial;
    const T spin = mover.mobility.axial * formula::dot(mover.w, mover.u) / axial;
    // L/I_t = ω − (1/I_a − 1/I_t)(u · L) u
    const Vec3<T> turn = formula::scaled(t, formula::plus(mover.w, T(-spin), mover.u));
    const T angle = scalar::sqrt(T(formula::dot(turn, turn) + scalar::tiny<T>()));
    FlightPath<T> path;
    path.u_W = mover.u;
    path.k_W = formula::scaled(T(T(1) / angle), turn);
    return {member.stone, formula::plus(member.state.p_WB, t, mover.v),
            formula::axis_turned(path, scalar::sincos(angle))};
  }

  /// Whether the gap of a row, less the clearance, will be below a length   [m].
  [[nodiscard]] bool leads_below(const World<T>& world, std::size_t k, const T& t, const T& lowest) const {
    const Row<T>& row = sweeps.rows[k];
    const RowSource<T>& source = sources[k];
    const Placed<T> one = placed_after(world.members[source.first], sweeps.movers[row.a], t);
    if (source.second == no_index) {
      return formula::dot(row.n, formula::minus(one.p_W, source.contact.p_other)) -
                 support_value(one.stone, see<T>(one.u_W, row.n).direction) <
             lowest;
    }
    const Placed<T> two = other_after(world, row, source, sweeps, t);
    const T least = lowest + *world.settings.clearance;
    return gap_along_normal(one, two, row.n) < least && separation(one, two).gap < least;
  }

  /// How fast the bodies of a row turn, and turn about each other, squared   [1/s²].
  [[nodiscard]] T turning_square(std::size_t k) const {
    const Row<T>& row = sweeps.rows[k];
    const Mover<T>& a = sweeps.movers[row.a];
    const Vec3<T> v = formula::minus(sweeps.velocity(row), sources[k].other_v);
    T square = formula::dot(a.w, a.w) + formula::dot(v, v) / scalar::sq(a.reach);
    if (row.b != no_index) {
      square = square + formula::dot(sweeps.movers[row.b].w, sweeps.movers[row.b].w);
    }
    return square;
  }

  /// What a row asks of a step as long as h: that it closes what there is of a gap; and where it begins, with the impulses of
  /// the last step. `again`: by the velocities and impulses that were found.
  void aim(const World<T>& world, std::size_t k, const T& h, bool again) {
    Row<T>& row = sweeps.rows[k];
    const RowSource<T>& source = sources[k];
    const ContactMemory<T>& memory = *source.memory;
    Vec3<T> turning = source.second == no_index
                          ? on_ground(world.members[source.first].stone, row, source.contact.feature)
                          : between(world, k, h, again);
    // Bodies that touch bend no faster than c (|ω| + |v|/c)². Where the contact jumps, or runs about a rim that all but lies
    // flat, it tells nothing; nor by velocities that it has made itself.
    if (!again) {
      row.most = T(2) * sweeps.movers[row.a].reach * turning_square(k);
    }
    if (!(formula::dot(turning, turning) <= scalar::sq(row.most))) {
      turning = Vec3<T>::Zero();
    }
    row.bias = row.in_frame(formula::minus(formula::scaled(T(h / T(2)), turning), source.other_v));
    row.bias.z() = row.bias.z() + source.gap / h;
    row.turning = h / T(2) * formula::dot(row.n, turning);
    if (again) {
      return;
    }
    row.p = row.torque = Vec3<T>::Zero();
    if (source.known && T(0) < memory.weight) {
      const T scale = h / memory.weight;
      const Vec3<T> p = row.in_frame(formula::scaled(scale, memory.impulse));
      if (T(0) < p.z()) {
        row.p = p;
        row.torque = formula::scaled(scale, memory.torque);
      }
    }
  }

 private:
  [[nodiscard]] Placed<T> placed(const Member<T>& member) const {
    return {member.stone, member.state.p_WB, sweeps.movers[member.local].u};
  }

  /// Where both bodies get their impulses: one point, so that they keep the angular momentum.
  [[nodiscard]] static Vec3<T> middle(const Separation<T>& contact) {
    return formula::plus(contact.p_stone, T(-contact.gap / T(2)), contact.n_W);
  }

  void touch_ground(World<T>& world, std::size_t i) {
    Member<T>& member = world.members[i];
    const T low = member.state.p_WB.z() - member.reach;
    for (std::size_t which = 0; which < 2; ++which) {
      ContactMemory<T>& memory = member.ground[which];
      const bool known = memory.listed, is_board = which == 0;
      memory.listed = false;
      const Plane<T> floor = floor_of(world.board);
      if (world.range < low - (is_board ? T(0) : floor.offset)) {
        continue;
      }
      const Separation<T> contact = is_board ? separation(placed(member), world.board)
                                             : separation_along(placed(member), floor.n_W, floor.offset);
      if (contact.gap <= world.range) {
        static_cast<void>(add(world, memory, known, i, no_index, contact, T(contact.gap)));
      }
    }
  }

  void touch_stone(World<T>& world, std::size_t i, std::size_t k) {
    PairRecord<T>& pair = world.pairs[k];
    const std::size_t j = pair.first == i ? pair.second : pair.first;
    const Member<T>& other = world.members[j];
    const bool hand = other.keeper == Keeper::hand;
    if (!hand && (!world.share_cluster(world.members[i], other) || pair.second == i)) {
      return;
    }
    if (!pair.contact.listed && !pair.exact && world.now < pair.due) {
      return;  // too far for now
    }
    const bool known = pair.contact.listed;
    pair.contact.listed = false;
    const State<T> at = hand ? world.state_at(other, world.now) : other.state;
    const Placed<T> two{other.stone, at.p_WB, hand ? symmetry_axis(at.q_WB) : sweeps.movers[other.local].u};
    const Placed<T> one = placed(world.members[i]);
    Separation<T> contact;
    if (i == pair.first) {
      contact = world.apart(pair, one, two);
    } else {  // a hand is the first
      contact = separation(one, two);
      ++world.counters.separations;
    }
    if (world.range < contact.gap) {
      world.wait(k, T(contact.gap - world.range), T(world.members[i].bounds.surface + other.bounds.surface), false);
    } else if (add(world, pair.contact, known, i, j, contact, T(contact.gap - *world.settings.clearance))) {
      pair.exact = true;  // as long as the steps take care of it
      pair.touches = false;
      world.agenda.remove(DueKind::pair, k);
    } else {
      pair.exact = true;  // of so fast ones, when they touch is asked after the step has been chosen
      pair.touches = false;
    }
  }

  /// A row; false for what meets so fast that it has to be when it touches.
  [[nodiscard]] bool add(World<T>& world, ContactMemory<T>& memory, bool known, std::size_t i, std::size_t j,
                         const Separation<T>& contact, const T& gap) {
    const T h = *world.settings.step, clearance = *world.settings.clearance;
    const Member<T>& member = world.members[i];
    const Member<T>* other = j == no_index ? nullptr : &world.members[j];
    const bool by_itself = other != nullptr && other->keeper == Keeper::hand;
    Row<T> row;
    row.a = member.local;
    row.b = other == nullptr || by_itself ? no_index : other->local;
    row.n = contact.n_W;
    const Vec3<T> p = middle(contact);
    row.ra = formula::minus(p, member.state.p_WB);
    row.rb = row.other_w = Vec3<T>::Zero();
    Vec3<T> other_v = Vec3<T>::Zero();
    if (other != nullptr) {
      row.rb = formula::minus(p, by_itself ? world.state_at(*other, world.now).p_WB : other->state.p_WB);
    }
    if (by_itself) {
      row.other_w = other->w_W;
      other_v = formula::plus(other->state.v_WB, formula::cross(other->w_W, row.rb));
    }
    const T approach = formula::dot(row.n, formula::minus(other_v, sweeps.velocity(row)));
    const bool recent = world.now < memory.last_impact + h;
    if (*world.settings.impact_speed < approach && T(2) * clearance < gap && !recent) {
      return false;
    }
    row.friction = other == nullptr ? world.settings.drop.friction : world.settings.friction;
    row.rolling = other == nullptr ? member.rolling : T((member.rolling + other->rolling) / T(2));
    row.pivot = other == nullptr ? member.pivot : T((member.pivot + other->pivot) / T(2));
    prepare(row, sweeps.movers[row.a], row.b == no_index ? nullptr : &sweeps.movers[row.b]);
    row.bias = row.p = row.torque = Vec3<T>::Zero();
    memory.listed = true;
    sources.push_back({&memory, i, j, gap, contact, other_v,
                       other == nullptr ? world.settings.drop.restitution : world.settings.restitution, known});
    sweeps.rows.push_back(row);
    return true;
  }

  [[nodiscard]] static Placed<T> other_after(const World<T>& world, const Row<T>& row, const RowSource<T>& source,
                                             const Sweeps<T>& sweeps, const T& t) {
    const Member<T>& other = world.members[source.second];
    return row.b != no_index ? placed_after(other, sweeps.movers[row.b], t)
                             : sight(world.moving(other), T(world.now + t)).placed;
  }

  [[nodiscard]] static Vec3<T> carried(const Mover<T>& mover, const Vec3<T>& r, const Vec3<T>& r_rate) {
    const T axial = formula::dot(mover.u, mover.w) / (mover.mobility.transverse + mover.mobility.axial);
    return formula::carried_rate(mover.mobility, mover.u, axial, mover.w, r, r_rate);
  }

  [[nodiscard]] Vec3<T> on_ground(const Stone<T>& stone, const Row<T>& row, Feature feature) const {
    const Mover<T>& a = sweeps.movers[row.a];
    if (feature != Feature::rim) {
      const T d = feature == Feature::lower_cap ? stone.sphere_offset : T(-stone.sphere_offset);
      return carried(a, row.ra, formula::cap_contact_rate(d, a.w, a.u));
    }
    const SeenNormal<T> seen = see<T>(a.u, row.n);
    const T n_r = seen.direction.radial;
    const Vec3<T> e = formula::scaled(T(T(1) / n_r), seen.radial_part);
    return carried(a, row.ra, formula::rim_contact_rate(stone.bevel_major_radius, a.w, a.u, row.n, e, n_r));
  }

  /// By what has changed since the last step, or, of a contact that is new or has just been hit, will have changed a little
  /// later.
  [[nodiscard]] Vec3<T> between(const World<T>& world, std::size_t k, const T& h, bool again) const {
    const Row<T>& row = sweeps.rows[k];
    const RowSource<T>& source = sources[k];
    const ContactMemory<T>& memory = *source.memory;
    T age = world.now - memory.time;
    Vec3<T> n, ra, rb;
    if (!again && source.known && T(0) < age && memory.last_impact < world.now) {
      n = formula::minus(row.n, memory.n);
      ra = formula::minus(row.ra, memory.ra);
      rb = formula::minus(row.rb, memory.rb);
    } else {
      age = h / T(64);
      const Placed<T> one = placed_after(world.members[source.first], sweeps.movers[row.a], age);
      const Placed<T> two = other_after(world, row, source, sweeps, age);
      const Separation<T> then = separation(one, two);
      n = formula::minus(then.n_W, row.n);
      const Vec3<T> p = middle(then);
      ra = formula::minus(formula::minus(p, one.p_W), row.ra);
      rb = formula::minus(formula::minus(p, two.p_W), row.rb);
    }
    const T over = T(1) / age;
    const Vec3<T> v = formula::minus(sweeps.velocity(row), source.other_v);
    Vec3<T> b = carried(sweeps.movers[row.a], row.ra, formula::scaled(over, ra));
    if (row.b != no_index) {
      b = formula::minus(b, carried(sweeps.movers[row.b], row.rb, formula::scaled(over, rb)));
    }
    b = formula::plus(b, T(over * formula::dot(n, v)), row.n);
    return b;
  }
};

}  // namespace goishi::detail
