#pragma once
/// \file
/// A board and stones on it and over it, as many as it holds: each flies, bounces, rolls, leans on others, and comes to rest.

#include <goishi/scene/world/scene_course.hpp>

namespace goishi {

/// A value: it can be stored, copied, stopped, changed and continued, and a copy goes on as the original does, bit for bit.
///
///     Scene<double> scene(make_board<double>());
///     const StoneId a = scene.add(stone, body, {.p_WB = {0, 0, 0.05}, .q_WB = …});
///     scene.advance(1.0 / 60.0);
///     scene.state(a);
///     scene.run_until_rest(10.0);
///
/// A stone that touches no other is a `Drop`, with its events and its bits. Two stones meet at a time that is searched for as
/// that of a stone and the board is; fast, an impact law parts them. Stones that stay together are a cluster, which goes by
/// steps: of first order in the step. Nothing depends on how time is cut, to the last bit: everything goes from one thing that
/// is due to the next, and the present is looked up between.
///
/// Domain  a board of `make_board`; stones, bodies and states as `Drop` takes them, no overlaps; settings in range; else
///         InvalidArgument, and the scene is as it was.
/// Rest    is a statement of statics: of a stone alone, as of `Drop`; of a cluster, contact forces that, from rest, leave no
///         acceleration above 1e-4 g. What rests costs nothing.
/// Friction  between stones is dry, and so is that of a cluster on the board, whatever the model of the drops.
template <Ordered T>
class Scene {
 public:
  explicit Scene(const Board<T>& board, const SceneSettings<T>& settings = {}) {
    detail::require_board(board);
    require_settings(settings);
    detail::World<T>& world = course_.world;
    world.board = board;
    world.given = world.settings = settings;
  }

  // --- stones

  /// Domain  as above; the stone overlaps nothing.
  StoneId add(const Stone<T>& stone, const RigidBody<T>& body, const State<T>& start) {
    detail::World<T>& world = course_.world;
    const Drop<T> drop(stone, body, start, world.board, world.settings.drop);  // refuses what is wrong
    require_free(stone, start);
    if (world.members.empty()) {
      fill(stone.width);
    }
    const T reach = detail::greatest_reach(stone);
    const T k2 = body.moments.x() / body.mass;
    detail::Member<T> member{.stone = stone,
                             .body = body,
                             .mobility = formula::mobility(body),
                             .reach = reach,
                             .lever = scalar::sqrt(T(T(1) + scalar::sq(reach) / k2)),
                             .rolling = drop.contact_body().resists ? drop.contact_body().rolling_resistance : T(0),
                             .pivot = drop.contact_body().resists ? drop.contact_body().pivot_radius : T(0),
                             .state = start,
                             .time = world.now};
    const std::size_t i = world.members.size();
    world.members.push_back(member);
    world.widen(reach);
    world.settle_at(i, start.p_WB);
    course_.take_up(i, start);
    return StoneId(i);
  }

  void remove(StoneId id) {
    const std::size_t i = known(id);
    course_.take_out(i);
    course_.world.forget(i);
    course_.world.members[i].keeper = detail::Keeper::removed;
  }

  [[nodiscard]] bool has(StoneId id) const {
    const auto i = static_cast<std::size_t>(id);
    return i < course_.world.members.size() && course_.world.members[i].keeper != detail::Keeper::removed;
  }

  /// All stones, in the order in which they were added.
  [[nodiscard]] std::vector<StoneId> stones() const {
    std::vector<StoneId> all;
    for (std::size_t i = 0; i < course_.world.members.size(); ++i) {
      if (has(StoneId(i))) {
        all.push_back(StoneId(i));
      }
    }
    return all;
  }

  // --- going on

  /// Goes on for a time, and tells of the events on its way, those at its end included. False if the work of one call is used up
  /// before (`SceneSettings::most_work`): then it is at `time()`, and the next call goes on from there.
  /// Domain  dt > 0 and finite; else InvalidArgument.
  bool advance(const T& dt, SceneSink<T> sink = {}) {
    require(T(0) < dt && scalar::is_finite(T(time() + dt)), "dt", dt,
            "must be positive and finite, the time after it too");
    return advance_to(T(time() + dt), sink);
  }

  /// The same up to a time.
  /// Domain  a finite time, not before `time()`.
  bool advance_to(const T& time, SceneSink<T> sink = {}) {
    detail::World<T>& world = course_.world;
    require(world.now <= time && scalar::is_finite(time), "time", time, "must be finite, and not before the present, ",
            world.now);
    world.sink = sink;
    const bool there = course_.run(time, false);
    world.sink = {};
    return there;
  }

