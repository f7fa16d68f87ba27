#include "version.hpp"

#include <fmt/format.h>

#include <build_info.hpp>

namespace goishi::cli {

std::string version() {
  return fmt::format("goishi {} ({})", build_info::version, build_info::commit);
}

}  // namespace goishi::cli
