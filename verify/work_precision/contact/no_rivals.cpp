#include "verify/work_precision/contact/contestant.hpp"

namespace goishi::verify::bench::contact {

std::vector<Contestant> rival_contestants() {
  return {};
}

}  // namespace goishi::verify::bench::contact
