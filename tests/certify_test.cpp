/// What certifies printed digits must refuse a wrong one.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <goishi/mass/inertia_table.hpp>
#include <iomanip>
#include <sstream>
#include <string>

#include "verify/certify/certify.hpp"
#include "verify/certify/printed.hpp"
#include "verify/certify/sentences.hpp"
#include "verify/certify/table_text.hpp"
#include "verify/certify/witness.hpp"

namespace goishi::verify::certify {
namespace {

bool certifies(const char* text, const Ball& exact, int least_digits = 0) {
  const auto printed = read_printed(text);
  return printed && is_certified(*printed, exact, least_digits);
}

TEST(Printed, IsTheRoundedDecimalOrNot) {
  const Ball third = Ball(1) / Ball(3);
  EXPECT_TRUE(certifies("0.333", third));
  EXPECT_TRUE(certifies("3.333e-01", third));
  EXPECT_TRUE(certifies("−0.3333333333333333", -third));
  EXPECT_FALSE(certifies("0.334", third));
  EXPECT_FALSE(certifies("0.332", third));
  EXPECT_FALSE(certifies("-0.333", third));
  EXPECT_TRUE(certifies("0.67", Ball(2) / Ball(3)));
  EXPECT_FALSE(certifies("0.66", Ball(2) / Ball(3)));
}

TEST(Printed, ATieOrAWideEnclosureProvesNothing) {
  EXPECT_FALSE(certifies("0.12", Ball(1) / Ball(8)));
  EXPECT_FALSE(certifies("0.13", Ball(1) / Ball(8)));
  Ball wide(1);
  arb_add_error_2exp_si(wide.get(), -10);  // ± 0.001
  EXPECT_TRUE(certifies("1.00", wide));
  EXPECT_FALSE(certifies("1.000", wide));
  EXPECT_FALSE(certifies("1.00", Ball(1) / Ball(0)));
}

TEST(Printed, FewDigitsMustBeExact) {
  EXPECT_TRUE(certifies("0.022", Ball(22) / Ball(1000), 6));
  EXPECT_FALSE(certifies("0.022", Ball(2201) / Ball(100000), 6));
  EXPECT_TRUE(certifies("0", Ball(0), 6));
  EXPECT_FALSE(certifies("0", Ball(1) / Ball(1000), 6));
}

TEST(Printed, OtherTextIsNoNumber) {
  for (const char* text : {"", "-", "1.", ".5", "1e", "1e+", "1.2.3", "1,2", " 1", "nan", "0x1", "1e99999"}) {
    EXPECT_FALSE(read_printed(text)) << text;
  }
}

TEST(Printed, TheNearestDouble) {
  EXPECT_TRUE(is_the_nearest(1.0 / 3.0, Ball(1) / Ball(3)));
  EXPECT_FALSE(is_the_nearest(std::nextafter(1.0 / 3.0, 1.0), Ball(1) / Ball(3)));
  EXPECT_FALSE(is_the_nearest(std::nextafter(1.0 / 3.0, 0.0), Ball(1) / Ball(3)));
}

/// A table of I_a alone, from the shipped one.
std::string csv_of(double factor = 1.0, int wrong_row = -1) {
  std::ostringstream text;
  text << "number,color,bevel_m,axial_kg_m2\n";
  int index = 0;
  for (const InertiaRow& row : inertia_table) {
    const double value = row.axial * (index++ == wrong_row ? factor : 1.0);
    text << row.number << ',' << to_string(row.color) << ',' << row.bevel << ',' << std::setprecision(11) << value
         << '\n';
  }
  return text.str();
}

TEST(CertifyTable, CertifiesEachNumber) {
  const Outcome outcome = certify_table(csv_of());
  EXPECT_TRUE(outcome.faults.empty()) << outcome.faults.front();
  EXPECT_EQ(outcome.certified, 192);  // bevel and I_a
}

TEST(CertifyTable, FindsTheWrongNumber) {
  const Outcome outcome = certify_table(csv_of(1.0 + 1e-9, 7));
  ASSERT_EQ(outcome.faults.size(), 1U);
  EXPECT_EQ(outcome.certified, 191);
  EXPECT_NE(outcome.faults[0].find("axial of size 25 black, b = 1000 µm"), std::string::npos) << outcome.faults[0];
}

TEST(CertifyTable, MissesARow) {
  const std::string text = csv_of();
  const std::string shorter = text.substr(0, text.rfind('\n', text.size() - 2) + 1);
  EXPECT_EQ(certify_table(shorter).faults.size(), 1U);
  const std::string last = text.substr(shorter.size());
  EXPECT_EQ(certify_table(text + last).faults.size(), 2U);  // twice, and too many
}

/// The head, and the rows that contain the text.
std::string rows_of(const std::string& table, const std::string& text) {
  std::istringstream lines(table);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    result += result.empty() || line.find(text) != std::string::npos ? line + '\n' : "";
  }
  return result;
}

TEST(CertifyTable, AWholeOneHasBothColorsSharpAndBevelled) {
  EXPECT_TRUE(certify_table(csv_of(), true).faults.empty());
  for (const char* part : {",white,", ",black,", ",0,", ",0.001,"}) {
    const std::string half = rows_of(csv_of(), part);
    EXPECT_TRUE(certify_table(half).faults.empty()) << part;
    EXPECT_EQ(certify_table(half).certified, 96) << part;
    EXPECT_EQ(certify_table(half, true).faults.size(), 2U) << part;
  }
}

TEST(CertifyTable, IsByOneStandard) {
  const std::string row = "number,color,bevel_m,width_m\n33,black,0,";
  const auto certified = [&](const char* width, Standard standard) {
    return certify_table(row + width + "\n", false, standard).certified;
  };
  EXPECT_EQ(certified("0.0223", Standard::talk), 2);
  EXPECT_EQ(certified("0.0222", Standard::nihon_kiin), 2);
  EXPECT_EQ(certified("0.0222", Standard::talk), 1);  // the bevel
  EXPECT_EQ(certified("0.0223", Standard::nihon_kiin), 1);
}

TEST(CertifyTable, AUnitIsOneOfTheQuantity) {
  const auto certify = [](const std::string& head, const std::string& row) {
    return certify_table("number,color,bevel_m," + head + "\n22,white,0," + row + "\n").certified;
  };
  EXPECT_EQ(certify("axial_per_mass_m2", "0.000040896317"), 2);
  EXPECT_EQ(certify("axial_per_mass_cm2", "0.40896317"), 2);
  EXPECT_THROW((void)certify("axial_per_mass_kg_m2", "0.000040896317"), std::runtime_error);
  EXPECT_THROW((void)certify("width_kg", "0.022"), std::runtime_error);
  EXPECT_THROW((void)certify("density_g", "2800000"), std::runtime_error);
}

TEST(CertifyTable, AStoneIsNamedToTheLetter) {
  for (const std::string row : {"22,blakc,0,0.022", "22a,white,0,0.022", " ,white,0,0.022", "22,white,0x,0.022",
                                "22,white,1mm,0.022", "22,white,inf,0.022", "22,white,nan,0.022"}) {
    EXPECT_THROW((void)certify_table("number,color,bevel_m,width_m\n" + row + "\n"), std::runtime_error) << row;
  }
}

TEST(CertifyTable, SaysWhatItCannotRead) {
  EXPECT_THROW((void)certify_table(""), std::runtime_error);
  EXPECT_THROW((void)certify_table("number,color\n"), std::runtime_error);
  EXPECT_THROW((void)certify_table("number,color,bevel_m,axial_kg_m2\n22,white,0\n"), std::runtime_error);
  EXPECT_THROW((void)certify_table("number,color,bevel_m,axial_furlongs\n22,white,0,1\n"), std::runtime_error);
  EXPECT_THROW((void)certify_table("number,color,bevel_m,beauty_m\n22,white,0,1\n"), std::runtime_error);
  EXPECT_THROW((void)certify_table("{\"units\": 3}"), std::runtime_error);
  EXPECT_THROW((void)certify_document("# A README\n\n| size |\n|---|\n| 22 |\n"), std::runtime_error);
}

TEST(ReadTable, MarkerFixesColumns) {
  const TableText table = read_marked_table(
      "text\n<!-- goishi table --color white --bevel 0 --units cgs -->\n\n| size | width × height [cm] |\n|---|---|\n"
      "| 22 | 2.2 × 0.63 |\n\n| other |\n|---|\n| 1 |\n");
  ASSERT_EQ(table.columns.size(), 5U);
  EXPECT_EQ(table.columns[0].key, "number");
  EXPECT_EQ(table.columns[2].key, "height");
  EXPECT_EQ(table.columns[2].unit, "cm");
  EXPECT_EQ(table.rows, (std::vector<std::vector<std::string>>{{"22", "2.2", "0.63", "white", "0"}}));
}

TEST(ReadTable, TheMarkersBevelMayHaveAUnit) {
  const auto certified = [](const std::string& bevel) {
    std::string text = "<!-- goishi table --bevel " + bevel + " -->\n\n| size | color | height [m] |\n|---|---|---|\n";
    for (const catalogue::Size& size : catalogue::sizes) {
      text += "| " + std::to_string(size.number) + " | white | " +
              std::to_string(metres<double>(catalogue_stone(size.number, StoneColor::white).height)) + " |\n";
    }
    return read_marked_table(text);
  };
  for (const auto& [bevel, cell, unit] :
       {std::array{"1mm", "1", "mm"}, std::array{"0.001", "0.001", "m"}, std::array{"0.1cm", "0.1", "cm"}}) {
    const TableText table = certified(bevel);
    EXPECT_EQ(table.columns.back().unit, unit);
    EXPECT_EQ(table.rows.back().back(), cell);
  }
}

TEST(Sentences, AreFoundAndJudged) {
  const std::vector<Sentence> sentences = {{"README.md", "diag({}, {})", {Ball(1) / Ball(3), Ball(2) / Ball(3)}}};
  const auto judged = [&](const char* text) {
    Outcome outcome;
    judge_sentences(text, sentences, outcome);
    return outcome;
  };
  EXPECT_EQ(judged("It is diag(0.33,\n  0.667) exactly.").certified, 2);
  EXPECT_TRUE(judged("diag(x) and then diag(0.33, 0.667)").faults.empty());
  EXPECT_EQ(judged("It is diag(0.33, 0.666).").faults.size(), 1U);
  EXPECT_EQ(judged("It is diag(0.33; 0.667).").faults.size(), 1U);
}

TEST(Sentences, BelongToADocument) {
  EXPECT_EQ(document_of("/any/where/README.md"), "README.md");
  EXPECT_EQ(document_of("/any/where/src/goishi/README.md"), "src/goishi/README.md");
  EXPECT_EQ(document_of("/any/verify/../verify/claims/published/README.md"), "verify/claims/published/README.md");
  EXPECT_EQ(document_of("-"), "README.md");
  for (const std::string_view document : documents) {
    EXPECT_FALSE(exact_results(document).empty()) << document;
    Outcome nothing_there;
    judge_sentences("", exact_results(document), nothing_there);
    EXPECT_EQ(nothing_there.faults.size(), exact_results(document).size()) << document;
  }
  EXPECT_TRUE(exact_results("other.md").empty());
}

TEST(SettlingTilt, BelowTheThresholdNothingRises) {
  const SpinningCap<Ball> stone = spinning_cap(catalogue_stone(33, StoneColor::white), Ball::from_decimal("9.80665"));
  EXPECT_NEAR(static_cast<double>(stone.threshold()), 27.930, 5e-4);
  EXPECT_THROW((void)settling_tilt(stone, Ball(27)), std::runtime_error);
}

}  // namespace
}  // namespace goishi::verify::certify
