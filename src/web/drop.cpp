#include <cstddef>
#include <goishi/drop/drop.hpp>
#include <goishi/drop/holds.hpp>
#include <limits>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "drop_settings.hpp"

struct goishi_drop {
  goishi::Drop<double> drop;
  std::vector<goishi::Event<double>> events;
};

namespace goishi::c {

namespace {

static_assert(is(DropStatus::rest, GOISHI_REST) && is(DropStatus::rest_leaning, GOISHI_REST_LEANING) &&
              is(DropStatus::moving, GOISHI_MOVING) && is(DropStatus::flies_on, GOISHI_FLIES_ON) &&
              is(DropStatus::start_inside, GOISHI_START_INSIDE) &&
              is(DropStatus::too_many_events, GOISHI_TOO_MANY_EVENTS) &&
              is(DropStatus::too_many_steps, GOISHI_TOO_MANY_STEPS) &&
              is(DropStatus::not_converged, GOISHI_DROP_NOT_CONVERGED));
static_assert(is(Ground::none, GOISHI_GROUND_NONE) && is(Ground::board, GOISHI_GROUND_BOARD) &&
              is(Ground::floor, GOISHI_GROUND_FLOOR));
static_assert(is(EventKind::start, GOISHI_KIND_START) && is(EventKind::impact, GOISHI_KIND_IMPACT) &&
              is(EventKind::bounces_close, GOISHI_KIND_BOUNCES_CLOSE) && is(EventKind::contact, GOISHI_KIND_CONTACT) &&
              is(EventKind::stick, GOISHI_KIND_STICK) && is(EventKind::slip, GOISHI_KIND_SLIP) &&
              is(EventKind::feature, GOISHI_KIND_FEATURE) && is(EventKind::jam, GOISHI_KIND_JAM) &&
              is(EventKind::lift_off, GOISHI_KIND_LIFT_OFF) && is(EventKind::board_edge, GOISHI_KIND_BOARD_EDGE) &&
              is(EventKind::side, GOISHI_KIND_SIDE) && is(EventKind::rest, GOISHI_KIND_REST) &&
              is(EventKind::woken, GOISHI_KIND_WOKEN) && is(EventKind::push, GOISHI_KIND_PUSH));
static_assert(is(Side::before, GOISHI_BEFORE) && is(Side::after, GOISHI_AFTER));

[[nodiscard]] std::vector<double> motion_of(const goishi_drop& drop, const State<double>& state) {
  std::vector<double> result;
  put_motion(Row(result), state, drop.drop.body(), drop.drop.settings().gravity);
  return result;
}

}  // namespace
}  // namespace goishi::c

using namespace goishi;
using namespace goishi::c;

