#pragma once
/// \file
/// The files of the set, `reference.schema.json` describes them: written from problems, read as a judge needs them.

#include <string>
#include <string_view>
#include <vector>

#include "verify/reference/enclosure.hpp"
#include "verify/reference/problem.hpp"

namespace goishi::verify::reference {

/// A file, with the enclosures that it takes long to compute.
[[nodiscard]] std::string file_text(const Section& section);

/// What a judge takes from a file.
struct ReadCase {
  std::string id;
  std::vector<Enclosure> answers;
};
struct ReadFile {
  std::string section;
  std::vector<std::string> either_sign;  // quantities that are the same with the other sign
  std::vector<ReadCase> cases;
};

/// Throws std::runtime_error, which says what is wrong, where the text is no file of the set.
[[nodiscard]] ReadFile read_file(std::string_view text);

}  // namespace goishi::verify::reference
