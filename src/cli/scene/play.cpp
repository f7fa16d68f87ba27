#include "scene/play.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "sample.hpp"
#include "scene/cases.hpp"

namespace goishi::cli {

ScenePlay::ScenePlay(const SceneFile& file) : file_(&file), scene_(file.board, file.settings) {
  for (const StoneEntry& entry : file.stones) {
    add(entry);
  }
}

void ScenePlay::add(const StoneEntry& entry) {
  in_file(file_->name, entry.path, [&] {
    const SolidStone& solid = file_->solids[entry.solid];
    try {
      scene_.add(solid.stone, solid.body, entry.start);
    } catch (const InvalidArgument& error) {  // of a group: which
      throw InvalidArgument(error.argument(), error.value(), fmt::format("stone {} {}", solids_.size(), error.rule()));
    }
    solids_.push_back(entry.solid);
  });
}

void ScenePlay::apply(const SceneAction& action, SceneSink<double> sink) {
  in_file(file_->name, action.path, [&] {
    std::visit(Cases{[&](const ImpulseAction& a) {
                       const Vec3<double> p_W = scene_.state(a.id).p_WB + a.offset_W;
                       scene_.apply_impulse(a.id, p_W, a.impulse_W, sink);
                     },
                     [&](const HoldAction& a) { scene_.hold(a.id, a.v_WB, a.w_WB, a.duration); },
                     [&](const ReleaseAction& a) { scene_.release(a.id); },
                     [&](const GravityAction& a) {
                       SceneSettings<double> settings = file_->settings;
                       settings.drop.gravity = a.gravity;
                       scene_.change(settings, sink);
                     },
                     [&](const AddAction& a) { add(a.entry); },
                     [&](const RemoveAction& a) {
                       const double work = scene_.work(a.id);
                       scene_.remove(a.id);
                       removed_work_ += work;
                     }},
               action.what);
  });
}

template <class Go>
void ScenePlay::in_calls(double time, Go&& go) {
  constexpr int most_calls = 100;
  for (int calls = 1; !go(); ++calls) {
    require(calls < most_calls, "time", time, "takes too much work: in ", most_calls, " calls it came to ",
            scene_.time(), " s");
  }
}

void ScenePlay::go_to(double time, SceneSink<double> sink) {
  in_calls(time, [&] { return scene_.advance_to(time, sink); });
}

void ScenePlay::advance_to(double time, SceneSink<double> sink) {
  for (; done_ < file_->actions.size() && file_->actions[done_].time <= time; ++done_) {
    go_to(file_->actions[done_].time, sink);
    apply(file_->actions[done_], sink);
  }
  go_to(time, sink);
}

bool ScenePlay::advance_to_end(SceneSink<double> sink) {
  if (!file_->to_rest) {
    advance_to(file_->end, sink);
    return moving() == 0;
  }
  if (!file_->actions.empty()) {
    advance_to(file_->actions.back().time, sink);
  }
  bool rests = false;
  in_calls(file_->end, [&] {
    rests = scene_.run_until_rest(file_->end - scene_.time(), sink);
    return rests || !(scene_.time() < file_->end);
  });
  return rests;
}

long long ScenePlay::moving() const {
  const std::vector<StoneId> stones = scene_.stones();
  return std::ranges::count_if(stones, [this](StoneId id) {
    const StoneMode mode = scene_.mode(id);
    if (mode == StoneMode::held) {
      const State<double> state = scene_.state(id);
      return state.v_WB != Vec3<double>::Zero() || state.L_W != Vec3<double>::Zero();
    }
    return mode != StoneMode::rest;
  });
}

double ScenePlay::hand_work() const {
  double sum = removed_work_;
  for (const StoneId id : scene_.stones()) {
    sum += scene_.work(id);
  }
  return sum;
}

std::string series_of(const SceneFile& file, double end, int times) {
  std::string text = fmt::format("time_s,stone,{},mode\n", sample_columns);
  ScenePlay play(file);
  const Scene<double>& scene = play.scene();
  for (int row = 0; row < times; ++row) {
    const double time = row == times - 1 ? end : end * row / (times - 1);
    play.advance_to(time);
    for (const StoneId id : scene.stones()) {
      fmt::format_to(std::back_inserter(text), "{:.17g},{}", time, index_of(id));
      append_cells(text, sample_of(time, scene.state(id), scene.body(id), scene.settings().drop.gravity));
      fmt::format_to(std::back_inserter(text), ",{}\n", to_string(scene.mode(id)));
    }
  }
  return text;
}

}  // namespace goishi::cli
