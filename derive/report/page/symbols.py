"""Which characters stand for which commands of LaTeX: the whole of what the pages can set."""

from __future__ import annotations

LETTERS = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ϵ", "varepsilon": "ε", "zeta": "ζ", "eta": "η",
    "theta": "θ", "vartheta": "ϑ", "kappa": "κ", "varkappa": "ϰ", "lambda": "λ", "mu": "μ", "nu": "ν", "xi": "ξ",
    "pi": "π", "rho": "ρ", "sigma": "σ", "varsigma": "ς", "tau": "τ", "phi": "ϕ", "varphi": "φ", "chi": "χ", "psi": "ψ",
    "omega": "ω", "ell": "ℓ", "wp": "℘", "partial": "∂", "infty": "∞",
}  # fmt: skip
CAPITALS = {
    "Gamma": "Γ", "Delta": "Δ", "Theta": "Θ", "Lambda": "Λ", "Xi": "Ξ", "Pi": "Π", "Sigma": "Σ", "Phi": "Φ", "Psi": "Ψ",
    "Omega": "Ω",
}  # fmt: skip
OPERATORS = {
    "cdot": "·", "times": "×", "otimes": "⊗", "pm": "±", "mp": "∓", "in": "∈", "notin": "∉", "to": "→", "le": "≤",
    "leq": "≤", "ge": "≥", "geq": "≥", "ne": "≠", "neq": "≠", "approx": "≈", "equiv": "≡", "parallel": "∥", "perp": "⊥",
    "prime": "′", "dots": "…", "mapsto": "↦", "circ": "∘", "|": "∥", "{": "{", "}": "}", "#": "#", "%": "%", "_": "_",
    "&": "&", "$": "$",
}  # fmt: skip
SIGNS = {"-": "−", "*": "∗", "'": "′", "<": "<", ">": ">"}  # characters that are operators of another shape, or none
NAMED = {
    "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "acosh", "ln", "log", "exp", "max", "min",
    "lim",
}  # fmt: skip
LIMITS = {"max", "min", "lim"}  # what takes its index below
LARGE = {"int": "∫", "sum": "∑"}
SPACES = {",": "0.17", ":": "0.22", ";": "0.28", "!": "-0.17", " ": "0.25", "quad": "1", "qquad": "2", "~": "0.25"}
ACCENTS = {"overline": "¯", "bar": "¯", "hat": "^", "tilde": "~"}
SIZES = {"big": "1.2em", "Big": "1.6em", "bigl": "1.2em", "bigr": "1.2em", "Bigl": "1.6em", "Bigr": "1.6em"}
FENCES = {"(": "(", ")": ")", "[": "[", "]": "]", "|": "|", "\\{": "{", "\\}": "}", ".": ""}
OPENING, CLOSING = {"(", "[", "\\{"}, {")", "]", "\\}"}  # as tokens
# Alphabets: a style of letters, or letters of Unicode.
STYLES = {"mathrm": "rm", "rm": "rm", "boldsymbol": "b", "mathbf": "b", "mathsf": "sf", "operatorname": "rm"}
SCRIPT = {"B": "ℬ", "E": "ℰ", "F": "ℱ", "H": "ℋ", "I": "ℐ", "L": "ℒ", "M": "ℳ", "R": "ℛ"}
FRAKTUR = {"C": "ℭ", "H": "ℌ", "I": "ℑ", "R": "ℜ", "Z": "ℨ"}
DOUBLE = {"C": "ℂ", "H": "ℍ", "N": "ℕ", "P": "ℙ", "Q": "ℚ", "R": "ℝ", "Z": "ℤ"}
# The letters that Unicode has from elsewhere, and the code of A and of a in the alphabet.
ALPHABETS = {
    "mathcal": (SCRIPT, 0x1D49C, 0x1D4B6),
    "mathscr": (SCRIPT, 0x1D49C, 0x1D4B6),
    "mathfrak": (FRAKTUR, 0x1D504, 0x1D51E),
    "mathbb": (DOUBLE, 0x1D538, 0x1D552),
    "mathbbm": (DOUBLE, 0x1D538, 0x1D552),
}
TABLES = {"split", "aligned", "matrix", "array", "cases"}


def of_alphabet(letter: str, alphabet: str) -> str:
    """A letter of an alphabet of its own; what it has no letter for stays."""
    own, capital, small = ALPHABETS[alphabet]
    if not (letter.isascii() and letter.isalpha()):
        return letter
    start, code = ("A", capital) if letter.isupper() else ("a", small)
    return own.get(letter, chr(code + ord(letter) - ord(start)))
