#pragma once
/// \file
/// `Drop` in double, which many files of the program, the suite and the tests call: compiled once, in drop.cpp.

#include <goishi/drop/drop.hpp>

namespace goishi {

extern template class Drop<double>;
extern template DropResult<double> followed(Drop<double>&);

}  // namespace goishi
