"""The judges: proofs, tests and claims, as programs built against the changed copy of the library."""

import concurrent.futures
import dataclasses
import hashlib
import json
import os
import pathlib
import re
import signal
import subprocess
import tempfile
import threading

KINDS = ("proof", "test", "claim")


@dataclasses.dataclass
class Unit:
    """What can be run by itself: a proof, a test, a claim."""
    program: "Program"
    name: str
    family: str
    work: int = 0  # places of the library that it passes: the same on every machine, unlike its time
    seconds: float = 0.0
    places: frozenset = frozenset()

    def limit(self):
        """Of the processor's time: far beyond what a change that only makes it slower takes."""
        return max(3.0, 30 * self.seconds)

    def order(self):
        return (self.work.bit_length(), self.name)  # threads that pass a place at once count it once


class Program:
    def __init__(self, path, kind, name=""):
        self.path, self.kind, self.name = pathlib.Path(path), kind, name

    def units(self):
        if self.kind == "proof":
            return [Unit(self, self.name, "proof")]
        listed = subprocess.run([self.path, "--list"], capture_output=True, text=True, check=True).stdout
        return [Unit(self, *line.split("\t")) for line in listed.splitlines()]

    def start(self, units, environment, limit):
        """How it ended, what it wrote, and the processor's time."""
        arguments = [] if self.kind == "proof" else [f"{u.limit() if limit else 600}:{u.name}" for u in units]
        environment = {**os.environ, "RC_PARAMS": "seed=1", **environment}
        with subprocess.Popen([self.path, *arguments], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                              stdin=subprocess.DEVNULL, env=environment) as process:
            guard = threading.Timer(20 * (limit or 600) + 60, process.kill)  # of one that waits without working
            guard.start()
            written = process.stdout.read()
            _, status, usage = os.wait4(process.pid, 0)
            guard.cancel()
            process.returncode = os.waitstatus_to_exitcode(status)
        return process.returncode, written, usage.ru_utime + usage.ru_stime

    def judge(self, units, code):
        """("passes", None), or how the first unit fails that does: "killed", "hang", "crash"."""
        limit = sum(unit.seconds for unit in units) + max(unit.limit() for unit in units)
        status, written, _ = self.start(units, {"GOISHI_MUTANT": str(code), "GOISHI_MUTANT_SECONDS": f"{limit:.3f}"},
                                        limit)
        if status == 0:
            return "passes", None
        at = units[0]
        if self.kind != "proof":
            names = re.findall(rb"^unit (.*)$", written, re.M)
            at = next((u for u in units if names and u.name == names[-1].decode()), at)
        return {-signal.SIGPROF: "hang", -signal.SIGKILL: "hang"}.get(status, "killed" if 0 < status else "crash"), at

    def measure(self, unit):
        """Runs a unit without a change: its time, its places. Returns the places that have nothing to change."""
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "reached"
            status, _, seconds = self.start([unit], {"GOISHI_MUTANT_REACHED": str(file)}, None)
            if status != 0:
                raise RuntimeError(f"{unit.name} fails without a change")
            work, *lines = file.read_text().splitlines()
        reached = dict(tuple(map(int, line.split())) for line in lines)
        unit.work, unit.seconds = int(work), seconds
        unit.places = frozenset(place for place, stages in reached.items() if stages)
        return [place for place, stages in reached.items() if not stages]


def measured(programs, jobs, cache=None):
    """All units with their places, in the order in which they judge; and the places where nothing can be changed.
    The file `cache` keeps what is known of programs that are the same to the last byte."""
    known = json.loads(cache.read_text()) if cache and cache.exists() else {}
    units, constant = [], set()
    for program in programs:
        content = hashlib.sha256(program.path.read_bytes()).hexdigest()
        if known.get(program.path.name, [None])[0] != content:
            mine = program.units()
            with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
                fixed = list(pool.map(program.measure, mine))
            rows = [[u.name, u.family, u.work, u.seconds, sorted(u.places), f] for u, f in zip(mine, fixed)]
            known[program.path.name] = [content, rows]
        for *unit, places, fixed in known[program.path.name][1]:
            units.append(Unit(program, *unit, frozenset(places)))
            constant.update(fixed)
    if cache:
        write_if_changed(cache, json.dumps(known).encode())
    constant -= set().union(*(unit.places for unit in units))
    return sorted(units, key=lambda unit: (KINDS.index(unit.program.kind), unit.order())), constant


