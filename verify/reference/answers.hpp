#pragma once
/// \file
/// Anybody's answers to the set, and how far off each is.

#include <string>
#include <string_view>
#include <vector>

#include "verify/reference/file.hpp"
#include "verify/reference/problem.hpp"

namespace goishi::verify::reference {

/// An answer as it was written: decimals with any number of digits, or a word.
struct Given {
  std::string id;
  std::string quantity;
  std::vector<std::string> values;
};

/// Lines `id,quantity,value[,value…]`; empty ones, those that begin with # and a first one that begins with `id,` are passed
/// over. Throws std::runtime_error where a line is none.
[[nodiscard]] std::vector<Given> read_csv(std::string_view text);

/// {"id": {"quantity": value or [value, …], …}, …}, values as numbers or as strings. Throws likewise.
[[nodiscard]] std::vector<Given> read_json(std::string_view text);

/// JSON if it begins with a brace, else CSV.
[[nodiscard]] std::vector<Given> read_answers(std::string_view text);

/// The library's own answers in double, as lines of CSV.
[[nodiscard]] std::string own_answers(const Section& section);

/// |given − exact| in ulps of the double nearest to the scale, or to the value where there is no scale; of several
/// components, the length of the difference. Infinite for another word, for what is no finite number, and for another number
/// of components.
[[nodiscard]] double error_of(const Given& given, const Enclosure& exact, bool either_sign);

/// The errors of one quantity of one file.
struct Tally {
  std::string section;
  std::string quantity;
  int cases = 0;               // that ask for it
  std::vector<double> errors;  // of those that were answered, in ascending order
  std::string worst;           // the case with the greatest error
};

/// Quantities in the order of the files. Throws std::runtime_error for an answer to what no case asks, and for a second one
/// to the same.
[[nodiscard]] std::vector<Tally> judge(const std::vector<ReadFile>& files, const std::vector<Given>& answers);

[[nodiscard]] double median_of(const Tally& tally);

}  // namespace goishi::verify::reference
