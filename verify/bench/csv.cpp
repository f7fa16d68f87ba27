#include <fmt/format.h>

#include <algorithm>

#include "verify/bench/report.hpp"

namespace goishi::verify::bench {

std::string csv_report(const Bench& bench) {
  std::vector<std::string> names;
  for (const Race& race : bench.races) {
    for (const Quantity& quantity : race.quantities) {
      if (std::find(names.begin(), names.end(), quantity.name) == names.end()) {
        names.push_back(quantity.name);
      }
    }
  }
  std::string head = "problem,contestant,family,kind,setting,cost,ns,ns_q1,ns_q3,ns_p90";
  for (const std::string& name : names) {
    head += "," + name;
  }
  std::replace(head.begin(), head.end(), ' ', '_');
  std::string out = head + "\n";
  for (const Race& race : bench.races) {
    for (const Curve& curve : race.curves) {
      const auto& [name, label, family, kind, settings] = curve.who;
      for (const Point& point : curve.points) {
        const auto& [median, lower, upper, late] = point.cost;
        out += fmt::format("{},{},{},{},{},{},{:.5g},{:.5g},{:.5g},{:.5g}", race.name, name, family, to_string(kind),
                           kind == Kind::direct ? "" : fmt::format("{}", point.setting), race.cost, median, lower,
                           upper, late);
        for (const std::string& quantity : names) {
          const std::optional<double> value = value_of(race, point, quantity);
          out += value ? fmt::format(",{:.5g}", *value) : ",";
        }
        out += "\n";
      }
    }
  }
  return out;
}

}  // namespace goishi::verify::bench