  /// Goes on until all stones rest, for no longer than `horizon`   [s]. True if they do.
  /// Domain  a finite horizon > 0.
  bool run_until_rest(const T& horizon, SceneSink<T> sink = {}) {
    detail::World<T>& world = course_.world;
    require_positive("horizon", horizon);
    world.sink = sink;
    const bool done = course_.run(T(world.now + horizon), true);
    world.sink = {};
    return done && course_.rests();
  }

  // --- what it is

  [[nodiscard]] const T& time() const { return course_.world.now; }
  [[nodiscard]] State<T> state(StoneId id) const {
    const detail::World<T>& world = course_.world;
    const detail::Member<T>& member = world.members[known(id)];
    return is_new(member) ? world.drops[member.drop].state() : world.seen_at(member, world.now);
  }

  [[nodiscard]] StoneMode mode(StoneId id) const { return mode(known(id)); }

  [[nodiscard]] const SceneCounters& counters() const { return course_.world.counters; }
  [[nodiscard]] const Board<T>& board() const { return course_.world.board; }
  [[nodiscard]] const SceneSettings<T>& settings() const { return course_.world.settings; }
  [[nodiscard]] const Stone<T>& stone(StoneId id) const { return course_.world.members[known(id)].stone; }
  [[nodiscard]] const RigidBody<T>& body(StoneId id) const { return course_.world.members[known(id)].body; }

  /// Of all stones   [J], potential zero at the origin of W.
  [[nodiscard]] T energy() const {
    T sum(0);
    for (const StoneId id : stones()) {
      sum = sum + formula::energy(state(id), body(id), settings().drop.gravity);
    }
    return sum;
  }

  /// What touches now, by the first of two stones. The forces are means of a step or a stretch, those on what rests exact to
  /// what rest is; unset where a stone leans on two things by itself.
  [[nodiscard]] std::vector<SceneContact<T>> contacts() const {
    const detail::World<T>& world = course_.world;
    std::vector<SceneContact<T>> all;
    const auto remembered = [&](std::size_t i, std::optional<StoneId> other, const detail::ContactMemory<T>& memory) {
      if (memory.listed && T(0) < formula::dot(memory.impulse, memory.n)) {
        all.push_back(
            {StoneId(i), other, memory.p, memory.n, formula::scaled(T(T(1) / memory.weight), memory.impulse)});
      }
    };
    for (std::size_t i = 0; i < world.members.size(); ++i) {
      const detail::Member<T>& member = world.members[i];
      if (member.keeper == detail::Keeper::cluster) {
        for (const detail::ContactMemory<T>& memory : member.ground) {
          remembered(i, std::nullopt, memory);
        }
      } else if (mode(i) == StoneMode::rest || mode(i) == StoneMode::contact) {
        alone(i, all);
      }
      for (const std::size_t k : member.pairs) {
        const detail::PairRecord<T>& pair = world.pairs[k];
        // A hand is held against as well as anything: then the stone is the other.
        const bool first = pair.first == i, by_hand = world.members[pair.first].keeper == detail::Keeper::hand;
        if (first != by_hand && world.is_listed(pair)) {
          remembered(i, StoneId(first ? pair.second : pair.first), pair.contact);
        }
      }
    }
    return all;
  }

  // --- what is done to it

  /// A hand takes a stone: from where it is it moves with a velocity and an angular velocity for a time, whatever it meets, and
  /// then stands still until it is told otherwise or let go.
  /// Domain  all finite, duration > 0; the way does not lead into board or floor; else InvalidArgument.
  void hold(StoneId id, const Vec3<T>& v_WB, const Vec3<T>& w_WB, const T& duration) {
    const std::size_t i = known(id);
    detail::World<T>& world = course_.world;
    require(scalar::is_finite(v_WB), "v_WB", v_WB.transpose(), "must be finite");
    require(scalar::is_finite(w_WB), "w_WB", w_WB.transpose(), "must be finite");
    require_positive("duration", duration);
    detail::Member<T> hand = world.members[i];
    hand.state = state(id);
    hand.time = world.now;
    hand.keeper = detail::Keeper::hand;
    hand.state.v_WB = v_WB;
    hand.state.L_W = formula::angular_momentum_W(hand.state.q_WB, hand.body, formula::in_body(hand.state.q_WB, w_WB));
    hand.w_W = w_WB;
    hand.hand_end = world.now + duration;
    require_free_way(hand, duration);
    course_.take_out(i);
    detail::Member<T>& member = world.members[i];
    member.state = hand.state;
    member.w_W = w_WB;
    member.hand_end = hand.hand_end;
    member.keeper = detail::Keeper::hand;
    const T centre = scalar::sqrt(formula::dot(v_WB, v_WB));
    world.bound_by(i, {centre, T(centre + member.reach * scalar::sqrt(formula::dot(w_WB, w_WB)))});
    world.turn(i);
    world.agenda.set(detail::DueKind::stretch, i, member.hand_end);
  }

