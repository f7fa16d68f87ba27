#pragma once
/// \file
/// Quaternions by Hamilton's rules, the witness of everything that turns; and proofs in symbols that are bound by
/// relations.
///
/// A unit quaternion, a unit vector, the cosine and sine of an angle are plain symbols here, each set with one relation
/// that gives the square of one of its symbols: w² = 1 − x² − y² − z², s² = 1 − c². Since the sets share no symbol, a
/// polynomial has one form in which each of these symbols occurs at most once, and two polynomials are equal under the
/// relations if and only if these forms are. For a composed rotation that is far cheaper than rational symbols and
/// `normal()`.

#include <goishi/rotation.hpp>
#include <string>
#include <utility>
#include <vector>

#include "proof.hpp"

namespace derivation {

using Vector = goishi::Vec3<ex>;
using Quaternion = goishi::Quat<ex>;

// --- symbols and Hamilton's rules

/// A symbol's name is what chooses its sample point, and names that differ only in the index give three vectors in one
/// plane, where every triple product vanishes. So the first symbol is named "nn", the second "nnn", and printed with
/// their indices.
inline std::string repeated(const std::string& name, int times) {
  return times == 0 ? "" : name + repeated(name, times - 1);
}

inline realsymbol letter(const std::string& name, int index) {
  return {repeated(name, index + 1), name + "_" + std::to_string(index)};
}

inline Vector letters(const std::string& name) {
  return {letter(name, 1), letter(name, 2), letter(name, 3)};
}

/// The same, printed with the indices x, y, z; a number of a body may stand before them.
inline Vector letters_xyz(const std::string& name, const std::string& of_body = "") {
  const std::string index = name + "_{" + (of_body.empty() ? "" : of_body + ",");
  const auto letter = [&](int i) { return realsymbol(repeated(name + of_body, i + 2), index + "xyz"[i] + "}"); };
  return {letter(0), letter(1), letter(2)};
}

inline Vector positive_letters(const std::string& name) {
  const auto positive = [&](int index) {
    return possymbol(repeated(name, index + 1), name + "_" + std::to_string(index));
  };
  return {positive(1), positive(2), positive(3)};
}

inline Quaternion quaternion_letters(const std::string& name) {
  return {letter(name, 0), letter(name, 1), letter(name, 2), letter(name, 3)};
}

/// All components in one expression: a product with independent symbols.
inline ex components(const Vector& v) {
  static const Vector a = letters("a");
  return a.dot(v);
}

inline ex components(const Quaternion& q) {
  static const ex a0 = letter("a", 0);
  return a0 * q.w() + components(Vector(q.vec()));
}

inline Quaternion quaternion(const ex& scalar, const Vector& v) {
  return {scalar, v.x(), v.y(), v.z()};
}

inline Quaternion pure(const Vector& v) {
  return quaternion(0, v);
}

/// (s, a)(t, b) = (st − a·b, sb + ta + a×b).
inline Quaternion hamilton(const Quaternion& p, const Quaternion& q) {
  const Vector a = p.vec();
  const Vector b = q.vec();
  return quaternion(p.w() * q.w() - a.dot(b), Vector(p.w() * b) + Vector(q.w() * a) + a.cross(b));
}

inline Quaternion conjugated(const Quaternion& q) {
  return quaternion(q.w(), -q.vec());
}

/// q v q̄; for a unit quaternion the vector v of B in W.
inline Vector turned(const Quaternion& q, const Vector& v) {
  return hamilton(hamilton(q, pure(v)), conjugated(q)).vec();
}

inline ex squared_norm(const Quaternion& q) {
  return pow(q.w(), 2) + pow(q.x(), 2) + pow(q.y(), 2) + pow(q.z(), 2);
}

// --- relations

class Relations {
 public:
  /// symbol² = value.
  Relations& square(const ex& symbol, const ex& value) {
    squares_.emplace_back(symbol, value);
    return *this;
  }

  Relations& unit(const Vector& n) { return square(n.z(), 1 - pow(n.x(), 2) - pow(n.y(), 2)); }
  Relations& unit(const Quaternion& q) { return square(q.w(), 1 - pow(q.x(), 2) - pow(q.y(), 2) - pow(q.z(), 2)); }

  /// Two symbols for the cosine and sine of an argument.
  Relations& angle(const ex& argument, const ex& cosine, const ex& sine) {
    angles_.push_back({(*this)(argument), cosine, sine});
    return square(sine, 1 - pow(cosine, 2));
  }

