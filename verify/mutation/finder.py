"""Finds what can be changed in the headers, and writes the copy in which all of it can be."""

import re

from clang.cindex import CursorKind as K

from mutation import tree
from mutation.edits import Edits
from mutation.formulas import FormulaFinder

FUNCTIONS = (K.FUNCTION_DECL, K.CXX_METHOD, K.CONSTRUCTOR, K.DESTRUCTOR, K.FUNCTION_TEMPLATE, K.CONVERSION_FUNCTION)
SCOPES = (K.NAMESPACE, K.CLASS_DECL, K.STRUCT_DECL, K.CLASS_TEMPLATE, K.CLASS_TEMPLATE_PARTIAL_SPECIALIZATION,
          K.LINKAGE_SPEC, K.FRIEND_DECL)
RELATIONS = {"<": "less", ">": "greater", "<=": "less_equal", ">=": "greater_equal", "==": "equal", "!=": "not_equal"}
OPPOSITE = {"<": "<=", ">": ">=", "<=": "<", ">=": ">", "==": "!=", "!=": "=="}
ARITHMETIC = {"+": ("plus", "-"), "-": ("minus", "+"), "*": ("times", "/"), "/": ("divided", "*"), "%": ("rest", "*")}
ASSIGNMENTS = ("=", "+=", "-=", "*=", "/=", "%=", "|=", "&=")
INTEGERS = re.compile(r"(const )?(int|unsigned( int| long| char)?|long|std::size_t|size_t|std::u?int\d+_t|StoneId)$")
# Of a header, so that a change of it leaves the numbers of the others as they are; and of all (mutation.hpp).
PLACES, MOST_PLACES = 1024, 1 << 17
# What these changes do, as the program knows them (mutation.hpp).
TRUE, FALSE, OTHER = 0, 1, 2


