/// The reference set: its files keep to the schema, and the judge of answers sees a wrong digit.

#include <gtest/gtest.h>
#include <rapidjson/document.h>
#include <rapidjson/schema.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include "verify/oracles/motion/free_body.hpp"
#include "verify/reference/answers.hpp"
#include "verify/reference/bracket.hpp"
#include "verify/reference/elliptic.hpp"
#include "verify/reference/enclosure.hpp"
#include "verify/reference/file.hpp"
#include "verify/reference/sections.hpp"

namespace goishi::verify::reference {
namespace {

std::string reference_text(const std::string& file) {
  std::ifstream stream(std::filesystem::path(GOISHI_REFERENCE_FOLDER) / file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string edited(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// Empty when the schema accepts the text, else what is wrong.
std::string file_error(const std::string& text) {
  rapidjson::Document schema_json, document;
  schema_json.Parse(reference_text("reference.schema.json").c_str());
  EXPECT_FALSE(schema_json.HasParseError());
  document.Parse<rapidjson::kParseValidateEncodingFlag>(text.c_str());
  if (document.HasParseError()) {
    return "not JSON";
  }
  const rapidjson::SchemaDocument schema(schema_json);
  rapidjson::SchemaValidator validator(schema);
  return document.Accept(validator) ? "" : validator.GetInvalidSchemaKeyword();
}

std::vector<ReadFile> all_files() {
  std::vector<ReadFile> files;
  for (const Section& section : all_sections()) {
    files.push_back(read_file(reference_text(section.name + ".json")));
  }
  return files;
}

TEST(ReferenceFiles, KeepToTheSchema) {
  for (const Section& section : all_sections()) {
    EXPECT_EQ(file_error(reference_text(section.name + ".json")), "") << section.name;
  }
}

TEST(ReferenceFiles, TheSchemaRefuses) {
  const std::string good = reference_text("shapes.json");
  EXPECT_NE(file_error(edited(good, "\"rad\": \"", "\"radius\": \"")), "");
  EXPECT_NE(file_error(edited(good, "\"mid\": \"", "\"mid\": \"x")), "");
  EXPECT_NE(file_error(edited(good, "\"proof\": \"formula\"", "\"proof\": \"I saw it\"")), "");
  EXPECT_NE(file_error(edited(good, "\"id\": \"shape-001\"", "\"id\": 1")), "");
}

/// A file names what its cases give and ask for, each case once; all have three megabytes together.
TEST(ReferenceFiles, SayWhatTheyHold) {
  std::set<std::string> ids;
  std::size_t size = 0;
  for (const Section& section : all_sections()) {
    std::map<std::string, int> components, seen;
    std::set<std::string> inputs;
    for (const QuantityKind& quantity : section.quantities) {
      components[quantity.name] = quantity.proof == Proof::word ? 0 : quantity.components;
    }
    for (const InputKind& input : section.inputs) {
      inputs.insert(input.name);
    }
    const std::string text = reference_text(section.name + ".json");
    const ReadFile file = read_file(text);
    size += text.size();
    ASSERT_EQ(file.cases.size(), section.problems.size());
    for (std::size_t i = 0; i < file.cases.size(); ++i) {
      EXPECT_TRUE(ids.insert(file.cases[i].id).second) << file.cases[i].id;
      EXPECT_EQ(file.cases[i].id, section.problems[i].id);
      for (const Input& input : section.problems[i].inputs) {
        EXPECT_TRUE(inputs.contains(input.name)) << input.name;
      }
      for (const Enclosure& answer : file.cases[i].answers) {
        ASSERT_TRUE(components.contains(answer.quantity)) << answer.quantity;
        EXPECT_EQ(static_cast<int>(answer.mid.size()), components[answer.quantity]) << answer.quantity;
        EXPECT_TRUE(!(0.0 < answer.scale) || scale_of(answer.scale) == answer.scale) << answer.scale;
        ++seen[answer.quantity];
      }
    }
    EXPECT_EQ(seen.size(), components.size()) << section.name;
  }
  EXPECT_LT(size, 3000000U);
}

/// The greatest error of the library's own answers, by file   [ulp]. Measured on 2026-11-30; twice that is allowed.
TEST(ReferenceAnswers, TheLibraryKeepsItsBounds) {
  const std::map<std::string, double> measured = {{"shapes", 1.16}, {"mass", 3.07},   {"surface", 0.469},
                                                  {"flight", 1.62}, {"impact", 1.33}, {"contact", 27.2},
                                                  {"drop", 2.9}};
  std::vector<Given> answers;
  for (const Section& section : all_sections()) {
    const std::vector<Given> own = read_csv(own_answers(section));
    answers.insert(answers.end(), own.begin(), own.end());
  }
  std::map<std::string, double> greatest;
  for (const Tally& tally : judge(all_files(), answers)) {
    EXPECT_EQ(static_cast<int>(tally.errors.size()), tally.cases) << tally.section << ", " << tally.quantity;
    greatest[tally.section] = std::fmax(greatest[tally.section], tally.errors.back());
  }
  ASSERT_EQ(greatest.size(), measured.size());
  for (const auto& [section, error] : greatest) {
    EXPECT_LE(error, 2.0 * measured.at(section)) << section;
    EXPECT_LE(measured.at(section), 10.0 * error) << section << ": a bound that guards nothing";
  }
}

/// A wrong last digit of a double moves an answer by an ulp or more, and the judge says so.
TEST(ReferenceAnswers, AWrongDigitIsSeen) {
  const Section shapes = shapes_section();
  const std::string right = own_answers(shapes);
  const std::string wrong =
      edited(right, "shape-001,sphere_radius,0.011", "shape-001,sphere_radius,0.01100000000000001");
  const std::vector<ReadFile> files = {read_file(reference_text("shapes.json"))};
  const auto radius = [&](const std::string& answers) {
    for (Tally& tally : judge(files, read_csv(answers))) {
      if (tally.quantity == "sphere_radius") {
        return std::move(tally);
      }
    }
    return Tally();
  };
  EXPECT_LE(radius(right).errors.back(), 1.0);
  EXPECT_GT(radius(wrong).errors.back(), 5.0);
  EXPECT_EQ(radius(wrong).worst, "shape-001");
}

/// A digit of the file that is changed is another value, whatever the answer's precision.
TEST(ReferenceAnswers, AWrongDigitOfTheFileIsSeen) {
  const Enclosure third{.quantity = "x", .mid = {"3.33333333333333333333333333333e-1"}, .rad = "1e-30"};
  const Given answer{.id = "", .quantity = "x", .values = {"0.33333333333333333333333333333333"}};
  EXPECT_LT(error_of(answer, third, false), 1e-13);
  Enclosure changed = third;
  changed.mid.front()[25] = '4';
  EXPECT_GT(error_of(answer, changed, false), 1e-10);
}

TEST(ReferenceAnswers, AreCountedInUlps) {
  const Enclosure one{.quantity = "x", .mid = {"1"}, .rad = "0"};
  const auto error = [](const Enclosure& exact, std::vector<std::string> values, bool either_sign = false) {
    return error_of({.id = "", .quantity = "x", .values = std::move(values)}, exact, either_sign);
  };
  EXPECT_EQ(error(one, {"1"}), 0.0);
  EXPECT_EQ(error(one, {"1.000000000000000222044604925031308"}), 1.0);
  EXPECT_EQ(error(one, {"0x1.0000000000002p0"}), 2.0);
  EXPECT_EQ(error(one, {"0x1p0"}), 0.0);
  const Enclosure scaled{.quantity = "x", .mid = {"0", "1", "0"}, .rad = "0", .scale = 4.0};
  EXPECT_EQ(error(scaled, {"0x3p-52", "1", "-0x4p-52"}), 1.25);
  EXPECT_EQ(error(scaled, {"0", "-1", "0"}, true), 0.0);
  EXPECT_GT(error(scaled, {"0", "-1", "0"}), 1e15);
  const double none = std::numeric_limits<double>::infinity();
  for (const char* text : {"nan", "inf", "-inf", "one", "", "1x", "1e999"}) {
    EXPECT_EQ(error(one, {text}), none) << text;
  }
  EXPECT_EQ(error(one, {"1", "1"}), none);
  const Enclosure word{.quantity = "x", .mid = {}, .rad = "0", .scale = 0.0, .word = "hit"};
  EXPECT_EQ(error(word, {"hit"}), 0.0);
  EXPECT_EQ(error(word, {"none"}), none);
}

TEST(ReferenceAnswers, AreReadAsCsvOrJson) {
  const std::vector<Given> csv = read_answers("id,quantity,value\r\n# mine\n\n a-1 , x , 1.50 \na-2,y,1,2,3\n");
  ASSERT_EQ(csv.size(), 2U);
  EXPECT_EQ(csv[0].id, "a-1");
  EXPECT_EQ(csv[0].quantity, "x");
  EXPECT_EQ(csv[0].values, std::vector<std::string>{"1.50"});
  EXPECT_EQ(csv[1].values.size(), 3U);
  const std::vector<Given> json =
      read_answers(R"({"a-1": {"x": 0.1000000000000000055511151231257827, "s": "hit"}, "a-2": {"y": [1, 2, 3]}})");
  ASSERT_EQ(json.size(), 3U);
  EXPECT_EQ(json[0].values, std::vector<std::string>{"0.1000000000000000055511151231257827"});
  EXPECT_EQ(json[1].values, std::vector<std::string>{"hit"});
  EXPECT_EQ(json[2].values, (std::vector<std::string>{"1", "2", "3"}));
  for (const char* text :
       {"a-1,x", "a-1", "{", "{\"a-1\": 1}", "{\"a-1\": {\"x\": true}}", "{\"a-1\": {\"x\": [[1]]}}"}) {
    EXPECT_THROW(static_cast<void>(read_answers(text)), std::runtime_error) << text;
  }
}

TEST(ReferenceAnswers, ToWhatNobodyAsksAreRefused) {
  const std::vector<ReadFile> files = {read_file(reference_text("shapes.json"))};
  const auto judged = [&](const char* text) { static_cast<void>(judge(files, read_csv(text))); };
  EXPECT_NO_THROW(judged("shape-001,sphere_radius,1"));
  EXPECT_THROW(judged("shape-999,sphere_radius,1"), std::runtime_error);
  EXPECT_THROW(judged("shape-001,radius,1"), std::runtime_error);
  EXPECT_THROW(judged("shape-001,sphere_radius,1\nshape-001,sphere_radius,1"), std::runtime_error);
}

TEST(ReferenceEnclosure, HasThirtyDigits) {
  const auto print = [](const Ball& x, double scale = 0.0) {
    return printed({.quantity = "x", .values = {OrderedBall(x)}, .scale = scale, .word = ""});
  };
  const Enclosure third = print(Ball(1) / Ball(3));
  EXPECT_EQ(third.mid.front(), "3.33333333333333333333333333333e-1");
  EXPECT_EQ(third.rad, "1e-30");
  EXPECT_EQ(print(Ball(2) / Ball(3)).mid.front(), "6.66666666666666666666666666667e-1");
  EXPECT_EQ(print(-(Ball(2000) / Ball(3))).mid.front(), "-6.66666666666666666666666666667e2");
  EXPECT_EQ(print(Ball(0.375)).mid.front(), "3.75e-1");
  EXPECT_EQ(print(Ball(0.375)).rad, "0");
  EXPECT_EQ(print(Ball(10)).mid.front(), "1e1");
  EXPECT_EQ(print(Ball(1) / Ball(3), 1024.0).mid.front(), "3.3333333333333333333333333e-1");
  EXPECT_EQ(print(Ball(1) / Ball(3), 1024.0).rad, "1e-26");
  EXPECT_EQ(print(Ball(0), 1.0).mid.front(), "0");
}

TEST(ReferenceEnclosure, AWideBallIsNone) {
  const auto print = [](double radius, double scale) {
    Ball one(1);
    arb_add_error(one.get(), Ball(radius).get());
    return printed({.quantity = "x", .values = {OrderedBall(one)}, .scale = scale, .word = ""});
  };
  EXPECT_NO_THROW(static_cast<void>(print(0.9e-29, 0.0)));
  EXPECT_THROW(static_cast<void>(print(1.1e-29, 0.0)), std::runtime_error);
  EXPECT_NO_THROW(static_cast<void>(print(1.1e-29, 16.0)));
  EXPECT_THROW(static_cast<void>(print(2.0, 0.0)), std::runtime_error);
  EXPECT_THROW(static_cast<void>(printed({.quantity = "x", .values = {OrderedBall(0)}})), std::runtime_error);
  EXPECT_THROW(static_cast<void>(printed({.quantity = "x", .values = {OrderedBall(1) / OrderedBall(0)}, .scale = 1.0})),
               std::runtime_error);
}

TEST(ReferenceEnclosure, TwoWaysMeetOrNot) {
  const OrderedBall third = OrderedBall(1) / OrderedBall(3), sixth = OrderedBall(1) / OrderedBall(6);
  EXPECT_NO_THROW(require_met(third, sixth + sixth, "a third"));
  EXPECT_THROW(require_met(third, third + OrderedBall(Ball::from_decimal("1e-60")), "a third"), std::runtime_error);
  Ball wide(0);
  arb_add_error_2exp_si(wide.get(), 3);
  EXPECT_THROW(require_met(third, OrderedBall(wide), "a third"), std::runtime_error);
  EXPECT_THROW(require_met(third, OrderedBall(1) / OrderedBall(0), "a third"), std::runtime_error);
}

TEST(ReferenceEnclosure, ScalesArePowersOfTwo) {
  EXPECT_EQ(scale_of(1.0), 1.0);
  EXPECT_EQ(scale_of(std::nextafter(1.0, 2.0)), 2.0);
  EXPECT_EQ(scale_of(0.3), 0.5);
  EXPECT_EQ(scale_of(0.0), 1.0);
}

/// What is undecided gives a ball that holds what all branches give.
TEST(ReferenceEnclosure, HoldsAllBranches) {
  const auto one = [](int x, const char* choice) {
    return Answers<OrderedBall>{{.quantity = "x", .values = {OrderedBall(x)}},
                                {.quantity = "choice", .values = {}, .scale = 0.0, .word = choice}};
  };
  const Answers<OrderedBall> both = common({one(1, "cap"), one(3, "rim")});
  ASSERT_EQ(both.size(), 1U);
  EXPECT_TRUE(both.front().values.front().ball().overlaps(Ball(2)));
  EXPECT_FALSE(both.front().values.front().ball().overlaps(Ball(4)));
  EXPECT_EQ(common({one(1, "cap"), one(1, "cap")}).size(), 2U);
}

// --- the elliptic functions of balls

TEST(ReferenceElliptic, WhereTheyAreKnown) {
  using Number = OrderedBall;
  const auto meet = [](const Number& x, const Number& y) {
    return x.ball().is_finite() && x.ball().relative_radius() < 1e-65 && x.ball().overlaps(y.ball());
  };
  const Number x(3), root = scalar::sqrt(x), pi = scalar::pi<Number>();
  EXPECT_TRUE(meet(elliptic::carlson_f<Number>(x, x, x), Number(1) / root));
  EXPECT_TRUE(meet(elliptic::carlson_f<Number>(Number(0), x, x), pi / (Number(2) * root)));
  EXPECT_TRUE(meet(elliptic::carlson_j<Number>(x, x, x, x), Number(1) / (x * root)));
  // R_J(0, y, y, p) = 3π / (2 (y √p + p √y)).
  EXPECT_TRUE(meet(elliptic::carlson_j<Number>(Number(0), Number(4), Number(4), Number(9)), pi / Number(20)));
  for (const double m1 : {0.5, 0.999, 1e-12}) {
    const Number m = Number(1) - Number(m1);
    const elliptic::JacobiFunctions<Number> jacobi{Number(m1)};
    const Number K = jacobi.quarter_period();
    EXPECT_TRUE(meet(K, elliptic::carlson_f<Number>(Number(0), Number(m1), Number(1))));
    for (const int part : {1, 3, 7}) {
      const elliptic::Jacobi<Number> at = jacobi(K * Number(part) / Number(10));
      EXPECT_TRUE(meet(at.sn * at.sn + at.cn * at.cn, Number(1))) << m1;
      EXPECT_TRUE(meet(at.dn * at.dn + m * at.sn * at.sn, Number(1))) << m1;
      // The integral of the first kind leads back.
      const Number back = at.sn * elliptic::carlson_f<Number>(at.cn * at.cn, at.dn * at.dn, Number(1));
      EXPECT_TRUE(meet(back, K * Number(part) / Number(10))) << m1;
    }
  }
}

// --- flights, by another way than their energy

template <std::size_t count>
std::array<Quad, count> quads_of(const Problem& problem, const std::string& name) {
  std::array<Quad, count> result;
  const auto given = std::ranges::find(problem.inputs, name, &Input::name);
  EXPECT_EQ(given->numbers.size(), count) << name;
  std::ranges::transform(given->numbers, result.begin(), [](double x) { return Quad(x); });
  return result;
}

/// The length of the difference, in units of the scale.
template <std::size_t count>
double off(const std::array<Quad, count>& integrated, const Enclosure& enclosed, int sign) {
  Quad square = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Quad difference = integrated[i] - sign * Quad(enclosed.mid.at(i));
    square += difference * difference;
  }
  return static_cast<double>(Quad(sqrt(square))) / enclosed.scale;
}

TEST(ReferenceFlight, MeetsTheIntegratedEquations) {
  constexpr double least_angle = 0.5, most_angle = 20.0;  // 10 ms a radian
  const Section section = flight_section();
  const ReadFile file = read_file(reference_text("flight.json"));
  int symmetric = 0, asymmetric = 0;
  for (std::size_t i = 0; i < section.problems.size(); ++i) {
    const Problem& problem = section.problems[i];
    const auto spin = quads_of<3>(problem, "spin"), moments = quads_of<3>(problem, "moments");
    const Quad time = quads_of<1>(problem, "time").front();
    const Quad rate = sqrt(spin[0] * spin[0] + spin[1] * spin[1] + spin[2] * spin[2]);
    const double angle = std::fabs(static_cast<double>(Quad(rate * time)));
    if (!(least_angle < angle && angle < most_angle)) {
      continue;
    }
    const FreeBodyReference integrated =
        integrate_free_body({.moments = moments, .attitude = quads_of<4>(problem, "attitude"), .spin = spin}, time);
    const auto answer = [&](const std::string& quantity) {
      return *std::ranges::find(file.cases[i].answers, quantity, &Enclosure::quantity);
    };
    const Enclosure attitude = answer("attitude");
    EXPECT_LT(std::fmin(off(integrated.attitude, attitude, 1), off(integrated.attitude, attitude, -1)), 1e-21)
        << problem.id << ", " << problem.about;
    EXPECT_LT(off(integrated.spin, answer("spin"), 1), 1e-21) << problem.id << ", " << problem.about;
    ++(moments[0] == moments[1] ? symmetric : asymmetric);
  }
  EXPECT_GE(symmetric, 3);
  EXPECT_GE(asymmetric, 3);
}

// --- what proves gaps and times, where they are known

/// Of lengths and times of some hundredths.
void expect_known(const OrderedBall& enclosed, const OrderedBall& known) {
  EXPECT_TRUE(enclosed.ball().overlaps(known.ball())) << enclosed << " and " << known;
  Ball radius;
  arb_get_rad_arb(radius.get(), enclosed.ball().get());
  EXPECT_LT(static_cast<double>(radius), 1e-60);
}

Shape ball_shape() {
  return {0.022, 0.022, 0.0, false, "the ball"};
}
Shape bevelled_shape() {
  return {0.022, 0.0092, 0.001, false, "size 33, b = 1 mm"};
}

TEST(ReferenceBracket, GapsOfBalls) {
  const OrderedBall half = OrderedBall(0.022) / OrderedBall(2);
  Encounter two;
  two.against = Against::stone;
  two.first = {.shape = ball_shape(), .position = {0.03, -0.04, 0.0}, .attitude = {1.0, 2.0, 3.0, 4.0}};
  two.other = {.shape = ball_shape()};
  const OrderedBall x(0.03), y(-0.04);
  expect_known(enclosed_gap(two, OrderedBall(0)).gap, scalar::sqrt(OrderedBall(x * x + y * y)) - OrderedBall(0.022));
  Encounter corner;
  corner.against = Against::board;
  corner.first = {.shape = ball_shape(), .position = {0.25, 0.25, 0.03}, .attitude = {1.0, 2.0, 3.0, 4.0}};
  const OrderedBall dx = OrderedBall(0.25) - OrderedBall(board_half_width),
                    dy = OrderedBall(0.25) - OrderedBall(board_half_length), dz(0.03);
  const OrderedBall far = scalar::sqrt(OrderedBall(dx * dx + dy * dy + dz * dz));
  const EnclosedGap met = enclosed_gap(corner, OrderedBall(0));
  expect_known(met.gap, far - half);
  ASSERT_TRUE(met.contact.has_value());
  EXPECT_TRUE(met.contact->n_W.x().ball().overlaps((dx / far).ball()));
  EXPECT_TRUE(met.contact->p_other.z().ball().overlaps(Ball(0)));
}

/// Cores that overlap have no two points by which a normal is proved the best: the enclosure says nothing of the depth.
TEST(ReferenceBracket, AnOverlapIsNotProved) {
  Encounter two;
  two.against = Against::stone;
  two.first = {.shape = bevelled_shape(), .position = {0.005, 0.0, 0.003}, .attitude = {4.0, 1.0, 0.0, 0.0}};
  two.other = {.shape = bevelled_shape()};
  const EnclosedGap met = enclosed_gap(two, OrderedBall(0));
  EXPECT_FALSE(met.contact.has_value());
  EXPECT_THROW(static_cast<void>(printed({.quantity = "gap", .values = {met.gap}, .scale = 1.0})), std::runtime_error);
}

TEST(ReferenceBracket, TimesOfFalls) {
  const OrderedBall g(9.80665), start(0.05), half = OrderedBall(0.0092) / OrderedBall(2);
  Encounter fall;
  fall.first = {.shape = bevelled_shape(), .position = {0.0, 0.0, 0.05}};
  fall.gravity = {0.0, 0.0, -9.80665};
  const OrderedBall known = scalar::sqrt(OrderedBall(OrderedBall(2) * (start - half) / g));
  for (const Against against : {Against::plane, Against::board}) {
    fall.against = against;
    const auto time = enclosed_touch(fall);
    ASSERT_TRUE(time.has_value());
    expect_known(*time, known);
  }
  fall.horizon = 0.0961;  // it is 0.09623 s
  EXPECT_FALSE(enclosed_touch(fall).has_value());
}

TEST(ReferenceBracket, WhatIsNoTouchIsNotProved) {
  Encounter fall;
  fall.against = Against::board;
  fall.gravity = {0.0, 0.0, -9.80665};
  fall.first = {.shape = bevelled_shape(), .position = {0.0, 0.0, 0.001}};  // it begins inside
  EXPECT_THROW(static_cast<void>(enclosed_touch(fall)), std::runtime_error);
  fall.first = {.shape = {0.022, 0.0092, 0.0, false, "sharp"}, .position = {0.0, 0.0, 0.05}};  // no bevel to reach into
  EXPECT_THROW(static_cast<void>(enclosed_touch(fall)), std::runtime_error);
}

}  // namespace
}  // namespace goishi::verify::reference
