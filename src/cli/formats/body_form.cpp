#include "formats/body_form.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace goishi::cli {

bool is_plain_name(std::string_view name) {
  const auto is_plain = [](char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') ||
           std::string_view("._-+").find(c) != std::string_view::npos;
  };
  return !name.empty() && std::ranges::all_of(name, is_plain);
}

std::string filled(const char* form, const BodyFile& body) {
  const MassProperties<Number>& properties = body.properties;
  return fmt::format(fmt::runtime(form), fmt::arg("comment", body.comment), fmt::arg("mesh", body.mesh),
                     fmt::arg("mass", seventeen_digits(properties.mass)),
                     fmt::arg("axial", seventeen_digits(properties.moments.axial)),
                     fmt::arg("transverse", seventeen_digits(properties.moments.transverse)),
                     fmt::arg("color", fmt::format("{} 1", fmt::join(body.color, " "))));
}

}  // namespace goishi::cli
