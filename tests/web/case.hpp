#pragma once
/// \file
/// Cases of table.cpp, printed as JSON.

#include <bit>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "goishi.h"

using List = std::vector<double>;

inline void print(double value) {
  std::printf("\"%016" PRIx64 "\"", std::bit_cast<std::uint64_t>(value));
}

inline void print(const List& list) {
  std::printf("[");
  for (std::size_t i = 0; i < list.size(); ++i) {
    std::printf(i == 0 ? "" : ",");
    print(list[i]);
  }
  std::printf("]");
}

/// One case, printed argument by argument.
class Case {
 public:
  explicit Case(const char* function) {
    std::printf("%s{\"function\":\"%s\",\"arguments\":[", count++ == 0 ? "[\n" : ",\n", function);
  }

  Case& in(const List& list) {
    begin("in");
    print(list);
    return end();
  }
  Case& out(std::size_t size) {
    begin("out");
    std::printf("%zu", size);
    return end();
  }
  Case& ints(const std::vector<int>& list) {
    begin("ints");
    std::printf("[");
    for (std::size_t i = 0; i < list.size(); ++i) {
      std::printf(i == 0 ? "%d" : ",%d", list[i]);
    }
    std::printf("]");
    return end();
  }
  Case& whole(int value) {
    begin("whole");
    std::printf("%d", value);
    return end();
  }
  Case& number(double value) {
    begin("number");
    print(value);
    return end();
  }
  /// A pointer to one integer that the function sets.
  Case& one() {
    begin("one");
    std::printf("0");
    return end();
  }

  void gives(int status, const List& result) {
    if (status != GOISHI_OK) {
      std::fprintf(stderr, "case %d: %s\n", count, goishi_message());
      std::exit(1);
    }
    std::printf("],\"result\":");
    print(result);
    std::printf("}");
  }

  static int count;

 private:
  void begin(const char* kind) {
    std::printf(first_ ? "{\"%s\":" : ",{\"%s\":", kind);
    first_ = false;
  }
  Case& end() {
    std::printf("}");
    return *this;
  }

  bool first_ = true;
};

inline int Case::count = 0;
