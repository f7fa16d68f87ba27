"""The formulas' headers as tokens: brackets in pairs, function templates, the types of fields."""

import dataclasses
import re

TOKEN = re.compile(r"//[^\n]*|\s+|(?P<number>\d[\d']*)|(?P<name>[A-Za-z_]\w*)|"
                   r"(?P<sign>::|->|<<|<=|>=|==|!=|&&|\|\||\+=|-=|\+\+|--|.)", re.S)


@dataclasses.dataclass
class Token:
    kind: str
    text: str
    start: int
    end: int
    partner: int = -1  # index of the bracket that belongs to this one
    fixed: bool = False  # within what is not changed: a subscript, a template's arguments, a loop's head


def tokenize(source):
    tokens = []
    for match in TOKEN.finditer(source):
        if match.lastgroup:
            tokens.append(Token(match.lastgroup, match.group(), match.start(), match.end()))
    pair_brackets(tokens)
    return tokens


def pair_brackets(tokens):
    """Finds partners. `<` is a bracket if what follows can be template arguments."""
    for i, token in enumerate(tokens):
        if token.text == "<" and i > 0 and tokens[i - 1].kind == "name":
            j, depth = i + 1, 1
            allowed = "<>::,+-*&" + ("=" if tokens[i - 1].text == "template" else "")
            while j < len(tokens) and depth and (tokens[j].kind != "sign" or tokens[j].text in allowed):
                depth += {"<": 1, ">": -1}.get(tokens[j].text, 0)
                j += 1
            follows = tokens[j] if j < len(tokens) else None
            after = ("(", ")", "[", "{", "::", ">", ",", "&")
            if depth == 0 and follows and (follows.kind == "name" or follows.text in after):
                token.partner, tokens[j - 1].partner = j - 1, i
    stack = []
    for i, token in enumerate(tokens):
        if token.text in ("(", "[", "{"):
            stack.append(i)
        elif token.text in (")", "]", "}") and stack:
            token.partner = stack.pop()
            tokens[token.partner].partner = i


@dataclasses.dataclass
class Function:
    name: str
    result: str
    begin: int  # of its tokens: `template`
    body: int  # its opening brace
    end: int


def head_of(tokens, i):
    """The type that begins at token i, without const and arguments, and where it ends."""
    while tokens[i].text == "const":
        i += 1
    text = tokens[i].text
    while tokens[i + 1].text == "::":
        text += "::" + tokens[i + 2].text
        i += 2
    i += 1
    inner = ""
    if tokens[i].text == "<" and tokens[i].partner > 0:
        inner = head_of(tokens, i + 1)[0]
        i = tokens[i].partner + 1
    return (text + ":" + inner if text == "std::array" else text), i


def functions_of(tokens):
    """The function templates of namespace goishi::formula."""
    found = []
    i = 0
    while i < len(tokens):
        if tokens[i].text == "namespace":
            j = i + 1
            while tokens[j].text not in "{;=":
                j += 1
            if tokens[j].text == "{" and tokens[j - 1].text == "formula":
                found += functions_between(tokens, j + 1, tokens[j].partner)
                i = tokens[j].partner
        i += 1
    return found


def functions_between(tokens, i, end):
    found = []
    while i < end:
        if tokens[i].text == "template":
            begin = i
            i = tokens[i + 1].partner + 1
            if tokens[i].text in ("struct", "class", "using", "concept"):
                continue
            while tokens[i].text == "[" or tokens[i].text in ("inline", "constexpr"):
                i = tokens[i].partner + 1 if tokens[i].text == "[" else i + 1
            result, i = head_of(tokens, i)
            name = tokens[i].text
            body = tokens[i + 1].partner + 1
            if tokens[i + 1].text != "(" or tokens[body].text != "{":
                raise ValueError(f"cannot read the function {name}, at {tokens[begin].start}")
            i = tokens[body].partner
            found.append(Function(name, result, begin, body, i))
        elif tokens[i].partner > i:
            i = tokens[i].partner
        i += 1
    return found


class Library:
    """All headers: their text, functions, and what the fields of structs and the results of functions are."""

    def __init__(self, folder):
        self.sources = {str(path.relative_to(folder)): path.read_text() for path in sorted(folder.rglob("*.hpp"))}
        self.tokens = {header: tokenize(source) for header, source in self.sources.items()}
        self.functions = {header: functions_of(tokens) for header, tokens in self.tokens.items()}
        self.results = {f.name: f.result for functions in self.functions.values() for f in functions}
        self.fields = {}
        for source in self.sources.values():
            for name, body in re.findall(r"^struct (\w+) \{\n(.*?)^\};", source, re.M | re.S):
                fields = self.fields.setdefault(name, {})
                for line in re.sub(r"//.*", "", body).splitlines():
                    match = re.match(r"\s+(\w+)(?:<[\w, ]+>)? ((?:\w+(?:, )?)+)(?: =|;)", line)
                    for field in match.group(2).split(", ") if match else []:
                        fields[field] = match.group(1)
