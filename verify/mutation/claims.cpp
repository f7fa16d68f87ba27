/// The claims as `verify/mutants` asks them: quick, seed 1, one after the other.

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "verify/claims/claims.hpp"
#include "verify/mutation/units.hpp"
#include "verify/oracles/stone/quadrature.hpp"
#include "verify/suite/claim.hpp"

namespace {

using namespace goishi::verify;

bool holds(const Claim& claim) {
  try {
    Context context(Tier::quick, 1, claim.id);
    return judge(claim, claim.measure(context)).holds;
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<Claim> claims = all_claims();
  if (argc == 2 && std::string_view(argv[1]) == "--list") {
    for (const Claim& claim : claims) {
      fmt::print("{}\t{}\n", claim.id, to_string(claim.family));
    }
    return 0;
  }
  silence_gsl();
  for (const goishi::mutant::Unit& unit : goishi::mutant::units_of(argc, argv)) {
    const auto claim = std::ranges::find(claims, unit.name, &Claim::id);
    goishi::mutant::begin(unit);
    if (claim == claims.end() || !holds(*claim)) {
      return 1;
    }
  }
  return 0;
}
