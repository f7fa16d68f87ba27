#pragma once
/// \file
/// `drop` in double, which many files of the program, the suite and the tests call: compiled once, in drop.cpp.
/// (`verify/mutants` compiles one claim against a changed library: there each file has its own.)

#include <goishi/drop/drop.hpp>

#ifndef GOISHI_DROP_IN_EVERY_FILE
namespace goishi::detail {

extern template Drop<double> dropped(const Stone<double>&, const RigidBody<double>&, const Board<double>*,
                                     const State<double>&, const DropSettings<double>&, const double&, EventKind);

}  // namespace goishi::detail
#endif
