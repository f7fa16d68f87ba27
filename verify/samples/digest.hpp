#pragma once
/// \file
/// What is told of the events of a drop or a scene, in one number.

#include <bit>
#include <cstdint>
#include <goishi/drop/events.hpp>

namespace goishi::verify {

class Digest {
 public:
  void operator()(const Event<double>& event) {
    add(static_cast<double>(event.kind));
    add(event.time);
    add(event.after);
  }
  void add(const State<double>& state) {
    for (const Vec3<double>* v : {&state.p_WB, &state.v_WB, &state.L_W}) {
      add(v->x());
      add(v->y());
      add(v->z());
    }
    add(state.q_WB.w());
    add(state.q_WB.x());
    add(state.q_WB.y());
    add(state.q_WB.z());
  }
  void add(double x) {  // FNV-1a
    const auto bits = std::bit_cast<std::uint64_t>(x);
    for (int byte = 0; byte < 8; ++byte) {
      hash_ = (hash_ ^ (bits >> (8 * byte) & 0xffU)) * 0x100000001b3U;
    }
  }
  [[nodiscard]] bool operator==(const Digest&) const = default;

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

}  // namespace goishi::verify
