#include "verify/bits/kinds.hpp"

#include <cstdio>
#include <cstring>

namespace goishi::verify::bits {

void Hash::mix(std::uint64_t bits) {
  constexpr std::uint64_t prime = 1099511628211U;
  for (int i = 0; i < 8; ++i) {
    value_ = (value_ ^ (bits >> (8 * i) & 0xff)) * prime;
  }
  ++count_;
}

void Hash::add(double x) {
  std::uint64_t bits = 0x7ff8000000000000U;
  if (!(x != x)) {
    std::memcpy(&bits, &x, sizeof bits);
  }
  mix(bits);
}

void Hash::add(float x) {
  add(static_cast<double>(x));
}

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = {
      {"elementary", {"SINE-1", "SINE-2", "ATAN-1"}, hash_elementary},
      {"mass", {"MASS-1", "MASS-2", "SHAPE-1", "GSL-4"}, hash_mass},
      {"mesh", {"MESH-1", "MESH-4"}, hash_mesh},
      {"flight", {"FLIGHT-1", "ELLIPTIC-3", "ORDER-4"}, hash_flight},
      {"batch", {"BATCH-1"}, hash_batch},
      {"contact", {"CONTACT-1", "CONTACT-2", "CONTACT-4", "SURFACE-2"}, hash_contact},
      {"time of impact", {"TOI-2", "TOI-4", "TOI-5"}, hash_time_of_impact},
      {"impact", {"IMPACT-1", "IMPACT-7"}, hash_impact},
      {"drop", {"DROP-19", "DROP-33"}, hash_drop},
  };
  return all;
}

std::string digits(const Hash& hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash.value()));
  return text;
}

std::string line(const Kind& kind) {
  Hash hash;
  kind.run(hash);
  return kind.name + ": " + digits(hash) + " " + std::to_string(hash.count()) + "\n";
}

}  // namespace goishi::verify::bits
