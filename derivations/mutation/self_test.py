"""The tool's own test: a formula with two proofs, of which one is blind."""

import os
import pathlib
import subprocess
import tempfile

from mutation.programs import Programs
from mutation.rewriter import rewrite
from mutation.source import Library

HEADER = pathlib.Path(__file__).with_name("mutation.hpp")
TOY_HEADER = """\
namespace goishi::formula {
template <class T>
[[nodiscard]] T toy(const T& a, const T& b) {
  return T(2) * a - b;
}
}
"""
TOY_PROOF = """\
#include "toy.hpp"
int main() { return goishi::formula::toy(3.0, B) == 6 - B ? 0 : 1; }
"""


def self_test():
    """The proof that looks at b = 0 only must let the changes of b's term pass, the one with b = 1 none."""
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        (work / "include").mkdir()
        (work / "include/toy.hpp").write_text(TOY_HEADER)
        changed, mutants = rewrite(Library(work / "include"))
        expected = ["sign of `T(2) * a`", "2 + 1 in `T(2) * a`", "sign of `b`", "size of `b`"]
        if sorted(m.what for m in mutants) != sorted(expected):
            print("self-test: other changes than expected:", [m.what for m in mutants])
            return 1
        (work / "toy.hpp").write_text(changed["toy.hpp"])
        (work / "toy.cpp").write_text(TOY_PROOF)
        compiler = os.environ.get("CXX", "c++")
        paths = {}
        for name, b in (("blind", "0.0"), ("seeing", "1.0")):
            paths[name] = work / name
            subprocess.run([compiler, "-std=c++20", f"-DB={b}", "-include", HEADER,
                            work / "toy.cpp", "-o", paths[name]], check=True)
        programs = Programs(paths, work)
        survivors = {name: [m.what for m in mutants if programs.notice(m, [name]) is None] for name in paths}
    if survivors != {"blind": ["sign of `b`", "size of `b`"], "seeing": []}:
        print("self-test: wrong survivors:", survivors)
        return 1
    print("self-test passed: the blind proof is found out, the seeing one is not")
    return 0
