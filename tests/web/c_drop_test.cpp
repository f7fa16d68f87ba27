/// The C interface beside the library: contact, impact, drop. The same numbers, to the last bit.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <goishi/contact/stone_board.hpp>
#include <goishi/contact/stone_stone.hpp>
#include <goishi/contact/time_of_impact.hpp>
#include <goishi/drop/holds.hpp>
#include <goishi/impact/laws.hpp>
#include <goishi/published/separating_axis.hpp>
#include <limits>
#include <set>
#include <vector>

#include "compiled/drop.hpp"
#include "tests/web/scenes.hpp"

namespace goishi::web_test {

namespace {

const List board_list = {19.0, 0.022, 0.0237, 0.0141, 0.01395, 0.1515, 0.0};

TEST(CInterface, TheBoardIsTheLibrarys) {
  List got(GOISHI_BOARD_SIZE);
  EXPECT_DONE(goishi_board(AS_ARRAY(got)));
  expect_same(got, board_list, "board");
}

TEST(CInterface, Separation) {
  Scenes scenes;
  const Board<double> board = make_board<double>();
  for (int i = 0; i < 200; ++i) {
    Scene scene = scenes.next();
    if (i % 2 == 0) {  // at an edge of the board
      scene.start.p_WB.x() += 0.21;
      scene.start.p_WB.z() -= 0.05;
      scene.state[0] = scene.start.p_WB.x();
      scene.state[2] = scene.start.p_WB.z();
    }
    const Vec n = Vec(scenes.vector(1.0) + Vec(0.0, 0.0, 2.0)).normalized();
    const double offset = scenes.between(-0.01, 0.01);
    const List plane = {n[0], n[1], n[2], offset}, pose = scene.pose_list();
    List got(GOISHI_SEPARATION_SIZE), expected;
    EXPECT_DONE(goishi_separation(AS_ARRAY(scene.stone), AS_ARRAY(pose), AS_ARRAY(plane), AS_ARRAY(got)));
    expect_same(got, expected << separation(scene.shape, scene.pose(), Plane<double>{n, offset}), "plane");
    expected.clear();
    EXPECT_DONE(goishi_separation(AS_ARRAY(scene.stone), AS_ARRAY(pose), AS_ARRAY(board_list), AS_ARRAY(got)));
    expect_same(got, expected << separation(scene.shape, scene.pose(), board), "board");
    Scene other = scenes.next();
    const List other_pose = other.pose_list();
    expected.clear();
    EXPECT_DONE(goishi_separation_stones(AS_ARRAY(scene.stone), AS_ARRAY(pose), AS_ARRAY(other.stone),
                                         AS_ARRAY(other_pose), AS_ARRAY(got)));
    expect_same(got, expected << separation(scene.shape, scene.pose(), other.shape, other.pose()), "stone");
  }
}

TEST(CInterface, PublishedSeparation) {
  Scenes scenes;
  const Board<double> board = make_board<double>();
  int colliding = 0;
  std::set<double> regions;
  for (int i = 0; i < 400; ++i) {
    Scene scene = scenes.next();
    const double x = scenes.between(-0.222, 0.222), y = scenes.between(-0.237, 0.237), z = scenes.between(-0.01, 0.02);
    const bool at_side = i % 3 != 0, at_top = i % 2 == 0;
    scene.start.p_WB = {at_side ? std::copysign(0.212, x) : x, at_top ? std::copysign(0.227, y) : y, z};
    std::copy_n(scene.start.p_WB.data(), 3, scene.state.begin());
    const List pose = scene.pose_list();
    List got(GOISHI_PUBLISHED_SEPARATION_SIZE), expected;
    EXPECT_DONE(
        goishi_published_separation(AS_ARRAY(scene.stone), AS_ARRAY(pose), AS_ARRAY(board_list), AS_ARRAY(got)));
    const auto least = separating_axis_published(scene.shape, scene.pose(), board);
    const auto most = separating_axis_published(scene.shape, scene.pose(), board, PushOut::most_penetration);
    const auto axes = published_axes(scene.shape, scene.pose(), board);
    expected << static_cast<double>(least.region) << static_cast<double>(least.colliding) << least.axis_W << least.depth
             << most.axis_W << most.depth << static_cast<double>(axes.size());
    for (const auto& one : axes) {
      expected << one.axis_W << one.depth;
    }
    expected.resize(GOISHI_PUBLISHED_SEPARATION_SIZE, std::numeric_limits<double>::quiet_NaN());
    expect_same(got, expected, "published");
    colliding += got[GOISHI_COLLIDING] == 1.0 ? 1 : 0;
    regions.insert(got[GOISHI_REGION]);
  }
  EXPECT_LT(50, colliding);
  EXPECT_LT(colliding, 350);
  EXPECT_EQ(regions.size(), 10U);
}

List hit(const TimeOfImpact<double>& found) {
  List result;
  return result << static_cast<double>(found.status) << found.time << found.contact << found.steps << found.separations;
}

TEST(CInterface, TimeOfImpact) {
  Scenes scenes;
  int hits = 0;
  for (int i = 0; i < 100; ++i) {
    const Scene scene = scenes.next(), other = scenes.next();
    const FlightPath<double> path = path_of(scene.start, make_mobility(scene.mass.moments), g_W);
    const FlightPath<double> other_path = path_of(other.start, make_mobility(other.mass.moments), g_W);
    const List plane = {0.0, 0.0, 1.0, 0.01};
    List got(GOISHI_HIT_SIZE);
    EXPECT_DONE(goishi_time_of_impact(AS_ARRAY(scene.stone), AS_ARRAY(scene.state), AS_ARRAY(gravity), AS_ARRAY(plane),
                                      infinity, AS_ARRAY(got)));
    expect_same(got, hit(time_of_impact(scene.shape, path, Plane<double>{{0, 0, 1}, 0.01}, infinity)), "plane");
    EXPECT_DONE(goishi_time_of_impact(AS_ARRAY(scene.stone), AS_ARRAY(scene.state), AS_ARRAY(gravity),
                                      AS_ARRAY(board_list), 0.1, AS_ARRAY(got)));
    expect_same(got, hit(time_of_impact(scene.shape, path, make_board<double>(), 0.1)), "board");
    hits += static_cast<int>(got[GOISHI_HIT_STATUS]) == GOISHI_HIT ? 1 : 0;
    EXPECT_DONE(goishi_time_of_impact_stones(AS_ARRAY(scene.stone), AS_ARRAY(scene.state), AS_ARRAY(other.stone),
                                             AS_ARRAY(other.state), AS_ARRAY(gravity), 0.3, AS_ARRAY(got)));
    expect_same(got, hit(time_of_impact(scene.shape, path, other.shape, other_path, 0.3)), "stone");
  }
  EXPECT_LT(10, hits);
}

List impulse(const Impulse<double>& found) {
  List result;
  return result << static_cast<double>(found.outcome) << found.impulse_W << found.normal << found.velocity_before
                << found.velocity_after << found.energy_change << found.rounds;
}

TEST(CInterface, Impacts) {
  Scenes scenes;
  for (int i = 0; i < 150; ++i) {
    const Scene scene = scenes.next(), other = scenes.next();
    const auto law = static_cast<ImpactLaw>(i % 3);
    const double e = scenes.between(0.0, 1.0), mu = scenes.between(0.0, 0.5);
    const Vec n = scenes.vector(1.0).normalized(), p = scene.start.p_WB + scenes.vector(0.01);
    const List normal = {n[0], n[1], n[2]}, point = {p[0], p[1], p[2]};
    const auto seen = [](const Scene& one) {
      return ImpactBody<double>{.mobility = make_mobility(one.mass),
                                .p_WB = one.start.p_WB,
                                .u_W = symmetry_axis(one.start.q_WB),
                                .v_WB = one.start.v_WB,
                                .L_W = one.start.L_W};
    };
    const Impact<double> found = resolve(law, make_material(e, mu), p, n, seen(scene));
    List got(GOISHI_IMPACT_SIZE), expected = impulse(found.impulse);
    EXPECT_DONE(goishi_impact(AS_ARRAY(scene.stone), AS_ARRAY(scene.state), static_cast<int>(law), e, mu,
                              AS_ARRAY(point), AS_ARRAY(normal), AS_ARRAY(got)));
    expect_same(got, expected << found.body.v_WB << found.body.L_W, "impact");
    const TwoBodyImpact<double> two = resolve(law, make_material(e, mu), p, n, seen(scene), seen(other));
    List got_two(GOISHI_IMPACT_STONES_SIZE), expected_two = impulse(two.impulse);
    EXPECT_DONE(goishi_impact_stones(AS_ARRAY(scene.stone), AS_ARRAY(scene.state), AS_ARRAY(other.stone),
                                     AS_ARRAY(other.state), static_cast<int>(law), e, mu, AS_ARRAY(point),
                                     AS_ARRAY(normal), AS_ARRAY(got_two)));
    expect_same(got_two, expected_two << two.first.v_WB << two.first.L_W << two.second.v_WB << two.second.L_W, "two");
  }
}

[[nodiscard]] List own_settings() {
  List result(GOISHI_SETTINGS_SIZE);
  EXPECT_DONE(goishi_settings(AS_ARRAY(result)));
  return result;
}

[[nodiscard]] List info_of(const goishi_drop* drop) {
  List result(GOISHI_DROP_SIZE);
  EXPECT_DONE(goishi_drop_info(drop, AS_ARRAY(result)));
  return result;
}

void expect_same_drop(const goishi_drop* drop, const Drop<double>& other, const std::vector<Event<double>>& events) {
  const List info = info_of(drop);
  const DropCounters& c = other.counters();
  List expected = {other.time(),
                   static_cast<double>(other.status()),
                   static_cast<double>(other.ground()),
                   other.depth(),
                   other.lower_order() ? 1.0 : 0.0,
                   other.motion_begin(),
                   static_cast<double>(other.kept()),
                   static_cast<double>(events.size())};
  expected << c.impacts << c.root_steps << c.separations << c.contact_evaluations << c.steps_accepted
           << c.steps_rejected << c.evaluations_located << c.edge_impacts;
  const List now = motion(other.state(), other.body(), other.settings().gravity);
  expected.insert(expected.end(), now.begin(), now.end());
  expect_same(info, expected, "info");
  List got(events.size() * GOISHI_EVENT_SIZE), rows;
  EXPECT_DONE(goishi_drop_events(drop, 0, AS_ARRAY(got)));
  for (const Event<double>& event : events) {
    rows << static_cast<double>(event.kind) << event.time << event.energy << event.impulse_W << event.contact_W
         << event.normal_W << static_cast<double>(event.feature) << static_cast<double>(event.other_feature)
         << static_cast<double>(event.outcome) << event.before << event.after;
  }
  expect_same(got, rows, "events");
}

TEST(CInterface, Drops) {
  Scenes scenes;
  for (int i = 0; i < 6; ++i) {
    const Scene scene = scenes.next();
    const bool on_plane = i % 3 == 2;
    List settings = own_settings();
    DropSettings<double> same_settings;
    settings[GOISHI_TOLERANCE] = same_settings.tolerance = 1e-6;
    if (i % 2 == 1) {  // all that is left to the library is set
      settings[GOISHI_RESTITUTION] = same_settings.restitution = 0.25;
      settings[GOISHI_ROLLING_RESISTANCE] = 2e-4;
      same_settings.rolling_resistance = 2e-4;
      settings[GOISHI_PIVOT_RADIUS] = 1e-4;
      same_settings.pivot_radius = 1e-4;
      settings[GOISHI_HORIZON] = 5.0;
      same_settings.horizon = 5.0;
      settings[GOISHI_LAW] = GOISHI_STRONGE;
      same_settings.law = ImpactLaw::stronge;
    }
    const List ground = on_plane ? List{0.0, 0.0, 1.0, 0.0} : board_list;
    goishi_drop* drop = nullptr;
    EXPECT_DONE(goishi_drop_create(AS_ARRAY(scene.stone), AS_ARRAY(scene.state), AS_ARRAY(ground), AS_ARRAY(settings),
                                   100000, &drop));
    Drop<double> other =
        on_plane ? Drop<double>(scene.shape, scene.body(), scene.start, same_settings)
                 : Drop<double>(scene.shape, scene.body(), scene.start, make_board<double>(), same_settings);
    other.keep_motion(100000);
    std::vector<Event<double>> events;
    EXPECT_DONE(goishi_drop_advance(drop, 0.125));
    static_cast<void>(other.advance(0.125, events));
    expect_same_drop(drop, other, events);

    goishi_drop* copy = nullptr;
    EXPECT_DONE(goishi_drop_copy(drop, &copy));
    const Vec p(0.01, 0.0, 0.01), P(2e-4, 0.0, 1e-3);
    const List point = {p[0], p[1], p[2]}, push = {P[0], P[1], P[2]};
    EXPECT_DONE(goishi_drop_push(drop, AS_ARRAY(point), AS_ARRAY(push)));
    other.apply_impulse(p, P, events);
    EXPECT_DONE(goishi_drop_advance(drop, infinity));
    static_cast<void>(other.advance_to_rest(events));
    settings[GOISHI_GRAVITY] = 0.5;
    same_settings.gravity = {0.5, 0.0, -9.80665};
    EXPECT_DONE(goishi_drop_change(drop, AS_ARRAY(settings)));
    other.change(same_settings, events);
    EXPECT_DONE(goishi_drop_advance(drop, 0.25));
    static_cast<void>(other.advance(0.25, events));
    expect_same_drop(drop, other, events);

    for (const Side side : {Side::before, Side::after}) {
      List times, expected;
      for (const Event<double>& event : events) {
        times << event.time << scenes.between(0.0, other.time());
      }
      for (const double time : times) {
        const List one = motion(other.state_at(time, side), other.body(), other.settings().gravity);
        expected.insert(expected.end(), one.begin(), one.end());
      }
      List got(times.size() * GOISHI_MOTION_SIZE);
      EXPECT_DONE(goishi_drop_motions(drop, AS_ARRAY(times), static_cast<int>(side), AS_ARRAY(got)));
      expect_same(got, expected, "motions");
    }
    EXPECT_EQ(info_of(copy)[GOISHI_DROP_TIME], 0.125);  // the copy has stayed
    goishi_drop_free(drop);
    goishi_drop_free(copy);
  }
}

TEST(CInterface, TheSettingsAreTheLibrarys) {
  const List settings = own_settings();
  const DropSettings<double> own;
  expect_same(settings,
              {own.restitution,
               own.friction,
               0.0,
               0.0,
               -9.80665,
               GOISHI_UNSET,
               GOISHI_UNSET,
               GOISHI_DRY,
               GOISHI_UNSET,
               GOISHI_UNSET,
               GOISHI_UNSET,
               0.0,
               GOISHI_CHATTERJEE_RUINA,
               GOISHI_UNSET,
               2147483647.0,
               100000.0,
               2000000.0,
               own.tolerance,
               GOISHI_UNSET,
               GOISHI_UNSET,
               GOISHI_UNSET,
               own.touching},
              "settings");
}

TEST(CInterface, Holds) {
  Scenes scenes;
  for (int i = 0; i < 24; ++i) {
    Scene scene = scenes.next();
    const double tilt = i % 4 == 0 ? 0.0 : scenes.between(0.0, 0.02);
    scene.start.q_WB = Quat<double>(std::cos(tilt / 2.0), std::sin(tilt / 2.0), 0.0, 0.0);
    scene.start.p_WB = {0.0, 0.0, support(scene.shape, Vec(scene.start.q_WB.conjugate() * Vec(0.0, 0.0, -1.0))).value};
    List pose;
    pose << scene.start;
    pose.resize(GOISHI_POSE_SIZE);
    List settings = own_settings();
    DropSettings<double> same_settings;
    settings[GOISHI_GRAVITY] = 0.25;
    same_settings.gravity.x() = 0.25;
    const List ground = i % 2 == 0 ? List{0.0, 0.0, 1.0, 0.0} : board_list;
    const Hold<double> hold = i % 2 == 0 ? holds(scene.shape, scene.pose(), Plane<double>{}, same_settings)
                                         : holds(scene.shape, scene.pose(), make_board<double>(), same_settings);
    List got(GOISHI_HOLD_SIZE);
    EXPECT_DONE(
        goishi_holds(AS_ARRAY(scene.stone), AS_ARRAY(pose), AS_ARRAY(ground), AS_ARRAY(settings), AS_ARRAY(got)));
    expect_same(got,
                {hold.holds ? 1.0 : 0.0, static_cast<double>(hold.contacts), hold.gap, hold.friction, hold.resistance,
                 hold.tilt},
                "hold");
  }
}

}  // namespace

}  // namespace goishi::web_test
