#pragma once
/// \file
/// The reference set: problems with exact inputs, and what their answers are in any scalar.

#include <algorithm>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "verify/oracles/numbers/ordered_ball.hpp"

namespace goishi::verify::reference {

/// What a problem gives: a number, several, or a word. Each number is a double, to be taken as exact.
struct Input {
  std::string name;
  std::vector<double> numbers = {};
  std::string word = {};  // in place of numbers
};

/// What a problem asks for, in a scalar.
template <class T>
struct Answer {
  std::string quantity;
  std::vector<T> values = {};
  double scale = 0.0;     // an error is counted in ulps of it; 0: in ulps of the value itself
  std::string word = {};  // in place of values
};

template <class T>
using Answers = std::vector<Answer<T>>;

/// A problem, its enclosed answers, and those of the library in double.
struct Problem {
  std::string id;
  std::string about;
  std::vector<Input> inputs;
  std::function<Answers<OrderedBall>()> enclose;
  std::function<Answers<double>()> compute;
};

/// What the file says of an input.
struct InputKind {
  std::string name;
  std::string unit;  // empty: none
  std::string about;
};

/// How an enclosure is proved.
enum class Proof {
  formula,   // the formula on balls, each choice proved by them; at a switch, what all branches give
  integral,  // the same, and it meets Arb's rigorous integration of the solid
  bracket,   // a normal that separates so much, and two points that are so near
  root,      // positive before, and of the other sign after
  word       // a choice, proved by balls
};

struct QuantityKind {
  std::string name;
  std::string unit;
  int components = 1;
  Proof proof = Proof::formula;
  std::string about;
  bool either_sign = false;  // q and −q are the same
};

/// A file of the set.
struct Section {
  std::string name;
  std::string about;
  std::vector<InputKind> inputs;
  std::vector<QuantityKind> quantities;
  std::vector<Problem> problems;
};

/// What all answers that undecided comparisons leave open have in common: for each number a ball that contains them all.
/// Answers that not all of them have, and words in which they differ, are left out.
[[nodiscard]] Answers<OrderedBall> common(std::vector<Answers<OrderedBall>> outcomes);

/// A problem whose answers are `ask(std::type_identity<T>())`, the same source on balls and in double.
template <class Ask>
[[nodiscard]] Problem make_problem(std::string id, std::string about, std::vector<Input> inputs, Ask ask) {
  return {.id = std::move(id),
          .about = std::move(about),
          .inputs = std::move(inputs),
          .enclose = [ask] { return common(every_outcome([&] { return ask(std::type_identity<OrderedBall>()); })); },
          .compute = [ask] { return ask(std::type_identity<double>()); }};
}

}  // namespace goishi::verify::reference
