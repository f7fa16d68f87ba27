#pragma once
/// \file
/// `Drop` in double, which many files of the program, the suite and the tests call: compiled once, in drop.cpp.
/// (`verify/mutants` compiles one claim against a changed library: there each file has its own.)

#include <goishi/drop/drop.hpp>

#ifndef GOISHI_DROP_IN_EVERY_FILE
namespace goishi {

extern template class Drop<double>;
extern template DropResult<double> followed(Drop<double>&);

}  // namespace goishi
#endif
