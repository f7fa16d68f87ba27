#include "verify/bench/clock.hpp"

#include <benchmark/benchmark.h>

#include <array>
#include <string>

#include "verify/suite/quantile.hpp"

namespace goishi::verify::bench {

namespace {

class Collector final : public benchmark::BenchmarkReporter {
 public:
  explicit Collector(std::size_t calls) : times(calls) {}

  bool ReportContext(const Context& /*unused*/) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type == Run::RT_Iteration) {
        times[std::stoul(run.run_name.function_name)].push_back(run.GetAdjustedCPUTime());
      }
    }
  }

  std::vector<std::vector<double>> times;
};

/// Its settings are those of a command line.
void take_turns_at_random() {
  static std::string name = "bench", turns = "--benchmark_enable_random_interleaving=true";
  static std::array<char*, 3> arguments = {name.data(), turns.data(), nullptr};
  int count = 2;
  benchmark::Initialize(&count, arguments.data());
}

}  // namespace

Timing summary(const std::vector<double>& times) {
  return {.median = quantile(times, 0.5),
          .lower = quantile(times, 0.25),
          .upper = quantile(times, 0.75),
          .late = quantile(times, 0.9)};
}

std::vector<std::vector<double>> time_by_turns(const std::vector<std::function<void()>>& calls, double batch,
                                               int repeats) {
  take_turns_at_random();
  benchmark::ClearRegisteredBenchmarks();
  for (std::size_t i = 0; i < calls.size(); ++i) {
    const auto run = [&call = calls[i]](benchmark::State& state) {
      for (auto _ : state) {
        call();
      }
    };
    benchmark::RegisterBenchmark(std::to_string(i).c_str(), run)->MinTime(batch)->Repetitions(repeats);
  }
  Collector collector(calls.size());
  if (!calls.empty()) {
    benchmark::RunSpecifiedBenchmarks(&collector, "all");
  }
  benchmark::ClearRegisteredBenchmarks();  // they refer to `calls`
  return collector.times;
}

}  // namespace goishi::verify::bench
