/// Impacts: errors of the caller.

#include <gtest/gtest.h>

#include <goishi/published/linear_response.hpp>
#include <utility>
#include <vector>

#include "tests/impact_test.hpp"

namespace goishi::impact_test {

namespace {

/// All that take a body: alone, as the first and as the second.
void expect_invalid_body(const std::string& argument, const ImpactBody<double>& body) {
  const Material<double> material = make_material(0.5, 0.3);
  for (const ImpactLaw law : all_laws) {
    expect_invalid(argument, [&] { (void)resolve(law, material, vec(0, 0, 0), vec(0, 0, 1), body); });
    const ImpactBody<double> good = ball(vec(0, 0, -3));
    expect_invalid(argument, [&] { (void)resolve(law, material, vec(0, 0, 0), vec(0, 0, 1), body, good); });
    expect_invalid(argument, [&] { (void)resolve(law, material, vec(0, 0, 0), vec(0, 0, 1), good, body); });
  }
}

/// All that take a contact.
void expect_invalid_contact(const std::string& argument, const Material<double>& material, const Vec3<double>& p_WC,
                            const Vec3<double>& n_W) {
  const ImpactBody<double> body = ball(vec(0, 0, -3));
  for (const ImpactLaw law : all_laws) {
    expect_invalid(argument, [&] { (void)resolve(law, material, p_WC, n_W, body); });
    expect_invalid(argument, [&] { (void)resolve(law, material, p_WC, n_W, body, body); });
  }
}

TEST(BadMaterial, Restitution) {
  for (const double bad : {-1e-300, -1.0, 1.0000000000000002, 2.0, infinity, -infinity, nan}) {
    expect_invalid("restitution", [&] { (void)make_material(bad, 0.3); });
    expect_invalid_contact("restitution", {bad, 0.3}, vec(0, 0, 0), vec(0, 0, 1));
    expect_invalid("restitution", [&] { (void)linear_response(vec(0, 0, -1), vec(0, 0, 1), bad); });
  }
  expect_invalid_contact("restitution", {}, vec(0, 0, 0), vec(0, 0, 1));
}

TEST(BadMaterial, Friction) {
  for (const double bad : {-1e-300, -1.0, -infinity, nan}) {
    expect_invalid("friction", [&] { (void)make_material(0.5, bad); });
    expect_invalid_contact("friction", {0.5, bad}, vec(0, 0, 0), vec(0, 0, 1));
  }
}

TEST(BadMaterial, TheWholeRangeIsGood) {
  for (const double e : {0.0, -0.0, 5e-324, 0.5, 1.0}) {
    for (const double mu : {0.0, -0.0, 5e-324, 1e-308, 1.0, 1e300, infinity}) {
      const Material<double> material = make_material(e, mu);
      EXPECT_EQ(material.restitution, e);
      EXPECT_EQ(material.friction, mu);
      for (const ImpactLaw law : all_laws) {
        for (const Vec3<double>& v : {vec(0, 0, -3), vec(3, 4, -3), vec(-20, 1, -3), vec(1, 1, -1e-300)}) {
          const Impulse<double> found = on_plane(law, e, mu, off_centre(v)).impulse;
          EXPECT_TRUE(found.impulse_W.allFinite()) << to_string(law) << ", e = " << e << ", mu = " << mu;
          EXPECT_NE(found.outcome, ImpactOutcome::not_converged) << to_string(law) << ", e = " << e << ", mu = " << mu;
          EXPECT_LE(found.energy_change, 1e-12);
          EXPECT_GE(found.normal, -1e-14);
        }
      }
    }
  }
}

TEST(BadContact, NormalAndPoint) {
  const Material<double> material = make_material(0.5, 0.3);
  for (const Vec3<double>& bad : {vec(0, 0, 0), vec(1, 1, 0), vec(0, 0, 2), Vec3<double>(0.6, 0.0, 0.8000001),
                                  Vec3<double>(nan, 0.0, 1.0), Vec3<double>(infinity, 0.0, 0.0)}) {
    expect_invalid_contact("normal", material, vec(0, 0, 0), bad);
    expect_invalid("normal", [&] { (void)linear_response(vec(0, 0, -1), bad, 0.5); });
  }
  for (const double bad : {nan, infinity, -infinity}) {
    for (int i = 0; i < 3; ++i) {
      Vec3<double> p = vec(0, 0, 0);
      p[i] = bad;
      expect_invalid_contact("contact point", material, p, vec(0, 0, 1));
      expect_invalid("momentum", [&] { (void)linear_response(p, vec(0, 0, 1), 0.5); });
    }
  }
}

TEST(BadImpactBody, EachComponentOfEachVector) {
  using Member = Vec3<double> ImpactBody<double>::*;
  const std::vector<std::pair<std::string, Member>> members = {{"position", &ImpactBody<double>::p_WB},
                                                               {"axis", &ImpactBody<double>::u_W},
                                                               {"velocity", &ImpactBody<double>::v_WB},
                                                               {"angular momentum", &ImpactBody<double>::L_W}};
  for (const auto& [argument, member] : members) {
    for (int i = 0; i < 3; ++i) {
      for (const double bad : {nan, infinity, -infinity}) {
        ImpactBody<double> body = ball(vec(0, 0, -3));
        (body.*member)[i] = bad;
        expect_invalid_body(argument, body);
      }
    }
  }
  for (const Vec3<double>& bad : {vec(0, 0, 0), vec(0, 0, 1.000001L)}) {
    ImpactBody<double> body = ball(vec(0, 0, -3));
    body.u_W = bad;
    expect_invalid_body("axis", body);
  }
  expect_invalid_body("position", {});
}

TEST(BadImpactBody, Mobility) {
  using Member = double Mobility<double>::*;
  for (const Member member : {&Mobility<double>::linear, &Mobility<double>::transverse, &Mobility<double>::axial}) {
    for (const double bad : {nan, infinity, -infinity, -1e3}) {
      ImpactBody<double> body = ball(vec(0, 0, -3));
      body.mobility.*member = bad;
      expect_invalid_body("mobility", body);
    }
  }
  // Two fixed bodies.
  ImpactBody<double> fixed = ball(vec(0, 0, -3));
  fixed.mobility = fixed_mobility<double>();
  expect_invalid("mobility", [&] {
    (void)resolve(ImpactLaw::chatterjee_ruina, make_material(0.5, 0.3), vec(0, 0, 0), vec(0, 0, 1), fixed, fixed);
  });
  const Moments<double> moments{.axial = 2.0, .transverse = 1.0};
  EXPECT_NO_THROW((void)make_mobility(1.0, moments));
  for (const double bad : {0.0, -1.0, nan, infinity}) {
    expect_invalid("mass", [&] { (void)make_mobility(bad, moments); });
    expect_invalid("mass", [&] { (void)make_linear_mobility(bad); });
    expect_invalid("axial", [&] { (void)make_mobility(1.0, Moments<double>{.axial = bad, .transverse = 1.0}); });
    expect_invalid("transverse", [&] { (void)make_mobility(1.0, Moments<double>{.axial = 1.0, .transverse = bad}); });
  }
  expect_invalid("axial", [&] { (void)make_mobility(1.0, Moments<double>{.axial = 2.001, .transverse = 1.0}); });
  // Whose inverses are no normal numbers.
  for (const double bad : {1e-320, 1.7e308}) {
    expect_invalid("mass", [&] { (void)make_mobility(bad, moments); });
  }
  expect_invalid("transverse", [&] { (void)make_mobility(1.0, Moments<double>{.axial = 1.0, .transverse = 6e307}); });
  expect_invalid("axial", [&] { (void)make_mobility(1.0, Moments<double>{.axial = 6e307, .transverse = 4e307}); });
}

}  // namespace
}  // namespace goishi::impact_test
