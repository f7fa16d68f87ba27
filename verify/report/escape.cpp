#include "verify/report/escape.hpp"

#include <cstdint>

namespace goishi::verify {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";

struct Character {
  std::uint32_t code = 0;
  std::string_view bytes;
  bool valid = false;
};

/// The next character of a text that is not empty. A wrong byte is a character of its own.
Character next_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const Character wrong{0, text.substr(0, 1), false};
  const unsigned lead = byte(0);
  if (lead < 0x80) {
    return {lead, text.substr(0, 1), true};
  }
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) {
    return wrong;
  }
  std::uint32_t code = lead & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) {
      return wrong;
    }
    code = code << 6U | (byte(i) & 0x3FU);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (overlong || surrogate || code > 0x10FFFF) {
    return wrong;
  }
  return {code, text.substr(0, length), true};
}

template <class Each>
void for_each_character(std::string_view text, Each&& each) {
  while (!text.empty()) {
    const Character character = next_character(text);
    each(character);
    text.remove_prefix(character.bytes.size());
  }
}

bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0);
}

std::size_t columns_of(std::uint32_t code) {
  const auto within = [code](std::uint32_t first, std::uint32_t last) { return code >= first && code <= last; };
  if (is_control(code) || within(0x300, 0x36F) || within(0x200B, 0x200F)) {
    return 0;
  }
  const bool wide = within(0x1100, 0x115F) || within(0x2E80, 0xA4CF) || within(0xAC00, 0xD7A3) ||
                    within(0xF900, 0xFAFF) || within(0xFE30, 0xFE6F) || within(0xFF00, 0xFF60) ||
                    within(0x1F300, 0x1FAFF) || within(0x20000, 0x3FFFD);
  return wide ? 2 : 1;
}

}  // namespace

std::string valid_utf8(std::string_view text) {
  std::string result;
  for_each_character(text,
                     [&](const Character& character) { result += character.valid ? character.bytes : replacement; });
  return result;
}

std::string printable(std::string_view text) {
  std::string result;
  for_each_character(text, [&](const Character& character) {
    if (!character.valid) {
      result += replacement;
    } else if (is_control(character.code)) {
      result += ' ';
    } else {
      result += character.bytes;
    }
  });
  return result;
}

std::string xml(std::string_view text) {
  std::string result;
  for_each_character(text, [&](const Character& character) {
    const bool forbidden = character.code == 0xFFFE || character.code == 0xFFFF;
    if (!character.valid || forbidden) {
      result += replacement;
      return;
    }
    switch (character.code) {
      case '&':
        result += "&amp;";
        return;
      case '<':
        result += "&lt;";
        return;
      case '>':
        result += "&gt;";
        return;
      case '"':
        result += "&quot;";
        return;
      case '\'':
        result += "&#39;";
        return;
      default:
        break;
    }
    if (!is_control(character.code) || character.code == '\n' || character.code == '\t') {
      result += character.bytes;
    }
  });
  return result;
}

std::string anchor(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
    result += plain ? c : '-';
  }
  return result.empty() ? "-" : result;
}

std::size_t columns(std::string_view text) {
  std::size_t count = 0;
  for_each_character(text, [&](const Character& c) { count += c.valid ? columns_of(c.code) : std::size_t{1}; });
  return count;
}

std::string padded(std::string_view text, std::size_t width) {
  const std::size_t wide = columns(text);
  return std::string(text) + std::string(width > wide ? width - wide : 0, ' ');
}

std::string right_aligned(std::string_view text, std::size_t width) {
  const std::size_t wide = columns(text);
  return std::string(width > wide ? width - wide : 0, ' ') + std::string(text);
}

std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
  std::vector<std::string> lines(1);
  while (!text.empty()) {
    const std::size_t space = text.find(' ');
    const std::string_view word = text.substr(0, space);
    text.remove_prefix(space == std::string_view::npos ? text.size() : space + 1);
    if (word.empty()) {
      continue;
    }
    if (!lines.back().empty()) {
      if (columns(lines.back()) + 1 + columns(word) > width) {
        lines.emplace_back();
      } else {
        lines.back() += ' ';
      }
    }
    lines.back() += word;
  }
  return lines;
}

std::string shortened(std::string_view text, std::size_t width) {
  if (columns(text) <= width) {
    return std::string(text);
  }
  std::string result;
  std::size_t used = 1;  // the ellipsis
  bool full = false;
  for_each_character(text, [&](const Character& character) {
    const std::size_t more = character.valid ? columns_of(character.code) : 1;
    full = full || used + more > width;
    if (!full) {
      used += more;
      result += character.bytes;
    }
  });
  return result + "…";
}

}  // namespace goishi::verify
