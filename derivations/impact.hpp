#pragma once
/// \file
/// Symbols for impacts: any contact matrix, any body at the moment of an impact.

#include <goishi/impact/impulses.hpp>
#include <string>

#include "enclosure.hpp"  // has an e and an n of its own: ahead of the letters below
#include "proof.hpp"
#include "relations.hpp"

namespace derivation {

namespace formula = goishi::formula;
using goishi::ContactMatrix;
using Matrix = goishi::Mat3<ex>;
using Body = goishi::ImpactBody<ex>;

inline const Vector n = letters("n");
inline const Vector v = letters("v");
inline const Vector p = letters("p");
inline const possymbol e("e");
inline const possymbol mu("mu", R"(\mu)");

/// Any contact matrix.
inline ContactMatrix<ex> matrix_letters(const std::string& name) {
  const auto letter = [&](const std::string& index) { return realsymbol(name + index, name + "_{" + index + "}"); };
  return {letter("xx"), letter("yy"), letter("zz"), letter("xy"), letter("xz"), letter("yz")};
}

inline Matrix full(const ContactMatrix<ex>& W) {
  Matrix M;
  M << W.xx, W.xy, W.xz, W.xy, W.yy, W.yz, W.xz, W.yz, W.zz;
  return M;
}

inline const ContactMatrix<ex> W = matrix_letters("W");
inline const Matrix M = full(W);

}  // namespace derivation
