#include "compiled/scene.hpp"

namespace goishi {

template class Scene<double>;

}  // namespace goishi
