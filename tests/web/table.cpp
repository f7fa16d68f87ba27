/// Calls of the C interface with what they give, as JSON: for WebAssembly to be compared with, to the last bit. A case is
///
///     {"function": "goishi_measures", "arguments": [{"in": [bits]}, {"out": 19}], "result": [bits]}
///
/// A number is its 64 bits in hexadecimal. The function "drop" is `goishi_drop_create`, `_advance` and `_info`; "scene" is
/// `goishi_scene_create`, `_add` for each stone and its state, `_advance` a hundred times, and `_stones`.

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "case.hpp"
#include "goishi.h"

namespace {

constexpr double v = 0.5, L = 1e-6;  // scales of a stone

class Samples {
 public:
  [[nodiscard]] double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  [[nodiscard]] List vector(double size) {
    const double x = between(-size, size), y = between(-size, size), z = between(-size, size);
    return {x, y, z};
  }

  /// Sharp, bevelled, measured, of given mass.
  [[nodiscard]] List stone() {
    const int kind = kind_++ % 4;
    const double width = between(0.01, 0.03), height = width * between(0.1, 1.0), part = between(0.05, 0.9);
    const double density = between(1000.0, 4000.0), mass = between(0.001, 0.01);
    return {width,
            height,
            kind % 2 == 0 ? height * part : 0.0,
            kind == 2 ? 1.0 : 0.0,
            kind == 3 ? 0.0 : density,
            kind == 3 ? mass : 0.0};
  }

