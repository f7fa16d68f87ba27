#include <cstddef>
#include <goishi/contact/stone_board.hpp>
#include <goishi/contact/stone_stone.hpp>
#include <goishi/contact/time_of_impact.hpp>
#include <goishi/drop/phases/next_impact.hpp>
#include <goishi/impact/laws.hpp>
#include <goishi/motion/free_flight.hpp>
#include <goishi/published/separating_axis.hpp>
#include <limits>
#include <variant>
#include <vector>

#include "arguments.hpp"

namespace goishi::c {

namespace {

static_assert(is(SeparationStatus::separated, GOISHI_SEPARATED) &&
              is(SeparationStatus::overlapping, GOISHI_OVERLAPPING) &&
              is(SeparationStatus::not_converged, GOISHI_NOT_CERTAIN));
static_assert(is(OtherFeature::surface, GOISHI_ON_SURFACE) && is(OtherFeature::side, GOISHI_ON_SIDE) &&
              is(OtherFeature::top_edge, GOISHI_ON_TOP_EDGE) &&
              is(OtherFeature::vertical_edge, GOISHI_ON_VERTICAL_EDGE) && is(OtherFeature::corner, GOISHI_ON_CORNER) &&
              is(OtherFeature::stone, GOISHI_ON_STONE));
static_assert(is(Region::primary, GOISHI_PRIMARY) && is(Region::left, GOISHI_LEFT) && is(Region::right, GOISHI_RIGHT) &&
              is(Region::bottom, GOISHI_BOTTOM) && is(Region::top, GOISHI_TOP) &&
              is(Region::bottom_left, GOISHI_BOTTOM_LEFT) && is(Region::bottom_right, GOISHI_BOTTOM_RIGHT) &&
              is(Region::top_left, GOISHI_TOP_LEFT) && is(Region::top_right, GOISHI_TOP_RIGHT) &&
              is(Region::out_of_reach, GOISHI_OUT_OF_REACH));
static_assert(is(ImpactStatus::hit, GOISHI_HIT) && is(ImpactStatus::none, GOISHI_NO_HIT) &&
              is(ImpactStatus::overlapping, GOISHI_HIT_OVERLAPPING) &&
              is(ImpactStatus::not_converged, GOISHI_HIT_NOT_CONVERGED));
static_assert(is(ImpactLaw::chatterjee_ruina, GOISHI_CHATTERJEE_RUINA) &&
              is(ImpactLaw::published, GOISHI_PUBLISHED_LAW) && is(ImpactLaw::stronge, GOISHI_STRONGE));
static_assert(is(ImpactOutcome::separating, GOISHI_SEPARATING) && is(ImpactOutcome::stuck, GOISHI_STUCK) &&
              is(ImpactOutcome::slid, GOISHI_SLID) && is(ImpactOutcome::not_converged, GOISHI_IMPACT_NOT_CONVERGED));

/// A stone at an impact.
[[nodiscard]] ImpactBody<double> impact_body(const Body& body, const State<double>& state) {
  return {.mobility = make_mobility(body.mass),
          .p_WB = state.p_WB,
          .u_W = symmetry_axis(state.q_WB),
          .v_WB = state.v_WB,
          .L_W = state.L_W};
}

void put_impulse(Row row, const Impulse<double>& impulse) {
  row << as_number(impulse.outcome) << impulse.impulse_W << impulse.normal << impulse.velocity_before
      << impulse.velocity_after << impulse.energy_change << static_cast<double>(impulse.rounds);
}

[[nodiscard]] std::vector<double> hit_of(const TimeOfImpact<double>& found) {
  std::vector<double> result;
  Row(result) << as_number(found.status) << found.time << found.contact << static_cast<double>(found.steps)
              << static_cast<double>(found.separations);
  return result;
}

[[nodiscard]] FlightPath<double> read_path(const Body& body, const char* name, const double* state,
                                           std::size_t state_size, const Vec& gravity) {
  return path_of(read_state(name, state, state_size), make_mobility(body.mass.moments), gravity);
}

}  // namespace
}  // namespace goishi::c

using namespace goishi;
using namespace goishi::c;

