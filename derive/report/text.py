"""Plain text and printed formulas as LaTeX that compiles: what is not a formula is escaped, whatever it holds."""

from __future__ import annotations

import re
import unicodedata

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
ACCENTS = {"bar": r"\overline", "hat": r"\hat", "tilde": r"\tilde"}
GREEK = {
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "kappa", "mu", "nu", "xi", "sigma", "tau",
    "phi", "chi", "psi", "omega", "ell", "varkappa", "vartheta", "varepsilon", "lambda", "rho",
}  # fmt: skip
NAMES = re.compile(r"(\b[A-Za-z]+(?:_[A-Za-z0-9]+)+\b|(?<=[ =])-\d+\b|\b(?:" + "|".join(sorted(GREEK)) + r")\b)")
DIGITS = 8  # of a decimal number
COMMENT = re.compile(r"(?<!\\)%[^\n]*")
LEFT_OUT = re.compile(r"\\label\s*\{[^{}]*\}|\\(?:nonumber|notag)(?![A-Za-z])")
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
    """A name of the theory, say ``xi_tip`` or ``gamma_bar``, as a formula; no other text is let through."""
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", name):
        return rf"\text{{{text(name)}}}"
    base, *scripts = name.split("_")
    letter = rf"\{base}" if base in GREEK else base if len(base) == 1 else rf"\mathrm{{{base}}}"
    for accent, written in ACCENTS.items():
        if accent in scripts:
            scripts.remove(accent)
            letter = rf"{written}{{{letter}}}"
    under = ", ".join(part if part.isdigit() or len(part) == 1 else rf"\mathrm{{{part}}}" for part in scripts if part)
    return f"{letter}_{{{under}}}" if under else letter


def prose(said: str) -> str:
    """Text in which names of the theory, such as ``xi_tip``, and numbers with a minus are set as formulas."""
    parts = re.split(
        r"(\b[A-Za-z]+(?:_[A-Za-z0-9]+)+\b|(?<=[ =])-\d+\b|\b(?:" + "|".join(sorted(GREEK)) + r")\b)", said
    )
    return "".join(_named(part) if n % 2 else text(part) for n, part in enumerate(parts))


def _named(part: str) -> str:
    """A number or the name of a letter as a formula; names made of words as words."""
    base = part.split("_")[0]
    if part.startswith("-"):
        return f"${part}$"
    return f"${symbol(part)}$" if base in GREEK or len(base) == 1 else text(part.replace("_", " "))


def number(said: str) -> str:
    """A number as text for a formula: a fraction as it stands, a decimal to a few digits; other text is escaped."""
    if re.fullmatch(r"-?\d+(?:/\d+)?", said):
        return said
    if found := re.fullmatch(r"(-?\d+\.\d*)(?:e([+-]?\d+))?", said):
        short = f"{float(found[1]):.{DIGITS}g}"
        return rf"{short} \cdot 10^{{{int(found[2])}}}" if found[2] else short
    return rf"\text{{{text(said)}}}"


def printed(latex: str) -> str:
    """A printed display without its label, comments and closing punctuation, in one line of source."""
    found = LEFT_OUT.sub("", COMMENT.sub("", latex)).replace("{split}", "{aligned}")
    return " ".join(CLOSING.sub("", found).split())
