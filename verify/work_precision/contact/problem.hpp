#pragma once
/// \file
/// The contact queries that are raced: which stone, which query, how near contact.

#include <string>
#include <vector>

#include "verify/samples/stone.hpp"

namespace goishi::verify::bench::contact {

/// What is asked about. `plane`: z = 0 without end; `edge` and `corner`: the board; `apart`, `bevels` and `cores`: two
/// equal stones that do not overlap, overlap by no more than their bevels, overlap by more; `impact`: when a flying
/// stone reaches z = 0.
enum class Query { plane, edge, corner, apart, bevels, cores, impact };

[[nodiscard]] constexpr bool is_pair(Query query) {
  return query == Query::apart || query == Query::bevels || query == Query::cores;
}

struct Problem {
  std::string name;   // "edge", as on the command line
  std::string title;  // for people
  Query query;
  ShapeSample<double> shape;
  double greatest_time;   // [ns] a query in double that is promised,
  double greatest_error;  // of the gap, in widths
};

[[nodiscard]] const std::vector<Problem>& problems();

}  // namespace goishi::verify::bench::contact
