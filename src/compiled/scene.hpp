#pragma once
/// \file
/// `Scene` in double, compiled once, in scene.cpp.

#include <goishi/scene/scene.hpp>

#include "compiled/drop.hpp"

#ifndef GOISHI_DROP_IN_EVERY_FILE
namespace goishi {

extern template class Scene<double>;

}  // namespace goishi
#endif
