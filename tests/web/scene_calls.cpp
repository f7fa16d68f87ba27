#include <climits>
#include <cstdlib>
#include <vector>

#include "tests/web/call_parts.hpp"

namespace goishi::web_test {

namespace {

const Array the_scene = in("scene", {0.0}, Kind::scene);

std::vector<double> scene_settings() {
  std::vector<double> result(GOISHI_SCENE_SETTINGS_SIZE);
  if (goishi_scene_settings(result.data(), result.size()) != GOISHI_OK) {
    std::abort();
  }
  return result;
}

}  // namespace

/// The stones of `busy_scene` are 0, 1 and 2.
std::vector<Call> scene_calls() {
  const auto id = [](long long value, std::vector<long long> bad = {}) {
    bad.insert(bad.end(), {3, LLONG_MAX, -1});
    return Whole{"id", value, bad};
  };
  return {
      {"goishi_scene_settings",
       {out("settings", GOISHI_SCENE_SETTINGS_SIZE)},
       {},
       {},
       arrays_only<goishi_scene_settings, 1>},
      {"goishi_scene_create",
       {in("board", board), in("settings", scene_settings()), out("scene", 1, false, Kind::new_scene)},
       {},
       {},
       [](const Views& a, const Wholes&, const Scalars&) {
         return goishi_scene_create(a[0].numbers(), a[0].size, a[1].numbers(), a[1].size, a[2].new_scene());
       }},
      {"goishi_scene_copy",
       {the_scene, out("copy", 1, false, Kind::new_scene)},
       {},
       {},
       [](const Views& a, const Wholes&, const Scalars&) { return goishi_scene_copy(a[0].scene(), a[1].new_scene()); }},
      {"goishi_scene_add",
       {the_scene, in("stone", stone),
        in("state", {-0.05, 0.03, 0.03, 0.8, 0.6, 0.0, 0.0, 0.1, 0.0, -0.2, 1e-6, -2e-6, 3e-6}),
        out("id", 1, false, Kind::size)},
       {},
       {},
       [](const Views& a, const Wholes&, const Scalars&) {
         return goishi_scene_add(a[0].scene(), a[1].numbers(), a[1].size, a[2].numbers(), a[2].size, a[3].sizes());
       }},
      {"goishi_scene_remove",
       {the_scene},
       {id(1)},
       {},
       [](const Views& a, const Wholes& i, const Scalars&) {
         return goishi_scene_remove(a[0].scene(), static_cast<std::size_t>(i[0]));
       }},
      {"goishi_scene_advance",
       {the_scene},
       {},
       {{"dt", 0.01, {0.0, -1e-300, infinity, -infinity, nan}}},
       [](const Views& a, const Wholes&, const Scalars& x) { return goishi_scene_advance(a[0].scene(), x[0]); }},
      {"goishi_scene_advance_to",
       {the_scene},
       {},
       {{"time", 0.1, {0.0, -1.0, infinity, -infinity, nan}}},
       [](const Views& a, const Wholes&, const Scalars& x) { return goishi_scene_advance_to(a[0].scene(), x[0]); }},
      {"goishi_scene_run_until_rest",
       {the_scene},
       {},
       {{"horizon", 0.1, {0.0, -1.0, infinity, -infinity, nan}}},
       [](const Views& a, const Wholes&, const Scalars& x) { return goishi_scene_run_until_rest(a[0].scene(), x[0]); }},
      {"goishi_scene_push",
       {the_scene, in("point", point), in("impulse", impulse)},
       {id(1, {2})},
       {},
       [](const Views& a, const Wholes& i, const Scalars&) {
         return goishi_scene_push(a[0].scene(), static_cast<std::size_t>(i[0]), a[1].numbers(), a[1].size,
                                  a[2].numbers(), a[2].size);
       }},
      {"goishi_scene_hold",
       {the_scene, in("velocity", {0.0, 0.01, 0.1}), in("spin", {0.0, 0.0, 1.0})},
       {id(1)},
       {{"duration", 0.1, {0.0, -1.0, infinity, nan}}},
       [](const Views& a, const Wholes& i, const Scalars& x) {
         return goishi_scene_hold(a[0].scene(), static_cast<std::size_t>(i[0]), a[1].numbers(), a[1].size,
                                  a[2].numbers(), a[2].size, x[0]);
       }},
      {"goishi_scene_release",
       {the_scene},
       {id(2, {0, 1})},
       {},
       [](const Views& a, const Wholes& i, const Scalars&) {
         return goishi_scene_release(a[0].scene(), static_cast<std::size_t>(i[0]));
       }},
      {"goishi_scene_change",
       {the_scene, in("settings", scene_settings())},
       {},
       {},
       [](const Views& a, const Wholes&, const Scalars&) {
         return goishi_scene_change(a[0].scene(), a[1].numbers(), a[1].size);
       }},
      {"goishi_scene_info",
       {the_scene, out("info", GOISHI_SCENE_SIZE)},
       {},
       {},
       [](const Views& a, const Wholes&, const Scalars&) {
         return goishi_scene_info(a[0].scene(), a[1].numbers(), a[1].size);
       }},
      {"goishi_scene_stones",
       {the_scene, out("rows", std::size_t{2 * GOISHI_SCENE_STONE_SIZE}, true)},
       {{"first", 1, {2, 4, LLONG_MAX, -1}}},
       {},
       [](const Views& a, const Wholes& i, const Scalars&) {
         return goishi_scene_stones(a[0].scene(), static_cast<std::size_t>(i[0]), a[1].numbers(), a[1].size);
       }},
      {"goishi_scene_contacts",
       {the_scene, out("rows", std::size_t{3 * GOISHI_SCENE_CONTACT_SIZE}, true), out("count", 1, false, Kind::size)},
       {},
       {},
       [](const Views& a, const Wholes&, const Scalars&) {
         return goishi_scene_contacts(a[0].scene(), a[1].numbers(), a[1].size, a[2].sizes());
       }},
  };
}

goishi_scene* busy_scene() {
  goishi_scene* scene = nullptr;
  std::vector<double> how = scene_settings();
  how[GOISHI_TOLERANCE] = 1e-4;
  std::size_t id = 0;
  const std::vector<double> up = {0.0, 0.0, 0.1}, still = {0.0, 0.0, 0.0};
  bool good = goishi_scene_create(board.data(), board.size(), how.data(), how.size(), &scene) == GOISHI_OK &&
              goishi_scene_add(scene, stone.data(), stone.size(), state.data(), state.size(), &id) == GOISHI_OK;
  for (const double x : {0.05, 0.1}) {
    const std::vector<double> lies = {x, 0.0, 0.0046, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    good = good && goishi_scene_add(scene, stone.data(), stone.size(), lies.data(), lies.size(), &id) == GOISHI_OK;
  }
  good = good && goishi_scene_hold(scene, id, up.data(), up.size(), still.data(), still.size(), 0.01) == GOISHI_OK &&
         goishi_scene_advance(scene, 0.02) == GOISHI_OK;
  if (!good) {
    std::abort();
  }
  return scene;
}

}  // namespace goishi::web_test
