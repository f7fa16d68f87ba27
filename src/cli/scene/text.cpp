#include "scene/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drop_text.hpp"
#include "scene/cases.hpp"

namespace goishi::cli {

namespace {

std::string text_of_action(const SceneAction& action) {
  return std::visit(
      Cases{[](const ImpulseAction& a) { return fmt::format("an impulse on stone {}", index_of(a.id)); },
            [](const HoldAction& a) { return fmt::format("a hand moves stone {}", index_of(a.id)); },
            [](const ReleaseAction& a) { return fmt::format("stone {} is let go", index_of(a.id)); },
            [](const GravityAction& a) { return fmt::format("gravity {} m/s²", text_of_gravity(a.gravity)); },
            [](const AddAction&) { return std::string("a stone is added"); },
            [](const RemoveAction& a) { return fmt::format("stone {} is removed", index_of(a.id)); }},
      action.what);
}

std::string of_stones(long long count) {
  return fmt::format("{} stone{}", count, count == 1 ? "" : "s");
}

/// What the stones are, and under which laws.
std::string text_of_setting(const SceneFile& file) {
  std::vector<long long> counts(file.solids.size());
  for (const StoneEntry& entry : file.stones) {
    ++counts[entry.solid];
  }
  std::string text =
      fmt::format("{}\n{} on the {}\n", file.title, of_stones(static_cast<long long>(file.stones.size())), file.ground);
  double mass = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (0 < counts[i]) {
      const SolidStone& solid = file.solids[i];
      text += fmt::format("{} × {}, {:.6g} kg{}\n", counts[i], solid.title, solid.body.mass,
                          solid.density_assumed ? " (density assumed)" : "");
      mass += static_cast<double>(counts[i]) * solid.body.mass;
    }
  }
  const SceneSettings<double> all = filled(file.settings, file.solids.front().stone.width);
  text += fmt::format("mass {:.6g} kg, gravity {} m/s²\n", mass, text_of_gravity(all.drop.gravity));
  text += fmt::format("on the board: {}\n", text_of_laws(file.settings.drop, file.solids.front().stone));
  text += fmt::format("of two stones: restitution {:.6g}, friction {:.6g}\n", all.restitution, all.friction);
  return text + fmt::format("tolerance {:.6g}, steps of {:.6g} s; until {:.6g} s{}\n\n", all.drop.tolerance, *all.step,
                            file.end, file.to_rest ? ", or all stones rest" : "");
}

std::string text_of_contacts(const Scene<double>& scene) {
  long long board = 0, floor = 0, stones = 0;
  for (const SceneContact<double>& contact : scene.contacts()) {
    const bool low = is_on_floor(scene.board(), contact.p_WC, OtherFeature::surface);
    ++(contact.other ? stones : low ? floor : board);
  }
  return text_of_counts({{board, "with the board"}, {floor, "with the floor"}, {stones, "of two stones"}}, "");
}

}  // namespace

void SceneSummary::tell(const SceneEvent<double>& event) {
  ++kinds_[static_cast<std::size_t>(event.event.kind)];
  of_pairs_ += event.event.kind == EventKind::impact && event.other ? 1 : 0;
}

std::string SceneSummary::text(const SceneFile& file, const ScenePlay& end, bool rests) const {
  const Scene<double>& scene = end.scene();
  std::string text = text_of_setting(file);
  for (const SceneAction& action : file.actions) {
    text += fmt::format("{:.6g} s: {}\n", action.time, text_of_action(action));
  }
  text += file.actions.empty() ? "" : "\n";
  std::string how = end_of(end, rests);
  how.front() = static_cast<char>(how.front() - 'a' + 'A');
  std::vector<std::pair<long long, std::string_view>> modes, kinds;
  for (const StoneMode mode :
       {StoneMode::flight, StoneMode::contact, StoneMode::cluster, StoneMode::rest, StoneMode::held}) {
    const std::vector<StoneId> stones = scene.stones();
    modes.emplace_back(std::ranges::count(stones, mode, [&](StoneId id) { return scene.mode(id); }), to_string(mode));
  }
  for (std::size_t i = 0; i < kinds_.size(); ++i) {
    kinds.emplace_back(kinds_[i], to_string(EventKind(i)));
  }
  text += fmt::format("{}.\nStones: {}.\nContacts: {}.\n", how, text_of_counts(modes, ""), text_of_contacts(scene));
  const double energy = scene.energy();
  text += fmt::format("Energy: {:.6g} mJ at the start, {:.6g} mJ at the end, {:.6g} mJ {}", 1e3 * energy_, 1e3 * energy,
                      1e3 * std::abs(energy_ - energy), energy <= energy_ ? "lost" : "gained");
  const double work = end.hand_work();
  text += work == 0 ? ".\n" : fmt::format("; {:.6g} mJ were the work of hands on other stones.\n", 1e3 * work);
  text += fmt::format("Events: {}", text_of_counts(kinds, ""));
  text +=
      of_pairs_ == 0 ? ".\n" : fmt::format("; {} of these impacts are those of two stones, told of each.\n", of_pairs_);
  std::vector<std::pair<long long, std::string_view>> costs;
  for (const auto& [name, count] : counts_of(scene.counters())) {
    costs.emplace_back(count, name);
  }
  std::string cost = text_of_counts(costs, "");
  std::ranges::replace(cost, '_', ' ');
  return text + fmt::format("Computed: {}.\n", cost);
}

std::string end_of(const ScenePlay& play, bool rests) {
  const double time = play.scene().time();
  return rests ? fmt::format("at rest after {:.6g} s", time)
               : fmt::format("still moving after {:.6g} s: {} of {}", time, play.moving(),
                             of_stones(static_cast<long long>(play.scene().stones().size())));
}

std::vector<std::pair<const char*, long long>> counts_of(const SceneCounters& c) {
  return {{"stretches", c.stretches},
          {"looks", c.looks},
          {"separations", c.separations},
          {"pair_impacts", c.pair_impacts},
          {"joins", c.joins},
          {"steps", c.steps},
          {"stone_steps", c.stone_steps},
          {"cut_steps", c.cut_steps},
          {"retries", c.retries},
          {"solves", c.solves},
          {"sweeps", c.sweeps},
          {"updates", c.updates},
          {"unsolved", c.unsolved},
          {"rest_trials", c.rest_trials}};
}

}  // namespace goishi::cli
