#pragma once
/// \file
/// Run time against error of drops as they were at an earlier commit, beside drops as they are: what `measure` has written
/// into drops.csv. It is kept, since the old scheme is no code of this tree any more.

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace goishi::verify::bench::history {

struct Point {
  double tolerance;
  double time, late;         // [ns] of a drop: median and ninetieth percentile
  double error, late_error;  // [m] of the place of rest, likewise
};

struct Curve {
  std::string problem;        // "thrown", "set-down"
  std::string commit;         // as the facts have it
  std::vector<Point> points;  // from coarse to fine
};

struct History {
  std::map<std::string, std::string> facts;  // old, old-date, new, new-date, measured, machine, compiler, drops, rounds
  std::vector<Curve> curves;                 // of each problem the old one, then the new one
};

/// Of a file as `measure` writes it: facts as "# name: value", a line with the columns' names, a line a point. Throws
/// std::runtime_error, which names the line, for anything else: a fact or a curve that is not there, tolerances that do
/// not fall, curves that do not have the same ones, numbers that are not positive.
[[nodiscard]] History read(std::string_view file);

/// drops.csv as it was when this was compiled.
[[nodiscard]] std::string_view recorded();

}  // namespace goishi::verify::bench::history
