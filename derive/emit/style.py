"""Expressions and statements as text in the style of the repository's formatter, within its line length."""

from __future__ import annotations

import ast
import io
import re
import tokenize

WIDTH = 120
_OPENING, _CLOSING = "([{", ")]}"
# Operators at which a long line breaks, the loosest first.
_BREAKS = ((" if ", " else "), (" or ",), (" and ",), (" + ", " - "), (" * ", " / ", " // ", " % "))
_BLOCK_KEYWORDS = re.compile(r"(return |assert |raise |yield |[^=()\[\]{}\"']*? [-+*/]?= )")


def expression(node: ast.AST) -> str:
    """One expression or simple statement on one line."""
    return _restyle(ast.unparse(node))


def _restyle(text: str) -> str:
    """Double quotes, no spaces around ** between simple operands, no parentheses around a bare tuple."""
    tokens = list(tokenize.generate_tokens(io.StringIO(text).readline))
    edits: list[tuple[int, int, str]] = []
    for before, token, after, last in zip(tokens, tokens[1:], tokens[2:], [*tokens[3:], tokens[-1]], strict=False):
        if token.string == "**" and _simple(before, after, last):
            edits.append((before.end[1], after.start[1], "**"))
    for token in tokens:
        if token.type == tokenize.STRING and (swapped := _double_quoted(token.string)):
            edits.append((token.start[1], token.end[1], swapped))
    for start, end, new in sorted(edits, reverse=True):
        text = text[:start] + new + text[end:]
    text = re.sub(r"(?<=[\w.]) \*\* \(-(\w+)\)", r"**-\1", text)
    return _bare_tuple(_bare_generators(text))


def _bare_generators(text: str) -> str:
    """``tuple(f(x) for x in y)`` without the second pair of parentheses that ast.unparse adds."""
    for found in reversed(list(re.finditer(r"(?<=\w)\(\(", text))):
        start, end = found.start() + 1, _matching(text, found.start() + 1)
        if text[end + 1 : end + 2] == ")" and _split(text[start + 1 : end], (" for ",))[1:]:
            text = text[:start] + text[start + 1 : end] + text[end + 1 :]
    return text


def _simple(before: tokenize.TokenInfo, after: tokenize.TokenInfo, last: tokenize.TokenInfo) -> bool:
    operands = (tokenize.NAME, tokenize.NUMBER)
    return before.type in operands and after.type in operands and last.string not in ("(", "[", ".")


def _double_quoted(text: str) -> str | None:
    quote = re.fullmatch(r"([rbfRBF]*)'([^'\"]*)'", text, re.DOTALL)
    return f'{quote[1]}"{quote[2]}"' if quote else None


def _bare_tuple(text: str) -> str:
    """``a = (b, c)`` and ``return (b, c)`` without the parentheses that ast.unparse adds."""
    head = _BLOCK_KEYWORDS.match(text)
    if not head or text.startswith(("raise", "assert")):
        return text
    rest = text[head.end() :]
    if _split(rest[1:-1], (" for ",))[1:]:
        return text  # a generator, not a tuple
    if rest.startswith("(") and _matching(rest, 0) == len(rest) - 1 and _split(rest[1:-1], (", ",))[1:]:
        return head[0] + rest[1:-1]
    return text


def wrap(text: str, indent: str) -> list[str]:
    """``text`` as lines within the width: broken inside its last bracket, else at its loosest operator."""
    if len(indent + text) <= WIDTH or "\n" in text:
        return [indent + text]
    head = _BLOCK_KEYWORDS.match(text)
    if head:
        start = head.end()
        members = _split(text[start:], (", ",))
        if len(members) > 1:  # a bare tuple
            body = [line for part in members for line in _with_comma(wrap(part, indent + "    "))]
            return [f"{indent}{text[:start]}(", *body, f"{indent})"]
        operands = _operands(text[start:])
        if len(operands) > 1:
            body = [line for part in operands for line in wrap(part, indent + "    ")]
            return [f"{indent}{text[:start]}(", *body, f"{indent})"]
    elif len(operands := _operands(text)) > 1:
        return [line for part in operands for line in wrap(part, indent)]
    return _break_bracket(text, indent)


def _operands(text: str) -> list[str]:
    for operators in _BREAKS:
        parts = _split(text, operators)
        if len(parts) > 1:
            return parts
    return [text]


def _break_bracket(text: str, indent: str) -> list[str]:
    """Break inside the widest outermost bracket."""
    best = max(_brackets(text), key=lambda pair: pair[1] - pair[0], default=None)
    if best is None:
        return [indent + text]
    start, end = best
    inner = text[start + 1 : end]
    deeper = indent + "    "
    element, *clauses = _split(inner, (" for ",))
    parts = _split(inner, (", ",))
    if clauses:
        loops = [part for clause in clauses for part in _split(clause, (" if ",))]
        lines = [line for part in (element, *loops) for line in wrap(part, deeper)]
    elif len(parts) > 1 and len(deeper + inner) > WIDTH:
        lines = [line for part in parts for line in _with_comma(wrap(part, deeper))]
    elif len(parts) > 1:
        lines = [deeper + inner]
    else:
        lines = [line for part in _operands(inner) for line in wrap(part, deeper)]
    return [indent + text[: start + 1], *lines, indent + text[end:]]


def _with_comma(lines: list[str]) -> list[str]:
    return [*lines[:-1], lines[-1].rstrip(",") + ","]


def _split(text: str, separators: tuple[str, ...]) -> list[str]:
    """Parts of ``text`` between separators outside brackets and strings; an operator opens the next part."""
    parts, start, depth, quote, at = [], 0, 0, "", 0
    while at < len(text):
        char = text[at]
        if quote:
            quote = "" if char == quote else quote
        elif char in "\"'":
            quote = char
        depth += (char in _OPENING) - (char in _CLOSING) if not quote else 0
        found = next((s for s in separators if text.startswith(s, at)), None) if depth == 0 and not quote else None
        if found and at > start:
            parts.append(text[start:at])
            start = at + len(found) if found == ", " else at + 1
            at += len(found) - 1
        at += 1
    return [*parts, text[start:]]


def _brackets(text: str) -> list[tuple[int, int]]:
    """Outermost bracket pairs."""
    pairs, at = [], 0
    while at < len(text):
        if text[at] in _OPENING:
            end = _matching(text, at)
            pairs.append((at, end))
            at = end
        at += 1
    return pairs


def _matching(text: str, start: int) -> int:
    depth, quote = 0, ""
    for at in range(start, len(text)):
        char = text[at]
        if quote:
            quote = "" if char == quote else quote
        elif char in "\"'":
            quote = char
        else:
            depth += (char in _OPENING) - (char in _CLOSING)
            if depth == 0:
                return at
    return len(text) - 1
