"""The changed text of a header, and the list of its changes."""

import dataclasses


@dataclasses.dataclass
class Mutant:
    header: str
    function: str
    line: int
    what: str  # names it, with header and function
    code: int  # what the program reads from the environment: 4 × place + change
    formula: bool

    def key(self):
        return f"{self.header} {self.function}: {self.what}"


class Edits:
    """One header: `edits` make the changed copy, in which each place asks whether it is its turn; `mutants` are the changes."""

    def __init__(self, header, source, first_place):
        self.header, self.source, self.place = header, source, first_place
        self.edits, self.mutants = [], []
        self.function, self.live, self.in_formula = "", False, False

    def rewritten(self):
        text, at = [], 0
        for start, _, _, _, end, insertion in sorted(self.edits):
            text += [self.source[at:start], insertion.encode()]
            at = end
        return b"".join(text) + self.source[at:]

    def open(self, start, end, insertion):
        self.edits.append((start, 1, -end, len(self.edits), start, insertion))

    def close(self, start, end, text=")"):
        self.edits.append((end, 0, -start, -len(self.edits), end, text))

    def replace(self, start, end, insertion):
        self.edits.append((start, 2, 0, 0, end, insertion))

    def place_text(self):
        return f"::goishi::mutant::live({self.place})" if self.live else str(self.place)

    def wrap(self, node, name, rest=""):
        """`name(place, node)`, a place of its own."""
        self.open(node.start, node.end, f"::goishi::mutant::{name}({self.place_text()}, ")
        self.close(node.start, node.end, f"{rest})")
        self.place += 1

    def wrap_operator(self, node, name, operator):
        """`name(place, left, right)`."""
        symbol, at, _, _ = operator
        self.open(node.start, node.end, f"::goishi::mutant::{name}({self.place_text()}, ")
        self.replace(at, at + len(symbol), ",")
        self.close(node.start, node.end)
        self.place += 1

    def add(self, node, what, change):
        """A change of the place that comes next."""
        self.mutants.append(
            Mutant(self.header, self.function, node.line(), what, 4 * self.place + change, self.in_formula))