extern "C" {

int goishi_settings(double* settings, size_t settings_size) {
  return guarded([&] {
    require_array("settings", settings, settings_size, GOISHI_SETTINGS_SIZE);
    std::vector<double> row;
    put_settings(Row(row), DropSettings<double>{});
    write(row, settings);
  });
}

int goishi_drop_create(const double* stone, size_t stone_size, const double* state, size_t state_size,
                       const double* ground, size_t ground_size, const double* settings, size_t settings_size,
                       size_t kept, goishi_drop** drop) {
  return guarded([&] {
    const Body body = read_stone("stone", stone, stone_size);
    const State<double> start = read_state("state", state, state_size);
    const Obstacle on = read_ground(ground, ground_size);
    const DropSettings<double> chosen_settings = read_settings(settings, settings_size);
    require_pointer("drop", drop);
    if (const auto* plane = std::get_if<Plane<double>>(&on)) {
      require(plane->n_W == Vec(0.0, 0.0, 1.0) && plane->offset == 0.0, "ground", plane->n_W.transpose(),
              "must be a board, or the plane with the normal 0 0 1 and the offset 0 (its normal is shown)");
    }
    const auto* board = std::get_if<Board<double>>(&on);
    Drop<double> made = board != nullptr ? Drop<double>(body.stone, body.rigid(), start, *board, chosen_settings)
                                         : Drop<double>(body.stone, body.rigid(), start, chosen_settings);
    made.keep_motion(kept);
    *drop = new goishi_drop{std::move(made), {}};
  });
}

int goishi_drop_copy(const goishi_drop* drop, goishi_drop** copy) {
  return guarded([&] {
    require_pointer("drop", drop);
    require_pointer("copy", copy);
    *copy = new goishi_drop(*drop);
  });
}

void goishi_drop_free(goishi_drop* drop) {
  delete drop;
}

int goishi_drop_advance(goishi_drop* drop, double dt) {
  return guarded([&] {
    require_pointer("drop", drop);
    if (dt == std::numeric_limits<double>::infinity()) {
      static_cast<void>(drop->drop.advance_to_rest(drop->events));
    } else {
      static_cast<void>(drop->drop.advance(dt, drop->events));
    }
  });
}

int goishi_drop_push(goishi_drop* drop, const double* point, size_t point_size, const double* impulse,
                     size_t impulse_size) {
  return guarded([&] {
    require_pointer("drop", drop);
    const Vec p_W = read_vector("point", point, point_size), P_W = read_vector("impulse", impulse, impulse_size);
    drop->drop.apply_impulse(p_W, P_W, drop->events);
  });
}

int goishi_drop_change(goishi_drop* drop, const double* settings, size_t settings_size) {
  return guarded([&] {
    require_pointer("drop", drop);
    drop->drop.change(read_settings(settings, settings_size), drop->events);
  });
}

int goishi_drop_info(const goishi_drop* drop, double* info, size_t info_size) {
  return guarded([&] {
    require_pointer("drop", drop);
    require_array("info", info, info_size, GOISHI_DROP_SIZE);
    const Drop<double>& one = drop->drop;
    const DropCounters& counters = one.counters();
    std::vector<double> row;
    Row(row) << one.time() << as_number(one.status()) << as_number(one.ground()) << one.depth()
             << as_number(one.lower_order()) << one.motion_begin() << static_cast<double>(one.kept())
             << static_cast<double>(drop->events.size());
    for (const int count :
         {counters.impacts, counters.root_steps, counters.separations, counters.contact_evaluations,
          counters.steps_accepted, counters.steps_rejected, counters.evaluations_located, counters.edge_impacts}) {
      Row(row) << static_cast<double>(count);
    }
    write(row, info);
    write(motion_of(*drop, one.state()), info + GOISHI_DROP_MOTION);
  });
}

int goishi_drop_events(const goishi_drop* drop, size_t first, double* rows, size_t rows_size) {
  return guarded([&] {
    require_pointer("drop", drop);
    const std::size_t count = count_rows("rows", rows, rows_size, GOISHI_EVENT_SIZE);
    const std::vector<Event<double>>& events = drop->events;
    require(first <= events.size() && count <= events.size() - first, "first", first, "must have ", count,
            " events from there on, and there are ", events.size());
    std::vector<double> result;
    for (std::size_t i = first; i < first + count; ++i) {
      const Event<double>& event = events[i];
      Row(result) << as_number(event.kind) << event.time << event.energy << event.impulse_W << event.contact_W
                  << event.normal_W << as_number(event.feature) << as_number(event.other_feature)
                  << as_number(event.outcome) << event.before << event.after;
    }
    write(result, rows);
  });
}

int goishi_drop_motions(const goishi_drop* drop, const double* times, size_t times_size, int side, double* motions,
                        size_t motions_size) {
  return guarded([&] {
    require_pointer("drop", drop);
    require_pointer("times", times);
    const Side which = chosen("side", side, Side::after);
    const std::size_t count = count_rows("motions", motions, motions_size, GOISHI_MOTION_SIZE);
    require(times_size == count, "times_size", times_size, "must be that of motions, ", count, " of them");
    std::vector<double> result;
    for (std::size_t i = 0; i < count; ++i) {
      const std::vector<double> motion = motion_of(*drop, drop->drop.state_at(times[i], which));
      result.insert(result.end(), motion.begin(), motion.end());
    }
    write(result, motions);
  });
}

int goishi_holds(const double* stone, size_t stone_size, const double* pose, size_t pose_size, const double* ground,
                 size_t ground_size, const double* settings, size_t settings_size, double* hold, size_t hold_size) {
  return guarded([&] {
    const Stone<double> shape = read_stone("stone", stone, stone_size).stone;
    const Pose<double> there = read_pose("pose", pose, pose_size);
    const Obstacle on = read_ground(ground, ground_size);
    const DropSettings<double> chosen_settings = read_settings(settings, settings_size);
    require_array("hold", hold, hold_size, GOISHI_HOLD_SIZE);
    const Hold<double> found =
        std::visit([&](const auto& one) { return holds(shape, there, one, chosen_settings); }, on);
    write({as_number(found.holds), static_cast<double>(found.contacts), found.gap, found.friction, found.resistance,
           found.tilt},
          hold);
  });
}

}  // extern "C"
