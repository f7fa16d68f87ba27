#pragma once
/// \file
/// The hashes in the report: each beside the errors of what it hashes.

#include "verify/report/report.hpp"

namespace goishi::verify::bits {

/// Of a run's claims; one that was not measured stands there by its id alone.
[[nodiscard]] Section page_section(const Run& run);

}  // namespace goishi::verify::bits
