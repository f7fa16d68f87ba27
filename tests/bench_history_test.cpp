/// The drops that were recorded of an earlier commit: the file that the report draws, and who reads it.

#include "verify/bench/history/history.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace goishi::verify::bench::history {

namespace {

TEST(BenchHistory, TheFileHasBothCurvesOfEachProblem) {
  const History all = read(recorded());
  EXPECT_EQ(all.facts.at("old"), "3c830af");
  EXPECT_EQ(all.facts.at("new").substr(0, 7).find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(all.facts.at("new").find("-changed"), std::string::npos) << "measured of a tree that no commit has";
  EXPECT_EQ(all.facts.at("drops"), "128");
  ASSERT_EQ(all.curves.size(), 4U);
  EXPECT_EQ(all.curves[0].problem, "set-down");
  EXPECT_EQ(all.curves[2].problem, "thrown");
  for (const Curve& curve : all.curves) {
    ASSERT_EQ(curve.points.size(), 9U);
    EXPECT_EQ(curve.points.front().tolerance, 1e-3);
    EXPECT_EQ(curve.points.back().tolerance, 1e-11);
    // Nine orders of the tolerance are at least six of the error, and cost at least five times as much.
    EXPECT_LT(curve.points.back().error, 1e-6 * curve.points.front().error);
    EXPECT_LT(5.0 * curve.points.front().time, curve.points.back().time);
    for (const Point& point : curve.points) {
      EXPECT_LE(point.time, point.late);
      EXPECT_LE(point.error, point.late_error);
    }
  }
}

std::string changed(const std::string& from, const std::string& to) {
  std::string file(recorded());
  const std::size_t at = file.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return file.replace(at, from.size(), to);
}

TEST(BenchHistory, RefusesAFileThatIsNotWhole) {
  EXPECT_NO_THROW((void)read(recorded()));
  EXPECT_THROW((void)read(""), std::runtime_error);
  EXPECT_THROW((void)read(changed("# old: ", "# new: ")), std::runtime_error);
  EXPECT_THROW((void)read(changed("# machine: ", "# made: ")), std::runtime_error);
  EXPECT_THROW((void)read(changed("ns_p90", "p90")), std::runtime_error);
  EXPECT_THROW((void)read(changed(",1e-4,", ",1e-2,")), std::runtime_error);
  EXPECT_THROW((void)read(changed(",1e-4,", ",2e-4,")), std::runtime_error);
  EXPECT_THROW((void)read(changed(",1e-4,", ",nan,")), std::runtime_error);
  EXPECT_THROW((void)read(changed(",1e-4,", ",")), std::runtime_error);
  EXPECT_THROW((void)read(changed("\nset-down,3c830af,1e-11", "\nset-down,3c830ag,1e-11")), std::runtime_error);
}

}  // namespace
}  // namespace goishi::verify::bench::history
