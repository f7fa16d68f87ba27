#include <algorithm>
#include <cstddef>
#include <goishi/scene/scene.hpp>
#include <vector>

#include "drop_settings.hpp"

struct goishi_scene {
  goishi::Scene<double> scene;
};

namespace goishi::c {

namespace {

static_assert(is(StoneMode::flight, GOISHI_MODE_FLIGHT) && is(StoneMode::contact, GOISHI_MODE_CONTACT) &&
              is(StoneMode::cluster, GOISHI_MODE_CLUSTER) && is(StoneMode::rest, GOISHI_MODE_REST) &&
              is(StoneMode::held, GOISHI_MODE_HELD));

[[nodiscard]] SceneSettings<double> read_scene_settings(const double* pointer, std::size_t size) {
  const auto a = read<GOISHI_SCENE_SETTINGS_SIZE>("settings", pointer, size);
  SceneSettings<double> settings;
  settings.drop = drop_settings(a.data());
  settings.restitution = a[GOISHI_STONES_RESTITUTION];
  settings.friction = a[GOISHI_STONES_FRICTION];
  settings.step = setting(a[GOISHI_STEP]);
  settings.solver_tolerance = a[GOISHI_SOLVER_TOLERANCE];
  settings.clearance = setting(a[GOISHI_CLEARANCE]);
  settings.impact_speed = setting(a[GOISHI_IMPACT_SPEED]);
  settings.leaving_time = setting(a[GOISHI_LEAVING_TIME]);
  return settings;
}

}  // namespace
}  // namespace goishi::c

using namespace goishi;
using namespace goishi::c;

