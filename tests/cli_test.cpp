/// The program `goishi`: what it prints.

#include "tests/cli_test.hpp"

#include <algorithm>
#include <cmath>
#include <goishi/mass/inertia.hpp>
#include <goishi/mass/inertia_table.hpp>
#include <goishi/shape/stone.hpp>
#include <regex>
#include <sstream>

namespace goishi::cli_test {

namespace {

using Members = std::vector<std::pair<std::string, std::string>>;

/// The members of JSON objects whose values are numbers or words, in their order.
Members members_of(const std::string& json) {
  static const std::regex member("\"(\\w+)\": \"?([^\",\n{[]+)");
  Members members;
  for (std::sregex_iterator i(json.begin(), json.end(), member), end; i != end; ++i) {
    members.emplace_back((*i)[1], (*i)[2]);
  }
  return members;
}

std::string value_of(const Members& members, const std::string& key) {
  const auto found = std::ranges::find(members, key, &Members::value_type::first);
  return found == members.end() ? "no such key" : found->second;
}

double number_of(const Members& members, const std::string& key) {
  return std::strtod(value_of(members, key).c_str(), nullptr);
}

bool is_json_number(const std::string& text) {
  return std::regex_match(text, std::regex("-?(0|[1-9]\\d*)(\\.\\d+)?([eE][-+]?\\d+)?"));
}

int significant_digits(std::string text) {
  text = text.substr(0, text.find('e'));
  std::erase(text, '.');
  return static_cast<int>(text.size() - text.find_first_not_of('0'));
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) {
    parts.push_back(part);
  }
  return parts;
}

const std::vector<std::string> keys = {"width",
                                       "height",
                                       "bevel",
                                       "sphere_radius",
                                       "sphere_offset",
                                       "bevel_major_radius",
                                       "bevel_minor_radius",
                                       "outer_width",
                                       "volume",
                                       "surface_area",
                                       "density",
                                       "mass",
                                       "axial",
                                       "transverse",
                                       "axial_per_mass",
                                       "transverse_per_mass"};

void expect_close(double actual, double expected, const std::string& what) {
  EXPECT_LE(std::fabs(actual - expected), 8 * 0x1p-52 * std::fabs(expected))  // 8 to 16 ulp
      << what << ": " << actual << " and " << expected;
}

/// `digits` and `nearest` are the same number, rounded to 17 digits and to a double.
void expect_same_number(const std::string& digits, double nearest) {
  const double ulp = std::nextafter(nearest, 2 * nearest + 1) - nearest;
  const long double half_digit = 0.5e-16L * nearest;  // at most
  EXPECT_LE(std::fabs(std::strtold(digits.c_str(), nullptr) - nearest), ulp / 2 + half_digit)
      << digits << " and " << nearest;
}

void expect_properties(const Members& members, const Stone<double>& stone, const MassProperties<double>& properties) {
  const double expected[] = {stone.width,
                             stone.height,
                             stone.bevel,
                             stone.sphere_radius,
                             stone.sphere_offset,
                             stone.bevel_major_radius,
                             stone.bevel_minor_radius,
                             outer_width(stone),
                             properties.volume,
                             properties.surface_area,
                             properties.density,
                             properties.mass,
                             properties.moments.axial,
                             properties.moments.transverse,
                             properties.moments_per_mass.axial,
                             properties.moments_per_mass.transverse};
  for (std::size_t i = 0; i < keys.size(); ++i) {
    expect_close(number_of(members, keys[i]), expected[i], keys[i]);
  }
}

using CliInertia = Cli;
using CliTable = Cli;
using CliStandard = Cli;
using CliUnits = Cli;

// --- inertia

TEST_F(CliInertia, JsonHasTheKeysInOrderAnd17Digits) {
  const Members members = members_of(printed({"inertia", "--size", "33", "--bevel", "1mm", "--format", "json"}));
  ASSERT_EQ(members.size(), keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    EXPECT_EQ(members[i].first, keys[i]);
    EXPECT_TRUE(is_json_number(members[i].second)) << members[i].second;
    EXPECT_EQ(significant_digits(members[i].second), 17) << members[i].second;
  }
}

TEST_F(CliInertia, JsonIsOneObject) {
  const std::string json = printed({"inertia", "--size", "22", "--format", "json"});
  EXPECT_TRUE(std::regex_match(json, std::regex("\\{\n(  \"\\w+\": [-+.e0-9]+,\n){15}"
                                                "  \"\\w+\": [-+.e0-9]+\n\\}\n")))
      << json;
}

TEST_F(CliInertia, AgreesWithTheLibrary) {
  const auto sharp = make_stone(0.022, 0.0092);
  expect_properties(members_of(printed({"inertia", "--size", "33", "--format", "json"})), sharp,
                    mass_properties(sharp, Density{2800.0}));
  const auto black = make_stone(0.0223, 0.0098, 0.001);
  expect_properties(
      members_of(printed({"inertia", "--size", "33", "--color", "black", "--bevel", "1mm", "--format", "json"})), black,
      mass_properties(black, Density{2750.0}));
  const auto measured = make_measured_stone(0.022, 0.0092, 0.001);
  expect_properties(members_of(printed({"inertia", "--width", "22mm", "--height", "9.2mm", "--bevel", "1mm",
                                        "--measured", "--mass", "5.2g", "--format", "json"})),
                    measured, mass_properties(measured, Mass{0.0052}));
  const auto ball = make_stone(0.01, 0.01, 0.004);
  expect_properties(members_of(printed({"inertia", "--width", "1cm", "--height", "1cm", "--bevel", "4mm", "--density",
                                        "1g/cm3", "--format", "json"})),
                    ball, mass_properties(ball, Density{1000.0}));
}

TEST_F(CliInertia, AgreesWithFiguresComputedElsewhere) {
  // 22 × 9.2 mm, in cm³ and cm².
  const Members sharp = members_of(printed({"inertia", "--size", "33", "--format", "json"}));
  EXPECT_NEAR(number_of(sharp, "volume") * 1e6, 1.850540491831, 5e-13);
  EXPECT_NEAR(number_of(sharp, "axial_per_mass") * 1e4, 0.415606897126197, 5e-16);
  EXPECT_NEAR(number_of(sharp, "transverse_per_mass") * 1e4, 0.244624139941691, 5e-16);
}

TEST_F(CliInertia, EveryPrintedDigitIsRight) {
  // A ball of 2 m: r = 1, V = 4π/3, S = 4π, I/m = 2/5; the last digits are those of π.
  const Members ball =
      members_of(printed({"inertia", "--width", "2", "--height", "2", "--density", "1", "--format", "json"}));
  EXPECT_EQ(value_of(ball, "volume"), "4.1887902047863910");        // 4.18879020478639098…
  EXPECT_EQ(value_of(ball, "surface_area"), "12.566370614359173");  // 12.5663706143591729…
  EXPECT_EQ(value_of(ball, "axial_per_mass"), "0.40000000000000000");
  EXPECT_EQ(value_of(ball, "sphere_offset"), "0");
}

TEST_F(CliInertia, NoSizeIsTooSmallOrTooLarge) {
  const auto ask = [this](const std::string& scale) {
    return members_of(printed({"inertia", "--width", "1" + scale, "--height", "0.4" + scale, "--bevel", "0.1" + scale,
                               "--density", "1", "--format", "json"}));
  };
  const Members one = ask("");
  for (const std::string& sign : {std::string("-"), std::string("+")}) {
    for (const int order : {400, 90'000'000}) {
      const Members other = ask("e" + sign + std::to_string(order));
      for (const auto& [key, value] : other) {
        EXPECT_TRUE(is_json_number(value)) << key << ": " << value;
      }
      const auto digits = [](const Members& members, const std::string& key) {
        std::string text = value_of(members, key);
        text = text.substr(0, text.find('e'));
        std::erase(text, '.');
        return text.substr(text.find_first_not_of('0'));
      };
      for (const auto* key : {"width", "bevel_minor_radius", "volume", "transverse"}) {
        EXPECT_EQ(digits(other, key), digits(one, key)) << order;
      }
      // V = 0.1… and I_t = 0.001… at scale 1.
      const std::string volume = value_of(one, "volume");
      ASSERT_EQ(volume.substr(0, 3), "0.1");
      EXPECT_TRUE(value_of(other, "volume").ends_with("e" + sign + std::to_string(3 * order + (sign == "-" ? 1 : -1))));
    }
  }
}

TEST_F(CliInertia, TextNamesUnitsAndWhatIsAssumed) {
  const std::string text = printed({"inertia", "--size", "33", "--bevel", "1mm"});
  EXPECT_NE(text.find("The white stone of size 33\n"), std::string::npos) << text;
  EXPECT_TRUE(std::regex_search(text, std::regex("\nvolume +V +1.84302e-06 +m³ +1.84302 +cm³\n")));
  EXPECT_TRUE(std::regex_search(text, std::regex("\naxial moment per mass +I_a/m +4.12568e-05 +m² +0.412568 +cm²\n")));
  EXPECT_TRUE(std::regex_search(text, std::regex("\ndensity +ρ +2800 +kg/m³ +2.8 +g/cm³ +\\(assumed\\)\n")));
  const std::string given = printed({"inertia", "--size", "33", "--density", "2700"});
  EXPECT_EQ(given.find("assumed"), std::string::npos);
  const std::string plain = printed({"inertia", "--width", "22mm", "--height", "9.2mm"});
  EXPECT_TRUE(std::regex_search(plain, std::regex("density .* 2800 .*\\(assumed\\)\n"))) << plain;
}

// --- units

TEST_F(CliUnits, TheSameLengthInEveryUnit) {
  const std::string expected = printed({"inertia", "--width", "0.022", "--height", "0.0092", "--format", "json"});
  EXPECT_EQ(value_of(members_of(expected), "width"), "0.022000000000000000");
  for (const auto* width :
       {"22mm", "2.2cm", "22 mm", " 22mm ", "+22mm", "22.0mm", ".022", "22e-3", "2.2E-2m", "22000um", "22000µm",
        "22000μm", "22000000nm", "0.000022km", "000.0220000", "0.00000000000000000000000000000000022e32m"}) {
    EXPECT_EQ(printed({"inertia", "--width", width, "--height", "9.2mm", "--format", "json"}), expected) << width;
  }
}

TEST_F(CliUnits, DensitiesAndMasses) {
  const auto ask = [this](const char* option, const char* value) {
    return printed({"inertia", "--size", "33", option, value, "--format", "json"});
  };
  const std::string by_density = ask("--density", "2700");
  for (const auto* density : {"2.7g/cm3", "2.7 g/cm^3", "2.7g/cm³", "2700kg/m3", "2700 kg/m^3", "2700kg/m³", "2.7e3"}) {
    EXPECT_EQ(ask("--density", density), by_density) << density;
  }
  const std::string by_mass = ask("--mass", "0.005");
  for (const auto* mass : {"5g", "0.005kg", "5000mg", "5 g"}) {
    EXPECT_EQ(ask("--mass", mass), by_mass) << mass;
  }
}

// --- table

TEST_F(CliTable, CsvHoldsTheLibrarysTable) {
  const std::vector<std::string> lines = split(printed({"table", "--format", "csv"}), '\n');
  ASSERT_EQ(lines.size(), inertia_table.size() + 1);
  EXPECT_EQ(lines[0],
            "number,color,bevel_m,width_m,height_m,outer_width_m,volume_m3,surface_area_m2,"
            "density_kg_m3,mass_kg,axial_kg_m2,transverse_kg_m2,axial_per_mass_m2,"
            "transverse_per_mass_m2");
  for (std::size_t i = 0; i < inertia_table.size(); ++i) {
    const InertiaRow& row = inertia_table[i];
    const std::vector<std::string> cells = split(lines[i + 1], ',');
    ASSERT_EQ(cells.size(), 14U);
    EXPECT_EQ(cells[0], std::to_string(row.number));
    EXPECT_EQ(cells[1], to_string(row.color));
    const double expected[] = {row.bevel,  row.width,        row.height,         row.outer_width,
                               row.volume, row.surface_area, row.density,        row.mass,
                               row.axial,  row.transverse,   row.axial_per_mass, row.transverse_per_mass};
    for (std::size_t j = 0; j < 12; ++j) {
      const std::string& cell = cells[j + 2];
      expect_same_number(cell, expected[j]);
      EXPECT_TRUE(cell == "0" || significant_digits(cell) == 17) << cell;
    }
  }
}

TEST_F(CliTable, JsonSaysTheSameAsCsvAndNamesItsUnits) {
  const std::string json = printed({"table", "--format", "json", "--units", "cgs"});
  const std::vector<std::string> lines = split(printed({"table", "--format", "csv", "--units", "cgs"}), '\n');
  const Members members = members_of(json);
  ASSERT_EQ(members.size(), 12 + 2 + 96 * 14U);
  EXPECT_EQ(members[0], (Members::value_type{"bevel", "cm"}));
  EXPECT_EQ(members[8], (Members::value_type{"axial", "g cm²"}));
  EXPECT_EQ(members[12], (Members::value_type{"standard", "talk"}));
  EXPECT_EQ(members[13], (Members::value_type{"density_assumed", "true"}));
  for (std::size_t i = 0; i < 96; ++i) {
    const std::vector<std::string> cells = split(lines[i + 1], ',');
    for (std::size_t j = 0; j < 14; ++j) {
      EXPECT_EQ(members[14 + 14 * i + j].second, cells[j]);
    }
  }
  const Members given = members_of(printed({"table", "--format", "json", "--density", "2700"}));
  EXPECT_EQ(value_of(given, "density_assumed"), "false");
}

TEST_F(CliTable, UnitsAreCgsOnRequest) {
  const std::string row = split(printed({"table", "--units", "cgs", "--format", "csv"}), '\n').at(25);
  const std::vector<std::string> cells = split(row, ',');
  EXPECT_EQ(cells[0] + cells[1], "33white");
  EXPECT_EQ(cells[3], "2.2000000000000000");
  EXPECT_EQ(cells[8], "2.8000000000000000");
  EXPECT_NEAR(std::stod(cells[6]), 1.850540491831, 5e-13);      // V [cm³]
  EXPECT_NEAR(std::stod(cells[12]), 0.415606897126197, 5e-16);  // I_a/m [cm²]
  EXPECT_NEAR(std::stod(cells[9]), 2.8 * 1.850540491831, 5e-12);
  EXPECT_NEAR(std::stod(cells[10]), 2.8 * 1.850540491831 * 0.415606897126197, 5e-12);
}

TEST_F(CliTable, TextIsAlignedAndFitsAScreen) {
  const std::vector<std::string> lines = split(printed({"table"}), '\n');
  ASSERT_EQ(lines.size(), 5 + 96U);
  EXPECT_NE(lines[1].find("assumed"), std::string::npos);
  EXPECT_NE(lines[3].find("I_a/m"), std::string::npos);
  EXPECT_NE(lines[4].find("kg m²"), std::string::npos);
  for (std::size_t i = 5; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].size(), lines[5].size()) << lines[i];
    EXPECT_LE(lines[i].size(), 160U);
  }
  EXPECT_NE(lines[29].find("33  white  0 "), std::string::npos) << lines[29];
  EXPECT_NE(lines[29].find("1.85054e-06"), std::string::npos) << lines[29];
}

