#pragma once
/// \file
/// The stones of a scene, where they are and when pairs of them may touch.

#include <goishi/board/board.hpp>
#include <goishi/scene/pairs/first_touch.hpp>
#include <goishi/scene/settings.hpp>
#include <goishi/scene/world/agenda.hpp>
#include <goishi/scene/world/members.hpp>
#include <optional>

namespace goishi::detail {

template <Ordered T>
class World {
 public:
  Board<T> board;
  SceneSettings<T> given;     // as they were
  SceneSettings<T> settings;  // filled
  T g = T(0);                 // [m/s²] strength of gravity
  T range = T(0);             // [m] pairs that are further apart are not in a cluster's step
  T now = T(0);               // [s]
  std::vector<Member<T>> members;
  Slots<PairRecord<T>> pairs;
  Slots<Cluster<T>> clusters;
  Slots<Drop<T>> drops;
  Agenda<T> agenda;
  SceneCounters counters;
  SceneSink<T> sink;  // of the present call

  // --- where stones are

  [[nodiscard]] bool is_asleep(const Member<T>& member) const {
    return member.keeper == Keeper::rest || (member.keeper == Keeper::cluster && clusters[member.cluster].asleep);
  }

  [[nodiscard]] bool share_cluster(const Member<T>& a, const Member<T>& b) const {
    return a.keeper == Keeper::cluster && b.keeper == Keeper::cluster && a.cluster == b.cluster;
  }

  [[nodiscard]] State<T> state_at(const Member<T>& member, const T& time) const {
    const T t = time - member.time;
    if (member.keeper == Keeper::drop) {
      return drops[member.drop].state_ahead(time);
    }
    if (member.keeper == Keeper::hand) {
      State<T> state = member.state;
      state.p_WB = formula::plus(state.p_WB, t, state.v_WB);
      state.q_WB =
          formula::reunited(formula::product(formula::rotation_exp(formula::scaled(t, member.w_W)), member.state.q_WB));
      return state;
    }
    return T(0) < t && !is_asleep(member)
               ? formula::free_flight(member.state, member.mobility, Vec3<T>(Vec3<T>::Zero()), t)
               : member.state;
  }

  /// The same with a cluster's velocities, which are of the middles of steps, taken to the time, too.
  [[nodiscard]] State<T> seen_at(const Member<T>& member, const T& time) const {
    State<T> state = state_at(member, time);
    if (member.keeper == Keeper::cluster && !is_asleep(member)) {
      const T t = time - member.nominal;
      state.v_WB = formula::plus(state.v_WB, t, member.v_rate);
      state.L_W = formula::plus(state.L_W, t, member.L_rate);
    }
    return state;
  }

  [[nodiscard]] Vec3<T> centre_at(const Member<T>& member, const T& time) const {
    if (member.keeper == Keeper::drop) {
      return centre_of(drops[member.drop], time);
    }
    const Vec3<T>& p = member.state.p_WB;
    return is_asleep(member) ? p : formula::plus(p, T(time - member.time), member.state.v_WB);
  }

  /// How it moves as far as is known.
  [[nodiscard]] Moving<T> moving(const Member<T>& member) const {
    constexpr T never = std::numeric_limits<T>::infinity();
    if (member.keeper == Keeper::drop) {
      Moving<T> result = moving_of(drops[member.drop], member.mobility);
      result.speed = member.bounds.surface;
      result.end = scalar::min(result.end, member.bounds.until);
      return result;
    }
    Moving<T> result{.stone = &member.stone, .begin = member.time, .end = never, .speed = member.bounds.surface};
    result.path = path_of(member.state, member.mobility, Vec3<T>(Vec3<T>::Zero()));
    if (member.keeper == Keeper::hand) {
      const T rate = scalar::sqrt(formula::dot(member.w_W, member.w_W));
      result.path.rate = rate;
      result.path.k_W = T(0) < rate ? Vec3<T>(member.w_W / rate) : Vec3<T>(T(0), T(0), T(1));
      result.end = member.hand_end;
    } else if (is_asleep(member)) {
      result.path.v_W = Vec3<T>::Zero();
      result.path.rate = T(0);
    } else {
      result.end = clusters[member.cluster].end;
    }
    return result;
  }

