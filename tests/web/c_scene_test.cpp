/// The C interface beside the library: a scene. The same numbers, to the last bit.

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "compiled/scene.hpp"
#include "tests/web/scenes.hpp"

namespace goishi::web_test {

namespace {

using Library = goishi::Scene<double>;

const List board_list = {19.0, 0.022, 0.0237, 0.0141, 0.01395, 0.1515, 0.0};

List own_scene_settings() {
  List settings(GOISHI_SCENE_SETTINGS_SIZE);
  EXPECT_DONE(goishi_scene_settings(AS_ARRAY(settings)));
  return settings;
}

List stone_rows(const goishi_scene* scene, std::size_t first, std::size_t count) {
  List rows(count * GOISHI_SCENE_STONE_SIZE);
  EXPECT_DONE(goishi_scene_stones(scene, first, AS_ARRAY(rows)));
  return rows;
}

List info_of(const goishi_scene* scene) {
  List info(GOISHI_SCENE_SIZE);
  EXPECT_DONE(goishi_scene_info(scene, AS_ARRAY(info)));
  return info;
}

/// Whatever the interface tells of a scene, it tells of the library's.
void expect_same_scene(const goishi_scene* scene, const Library& other) {
  const SceneCounters& c = other.counters();
  List stones, contacts, info;
  double moving = 0.0;
  for (const StoneId id : other.stones()) {
    moving += other.mode(id) == StoneMode::rest ? 0.0 : 1.0;
    stones << static_cast<double>(id) << static_cast<double>(other.mode(id)) << other.work(id);
    const List now = motion(other.state(id), other.body(id), other.settings().drop.gravity);
    stones.insert(stones.end(), now.begin(), now.end());
  }
  const std::size_t count = other.stones().size();
  info << other.time() << static_cast<double>(count) << moving << other.energy();
  for (const long long one : {c.stretches, c.looks, c.separations, c.pair_impacts, c.joins, c.steps, c.stone_steps,
                              c.cut_steps, c.retries, c.solves, c.sweeps, c.updates, c.unsolved, c.rest_trials}) {
    info << static_cast<double>(one);
  }
  expect_same(info_of(scene), info, "info");
  expect_same(stone_rows(scene, 0, count), stones, "stones");
  expect_same(stone_rows(scene, 1, 1),
              List(stones.begin() + GOISHI_SCENE_STONE_SIZE, stones.begin() + 2 * GOISHI_SCENE_STONE_SIZE), "one");
  for (const SceneContact<double>& one : other.contacts()) {
    contacts << static_cast<double>(one.stone) << (one.other ? static_cast<double>(*one.other) : -1.0) << one.p_WC
             << one.n_W << one.force_W;
  }
  const std::size_t room = 40;
  List got(room * GOISHI_SCENE_CONTACT_SIZE, 77.0);
  std::size_t there = 0;
  EXPECT_DONE(goishi_scene_contacts(scene, AS_ARRAY(got), &there));
  EXPECT_EQ(there * GOISHI_SCENE_CONTACT_SIZE, contacts.size());
  contacts.resize(got.size(), 77.0);
  expect_same(got, contacts, "contacts");
}

/// A heap of stones about to fall, in both.
struct Both {
  List settings = own_scene_settings();
  SceneSettings<double> same_settings;
  goishi_scene* scene = nullptr;
  Library other;

  Both() : other(make_board<double>(), made(*this)) {
    EXPECT_DONE(goishi_scene_create(AS_ARRAY(board_list), AS_ARRAY(settings), &scene));
    Scenes scenes;
    for (std::size_t i = 0; i < 8; ++i) {
      web_test::Scene one = scenes.next();
      one.start.p_WB = {0.012 * static_cast<double>(i % 2), 0.01 * static_cast<double>(i % 3),
                        0.03 + 0.03 * static_cast<double>(i)};
      one.start.v_WB *= 0.2;
      std::copy_n(one.start.p_WB.data(), 3, one.state.begin());
      std::copy_n(one.start.v_WB.data(), 3, one.state.begin() + GOISHI_VELOCITY);
      std::size_t id = 77;
      EXPECT_DONE(goishi_scene_add(scene, AS_ARRAY(one.stone), AS_ARRAY(one.state), &id));
      EXPECT_EQ(StoneId(id), other.add(one.shape, one.body(), one.start));
    }
  }
  ~Both() { goishi_scene_free(scene); }
  Both(const Both&) = delete;
  Both& operator=(const Both&) = delete;