  /// The form that decides. A root or a function of an argument that is not known stays as it is.
  ex operator()(const ex& e) const { return Reducer(*this)(e); }
  Vector operator()(const Vector& v) const { return {(*this)(v.x()), (*this)(v.y()), (*this)(v.z())}; }
  Quaternion operator()(const Quaternion& q) const {
    return {(*this)(q.w()), (*this)(q.x()), (*this)(q.y()), (*this)(q.z())};
  }

  /// The same for what has no root and no function: without looking for them.
  [[nodiscard]] ex of_polynomial(const ex& e) const {
    ex form = e.expand();
    for (const auto& [symbol, value] : squares_) {
      if (!form.has(symbol) || !form.is_polynomial(symbol)) {
        continue;
      }
      while (form.degree(symbol) > 1) {
        ex sum = 0;
        for (int n = form.degree(symbol); n >= 0; --n) {
          sum += form.coeff(symbol, n) * (n % 2 == 0 ? ex(1) : symbol) * pow(value, n / 2);
        }
        form = sum.expand();
      }
    }
    return form;
  }

  /// d/dt of a form: dc = −s dφ and ds = c dφ for every angle φ.
  ex rate(const ex& form, const symbol& t) const {
    ex sum = form.diff(t);
    for (const Angle& angle : angles_) {
      const ex by_cosine = form.diff(GiNaC::ex_to<symbol>(angle.cosine));
      const ex by_sine = form.diff(GiNaC::ex_to<symbol>(angle.sine));
      sum += angle.argument.diff(t) * (angle.cosine * by_sine - angle.sine * by_cosine);
    }
    return (*this)(sum);
  }
  Quaternion rate(const Quaternion& q, const symbol& t) const {
    return {rate(q.w(), t), rate(q.x(), t), rate(q.y(), t), rate(q.z(), t)};
  }

  /// A form where all angles are zero.
  ex at_zero_angles(const ex& form) const {
    exmap zero;
    for (const Angle& angle : angles_) {
      zero[angle.cosine] = 1;
      zero[angle.sine] = 0;
    }
    return form.subs(zero);
  }

  /// The statement under the relations.
  Statement operator()(Statement statement) const {
    statement.view = [*this, view = statement.view](const ex& e) { return (*this)(view ? view(e) : e); };
    statement.witness = (*this)(statement.witness);
    return statement;
  }

  /// The statement that two expressions are the same under the relations, and not the negative or a little more.
  [[nodiscard]] Statement whole(const std::string& text, const ex& result, const ex& witness) const {
    const ex form = (*this)(result);
    return {.text = text, .result = form, .witness = (*this)(witness), .controls = scaled(form)};
  }

 private:
  struct Angle {
    ex argument;
    ex cosine;
    ex sine;
  };

  struct Reducer : GiNaC::map_function {
    explicit Reducer(const Relations& relations) : given(relations) {}
    ex operator()(const ex& node) override {
      const ex inner = node.nops() == 0 ? node : node.map(*this);
      if (GiNaC::is_a<GiNaC::function>(inner)) {
        return given.of_function(inner);
      }
      if (GiNaC::is_a<GiNaC::power>(inner) && inner.op(1).info(GiNaC::info_flags::rational) &&
          !inner.op(1).info(GiNaC::info_flags::integer)) {
        return given.of_polynomial(pow(positive_root(inner.op(0)), 2 * inner.op(1)));
      }
      return given.of_polynomial(inner);
    }
    const Relations& given;
  };

  [[nodiscard]] ex of_function(const ex& f) const {
    const bool is_cosine = GiNaC::is_the_function<GiNaC::cos_SERIAL>(f);
    if (!is_cosine && !GiNaC::is_the_function<GiNaC::sin_SERIAL>(f)) {
      return f;
    }
    for (const Angle& angle : angles_) {
      const bool same = (f.op(0) - angle.argument).expand().is_zero();
      if (same || (f.op(0) + angle.argument).expand().is_zero()) {
        return is_cosine ? angle.cosine : same ? angle.sine : -angle.sine;
      }
    }
    return f;
  }

  std::vector<std::pair<ex, ex>> squares_;
  std::vector<Angle> angles_;
};

/// The alterations that show in a result that is zero: all but that of the whole.
inline std::vector<ex> alterations_within(const ex& result) {
  std::vector<ex> altered = alterations(result);
  altered.resize(altered.size() - scaled(result).size());
  return altered;
}

}  // namespace derivation
