#include "tests/web/call_parts.hpp"

#include <climits>
#include <cstdlib>
#include <utility>
#include <vector>

namespace goishi::web_test {

namespace {

const Array the_drop = in("drop", {0.0}, Kind::drop), new_drop = out("drop", 1, false, Kind::new_drop);

std::vector<Call> shape_calls() {
  const Array fineness = in("fineness", {2.0, 3.0, 4.0}, Kind::ints);
  const Whole method{"method", GOISHI_SUBDIVISION, {-1, 2, INT_MAX, INT_MIN}};
  const Whole weld{"weld", GOISHI_WELDED, {-1, 3, INT_MAX, INT_MIN}};
  return {
      {"goishi_catalogue_stone",
       {out("stone", GOISHI_STONE_SIZE)},
       {{"size", 33, {0, 23, -1, INT_MAX, INT_MIN}}, {"color", GOISHI_BLACK, {-1, 2, INT_MAX, INT_MIN}}},
       {{"bevel", 0.001, {-1e-300, 0.0098, 1.0, infinity, -infinity, nan}}},
       [](const Views& a, const Wholes& i, const Scalars& x) {
         return goishi_catalogue_stone(as_int(i[0]), as_int(i[1]), x[0], a[0].numbers(), a[0].size);
       }},
      {"goishi_measures",
       {in("stone", stone), out("measures", GOISHI_MEASURES_SIZE)},
       {},
       {},
       arrays_only<goishi_measures, 2>},
      {"goishi_published_measures",
       {in("stone", stone), out("published", GOISHI_PUBLISHED_MEASURES_SIZE)},
       {},
       {},
       arrays_only<goishi_published_measures, 2>},
      {"goishi_tensor",
       {in("stone", stone), in("pose", pose), out("tensor", 9)},
       {},
       {},
       arrays_only<goishi_tensor, 3>},
      {"goishi_profile",
       {in("stone", stone), out("rows", std::size_t{3 * 5 * GOISHI_PROFILE_SIZE}, true)},
       {{"steps", 4, {0, 3, 5, 6, LLONG_MAX, -1}}},
       {},
       [](const Views& a, const Wholes& i, const Scalars&) {
         return goishi_profile(a[0].numbers(), a[0].size, static_cast<std::size_t>(i[0]), a[1].numbers(), a[1].size);
       }},
      {"goishi_fineness",
       {in("stone", stone), out("fineness", GOISHI_FINENESS_SIZE, false, Kind::ints)},
       {method, {"level", 3, {-2, 9, INT_MAX, INT_MIN}}},
       {{"tolerance", 1e-4, {}}},
       [](const Views& a, const Wholes& i, const Scalars& x) {
         return goishi_fineness(a[0].numbers(), a[0].size, as_int(i[0]), as_int(i[1]), x[0], a[1].ints(), a[1].size);
       }},
      {"goishi_fineness by tolerance",
       {in("stone", stone), out("fineness", GOISHI_FINENESS_SIZE, false, Kind::ints)},
       {method},
       {{"tolerance", 1e-4, {0.0, -1.0, 1e-18, 1e-300, infinity, nan}}},
       [](const Views& a, const Wholes& i, const Scalars& x) {
         return goishi_fineness(a[0].numbers(), a[0].size, as_int(i[0]), -1, x[0], a[1].ints(), a[1].size);
       }},
      {"goishi_mesh_figures",
       {in("stone", stone), fineness, out("figures", GOISHI_MESH_FIGURES_SIZE)},
       {method, weld},
       {},
       [](const Views& a, const Wholes& i, const Scalars&) {
         return goishi_mesh_figures(a[0].numbers(), a[0].size, as_int(i[0]), a[1].ints(), a[1].size, as_int(i[1]),
                                    a[2].numbers(), a[2].size);
       }},
      {"goishi_mesh_counts",
       {in("stone", stone), fineness, out("vertices", 1, false, Kind::size), out("triangles", 1, false, Kind::size)},
       {method, weld},
       {},
       [](const Views& a, const Wholes& i, const Scalars&) {
         return goishi_mesh_counts(a[0].numbers(), a[0].size, as_int(i[0]), a[1].ints(), a[1].size, as_int(i[1]),
                                   a[2].sizes(), a[3].sizes());
       }},
      {"goishi_mesh",
       {in("stone", stone), fineness, out("points", std::size_t{3 * 92}), out("normals", std::size_t{3 * 92}),
        out("corners", std::size_t{3 * 180}, false, Kind::corners)},
       {method, weld},
       {},
       [](const Views& a, const Wholes& i, const Scalars&) {
         return goishi_mesh(a[0].numbers(), a[0].size, as_int(i[0]), a[1].ints(), a[1].size, as_int(i[1]),
                            a[2].numbers(), a[2].size, a[3].numbers(), a[3].size, a[4].corners(), a[4].size);
       }},
  };
}

std::vector<Call> motion_calls() {
  const Whole freedom{"freedom", GOISHI_BOTH, {-1, 3, INT_MAX, INT_MIN}};
  return {
      {"goishi_state",
       {in("stone", stone), in("pose", pose), in("velocity", {0.1, 0.2, 0.3}), in("spin", {1.0, -2.0, 3.0}),
        out("state", GOISHI_STATE_SIZE)},
       {},
       {},
       arrays_only<goishi_state, 5>},
      {"goishi_free_flight",
       {in("stone", stone), in("state", state), in("gravity", gravity), out("motion", GOISHI_MOTION_SIZE)},
       {freedom},
       {{"time", -0.25, {infinity, -infinity, nan}}},
       [](const Views& a, const Wholes& i, const Scalars& x) {
         return goishi_free_flight(a[0].numbers(), a[0].size, a[1].numbers(), a[1].size, a[2].numbers(), a[2].size,
                                   as_int(i[0]), x[0], a[3].numbers(), a[3].size);
       }},
      {"goishi_free_rotation",
       {in("moments", {2e-7, 1.2e-7}), in("attitude", {0.8, 0.6, 0.0, 0.0}), in("momentum", {1e-6, -2e-6, 3e-6}),
        out("rotation", 7)},
       {},
       {{"time", -0.25, {infinity, -infinity, nan}}},
       [](const Views& a, const Wholes&, const Scalars& x) {
         return goishi_free_rotation(a[0].numbers(), a[0].size, a[1].numbers(), a[1].size, a[2].numbers(), a[2].size,
                                     x[0], a[3].numbers(), a[3].size);
       }},
      {"goishi_flight",
       {in("stone", stone), in("state", state), in("gravity", gravity),
        out("rows", std::size_t{5 * GOISHI_FLIGHT_SIZE}, true), out("done", 1, false, Kind::size),
        out("ended", 1, false, Kind::integer)},
       {freedom,
        {"scheme", GOISHI_RUNGE_KUTTA_4, {-1, 9, INT_MAX, INT_MIN}},
        {"steps", 3, {0, -1, INT_MIN, INT_MAX, 100'000'000}}},
       {{"step", 1e-3, {0.0, -1.0, infinity, nan}}},
       [](const Views& a, const Wholes& i, const Scalars& x) {
         return goishi_flight(a[0].numbers(), a[0].size, a[1].numbers(), a[1].size, a[2].numbers(), a[2].size,
                              as_int(i[0]), as_int(i[1]), x[0], as_int(i[2]), a[3].numbers(), a[3].size, a[4].sizes(),
                              a[5].ints());
       }},
  };
}

std::vector<Call> contact_calls() {
  std::vector<Call> result;
  for (const std::vector<double>& ground : {plane, board}) {
    result.push_back(
        {"goishi_separation",
         {in("stone", stone), in("pose", pose), in("ground", ground), out("separation", GOISHI_SEPARATION_SIZE)},
         {},
         {},
         arrays_only<goishi_separation, 4>});
    result.push_back({"goishi_time_of_impact",
                      {in("stone", stone), in("state", state), in("gravity", gravity), in("ground", ground),
                       out("hit", GOISHI_HIT_SIZE)},
                      {},
                      {{"horizon", infinity, {0.0, -1.0, -infinity, nan}}},
                      [](const Views& a, const Wholes&, const Scalars& x) {
                        return goishi_time_of_impact(a[0].numbers(), a[0].size, a[1].numbers(), a[1].size,
                                                     a[2].numbers(), a[2].size, a[3].numbers(), a[3].size, x[0],
                                                     a[4].numbers(), a[4].size);
                      }});
    result.push_back({"goishi_holds",
                      {in("stone", stone), in("pose", pose), in("ground", ground), in("settings", settings()),
                       out("hold", GOISHI_HOLD_SIZE)},
                      {},
                      {},
                      arrays_only<goishi_holds, 5>});
    result.push_back(
        {"goishi_drop_create",
         {in("stone", stone), in("state", state), in("ground", ground), in("settings", settings()), new_drop},
         {{"kept", 10, {}}},
         {},
         [](const Views& a, const Wholes& i, const Scalars&) {
           return goishi_drop_create(a[0].numbers(), a[0].size, a[1].numbers(), a[1].size, a[2].numbers(), a[2].size,
                                     a[3].numbers(), a[3].size, static_cast<std::size_t>(i[0]), a[4].new_drop());
         }});
  }
  const Whole law{"law", GOISHI_CHATTERJEE_RUINA, {-1, 3, INT_MAX, INT_MIN}};
  const Scalar restitution{"restitution", 0.5, {-1e-300, 1.0000000000000002, infinity, nan}};
  const Scalar friction{"friction", 0.3, {-1e-300, -infinity, nan}};
  result.push_back({"goishi_board", {out("board", GOISHI_BOARD_SIZE)}, {}, {}, arrays_only<goishi_board, 1>});
  result.push_back(
      {"goishi_published_separation",
       {in("stone", stone), in("pose", pose), in("board", board), out("separation", GOISHI_PUBLISHED_SEPARATION_SIZE)},
       {},
       {},
       arrays_only<goishi_published_separation, 4>});
  result.push_back({"goishi_separation_stones",
                    {in("stone", stone), in("pose", pose), in("other", stone), in("other_pose", other_pose),
                     out("separation", GOISHI_SEPARATION_SIZE)},
                    {},
                    {},
                    arrays_only<goishi_separation_stones, 5>});
  result.push_back({"goishi_time_of_impact_stones",
                    {in("stone", stone), in("state", state), in("other", stone), in("other_state", other_state),
                     in("gravity", gravity), out("hit", GOISHI_HIT_SIZE)},
                    {},
                    {{"horizon", 1.0, {0.0, -1.0, -infinity, nan}}},
                    [](const Views& a, const Wholes&, const Scalars& x) {
                      return goishi_time_of_impact_stones(a[0].numbers(), a[0].size, a[1].numbers(), a[1].size,
                                                          a[2].numbers(), a[2].size, a[3].numbers(), a[3].size,
                                                          a[4].numbers(), a[4].size, x[0], a[5].numbers(), a[5].size);
                    }});
  result.push_back({"goishi_impact",
                    {in("stone", stone), in("state", state), in("point", point), in("normal", normal),
                     out("impact", GOISHI_IMPACT_SIZE)},
                    {law},
                    {restitution, friction},
                    [](const Views& a, const Wholes& i, const Scalars& x) {
                      return goishi_impact(a[0].numbers(), a[0].size, a[1].numbers(), a[1].size, as_int(i[0]), x[0],
                                           x[1], a[2].numbers(), a[2].size, a[3].numbers(), a[3].size, a[4].numbers(),
                                           a[4].size);
                    }});
  result.push_back({"goishi_impact_stones",
                    {in("stone", stone), in("state", state), in("other", stone), in("other_state", other_state),
                     in("point", point), in("normal", normal), out("impact", GOISHI_IMPACT_STONES_SIZE)},
                    {law},
                    {restitution, friction},
                    [](const Views& a, const Wholes& i, const Scalars& x) {
                      return goishi_impact_stones(a[0].numbers(), a[0].size, a[1].numbers(), a[1].size, a[2].numbers(),
                                                  a[2].size, a[3].numbers(), a[3].size, as_int(i[0]), x[0], x[1],
                                                  a[4].numbers(), a[4].size, a[5].numbers(), a[5].size, a[6].numbers(),
                                                  a[6].size);
                    }});
  return result;
}

std::vector<Call> drop_calls() {
  return {
      {"goishi_settings", {out("settings", GOISHI_SETTINGS_SIZE)}, {}, {}, arrays_only<goishi_settings, 1>},
      {"goishi_drop_copy",
       {the_drop, out("copy", 1, false, Kind::new_drop)},
       {},
       {},
       [](const Views& a, const Wholes&, const Scalars&) { return goishi_drop_copy(a[0].drop(), a[1].new_drop()); }},
      {"goishi_drop_advance",
       {the_drop},
       {},
       {{"dt", 0.01, {-1e-300, -infinity, nan}}},
       [](const Views& a, const Wholes&, const Scalars& x) { return goishi_drop_advance(a[0].drop(), x[0]); }},
      {"goishi_drop_push",
       {the_drop, in("point", point), in("impulse", impulse)},
       {},
       {},
       [](const Views& a, const Wholes&, const Scalars&) {
         return goishi_drop_push(a[0].drop(), a[1].numbers(), a[1].size, a[2].numbers(), a[2].size);
       }},
      {"goishi_drop_change",
       {the_drop, in("settings", settings())},
       {},
       {},
       [](const Views& a, const Wholes&, const Scalars&) {
         return goishi_drop_change(a[0].drop(), a[1].numbers(), a[1].size);
       }},
      {"goishi_drop_info",
       {the_drop, out("info", GOISHI_DROP_SIZE)},
       {},
       {},
       [](const Views& a, const Wholes&, const Scalars&) {
         return goishi_drop_info(a[0].drop(), a[1].numbers(), a[1].size);
       }},
      {"goishi_drop_events",
       {the_drop, out("rows", std::size_t{2 * GOISHI_EVENT_SIZE}, true)},
       {{"first", 0, {1'000'000, LLONG_MAX, -1}}},
       {},
       [](const Views& a, const Wholes& i, const Scalars&) {
         return goishi_drop_events(a[0].drop(), static_cast<std::size_t>(i[0]), a[1].numbers(), a[1].size);
       }},
      {"goishi_drop_motions",
       {the_drop, in("times", {0.1, 0.0}), out("motions", std::size_t{2 * GOISHI_MOTION_SIZE}, true)},
       {{"side", GOISHI_AFTER, {-1, 2, INT_MAX, INT_MIN}}},
       {},
       [](const Views& a, const Wholes& i, const Scalars&) {
         return goishi_drop_motions(a[0].drop(), a[1].numbers(), a[1].size, as_int(i[0]), a[2].numbers(), a[2].size);
       }},
  };
}

}  // namespace

std::vector<Call> all_calls() {
  std::vector<Call> result = shape_calls();
  for (std::vector<Call>& more :
       std::vector<std::vector<Call>>{motion_calls(), contact_calls(), drop_calls(), scene_calls()}) {
    for (Call& call : more) {
      result.push_back(std::move(call));
    }
  }
  return result;
}

goishi_drop* falling_drop() {
  goishi_drop* drop = nullptr;
  const std::vector<double> how = settings();
  if (goishi_drop_create(stone.data(), stone.size(), state.data(), state.size(), board.data(), board.size(), how.data(),
                         how.size(), 1000, &drop) != GOISHI_OK ||
      goishi_drop_advance(drop, 0.1) != GOISHI_OK) {
    std::abort();
  }
  return drop;
}

}  // namespace goishi::web_test
