#pragma once
/// \file
/// Random poses near contact, and the right answers, by the witnesses alone: nothing of src/goishi/contact is used.

#include <cstddef>
#include <goishi/board/board.hpp>
#include <goishi/contact/time_of_impact.hpp>
#include <string>
#include <vector>

#include "verify/oracles/stone/hull.hpp"
#include "verify/work_precision/contact/problem.hpp"

namespace goishi::verify::bench::contact {

/// One problem's poses. All contestants are asked about the same.
struct Scene {
  const Problem* problem = nullptr;
  Hull<Digits50> hull;
  Board<double> board;
  std::vector<Pose<double>> poses;
  std::vector<Pose<double>> others;       // of the second stones; empty where there are none
  std::vector<FlightPath<double>> paths;  // in place of poses, where the stone flies
  std::vector<double> right;              // gap [m], or time of impact [s]
  std::vector<double> rate;               // what an answer's error is multiplied with: 1, or the speed of approach
  std::string witness;                    // who gave the right answers

  [[nodiscard]] std::size_t size() const { return right.size(); }
};

/// The stone is put where a random normal of the feature's cone touches, then moved along it: that normal is the
/// contact's. In 50 digits the gap along it, a lower bound of the separation, and the distance of two points of the
/// cores less the bevels, an upper bound, must agree. Stones whose cores overlap have no upper bound: the greatest
/// separation is searched. A flying stone is stepped no farther than it could have come.
///
/// Throws std::runtime_error when a witness does not reach its certificate.
[[nodiscard]] Scene make_scene(const Problem& problem, std::size_t poses);

/// How soon a stone can touch z = 0 at the earliest [s], `gap` over it with the vertical velocity v, where g pulls it
/// and no point of it turns faster than `swing` [m/s]: gap = closing t + g t²/2.
template <class Real>
[[nodiscard]] Real earliest_contact(const Real& gap, const Real& v, const Real& swing, const Real& g) {
  using std::sqrt;
  const Real closing = (v < Real(0) ? Real(-v) : Real(0)) + swing;
  return Real(2) * gap / (closing + sqrt(closing * closing + Real(2) * g * gap));
}

}  // namespace goishi::verify::bench::contact