extern "C" {

int goishi_scene_settings(double* settings, size_t settings_size) {
  return guarded([&] {
    require_array("settings", settings, settings_size, GOISHI_SCENE_SETTINGS_SIZE);
    const SceneSettings<double> own;
    std::vector<double> row;
    put_settings(Row(row), own.drop);
    Row(row) << own.restitution << own.friction << value_of(own.step) << own.solver_tolerance << value_of(own.clearance)
             << value_of(own.impact_speed) << value_of(own.leaving_time);
    write(row, settings);
  });
}

int goishi_scene_create(const double* board, size_t board_size, const double* settings, size_t settings_size,
                        goishi_scene** scene) {
  return guarded([&] {
    const Board<double> on = read_board("board", board, board_size);
    const SceneSettings<double> chosen_settings = read_scene_settings(settings, settings_size);
    require_pointer("scene", scene);
    *scene = new goishi_scene{Scene<double>(on, chosen_settings)};
  });
}

int goishi_scene_copy(const goishi_scene* scene, goishi_scene** copy) {
  return guarded([&] {
    require_pointer("scene", scene);
    require_pointer("copy", copy);
    *copy = new goishi_scene(*scene);
  });
}

void goishi_scene_free(goishi_scene* scene) {
  delete scene;
}

int goishi_scene_add(goishi_scene* scene, const double* stone, size_t stone_size, const double* state,
                     size_t state_size, size_t* id) {
  return guarded([&] {
    require_pointer("scene", scene);
    const Body body = read_stone("stone", stone, stone_size);
    const State<double> start = read_state("state", state, state_size);
    require_pointer("id", id);
    *id = static_cast<std::size_t>(scene->scene.add(body.stone, body.rigid(), start));
  });
}

int goishi_scene_remove(goishi_scene* scene, size_t id) {
  return guarded([&] {
    require_pointer("scene", scene);
    scene->scene.remove(StoneId(id));
  });
}

int goishi_scene_advance(goishi_scene* scene, double dt) {
  return guarded([&] {
    require_pointer("scene", scene);
    scene->scene.advance(dt);
  });
}

int goishi_scene_advance_to(goishi_scene* scene, double time) {
  return guarded([&] {
    require_pointer("scene", scene);
    scene->scene.advance_to(time);
  });
}

int goishi_scene_run_until_rest(goishi_scene* scene, double horizon) {
  return guarded([&] {
    require_pointer("scene", scene);
    static_cast<void>(scene->scene.run_until_rest(horizon));
  });
}

int goishi_scene_push(goishi_scene* scene, size_t id, const double* point, size_t point_size, const double* impulse,
                      size_t impulse_size) {
  return guarded([&] {
    require_pointer("scene", scene);
    const Vec p_W = read_vector("point", point, point_size), P_W = read_vector("impulse", impulse, impulse_size);
    scene->scene.apply_impulse(StoneId(id), p_W, P_W);
  });
}

int goishi_scene_hold(goishi_scene* scene, size_t id, const double* velocity, size_t velocity_size, const double* spin,
                      size_t spin_size, double duration) {
  return guarded([&] {
    require_pointer("scene", scene);
    const Vec v_WB = read_vector("velocity", velocity, velocity_size), w_WB = read_vector("spin", spin, spin_size);
    scene->scene.hold(StoneId(id), v_WB, w_WB, duration);
  });
}

int goishi_scene_release(goishi_scene* scene, size_t id) {
  return guarded([&] {
    require_pointer("scene", scene);
    scene->scene.release(StoneId(id));
  });
}

int goishi_scene_change(goishi_scene* scene, const double* settings, size_t settings_size) {
  return guarded([&] {
    require_pointer("scene", scene);
    scene->scene.change(read_scene_settings(settings, settings_size));
  });
}

int goishi_scene_info(const goishi_scene* scene, double* info, size_t info_size) {
  return guarded([&] {
    require_pointer("scene", scene);
    require_array("info", info, info_size, GOISHI_SCENE_SIZE);
    const Scene<double>& one = scene->scene;
    const SceneCounters& c = one.counters();
    double moving = 0.0;
    const std::vector<StoneId> ids = one.stones();
    for (const StoneId id : ids) {
      moving += as_number(one.mode(id) != StoneMode::rest);
    }
    std::vector<double> row;
    Row(row) << one.time() << static_cast<double>(ids.size()) << moving << one.energy();
    for (const long long count : {c.stretches, c.looks, c.separations, c.pair_impacts, c.joins, c.steps, c.stone_steps,
                                  c.cut_steps, c.retries, c.solves, c.sweeps, c.updates, c.unsolved, c.rest_trials}) {
      Row(row) << static_cast<double>(count);
    }
    write(row, info);
  });
}

int goishi_scene_stones(const goishi_scene* scene, size_t first, double* rows, size_t rows_size) {
  return guarded([&] {
    require_pointer("scene", scene);
    const std::size_t count = count_rows("rows", rows, rows_size, GOISHI_SCENE_STONE_SIZE);
    const Scene<double>& one = scene->scene;
    const std::vector<StoneId> ids = one.stones();
    require(first <= ids.size() && count <= ids.size() - first, "first", first, "must have ", count,
            " stones from there on, and there are ", ids.size());
    const Vec gravity = one.settings().drop.gravity;
    std::vector<double> result;
    result.reserve(rows_size);
    for (std::size_t i = first; i < first + count; ++i) {
      const StoneId id = ids[i];
      Row(result) << static_cast<double>(static_cast<std::size_t>(id)) << as_number(one.mode(id)) << one.work(id);
      put_motion(Row(result), one.state(id), one.body(id), gravity);
    }
    write(result, rows);
  });
}

int goishi_scene_contacts(const goishi_scene* scene, double* rows, size_t rows_size, size_t* count) {
  return guarded([&] {
    require_pointer("scene", scene);
    const std::size_t room = count_rows("rows", rows, rows_size, GOISHI_SCENE_CONTACT_SIZE);
    require_pointer("count", count);
    const std::vector<SceneContact<double>> contacts = scene->scene.contacts();
    std::vector<double> result;
    for (std::size_t i = 0; i < std::min(room, contacts.size()); ++i) {
      const SceneContact<double>& one = contacts[i];
      Row(result) << static_cast<double>(static_cast<std::size_t>(one.stone))
                  << (one.other ? static_cast<double>(static_cast<std::size_t>(*one.other)) : -1.0) << one.p_WC
                  << one.n_W << one.force_W;
    }
    write(result, rows);
    *count = contacts.size();
  });
}

}  // extern "C"
