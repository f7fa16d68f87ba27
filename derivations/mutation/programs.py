"""The proof programs, against the changed copy of the source."""

import os
import re
import subprocess
import time


def write_if_changed(path, text):
    if not path.exists() or path.read_text() != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def link_all(folder, copy, replaced):
    """Links what is visible in a folder into its copy, except for what is replaced there."""
    copy.mkdir(parents=True, exist_ok=True)
    for path in folder.iterdir():
        link = copy / path.name
        if path.name not in replaced and not path.name.startswith(".") and link.resolve() != path:
            link.unlink(missing_ok=True)
            link.symlink_to(path)


def build(root, work, changed, programs):
    """Compiles the proof programs of the tree `root`, in the folder `work`, against the changed headers."""
    copy = work / "source"
    for header, text in changed.items():
        write_if_changed(copy / "src/goishi" / header, text)
    link_all(root, copy, {"src", "derivations", "build"})
    link_all(root / "src", copy / "src", {"goishi"})
    link_all(root / "derivations", copy / "derivations", {"proof.hpp"})
    # The first failure is enough.
    proof, count = re.subn(r"(failed_ \+= holds \? 0 : 1;)", r"\1 if (!holds) std::_Exit(1);",
                           (root / "derivations/proof.hpp").read_text())
    if count != 1:
        raise RuntimeError("proof.hpp does not count its failures where it did")
    write_if_changed(copy / "derivations/proof.hpp", proof)
    flags = f"-std=c++20 -w -include {root / 'derivations/mutation/mutation.hpp'}"
    options = [f"-DGOISHI_BUILD_{part}=OFF" for part in ("CLI", "VERIFY", "BENCHMARKS", "TESTS")]
    commands = [["cmake", "-S", copy, "-B", work / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=None",
                 f"-DCMAKE_CXX_FLAGS={flags}", "-DGOISHI_INSTALL=OFF", *options],
                ["cmake", "--build", work / "build", "--parallel", "1", "--target",
                 *(f"derive_{name}" for name in programs)]]
    for command in commands:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode:
            raise RuntimeError(f"the changed copy does not compile\n{done.stdout}")
    return {name: work / "build/derivations" / f"derive_{name}" for name in programs}


class Programs:
    """Proof programs by name: the places that each comes to, and how long it takes."""

    def __init__(self, paths, work):
        self.paths, self.reached, self.seconds = paths, {}, {}
        for name in paths:
            trace = work / "reached"
            start = time.monotonic()
            if not self.holds(name, {"GOISHI_MUTANT_REACHED": str(trace)}):
                raise RuntimeError(f"{name} fails without any change")
            self.seconds[name] = time.monotonic() - start
            self.reached[name] = {int(place) for place in trace.read_text().split()}

    def holds(self, name, environment):
        """Whether a program proves everything. One that takes ten times as long as it should does not."""
        limit = 10 * self.seconds[name] + 10 if name in self.seconds else None
        try:
            done = subprocess.run([self.paths[name]], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                  env={**os.environ, **environment}, timeout=limit, check=False)
        except subprocess.TimeoutExpired:
            return False
        return done.returncode == 0

    def notice(self, mutant, names):
        """The program that notices a change, or None."""
        for name in sorted(names, key=self.seconds.get):
            if mutant.code // 2 in self.reached[name] and not self.holds(name, {"GOISHI_MUTANT": str(mutant.code)}):
                return name
        return None