TEST_F(CliTable, MarkdownIsATable) {
  const std::vector<std::string> lines = split(printed({"table", "--format", "markdown"}), '\n');
  ASSERT_EQ(lines.size(), 5 + 96U);
  EXPECT_NE(lines[1].find("assumed"), std::string::npos);
  EXPECT_NE(lines[3].find("| volume [m³] |"), std::string::npos) << lines[3];
  for (std::size_t i = 3; i < lines.size(); ++i) {
    EXPECT_EQ(std::ranges::count(lines[i], '|'), 15) << lines[i];
  }
}

TEST_F(CliTable, OneColorOneBevelOneDensity) {
  const std::string csv =
      printed({"table", "--color", "black", "--bevel", "0.5mm", "--density", "2.6g/cm3", "--format", "csv"});
  const std::vector<std::string> lines = split(csv, '\n');
  ASSERT_EQ(lines.size(), 25U);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> cells = split(lines[i], ',');
    EXPECT_EQ(cells[1], "black");
    EXPECT_EQ(cells[2], "0.00050000000000000000");
    EXPECT_EQ(cells[8], "2600.0000000000000");
  }
  EXPECT_EQ(split(printed({"table", "--color", "white", "--format", "csv"}), '\n').size(), 49U);
}

TEST_F(CliTable, HeaderIsTheShippedOne) {
  EXPECT_EQ(printed({"table", "--format", "cpp"}), contents(GOISHI_TABLE_HEADER));
  const Result check = run({"table", "--check", GOISHI_TABLE_HEADER});
  EXPECT_EQ(check.status, 0) << check.err;
  EXPECT_EQ(check.out, std::string(GOISHI_TABLE_HEADER) + ": all 96 rows agree\n");
}

