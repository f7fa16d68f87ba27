"""What can be changed in a formula: the sign of each term, its size, its whole numbers."""

import re

from clang.cindex import CursorKind as K

# `T(x)` is x: no place of its own.
CONVERSION = re.compile(r"(T|S|Wide|(Vec3|Mat3|Quat)<\w+>|static_cast<\w+>)$")
# To change an argument of these is to change the result, which has a place already.
LINEAR = re.compile(r"(formula::|scalar::)?(dot|cross|scaled|cwiseProduct|cwiseQuotient|sq)$")
EVEN = re.compile(r"(scalar::)?cos$")
# Types whose values have a sign and a size; of others (a stone, a body) only the parts are changed.
NUMERIC = re.compile(r"(const )?(T|S|Wide|Vec3<.*>|Mat3<.*>|Quat<.*>|Eigen::.*|<dependent type>|auto)( &)?$")


class FormulaFinder:
    """The part of the finder that knows terms."""

    def visit_value(self, node):
        """An expression that is a sum of terms."""
        node = self.stripped(node)
        if self.is_constant(node):
            return
        operator = node.operator()
        if operator and operator[0] in ("+", "-"):
            self.visit_value(operator[2])
            self.visit_value(operator[3])
        elif node.kind == K.CONDITIONAL_OPERATOR:
            parts = [c for c in node.children if c.is_expression]
            self.visit_value(parts[1])
            self.visit_value(parts[2])
        elif node.kind in (K.LAMBDA_EXPR, K.INIT_LIST_EXPR) or operator and operator[0] not in "*/":
            self.visit_parts(node)
        else:
            self.add_term(node, True)

    def is_constant(self, node):
        return node.kind in (K.FLOATING_LITERAL, K.CXX_BOOL_LITERAL_EXPR, K.STRING_LITERAL)

    def stripped(self, node):
        """Without brackets and conversions."""
        while True:
            node = node.bare()
            arguments, _ = node.arguments() if node.is_expression else ([], 0)
            if node.operator() is None and len(arguments) == 1 and CONVERSION.match(node.callee()):
                node = arguments[0]
            else:
                return node

    def add_term(self, node, signed):
        if node.kind == K.INTEGER_LITERAL:
            self.add_number(node, node, signed and node.text() != "0")
            return
        numbers = self.number_factors(node)
        is_numeric = NUMERIC.match(node.type)
        if is_numeric:
            if signed:
                self.add(node, f"sign of `{node.text()}`", 0)
            if not numbers:
                self.add(node, f"size of `{node.text()}`", 1)
            if signed or not numbers:
                self.wrap(node, "term")
        self.visit_parts(node, node)

    def number_factors(self, node):
        """The whole numbers that are factors of a term: to change one is to change its size."""
        node = self.stripped(node)
        if node.kind == K.INTEGER_LITERAL:
            return [node]
        operator = node.operator()
        if operator and operator[0] in ("*", "/"):
            return self.number_factors(operator[2]) + self.number_factors(operator[3])
        symbol, operand = node.unary()
        return self.number_factors(operand) if symbol == "-" else []

    def visit_parts(self, node, term=None):
        """What is inside a term."""
        node = self.stripped(node)
        operator = node.operator()
        symbol, operand = node.unary()
        if node.kind == K.INTEGER_LITERAL:
            self.add_number(node, term or node)
        elif operator and operator[0] in ("*", "/"):
            for factor in operator[2:]:
                inner = self.stripped(factor).operator()
                if inner and inner[0] in ("+", "-"):
                    self.visit_value(factor)
                else:
                    self.visit_parts(factor, term)
        elif operator and operator[0] == "<<":  # a matrix, entry by entry
            self.visit_parts(operator[2])
            self.visit_value(operator[3])
        elif operator and operator[0] in ("+", "-"):
            self.visit_value(node)
        elif operator:
            self.visit_operator(node, operator)
        elif symbol == "-":
            self.visit_parts(operand, term)
        elif node.kind == K.INIT_LIST_EXPR:
            for part in node.children:
                self.visit_listed(part)
        elif node.kind == K.LAMBDA_EXPR:
            self.visit_lambda(node)
        elif node.kind in (K.CALL_EXPR, K.CXX_FUNCTIONAL_CAST_EXPR, K.UNEXPOSED_EXPR) and node.arguments()[0]:
            self.visit_arguments(node)
        elif node.kind in (K.MEMBER_REF_EXPR, K.CALL_EXPR):
            for child in node.children[:1]:
                if child.is_expression and child.start == node.start and child.end < node.end:
                    self.visit_parts(child)

    def visit_listed(self, node):
        """A part of a list, `.name = value` too."""
        values = [c for c in node.children if c.is_expression]
        if node.kind == K.UNEXPOSED_EXPR and self.source[node.start:node.start + 1] == b"." and values:
            self.visit_value(values[-1])
        elif node.is_expression:
            self.visit_value(node)

    def visit_arguments(self, node):
        name = node.callee()
        for child in node.children[:1]:
            if child.is_expression and child.start == node.start and "." in name:
                self.visit_parts(child)
        arguments = [a for a in node.arguments()[0] if a.is_expression]
        for argument in arguments:
            inner = self.stripped(argument)
            operator = inner.operator()
            is_sum = operator and operator[0] in ("+", "-")
            if LINEAR.search(name.rsplit(".", 1)[-1]) and not is_sum:
                self.visit_parts(argument)
            elif is_sum or inner.kind in (K.INIT_LIST_EXPR, K.LAMBDA_EXPR):
                self.visit_value(argument)
            else:
                self.add_term(inner, not EVEN.match(name))
