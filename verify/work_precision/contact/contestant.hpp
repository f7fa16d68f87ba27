#pragma once
/// \file
/// Who is asked: one interface for what the library ships and for the rivals.

#include <cstddef>
#include <functional>
#include <goishi/contact/separating_axis.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "verify/work_precision/contact/scene.hpp"
#include "verify/work_precision/timing.hpp"

namespace goishi::verify::bench::contact {

/// One contestant, with one setting, on one scene.
class Asker {
 public:
  Asker() = default;
  Asker(const Asker&) = delete;
  Asker& operator=(const Asker&) = delete;
  virtual ~Asker() = default;

  /// Asks about so many poses, one after the other from `first` on, round and round. This alone is timed.
  virtual void ask(std::size_t first, std::size_t calls) = 0;
  /// Of each pose, when it was asked about last: gap [m], or time of impact [s]; not finite where there is no answer.
  [[nodiscard]] virtual const std::vector<double>& answers() const = 0;
};

namespace detail {

[[nodiscard]] inline double number_of(double answer) {
  return answer;
}
template <class T>
[[nodiscard]] double number_of(const Separation<T>& answer) {
  return answer.status == SeparationStatus::not_converged ? scalar::unset<double>() : static_cast<double>(answer.gap);
}
template <class T>
[[nodiscard]] double number_of(const TimeOfImpact<T>& answer) {
  return answer.status == ImpactStatus::hit ? static_cast<double>(answer.time) : scalar::unset<double>();
}

template <class T>
[[nodiscard]] double number_of(const PublishedSeparation<T>& answer) {
  return -static_cast<double>(answer.depth);
}

template <class Ask>
class AskerOf final : public Asker {
 public:
  AskerOf(std::size_t poses, Ask query) : query_(std::move(query)), answers_(poses, scalar::unset<double>()) {}

  void ask(std::size_t first, std::size_t calls) override {
    const std::size_t mask = answers_.size() - 1;
    for (std::size_t i = first; i < first + calls; ++i) {
      const auto answer = query_(i & mask);
      keep(answer);
      answers_[i & mask] = number_of(answer);
    }
  }
  [[nodiscard]] const std::vector<double>& answers() const override { return answers_; }

 private:
  Ask query_;
  std::vector<double> answers_;
};

}  // namespace detail

/// `query(i)` answers for pose i of so many, a power of two.
template <class Ask>
[[nodiscard]] std::unique_ptr<Asker> make_asker(std::size_t poses, Ask query) {
  return std::make_unique<detail::AskerOf<Ask>>(poses, std::move(query));
}

enum class Kind {
  direct,    // no setting
  vertices,  // setting: of the hull in place of the stone
  tolerance  // setting: where the search ends
};

struct Contestant {
  std::string name;   // "fcl-hull", for the CSV file
  std::string label;  // for people
  bool ours;
  Kind kind;
  std::vector<double> settings;  // from coarse to fine
  std::function<std::unique_ptr<Asker>(const Scene&, double setting)> enter;
  bool only_at_board = false;

  [[nodiscard]] bool can_enter(const Problem& problem) const {
    return !only_at_board || problem.query == Query::edge || problem.query == Query::corner;
  }
};

[[nodiscard]] std::vector<Contestant> our_contestants();
/// None where libccd and FCL were not found.
[[nodiscard]] std::vector<Contestant> rival_contestants();
[[nodiscard]] const std::vector<Contestant>& contestants();

}  // namespace goishi::verify::bench::contact
