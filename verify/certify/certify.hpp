#pragma once
/// \file
/// Judges printed numbers: each is the correctly rounded decimal of an enclosure, or a fault.

#include <filesystem>
#include <goishi/standard.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace goishi::verify::certify {

struct Outcome {
  int certified = 0;                // numbers whose every digit is proved
  std::vector<std::string> faults;  // numbers that are not, and whatever else is wrong, each in a sentence
};

/// A table that `goishi table` printed with the catalogue's densities and by this standard: every number, and that each
/// colour and bevel that occurs has all sizes. In a `whole` table white and black, sharp and with b = 1 mm, must all
/// occur.
[[nodiscard]] Outcome certify_table(std::string_view text, bool whole = false, Standard standard = Standard::talk);

/// A document for people: the exact results in its sentences, each of which must stand there, and the table below its
/// marker `<!-- goishi table … -->`, which README.md must have. `file` says which document it is. Measured figures
/// (errors, times) and what a simulated drop prints cannot be certified and are not looked at.
[[nodiscard]] Outcome certify_document(std::string_view text, const std::filesystem::path& file = "README.md");

}  // namespace goishi::verify::certify
