#pragma once
/// \file
/// `Scene` in double, compiled once, in scene.cpp.

#include <goishi/scene/scene.hpp>

#include "compiled/drop.hpp"

namespace goishi {

extern template class Scene<double>;

}  // namespace goishi