# --- building them


def write_if_changed(path, data):
    if not path.exists() or path.read_bytes() != data:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


def link_all(folder, copy, replaced):
    """Links what is visible in a folder into its copy, except for what is replaced there."""
    copy.mkdir(parents=True, exist_ok=True)
    for link in copy.iterdir():
        if link.is_symlink() and not link.exists():
            link.unlink()
    for path in folder.iterdir():
        link = copy / path.name
        if path.name not in replaced and not path.name.startswith(".") and link.resolve() != path:
            link.unlink(missing_ok=True)
            link.symlink_to(path)


def copy_tree(root, copy, changed):
    """The tree with the changed headers in it."""
    link_all(root, copy, {"src", "derivations", "build"})
    link_all(root / "src", copy / "src", {"goishi"})
    for header, text in changed.items():
        write_if_changed(copy / "src/goishi" / header, text)
    library = root / "src/goishi"
    for path in library.rglob("*.hpp"):
        if str(path.relative_to(library)) not in changed:
            write_if_changed(copy / "src/goishi" / path.relative_to(library), path.read_bytes())
    for path in (copy / "src/goishi").rglob("*.hpp"):
        if path.name != "mutation.hpp" and not (library / path.relative_to(copy / "src/goishi")).exists():
            path.unlink()
    write_if_changed(copy / "src/goishi/mutation.hpp", (root / "verify/mutation/mutation.hpp").read_bytes())
    for path in (root / "derivations").iterdir():
        if path.suffix in (".hpp", ".cpp", ".txt", ".supp") and path.name != "proof.hpp":
            write_if_changed(copy / "derivations" / path.name, path.read_bytes())
    # Of a proof the first failure is enough.
    proof, count = re.subn(rb"(failed_ \+= holds \? 0 : 1;)", rb"\1 if (!holds) std::_Exit(1);",
                           (root / "derivations/proof.hpp").read_bytes())
    if count != 1:
        raise RuntimeError("proof.hpp does not count its failures where it did")
    write_if_changed(copy / "derivations/proof.hpp", proof)


def build(root, work, changed, proofs, others, jobs):
    """Compiles the judges in the folder `work`; returns them."""
    copy = work / "source"
    copy_tree(root, copy, changed)
    targets = [f"derive_{name}" for name in proofs] + (["goishi_tests", "goishi_mutation_claims"] if others else [])
    cmake = ["cmake", "-S", copy, "-B", work / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=None",
             "-DCMAKE_CXX_FLAGS=-O1 -w -Wno-narrowing -ftrivial-auto-var-init=zero", "-DGOISHI_SIMD_LEVEL=",
             "-DGOISHI_BENCH_RIVALS=OFF", "-DGOISHI_INSTALL=OFF", "-DGOISHI_MUTATION=ON",
             "-DGOISHI_BUILD_CLI=OFF", "-DGOISHI_BUILD_C=OFF"]
    for command in (cmake, ["cmake", "--build", work / "build", "--parallel", str(jobs), "--target", *targets]):
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode:
            (work / "build.log").write_text(done.stdout)
            first = next((line for line in done.stdout.splitlines() if "error" in line.lower()), "")
            raise RuntimeError(f"the changed copy does not compile ({work / 'build.log'}): {first}")
    built = work / "build"
    programs = [Program(built / f"derivations/derive_{name}", "proof", f"derivations/{name}.cpp") for name in proofs]
    if others:
        programs.append(Program(built / "tests/goishi-tests", "test"))
        programs.append(Program(built / "verify/goishi-mutation-claims", "claim"))
    return programs
