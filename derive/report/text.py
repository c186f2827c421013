"""Plain text and printed formulas as LaTeX that compiles: what is not a formula is escaped, whatever it holds."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from fractions import Fraction

# Characters that are no ASCII, as LaTeX for mathematics.
MATHS = {
    "α": r"\alpha", "β": r"\beta", "γ": r"\gamma", "δ": r"\delta", "ε": r"\varepsilon", "ζ": r"\zeta", "η": r"\eta",
    "θ": r"\theta", "ϑ": r"\vartheta", "κ": r"\kappa", "ϰ": r"\varkappa", "λ": r"\lambda", "μ": r"\mu", "ν": r"\nu",
    "ξ": r"\xi", "π": r"\pi", "ρ": r"\rho", "σ": r"\sigma", "τ": r"\tau", "φ": r"\phi", "χ": r"\chi", "ψ": r"\psi",
    "ω": r"\omega", "ϕ": r"\phi", "ς": r"\varsigma", "Φ": r"\Phi", "Ψ": r"\Psi", "Σ": r"\Sigma", "Δ": r"\Delta",
    "Π": r"\Pi", "Γ": r"\Gamma", "Ω": r"\Omega", "ℓ": r"\ell", "℘": r"\wp", "∞": r"\infty", "≤": r"\le",
    "≥": r"\ge", "≠": r"\ne", "±": r"\pm", "∓": r"\mp", "√": r"\surd", "×": r"\times", "·": r"\cdot", "→": r"\to",
    "−": "-", "′": "'", "″": "''", "²": "^2", "³": "^3", "⁴": "^4", "½": r"\tfrac12", "¼": r"\tfrac14", "∈": r"\in",
    "∉": r"\notin", "∂": r"\partial", "∫": r"\int", "⊗": r"\otimes", "≈": r"\approx", "₀": "_0", "₁": "_1",
    "₂": "_2", "₃": "_3", "₄": "_4", "ⁿ": "^n", "ᵤ": "_u", "ᵢ": "_i", "Θ": r"\Theta", "∥": r"\parallel",
    "⊥": r"\perp", "°": r"^\circ", "…": r"\dots",
}  # fmt: skip
ESCAPED = {
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "$": r"\$", "&": r"\&", "#": r"\#", "%": r"\%", "_": r"\_",
    "^": r"\textasciicircum{}", "~": r"\textasciitilde{}", "<": r"$<$", ">": r"$>$", "|": r"$|$", '"': r"''",
    "–": "--", "—": "---", "‘": "`", "’": "'", "“": "``", "”": "''",
}  # fmt: skip
SPELLED = {"epsilon": r"\varepsilon"}  # where the article takes another form of a letter
ACCENTS = {"bar": r"\overline", "hat": r"\hat", "tilde": r"\tilde"}
GREEK = {
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "kappa", "mu", "nu", "xi", "sigma", "tau",
    "varsigma", "phi", "chi", "psi", "omega", "pi", "ell", "varkappa", "vartheta", "varepsilon", "lambda", "rho",
}  # fmt: skip
NAMES = re.compile(r"(\b[^\W\d_]+(?:_[A-Za-z0-9]+)+\b|(?<=[ =])-\d+\b|\b(?:" + "|".join(sorted(GREEK)) + r")\b)")
DIGITS = 8  # of a decimal number
COMMENT = re.compile(r"(?<!\\)%[^\n]*")
LEFT_OUT = re.compile(r"\\label\s*\{[^{}]*\}|\\(?:nonumber|notag)(?![A-Za-z])")
ENVIRONMENT = re.compile(r"\\begin\{(\w+)\}.*?\\end\{\1\}")
CLOSING = re.compile(r"(?:\\[,;:! ]|\\quad(?![A-Za-z])|\\qquad(?![A-Za-z])|[\s,;~]|(?<!\\right)\.)+$")


def text(said: str) -> str:
    """Any text, so that LaTeX sets it as it stands."""
    return "".join(_character(one) for one in unicodedata.normalize("NFC", said))


def _character(one: str) -> str:
    if one in ESCAPED:
        return ESCAPED[one]
    if one in MATHS:
        return rf"\ensuremath{{{MATHS[one]}}}"
    if one in ("\n", "\t") or (one.isascii() and one.isprintable()):
        return one
    if unicodedata.combining(one):
        return ""
    return rf"\texttt{{U+{ord(one):04X}}}"


def symbol(name: str) -> str:
    """A name of the theory, say ``xi_tip``, ``gamma_bar`` or ``delta_q_1(s)``, as a formula; other text is escaped."""
    if called := re.fullmatch(r"(\w+)\((\w+)\)", name):
        return f"{symbol(called[1])}({symbol(called[2])})"
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", name):
        return rf"\text{{{text(name)}}}"
    base, *scripts = name.split("_")
    if base == "delta" and scripts:
        return rf"\delta {symbol('_'.join(scripts))}"
    letter = _letter(base)
    for accent, written in ACCENTS.items():
        if accent in scripts:
            scripts.remove(accent)
            letter = rf"{written}{{{letter}}}"
    under = " ".join(part if part.isdigit() else _letter(part) for part in scripts if part)
    return f"{letter}_{{{under}}}" if under else letter


def _letter(word: str) -> str:
    if word.lower() in GREEK:
        return SPELLED.get(word, rf"\{word}")
    return word if len(word) == 1 else rf"\mathrm{{{word}}}"


def prose(said: str) -> str:
    """Text in which names of the theory, such as ``xi_tip``, and numbers with a minus are set as formulas."""
    return "".join(f"${part}$" if formula else text(part) for formula, part in pieces(said))


def pieces(said: str) -> Iterator[tuple[bool, str]]:
    """Text in parts: whether one is a formula, and its LaTeX or its words."""
    for n, part in enumerate(NAMES.split(said)):
        yield _named(part) if n % 2 else (False, part)


def _named(part: str) -> tuple[bool, str]:
    """A number or the name of a letter as a formula; names made of words as words."""
    base, _, script = part.partition("_")
    if part.startswith("-"):
        return True, part
    if base in MATHS:
        return True, f"{MATHS[base]}_{{{symbol(script)}}}"
    return (True, symbol(part)) if base in GREEK or len(base) == 1 else (False, part.replace("_", " "))


def number(said: str) -> str:
    """A number as text for a formula: as a decimal where that is exact and short; other text is escaped."""
    if re.fullmatch(r"-?\d+(?:/\d+)?", said):
        value = Fraction(said)
        short = f"{float(value):.{DIGITS}g}"
        return _decimal(short) if Fraction(short) == value else said
    if re.fullmatch(r"-?\d+\.\d*(?:e[+-]?\d+)?", said):
        return _decimal(f"{float(said):.{DIGITS}g}")
    return rf"\text{{{text(said)}}}"


def _decimal(said: str) -> str:
    mantissa, _, exponent = said.partition("e")
    power = rf"10^{{{int(exponent)}}}" if exponent else ""
    return (power if mantissa == "1" else rf"{mantissa} \cdot {power}") if exponent else mantissa


def printed(latex: str) -> str:
    """A printed display without its label, comments and closing punctuation, in one line of source.

    A part of an alignment, with its marks, gets an alignment of its own.
    """
    found = LEFT_OUT.sub("", COMMENT.sub("", latex)).replace("{split}", "{aligned}")
    found = " ".join(CLOSING.sub("", found).split())
    open_marks = re.search(r"&|\\\\", ENVIRONMENT.sub("", found))
    return rf"\begin{{aligned}} {found} \end{{aligned}}" if open_marks else found
