"""The tool's own test: a header whose changes have known verdicts, shards, and files that do not fit."""

import contextlib
import datetime
import io
import os
import pathlib
import shutil
import subprocess
import tempfile

from mutation import programs, report, results, sweep
from mutation.finder import rewrite

HERE = pathlib.Path(__file__).parent
HEADER = """\
#pragma once
namespace goishi {
namespace formula {
template <class T>
[[nodiscard]] T twice(const T& a) {
  return T(2) * a;
}
}
inline bool is_small(int a) { return a < 10; }
inline int steps(int n) {
  int count = 0;
  while (count < n) {
    count += 1;
  }
  return count;
}
inline double loose(double a) { return a + 1e-9; }
inline int never(int a) { return -a; }
}
"""
PROOF = """\
#include <goishi/toy.hpp>
int main() { return goishi::formula::twice(3.0) == 6.0 ? 0 : 1; }
"""
# A program of units: `one` and `other` are conditions.
UNITS = """\
#include "verify/mutation/units.hpp"
#include <goishi/toy.hpp>
#include <cstdio>
int main(int argc, char** argv) {
  using namespace goishi;
  if (argc == 2 && std::string(argv[1]) == "--list") { std::puts("one\\t%s\\nother\\t%s"); return 0; }
  for (const auto& unit : mutant::units_of(argc, argv)) {
    mutant::begin(unit);
    if (!(unit.name == "one" ? %s : %s)) { return 1; }
  }
  return 0;
}
"""
TESTS = UNITS % ("test", "test", "is_small(9)", "steps(3) >= 3")
CLAIMS = UNITS % ("exact solution", "invariant", "!is_small(10)", "loose(1.0) < 2.0")
# function: change → verdict, by whom
EXPECTED = {
    "twice: sign of `T(2) * a`": ("killed", "proof"),
    "twice: 2 + 1 in `T(2) * a`": ("killed", "proof"),
    "is_small: `a < 10` -> true": ("killed", "one exact solution"),
    "is_small: `a < 10` -> false": ("killed", "one test"),
    "is_small: `a < 10` -> <=": ("killed", "one exact solution"),
    "steps: 0 + 1 of line `int count = 0;`": ("survived", None),
    "steps: `count < n` -> false": ("killed", "other test"),
    "steps: `count < n` -> <=": ("survived", None),
    "steps: drop `count += 1`": ("hang", "other test"),
    "steps: 1 + 1 of line `count += 1;`": ("survived", None),
    "loose: `a + 1e-9` -> -": ("survived", None),
    "never: `-a` without -": ("unreached", None),
}


def build(work):
    """The toy's changes, and its judges."""
    library = work / "library"
    library.mkdir()
    (library / "toy.hpp").write_text(HEADER)
    changed, mutants = rewrite(library, ["toy.hpp"], [])
    headers = work / "include/goishi"
    headers.mkdir(parents=True)
    (headers / "toy.hpp").write_bytes(changed["toy.hpp"])
    shutil.copy(HERE / "mutation.hpp", headers)
    judges = []
    for kind, source in (("proof", PROOF), ("test", TESTS), ("claim", CLAIMS)):
        (work / f"{kind}.cpp").write_text(source)
        subprocess.run([os.environ.get("CXX", "c++"), "-std=c++20", "-I", work / "include", "-I", HERE.parent.parent,
                        work / f"{kind}.cpp", "-o", work / kind], check=True)
        judges.append(programs.Program(work / kind, kind, "proof"))
    return mutants, judges


def swept(work, judges, mutants, shard, shards):
    """The file of a shard."""
    keys = sorted(m.key() for m in mutants)
    head = {"schema": 1, "commit": "toy", "source": results.digest("toy"), "filter": "*", "sample": None, "seed": 1,
            "judges": list(programs.KINDS), "work": None, "shard": [shard, shards], "changes": len(keys),
            "keys": results.digest("\n".join(keys))}
    here = [m for m in mutants if results.shard_of(m.key(), shards) == shard]
    out = work / f"{shard}-of-{shards}.jsonl"
    with contextlib.redirect_stderr(io.StringIO()):
        sweep.Sweep(judges, {}, head, here, out).run(2)
    return out


def by(record):
    if record["by"] is None:
        return None
    return record["by"] if record["family"] == "proof" else f"{record['by']} {record['family']}"


def check_verdicts(records):
    found = {f"{r['function']}: {r['what']}": (r["verdict"], by(r)) for r in records}
    for what in sorted({*found, *EXPECTED}):
        if found.get(what) != EXPECTED.get(what):
            yield f"{what}: {found.get(what)} in place of {EXPECTED.get(what)}"


