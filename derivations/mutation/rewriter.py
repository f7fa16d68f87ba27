"""Finds what can be changed in the formulas, and writes the copy in which it is."""

import dataclasses
import re

from mutation import source

# Types whose values have a sign and a size; of others (a stone, a body) only the parts are changed.
NUMERIC = {"T", "S", "Vec3", "Mat3", "Quat", "Eigen::Matrix", "int", "std::size_t"}
# `T(x)` is x: no place of its own.
CONVERSIONS = {"T", "S", "Vec3", "Mat3", "Quat", "static_cast"}
# To change an argument of these is to change the result, which has a place already.
LINEAR = {"dot", "cross", "scaled", "cwiseProduct", "cwiseQuotient", "sq"}
EVEN = {"cos"}


@dataclasses.dataclass
class Mutant:
    header: str
    function: str
    line: int
    what: str  # names it, with header and function
    code: int  # what the program reads from the environment

    def key(self):
        return f"{self.header} {self.function}: {self.what}"


class Rewriter:
    """One header with its places: `insertions` make the changed copy, `mutants` are the changes."""

    def __init__(self, library, header, first_place):
        self.library, self.header, self.place = library, header, first_place
        self.source, self.tokens = library.sources[header], library.tokens[header]
        self.insertions, self.mutants = [], []
        for function in library.functions[header]:
            self.function = function
            self.variables = self.declared()
            self.fix()
            self.walk()
        seen = {}
        for mutant in self.mutants:
            count = seen[mutant.key()] = seen.get(mutant.key(), 0) + 1
            if count > 1:
                mutant.what += f" #{count}"

    def rewritten(self):
        text, at = [], 0
        for position, _, insertion in sorted(self.insertions):
            text += [self.source[at:position], insertion]
            at = position
        return "".join(text) + self.source[at:]

    def declared(self):
        """The types of the function's parameters and variables."""
        variables = {}
        for i in range(self.function.begin, self.function.end):
            if self.tokens[i].kind != "name" or self.tokens[i - 1].text in ("::", ".", "->"):
                continue
            head, j = source.head_of(self.tokens, i)
            while self.tokens[j].text == "&":
                j += 1
            if self.tokens[j].kind == "name" and self.tokens[j + 1].text in ("=", ",", ";", "(", ")", "{"):
                if head not in ("return", "const", "constexpr"):
                    variables.setdefault(self.tokens[j].text, head)
        return variables

    def fix(self):
        """Marks what is not changed."""
        t = self.tokens

        def mark(begin, end):
            for k in range(begin, end + 1):
                t[k].fixed = True

        counting = set()  # local functions of an index
        body, end = self.function.body, self.function.end
        for i in range(body, end):
            if t[i].text in ("[", "<") and t[i].partner > i:
                mark(i, t[i].partner)
            if t[i].text == "]" and t[i + 1].text == "(" and t[t[i].partner - 1].text in ("=", "(", ","):
                mark(i + 1, t[i + 1].partner)
                if t[i + 2].text in ("int", "std"):
                    counting.add(t[t[i].partner - 2].text)
            if t[i].text == "for":
                mark(i + 1, t[i + 1].partner)
            if t[i].text == "constexpr":
                mark(i, next(k for k in range(i, end) if t[k].text == ";"))
            if t[i].text == "->":  # a local function that returns a reference
                brace = next(k for k in range(i, end) if t[k].text == "{")
                mark(i, t[brace].partner)
            if t[i].text == "?":
                k = i - 1
                while t[k].text not in ("(", "{", ",", "=", "return"):
                    k = t[k].partner - 1 if 0 <= t[k].partner < k else k - 1
                mark(k + 1, i - 1)
        for i in range(body, end):
            if t[i].text in counting and t[i + 1].text == "(":
                mark(i + 1, t[i + 1].partner)

    def ends_operand(self, i):
        token = self.tokens[i]
        if token.kind == "name":
            return token.text != "return"
        return token.kind == "number" or token.text in (")", "]") or (token.text == ">" and token.partner >= 0)

    def term_end(self, i):
        """One past the term that begins at token i."""
        while self.tokens[i].text == "-":
            i += 1
        while True:
            text = self.tokens[i].text
            if self.tokens[i].partner > i:
                i = self.tokens[i].partner + 1
                continue
            if text in (",", ";", ")", "]", "}", "?", ":", "<<", "<", ">", "<=", ">=", "==", "!=", "&&", "||"):
                return i
            if text in "+-" and self.ends_operand(i - 1):
                return i
            i += 1

    def terms_in(self, bracket):
        """How many terms and arguments a bracket holds."""
        i, terms, arguments = bracket + 1, 0, 1
        while i < self.tokens[bracket].partner:
            end = self.term_end(i)
            terms += 1
            arguments += self.tokens[end].text == ","
            i = end + 1
        return terms, arguments

    def called(self, bracket):
        """The name before a bracket, if it is a call or a conversion."""
        i = bracket - 1
        if self.tokens[i].text == ">" and self.tokens[i].partner >= 0:
            i = self.tokens[i].partner - 1
        return self.tokens[i].text if self.tokens[i].kind == "name" and self.tokens[i].text != "return" else ""

    def is_group(self, bracket):
        """Whether a bracket only groups: `(…)`, `T(…)` with one argument."""
        name = self.called(bracket)
        groups = self.tokens[bracket].text == "(" and (name == "" or name in CONVERSIONS)
        return groups and self.terms_in(bracket)[1] == 1

    def starts_term(self, i):
        t, before = self.tokens, self.tokens[i - 1].text
        if t[i].kind == "sign" and t[i].text not in ("(", "-"):
            return False
        if t[i].text == "-" and self.ends_operand(i - 1):
            return False
        if t[i].kind == "name" and t[i].text in ("for", "const", "return", "constexpr"):
            return False
        if before in (",", "{") and t[i].kind == "name" and t[i + 1].text in ("=", "("):
            declarator = before == "," and self.in_declaration(i)
            if t[i + 1].text == "=" or declarator:
                return False
        if before in ("+", "-"):
            return self.ends_operand(i - 2)
        if before == "=":  # a reference is another name, no formula
            return t[i - 3].text != "&"
        if before == "{":
            bracket = i - 1
            return t[bracket - 1].text in ("return", "=", ",", "(", "{", ">") or self.called(bracket) != ""
        return before in ("return", "(", ",", "+=", "-=", "<<", "?", ":")

    def in_declaration(self, i):
        """Whether a comma stands between declared variables."""
        k = i - 1
        while self.tokens[k].text not in (";", "{", "(", "}"):
            k = self.tokens[k].partner - 1 if 0 <= self.tokens[k].partner < k else k - 1
        streams = self.tokens[k + 2].text == "<<"  # a matrix, entry by entry
        return not streams and (self.tokens[k].text in (";", "}") or k == self.function.body)

    def is_numeric(self, begin, end):
        """Whether a term that is only a name, `a.b`, `a[i].b` or `f(…)`, has a sign and a size."""
        t = self.tokens
        i = begin
        if t[i].kind != "name":
            return True
        if t[i].text == "formula" and t[i + 1].text == "::":
            i += 2
        if t[i].text not in self.variables:
            after = t[i + 1].partner + 1 if t[i + 1].text == "<" and t[i + 1].partner > 0 else i + 1
            only_call = t[after].text == "(" and t[after].partner + 1 == end
            return not only_call or self.library.results.get(t[i].text, "T") in NUMERIC
        kind = self.variables[t[i].text]
        i += 1
        while i < end:
            if t[i].text == "[":
                kind = kind.removeprefix("std::array:") if kind.startswith("std::array:") else "T"
                i = t[i].partner + 1
            elif t[i].text == "." and t[i + 1].kind == "name":
                kind = self.library.fields.get(kind, {}).get(t[i + 1].text, "T")
                i += 2
            else:
                return True
        return kind in NUMERIC

    def walk(self):
        for i in range(self.function.body + 1, self.function.end):
            token = self.tokens[i]
            if token.fixed:
                continue
            if self.starts_term(i):
                self.add_term(i)
            if token.kind == "number":
                self.add_number(i)

    def text(self, begin, end):
        return re.sub(r"\s+", " ", self.source[self.tokens[begin].start:self.tokens[end - 1].end])

    def add(self, i, what, change):
        line = self.source.count("\n", 0, self.tokens[i].start) + 1
        self.mutants.append(Mutant(self.header, self.function.name, line, what, 2 * self.place + change))

    def wrap(self, begin, end, name):
        first, last = self.tokens[begin].start, self.tokens[end - 1].end
        # Of brackets that open at one place, the longest first; of those that close, the shortest.
        self.insertions.append((first, -last, f"::goishi::mutant::{name}({self.place}, "))
        self.insertions.append((last, -(10**9) - first, ")"))
        self.place += 1

    def add_term(self, i):
        t = self.tokens
        end = self.term_end(i)
        before = t[i - 1].text
        sign, size = True, True
        if before in ("(", ","):
            bracket = self.enclosing(i)
            if t[bracket].text == "(":
                alone = before == "(" and t[end].text in (")",) or t[end].text in (",", ")")
                name = self.called(bracket)
                if alone and (self.is_group(bracket) or name in LINEAR):
                    return
                sign = not (alone and name in EVEN)
        # A number alone has a place of its own; so has the size of a term with a number as a factor.
        factors = self.number_factors(i, end)
        if factors:
            size = False
            if end - i <= 4 and set(factors) == {"0"}:
                return
        if not self.is_numeric(i, end):
            return
        leading = before not in ("+", "-")
        if leading and self.only_group(i, end):
            return
        if sign:
            self.add(i, f"sign of `{self.text(i, end)}`", 0)
        if size:
            self.add(i, f"size of `{self.text(i, end)}`", 1)
        if sign or size:
            self.wrap(i, end, "term")

    def enclosing(self, i):
        k = i - 1
        while self.tokens[k].partner <= k:
            k = self.tokens[k].partner - 1 if 0 <= self.tokens[k].partner < k else k - 1
        return k

    def only_group(self, i, end):
        """Whether a term is nothing but a group of several terms, which have places of their own."""
        bracket = i
        while self.tokens[bracket].text != "(" and bracket < end:
            bracket = self.tokens[bracket].partner + 1 if self.tokens[bracket].partner > bracket else bracket + 1
        if bracket >= end or self.tokens[bracket].partner + 1 != end or not self.is_group(bracket):
            return False
        first = bracket
        if self.called(bracket):
            first -= 1
            if self.tokens[first].text == ">":
                first = self.tokens[first].partner - 1
        if first != i:
            return False
        return self.terms_in(bracket)[0] > 1 or self.only_group(bracket + 1, self.tokens[bracket].partner)

    def number_factors(self, i, end):
        """The numbers that are factors of a term, as `2` in `T(2) * x`."""
        numbers, t = [], self.tokens
        while i < end:
            if t[i].text == "T" and t[i + 1].text == "(" and t[i + 2].kind == "number" and t[i + 3].text == ")":
                numbers.append(t[i + 2].text)
            elif t[i].kind == "number":
                numbers.append(t[i].text)
            i = t[i].partner + 1 if t[i].partner > i else i + 1
        return numbers

    def add_number(self, i):
        begin = i
        while not self.starts_term(begin) or self.term_end(begin) <= i or self.only_number(begin, self.term_end(begin)):
            begin -= 1
            if begin <= self.function.body or self.tokens[begin].text in (";", "{"):
                begin = i - 2 if self.tokens[i - 1].text == "(" else i
                break
        context = self.text(begin, max(self.term_end(begin), i + 1))
        self.add(i, f"{self.tokens[i].text} + 1 in `{context}`", 0)
        self.wrap(i, i + 1, "number")

    def only_number(self, begin, end):
        return end - begin == 1 and self.tokens[begin].kind == "number"


def rewrite(library):
    """The changed headers, and all changes."""
    changed, mutants, place = {}, [], 0
    for header in library.sources:
        rewriter = Rewriter(library, header, place)
        place = rewriter.place
        changed[header] = rewriter.rewritten()
        mutants += rewriter.mutants
    return changed, mutants
