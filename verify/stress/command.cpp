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

void show_progress(std::uint64_t finished, const Order& order, std::uint64_t each, const char* what) {
  if (finished % each == 0 && isatty(STDERR_FILENO) != 0) {
    fmt::print(stderr, "\r\033[K{} of {} {} …", finished, order.samples, what);
    std::fflush(stderr);
  }
}

void clear_progress() {
  if (isatty(STDERR_FILENO) != 0) {
    fmt::print(stderr, "\r\033[K");
  }
}

/// Of a case that does not end.
[[noreturn]] void give_up(const std::string& how_to_replay) {
  fmt::print("FAILS  does not end within {} s\n       replay: {}\n", longest_case, how_to_replay);
  std::fflush(stdout);
  std::_Exit(1);
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
  const DropResult<double> drop = run(scene);
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
      done.steps_rejected, done.evaluations_located, done.edge_impacts);
  const Verdict verdict = judge(scene, drop);
  for (const std::string& fault : verdict.faults) {
    fmt::print("FAILS  {}\n", fault);
  }
  return verdict.faults.empty();
}

std::string replay_pose(std::uint64_t seed, std::uint64_t index) {
  return fmt::format("goishi-verify stress --of poses --seed {} --case {}", seed, index);
}

bool run_single_pose(std::uint64_t seed, std::uint64_t index) {
  const PoseVerdict verdict = judge_pose(seed, index);
  fmt::print("{}\n{}\n", describe_pose(seed, index),
             verdict.fault.empty() ? std::string("sound") : "FAILS  " + verdict.fault);
  return verdict.fault.empty();
}

bool run_all_poses(const Order& order) {
  const PoseTally tally =
      run_poses(order, [&](std::uint64_t finished) { show_progress(finished, order, 6400, "poses"); });
  clear_progress();
  for (const Failure& failure : tally.failures) {
    fmt::print("FAILS  {}\n       replay: {}\n", failure.fault, replay_pose(order.seed, failure.index));
  }
  fmt::print("{} poses, {} wrong; seed {}, {:.1f} s\n", tally.samples, tally.failures.size(), order.seed,
             tally.seconds);
  const auto line = [](std::uint64_t count, const char* what) { fmt::print("  {:>10}  {}\n", count, what); };
  line(tally.pairs, "of two stones, the others of a stone and a board");
  line(tally.overlapping, "overlapping");
  line(tally.uncertified, "at the board without a certificate");
  line(tally.uncertified_pairs, "of two stones without a certificate");
  line(tally.proved, "judged by a proof over all normals");
  line(tally.searched, "only by a dense search: too many normals are as good");
  fmt::print("  gaps off those of their own normals by up to {:.2g} widths\n", tally.error);
  return tally.failures.empty();
}

std::string replay_heap(std::uint64_t seed, std::uint64_t index) {
  return fmt::format("goishi-verify stress --of scenes --seed {} --case {}", seed, index);
}

bool run_single_heap(std::uint64_t seed, std::uint64_t index) {
  const HeapVerdict verdict = judge_heap(seed, index);
  fmt::print("{}\n", describe_heap(seed, index));
  fmt::print("{} impacts of stones, {} steps of clusters, {}\n", verdict.counters.pair_impacts, verdict.counters.steps,
             verdict.rests ? "rests" : "is not asked to rest");
  for (const std::string& fault : verdict.faults) {
    fmt::print("FAILS  {}\n", fault);
  }
  return verdict.faults.empty();
}

bool run_all_heaps(const Order& order) {
  const HeapTally tally = run_heaps(
      order, [&](std::uint64_t finished) { show_progress(finished, order, 10, "scenes"); },
      [&](std::uint64_t index) { give_up(replay_heap(order.seed, index)); });
  clear_progress();
  for (const Failure& failure : tally.failures) {
    fmt::print("FAILS  {}\n       replay: {}\n", failure.fault, replay_heap(order.seed, failure.index));
  }
  fmt::print("{} scenes, {} failed; seed {}, {:.1f} s\n", tally.samples, tally.failures.size(), order.seed,
             tally.seconds);
  fmt::print("  {:>8}  stones, {} starts that overlap refused\n", tally.stones, tally.refused);
  fmt::print("  {:>8}  scenes come to rest\n", tally.rest);
  fmt::print("  {:>8}  impacts of two stones, {} steps of clusters, {} not solved\n", tally.counters.pair_impacts,
             tally.counters.steps, tally.counters.unsolved);
  fmt::print("  deepest {:.2g} widths; greatest rise of energy {:.2g} of what a step allows\n", tally.depth,
             tally.energy_rise);
  fmt::print("  slowest {:.2f} s: {}\n", tally.slowest, replay_heap(order.seed, tally.slowest_index));
  return tally.failures.empty();
}

}  // namespace

CLI::App* define_stress(CLI::App& app, Options& options) {
  CLI::App* stress = app.add_subcommand(
      "stress",
      "Drops random stones: any shape, pose, spin to 1000 rad/s, law and material, over edges and corners; judges that "
      "nothing is NaN, nothing tunnels, energy never rises, and every drop ends at rest or says why not.");
  stress->option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  stress
      ->add_option("--of", options.of,
                   "drops; poses: random stones in the board and in each other, thin ones, near edges and corners and "
                   "exactly singular, each gap judged by a proof over all normals; or scenes: boards with 2 to 50 "
                   "random stones, "
                   "with blows, hands and tilts")
      ->check(CLI::IsMember({"drops", "poses", "scenes"}))
      ->capture_default_str()
      ->type_name("WHAT");
  stress->add_option("--seed", options.order.seed, "seed of all")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str()
      ->type_name("N");
  stress->add_option("--samples", options.order.samples, "how many")
      ->check(CLI::PositiveNumber)
      ->capture_default_str()
      ->type_name("N");
  stress->add_option("--seconds", options.order.seconds, "stop after so long (0: never)")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str()
      ->type_name("S");
  stress->add_option("--threads", options.order.threads, "how many at once; the results do not depend on it")
      ->check(CLI::Range(1U, 256U))
      ->capture_default_str()
      ->type_name("N");
  stress->add_option("--case", options.single, "one alone: a drop with its events")
      ->check(CLI::NonNegativeNumber)
      ->type_name("K");
  stress->footer(
      "Exit status: 0 every drop is sound, 1 one is not (the command that replays it is printed), 2 bad usage.\n"
      "Examples: goishi-verify stress --samples 100000 --seed 7\n"
      "          goishi-verify stress --of poses --samples 10000000");
  return stress;
}

bool run_stress_command(const Options& options) {
  const std::uint64_t seed = options.order.seed;
  if (options.of == "poses") {
    return options.single ? run_single_pose(seed, *options.single) : run_all_poses(options.order);
  }
  if (options.of == "scenes") {
    return options.single ? run_single_heap(seed, *options.single) : run_all_heaps(options.order);
  }
  if (options.single) {
    return run_single(seed, *options.single);
  }
  const Tally tally = run_stress(
      options.order, [&](std::uint64_t finished) { show_progress(finished, options.order, 100, "drops"); },
      [&](std::uint64_t index) { give_up(replay(seed, index)); });
  clear_progress();
  print_tally(tally, seed);
  return tally.failures.empty();
}

}  // namespace goishi::verify::stress
