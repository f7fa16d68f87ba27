#pragma once
/// \file
/// Results of the library as one number for each kind of work: the same for every compiler, level of optimisation, processor and
/// width of SIMD registers. Compiles wherever the library does, with nothing but it.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace goishi::verify::bits {

/// FNV-1a over the bits of the numbers that a kind of work gives, in order. No number is one number, whatever its bits.
class Hash {
 public:
  void add(double x);
  void add(float x);
  void add(int x) { mix(static_cast<std::uint64_t>(x)); }
  void add(bool x) { mix(x ? 1 : 0); }

  [[nodiscard]] std::uint64_t value() const { return value_; }
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  void mix(std::uint64_t bits);

  std::uint64_t value_ = 14695981039346656037U;
  std::size_t count_ = 0;
};

/// A kind of work: which claims say how far off its numbers are, and the hash of them.
struct Kind {
  std::string name;
  std::vector<std::string> claims;
  void (*run)(Hash&);
};

[[nodiscard]] const std::vector<Kind>& kinds();

/// 16 hexadecimal digits.
[[nodiscard]] std::string digits(const Hash& hash);

/// "name hash count", a line for each kind: what `hashes.txt` has.
[[nodiscard]] std::string line(const Kind& kind);

// Each in a file of its own.
void hash_elementary(Hash& hash);
void hash_mass(Hash& hash);
void hash_mesh(Hash& hash);
void hash_flight(Hash& hash);
void hash_batch(Hash& hash);
void hash_contact(Hash& hash);
void hash_time_of_impact(Hash& hash);
void hash_impact(Hash& hash);
void hash_drop(Hash& hash);

}  // namespace goishi::verify::bits
