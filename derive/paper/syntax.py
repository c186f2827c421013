"""Tokens of one statement → the tree of its syntax, by the LALR grammar in ``statement.lark``."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cache
from importlib.resources import files
from typing import Any

from lark import Lark, Token, Tree, UnexpectedToken
from lark.lexer import Lexer

from .errors import ReadError

_HIDDEN = ("SUP", "SUB", "LBRACE", "RBRACE")
_SAID = {
    "RELATION": "a relation", "SIGN": "a sign", "CDOT": "a dot product", "CROSS": "a cross product", "SLASH": "'/'",
    "COMMA": "','", "SEMICOLON": "';'", "DOT": "'.'", "TICK": "a prime", "PRIME": "a prime",
    "OUTER": "a tensor product", "EVAL": "an evaluation bar", "$END": "the end",
}  # fmt: skip


class _Given(Lexer):
    """Lark wants a lexer; the tokens are fed by hand."""

    def __init__(self, lexer_conf: Any) -> None:
        """Nothing to configure."""

    def lex(self, lexer_state: Any, parser_state: Any) -> Iterator[Token]:
        """Nothing: tokens are fed one by one."""
        return iter(())


@cache
def _grammar() -> Lark:
    text = files(__package__).joinpath("statement.lark").read_text(encoding="utf-8")
    return Lark(text, parser="lalr", lexer=_Given, propagate_positions=True, maybe_placeholders=False)


def syntax_tree(tokens: Sequence[Token], error: Callable[[int, str], ReadError]) -> Tree[Token]:
    """The syntax of one statement; ``error(offset, message)`` makes the error for a token out of place."""
    parser = _grammar().parse_interactive()
    for token in tokens:
        kind = "_" + token.type if token.type in _HIDDEN else token.type
        _feed(parser, Token.new_borrow_pos(kind, token, token), error)
    end = Token.new_borrow_pos("$END", "", tokens[-1])
    return _feed(parser, end, error)


def _feed(parser: Any, token: Token, error: Callable[[int, str], ReadError]) -> Any:
    try:
        return parser.feed_token(token)
    except UnexpectedToken:
        if token.type == "$END":
            raise error(token.end_pos or 0, "the formula ends too early; something is missing here") from None
        said = _SAID.get(token.type, f"'{token}'")
        raise error(token.start_pos or 0, f"{said} cannot stand here; check what comes before it") from None
