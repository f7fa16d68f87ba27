#include "verify/work_precision/contact/problem.hpp"

#include <limits>

namespace goishi::verify::bench::contact {

namespace {

constexpr ShapeSample<double> size_33{0.022, 0.0092, 0.001};
constexpr ShapeSample<double> thin{0.022, 0.0022, 0.0002};

}  // namespace

// What is promised, for the machine that the README names.
const std::vector<Problem>& problems() {
  constexpr double no_error_promised = std::numeric_limits<double>::infinity();
  static const std::vector<Problem> all = {
      {"plane", "Stone and plane", Query::plane, size_33, 15, 1e-13},
      {"edge", "Stone at the board's edge", Query::edge, size_33, 200, 1e-13},
      {"edge-thin", "Thin stone at the board's edge", Query::edge, thin, 300, 1e-13},
      {"corner", "Stone at the board's corner", Query::corner, size_33, 200, 1e-13},
      {"corner-thin", "Thin stone at the board's corner", Query::corner, thin, 300, 1e-13},
      {"apart", "Two stones, separated", Query::apart, size_33, 500, 1e-12},
      {"apart-thin", "Two thin stones, separated", Query::apart, thin, 500, 1e-12},
      {"bevels", "Two stones, overlapping by no more than the bevels", Query::bevels, size_33, 500, 1e-12},
      {"cores", "Two stones, their cores overlapping", Query::cores, size_33, 5000, 1e-12},
      {"impact", "Time of impact with a plane", Query::impact, size_33, 500, no_error_promised}};
  return all;
}

}  // namespace goishi::verify::bench::contact