  [[nodiscard]] List state() {
    const List p = vector(0.01), u = vector(1.0), rate = vector(v), momentum = vector(L);
    const double length = std::sqrt(1.0 + u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    return {p[0],    p[1],    0.05 + p[2], 1.0 / length, u[0] / length, u[1] / length, u[2] / length,
            rate[0], rate[1], rate[2],     momentum[0],  momentum[1],   momentum[2]};
  }

  [[nodiscard]] static List unit(const List& u) {
    const double length = std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    return {u[0] / length, u[1] / length, u[2] / length};
  }

 private:
  std::mt19937_64 random_{33};
  int kind_ = 0;
};

#define AS_ARRAY(list) (list).data(), (list).size()

const List gravity = {0.0, 0.0, -9.80665}, plane = {0.0, 0.0, 1.0, 0.0};

[[nodiscard]] List pose_of(const List& state) {
  return {state.begin(), state.begin() + GOISHI_POSE_SIZE};
}

}  // namespace

int main() {
  Samples samples;
  List board(GOISHI_BOARD_SIZE), settings(GOISHI_SETTINGS_SIZE);
  Case("goishi_board").out(board.size()).gives(goishi_board(AS_ARRAY(board)), board);
  const int settings_status = goishi_settings(AS_ARRAY(settings));
  Case("goishi_settings").out(settings.size()).gives(settings_status, settings);
  for (const int number : {22, 25, 28, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40}) {
    for (const int color : {GOISHI_WHITE, GOISHI_BLACK}) {
      List stone(GOISHI_STONE_SIZE);
      const int status = goishi_catalogue_stone(number, color, 0.001, AS_ARRAY(stone));
      Case("goishi_catalogue_stone").whole(number).whole(color).number(0.001).out(stone.size()).gives(status, stone);
    }
  }
  for (int i = 0; i < 150; ++i) {
    const List stone = samples.stone();
    List measures(GOISHI_MEASURES_SIZE);
    const int status = goishi_measures(AS_ARRAY(stone), AS_ARRAY(measures));
    Case("goishi_measures").in(stone).out(measures.size()).gives(status, measures);
  }
  Samples others;  // so that the cases below stay as they are
  for (int i = 0; i < 20; ++i) {
    const List stone = others.stone(), state = others.state(), pose = pose_of(state);
    List published(GOISHI_PUBLISHED_MEASURES_SIZE), tensor(9), rotation(7);
    int status = goishi_published_measures(AS_ARRAY(stone), AS_ARRAY(published));
    Case("goishi_published_measures").in(stone).out(published.size()).gives(status, published);
    status = goishi_tensor(AS_ARRAY(stone), AS_ARRAY(pose), AS_ARRAY(tensor));
    Case("goishi_tensor").in(stone).in(pose).out(9).gives(status, tensor);
    const List moments = {2e-7, others.between(1.1e-7, 3e-7)}, attitude(state.begin() + 3, state.begin() + 7),
               momentum(state.begin() + GOISHI_MOMENTUM, state.end());
    status = goishi_free_rotation(AS_ARRAY(moments), AS_ARRAY(attitude), AS_ARRAY(momentum), 0.25, AS_ARRAY(rotation));
    Case("goishi_free_rotation").in(moments).in(attitude).in(momentum).number(0.25).out(7).gives(status, rotation);
    const List place = {0.01, 0.02, 0.03, 1.0, attitude[1], attitude[2], attitude[3]}, spin = others.vector(20.0);
    List start(GOISHI_STATE_SIZE);
    status = goishi_state(AS_ARRAY(stone), AS_ARRAY(place), AS_ARRAY(gravity), AS_ARRAY(spin), AS_ARRAY(start));
    Case("goishi_state").in(stone).in(place).in(gravity).in(spin).out(start.size()).gives(status, start);
  }
  for (int i = 0; i < 150; ++i) {
    const List stone = samples.stone(), other = samples.stone(), state = samples.state(), other_state = samples.state();
    const List pose = pose_of(state), other_pose = pose_of(other_state);
    List separation(GOISHI_SEPARATION_SIZE), talk(GOISHI_PUBLISHED_SEPARATION_SIZE);
    List at_edge = pose;
    at_edge[0] += 0.21;
    at_edge[2] -= 0.05;
    int status = goishi_separation(AS_ARRAY(stone), AS_ARRAY(pose), AS_ARRAY(plane), AS_ARRAY(separation));
    Case("goishi_separation").in(stone).in(pose).in(plane).out(separation.size()).gives(status, separation);
    status = goishi_separation(AS_ARRAY(stone), AS_ARRAY(at_edge), AS_ARRAY(board), AS_ARRAY(separation));
    Case("goishi_separation").in(stone).in(at_edge).in(board).out(separation.size()).gives(status, separation);
    status = goishi_published_separation(AS_ARRAY(stone), AS_ARRAY(at_edge), AS_ARRAY(board), AS_ARRAY(talk));
    Case published("goishi_published_separation");
    published.in(stone).in(at_edge).in(board).out(talk.size()).gives(status, talk);
    status = goishi_separation_stones(AS_ARRAY(stone), AS_ARRAY(pose), AS_ARRAY(other), AS_ARRAY(other_pose),
                                      AS_ARRAY(separation));
    Case stones("goishi_separation_stones");
    stones.in(stone).in(pose).in(other).in(other_pose).out(separation.size()).gives(status, separation);
  }
  for (int i = 0; i < 144; ++i) {
    const List stone = samples.stone(), state = samples.state();
    const int scheme = i % 9;
    const double step = samples.between(1e-4, 2e-3);
    List rows(4 * GOISHI_FLIGHT_SIZE);
    std::size_t done = 0;
    int ended = -1;
    const int status = goishi_flight(AS_ARRAY(stone), AS_ARRAY(state), AS_ARRAY(gravity), GOISHI_BOTH, scheme, step, 9,
                                     AS_ARRAY(rows), &done, &ended);
    Case("goishi_flight")
        .in(stone)
        .in(state)
        .in(gravity)
        .whole(GOISHI_BOTH)
        .whole(scheme)
        .number(step)
        .whole(9)
        .out(rows.size())
        .one()
        .one()
        .gives(status, rows);
  }
  for (int i = 0; i < 60; ++i) {
    const List stone = samples.stone(), state = samples.state();
    const double time = samples.between(-1.0, 1.0);
    List there(GOISHI_MOTION_SIZE);
    const int status =
        goishi_free_flight(AS_ARRAY(stone), AS_ARRAY(state), AS_ARRAY(gravity), GOISHI_BOTH, time, AS_ARRAY(there));
    Case("goishi_free_flight")
        .in(stone)
        .in(state)
        .in(gravity)
        .whole(GOISHI_BOTH)
        .number(time)
        .out(there.size())
        .gives(status, there);
  }
  for (int i = 0; i < 60; ++i) {
    const List stone = samples.stone(), state = samples.state();
    List hit(GOISHI_HIT_SIZE);
    const int status = goishi_time_of_impact(AS_ARRAY(stone), AS_ARRAY(state), AS_ARRAY(gravity), AS_ARRAY(plane), 10.0,
                                             AS_ARRAY(hit));
    Case("goishi_time_of_impact")
        .in(stone)
        .in(state)
        .in(gravity)
        .in(plane)
        .number(10.0)
        .out(hit.size())
        .gives(status, hit);
  }
  for (int i = 0; i < 120; ++i) {
    const List stone = samples.stone(), state = samples.state(), normal = Samples::unit(samples.vector(1.0));
    const List arm = samples.vector(0.01), point = {state[0] + arm[0], state[1] + arm[1], state[2] + arm[2]};
    const double e = samples.between(0.0, 1.0), mu = samples.between(0.0, 0.5);
    List impact(GOISHI_IMPACT_SIZE);
    const int status = goishi_impact(AS_ARRAY(stone), AS_ARRAY(state), i % 3, e, mu, AS_ARRAY(point), AS_ARRAY(normal),
                                     AS_ARRAY(impact));
    Case("goishi_impact")
        .in(stone)
        .in(state)
        .whole(i % 3)
        .number(e)
        .number(mu)
        .in(point)
        .in(normal)
        .out(impact.size())
        .gives(status, impact);
  }
  for (int i = 0; i < 40; ++i) {
    const List stone = samples.stone();
    std::vector<int> fineness(GOISHI_FINENESS_SIZE);
    List figures(GOISHI_MESH_FIGURES_SIZE);
    const int fineness_status = goishi_fineness(AS_ARRAY(stone), i % 2, i % 4, 0.0, AS_ARRAY(fineness));
    const int status = goishi_mesh_figures(AS_ARRAY(stone), i % 2, AS_ARRAY(fineness), i % 3, AS_ARRAY(figures));
    Case("goishi_mesh_figures")
        .in(stone)
        .whole(i % 2)
        .ints(fineness)
        .whole(i % 3)
        .out(figures.size())
        .gives(fineness_status + status, figures);
  }
  // A drop for a fifth of a second: falls, bounces, contact.
  for (int i = 0; i < 24; ++i) {
    const List stone = samples.stone(), state = samples.state();
    List info(GOISHI_DROP_SIZE);
    goishi_drop* drop = nullptr;
    int status = goishi_drop_create(AS_ARRAY(stone), AS_ARRAY(state), AS_ARRAY(board), AS_ARRAY(settings), 100, &drop);
    status += goishi_drop_advance(drop, 0.2) + goishi_drop_info(drop, AS_ARRAY(info));
    goishi_drop_free(drop);
    Case("drop").in(stone).in(state).in(board).in(settings).number(0.2).out(info.size()).gives(status, info);
  }
  // Some stones fall on one another, for a hundred steps: impacts, clusters.
  List scene_settings(GOISHI_SCENE_SETTINGS_SIZE);
  const int scene_settings_status = goishi_scene_settings(AS_ARRAY(scene_settings));
  Case("goishi_scene_settings").out(scene_settings.size()).gives(scene_settings_status, scene_settings);
  scene_settings[GOISHI_TOLERANCE] = 1e-6;
  for (int i = 0; i < 8; ++i) {
    List stones, rows(6 * GOISHI_SCENE_STONE_SIZE);
    goishi_scene* scene = nullptr;
    int status = goishi_scene_create(AS_ARRAY(board), AS_ARRAY(scene_settings), &scene);
    for (int k = 0; k < 6; ++k) {
      const List stone = samples.stone();
      List state = samples.state();
      state[2] += 0.04 * k - 0.02;
      std::size_t id = 0;
      status += goishi_scene_add(scene, AS_ARRAY(stone), AS_ARRAY(state), &id);
      stones.insert(stones.end(), stone.begin(), stone.end());
      stones.insert(stones.end(), state.begin(), state.end());
    }
    for (int k = 0; k < 100; ++k) {
      status += goishi_scene_advance(scene, 0.004);
    }
    status += goishi_scene_stones(scene, 0, AS_ARRAY(rows));
    goishi_scene_free(scene);
    Case("scene").in(board).in(scene_settings).in(stones).number(0.004).out(rows.size()).gives(status, rows);
  }
  std::printf("\n]\n");
  return 0;
}
