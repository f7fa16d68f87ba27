"""Results as JSON lines: shards that are pure functions of their arguments, and what several of them are together."""

import collections
import hashlib
import json
import os
import pathlib

import jsonschema

SCHEMA = json.loads((pathlib.Path(__file__).with_name("results.schema.json")).read_text())
DEAD = ("killed", "hang", "crash")
ALIVE = ("survived", "unreached")


class BadInput(Exception):
    """A file that is not as it must be; the message says which."""


def digest(text):
    return hashlib.sha256(text.encode()).hexdigest()


def shard_of(key, shards):
    return 1 + int(digest(key), 16) % shards


def sample_of(mutants, count, seed):
    """Those whose hashes are least: what a change of other places leaves as it is."""
    return sorted(mutants, key=lambda m: digest(f"{seed} {m.key()}"))[:count]


def line_of(record):
    return json.dumps(record, ensure_ascii=False, separators=(",", ":"), sort_keys=True) + "\n"


def parse_line(file, number, line):
    """A line of a file, judged by the schema."""
    try:
        record = json.loads(line)
        jsonschema.validate(record, SCHEMA)
    except (json.JSONDecodeError, jsonschema.ValidationError) as error:
        what = error.message if isinstance(error, jsonschema.ValidationError) else str(error)
        raise BadInput(f"{file}: line {number}: {' '.join(what.split())[:200]}") from None
    return record


def read(file):
    """(head, records) of a file of results."""
    try:
        lines = pathlib.Path(file).read_text().splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise BadInput(f"{file}: {error}") from None
    if not lines:
        raise BadInput(f"{file}: it is empty")
    records = [parse_line(file, i + 1, line) for i, line in enumerate(lines)]
    if "schema" not in records[0] or any("schema" in record for record in records[1:]):
        raise BadInput(f"{file}: line 1 and no other must say what was run")
    return records[0], records[1:]


def write(file, head, records):
    """All at once, or nothing."""
    file = pathlib.Path(file)
    temporary = file.with_name(file.name + ".new")
    text = line_of(head) + "".join(line_of(r) for r in sorted(records, key=lambda r: r["key"]))
    temporary.write_text(text)
    os.replace(temporary, file)


def merged(files):
    """(head, records) of all shards of one run. Shards that are missing, doubled or of another run are refused."""
    first, records, seen = None, [], {}
    for file in files:
        head, part = read(file)
        of = {name: value for name, value in head.items() if name != "shard"}
        if first is None:
            first = of
            count = head["shard"][1]
        for name in of:
            if of[name] != first[name] or head["shard"][1] != count:
                raise BadInput(f"{file}: does not fit {files[0]}: another "
                               f"{name if of[name] != first[name] else 'number of shards'}")
        shard = head["shard"][0]
        if shard in seen:
            raise BadInput(f"{file}: shard {shard} of {count} is there already, in {seen[shard]}")
        seen[shard] = file
        for record in part:
            if shard_of(record["key"], count) != shard:
                raise BadInput(f"{file}: '{record['key']}' is not of shard {shard} of {count}")
        records += part
    missing = [str(i) for i in range(1, count + 1) if i not in seen]
    if missing:
        raise BadInput(f"shard {', '.join(missing)} of {count} is missing")
    keys = sorted(record["key"] for record in records)
    doubled = next((a for a, b in zip(keys, keys[1:]) if a == b), None)
    if doubled is not None:
        raise BadInput(f"'{doubled}' is there twice")
    if digest("\n".join(keys)) != first["keys"]:
        raise BadInput(f"{len(keys)} of {first['changes']} changes are there: some are missing, or of another run")
    return {**first, "shard": [1, 1]}, sorted(records, key=lambda r: r["key"])


# --- what they say


def folder_of(header):
    """`drop/phases/x.hpp` is of drop, `rotation.hpp` of the top."""
    return header.split("/")[0] if "/" in header else "top"


def counts(records, group):
    """group → verdict → number, for all groups that `group` gives, by name."""
    table = collections.defaultdict(collections.Counter)
    for record in records:
        table[group(record)][record["verdict"]] += 1
    return dict(sorted(table.items()))


def dead(counter):
    return sum(counter[verdict] for verdict in DEAD)


def rate(counter):
    """Of those that something reaches and that are not equivalent, how many are noticed."""
    reached = dead(counter) + counter["survived"]
    return f"{100 * dead(counter) / reached:.0f} %" if reached else "–"


def survivors_by_header(records):
    return dict(sorted(collections.Counter(r["header"] for r in records if r["verdict"] == "survived").items()))
