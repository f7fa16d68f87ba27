#include <iterator>
#include <utility>

#include "verify/claims/claims.hpp"

namespace goishi::verify {

std::vector<Claim> all_claims() {
  std::vector<Claim> all;
  const std::pair<const char*, std::vector<Claim> (*)()> subjects[] = {
      {"claims/scalar/elementary.cpp", elementary_claims},
      {"claims/shape/domain_stone.cpp", domain_stone_claims},
      {"claims/shape/domain_board.cpp", domain_board_claims},
      {"claims/shape/domain_ray.cpp", domain_ray_claims},
      {"claims/shape/surface.cpp", surface_claims},
      {"claims/shape/surface_laws.cpp", surface_law_claims},
      {"claims/shape/board.cpp", board_claims},
      {"claims/mesh/tessellation.cpp", mesh_tessellation_claims},
      {"claims/mesh/solid.cpp", mesh_solid_claims},
      {"claims/mass/accuracy.cpp", accuracy_claims},
      {"claims/mass/certified.cpp", certified_claims},
      {"claims/mass/gsl.cpp", gsl_claims},
      {"claims/mass/laws.cpp", law_claims},
      {"claims/mass/tensor.cpp", tensor_claims},
      {"claims/mass/table.cpp", table_claims},
      {"claims/mass/domain.cpp", domain_tensor_claims},
      {"claims/enclosure/formulas.cpp", enclosure_claims},
      {"claims/enclosure/branches.cpp", enclosure_branch_claims},
      {"claims/enclosure/switches.cpp", enclosure_switch_claims},
      {"claims/enclosure/boxes.cpp", enclosure_box_claims},
      {"claims/motion/domain_batch.cpp", domain_batch_claims},
      {"claims/motion/domain_steppers.cpp", domain_steppers_claims},
      {"claims/motion/domain.cpp", domain_motion_claims},
      {"claims/motion/flight.cpp", flight_claims},
      {"claims/motion/elliptic.cpp", elliptic_claims},
      {"claims/motion/laws.cpp", motion_law_claims},
      {"claims/motion/order.cpp", order_claims},
      {"claims/motion/cases.cpp", case_claims},
      {"claims/contact/separation.cpp", contact_claims},
      {"claims/contact/pair.cpp", contact_pair_claims},
      {"claims/contact/points.cpp", contact_point_claims},
      {"claims/contact/laws.cpp", contact_law_claims},
      {"claims/contact/lipschitz.cpp", contact_lipschitz_claims},
      {"claims/contact/domain.cpp", domain_contact_claims},
      {"claims/contact/time_of_impact.cpp", time_of_impact_claims},
      {"claims/contact/time_of_impact_bodies.cpp", time_of_impact_body_claims},
      {"claims/contact/time_of_impact_odeint.cpp", time_of_impact_odeint_claims},
      {"claims/impact/domain.cpp", domain_impact_claims},
      {"claims/impact/laws.cpp", impact_claims},
      {"claims/impact/process.cpp", impact_process_claims},
      {"claims/impact/slip.cpp", impact_slip_claims},
      {"claims/drop/bounces.cpp", drop_bounces_claims},
      {"claims/drop/rocking.cpp", drop_rocking_claims},
      {"claims/drop/rolling.cpp", drop_rolling_claims},
      {"claims/drop/friction.cpp", drop_friction_claims},
      {"claims/drop/spin.cpp", drop_spin_claims},
      {"claims/drop/statics.cpp", drop_statics_claims},
      {"claims/drop/sliding.cpp", drop_sliding_claims},
      {"claims/drop/odeint.cpp", drop_odeint_claims},
      {"claims/drop/whole.cpp", drop_whole_claims},
      {"claims/drop/scale.cpp", drop_scale_claims},
      {"claims/drop/board.cpp", drop_board_claims},
      {"claims/drop/tolerance.cpp", drop_tolerance_claims},
      {"claims/drop/value.cpp", drop_value_claims},
      {"claims/drop/picture.cpp", drop_picture_claims},
      {"claims/scene/alone.cpp", scene_alone_claims},
      {"claims/scene/impacts.cpp", scene_impact_claims},
      {"claims/scene/statics.cpp", scene_statics_claims},
      {"claims/scene/cluster.cpp", scene_cluster_claims},
      {"claims/scene/witness.cpp", scene_witness_claims},
      {"claims/scene/convergence.cpp", scene_convergence_claims},
      {"claims/scene/random.cpp", scene_random_claims},
      {"claims/scene/contacts.cpp", scene_contact_claims},
      {"claims/published/numbers.cpp", published_claims},
      {"claims/published/motion.cpp", published_motion_claims},
      {"claims/published/contact.cpp", published_contact_claims},
      {"claims/published/impact.cpp", published_impact_claims},
      {"claims/published/drop.cpp", published_drop_claims}};
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
