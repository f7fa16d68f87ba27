#pragma once
/// \file
/// A function for each alternative of a std::variant.

namespace goishi::cli {

/// std::visit(Cases{[](const A&) { … }, [](const B&) { … }}, variant)
template <class... F>
struct Cases : F... {
  using F::operator()...;
};
template <class... F>
Cases(F...) -> Cases<F...>;

}  // namespace goishi::cli
