#include "verify/suite/run.hpp"

#include <fmt/format.h>
#include <fnmatch.h>
#include <pthread.h>
#include <sys/utsname.h>

#include <array>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <ctime>
#include <exception>
#include <fstream>
#include <memory>
#include <mutex>
#include <optional>
#include <sstream>
#include <thread>

#include "build_info.hpp"

namespace goishi::verify {

namespace {

/// The value of the first line "key : value" of a file such as /proc/cpuinfo or /etc/os-release; empty if there is
/// none.
std::string first_value(const char* path, std::string_view key, char separator) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(key)) {
      const std::size_t at = line.find(separator);
      if (at == std::string::npos) {
        continue;
      }
      std::string value = line.substr(at + 1);
      std::erase(value, '"');
      value.erase(0, value.find_first_not_of(' '));
      return value;
    }
  }
  return {};
}

/// In UTC.
std::string time_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

/// For each check the greatest k at which 10^-k, added relatively to every production value, makes it fail; 0 if none does.
std::vector<int> smallest_errors_seen(const Claim& claim, const Stamp& stamp) {
  constexpr int finest = 17;
  std::array<std::optional<Verdict>, finest> verdicts;  // at 10^-k, where it was asked
  const auto fails = [&](std::size_t check, int k) {
    std::optional<Verdict>& verdict = verdicts[static_cast<std::size_t>(k)];
    if (!verdict) {
      Context context(Tier::quick, stamp.seed, claim.id, std::pow(10.0, -k));
      verdict = judge(claim, claim.measure(context));
    }
    return !verdict->judgements[check].holds;
  };
  std::vector<int> seen;
  for (std::size_t check = 0; check < claim.checks.size(); ++check) {
    // 10^-low is seen (or nothing is), 10^-high is not.
    int low = 0, high = finest;
    while (high - low > 1) {
      const int middle = (low + high) / 2;
      (fails(check, middle) ? low : high) = middle;
    }
    seen.push_back(low);
  }
  return seen;
}

/// A check that no error of the values could make fail guards nothing, unless it counts.
void require_sensitivity(const Claim& claim, const Stamp& stamp, Verdict& verdict) {
  verdict.seen = smallest_errors_seen(claim, stamp);
  for (std::size_t i = 0; i < claim.checks.size(); ++i) {
    if (verdict.seen[i] == 0 && !claim.checks[i].counts && verdict.holds) {
      verdict.holds = false;
      verdict.judgements[i] = {.why = "no error of the values makes it fail, and it does not say that it counts"};
      verdict.why = (claim.checks[i].name.empty() ? "" : claim.checks[i].name + ": ") + verdict.judgements[i].why;
    }
  }
}

