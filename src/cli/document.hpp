#pragma once
/// \file
/// A printed table.

#include <string>
#include <string_view>
#include <vector>

namespace goishi::cli {

/// Text that still knows where its rows are.
class Document {
 public:
  void append(std::string_view text) { text_ += text; }
  void append_row(std::string name, std::string_view text);

  /// The name of the row that holds the character at `offset`; empty outside of the rows.
  [[nodiscard]] std::string row_at(std::size_t offset) const;

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  struct Span {
    std::string name;
    std::size_t begin;
    std::size_t end;
  };

  std::string text_;
  std::vector<Span> rows_;
};

}  // namespace goishi::cli
