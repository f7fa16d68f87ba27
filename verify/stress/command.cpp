#include "verify/stress/command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace goishi::verify::stress {

namespace {

std::string replay(std::uint64_t seed, std::uint64_t index) {
  return fmt::format("goishi-verify stress --seed {} --case {}", seed, index);
}

void show_progress(std::uint64_t finished, const Order& order) {
  if (finished % 100 == 0 && isatty(STDERR_FILENO) != 0) {
    fmt::print(stderr, "\r\033[K{} of {} drops …", finished, order.samples);
    std::fflush(stderr);
  }
}

void print_tally(const Tally& tally, std::uint64_t seed) {
  for (const Failure& failure : tally.failures) {
    fmt::print("FAILS  {}\n       replay: {}\n", failure.fault, replay(seed, failure.index));
  }
  fmt::print("{} drops, {} failed; seed {}, {:.1f} s\n", tally.samples, tally.failures.size(), seed, tally.seconds);
  for (std::size_t i = 0; i < tally.by_status.size(); ++i) {
    if (0 < tally.by_status[i]) {
      fmt::print("  {:>8}  {}\n", tally.by_status[i], to_string(static_cast<DropStatus>(i)));
    }
  }
  fmt::print("  {:>8}  used the scheme of lower order (edges, sides, two contacts)\n", tally.lower_order);
  fmt::print("  deepest {:.2g} widths; greatest rise of energy {:.2g} of what the tolerance allows\n", tally.depth,
             tally.energy_rise);
  fmt::print("  slowest {:.2f} s: {}\n", tally.slowest, replay(seed, tally.slowest_index));
}

bool run_single(std::uint64_t seed, std::uint64_t index) {
  const Scene scene = draw_scene(seed, index);
  fmt::print("{}\n", describe(scene));
  const Drop<double> drop = run(scene);
  for (const Event<double>& event : drop.events) {
    const State<double>& now = event.after;
    fmt::print("{:16.12f} s  {:13} {:+.9e} J  p ({:+.6f}, {:+.6f}, {:+.6f}) m  |v| {:.3e} m/s  |L| {:.3e} kg m²/s\n",
               event.time, to_string(event.kind), event.energy, now.p_WB.x(), now.p_WB.y(), now.p_WB.z(),
               now.v_WB.norm(), now.L_W.norm());
  }
  const DropCounters& done = drop.counters;
  fmt::print(
      "{} after {} s: {} impacts, {} root steps, {} contact evaluations, {} steps ({} rejected, {} located), {} edge "
      "impacts\n",
      to_string(drop.status), drop.time, done.impacts, done.root_steps, done.contact_evaluations, done.steps_accepted,
      done.steps_rejected, done.steps_located, done.edge_impacts);
  const Verdict verdict = judge(scene, drop);
  for (const std::string& fault : verdict.faults) {
    fmt::print("FAILS  {}\n", fault);
  }
  return verdict.faults.empty();
}

}  // namespace

CLI::App* define_stress(CLI::App& app, Options& options) {
  CLI::App* stress = app.add_subcommand(
      "stress",
      "Drops random stones: any shape, pose, spin to 1000 rad/s, law and material, over edges and corners; judges that "
      "nothing is NaN, nothing tunnels, energy never rises, and every drop ends at rest or says why not.");
  stress->option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  stress->add_option("--seed", options.order.seed, "seed of all drops")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str()
      ->type_name("N");
  stress->add_option("--samples", options.order.samples, "how many drops")
      ->check(CLI::PositiveNumber)
      ->capture_default_str()
      ->type_name("N");
  stress->add_option("--seconds", options.order.seconds, "stop after so long (0: never)")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str()
      ->type_name("S");
  stress->add_option("--threads", options.order.threads, "drops at once; the results do not depend on it")
      ->check(CLI::Range(1U, 256U))
      ->capture_default_str()
      ->type_name("N");
  stress->add_option("--case", options.single, "one drop alone, with its events")
      ->check(CLI::NonNegativeNumber)
      ->type_name("K");
  stress->footer(
      "Exit status: 0 every drop is sound, 1 one is not (the command that replays it is printed), 2 bad usage.\n"
      "Example: goishi-verify stress --samples 100000 --seed 7");
  return stress;
}

bool run_stress_command(const Options& options) {
  const std::uint64_t seed = options.order.seed;
  if (options.single) {
    return run_single(seed, *options.single);
  }
  const Tally tally = run_stress(
      options.order, [&](std::uint64_t finished) { show_progress(finished, options.order); },
      [&](std::uint64_t index) {
        fmt::print("FAILS  does not end within {} s\n       replay: {}\n", longest_drop, replay(seed, index));
        std::fflush(stdout);
        std::_Exit(1);
      });
  if (isatty(STDERR_FILENO) != 0) {
    fmt::print(stderr, "\r\033[K");
  }
  print_tally(tally, seed);
  return tally.failures.empty();
}

}  // namespace goishi::verify::stress