TEST_F(CliTable, HeaderSaysHowItWasMade) {
  const std::string header =
      printed({"table", "--color", "white", "--bevel", "1 mm", "--density", "2.7g/cm3", "--format", "cpp"});
  EXPECT_NE(header.find("`goishi table --color white --bevel '1 mm' --density 2.7g/cm3 "
                        "--format cpp`"),
            std::string::npos);
  EXPECT_NE(header.find("std::array<InertiaRow, 24>"), std::string::npos);
  EXPECT_EQ(header.find("assumed"), std::string::npos);
}

// --- standards

TEST_F(CliStandard, TheTalksIsTheDefault) {
  for (const std::string command :
       {"table --format cpp", "table", "inertia --size 33 --color black", "contact --size 33 --position 0.2,0,0.001",
        "spin --size 45 --spin 1,2,3 --time 1", "drop --size 33 --from 1cm --position 0.21,0"}) {
    EXPECT_EQ(printed(words_of(command + " --standard talk")), printed(words_of(command))) << command;
  }
}

TEST_F(CliStandard, TheNihonKiinsTable) {
  const std::vector<std::string> lines = split(printed(words_of("table --standard nihon-kiin --format csv")), '\n');
  ASSERT_EQ(lines.size(), 97U);
  std::size_t line = 0;
  for (const catalogue::Size& size : catalogue::sizes) {
    for (const StoneColor color : {StoneColor::white, StoneColor::black}) {
      for (const double bevel : {0.0, 0.001}) {
        const std::vector<std::string> cells = split(lines[++line], ',');
        ASSERT_EQ(cells.size(), 14U);
        const CatalogueStone entry = catalogue_stone(size.number, color, Standard::nihon_kiin);
        const Stone<double> stone = make_stone(entry, bevel);
        const auto body = mass_properties(stone, Density{static_cast<double>(entry.density)});
        EXPECT_EQ(cells[0] + cells[1], std::to_string(size.number) + std::string(to_string(color)));
        EXPECT_EQ(std::stod(cells[2]), bevel);
        EXPECT_EQ(std::stod(cells[3]), color == StoneColor::white ? 0.0219 : 0.0222);
        expect_close(std::stod(cells[10]), body.moments.axial, lines[line]);
      }
    }
  }
  EXPECT_NE(printed(words_of("table --standard nihon-kiin")).find("\nDimensions: nihon-kiin. "), std::string::npos);
  EXPECT_EQ(value_of(members_of(printed(words_of("table --standard nihon-kiin --format json"))), "standard"),
            "nihon-kiin");
  const std::string header = printed(words_of("table --standard nihon-kiin --format cpp"));
  EXPECT_NE(header.find("`goishi table --standard nihon-kiin --format cpp`"), std::string::npos);
  EXPECT_NE(header.find("the standard `nihon-kiin`"), std::string::npos);
  EXPECT_EQ(run(words_of("table --standard nihon-kiin --check " GOISHI_TABLE_HEADER)).status, 1);
}