  /// Lets a stone go that a hand holds, with the velocities that it has.
  /// Domain  a stone that is held.
  void release(StoneId id) {
    const std::size_t i = known(id);
    detail::World<T>& world = course_.world;
    detail::Member<T>& member = world.members[i];
    require(member.keeper == detail::Keeper::hand, "id", i, "must be that of a stone that is held");
    const State<T> now = world.state_at(member, world.now);
    member.w_W = Vec3<T>::Zero();
    course_.take_up(i, now);
  }

  /// What hands have done to other stones through one that they hold or held   [J].
  [[nodiscard]] const T& work(StoneId id) const { return course_.world.members[known(id)].work; }

  /// An impulse P at a point of W   [N s], on a stone that no hand holds.
  /// Domain  both finite; else InvalidArgument.
  void apply_impulse(StoneId id, const Vec3<T>& p_W, const Vec3<T>& P_W, SceneSink<T> sink = {}) {
    const std::size_t i = known(id);
    detail::World<T>& world = course_.world;
    detail::Member<T>& member = world.members[i];
    require(scalar::is_finite(p_W), "p_W", p_W.transpose(), "must be finite");
    require(scalar::is_finite(P_W), "P_W", P_W.transpose(), "must be finite");
    require(member.keeper != detail::Keeper::hand, "id", i, "is held by a hand, and no impulse moves it");
    world.sink = sink;
    if (member.keeper == detail::Keeper::cluster) {
      course_.wake(member.cluster);
      const State<T> before = member.state;
      member.state.v_WB = formula::plus(before.v_WB, member.mobility.linear, P_W);
      member.state.L_W = formula::plus(before.L_W, formula::cross(formula::minus(p_W, before.p_WB), P_W));
      world.tell(i, detail::no_index, EventKind::push, before, member.state, [&](Event<T>& event) {
        event.impulse_W = P_W;
        event.contact_W = p_W;
      });
    } else {
      Drop<T>& drop = member.keeper == detail::Keeper::rest ? course_.take_up(i, member.state) : course_.present(i);
      drop.apply_impulse(p_W, P_W, course_.sink_of(i, detail::no_index));
      course_.begin(i);
    }
    world.sink = {};
  }

  /// Other settings from now on, gravity among them. What rests wakes if they move it.
  /// Domain  settings in range.
  void change(const SceneSettings<T>& settings, SceneSink<T> sink = {}) {
    detail::World<T>& world = course_.world;
    require_settings(settings);
    for (const detail::Member<T>& member : world.members) {
      require_settings(settings.drop, member.stone);
    }
    world.sink = sink;
    world.given = world.settings = settings;
    if (!world.members.empty()) {
      fill(world.members.front().stone.width);
    }
    for (std::size_t i = 0; i < world.members.size(); ++i) {
      detail::Member<T>& member = world.members[i];
      if (member.keeper == detail::Keeper::cluster) {
        course_.wake(member.cluster);
      } else if (member.keeper == detail::Keeper::rest || member.keeper == detail::Keeper::drop) {
        Drop<T>& drop = member.keeper == detail::Keeper::rest ? course_.take_up(i, member.state) : course_.present(i);
        drop.change(settings.drop, course_.sink_of(i, detail::no_index));
        course_.begin(i);
      }
      if (member.keeper != detail::Keeper::removed) {
        resist(member);
      }
    }
    world.sink = {};
  }

 private:
  [[nodiscard]] StoneMode mode(std::size_t i) const {
    const detail::World<T>& world = course_.world;
    const detail::Member<T>& member = world.members[i];
    if (member.keeper == detail::Keeper::hand) {
      return StoneMode::held;
    }
    if (world.is_asleep(member)) {
      return StoneMode::rest;
    }
    if (member.keeper == detail::Keeper::cluster) {
      return StoneMode::cluster;
    }
    const auto& motion = world.drops[member.drop].stretch().motion;
    return std::holds_alternative<detail::Touching<T>>(motion) ? StoneMode::contact : StoneMode::flight;
  }