def check_shards(work, judges, mutants):
    files = {n: [swept(work, judges, mutants, k, n) for k in range(1, n + 1)] for n in (1, 2, 8)}
    bytes_of = set()
    for shards in files.values():
        out = work / "merged.jsonl"
        results.write(out, *results.merged(shards[::-1]))
        bytes_of.add(out.read_bytes())
    if len(bytes_of) != 1:
        yield "1, 2 and 8 shards together are not the same bytes"
    one, two = files[2]
    yield from check_refusals(work, one, two, files[8][0])
    # What an interrupted run has done is kept, but for the line that was cut.
    lines = one.read_text().splitlines(keepends=True)
    partial = one.with_name(one.name + ".partial")
    partial.write_text(lines[0] + lines[1] + lines[2][:20])
    before = one.read_bytes()
    if swept(work, judges, mutants, 1, 2).read_bytes() != before or partial.exists():
        yield "an interrupted run does not end as one that was not"
    partial.write_text(lines[0].replace('"toy"', '"other"'))
    yield from refuses("a start of another run", "is of another run", lambda: swept(work, judges, mutants, 1, 2))


def refuses(what, says, action):
    try:
        action()
    except results.BadInput as error:
        if says not in str(error) or "\n" in str(error):
            yield f"{what}: says '{error}'"
    else:
        yield f"{what} is not refused"


def check_refusals(work, one, two, eighth):
    def changed(old, new):
        text = two.read_text()
        if old not in text:
            raise RuntimeError(f"the self-test has no '{old}' to change")
        file = work / f"changed{len(list(work.glob('changed*')))}.jsonl"
        file.write_text(text.replace(old, new, 1))
        return file

    first_key = two.read_text().splitlines()[1]
    cases = {
        "a missing shard": ([one], "shard 2 of 2 is missing"),
        "a doubled shard": ([one, two, two], "is there already"),
        "a shard of another number": ([one, eighth], "number of shards"),
        "a shard of another source": ([one, changed(results.digest("toy"), results.digest("other"))], "another source"),
        "a shard of another commit": ([one, changed('"commit":"toy"', '"commit":"other"')], "another commit"),
        "a corrupt line": ([one, changed('"verdict":', '"verdict"')], "line 2"),
        "an unknown verdict": ([one, changed('"verdict":"', '"verdict":"un')], "line 2"),
        "a line that is missing": ([one, changed(first_key + "\n", "")], "some are missing"),
        "a line that is doubled": ([one, changed(first_key, first_key + "\n" + first_key)], "is there twice"),
        "a file without a head": ([one, changed(two.read_text().splitlines()[0] + "\n", "")], "line 1"),
        "no file": ([work / "none.jsonl"], "none.jsonl"),
    }
    for what, (files, says) in cases.items():
        files = [pathlib.Path(shutil.copy(file, work / f"case{i}.jsonl")) if file.exists() else file
                 for i, file in enumerate(files)]
        yield from refuses(what, says, lambda files=files: results.merged(files))


def check_report(work, head, records):
    """What is published, in a tree of its own; and that counts may not rise."""
    root = work / "tree"
    (root / "verify/mutation").mkdir(parents=True)
    shutil.copy(HERE / "page.html", root / "verify/mutation")
    readme = root / "verify/README.md"
    readme.write_text("before\n<!-- verify/mutants -->\nstale\n<!-- end -->\nafter\n")
    report.write(head, records, root, datetime.date(2026, 1, 2))
    written, page = readme.read_text(), (root / "build/report/mutants.html").read_text()
    row = "| top | 12 | 6 | 0 | 1 | 0 | 4 | 1 | 64 % |"
    if row not in written or "stale" in written or "2026-01-02" not in written or "after" not in written:
        yield f"the README is not as it must be: {written}"
    for part in (row.split("|")[1].strip(), ": loose: `a + 1e-9` -&gt; -", "never: `-a` without -"):
        if part not in page:
            yield f"the page has no '{part}'"
    if results.read(root / "build/report/mutants.jsonl")[1] != records:
        yield "the published results are not those"
    if report.rises(head, records, root):
        yield "the counts rise without a change"
    counts = root / "verify/mutation/survivors.json"
    counts.write_text(counts.read_text().replace("4", "3"))
    if report.rises(head, records, root) != ["RISES     src/goishi/toy.hpp: 4 survivors, 3 until now"]:
        yield "a count that rises is not seen"
    yield from refuses("a count of another sample", "of another sample",
                       lambda: report.rises({**head, "seed": 2}, records, root))
    readme.write_text("nothing")
    yield from refuses("a README without the part", "has no part",
                       lambda: report.write(head, records, root, datetime.date(2026, 1, 2)))


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        mutants, built = build(work)
        judges = sweep.Judges(*programs.measured(built, 2))
        head, records = results.merged([swept(work, judges, mutants, 1, 1)])
        wrong = [*check_verdicts(records), *check_shards(work, judges, mutants), *check_report(work, head, records)]
        cheapest = sweep.Judges(judges.units, judges.constant, 1)
        loose = next(m for m in mutants if m.function == "is_small" and m.what.endswith("<="))
        if cheapest.verdict(loose) != ("survived", None, 1):
            wrong.append(f"with the least work: {cheapest.verdict(loose)}")
        blind, count = sweep.blind(judges, mutants, 1, 10, 1)
        if blind.keys() != {"other"} or count != 2:
            wrong.append(f"the blind claim is not found: {blind}")
    for line in wrong:
        print(f"self-test: {line}")
    if not wrong:
        print(f"self-test passed: {len(EXPECTED)} changes have the verdicts that they must have")
    return 1 if wrong else 0
