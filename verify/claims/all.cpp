#include <iterator>
#include <utility>

#include "verify/claims/claims.hpp"

namespace goishi::verify {

std::vector<Claim> all_claims() {
  std::vector<Claim> all;
  const std::pair<const char*, std::vector<Claim> (*)()> subjects[] = {
      {"claims/accuracy.cpp", accuracy_claims},
      {"claims/enclosure.cpp", enclosure_claims},
      {"claims/enclosure_branches.cpp", enclosure_branch_claims},
      {"claims/enclosure_switches.cpp", enclosure_switch_claims},
      {"claims/enclosure_boxes.cpp", enclosure_box_claims},
      {"claims/certified.cpp", certified_claims},
      {"claims/gsl.cpp", gsl_claims},
      {"claims/laws.cpp", law_claims},
      {"claims/tensor.cpp", tensor_claims},
      {"claims/table.cpp", table_claims},
      {"claims/domain_stone.cpp", domain_stone_claims},
      {"claims/domain_board.cpp", domain_board_claims},
      {"claims/domain_ray.cpp", domain_ray_claims},
      {"claims/domain_tensor.cpp", domain_tensor_claims},
      {"claims/domain_batch.cpp", domain_batch_claims},
      {"claims/domain_steppers.cpp", domain_steppers_claims},
      {"claims/domain_motion.cpp", domain_motion_claims},
      {"claims/domain_impact.cpp", domain_impact_claims},
      {"claims/published.cpp", published_claims},
      {"claims/flight.cpp", flight_claims},
      {"claims/elliptic.cpp", elliptic_claims},
      {"claims/motion_laws.cpp", motion_law_claims},
      {"claims/order.cpp", order_claims},
      {"claims/cases.cpp", case_claims},
      {"claims/published_motion.cpp", published_motion_claims},
      {"claims/surface.cpp", surface_claims},
      {"claims/surface_laws.cpp", surface_law_claims},
      {"claims/board.cpp", board_claims},
      {"claims/contact.cpp", contact_claims},
      {"claims/contact_pair.cpp", contact_pair_claims},
      {"claims/contact_points.cpp", contact_point_claims},
      {"claims/contact_laws.cpp", contact_law_claims},
      {"claims/contact_lipschitz.cpp", contact_lipschitz_claims},
      {"claims/domain_contact.cpp", domain_contact_claims},
      {"claims/time_of_impact.cpp", time_of_impact_claims},
      {"claims/time_of_impact_bodies.cpp", time_of_impact_body_claims},
      {"claims/time_of_impact_odeint.cpp", time_of_impact_odeint_claims},
      {"claims/published_contact.cpp", published_contact_claims},
      {"claims/impact.cpp", impact_claims},
      {"claims/impact_process.cpp", impact_process_claims},
      {"claims/published_impact.cpp", published_impact_claims},
      {"claims/published_drop.cpp", published_drop_claims},
      {"claims/drop_bounces.cpp", drop_bounces_claims},
      {"claims/drop_rocking.cpp", drop_rocking_claims},
      {"claims/drop_rolling.cpp", drop_rolling_claims},
      {"claims/drop_friction.cpp", drop_friction_claims},
      {"claims/drop_spin.cpp", drop_spin_claims},
      {"claims/drop_sliding.cpp", drop_sliding_claims},
      {"claims/drop_odeint.cpp", drop_odeint_claims},
      {"claims/drop_whole.cpp", drop_whole_claims},
      {"claims/drop_scale.cpp", drop_scale_claims},
      {"claims/drop_picture.cpp", drop_picture_claims}};
  for (const auto& [source, subject] : subjects) {
    std::vector<Claim> claims = subject();
    for (Claim& claim : claims) {
      claim.source = source;
    }
    all.insert(all.end(), std::make_move_iterator(claims.begin()), std::make_move_iterator(claims.end()));
  }
  return all;
}

}  // namespace goishi::verify