TEST_F(CliStandard, StonesAndTheirTitles) {
  const std::string of = " --standard nihon-kiin --size 50 --color black";
  const auto stone = make_stone(0.0222, 0.0149);
  expect_properties(members_of(printed(words_of("inertia --format json" + of))), stone,
                    mass_properties(stone, Density{2750.0}));
  for (const std::string command : {"inertia", "spin --spin 1,2,3 --time 1", "contact --position 0,0,0.1",
                                    "contact --position 0,0,0.1 --against plane", "drop --from 1cm"}) {
    const std::string text = printed(words_of(command + of));
    EXPECT_TRUE(text.starts_with("The black stone of size 50, nihon-kiin")) << text;
  }
}

TEST_F(CliStandard, BoardsAndWhatIsBesideThem) {
  // Flat beside the board, at the level of its surface: the gap is what lies between rim and side.
  const auto gap = [&](const std::string& options, const std::string& position) {
    const std::string stone = "contact --width 20mm --height 9mm --format json --position ";
    return number_of(members_of(printed(words_of(stone + position + " " + options))), "gap") * 1e3;
  };
  EXPECT_NEAR(gap("", "0.3,0,-0.01"), 300 - 10 - 212.1, 1e-12);
  EXPECT_NEAR(gap("--standard nihon-kiin", "0.3,0,-0.01"), 300 - 10 - 212.17, 1e-12);
  EXPECT_NEAR(gap("--standard nihon-kiin", "0,0.3,-0.01"), 300 - 10 - 227.28, 1e-12);
  EXPECT_NEAR(gap("--standard nihon-kiin --lines 13", "0.3,0,-0.01"), 300 - 10 - 145, 1e-12);
  EXPECT_NEAR(gap("--standard nihon-kiin --lines 13", "0,0.3,-0.01"), 300 - 10 - 157.5, 1e-12);
  EXPECT_NEAR(gap("--lines 13", "0.3,0,-0.01"), 300 - 10 - (132 + 14.1), 1e-12);
  const std::string title = printed(words_of("contact --size 33 --standard nihon-kiin --lines 13 --position 0,0,0.1"));
  EXPECT_TRUE(
      title.starts_with("The white stone of size 33, nihon-kiin, sharp, against the board with 13 lines, "
                        "nihon-kiin\n"))
      << title;
}

