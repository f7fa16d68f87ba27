"""What the suite catches: as text, as a table for the README, as a page, and the counts that may not rise."""

import html
import json
import re

from mutation import results

SURVIVORS = "verify/mutation/survivors.json"
COLUMNS = (("changes", lambda c: sum(c.values()) - c["none"]), ("killed", lambda c: c["killed"]),
           ("crash", lambda c: c["crash"]), ("hang", lambda c: c["hang"]), ("equivalent", lambda c: c["equivalent"]),
           ("survived", lambda c: c["survived"]), ("unreached", lambda c: c["unreached"]), ("noticed", results.rate))


def rows_by_folder(records):
    """The table by folder: a head, rows, and the sum."""
    table = results.counts(records, lambda r: results.folder_of(r["header"]))
    total = results.counts(records, lambda r: "all")
    rows = [[folder, *(str(f(counter)) for _, f in COLUMNS)] for folder, counter in {**table, **total}.items()]
    return [["folder", *(name for name, _ in COLUMNS)], *rows]


def rows_by_family(records):
    """Who noticed first. The cheapest is asked first, so that it says nothing about the others."""
    table = results.counts([r for r in records if r["family"]], lambda r: r["family"])
    dead = sum(results.dead(counter) for counter in table.values())
    rows = sorted(((results.dead(counter), family) for family, counter in table.items()), reverse=True)
    return [["noticed first by", "changes", "share"],
            *([family, str(count), f"{100 * count / dead:.0f} %"] for count, family in rows)]


def lines_of(records, verdict):
    chosen = sorted((r for r in records if r["verdict"] == verdict), key=lambda r: (r["header"], r["line"], r["what"]))
    return [f"src/goishi/{r['header']}:{r['line']}: {r['function']}: {r['what']}"
            + (f" ({r['left']} dearer not asked)" if r["left"] else "") for r in chosen]


def aligned(rows):
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    return "".join("  ".join(cell.ljust(w) if i == 0 else cell.rjust(w) for i, (cell, w) in enumerate(zip(row, widths)))
                   .rstrip() + "\n" for row in rows)


def text(records):
    told = [f"{verdict.upper():10}{line}\n" for verdict in results.ALIVE for line in lines_of(records, verdict)]
    return "".join(told) + aligned(rows_by_folder(records)) + "\n" + aligned(rows_by_family(records))


# --- the counts that may not rise


def selection(head):
    return {name: head[name] for name in ("filter", "sample", "seed", "work")}


def rises(head, records, root):
    """A line for each header that has more survivors than are written down."""
    known = json.loads((root / SURVIVORS).read_text())
    if selection(known) != selection(head):
        raise results.BadInput(f"{SURVIVORS}: is of another sample: {selection(known)}")
    return [f"RISES     src/goishi/{header}: {count} survivors, {known['survivors'].get(header, 0)} until now"
            for header, count in results.survivors_by_header(records).items()
            if known["survivors"].get(header, 0) < count]


# --- what is published


def markdown(rows):
    lines = ["| " + " | ".join(row) + " |" for row in rows]
    lines.insert(1, "|---" + "|---:" * (len(rows[0]) - 1) + "|")
    return "\n".join(lines)


def what_was_run(head, date):
    part = "all changes" if head["sample"] is None else f"{head['sample']} of the changes, drawn with seed {head['seed']}"
    where = "" if head["filter"] == "*" else f", of the headers `{head['filter']}`"
    asked = "" if head["work"] is None else (
        f" Of what comes to a change, the cheapest are asked, until they pass {head['work']:g}·10⁹ places.")
    commit = head["commit"][:10] + ("-dirty" if head["commit"].endswith("-dirty") else "")
    return f"{date.isoformat()}, commit {commit}: {part}{where}.{asked}"


def replaced(document, name, text):
    begin, end = f"<!-- {name} -->", "<!-- end -->"
    pattern = re.compile(re.escape(begin) + r".*?" + re.escape(end), re.S)
    if len(pattern.findall(document)) != 1:
        raise results.BadInput(f"verify/README.md: has no part '{begin}' … '{end}'")
    return pattern.sub(lambda _: f"{begin}\n\n{text}\n\n{end}", document)


def html_table(rows):
    def row(cells, tag):
        return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in cells) + "</tr>\n"

    return f"<table>\n<thead>{row(rows[0], 'th')}</thead>\n<tbody>{''.join(row(r, 'td') for r in rows[1:])}</tbody>\n</table>\n"


def page(head, records, date, template):
    def listed(verdict):
        items = "".join(f"<li><code>{html.escape(line)}</code></li>\n" for line in lines_of(records, verdict))
        return f"<ul>\n{items}</ul>\n" if items else "<p>None.</p>\n"

    parts = {"run": html.escape(what_was_run(head, date)), "folders": html_table(rows_by_folder(records)),
             "families": html_table(rows_by_family(records)),
             **{verdict: listed(verdict) for verdict in (*results.ALIVE, "equivalent")}}
    return re.sub(r"@(\w+)@", lambda match: parts[match.group(1)], template)


def write(head, records, root, date):
    """The table in the README, the page and its figures, and the counts."""
    readme = root / "verify/README.md"
    tables = "\n\n".join((what_was_run(head, date), markdown(rows_by_folder(records)), markdown(rows_by_family(records))))
    document = replaced(readme.read_text(), "verify/mutants", tables)
    template = (root / "verify/mutation/page.html").read_text()
    folder = root / "build/report"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "mutants.html").write_text(page(head, records, date, template))
    results.write(folder / "mutants.jsonl", {**head, "shard": [1, 1]}, records)
    counts = {**selection(head), "survivors": results.survivors_by_header(records)}
    (root / SURVIVORS).write_text(json.dumps(counts, indent=1) + "\n")
    readme.write_text(document)
