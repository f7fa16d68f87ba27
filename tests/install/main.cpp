#include <goishi/mass/tensor.hpp>
#include <goishi/shape/catalogue.hpp>

int main() {
  const auto stone = goishi::make_stone(goishi::catalogue_stone(33, goishi::StoneColor::white), 0.001);
  const auto body = goishi::mass_properties(stone, goishi::Density{2800.0});
  const bool weighs_five_grams = 0.0045 < body.mass && body.mass < 0.0055;
  return weighs_five_grams ? 0 : 1;
}