  /// What a stone alone touches.
  void alone(std::size_t i, std::vector<SceneContact<T>>& all) const {
    const detail::World<T>& world = course_.world;
    const detail::Member<T>& member = world.members[i];
    const State<T> now = world.state_at(member, world.now);
    const Pose<T> pose{now.p_WB, now.q_WB};
    const Separation<T> board = separation(member.stone, pose, world.board),
                        floor = separation(member.stone, pose, floor_of(world.board));
    const Separation<T>& contact = floor.gap < board.gap ? floor : board;
    SceneContact<T> found{StoneId(i), {}, contact.p_stone, contact.n_W, {}};
    const Vec3<T>& gravity = world.settings.drop.gravity;
    if (member.keeper == detail::Keeper::drop) {
      const Drop<T>& drop = world.drops[member.drop];
      const detail::Stretch<T>& stretch = drop.stretch();
      const Vec3<T> gain = formula::minus(drop.state_ahead(stretch.end).v_WB, drop.state_ahead(stretch.begin).v_WB);
      const T length = stretch.end - stretch.begin;
      found.force_W =
          formula::scaled(member.body.mass, formula::minus(formula::scaled(T(T(1) / length), gain), gravity));
    } else if (member.status == DropStatus::rest) {
      found.force_W = formula::scaled(T(-member.body.mass), gravity);
    } else {
      found.force_W = Vec3<T>::Constant(scalar::unset<T>());
    }
    all.push_back(found);
  }

  /// Throws InvalidArgument if a hand would move a stone into the board or the floor.
  void require_free_way(const detail::Member<T>& hand, const T& duration) const {
    const detail::World<T>& world = course_.world;
    const FlightPath<T> path = world.moving(hand).path;
    const auto require_free = [&](const auto& ground) {
      const TimeOfImpact<T> hit = time_of_impact(hand.stone, path, ground, duration);
      if (hit.status == ImpactStatus::none) {
        return;
      }
      const Vec3<T> arm = formula::minus(hit.contact.p_stone, formula::centre_at(path, hit.time));
      const T leaving = formula::dot(hit.contact.n_W, formula::plus(path.v_W, formula::cross(hand.w_W, arm)));
      require(T(-1e-6) * *world.settings.impact_speed <= leaving, "v_WB", path.v_W.transpose(),
              "moves the stone into what is below, ", hit.time, " s from now");
    };
    require_free(world.board);
    require_free(floor_of(world.board));
  }

  [[nodiscard]] std::size_t known(StoneId id) const {
    require(has(id), "id", static_cast<std::size_t>(id), "must be that of a stone of the scene");
    return static_cast<std::size_t>(id);
  }

  [[nodiscard]] static bool is_new(const detail::Member<T>& member) {
    return member.keeper == detail::Keeper::drop && member.fresh;
  }

  void fill(const T& width) {
    detail::World<T>& world = course_.world;
    world.settings = filled(world.given, width);
    const Vec3<T>& gravity = world.settings.drop.gravity;
    world.g = detail::strength_of(gravity, width, T(0));
    const T h = *world.settings.step;
    world.range = *world.settings.clearance + *world.settings.impact_speed * h + world.g * scalar::sq(h);
  }

  void resist(detail::Member<T>& member) {
    const DropSettings<T> all = filled(course_.world.settings.drop, member.stone, course_.world.g);
    const bool freely = !(T(0) < *all.rolling_resistance) && !(T(0) < *all.pivot_radius);
    const T &delta = *all.rolling_resistance, &kappa = *all.pivot_radius;
    member.rolling = freely ? T(0) : scalar::max(delta, T(kappa / T(100)));
    member.pivot = freely ? T(0) : scalar::max(kappa, T(delta / T(100)));
  }

  /// Throws InvalidArgument if a stone would overlap the board, the floor or another one.
  void require_free(const Stone<T>& stone, const State<T>& start) const {
    const detail::World<T>& world = course_.world;
    const Pose<T> pose{start.p_WB, start.q_WB};
    const T touching = world.settings.drop.touching * outer_width(stone);
    const auto require_apart = [&](const T& gap, const auto&... what) {
      require(-touching <= gap, "position", start.p_WB.transpose(), "overlaps ", what..., ", ", -gap, " m deep");
    };
    require_apart(separation(stone, pose, world.board).gap, "the board");
    require_apart(separation(stone, pose, floor_of(world.board)).gap, "the floor");
    const T reach = detail::greatest_reach(stone);
    world.near(start.p_WB, reach, [&](std::size_t j) {
      const State<T> there = state(StoneId(j));
      const Vec3<T> between = formula::minus(start.p_WB, there.p_WB);
      if (formula::dot(between, between) <= scalar::sq(T(reach + world.members[j].reach))) {
        require_apart(separation(stone, pose, world.members[j].stone, Pose<T>{there.p_WB, there.q_WB}).gap, "stone ",
                      std::to_string(j));
      }
    });
  }

  detail::SceneCourse<T> course_;
};

}  // namespace goishi
