/// Separations, rays, times of impact and impacts.

#include <goishi/board/ray.hpp>
#include <goishi/contact/stone_board.hpp>
#include <goishi/contact/stone_plane.hpp>
#include <goishi/contact/stone_stone.hpp>
#include <goishi/contact/time_of_impact.hpp>
#include <goishi/impact/laws.hpp>
#include <goishi/motion/invariants.hpp>
#include <goishi/published/linear_response.hpp>
#include <goishi/published/separating_axis.hpp>
#include <goishi/shape/ray.hpp>

#include "verify/bits/inputs.hpp"
#include "verify/bits/kinds.hpp"

namespace goishi::verify::bits {

namespace {

template <class T>
void add(Hash& hash, const Separation<T>& separation) {
  hash.add(static_cast<int>(separation.status));
  hash.add(separation.gap);
  bits::add(hash, separation.n_W);
  bits::add(hash, separation.p_stone);
  bits::add(hash, separation.p_other);
  hash.add(separation.certified);
}

template <class T>
void add_contact(Hash& hash, Random& random, const Board<T>& board) {
  const Stone<T> stone = random.stone<T>(), other = random.stone<T>();
  Pose<T> pose = random.pose<T>(0.25), beside = random.pose<T>(0.02);
  pose.p_WB.z() = random.between<T>(-0.02, 0.02);
  beside.p_WB = formula::plus(pose.p_WB, beside.p_WB);
  const Plane<T> plane{random.direction<T>(), random.between<T>(-0.1, 0.1)};
  add(hash, separation(stone, pose, plane));
  add(hash, separation(stone, pose, board));
  add(hash, separation(stone, pose, other, beside));
  hash.add(surface_gap(stone, pose));
  const Vec3<T> point = random.vector<T>(0.02), direction = random.direction<T>();
  const auto nearest = closest_point(stone, point);
  hash.add(nearest.distance);
  bits::add(hash, nearest.normal_B);
  const auto ray = cast_ray(stone, point, direction);
  hash.add(ray.hit);
  hash.add(ray.entry);
  hash.add(ray.exit);
  const auto board_ray = cast_ray(board, pose.p_WB, direction);
  hash.add(board_ray.hit);
  hash.add(board_ray.entry);
  bits::add(hash, board_ray.p_W);
  const auto published = separating_axis_published(stone, pose, board);
  hash.add(published.colliding);
  hash.add(published.depth);
  bits::add(hash, published.axis_W);
}

FlightPath<double> path(Random& random, double size) {
  const Vec3<double> p = random.vector<double>(size), v = random.vector<double>(1);
  const Vec3<double> u = random.direction<double>(), k = random.direction<double>();
  return {.p_W = p, .v_W = v, .a_W = gravity_W<double>(), .u_W = u, .k_W = k, .rate = random.between(0, 200)};
}

void add(Hash& hash, const TimeOfImpact<double>& found) {
  hash.add(static_cast<int>(found.status));
  hash.add(found.time);
  add(hash, found.contact);
}

template <class T>
ImpactBody<T> impact_body(Random& random) {
  const auto body = mass_properties(random.stone<T>(), Density<T>{T(2800)});
  const Vec3<T> p = random.vector<T>(0.01), u = random.direction<T>();
  const State<T> state = random.state<T>(body.moments);
  return {.mobility = make_mobility(body), .p_WB = p, .u_W = u, .v_WB = state.v_WB, .L_W = state.L_W};
}

template <class T>
void add_impact(Hash& hash, Random& random) {
  const ImpactBody<T> body = impact_body<T>(random), other = impact_body<T>(random);
  const T e = random.between<T>(0, 1), mu = random.between<T>(0, 1);
  const Material<T> material = make_material(e, mu);
  const Vec3<T> p = random.vector<T>(0.01), n = random.direction<T>();
  for (const ImpactLaw law : {ImpactLaw::chatterjee_ruina, ImpactLaw::published, ImpactLaw::stronge}) {
    const auto one = resolve(law, material, p, n, body);
    bits::add(hash, one.impulse.impulse_W);
    bits::add(hash, one.body.v_WB);
    bits::add(hash, one.body.L_W);
    const auto two = resolve(law, material, p, n, body, other);
    bits::add(hash, two.impulse.impulse_W);
    bits::add(hash, two.second.v_WB);
  }
}

}  // namespace

void hash_contact(Hash& hash) {
  Random random(7);
  const auto board = make_board<double>();
  const auto board_f = make_board<float>();
  for (int i = 0; i < 950; ++i) {
    add_contact(hash, random, board);
    add_contact(hash, random, board_f);
  }
}

void hash_time_of_impact(Hash& hash) {
  Random random(8);
  const auto board = make_board<double>();
  for (int i = 0; i < 3100; ++i) {
    const Stone<double> stone = random.stone<double>(), other = random.stone<double>();
    FlightPath<double> way = path(random, 0.25);
    way.p_W.z() = random.between(0.02, 0.1);
    const FlightPath<double> other_way = path(random, 0.25);
    add(hash, time_of_impact(stone, way, Plane<double>{{0, 0, 1}, 0.0}, 1.0));
    add(hash, time_of_impact(stone, way, board, 1.0));
    if (i % 2 == 0) {
      add(hash, time_of_impact(stone, way, other, other_way, 1.0));
    }
  }
}

void hash_impact(Hash& hash) {
  Random random(9);
  for (int i = 0; i < 1200; ++i) {
    add_impact<double>(hash, random);
    add_impact<float>(hash, random);
  }
}

}  // namespace goishi::verify::bits
