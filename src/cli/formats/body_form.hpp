#pragma once
/// \file
/// What the files of bodies have in common.

#include <string>

#include "formats/body_formats.hpp"

namespace goishi::cli {

/// The form with {comment}, {mesh}, {mass}, {axial}, {transverse} and {color}, "r g b 1", filled in.
[[nodiscard]] std::string filled(const char* form, const BodyFile& body);

}  // namespace goishi::cli
