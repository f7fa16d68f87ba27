#include "document.hpp"

#include <algorithm>
#include <utility>

namespace goishi::cli {

void Document::append_row(std::string name, std::string_view text) {
  rows_.push_back({std::move(name), text_.size(), text_.size() + text.size()});
  text_ += text;
}

std::string Document::row_at(std::size_t offset) const {
  const auto row =
      std::ranges::find_if(rows_, [offset](const Span& span) { return span.begin <= offset && offset < span.end; });
  return row == rows_.end() ? std::string() : row->name;
}

}  // namespace goishi::cli
