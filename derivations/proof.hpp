#pragma once
/// \file
/// The pattern of every derivation: a document in Markdown with LaTeX that proves each of its statements while it is printed.

#include <algorithm>
#include <cstddef>
#include <exception>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>
#include "algebra.hpp"
#include "latex.hpp"

namespace derivation {

/// A statement: `view(result)`, with the letters in it replaced by their `meaning`, is `witness` for all values of the symbols.
///
/// `result` is what the shipped function returns for symbols; `witness` is the same quantity from its definition and shares
/// no formula with it. `view` is what is compared (the result's square, its derivative); the result itself when empty.
/// `controls` are wrong results, for which the same proof must fail; when empty, all `alterations` of the result.
struct Statement {
  std::string text;
  ex result;
  ex witness;
  exmap meaning = {};
  std::function<ex(const ex&)> view = {};
  std::vector<ex> controls = {};
};

class Document {
 public:
  explicit Document(const std::string& title) { std::cout << "# " << title << "\n"; }

  void section(const std::string& title) { std::cout << "\n## " << title << "\n"; }
  void text(const std::string& markdown) { std::cout << "\n" << markdown << "\n"; }
  void display(const std::string& mathematics) { std::cout << "\n$$" << mathematics << "$$\n"; }
  void equation(const std::string& left, const ex& right) { display(left + " = " + latex(right)); }

  /// Where the function stands that the next statements are about.
  void shipped(const std::string& function, const std::string& file) {
    std::cout << "\n*Shipped:* `goishi::" << function << "` in `src/goishi/" << file << "`.\n";
  }

  /// Prints the statement with the verdict of its proof and of its controls.
  void prove(const Statement& statement) {
    const auto seen = [&](const ex& result, const exmap& meaning) {
      return (statement.view ? statement.view(result) : result).subs(meaning);
    };
    const std::vector<ex> controls = statement.controls.empty() ? alterations(statement.result) : statement.controls;
    bool proved = false;
    std::ptrdiff_t passed = 0;
    std::string trouble;
    try {
      proved = vanishes(seen(statement.result, statement.meaning) - statement.witness);
      exmap sampled;
      for (const auto& [letter, value] : statement.meaning) {
        sampled[letter] = sample(value);
      }
      const ex expected = sample(statement.witness);
      const auto passes = [&](const ex& control) { return !differ(sample(seen(control, sampled)), expected); };
      passed = std::count_if(controls.begin(), controls.end(), passes);
    } catch (const std::exception& error) {
      proved = false;
      trouble = std::string(": ") + error.what();
    }
    std::ostringstream verdict;
    if (!proved) {
      verdict << "**NOT PROVED**" << trouble;
    } else if (passed == 0) {
      verdict << "proved; " << controls.size()
              << (controls.size() == 1 ? " altered result fails" : " altered results fail");
      refused_ += controls.size();
    } else {
      verdict << "**" << passed << " WRONG RESULTS PASS TOO**";
    }
    conclude(statement.text, verdict.str(), proved && passed == 0);
  }

  /// A limit, already taken in `result`, where most alterations would vanish: the controls are the scaled result, or 1 for 0.
  void prove_limit(const std::string& text, const ex& result, const ex& witness) {
    const ex at_limit = resolve_roots(result);
    prove({.text = text,
           .result = at_limit,
           .witness = witness,
           .controls = at_limit.is_zero() ? std::vector<ex>{1} : scaled(at_limit)});
  }

  /// Prints that two expressions are *not* the same.
  void refute(const std::string& text, const ex& left, const ex& right) {
    const bool different = differ(sample(left), sample(right));
    conclude(text, different ? "proved to differ" : "**NOT REFUTED**", different);
  }

  /// Prints a decided fact about numbers.
  void check(const std::string& text, bool holds) { conclude(text, holds ? "holds" : "**DOES NOT HOLD**", holds); }

  /// Prints the summary. 0 if every proof held and every control failed, else 1.
  [[nodiscard]] int verdict() const {
    const bool good = failed_ == 0 && 0 < statements_;
    std::cout << "\n---\n\n"
              << statements_ << " statements, " << (good ? "all proved" : std::to_string(failed_) + " FAILED");
    if (refused_ > 0) {
      std::cout << "; " << refused_ << " altered results fail";
    }
    std::cout << ".\n";
    return good ? 0 : 1;
  }

 private:
  void conclude(const std::string& text, const std::string& verdict, bool holds) {
    ++statements_;
    failed_ += holds ? 0 : 1;
    std::cout << "\n**(" << statements_ << ")** " << text << " — " << verdict << "." << std::endl;
  }

  int statements_ = 0;
  int failed_ = 0;
  std::size_t refused_ = 0;
};

/// A derivation: what main returns. A shipped formula so wrong that it cannot even be evaluated (0/0) is not proved either.
inline int derive(const std::string& title, const std::function<void(Document&)>& body) {
  Document document(title);
  try {
    body(document);
  } catch (const std::exception& error) {
    std::cout << "\n**NOT PROVED**: " << error.what() << "\n";
    return 1;
  }
  return document.verdict();
}

}  // namespace derivation