Result measure(const Claim& claim, const Stamp& stamp) {
  Result result;
  result.claim = &claim;
  const auto start = std::chrono::steady_clock::now();
  try {
    Context context(stamp.tier, stamp.seed, claim.id);
    result.measurement = claim.measure(context);
    result.verdict = judge(claim, result.measurement);
    if (stamp.tier == Tier::full && result.verdict.holds) {
      require_sensitivity(claim, stamp, result.verdict);
    }
  } catch (const std::exception& error) {
    result.verdict = judge(claim, {});
    result.verdict.why = fmt::format("the measurement stopped: {}", error.what());
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace

Stamp make_stamp(std::uint64_t seed, Tier tier) {
  utsname name{};
  uname(&name);
  const std::string processor = first_value("/proc/cpuinfo", "model name", ':');
  const std::string system = first_value("/etc/os-release", "PRETTY_NAME", '=');
  return {.machine = fmt::format("{}, {} threads, {}", processor.empty() ? "unknown processor" : processor,
                                 std::thread::hardware_concurrency(), name.machine),
          .system = fmt::format("{}, {} {}", system.empty() ? "unknown system" : system, name.sysname, name.release),
          .compiler = fmt::format("{}, {}, {}", build_info::compiler, build_info::build_type, build_info::flags),
          .commit = std::string(build_info::commit),
          .time = time_now(),
          .seed = seed,
          .tier = tier};
}

std::size_t Run::failures() const {
  std::size_t count = 0;
  for (const Result& result : results) {
    count += result.verdict.holds ? 0 : 1;
  }
  return count;
}

namespace {

/// What a thread has used since: its processor's time, so that a claim that is held up from outside does not count as one that
/// hangs; and the time of day, for one that waits.
class Stopwatch {
 public:
  /// Of the thread that calls.
  Stopwatch() {
    pthread_getcpuclockid(pthread_self(), &clock_);
    used_ = used();
  }
  /// While that thread lives.
  [[nodiscard]] bool is_beyond(double limit) const {
    constexpr double patience = 20;
    const double day = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
    return limit < used() - used_ || patience * limit < day;
  }

 private:
  [[nodiscard]] double used() const {
    timespec time{};
    clock_gettime(clock_, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  clockid_t clock_{};
  double used_ = 0;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

/// What the threads of a run share. It outlives the run where a thread hangs.
struct Desk {
  explicit Desk(const std::vector<Claim>& the_claims)
      : claims(the_claims), results(the_claims.size()), begun(the_claims.size()), over(the_claims.size(), false) {}

  std::vector<Claim> claims;
  std::vector<Result> results;
  std::vector<std::optional<Stopwatch>> begun;  // of the claims under way
  std::vector<bool> over;
  std::size_t next = 0, finished = 0;
  std::mutex mutex;
  std::condition_variable changed;
};

void work(const std::shared_ptr<Desk>& desk, const Stamp& stamp) {
  std::unique_lock lock(desk->mutex);
  while (desk->next < desk->claims.size()) {
    const std::size_t i = desk->next++;
    desk->begun[i].emplace();
    lock.unlock();
    Result result = measure(desk->claims[i], stamp);
    lock.lock();
    if (desk->over[i]) {
      return;  // too late: another has taken this one's place
    }
    desk->begun[i].reset();
    desk->over[i] = true;
    desk->results[i] = std::move(result);
    ++desk->finished;
    desk->changed.notify_all();
  }
}

}  // namespace

Run run_claims(const std::vector<Claim>& claims, const Stamp& stamp, unsigned threads,
               const std::function<void(const Result&, std::size_t)>& done, double limit) {
  const auto start = std::chrono::steady_clock::now();
  Run run;
  run.stamp = stamp;
  const auto desk = std::make_shared<Desk>(claims);
  const auto hire = [&] { std::thread([desk, stamp] { work(desk, stamp); }).detach(); };
  for (unsigned i = 0; i < threads; ++i) {
    hire();
  }
  std::unique_lock lock(desk->mutex);
  std::vector<bool> shown(claims.size(), false);
  std::size_t count = 0;
  while (count < claims.size()) {
    desk->changed.wait_for(lock, std::chrono::milliseconds(200));
    for (std::size_t i = 0; i < claims.size(); ++i) {
      if (desk->begun[i] && desk->begun[i]->is_beyond(limit)) {
        desk->begun[i].reset();
        desk->over[i] = run.hangs = true;
        desk->results[i].claim = &desk->claims[i];
        desk->results[i].verdict = judge(desk->claims[i], {});
        desk->results[i].verdict.why = fmt::format("it takes longer than {} s", limit);
        desk->results[i].seconds = limit;
        hire();
      }
      if (desk->over[i] && !shown[i]) {
        shown[i] = true;
        done(desk->results[i], ++count);
      }
    }
  }
  run.results = desk->results;
  for (std::size_t i = 0; i < claims.size(); ++i) {
    run.results[i].claim = &claims[i];
  }
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return run;
}

Run run_claims(const std::vector<Claim>& claims, const Stamp& stamp, unsigned threads,
               const std::function<void(const Result&, std::size_t)>& done) {
  return run_claims(claims, stamp, threads, done, longest(stamp.tier));
}

bool matches(std::string_view id, std::string_view patterns) {
  std::istringstream list{std::string(patterns)};
  for (std::string pattern; std::getline(list, pattern, ',');) {
    if (fnmatch(pattern.c_str(), std::string(id).c_str(), 0) == 0) {
      return true;
    }
  }
  return false;
}

}  // namespace goishi::verify
