#include "compiled/drop.hpp"

namespace goishi::detail {

template Drop<double> dropped(const Stone<double>&, const RigidBody<double>&, const Board<double>*,
                              const State<double>&, const DropSettings<double>&, const double&, EventKind);

}  // namespace goishi::detail
