#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "verify/report/escape.hpp"
#include "verify/report/markdown.hpp"
#include "verify/report/report.hpp"

namespace goishi::verify::markdown {

namespace {

/// Where what stands between the markers begins and ends.
std::pair<std::size_t, std::size_t> place_of(std::string_view document, std::string_view name) {
  const std::string begin = fmt::format("<!-- goishi-verify: {} -->\n", name);
  constexpr std::string_view end = "<!-- end -->";
  const std::size_t marker = document.find(begin);
  const std::size_t first = marker == std::string_view::npos ? marker : marker + begin.size();
  const std::size_t last = marker == std::string_view::npos ? marker : document.find(end, first);
  if (last == std::string_view::npos || document.find(begin, first) != std::string_view::npos) {
    throw std::runtime_error(fmt::format("must have one part from <!-- goishi-verify: {} --> to {}", name, end));
  }
  return {first, last};
}

struct Document {
  std::string_view file;  // below the root
  std::string_view name;  // of its part
  std::string (*table)(const Run&);
  std::vector<std::string> (*differences)(std::string_view, const Run&);
};

constexpr std::array documents = {Document{"README.md", "subjects", subjects_table, subjects_differences},
                                  Document{"verify/README.md", "claims", claims_table, claims_differences}};

std::string read(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) {
    throw std::runtime_error(fmt::format("cannot read {}", printable(path.string())));
  }
  return text;
}

/// What is wrong with a document says which one.
template <class Function>
auto of_document(const std::filesystem::path& path, Function&& function) {
  const std::string text = read(path);
  try {
    return function(text);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{} {}", printable(path.string()), error.what()));
  }
}

}  // namespace

std::string part(std::string_view document, std::string_view name) {
  auto [begin, end] = place_of(document, name);
  while (begin < end && document[begin] == '\n') {
    ++begin;
  }
  while (begin < end && document[end - 1] == '\n') {
    --end;
  }
  return std::string(document.substr(begin, end - begin));
}

std::string with_part(std::string_view document, std::string_view name, std::string_view text) {
  const auto [begin, end] = place_of(document, name);
  return fmt::format("{}\n{}\n{}", document.substr(0, begin), text, document.substr(end));
}

std::string part_of_file(const std::filesystem::path& document, std::string_view name) {
  return of_document(document, [&](std::string_view text) { return part(text, name); });
}

std::string file_with_part(const std::filesystem::path& document, std::string_view name, std::string_view text) {
  return of_document(document, [&](std::string_view whole) { return with_part(whole, name, text); });
}

void require_parts(const std::filesystem::path& root) {
  for (const Document& document : documents) {
    (void)part_of_file(root / document.file, document.name);
  }
}

void write_tables(const Run& run, const std::filesystem::path& root) {
  std::vector<std::string> texts;
  for (const Document& document : documents) {
    texts.push_back(file_with_part(root / document.file, document.name, document.table(run)));
  }
  for (std::size_t i = 0; i < texts.size(); ++i) {
    write_file(root / documents[i].file, texts[i]);
  }
}

std::vector<std::string> table_differences(const Run& run, const std::filesystem::path& root) {
  std::vector<std::string> found;
  for (const Document& document : documents) {
    for (const std::string& difference : document.differences(part_of_file(root / document.file, document.name), run)) {
      found.push_back(fmt::format("{}: {}", document.file, difference));
    }
  }
  return found;
}

}  // namespace goishi::verify::markdown
