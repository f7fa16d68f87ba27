#include "verify/work_precision/contact/rivals.hpp"

namespace goishi::verify::bench::contact {

std::vector<Contestant> rival_contestants() {
  std::vector<Contestant> result = libccd_contestants();
  for (Contestant& other : fcl_contestants()) {
    result.push_back(std::move(other));
  }
  return result;
}

}  // namespace goishi::verify::bench::contact
