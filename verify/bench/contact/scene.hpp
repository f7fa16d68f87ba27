#pragma once
/// \file
/// Random poses near contact, and the right answers, by the witnesses alone: nothing of src/goishi/contact is used.

#include <cstddef>
#include <goishi/board/board.hpp>
#include <goishi/contact/time_of_impact.hpp>
#include <string>
#include <vector>

#include "verify/oracles/stone/hull.hpp"
#include "verify/samples/stone.hpp"

namespace goishi::verify::bench::contact {

/// What is asked about. `plane`: z = 0 without end; `edge` and `corner`: the board; `apart`, `bevels` and `cores`: two
/// equal stones that do not overlap, overlap by no more than their bevels, overlap by more; `impact`: when a flying
/// stone reaches z = 0.
enum class Query { plane, edge, corner, apart, bevels, cores, impact };

/// One problem's poses. All contestants are asked about the same.
struct Scene {
  std::string name, title;
  Query query;
  ShapeSample<double> shape;

  Hull<Digits50> hull = {};
  Board<double> board = {};
  std::vector<Pose<double>> poses = {};
  std::vector<Pose<double>> others = {};       // of the second stones; empty where there are none
  std::vector<FlightPath<double>> paths = {};  // in place of poses, where the stone flies
  std::vector<double> right = {};              // gap [m], or time of impact [s]
  std::vector<double> rate = {};               // an answer's error is multiplied with it: 1, or the speed of approach
  std::string witness = {};                    // who gave the right answers

  [[nodiscard]] bool is_pair() const {
    return query == Query::apart || query == Query::bevels || query == Query::cores;
  }
  [[nodiscard]] bool is_at_board() const { return query == Query::edge || query == Query::corner; }
};

/// The stone is put where a random normal of the feature's cone touches, then moved along it: that normal is the
/// contact's. In 50 digits the gap along it, a lower bound of the separation, and the distance of two points of the
/// cores less the bevels, an upper bound, must agree. Stones whose cores overlap have no upper bound: the greatest
/// separation is searched. A flying stone is stepped no farther than it could have come.
///
/// Throws std::runtime_error when a witness does not reach its certificate.
[[nodiscard]] Scene with_poses(Scene scene, std::size_t poses);

/// How soon a stone can touch z = 0 at the earliest [s], `gap` over it with the vertical velocity v, where g pulls it
/// and no point of it turns faster than `swing` [m/s]: gap = closing t + g t²/2.
template <class Real>
[[nodiscard]] Real earliest_contact(const Real& gap, const Real& v, const Real& swing, const Real& g) {
  using std::sqrt;
  const Real closing = (v < Real(0) ? Real(-v) : Real(0)) + swing;
  return Real(2) * gap / (closing + sqrt(closing * closing + Real(2) * g * gap));
}

}  // namespace goishi::verify::bench::contact
