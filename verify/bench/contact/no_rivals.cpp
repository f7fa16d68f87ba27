#include "verify/bench/contact/contact.hpp"

namespace goishi::verify::bench::contact {

std::vector<Contestant<Scene>> rival_contestants() {
  return {};
}

}  // namespace goishi::verify::bench::contact
