#pragma once
/// \file
/// All claims, one file per subject.

#include <vector>

#include "verify/suite/claim.hpp"

namespace goishi::verify {

[[nodiscard]] std::vector<Claim> elementary_claims();        // SINE, ATAN: our own sine, cosine, arctangent
[[nodiscard]] std::vector<Claim> accuracy_claims();          // SHAPE, MASS: ulps of float and double
[[nodiscard]] std::vector<Claim> enclosure_claims();         // ENCLOSURE: balls contain, and are narrow
[[nodiscard]] std::vector<Claim> enclosure_branch_claims();  // ENCLOSURE: whole functions on balls, choices proved
[[nodiscard]] std::vector<Claim> enclosure_switch_claims();  // ENCLOSURE: both branches meet where a function switches
[[nodiscard]] std::vector<Claim> enclosure_box_claims();     // ENCLOSURE: signs, proved on boxes that cover the domain
[[nodiscard]] std::vector<Claim> certified_claims();         // CERTIFIED: closed forms meet rigorous integration
[[nodiscard]] std::vector<Claim> gsl_claims();               // GSL: quadrature of profile and solid
[[nodiscard]] std::vector<Claim> law_claims();               // LAW: limits, scaling, sandwich, Steiner
[[nodiscard]] std::vector<Claim> tensor_claims();            // TENSOR: frames, points, principal axes
[[nodiscard]] std::vector<Claim> domain_stone_claims();      // DOMAIN: shape, mass and surface of stones of any size
[[nodiscard]] std::vector<Claim> domain_board_claims();      // DOMAIN: boards, their regions, rays at them
[[nodiscard]] std::vector<Claim> domain_ray_claims();        // DOMAIN: rays at stones
[[nodiscard]] std::vector<Claim> domain_tensor_claims();     // DOMAIN: principal axes
[[nodiscard]] std::vector<Claim> domain_batch_claims();      // DOMAIN: gaps of many stones to a plane
[[nodiscard]] std::vector<Claim> domain_steppers_claims();   // DOMAIN: steps of every scheme, and invariants
[[nodiscard]] std::vector<Claim> domain_motion_claims();     // DOMAIN: flights of any size and length
[[nodiscard]] std::vector<Claim> domain_impact_claims();     // DOMAIN: impacts of any size
[[nodiscard]] std::vector<Claim> table_claims();             // TABLE: the generated inertia table, certified; the sizes
[[nodiscard]] std::vector<Claim> published_claims();         // PUBLISHED: the talk's numbers, reproduced and refuted
[[nodiscard]] std::vector<Claim> flight_claims();  // FLIGHT, BATCH: the exact flight against Odeint, and what it keeps
[[nodiscard]] std::vector<Claim> elliptic_claims();           // ELLIPTIC: the exact flight of an asymmetric body
[[nodiscard]] std::vector<Claim> motion_law_claims();         // MOTION: time reversal, rotated worlds, scaling, frames
[[nodiscard]] std::vector<Claim> order_claims();              // ORDER: the steppers' orders, drift, divergence
[[nodiscard]] std::vector<Claim> case_claims();               // CASE: published cases of rigid-body motion
[[nodiscard]] std::vector<Claim> published_motion_claims();   // PUBLISHED: the talk's loops, and how far they are off
[[nodiscard]] std::vector<Claim> surface_claims();            // SURFACE: support, distance, rays
[[nodiscard]] std::vector<Claim> surface_law_claims();        // SURFACE: what holds for any convex body of revolution
[[nodiscard]] std::vector<Claim> mesh_tessellation_claims();  // MESH: triangles, their distance, their number
[[nodiscard]] std::vector<Claim> mesh_solid_claims();         // MESH: what a mesh encloses, boxes, supports
[[nodiscard]] std::vector<Claim> board_claims();              // BOARD: regions, rays, the boards by standard
[[nodiscard]] std::vector<Claim> contact_claims();            // CONTACT: plane and board against 50 digits and search
[[nodiscard]] std::vector<Claim> contact_pair_claims();       // CONTACT: two stones against search
[[nodiscard]] std::vector<Claim> contact_point_claims();      // CONTACT: normals and contact points
[[nodiscard]] std::vector<Claim> contact_law_claims();        // CONTACT: moved and mirrored worlds, a million poses
[[nodiscard]] std::vector<Claim> contact_lipschitz_claims();  // CONTACT: a gap changes by no more than the stone moves
[[nodiscard]] std::vector<Claim> domain_contact_claims();     // DOMAIN-CONTACT: to the ends of what is stated
[[nodiscard]] std::vector<Claim> time_of_impact_claims();     // TOI: a plane; where a flight starts
[[nodiscard]] std::vector<Claim> time_of_impact_body_claims();    // TOI: the board, another flying stone
[[nodiscard]] std::vector<Claim> time_of_impact_odeint_claims();  // TOI: against Odeint with events
[[nodiscard]] std::vector<Claim> published_contact_claims();      // PUBLISHED: the talk's test, push-out and support
[[nodiscard]] std::vector<Claim> impact_claims();                 // IMPACT: restitution, momentum, energy, friction
[[nodiscard]] std::vector<Claim>
impact_process_claims();  // IMPACT: Stronge's law in a plane, and the default law beside it
[[nodiscard]] std::vector<Claim> impact_slip_claims();        // IMPACT: Stronge's law out of the plane
[[nodiscard]] std::vector<Claim> published_impact_claims();   // PUBLISHED: the talk's impacts
[[nodiscard]] std::vector<Claim> published_drop_claims();     // PUBLISHED: the talk's loop on whole drops
[[nodiscard]] std::vector<Claim> drop_odeint_claims();        // DROP: contact phases against Lagrange's equations
[[nodiscard]] std::vector<Claim> drop_picture_claims();       // DROP: a drop's height, tilt and energy
[[nodiscard]] std::vector<Claim> drop_whole_claims();         // DROP: every link of a drop, its end, random drops
[[nodiscard]] std::vector<Claim> drop_bounces_claims();       // DROP: flat and elastic bounces, oblique impacts
[[nodiscard]] std::vector<Claim> drop_rocking_claims();       // DROP: periods, decay by resistance and by damping
[[nodiscard]] std::vector<Claim> drop_rolling_claims();       // DROP: what rolling keeps, ball, coin, Euler's disc
[[nodiscard]] std::vector<Claim> drop_friction_claims();      // DROP: Jellett's integral, Coulomb–Contensou friction
[[nodiscard]] std::vector<Claim> drop_spin_claims();          // DROP: threshold and settling tilts of a flat spin
[[nodiscard]] std::vector<Claim> drop_statics_claims();       // DROP: what is held, and what the drop does with it
[[nodiscard]] std::vector<Claim> drop_sliding_claims();       // DROP: sliding to a stop, slopes, waking
[[nodiscard]] std::vector<Claim> drop_board_claims();         // DROP: on a board, over its edge
[[nodiscard]] std::vector<Claim> drop_tolerance_claims();     // DROP: error by tolerance; float
[[nodiscard]] std::vector<Claim> drop_value_claims();         // DROP: cut, stored, looked back on; a step's stages
[[nodiscard]] std::vector<Claim> drop_scale_claims();         // DROP: other units, other sizes
[[nodiscard]] std::vector<Claim> scene_alone_claims();        // SCENE: what must change nothing
[[nodiscard]] std::vector<Claim> scene_impact_claims();       // SCENE: when two stones meet, and how
[[nodiscard]] std::vector<Claim> scene_statics_claims();      // SCENE: what stands still
[[nodiscard]] std::vector<Claim> scene_cluster_claims();      // SCENE: clusters: steps, laws
[[nodiscard]] std::vector<Claim> scene_witness_claims();      // SCENE: clusters beside another scheme
[[nodiscard]] std::vector<Claim> scene_convergence_claims();  // SCENE: error by step
[[nodiscard]] std::vector<Claim> scene_random_claims();       // SCENE: random boards
[[nodiscard]] std::vector<Claim> scene_contact_claims();      // SCENE: contacts of a cluster, step by step

[[nodiscard]] std::vector<Claim> all_claims();

}  // namespace goishi::verify
