/// The program `goishi`: bad input.

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <utility>

#include "tests/cli_test.hpp"

namespace goishi::cli_test {

namespace {

using CliError = Cli;
using CliNumbers = Cli;

// --- numbers: one rule for all of them

/// A command with @ where a number stands, a whole number without a unit that fits there, what is said of no number
/// there, and the units that are read there.
struct Place {
  std::string command;
  std::string number;
  std::string rule;
  std::string units;
};

Place place(const std::string& command, const std::string& number, const std::string& units, int count = 1) {
  std::string rule = count == 1 ? "must be a decimal number"
                                : "must be " + std::to_string(count) + " decimal numbers with commas between them";
  if (!units.empty()) {
    rule += ", bare (" + units.substr(0, units.find(',')) + ") or with a unit (" + units + ")";
  }
  return {command, number, rule, units};
}

Place whole(const std::string& command, const std::string& number, const std::string& rule) {
  return {command, number, rule, ""};
}

const std::string lengths = "m, cm, mm, µm, nm, km";
const std::string velocities = "m/s, cm/s, mm/s, km/s";
const std::string accelerations = "m/s², cm/s², mm/s²";
const std::string spins = "rad/s";
const std::string angles = "°, deg";
const std::string densities = "kg/m³, g/cm³";
const std::string masses = "kg, g, mg";
const std::string moment_units = "kg m², g cm²";
const std::string time_units = "s, ms";
const std::string sizes = "must be one of 22 25 28 30 31 32 33 34 35 36 37 38 39 40 41 42 43 44 45 46 47 48 49 50";

/// Every option of every command that takes numbers.
std::vector<Place> places() {
  const std::string lens = "inertia --height 1 --width ", stone = "inertia --size 33 ";
  const std::string turn = "spin --spin 1,2,3 --time 1 ", turning = turn + "--size 33 ";
  const std::string pose = "contact --position 0,0,1 ", there = pose + "--size 33 ";
  const std::string fly = there + "--horizon 1 ", other = there + "--against stone --other-position ";
  const std::string start = "drop --until 1ms --from 5cm ", drop = start + "--size 33 ";
  const std::string until = "must be rest, a time such as 500ms, or a count such as 5-impacts";
  const std::string rows = "must be a whole number from 2 to 100000";
  std::vector<Place> all = {
      place("table --bevel @", "0", lengths),
      place("table --density @", "2700", densities),
      place(lens + "@", "1", lengths),
      place("inertia --width 1 --height @", "1", lengths),
      place(turn + "--transverse 1 --axial @", "1", moment_units),
      place(turn + "--axial 1 --transverse @", "1", moment_units),
      place("spin --size 33 --time 1 --spin 1,@,3", "2", spins, 3),
      place("spin --size 33 --spin 1,2,3 --time @", "2", time_units),
      place(turning + "--attitude 0,@,0,0", "1", "", 4),
      place(turning + "--method published --step @", "1", time_units),
      whole(turning + "--series @", "3", rows),
      place("contact --size 33 --position @,0,1", "2", lengths, 3),
      place(pose + "--height 1 --width @", "1", lengths),
      place(pose + "--width 1 --height @", "1", lengths),
      place(there + "--attitude 0,0,0,@", "1", "", 4),
      whole(there + "--lines @", "9", "must be a whole number from 1 to 2147483647"),
      place(fly + "--velocity 0,0,@", "2", velocities, 3),
      place(fly + "--spin @,0,1", "2", spins, 3),
      place(fly + "--spin 1,0,1 --gravity @", "2", accelerations),
      place(there + "--spin 1,0,1 --horizon @", "2", time_units),
      place(other + "0,@,0", "2", lengths, 3),
      place(other + "0,0,0 --other-attitude 0,@,0,0", "1", "", 4),
      place(start + "--height 1mm --width @", "2", lengths),
      place(start + "--width 1 --height @", "0", lengths),
      place("drop --size 33 --until 1ms --from @", "1", lengths),
      place(drop + "--position @,0", "2", lengths, 2),
      place(drop + "--tilt @", "20", angles),
      place(drop + "--tilt 20 --tilt-axis 0,@,1", "2", "", 3),
      place(drop + "--velocity @,0,0", "2", velocities, 3),
      place(drop + "--spin 0,0,@", "2", spins, 3),
      place(drop + "--restitution @", "1", ""),
      place(drop + "--friction @", "2", ""),
      place(drop + "--rolling-resistance @", "0", lengths),
      place(drop + "--pivot-radius @", "0", lengths),
      place(drop + "--friction-model slip-proportional --slip-coefficient @", "2", "s/m"),
      place(drop + "--friction-model coulomb-contensou --patch-radius @", "0", lengths),
      place(drop + "--gravity @", "2", accelerations),
      place(drop + "--gravity 0,@,-9", "2", accelerations, 3),
      place(drop + "--tolerance @", "0", ""),
      {"drop --size 33 --from 5cm --until @", "1", until, time_units},
      whole("drop --size 33 --from 5cm --until @-impacts", "2", until),
      whole(drop + "--csv /dev/null --series @", "3", rows + "0"),
      place("mesh --stats --level 0 --height 1mm --width @", "2", lengths),
      place("mesh --stats --level 0 --width 1 --height @", "1", lengths),
      whole("mesh --stats --size 33 --level @", "1", "must be a whole number from 0 to 8"),
      place("mesh --stats --size 33 --tolerance @", "1", lengths),
  };
  const std::pair<std::string, std::string> stones[] = {{"inertia", ""},
                                                        {"spin", "--spin 1,2,3 --time 1 "},
                                                        {"contact", "--position 0,0,1 "},
                                                        {"drop", "--until 1ms --from 5cm "},
                                                        {"mesh", "--stats --level 0 "}};
  for (const auto& [command, more] : stones) {
    const std::string begin = command + " " + more;
    all.push_back(whole(begin + "--size @", "33", sizes));
    all.push_back(place(begin + "--size 33 --bevel @", "0", lengths));
    if (command != "contact" && command != "mesh") {
      all.push_back(place(begin + "--size 33 --mass @", "1", masses));
      all.push_back(place(begin + "--size 33 --density @", "2700", densities));
    }
  }
  return all;
}

/// The words of a place with a number's text in it.
Words with_number(const Place& place, const std::string& text) {
  Words words = words_of(place.command);
  for (std::string& word : words) {
    if (const std::size_t at = word.find('@'); at != std::string::npos) {
      word.replace(at, 1, text);
    }
  }
  return words;
}

TEST_F(CliNumbers, OneRuleForAll) {
  for (const Place& place : places()) {
    const std::string& n = place.number;
    const Result expected = run(with_number(place, n));
    for (const std::string& text : {"+" + n, "00" + n, n + ".", n + ".0", "." + n + "e" + std::to_string(n.size()),
                                    n + "0E-1", n + "e+0", " " + n, n + "\t "}) {
      const Result result = run(with_number(place, text));
      EXPECT_EQ(result.status, expected.status) << place.command << " " << text << result.err;
      EXPECT_EQ(result.out, expected.out) << place.command << " " << text;
    }
    // Where 0 does not fit either, at least it is read.
    if (n != "0") {
      EXPECT_EQ(expected.status, 0) << place.command << expected.err;
    }
  }
}

TEST_F(CliNumbers, WordsInTheirPlaceHaveBlanksToo) {
  const Words drop = {"drop", "--size", "33", "--from", "2cm"};
  const std::pair<std::string, std::string> words[] = {{"friction", "inf"}, {"until", "rest"}, {"until", "2-impacts"}};
  for (const auto& [option, word] : words) {
    EXPECT_EQ(printed(drop + Words{"--" + option, " " + word + "\t"}), printed(drop + Words{"--" + option, word}));
  }
}

TEST_F(CliNumbers, NothingElseIsRead) {
  const Words texts = {"",  " ", "nan", "NaN", "-inf", "Inf", "infinity", "mm",
                       ".", "-", "+-1", "--1", "- 1",  "e5",  "١"};
  // And a number, with what must be no unit.
  const Words begun = {"0x10", "1_000", "1e", "1e+", "1 0", "1.5.2", "1٫5", "1;5", "1parsec", "1 mm mm", "1MM", "2\v"};
  const Words behind = {"x10", "_000", "e", "e+", "0", ".2", "٫5", ";5", "parsec", "mm mm", "MM", "\\x0b"};
  // Each place sees some of them, each of them many places.
  std::size_t turn = 0;
  constexpr std::size_t share = 5;
  for (const Place& place : places()) {
    ++turn;
    const Words empty = words_of(place.command);
    const auto at = std::ranges::find_if(empty, [](const std::string& word) { return word.find('@') < word.size(); });
    const auto expect = [&](const std::string& text, const std::string& rule) {
      const Words words = with_number(place, text);
      std::string typed = words[static_cast<std::size_t>(at - empty.begin())];
      if (const std::size_t control = typed.find('\v'); control != std::string::npos) {
        typed.replace(control, 1, "\\x0b");
      }
      expect_error(words, std::prev(at)->substr(2) + " = " + typed + ": " + rule);
    };
    for (std::size_t i = turn % share; i < texts.size(); i += share) {
      expect(texts[i], place.rule);
    }
    for (std::size_t i = turn % share; i < begun.size(); i += share) {
      expect(begun[i], place.units.empty() ? place.rule
                                           : "must have one of the units " + place.units + ", not '" + behind[i] + "'");
    }
  }
}

TEST_F(CliNumbers, TheDigitsTypedAreShown) {
  const std::string z = "0000000000000000000000";  // 22 zeros
  const std::string lens = "inertia --width 22mm --height ", spun = "spin --size 33 --spin 1,2,3 ";
  const std::string turned = "spin --spin 1,2,3 --time 1 ",
                    flown = "contact --size 33 --position 0,0,1 --velocity 0,0,0 ";
  const std::string drop = "drop --size 33 --from 5cm ";
  const std::string wide = "drop --width 22mm --height 9mm --from 5cm ";
  const std::string half_width = "is a length, and must not exceed half the width (0.011)";
  // The last option is at fault.
  const std::pair<std::string, std::string> cases[] = {
      {"inertia --height 9mm --width -22." + z + "1mm", "must be positive and finite"},
      {lens + "-9." + z + "1mm", "must be positive and finite"},
      {lens + "22." + z + "1mm", "must not exceed the width (22mm)"},
      {"inertia --width 21.999999999999999999999mm --height 22mm",
       "must not exceed the width (21.999999999999999999999mm)"},
      {"inertia --measured --width 21.999999999999999999999mm --height 22mm",
       "must not exceed the width (21.999999999999999999999mm)"},
      {"inertia --measured --height 22mm --width -1." + z + "1", "must be positive and finite"},
      {lens + "9." + z + "1mm --bevel 9." + z + "1mm", "must be at least 0 and below the height (9." + z + "1mm)"},
      {"inertia --size 33 --bevel 9.2" + z + "1mm", "must be at least 0 and below the height (0.0092)"},
      {"inertia --size 33 --mass -1." + z + "1g", "must be positive and finite"},
      {"inertia --size 33 --density -1." + z + "1g/cm3", "must be positive and finite"},
      {"inertia --size 33." + z + z + z + "1", sizes},
      {"table --bevel 6.3" + z + "1mm", "must be at least 0 and below the height (0.0063)"},
      {"table --density 0" + z, "must be positive and finite"},
      {"table --format cpp --density 1.0" + z + "1e400", "is beyond the range of a double, which --format cpp prints"},
      {turned + "--transverse 1." + z + "1 --axial 2." + z + "3",
       "must satisfy the triangle inequality: no principal moment above the sum of the other two (transverse 1." + z +
           "1)"},
      {turned + "--axial 1 --transverse -1." + z + "1", "must be positive and finite"},
      {spun + "--time 1" + z + ".5",
       "must not turn the body by more than 1e20 rad, beyond which 50 digits are too few"},
      {spun + "--time -1." + z + "1 --method published --step 1", ""},
      {spun + "--time 1 --method published --step -1." + z + "1ms", "must be positive and finite"},
      {spun + "--time 1 --series 2." + z + "1", "must be a whole number from 2 to 100000"},
      {flown + "--horizon -1." + z + "1", "must be positive and finite"},
      {"contact --size 33 --position 0,0,1 --lines 9." + z + z + z + "1",
       "must be a whole number from 1 to 2147483647"},
      {drop + "--tilt 360." + z + "1", "must be from -360 to 360 degrees"},
      {drop + "--until -1." + z + "1s", "must be positive and finite"},
      {drop + "--restitution -1." + z + "1", "must be from 0 to 1"},
      {drop + "--friction -1." + z + "1", "must be at least 0 (infinity is allowed)"},
      {drop + "--rolling-resistance -1." + z + "1mm", "must be finite and at least 0"},
      {drop + "--pivot-radius -1." + z + "1mm", "must be finite and at least 0"},
      {drop + "--friction-model slip-proportional --slip-coefficient -1." + z + "1", "must be finite and at least 0"},
      {drop + "--friction-model coulomb-contensou --patch-radius -1." + z + "1mm", "must be finite and at least 0"},
      {drop + "--tolerance 1." + z + "1", "must be from 100 ε to 0.01"},
      {drop + "--rolling-resistance 0.3" + z + "1", half_width},
      {drop + "--pivot-radius 1.2" + z + "1cm", half_width},
      {wide + "--friction-model coulomb-contensou --patch-radius 11.1" + z + "1mm", half_width},
  };
  for (const auto& [command, rule] : cases) {
    Words words = words_of(command);
    if (rule.empty()) {  // not the last one, here
      expect_error(words, "time = -1." + z + "1: must not be negative with --method published, which steps forward");
    } else {
      expect_error(words, words[words.size() - 2].substr(2) + " = " + words.back() + ": " + rule);
    }
  }
}

TEST_F(CliNumbers, AVectorHasUnitsAsANumberHas) {
  const std::string contact = "contact --size 33 --horizon 1 --velocity 0.02,-3,0 --spin 1,2,3 --position ";
  const std::string expected = printed(words_of(contact + "0.216,0.01,0"));
  for (const std::string typed : {"216mm,10mm,0", "21.6cm,0.00001km,0mm", "216e3um,10000µm,0", "0.216m,10000μm,0."}) {
    EXPECT_EQ(printed(words_of(contact + typed)), expected) << typed;
  }
  EXPECT_EQ(printed(Words{"contact", "--size", "33", "--horizon", "1000 ms", "--velocity", "2 cm/s, -3000mm/s ,0",
                          "--spin", "1rad/s,2 rad/s,3rad/s", "--position", "216 mm, 10 mm ,0"}),
            expected);
  const std::string drop = "drop --size 33 --from 5cm --until 1s ";
  EXPECT_EQ(printed(words_of(drop + "--position 10mm,0 --tilt 20° --gravity 0,1cm/s2,-9800mm/s^2")),
            printed(words_of(drop + "--position 0.01,0 --tilt 20deg --gravity 0,0.01,-9.8")));
  EXPECT_EQ(printed({"spin", "--axial", "2e5g cm2", "--transverse", "4e5 g cm²", "--spin", "1,2,3", "--time", "1"}),
            printed({"spin", "--axial", "0.02 kg m^2", "--transverse", "0.04kg m2", "--spin", "1,2,3", "--time", "1"}));
  for (const std::string typed : {"216,10,3mm", "1mm,2,0", "0,0.5,0cm"}) {
    expect_error(words_of(contact + typed),
                 "position = " + typed + ": must have a unit with each number but 0, or with none");
  }
  expect_error(words_of(contact + "1mm,2ft,0"),
               "position = 1mm,2ft,0: must have one of the units m, cm, mm, µm, nm, km, not 'ft'");
}

TEST_F(CliNumbers, OutOfRange) {
  const std::string rule = ": must be 0 or from 1e-100000000 to 1e100000000";
  for (const std::string typed : {"1e100000001", "1e99999999999999999999999", "1e-100000000mm", "-0.1e-100000000"}) {
    expect_error({"inertia", "--width", typed, "--height", "9mm"}, "width = " + typed + rule + " m, in magnitude");
  }
  expect_error(words_of("spin --size 33 --time 1 --spin 1,2,1e100000001"),
               "spin = 1,2,1e100000001" + rule + " rad/s, in magnitude");
  expect_error(words_of("spin --size 33 --time 1 --spin 1,2,3 --attitude 1,0,0,1e100000001"),
               "attitude = 1,0,0,1e100000001" + rule + ", in magnitude");
}

TEST_F(CliNumbers, AnAttitudeOfFewDigitsIsMadeUnit) {
  const std::string spin = "spin --size 33 --spin 1,2,3 --time 1 --attitude ";
  const std::string contact = "contact --size 33 --position 0,0,1 --attitude ";
  const std::string other =
      "contact --size 33 --position 0,0,1 --against stone --other-position 0,0,0 --other-attitude ";
  struct Case {
    std::string typed;
    std::string same_as;  // in all digits
    std::string length;   // said in a note; empty: there is none
  };
  const std::string root = "0.70710678118654752440084436210484903928483593768847";
  const Case cases[] = {
      {"0.7071,0,0,0.7071", root + ",0,0," + root, "1 - 9.59005e-06"},
      {"0.70711,0,0,-.70711", root + ",0,0,-" + root, "1 + 4.55209e-06"},
      {"0.707106781187,0,0,0.707106781187", root + ",0,0," + root, "1 + 6.39897e-13"},
      {"0.9990001,0,0,0", "1,0,0,0", "1 - 0.0009999"},
      {"0,0,-1.0009999,0", "0,0,-1,0", "1 + 0.0009999"},
      {"1.0000000000000072,0,0,0", "1,0,0,0", "1 + 7.20000e-15"},  // 64 ε of double is 1.42e-14, twice that
      {"1.000000000000007,0,0,0", "1,0,0,0", ""},
  };
  for (const std::string& command : {spin, contact, other}) {
    const std::string option = words_of(command).back().substr(2);
    for (const Case& one : cases) {
      const Result result = run(words_of(command + one.typed));
      EXPECT_EQ(result.status, 0);
      EXPECT_EQ(result.out, run(words_of(command + one.same_as)).out) << one.typed;
      EXPECT_EQ(result.err, one.length.empty() ? ""
                                               : "goishi: note: " + option + " = " + one.typed +
                                                     ": is made a unit quaternion; its length is " + one.length + "\n");
    }
    const std::pair<std::string, std::string> wrong[] = {{"0,0,0,0", "0"},
                                                         {"1,1,0,0", "1.4142135623730950"},
                                                         {"0.998,0,0,0", "0.99800000000000000"},
                                                         {"0,1.0010001,0,0", "1.0010001000000000"},
                                                         {"1e1000,0,0,0", "1.0000000000000000e+1000"}};
    for (const auto& [typed, length] : wrong) {
      expect_error(
          words_of(command + typed),
          option + " = " + typed + ": must be a unit quaternion w,x,y,z, its length within 0.001 of 1, not " + length);
    }
  }
  // An error has one line.
  expect_error(words_of("contact --size 33 --attitude 0.7071,0,0,0.7071 --position 0,0,1 --lines 0"),
               "lines = 0: must be a whole number from 1 to 2147483647");
}

// --- combinations

TEST_F(CliError, WhichStone) {
  for (const std::string typed : {"51", "29", "0", "-33", "99999999999999999999"}) {
    expect_error({"inertia", "--size", typed}, "size = " + typed + ": " + sizes);
  }
  expect_error({"inertia", "--size", "33", "--color", "red"}, "color = red: must be white or black");
  expect_error({"inertia", "--size", "33", "--color", "both"}, "color = both: must be white or black");
  expect_error({"table", "--color", "red"}, "color = red: must be white, black or both");
  expect_error({"inertia", "--size", "33", "--density", "2800", "--mass", "5g"},
               "density = 2800: must not be given with --mass (5g)");
  expect_error({"inertia"}, "a stone is needed: --size, or --width and --height");
  expect_error({"inertia", "--size", "33", "--width", "22mm", "--height", "9mm"},
               "width = 22mm: must not be given with --size (33)");
  expect_error({"inertia", "--size", "33", "--height", "9mm"}, "height = 9mm: must not be given with --size (33)");
  expect_error({"inertia", "--width", "22mm"}, "width = 22mm: needs --height too");
  expect_error({"inertia", "--height", "9mm"}, "height = 9mm: needs --width too");
  expect_error({"inertia", "--width", "22mm", "--height", "9mm", "--color", "black"},
               "color = black: needs --size too");
}

TEST_F(CliError, WhichStandard) {
  const std::string rule = ": must be talk or nihon-kiin";
  const std::string commands[] = {"table",
                                  "inertia --size 33",
                                  "spin --size 33 --spin 1,2,3 --time 1",
                                  "contact --size 33 --position 0,0,1",
                                  "contact --size 33 --position 0,0,1 --against plane",
                                  "contact --width 22mm --height 9mm --position 0,0,1",
                                  "drop --size 33 --from 1cm",
                                  "drop --size 33 --from 1cm --on plane",
                                  "drop --width 22mm --height 9mm --from 1cm --on floor-board"};
  for (const std::string& command : commands) {
    for (const std::string typed : {"agfa", "Talk", "nihon_kiin", "1", ""}) {
      expect_error(words_of(command) + Words{"--standard", typed}, "standard = " + typed + rule);
    }
  }
  const std::string size = "standard = nihon-kiin: needs --size too";
  expect_error(words_of("inertia --width 22mm --height 9mm --standard nihon-kiin"), size);
  expect_error(words_of("spin --axial 1 --transverse 1 --spin 1,2,3 --time 1 --standard nihon-kiin"), size);
  expect_error(words_of("contact --width 1 --height 1 --position 0,0,1 --against plane --standard nihon-kiin"), size);
  expect_error(words_of("drop --width 22mm --height 9mm --from 1cm --on plane --standard nihon-kiin"), size);
  expect_error(words_of("mesh --width 22mm --height 9mm --stats --standard nihon-kiin"), size);
}

TEST_F(CliError, Formats) {
  expect_error({"inertia", "--size", "33", "--format", "csv"}, "format = csv: must be text or json");
  expect_error({"table", "--format", "xml"}, "format = xml: must be text, markdown, csv, json or cpp");
  expect_error({"table", "--units", "imperial"}, "units = imperial: must be si or cgs");
  expect_error({"table", "--units", "cgs", "--format", "cpp"}, "units = cgs: must be si with --format cpp");
  expect_error({"table", "--density", "1e400", "--format", "cpp"},
               "density = 1e400: is beyond the range of a double, which --format cpp prints");
}

TEST_F(CliError, Usage) {
  expect_error({}, "a command is needed: table, inertia, spin, contact, drop, scene, mesh or body");
  expect_error({"bake"}, "not expected: bake");
  expect_error({"--bake"}, "not expected: --bake");
  expect_error({"table", "--bake"}, "not expected: --bake");
  expect_error({"table", "extra"}, "not expected: extra");
  expect_error({"inertia", "--size"}, "--size: 1 required N missing");
  expect_error({"inertia", "--size=", "--color", "white"}, "size = : " + sizes);
  expect_error({"inertia", "--size", "33", "--size", "33"}, "--size: At Most 1 required but received 2");
  expect_error({"inertia", "--size", "33", "table", "--bevel", "0"}, "not expected: table");
  expect_error({"inertia", "--width", "22", "mm", "--height", "9mm"}, "not expected: mm");
}

}  // namespace

}  // namespace goishi::cli_test
