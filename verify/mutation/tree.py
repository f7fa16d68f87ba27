"""The library's headers as syntax trees, by libclang: all of them as one unit."""

import pathlib

from clang import cindex
from clang.cindex import CursorKind as K

WRAPPERS = (K.UNEXPOSED_EXPR, K.PAREN_EXPR)


class Node:
    """A cursor with its place in the header's bytes."""

    def __init__(self, cursor, source):
        self.cursor, self.source = cursor, source
        self.kind = cursor.kind
        self.start, self.end = cursor.extent.start.offset, cursor.extent.end.offset
        self._children = None

    @property
    def children(self):
        if self._children is None:
            self._children = [Node(c, self.source) for c in self.cursor.get_children()]
        return self._children

    @property
    def type(self):
        return self.cursor.type.spelling

    @property
    def is_expression(self):
        return self.kind.is_expression()

    def text(self):
        return " ".join(self.source[self.start:self.end].decode().split())

    def line(self):
        return self.cursor.extent.start.line

    def bare(self):
        """Without brackets and implicit conversions around it."""
        node = self
        while node.kind in WRAPPERS:
            inner = [c for c in node.children if c.is_expression]
            if len(inner) != 1:
                break
            node = inner[0]
        return node

    def operator(self):
        """(symbol, where it begins, left, right) of an operation with two operands, written as such; or None."""
        if self.kind not in (K.BINARY_OPERATOR, K.CALL_EXPR, K.COMPOUND_ASSIGNMENT_OPERATOR):
            return None
        parts = [c for c in self.children if c.is_expression]
        if len(parts) == 3:  # an overloaded operator stands between
            parts = sorted(parts, key=lambda part: part.start)
            del parts[1]
        if len(parts) != 2:
            return None
        left, right = parts
        if left.start != self.start or right.end != self.end or right.start < left.end:
            return None
        between = self.source[left.end:right.start]
        symbol = between.strip()
        if not symbol or not all(byte in b"+-*/%<>=!&|^" for byte in symbol):
            return None
        return symbol.decode(), left.end + between.index(symbol), left, right

    def arguments(self):
        """What stands in the last brackets of a call, a conversion or a list, and where they open."""
        last = self.source[self.end - 1:self.end]
        if last not in (b")", b"}"):
            return [], self.end
        depth, at = 0, self.end - 1
        while True:
            byte = self.source[at:at + 1]
            depth += byte in (b")", b"}")
            depth -= byte in (b"(", b"{")
            if depth == 0:
                return [c for c in self.children if at < c.start], at
            at -= 1

    def callee(self):
        """The text before the arguments."""
        _, bracket = self.arguments()
        return self.source[self.start:bracket].decode().strip()

    def unary(self):
        """The operand, if this is `-x` or `!x`; else None."""
        if self.kind not in (K.UNARY_OPERATOR, K.CALL_EXPR):
            return "", None
        symbol = self.source[self.start:self.start + 1].decode()
        parts = [c for c in self.children if c.is_expression]
        if symbol in ("-", "!") and parts and self.start < parts[-1].start and parts[-1].end == self.end:
            return symbol, parts[-1]
        return "", None


def parse(folder, headers, flags):
    """header -> its top cursors, in order."""
    unit_name = "all_headers.cpp"
    text = "".join(f'#include "{folder / header}"\n' for header in headers)
    index = cindex.Index.create()
    unit = index.parse(unit_name, args=["-std=c++20", *flags], unsaved_files=[(unit_name, text)])
    errors = [str(d) for d in unit.diagnostics if d.severity >= cindex.Diagnostic.Error]
    if errors:
        raise RuntimeError(f"libclang cannot read the headers: {errors[0]}")
    names = {str(folder / header): header for header in headers}
    cursors = {header: [] for header in headers}
    for cursor in unit.cursor.get_children():
        file = cursor.location.file
        header = names.get(str(pathlib.Path(file.name))) if file else None
        if header is not None:
            cursors[header].append(cursor)
    return unit, cursors
