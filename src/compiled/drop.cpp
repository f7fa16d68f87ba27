#include "compiled/drop.hpp"

namespace goishi {

template class Drop<double>;
template DropResult<double> followed(Drop<double>&);

}  // namespace goishi
