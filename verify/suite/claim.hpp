#pragma once
/// \file
/// What a claim is: a sentence about a production function, an oracle, a measured error, and a bound with its reason.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace goishi::verify {

/// Best first. `relation`: the function and itself, in another world, other units, backwards in time. `rounding`: the witness is
/// the same formula in more digits, so that range and round-off are judged, and not whether the formula is right.
enum class OracleFamily {
  proof,
  exact,
  invariant,
  relation,
  quadrature,
  integration,
  other_formula,
  brute_force,
  published,
  rounding,
  regression
};
[[nodiscard]] std::string_view to_string(OracleFamily family);

/// quick: seconds, on every build. full: more samples, and the claims that are dear.
enum class Tier { quick, full };
[[nodiscard]] std::string_view to_string(Tier tier);

/// How a curve of a plot looks: in a colour of its own; thin, grey and dashed, for what is not ours; its points as stars.
enum class Look { usual, foreign, star };

/// A curve of a plot that a measurement leaves for the report.
struct Series {
  std::string name;
  std::vector<std::pair<double, double>> points;  // (x, y)
  bool line = true;                               // else markers only
  Look look = Look::usual;
  bool segments = false;  // each two points are a stroke of their own
};

struct Plot {
  std::string title;
  std::string x_label;  // with unit
  std::string y_label;
  bool log_x = false;
  bool log_y = false;
  bool equal_scale = false;  // same scale on both axes, for shapes
  std::vector<Series> series;
  bool labelled = false;  // a larger picture, the names beside the ends of the curves in place of a legend
};

/// A further figure that people want to read beside the error: "volume V' = 2.5333626 cm³, right is 1.8505405 cm³".
struct Figure {
  std::string name;
  std::string value;
};

/// What a check found.
struct Measured {
  std::string check = {};                                   // its name
  double error = std::numeric_limits<double>::quiet_NaN();  // the worst, in the check's unit
  std::uint64_t cases = 0;                                  // how many values were compared
  std::string worst_case = {};                              // the arguments of the worst, so that it can be repeated
};

struct Measurement {
  std::vector<Measured> checks;  // those of the claim, in any order
  std::vector<Figure> figures = {};
  std::vector<Plot> plots = {};
};

/// A run's settings, and the claim's own random numbers: the same for a seed and an id, whatever else runs.
class Context {
 public:
  Context(Tier tier, std::uint64_t seed, std::string_view claim_id, double perturbation = 0.0);

  [[nodiscard]] Tier tier() const { return tier_; }
  /// A number of samples: `quick` in the quick tier, `full` in the full one.
  [[nodiscard]] int samples(int quick, int full) const { return tier_ == Tier::quick ? quick : full; }
  [[nodiscard]] std::mt19937_64& random() { return random_; }
  [[nodiscard]] double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  /// Every production value passes through here on its way to the comparison. The suite perturbs it by a relative
  /// amount to find the smallest error that the claim still sees.
  template <class T>
  [[nodiscard]] T produced(const T& value) const {
    return perturbation_ == 0.0 ? value : T(value * (1.0 + perturbation_));
  }

 private:
  Tier tier_;
  std::mt19937_64 random_;
  double perturbation_;
};

/// One comparison of a claim, and by what it is judged.
struct Check {
  std::string name = {};  // "place of rest"; empty where the claim has no other
  std::string unit;       // of error and bound: "ulp", "relative", "count", …
  double bound;
  std::string reason;       // where the bound comes from: derived, or "measured" with the date
  double resolution = 0.0;  // one ulp of the quantity, in the unit; a smaller error counts as this much
  bool counts = false;      // faults, choices, proofs, or a width: it compares no values
};

struct Claim {
  std::string id;         // "MASS-1"
  std::string statement;  // a sentence that a user can read
  std::string function;   // the production function that it is about
  OracleFamily family;
  std::string oracle;  // the witness, in a phrase
  std::vector<Check> checks;
  std::function<Measurement(Context&)> measure;
  std::string source = {};  // its file below verify/, as "claims/mass/gsl.cpp", set by `all_claims`

  /// The folder of its file: "mass".
  [[nodiscard]] std::string subject() const;
};

