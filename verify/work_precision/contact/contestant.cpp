#include "verify/work_precision/contact/contestant.hpp"

namespace goishi::verify::bench::contact {

const std::vector<Contestant>& contestants() {
  static const std::vector<Contestant> all = [] {
    std::vector<Contestant> result = our_contestants();
    for (Contestant& other : rival_contestants()) {
      result.push_back(std::move(other));
    }
    return result;
  }();
  return all;
}

}  // namespace goishi::verify::bench::contact
