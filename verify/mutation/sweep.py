"""Judges changes: by the proofs, tests and claims that come to their place, until one fails."""

import concurrent.futures
import itertools
import pathlib
import sys
import threading
import time

from mutation import results


class Judges:
    """All units, by the places that they come to."""

    def __init__(self, units, constant, most_work=None):
        self.units, self.constant, self.most_work = units, constant, most_work

    def reaching(self, mutant):
        return [unit for unit in self.units if mutant.code // 4 in unit.places]

    def asked(self, mutant):
        """Those that are asked: the cheapest, until they pass as many places as may be; and how many are left."""
        units, work = self.reaching(mutant), 0
        chosen = set()
        for unit in sorted(units, key=lambda unit: unit.work):
            work += unit.work
            if self.most_work and work > self.most_work and chosen:
                break
            chosen.add(id(unit))
        return [unit for unit in units if id(unit) in chosen], len(units) - len(chosen)

    def verdict(self, mutant):
        """(verdict, the unit that notices, how many were not asked)."""
        units, left = self.asked(mutant)
        if not units:
            return "none" if mutant.code // 4 in self.constant else "unreached", None, 0
        for program, of_it in itertools.groupby(units, key=lambda unit: unit.program):
            verdict, by = program.judge(list(of_it), mutant.code)
            if by is not None:
                return verdict, by, 0
        return "survived", None, left


class Sweep:
    """The changes of one shard, one after the other. What is done is kept beside the result until all is."""

    def __init__(self, judges, listed, head, mutants, out):
        self.judges, self.listed, self.head, self.out = judges, listed, head, pathlib.Path(out)
        self.mutants = sorted(mutants, key=lambda mutant: mutant.key())
        self.partial = self.out.with_name(self.out.name + ".partial")
        self.lock = threading.Lock()

    def record(self, mutant):
        verdict, by, left = self.judges.verdict(mutant)
        if verdict == "survived" and mutant.key() in self.listed:
            verdict = "equivalent"
        return {"key": mutant.key(), "header": mutant.header, "line": mutant.line, "function": mutant.function,
                "what": mutant.what, "formula": mutant.formula, "verdict": verdict,
                "by": by.name if by else None, "family": by.family if by else None, "left": left}

    def resumed(self):
        """What an earlier run of the same has done; a line that was cut short is done again."""
        if not self.partial.exists():
            return []
        text = self.partial.read_text()
        lines = text[:text.rfind("\n") + 1].splitlines()
        records = [results.parse_line(self.partial, i + 1, line) for i, line in enumerate(lines)]
        if not records or records[0] != self.head:
            raise results.BadInput(f"{self.partial}: is of another run: remove it, or give another --out")
        return records[1:]

    def run(self, jobs):
        """Writes the result; returns its records."""
        records = self.resumed()
        known = {record["key"] for record in records}
        left = [mutant for mutant in self.mutants if mutant.key() not in known]
        self.partial.write_text(results.line_of(self.head) + "".join(map(results.line_of, records)))
        start, done = time.monotonic(), 0
        with self.partial.open("a") as file, concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            futures = [pool.submit(self.record, mutant) for mutant in left]
            for future in concurrent.futures.as_completed(futures):
                record = future.result()
                records.append(record)
                file.write(results.line_of(record))
                file.flush()
                done += 1
                show_progress(done, len(left), time.monotonic() - start)
        results.write(self.out, self.head, records)
        self.partial.unlink()
        return sorted(records, key=lambda record: record["key"])


def show_progress(done, total, seconds):
    left = seconds / done * (total - done)
    if sys.stderr.isatty():
        end = "\n" if done == total else ""
        print(f"\r\033[K{done} of {total} changes, {left / 60:.0f} min left", end=end, file=sys.stderr, flush=True)
    elif done % 50 == 0 or done == total:
        print(f"{done} of {total} changes, {left / 60:.0f} min left", file=sys.stderr, flush=True)


def blind(judges, mutants, jobs, tries, seed):
    """Claims that notice none of so many changes that they come to, each run against them alone: name → how many were tried."""

    def notices(unit):
        reached = [m for m in mutants if m.code // 4 in unit.places]
        drawn = results.sample_of(reached, tries, f"{seed} {unit.name}")
        return any(unit.program.judge([unit], m.code)[1] is not None for m in drawn), len(drawn)

    claims = [unit for unit in judges.units if unit.program.kind == "claim"]
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        answers = list(pool.map(notices, claims))
    return {unit.name: tried for unit, (noticed, tried) in zip(claims, answers) if not noticed}, len(claims)
