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

struct Group {
  int begin, count;
  double scale;  // 0: to the last bit
};

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

  void gives(int status, const List& result, const std::vector<List>& stones, const std::vector<Group>& groups) {
    if (status != GOISHI_OK) {
      std::fprintf(stderr, "case %d: %s\n", count, goishi_message());
      std::exit(1);
    }
    std::printf("],\"result\":");
    print(result);
    std::printf(",\"stones\":[");
    for (std::size_t i = 0; i < stones.size(); ++i) {
      List measures(GOISHI_MEASURES_SIZE);
      static_cast<void>(goishi_measures(stones[i].data(), stones[i].size(), measures.data(), measures.size()));
      std::printf(i == 0 ? "{\"stone\":" : ",{\"stone\":");
      print(stones[i]);
      std::printf(",\"measures\":");
      print(measures);
      std::printf("}");
    }
    std::printf("],\"groups\":[");
    int next = 0;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      std::printf(i == 0 ? "[%d,%d," : ",[%d,%d,", groups[i].begin, groups[i].count);
      if (groups[i].scale == 0.0) {
        std::printf("null]");
      } else {
        std::printf("%.17g]", groups[i].scale);
      }
      if (groups[i].begin != next) {
        std::fprintf(stderr, "case %d: the groups leave numbers out\n", count);
        std::exit(1);
      }
      next = groups[i].begin + groups[i].count;
    }
    if (next != static_cast<int>(result.size())) {
      std::fprintf(stderr, "case %d: the groups are not of all numbers\n", count);
      std::exit(1);
    }
    std::printf("]}");
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
