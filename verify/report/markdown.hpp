#pragma once
/// \file
/// What a full run leaves in the documents, and a bench in its own: tables between two markers, `<!-- goishi-verify: NAME -->` and
/// `<!-- end -->`, written and compared.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "verify/suite/run.hpp"

namespace goishi::verify::markdown {

/// In README.md, part `subjects`: a row for each folder of verify/claims, with its weakest check.
/// In verify/README.md, part `claims`: a row for each claim, with its weakest check.
/// The weakest is the check whose error comes nearest to its bound. One that must find nothing, with the bound 0, is
/// shown only where there is no other.
[[nodiscard]] std::string subjects_table(const Run& run);
[[nodiscard]] std::string claims_table(const Run& run);

/// Another processor, with another mathematics library, may change an error by this factor, up or down.
inline constexpr double greatest_change = 1.5;

/// How a table differs from what the run gives; empty where it does not. Text and bounds are compared exactly. An error
/// may differ by `greatest_change`, and so another check may be the weakest.
[[nodiscard]] std::vector<std::string> subjects_differences(std::string_view table, const Run& run);
[[nodiscard]] std::vector<std::string> claims_differences(std::string_view table, const Run& run);

/// What stands in a part, without blank lines around it, and the document with another text there. Throws
/// std::runtime_error where the document does not have the part exactly once.
[[nodiscard]] std::string part(std::string_view document, std::string_view name);
[[nodiscard]] std::string with_part(std::string_view document, std::string_view name, std::string_view text);

/// The same of a document on disk, which the message of an exception names.
[[nodiscard]] std::string part_of_file(const std::filesystem::path& document, std::string_view name);
[[nodiscard]] std::string file_with_part(const std::filesystem::path& document, std::string_view name,
                                         std::string_view text);

/// Throws std::runtime_error where `root` does not have both documents with their parts.
void require_parts(const std::filesystem::path& root);
/// Into both documents, or none.
void write_tables(const Run& run, const std::filesystem::path& root);
[[nodiscard]] std::vector<std::string> table_differences(const Run& run, const std::filesystem::path& root);

}  // namespace goishi::verify::markdown