extern "C" {

int goishi_board(double* board, size_t board_size) {
  return guarded([&] {
    require_array("board", board, board_size, GOISHI_BOARD_SIZE);
    const BoardDimensions<double> real;
    write({static_cast<double>(real.lines), real.spacing_x, real.spacing_y, real.border_x, real.border_y,
           real.thickness, real.legs},
          board);
  });
}

int goishi_separation(const double* stone, size_t stone_size, const double* pose, size_t pose_size,
                      const double* ground, size_t ground_size, double* separation, size_t separation_size) {
  return guarded([&] {
    const Stone<double> shape = read_stone("stone", stone, stone_size).stone;
    const Pose<double> there = read_pose("pose", pose, pose_size);
    const Obstacle other = read_ground(ground, ground_size);
    require_array("separation", separation, separation_size, GOISHI_SEPARATION_SIZE);
    std::vector<double> row;
    Row(row) << std::visit([&](const auto& one) { return goishi::separation(shape, there, one); }, other);
    write(row, separation);
  });
}

int goishi_separation_stones(const double* stone, size_t stone_size, const double* pose, size_t pose_size,
                             const double* other, size_t other_size, const double* other_pose, size_t other_pose_size,
                             double* separation, size_t separation_size) {
  return guarded([&] {
    const Stone<double> first = read_stone("stone", stone, stone_size).stone;
    const Pose<double> there = read_pose("pose", pose, pose_size);
    const Stone<double> second = read_stone("other", other, other_size).stone;
    const Pose<double> other_there = read_pose("other_pose", other_pose, other_pose_size);
    require_array("separation", separation, separation_size, GOISHI_SEPARATION_SIZE);
    std::vector<double> row;
    Row(row) << goishi::separation(first, there, second, other_there);
    write(row, separation);
  });
}

int goishi_published_separation(const double* stone, size_t stone_size, const double* pose, size_t pose_size,
                                const double* board, size_t board_size, double* separation, size_t separation_size) {
  return guarded([&] {
    const Stone<double> shape = read_stone("stone", stone, stone_size).stone;
    const Pose<double> there = read_pose("pose", pose, pose_size);
    const Board<double> other = read_board("board", board, board_size);
    require_array("separation", separation, separation_size, GOISHI_PUBLISHED_SEPARATION_SIZE);
    const auto least = separating_axis_published(shape, there, other, PushOut::least_penetration);
    const auto most = separating_axis_published(shape, there, other, PushOut::most_penetration);
    const auto axes = published_axes(shape, there, other);
    std::vector<double> row;
    Row(row) << as_number(least.region) << as_number(least.colliding) << least.axis_W << least.depth << most.axis_W
             << most.depth << static_cast<double>(axes.size());
    for (const PublishedAxis<double>& one : axes) {
      Row(row) << one.axis_W << one.depth;
    }
    row.resize(GOISHI_PUBLISHED_SEPARATION_SIZE, std::numeric_limits<double>::quiet_NaN());
    write(row, separation);
  });
}

int goishi_time_of_impact(const double* stone, size_t stone_size, const double* state, size_t state_size,
                          const double* gravity, size_t gravity_size, const double* ground, size_t ground_size,
                          double horizon, double* hit, size_t hit_size) {
  return guarded([&] {
    const Body body = read_stone("stone", stone, stone_size);
    const Vec g_W = read_vector("gravity", gravity, gravity_size);
    const FlightPath<double> path = read_path(body, "state", state, state_size, g_W);
    const Obstacle other = read_ground(ground, ground_size);
    require_array("hit", hit, hit_size, GOISHI_HIT_SIZE);
    write(hit_of(std::visit([&](const auto& one) { return time_of_impact(body.stone, path, one, horizon); }, other)),
          hit);
  });
}

int goishi_time_of_impact_stones(const double* stone, size_t stone_size, const double* state, size_t state_size,
                                 const double* other, size_t other_size, const double* other_state,
                                 size_t other_state_size, const double* gravity, size_t gravity_size, double horizon,
                                 double* hit, size_t hit_size) {
  return guarded([&] {
    const Body first = read_stone("stone", stone, stone_size), second = read_stone("other", other, other_size);
    const Vec g_W = read_vector("gravity", gravity, gravity_size);
    const FlightPath<double> path = read_path(first, "state", state, state_size, g_W);
    const FlightPath<double> other_path = read_path(second, "other_state", other_state, other_state_size, g_W);
    require_array("hit", hit, hit_size, GOISHI_HIT_SIZE);
    write(hit_of(time_of_impact(first.stone, path, second.stone, other_path, horizon)), hit);
  });
}

// --- Impact

int goishi_impact(const double* stone, size_t stone_size, const double* state, size_t state_size, int law,
                  double restitution, double friction, const double* point, size_t point_size, const double* normal,
                  size_t normal_size, double* impact, size_t impact_size) {
  return guarded([&] {
    const Body body = read_stone("stone", stone, stone_size);
    const State<double> start = read_state("state", state, state_size);
    const Vec p_WC = read_vector("point", point, point_size), n_W = read_vector("normal", normal, normal_size);
    require_array("impact", impact, impact_size, GOISHI_IMPACT_SIZE);
    const Impact<double> found = resolve(chosen("law", law, ImpactLaw::stronge), make_material(restitution, friction),
                                         p_WC, n_W, impact_body(body, start));
    std::vector<double> row;
    put_impulse(Row(row), found.impulse);
    Row(row) << found.body.v_WB << found.body.L_W;
    write(row, impact);
  });
}

int goishi_impact_stones(const double* stone, size_t stone_size, const double* state, size_t state_size,
                         const double* other, size_t other_size, const double* other_state, size_t other_state_size,
                         int law, double restitution, double friction, const double* point, size_t point_size,
                         const double* normal, size_t normal_size, double* impact, size_t impact_size) {
  return guarded([&] {
    const Body first = read_stone("stone", stone, stone_size), second = read_stone("other", other, other_size);
    const State<double> start = read_state("state", state, state_size);
    const State<double> other_start = read_state("other_state", other_state, other_state_size);
    const Vec p_WC = read_vector("point", point, point_size), n_W = read_vector("normal", normal, normal_size);
    require_array("impact", impact, impact_size, GOISHI_IMPACT_STONES_SIZE);
    const TwoBodyImpact<double> found =
        resolve(chosen("law", law, ImpactLaw::stronge), make_material(restitution, friction), p_WC, n_W,
                impact_body(first, start), impact_body(second, other_start));
    std::vector<double> row;
    put_impulse(Row(row), found.impulse);
    Row(row) << found.first.v_WB << found.first.L_W << found.second.v_WB << found.second.L_W;
    write(row, impact);
  });
}

}  // extern "C"
