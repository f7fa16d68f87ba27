#pragma once
/// \file
/// The contact queries that are raced: one way to ask for what the library ships and for the rivals.

#include <vector>

#include "verify/bench/contact/scene.hpp"
#include "verify/bench/race.hpp"

namespace goishi::verify::bench::contact {

/// Of the gap [m], over all poses that were answered; of a time of impact, the error times the speed of approach: the
/// greatest, the median, and how many answers are not finite.
[[nodiscard]] std::vector<double> judge(const std::vector<double>& answers, const Scene& scene);

/// `query(i)` answers for pose i: gap [m], or time of impact [s]; not finite where there is no answer.
template <class Query>
[[nodiscard]] Entry make_query(const Scene& scene, Query query) {
  return make_entry(scene.right.size(), std::move(query),
                    [&scene](const auto& answers) { return judge(answers, scene); });
}

/// None where libccd and FCL were not found.
[[nodiscard]] std::vector<Contestant<Scene>> rival_contestants();

[[nodiscard]] Subject subject();

}  // namespace goishi::verify::bench::contact