/// A bound that is this many times what is measured guards nothing: the check fails.
inline constexpr double greatest_slack = 100.0;

/// Of one check.
struct Judgement {
  bool holds = false;
  double slack = 0.0;    // bound / max(error, resolution); 1 for an exact check that holds
  double part = 0.0;     // error / bound; 0 for an exact check that holds
  std::string why = {};  // why it does not hold; empty if it does
};

/// NaN fails, an error above the bound fails, a slack over `greatest_slack` fails, no case compared fails.
[[nodiscard]] Judgement judge(const Check& check, const Measured& measured);

/// Of a claim, which holds if each of its checks was measured and holds, and nothing else was measured.
struct Verdict {
  bool holds = false;
  std::string why = {};                    // of the first check that does not hold; empty if all do
  std::vector<Measured> measured = {};     // by the checks of the claim, in their order
  std::vector<Judgement> judgements = {};  // likewise
  std::vector<int> seen = {};              // likewise, in the full tier: 1e-k is the least relative error seen; 0: none

  /// The check that does not hold, or else the one whose error comes nearest to its bound.
  [[nodiscard]] std::size_t weakest() const;
};

[[nodiscard]] Verdict judge(const Claim& claim, const Measurement& measurement);

/// A check with all that is known of it.
struct Checked {
  const Check& check;
  const Measured& measured;
  const Judgement& judgement;
  int seen;  // 1e-seen is the least relative error of the values that it still sees; 0: none, or not asked
};

struct Result {
  const Claim* claim = nullptr;
  Measurement measurement;
  Verdict verdict;
  double seconds = 0.0;

  [[nodiscard]] Checked checked(std::size_t i) const {
    return {claim->checks[i], verdict.measured[i], verdict.judgements[i], verdict.seen.empty() ? 0 : verdict.seen[i]};
  }
  [[nodiscard]] Checked weakest() const { return checked(verdict.weakest()); }
};

/// An error in units of what is allowed. An allowance that is not positive and finite guards nothing: NaN.
[[nodiscard]] constexpr double part_of(double error, double allowed) {
  return 0.0 < allowed && allowed <= std::numeric_limits<double>::max() ? error / allowed
                                                                        : std::numeric_limits<double>::quiet_NaN();
}

/// Keeps the worst of many comparisons. A NaN is worse than everything.
class Worst {
 public:
  /// In units of `allowed`, where that depends on the case.
  template <class Describe>
  void see(double error, double allowed, Describe&& describe) {
    see(part_of(error, allowed), std::forward<Describe>(describe));
  }
  /// `describe` is called only when this error is the worst so far.
  template <class Describe>
  void see(double error, Describe&& describe) {
    ++cases_;
    if (!(error <= error_)) {
      if (!(error_ != error_)) {
        error_ = error;
        worst_case_ = describe();
      }
    }
  }
  [[nodiscard]] double error() const { return error_; }
  [[nodiscard]] std::uint64_t cases() const { return cases_; }
  [[nodiscard]] Measured measured(std::string check = {}) const {
    return {.check = std::move(check),
            .error = cases_ == 0 ? std::numeric_limits<double>::quiet_NaN() : error_,
            .cases = cases_,
            .worst_case = worst_case_};
  }
  /// Of a claim with one check.
  [[nodiscard]] Measurement measurement(std::vector<Figure> figures = {}) const {
    return {.checks = {measured()}, .figures = std::move(figures)};
  }

 private:
  double error_ = -1.0;
  std::uint64_t cases_ = 0;
  std::string worst_case_;
};

/// The comparisons of a claim with several checks, each by its name.
class Checks {
 public:
  /// Made at its first use.
  Worst& operator[](std::string_view name) {
    for (auto& [known, worst] : checks_) {
      if (known == name) {
        return worst;
      }
    }
    return checks_.emplace_back(name, Worst()).second;
  }
  [[nodiscard]] Measurement measurement(std::vector<Figure> figures = {}) const {
    Measurement result{.checks = {}, .figures = std::move(figures)};
    for (const auto& [name, worst] : checks_) {
      result.checks.push_back(worst.measured(name));
    }
    return result;
  }

 private:
  std::deque<std::pair<std::string, Worst>> checks_;  // which keeps references
};

}  // namespace goishi::verify