  static SceneSettings<double>& made(Both& both) {
    both.settings[GOISHI_TOLERANCE] = both.same_settings.drop.tolerance = 1e-4;
    both.settings[GOISHI_RESTITUTION] = both.same_settings.drop.restitution = 0.25;
    both.settings[GOISHI_STONES_RESTITUTION] = both.same_settings.restitution = 0.375;
    both.settings[GOISHI_STONES_FRICTION] = both.same_settings.friction = 0.25;
    both.settings[GOISHI_SOLVER_TOLERANCE] = both.same_settings.solver_tolerance = 0.05;
    both.settings[GOISHI_STEP] = 1.0 / 512;
    both.same_settings.step = 1.0 / 512;
    both.settings[GOISHI_CLEARANCE] = 6e-7;
    both.same_settings.clearance = 6e-7;
    both.settings[GOISHI_IMPACT_SPEED] = 0.006;
    both.same_settings.impact_speed = 0.006;
    both.settings[GOISHI_LEAVING_TIME] = 0.011;
    both.same_settings.leaving_time = 0.011;
    return both.same_settings;
  }
};

TEST(CScene, EverythingThatIsDoneToItIsDoneToTheLibrarys) {
  Both both;
  expect_same_scene(both.scene, both.other);
  EXPECT_DONE(goishi_scene_advance(both.scene, 0.15));
  both.other.advance(0.15);
  expect_same_scene(both.scene, both.other);

  goishi_scene* copy = nullptr;
  EXPECT_DONE(goishi_scene_copy(both.scene, &copy));
  const Library before = both.other;
  const Vec p(0.01, 0.0, 0.02), P(2e-4, 1e-4, 1e-4), v(0.02, 0.0, 0.05), w(0.0, 1.0, 2.0);
  const List point = {p[0], p[1], p[2]}, push = {P[0], P[1], P[2]}, velocity = {v[0], v[1], v[2]},
             spin = {w[0], w[1], w[2]};
  EXPECT_DONE(goishi_scene_push(both.scene, 1, AS_ARRAY(point), AS_ARRAY(push)));
  both.other.apply_impulse(StoneId(1), p, P);
  EXPECT_DONE(goishi_scene_hold(both.scene, 2, AS_ARRAY(velocity), AS_ARRAY(spin), 0.25));
  both.other.hold(StoneId(2), v, w, 0.25);
  EXPECT_DONE(goishi_scene_advance_to(both.scene, 0.4));
  both.other.advance_to(0.4);
  expect_same_scene(both.scene, both.other);
  EXPECT_DONE(goishi_scene_release(both.scene, 2));
  both.other.release(StoneId(2));
  EXPECT_DONE(goishi_scene_remove(both.scene, 0));
  both.other.remove(StoneId(0));
  both.settings[GOISHI_GRAVITY + 2] = -9.5;
  both.same_settings.drop.gravity = {0.0, 0.0, -9.5};
  EXPECT_DONE(goishi_scene_change(both.scene, AS_ARRAY(both.settings)));
  both.other.change(both.same_settings);
  EXPECT_DONE(goishi_scene_advance(both.scene, 0.25));
  both.other.advance(0.25);
  expect_same_scene(both.scene, both.other);
  EXPECT_DONE(goishi_scene_run_until_rest(both.scene, 60.0));
  EXPECT_TRUE(both.other.run_until_rest(60.0));
  EXPECT_EQ(info_of(both.scene)[GOISHI_SCENE_MOVING], 0.0);
  expect_same_scene(both.scene, both.other);
  expect_same_scene(copy, before);  // it has stayed
  goishi_scene_free(copy);
}

TEST(CScene, HowTimeIsCutDoesNotMatter) {
  Both whole, cut;
  EXPECT_DONE(goishi_scene_advance_to(whole.scene, 0.5));
  for (int i = 1; i <= 60; ++i) {
    EXPECT_DONE(goishi_scene_advance_to(cut.scene, i / 120.0));
  }
  expect_same(stone_rows(cut.scene, 0, 8), stone_rows(whole.scene, 0, 8), "stones");
}

TEST(CScene, TheSettingsAreTheLibrarys) {
  const SceneSettings<double> own;
  List settings = own_scene_settings(), of_drop(GOISHI_SETTINGS_SIZE);
  EXPECT_DONE(goishi_settings(AS_ARRAY(of_drop)));
  expect_same(List(settings.begin(), settings.begin() + GOISHI_SETTINGS_SIZE), of_drop, "of a drop");
  settings.erase(settings.begin(), settings.begin() + GOISHI_SETTINGS_SIZE);
  expect_same(
      settings,
      {own.restitution, own.friction, GOISHI_UNSET, own.solver_tolerance, GOISHI_UNSET, GOISHI_UNSET, GOISHI_UNSET},
      "of a scene");
}

TEST(CScene, OfManyContactsTheFirstAreTold) {
  Both both;
  EXPECT_DONE(goishi_scene_run_until_rest(both.scene, 60.0));
  List all(40 * GOISHI_SCENE_CONTACT_SIZE), one(GOISHI_SCENE_CONTACT_SIZE);
  std::size_t there = 0, same_there = 0;
  EXPECT_DONE(goishi_scene_contacts(both.scene, AS_ARRAY(all), &there));
  EXPECT_DONE(goishi_scene_contacts(both.scene, AS_ARRAY(one), &same_there));
  EXPECT_LT(1U, there);
  EXPECT_EQ(there, same_there);
  all.resize(one.size());
  expect_same(one, all, "the first");
}

}  // namespace

}  // namespace goishi::web_test