class Finder(Edits, FormulaFinder):
    """Walks through one header."""

    # --- declarations

    def walk(self, cursor, namespace=""):
        if cursor.kind in SCOPES:
            inner = cursor.spelling if cursor.kind == K.NAMESPACE else namespace
            for child in cursor.get_children():
                self.walk(child, inner)
        elif cursor.kind in FUNCTIONS:
            self.walk_function(tree.Node(cursor, self.source), namespace == "formula")
        elif cursor.kind == K.FIELD_DECL:
            self.function, self.live, self.in_formula = cursor.spelling, False, False
            self.visit_initializer(tree.Node(cursor, self.source))

    def walk_function(self, node, is_formula):
        bodies = [c for c in node.children if c.kind == K.COMPOUND_STMT]
        if not bodies:
            return
        head = self.source[node.start:node.cursor.location.offset]
        self.function = node.cursor.spelling.split("<")[0]
        self.live = re.search(rb"\b(constexpr|consteval)\b", head) is None
        self.in_formula = is_formula and node.kind == K.FUNCTION_TEMPLATE
        member = False  # what follows a member's name is its initializer
        for child in node.children:
            if member and child.is_expression:
                self.visit(child)
            member = child.kind == K.MEMBER_REF
        self.visit(bodies[0])

    def visit_initializer(self, node):
        """Of a variable or a field."""
        name = node.cursor.location.offset
        for child in node.children:
            written = child.is_expression and name <= child.start  # and not as an argument of the type
            if written and re.search(rb"[=({]|^.$", self.source[name:child.start + 1]):
                if self.in_formula and self.is_by_value(node):
                    self.visit_value(child)
                else:
                    self.visit(child)

    def is_by_value(self, node):
        return "&" not in node.type and "*" not in node.type and "(lambda" not in node.type

    # --- statements

    def visit_all(self, nodes):
        for node in nodes:
            self.visit(node)

    def visit(self, node):
        kind = node.kind
        handler = {K.COMPOUND_STMT: self.visit_compound, K.IF_STMT: self.visit_branch, K.WHILE_STMT: self.visit_branch,
                   K.DO_STMT: self.visit_do, K.FOR_STMT: self.visit_for, K.CXX_FOR_RANGE_STMT: self.visit_range,
                   K.DECL_STMT: self.visit_declaration, K.VAR_DECL: self.visit_initializer, K.RETURN_STMT: self.visit_return,
                   K.SWITCH_STMT: self.visit_switch, K.CASE_STMT: self.visit_case,
                   K.LAMBDA_EXPR: self.visit_lambda}.get(kind)
        if handler:
            handler(node)
        elif node.is_expression:
            self.visit_expression(node)
        elif not kind.is_reference() and not kind.is_attribute() and kind not in (K.STATIC_ASSERT, K.TYPE_ALIAS_DECL,
                                                                                  K.TYPEDEF_DECL, K.USING_DECLARATION):
            self.visit_all(node.children)

    def visit_compound(self, node):
        for statement in node.children:
            if self.can_drop(statement):
                self.add(statement, f"drop `{statement.text()}`", TRUE)
                end = self.source.index(b";", statement.end) + 1
                self.open(statement.start, end, f"if (!::goishi::mutant::drop({self.place_text()})) ")
                self.place += 1
            self.visit(statement)

    def can_drop(self, node):
        if self.in_formula or self.source[node.end:node.end + 1] != b";":
            return False
        operator = node.operator()
        if operator:
            return operator[0] in ASSIGNMENTS
        return node.kind in (K.CALL_EXPR, K.COMPOUND_ASSIGNMENT_OPERATOR) or (
            node.kind == K.UNARY_OPERATOR and re.match(rb"\+\+|--", self.source[node.start:node.end]))

    def head_end(self, node):
        """Where the brackets after `if`, `while`, `for` close."""
        at = self.source.index(b"(", node.start)
        depth = 0
        while True:
            byte = self.source[at:at + 1]
            depth += byte == b"("
            depth -= byte == b")"
            if depth == 0:
                return at
            at += 1

    def visit_branch(self, node):
        end = self.head_end(node)
        head = [c for c in node.children if c.start < end]
        if not re.match(rb"if\s+constexpr", self.source[node.start:node.start + 20]):
            loop = node.kind == K.WHILE_STMT
            self.visit_all(head[:-1])
            if all(c.kind != K.VAR_DECL for c in head):  # `if (auto x = …)` asks what it declares
                self.visit_condition(head[-1], not loop, True)
        self.visit_all(c for c in node.children if end < c.start)

    def visit_do(self, node):
        self.visit(node.children[0])
        self.visit_condition(node.children[1], False, True)

    def visit_for(self, node):
        end = self.head_end(node)
        semicolons = [at for at in range(node.start, end) if self.source[at:at + 1] == b";"]
        for child in node.children:
            if child.start < end and len(semicolons) == 2 and semicolons[0] < child.start < semicolons[1]:
                self.visit_condition(child, False, True, deep=False)
            elif end < child.start:
                self.visit(child)

    def visit_range(self, node):
        self.visit(node.children[-1])

    def visit_switch(self, node):
        self.visit_all(c for c in node.children if c.kind == K.COMPOUND_STMT)

    def visit_case(self, node):
        self.visit_all(node.children[1:])

    def visit_lambda(self, node):
        bodies = [c for c in node.children if c.kind == K.COMPOUND_STMT]
        if self.in_formula and bodies and re.search(rb"->[^{]*&\s*$", self.source[node.start:bodies[0].start]):
            return  # it hands out what is, and no value
        self.visit_all(c for c in node.children if c.kind == K.COMPOUND_STMT)

    def visit_return(self, node):
        for child in node.children:
            if self.in_formula:
                self.visit_value(child)
            else:
                self.visit(child)

    def visit_declaration(self, node):
        variables = [c for c in node.children if c.kind == K.VAR_DECL]
        constant = re.match(rb"(static )?(constexpr)\b", self.source[node.start:node.end])
        if constant and variables:
            # A table of numbers can as well be made when it is come to; what counts something cannot.
            if not self.live or self.in_formula or not re.search(r"\bT\b|double", variables[0].type):
                return
            self.replace(node.start + constant.start(2), node.start + constant.end(2), "const")
        for child in node.children:
            if child.kind == K.UNEXPOSED_DECL:  # of several names at once
                for value in child.children:
                    if value.is_expression:
                        (self.visit_value if self.in_formula else self.visit)(value)
            else:
                self.visit(child)

    # --- conditions

    def visit_condition(self, node, to_true, to_false, deep=True):
        """What is used as true or false: of `a && b` each is made true, of `a || b` false, and the whole the other."""
        bare = node.bare()
        operator = bare.operator()
        if operator and operator[0] in ("&&", "||"):
            both = operator[0] == "&&"
            self.visit_condition(operator[2], to_true and both, to_false and not both, deep)
            self.visit_condition(operator[3], to_true, to_false, deep)
            return
        if operator and operator[0] in RELATIONS:
            self.add_relation(bare, operator, to_true, to_false, deep)
            return
        if bare.kind == K.CXX_BOOL_LITERAL_EXPR:
            self.visit(bare)
            return
        if self.source[bare.start - 2:bare.start] == b"::":  # a concept of another namespace: nothing that runs
            return
        self.add_truth(bare, "true", TRUE, to_true)
        self.add_truth(bare, "false", FALSE, to_false)
        self.wrap(bare, "truth")
        symbol, operand = bare.unary()
        if symbol == "!":
            self.visit_condition(operand, False, False, deep)
        elif deep:
            self.visit(bare)

    def add_truth(self, node, value, change, wanted):
        if wanted:
            self.add(node, f"`{node.text()}` -> {value}", change)

    def add_relation(self, node, operator, to_true, to_false, deep=True):
        symbol, _, left, right = operator
        if symbol in ("==", "!="):
            self.add(node, f"`{node.text()}` -> {OPPOSITE[symbol]}", OTHER)
        else:
            self.add_truth(node, "true", TRUE, to_true)
            self.add_truth(node, "false", FALSE, to_false)
            if INTEGERS.match(left.bare().type) and INTEGERS.match(right.bare().type) and deep:
                self.add(node, f"`{node.text()}` -> {OPPOSITE[symbol]}", OTHER)
        self.wrap_operator(node, RELATIONS[symbol], operator)
        if deep:
            for side in (left, right):
                if not self.is_plain(side):
                    self.visit(side)

    def is_plain(self, node):
        """A number or an enumerator that something is compared with: another one makes another answer, as above."""
        node = self.stripped(node)
        return node.kind == K.INTEGER_LITERAL or (
            node.kind == K.DECL_REF_EXPR and node.cursor.referenced is not None and
            node.cursor.referenced.kind == K.ENUM_CONSTANT_DECL)

    # --- expressions

    def visit_expression(self, node):
        node = node.bare()
        kind = node.kind
        operator = node.operator()
        if operator:
            self.visit_operator(node, operator)
        elif kind == K.CONDITIONAL_OPERATOR:
            condition, yes, no = (c for c in node.children if c.is_expression)
            if not self.in_formula:
                self.visit_condition(condition, True, True)
            self.visit(yes)
            self.visit(no)
        elif kind == K.LAMBDA_EXPR:
            self.visit_lambda(node)
        elif kind == K.INTEGER_LITERAL:
            self.add_number(node, node)
        elif kind == K.CXX_BOOL_LITERAL_EXPR:
            self.add(node, f"`{node.text()}` -> {'false' if node.text() == 'true' else 'true'}", OTHER)
            self.wrap(node, "truth")
        elif kind == K.DECL_REF_EXPR:
            self.visit_name(node)
        elif kind == K.MEMBER_REF_EXPR:
            self.visit_object(node)
        elif kind == K.ARRAY_SUBSCRIPT_EXPR or self.source[node.end - 1:node.end] == b"]":
            self.visit_object(node)
        elif node.unary()[1] is not None:
            self.visit_unary(node)
        elif kind == K.CALL_EXPR or kind.name.startswith("CXX_") or kind == K.INIT_LIST_EXPR:
            self.visit_call(node)
        elif kind == K.BINARY_OPERATOR and self.in_formula:  # a comma, between entries of a matrix
            self.visit(node.children[0])
            self.visit_value(node.children[1])
        elif kind in (K.UNEXPOSED_EXPR, K.UNARY_OPERATOR, K.PAREN_EXPR, K.BINARY_OPERATOR):
            self.visit_all(c for c in node.children if c.is_expression or c.kind == K.COMPOUND_STMT)

    def visit_object(self, node):
        """Before `.name` or `[index]`: names, indices and template arguments stay."""
        for child in node.children[:1]:
            if child.is_expression and child.start == node.start and child.end < node.end:
                self.visit(child)

    def visit_operator(self, node, operator):
        symbol, _, left, right = operator
        if symbol in ASSIGNMENTS:
            if self.in_formula:
                self.visit_value(right)
            else:
                self.visit(right)
        elif symbol in ("&&", "||"):
            self.visit_condition(node, True, True)
        elif symbol in RELATIONS and not self.in_formula:
            self.add_relation(node, operator, True, True)
        elif symbol in ARITHMETIC and not self.in_formula:
            name, other = ARITHMETIC[symbol]
            self.add(node, f"`{node.text()}` -> {other}", OTHER)
            self.wrap_operator(node, name, operator)
            self.visit(left)
            self.visit(right)
        else:
            self.visit(left)
            self.visit(right)

    def visit_unary(self, node):
        symbol, operand = node.unary()
        if symbol == "!":
            self.visit_condition(node, True, True)
            return
        if operand.bare().kind not in (K.INTEGER_LITERAL, K.FLOATING_LITERAL):
            self.add(node, f"`{node.text()}` without -", OTHER)
            self.open(node.start, node.end, f"::goishi::mutant::negated({self.place_text()}, ")
            self.replace(node.start, node.start + 1, "")
            self.close(node.start, node.end)
            self.place += 1
        self.visit(operand)

    def visit_call(self, node):
        if node.callee().startswith("__builtin"):  # some want constants
            return
        if self.in_formula:
            self.visit_arguments(node)
            return
        arguments, bracket = node.arguments()
        for child in node.children[:1]:  # what a member function is asked of
            if child.is_expression and child.start == node.start and child.end <= bracket:
                self.visit(child)
        arguments = [a for a in arguments if a.is_expression]
        skip = self.add_swaps(arguments)
        for i, argument in enumerate(arguments):
            if i not in skip:
                self.visit(argument)

    def add_swaps(self, arguments):
        """Neighbouring names of one type; which of them are taken."""
        taken = set()
        for i in range(len(arguments) - 1):
            a, b = arguments[i].bare(), arguments[i + 1].bare()
            is_variable = all(n.kind == K.DECL_REF_EXPR and n.cursor.referenced is not None and
                              n.cursor.referenced.kind in (K.PARM_DECL, K.VAR_DECL) for n in (a, b))
            if i in taken or not is_variable or a.text() == b.text():
                continue
            if a.type.replace("const ", "") != b.type.replace("const ", ""):
                continue
            taken |= {i, i + 1}
            self.add(a, f"swap `{a.text()}, {b.text()}`", OTHER)
            place = self.place_text()
            for one, other in ((a, b), (b, a)):
                self.open(one.start, one.end, f"::goishi::mutant::pick({place}, ")
                self.close(one.start, one.end, f", {other.text()})")
            self.place += 1
        return taken

    def visit_name(self, node):
        """An enumerator becomes the next one of its kind."""
        what = node.cursor.referenced
        if what is None or what.kind != K.ENUM_CONSTANT_DECL:
            return
        names = [c.spelling for c in what.semantic_parent.get_children() if c.kind == K.ENUM_CONSTANT_DECL]
        if len(names) < 2 or what.spelling not in names:
            return
        following = names[(names.index(what.spelling) + 1) % len(names)]
        self.add(node, f"`{node.text()}` -> {following}", OTHER)
        text = node.text()
        scope = text[:len(text) - len(what.spelling)]
        self.wrap(node, "pick", f", {scope}{following}")

    def add_number(self, node, context, signed=False):
        text = node.text()
        product = context.text()
        if "epsilon" in product:
            return
        self.add(node, f"{text} + 1" + (f" in `{product}`" if product != text else f" of line `{self.line_of(node)}`"),
                 OTHER)
        if signed:
            self.add(node, f"sign of `{text}` of line `{self.line_of(node)}`", 0)
        self.wrap(node, "number")

    def line_of(self, node):
        begin = self.source.rfind(b"\n", 0, node.start) + 1
        return " ".join(self.source[begin:self.source.index(b"\n", node.start)].decode().split())


def rewrite(folder, headers, flags):
    """The changed headers, and all changes."""
    changed, mutants = {}, []
    unit, cursors = tree.parse(folder, headers, flags)
    for i, header in enumerate(headers):
        finder = Finder(header, (folder / header).read_bytes(), i * PLACES)
        for cursor in cursors[header]:
            finder.walk(cursor)
        if finder.place > (i + 1) * PLACES or finder.place > MOST_PLACES:
            raise RuntimeError(f"{header}: more places than mutation.hpp has room for")
        number_repeated(finder.mutants)
        include = b'#pragma once\n#include <goishi/mutation.hpp>'
        changed[header] = finder.rewritten().replace(b"#pragma once", include, 1)
        mutants += finder.mutants
    del unit
    return changed, mutants


def number_repeated(mutants):
    seen = {}
    for mutant in mutants:
        count = seen[mutant.key()] = seen.get(mutant.key(), 0) + 1
        if count > 1:
            mutant.what += f" #{count}"