  // --- neighbours

  /// How much nearer than a list of neighbours tells two stones may come before it is made again   [m].
  [[nodiscard]] T margin() const { return T(0.6) * widest_; }

  /// Takes a new stone's reach into account.
  void widen(const T& reach) {
    if (!(widest_ < reach)) {
      return;
    }
    widest_ = reach;
    grid_.reset(T(T(1.01) * (T(2) * widest_ + margin())));
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (members[i].place.linked) {
        grid_.link(i, T(members[i].place.x), T(members[i].place.y), places());
        meet_neighbours(i);
      }
    }
  }

  /// Where a stone is: its neighbours from here on.
  void settle_at(std::size_t i, const Vec3<T>& p) {
    if (members[i].place.linked) {
      grid_.unlink(i, places());
    }
    grid_.link(i, T(p.x()), T(p.y()), places());
    meet_neighbours(i);
  }

  void forget(std::size_t i) {
    grid_.unlink(i, places());
    while (!members[i].pairs.empty()) {
      drop_pair(members[i].pairs.back());
    }
    agenda.remove(DueKind::look, i);
    agenda.remove(DueKind::stretch, i);
  }

  /// Whether a stone is still where its neighbours were counted, or near.
  void look(std::size_t i, const T& time) {
    const Member<T>& member = members[i];
    const Vec3<T> p = centre_at(member, time);
    const T half = margin() / T(2);
    T away = scalar::sqrt(T(scalar::sq(T(p.x() - member.place.x)) + scalar::sq(T(p.y() - member.place.y))));
    if (T(0.5) * half < away) {
      settle_at(i, p);
      away = T(0);
    }
    if (T(0) < member.bounds.centre) {
      agenda.set(DueKind::look, i, T(time + (half - away) / member.bounds.centre));
    }
  }

