#pragma once
/// \file
/// `drop` in double, which many files of the suite call: compiled once, in compiled_drop.cpp.

#include <goishi/drop/drop.hpp>

namespace goishi::detail {

extern template Drop<double> dropped(const Stone<double>&, const RigidBody<double>&, const Board<double>*,
                                     const State<double>&, const DropSettings<double>&, const double&, EventKind);

}  // namespace goishi::detail
