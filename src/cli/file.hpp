#pragma once
/// \file
/// Files, whole or not at all. Every failure is an exception: a full device is noticed.

#include <cstddef>
#include <string>
#include <string_view>

namespace goishi::cli {

/// "stl" of "a/b.STL": what stands behind the last point of a file's name, in lower case.
[[nodiscard]] std::string extension_of(const std::string& file);

/// Throws std::runtime_error when the text cannot be written to the end.
void write_standard_output(std::string_view text);

/// Writes under a temporary name in the same folder, then renames; on failure FILE is as it was,
/// nothing else is left, and the exception is InvalidArgument. A file that its user may not write is not replaced.
/// A device or a pipe is written directly.
void write_file(const std::string& argument, const std::string& file, std::string_view text);

/// A file and what is to be in it.
struct FileText {
  std::string name;
  std::string_view text;
};

/// Writes a file as `write_file` does, and one that it names beside it: both stand under temporary names before either is
/// renamed. No device and no pipe: InvalidArgument, which speaks of the file.
void write_pair(const std::string& argument, const FileText& beside, const FileText& file);

/// The file, or its first `most` bytes: a device may have no end. InvalidArgument when it cannot be read.
[[nodiscard]] std::string read_file(const std::string& argument, const std::string& file, std::size_t most);

}  // namespace goishi::cli