TEST_F(CliStandard, TheFloorIsBelowTheBoardAndItsLegs) {
  // At rest beside the board, half a thickness above the floor.
  const auto floor = [&](const std::string& options) {
    const std::string text = printed(
        words_of("drop --width 22mm --height 9mm --bevel 1mm --from 1cm --position 0.5,0 --format json " + options));
    const std::string final = text.substr(text.find("\"final\""));
    const std::size_t position = final.find("\"position\": [");
    return std::stod(split(final.substr(position, final.find(']', position)), ',').at(2)) - 0.0045;
  };
  EXPECT_NEAR(floor(""), -0.1515, 1e-9);
  EXPECT_NEAR(floor("--standard nihon-kiin --on board"), -0.1515, 1e-9);
  EXPECT_NEAR(floor("--on floor-board"), -0.182 - 0.115, 1e-9);
  const std::string title = printed(words_of("drop --size 33 --from 1cm --standard nihon-kiin --on floor-board"));
  EXPECT_TRUE(
      title.starts_with("The white stone of size 33, nihon-kiin, sharp, dropped on the floor board, "
                        "nihon-kiin\n"))
      << title;
}

// --- help

TEST_F(Cli, HelpNamesEveryOptionAndItsExamplesRun) {
  const std::pair<std::string, std::string> commands[] = {
      {"table", "--color --standard --bevel --density --units --format --output --check"},
      {"inertia", "--size --color --standard --width --height --bevel --measured --mass --density --format"},
      {"spin",
       "--size --color --standard --bevel --mass --density --axial --transverse --spin --attitude --time --method "
       "--step --format "
       "--series"},
      {"contact",
       "--size --color --standard --width --height --bevel --position --attitude --against --other-position "
       "--other-attitude "
       "--lines --velocity --spin --gravity --horizon --format"},
      {"drop",
       "--size --color --standard --width --height --bevel --mass --density --from --position --tilt --tilt-axis "
       "--velocity "
       "--spin "
       "--on --restitution --friction --friction-model --slip-coefficient --patch-radius --rolling-resistance "
       "--pivot-radius --gravity --law --until --tolerance --format --series --csv"},
      {"mesh",
       "--size --color --standard --width --height --bevel --measured --method --level --tolerance --cache-order "
       "--units --format "
       "--output "
       "--stats"},
      {"body",
       "--size --color --standard --width --height --bevel --measured --mass --density --method --level --tolerance "
       "--cache-order "
       "--format "
       "--output"}};
  const std::string all = printed({"--help"});
  EXPECT_EQ(printed({"-h"}), all);
  for (const auto& [command, options] : commands) {
    EXPECT_NE(all.find("\n  " + command + " "), std::string::npos);
    EXPECT_NE(all.find("\n  goishi " + command), std::string::npos);
    const std::string help = printed({command, "--help"});
    for (const std::string& option : words_of(options)) {
      EXPECT_NE(help.find("\n  " + option + " "), std::string::npos) << option;
    }
    for (const auto* part : {"\nA number is decimal, with a point: ", "\n  lengths ", "\nExit status: 0 done, "}) {
      EXPECT_NE(help.find(part), std::string::npos) << command << part;
    }
    int examples = 0;
    for (const std::string& line : split(help, '\n')) {
      if (line.starts_with("  goishi " + command) && line.find(" --check ") == std::string::npos) {
        const Words words = words_of(line.substr(std::string("  goishi ").size()));
        const Result result = run(words, "cd '" + work().string() + "' && ");
        EXPECT_EQ(result.status, 0) << line << result.err;
        EXPECT_EQ(result.err, "") << line;
        ++examples;
      }
    }
    EXPECT_GE(examples, 3) << command;
  }
  EXPECT_TRUE(std::regex_match(printed({"--version"}), std::regex("goishi \\d+\\.\\d+\\.\\d+ .*\n")));
}

}  // namespace
}  // namespace goishi::cli_test
