#include <goishi/mass/inertia.hpp>
#include <goishi/shape/stone.hpp>

int main() {
  return 0;
}
