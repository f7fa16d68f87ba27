#include <iterator>
#include <utility>

#include "verify/claims/claims.hpp"

namespace goishi::verify {

std::vector<Claim> all_claims() {
  std::vector<Claim> all;
  for (auto* subject :
       {accuracy_claims, enclosure_claims, gsl_claims, law_claims, tensor_claims, table_claims, published_claims}) {
    std::vector<Claim> claims = subject();
    all.insert(all.end(), std::make_move_iterator(claims.begin()), std::make_move_iterator(claims.end()));
  }
  return all;
}

}  // namespace goishi::verify
