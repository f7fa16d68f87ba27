#pragma once
/// \file
/// 50 decimal digits.

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace goishi::verify {

/// Expression templates off: an `auto` is a value.
using Digits50 =
    boost::multiprecision::number<boost::multiprecision::backends::cpp_bin_float<50>, boost::multiprecision::et_off>;

}  // namespace goishi::verify