  template <class F>
  void near(std::size_t i, F&& f) {
    grid_.near(i, places(), f);
  }
  /// All stones that one as large as `reach`, at a place, may touch, and some more.
  template <class F>
  void near(const Vec3<T>& p, const T& reach, F&& f) const {
    if (reach <= widest_) {
      grid_.near(
          T(p.x()), T(p.y()), [this](std::size_t i) -> const GridPlace<T>& { return members[i].place; }, f);
      return;
    }
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (members[i].place.linked) {
        f(i);
      }
    }
  }

  // --- pairs

  /// Bounds a stone's speeds. What was found with lower ones holds for less long.
  void bound_by(std::size_t i, const SpeedBounds<T>& speeds) {
    SpeedBounds<T>& bounds = members[i].bounds;
    bounds.until = speeds.until;
    const auto is_near = [](const T& speed, const T& bound) { return speed <= bound && T(0.25) * bound <= speed; };
    if (is_near(speeds.centre, bounds.centre) && is_near(speeds.surface, bounds.surface)) {
      return;
    }
    const bool higher = bounds.centre < speeds.centre || bounds.surface < speeds.surface;
    bounds = {T(T(1.4) * speeds.centre), T(T(1.4) * speeds.surface), speeds.until};
    if (higher) {
      agenda.set(DueKind::look, i, now);
      for (const std::size_t k : members[i].pairs) {
        if (!pairs[k].exact && !is_listed(pairs[k])) {
          hasten(k);
        }
      }
    }
  }

  /// The motion of a stone is another from now on. What was found by its bounds alone holds on.
  void turn(std::size_t i) {
    for (const std::size_t k : members[i].pairs) {
      if (pairs[k].exact && !is_listed(pairs[k])) {
        ask(k);
      }
    }
  }

  /// Whether a cluster's step takes care of the pair.
  [[nodiscard]] bool is_listed(const PairRecord<T>& pair) const {
    if (!pair.contact.listed) {
      return false;
    }
    const Member<T>&a = members[pair.first], &b = members[pair.second];
    return share_cluster(a, b) || (a.keeper == Keeper::cluster && b.keeper == Keeper::hand) ||
           (b.keeper == Keeper::cluster && a.keeper == Keeper::hand);
  }

  /// Looks at a pair now.
  void ask(std::size_t k) {
    pairs[k].touches = false;
    agenda.set(DueKind::pair, k, now);
  }

  /// How far the stones of a pair are apart, the normal out of the second.
  [[nodiscard]] Separation<T> apart(PairRecord<T>& pair, const Placed<T>& one, const Placed<T>& two) {
    ++counters.separations;
    Separation<T> found = separation(one, two);
    pair.n_W = found.n_W;
    return found;
  }

  /// A pair whose stones may be faster from now on has what is left of its way to go.
  void hasten(std::size_t k) {
    PairRecord<T>& pair = pairs[k];
    const SpeedBounds<T>&a = members[pair.first].bounds, &b = members[pair.second].bounds;
    const T speed = pair.of_centres ? T(a.centre + b.centre) : T(a.surface + b.surface);
    if (pair.speed < speed) {
      pair.due = now < pair.due && T(0) < pair.speed ? T(now + (pair.due - now) * (pair.speed / speed)) : now;
      pair.speed = speed;
      agenda.set(DueKind::pair, k, pair.due);
    }
  }

  /// When a pair has to be looked at again, or touches.
  void check(std::size_t k) {
    PairRecord<T>& pair = pairs[k];
    const Member<T>&a = members[pair.first], &b = members[pair.second];
    const bool by_hand = a.keeper == Keeper::hand && b.keeper == Keeper::hand;
    const T speed = a.bounds.surface + b.bounds.surface;
    if (is_listed(pair) || by_hand || !(T(0) < speed)) {
      pair.exact = true;  // until one of them moves in another way, or at all
      pair.touches = false;
      return;
    }
    ++counters.looks;
    const Vec3<T> between = formula::minus(centre_at(a, now), centre_at(b, now));
    const T spheres = scalar::sqrt(formula::dot(between, between)) - (a.reach + b.reach);
    if (T(2) * range < spheres) {  // and not by less and less
      if (!fly_apart(k, between)) {
        wait(k, T(spheres - range), T(a.bounds.centre + b.bounds.centre), true);
      }
      return;
    }
    const Moving<T> one = moving(a), two = moving(b);
    const T limit = one.end < two.end ? one.end : two.end;
    if (!(now < limit)) {  // a cluster's step is due now, which asks again
      pair.exact = true;
      pair.touches = false;
      return;
    }
    const Placed<T> first = sight(one, now).placed, second = sight(two, now).placed;
    if (T(0) < formula::dot(pair.n_W, pair.n_W)) {
      const T least = gap_along_normal(first, second, pair.n_W);
      if (T(2) * range < least && limit <= now + (least - range) / speed) {
        wait(k, T(least - range), speed, false);
        return;
      }
    }
    const Separation<T> apart = this->apart(pair, first, second);
    const T safe = (apart.gap - range) / speed;
    if (limit <= now + safe && T(2) * range < apart.gap) {
      wait(k, T(apart.gap - range), speed, false);
      return;
    }
    const FirstTouch<T> found = first_touch(one, two, now, limit, *settings.clearance, apart);
    counters.separations += found.separations;
    if (!found.touches && found.time <= now + safe) {
      wait(k, T(apart.gap - range), speed, false);
      return;
    }
    pair.touches = found.touches;
    pair.exact = true;
    pair.due = found.time;
    agenda.set(DueKind::pair, k, pair.due);
  }

  /// Two stones that both fly, and fall alike, meet no sooner than the spheres around them, which go straight on seen from each
  /// other. False if they do not.
  [[nodiscard]] bool fly_apart(std::size_t k, const Vec3<T>& between) {
    PairRecord<T>& pair = pairs[k];
    const Member<T>&a = members[pair.first], &b = members[pair.second];
    if (a.keeper != Keeper::drop || b.keeper != Keeper::drop) {
      return false;
    }
    const Stretch<T>&one = drops[a.drop].stretch(), &two = drops[b.drop].stretch();
    const auto *first = std::get_if<Flying<T>>(&one.motion), *second = std::get_if<Flying<T>>(&two.motion);
    if (first == nullptr || second == nullptr || first->gravity != second->gravity) {
      return false;
    }
    const Vec3<T> v =
        formula::plus(formula::minus(first->from.v_WB, second->from.v_WB), T(two.begin - one.begin), first->gravity);
    const T limit = one.end < two.end ? one.end : two.end;
    const T meets = now + meeting_time(between, v, T(a.reach + b.reach + range));
    pair.touches = false;
    pair.exact = true;
    pair.due = meets < limit ? meets : limit;
    agenda.set(DueKind::pair, k, pair.due);
    return true;
  }

  /// Nothing happens to a pair until its stones, or only their centres, have come nearer by a length.
  void wait(std::size_t k, const T& length, const T& speed, bool of_centres) {
    PairRecord<T>& pair = pairs[k];
    pair.touches = pair.exact = false;
    pair.of_centres = of_centres;
    pair.speed = speed;
    pair.due = now + length / speed;
    agenda.set(DueKind::pair, k, pair.due);
  }

  // --- clusters

  [[nodiscard]] std::size_t new_cluster() { return clusters.add({}); }

  void drop_cluster(std::size_t c) {
    clusters[c].members.clear();
    agenda.remove(DueKind::step, c);
    clusters.remove(c);
  }

  // --- what is told

  template <class Fill>
  void tell(std::size_t i, std::size_t other, EventKind kind, const State<T>& before, const State<T>& after,
            Fill&& fill) {
    if (!sink) {
      return;
    }
    SceneEvent<T> event{.stone = StoneId(i), .other = {}, .event = {}};
    if (other != no_index) {
      event.other = StoneId(other);
    }
    event.event.kind = kind;
    event.event.time = now;
    event.event.before = before;
    event.event.after = after;
    event.event.energy = formula::energy(after, members[i].body, settings.drop.gravity);
    fill(event.event);
    sink(event);
  }

  void tell(std::size_t i, std::size_t other, EventKind kind, const State<T>& state) {
    tell(i, other, kind, state, state, [](Event<T>&) {});
  }

 private:
  [[nodiscard]] auto places() {
    return [this](std::size_t i) -> GridPlace<T>& { return members[i].place; };
  }

  /// Whether two stones may touch before either is counted again.
  [[nodiscard]] bool are_near(const Member<T>& a, const Member<T>& b) const {
    const T most = a.reach + b.reach + margin();
    return scalar::sq(T(a.place.x - b.place.x)) + scalar::sq(T(a.place.y - b.place.y)) < scalar::sq(most);
  }

  void meet_neighbours(std::size_t i) {
    for (std::size_t at = members[i].pairs.size(); at-- > 0;) {
      const std::size_t k = members[i].pairs[at];
      if (!are_near(members[pairs[k].first], members[pairs[k].second])) {
        drop_pair(k);
      }
    }
    near(i, [&](std::size_t j) {
      if (i == j || !are_near(members[i], members[j])) {
        return;
      }
      const std::size_t first = i < j ? i : j, second = i < j ? j : i;
      for (const std::size_t k : members[i].pairs) {
        if (pairs[k].first == first && pairs[k].second == second) {
          return;
        }
      }
      PairRecord<T> pair;
      pair.first = first;
      pair.second = second;
      const std::size_t k = pairs.add(pair);
      members[i].pairs.push_back(k);
      members[j].pairs.push_back(k);
      ask(k);
    });
  }

  void drop_pair(std::size_t k) {
    PairRecord<T>& pair = pairs[k];
    for (const std::size_t i : {pair.first, pair.second}) {
      std::vector<std::size_t>& list = members[i].pairs;
      list.erase(std::find(list.begin(), list.end(), k));
    }
    agenda.remove(DueKind::pair, k);
    pairs.remove(k);
  }

  Grid<T> grid_;
  T widest_ = T(0);  // [m] greatest reach
};

}  // namespace goishi::detail
