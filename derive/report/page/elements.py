"""MathML elements as text: only what MathML Core has, every character escaped here and nowhere else."""

from __future__ import annotations

from markupsafe import Markup, escape

# The elements that are used, all of MathML Core, and how many parts each has (None: any number).
CORE: dict[str, int | None] = {
    "math": None, "mrow": None, "mi": 1, "mo": 1, "mn": 1, "mtext": 1, "mspace": 0, "mfrac": 2, "msqrt": None,
    "mroot": 2, "msub": 2, "msup": 2, "msubsup": 3, "munder": 2, "mover": 2, "munderover": 3, "mtable": None,
    "mtr": None, "mtd": None,
}  # fmt: skip

TALL = ("mfrac", "msqrt", "mroot", "mtable", "munder", "msubsup")


def element(tag: str, *parts: Markup | str, **attributes: str) -> Markup:
    """One element. Strings are escaped; ``class_`` is the attribute class. ValueError for a wrong number of parts."""
    wanted = CORE[tag]
    if wanted is not None and len(parts) != wanted:
        raise ValueError(f"<{tag}> has {wanted} parts, not {len(parts)}")
    named = Markup("").join(Markup(' {}="{}"').format(name.rstrip("_"), value) for name, value in attributes.items())
    return Markup("<{0}{1}>{2}</{0}>").format(Markup(tag), named, Markup("").join(map(escape, parts)))


def row(parts: list[Markup]) -> Markup:
    """Parts side by side, as one."""
    return parts[0] if len(parts) == 1 else element("mrow", *parts)


def letter(said: str, style: str) -> Markup:
    """An identifier; styles: ``""`` (a single letter is italic), ``rm``, ``b`` (bold italic), ``sf``."""
    if not style:
        return element("mi", said)
    if style == "rm":
        return element("mi", said, mathvariant="normal") if len(said) == 1 else element("mi", said)
    return element("mi", said, mathvariant="normal", class_=style)


def operator(said: str, **attributes: str) -> Markup:
    """An operator, a relation, a mark or a bracket."""
    return element("mo", said, **attributes)


def fence(said: str, form: str, size: str = "") -> Markup:
    """A bracket that grows; form: prefix or postfix; size: to which, else to that of what stands beside it."""
    sized = {"minsize": size, "maxsize": size} if size else {}
    return operator(said, form=form, stretchy="true", **sized)


def fenced(opening: str, parts: list[Markup], closing: str) -> Markup:
    """Parts in brackets, one of which may be absent; they grow where something is tall. Else fonts may widen them."""
    tall = any(f"<{tag}" in part for part in parts for tag in TALL)
    sides = [
        operator(said, form=form, stretchy=str(tall).lower()) if said else Markup("")
        for said, form in ((opening, "prefix"), (closing, "postfix"))
    ]
    return element("mrow", sides[0], *parts, sides[1])


def space(width: str) -> Markup:
    """A space of a width in em."""
    return element("mspace", width=f"{width}em")


def scripted(base: Markup, below: Markup | None, above: Markup | None, limits: bool = False) -> Markup:
    """A base with what stands below and above it; limits: under and over it, else beside it."""
    under, over, both = ("munder", "mover", "munderover") if limits else ("msub", "msup", "msubsup")
    if below is not None and above is not None:
        return element(both, base, below, above)
    if below is not None:
        return element(under, base, below)
    return base if above is None else element(over, base, above)


def table(rows: list[list[Markup]], kind: str) -> Markup:
    """Cells in rows; the style sheet aligns them by kind."""
    lines = [element("mtr", *(element("mtd", cell) for cell in cells)) for cells in rows]
    return element("mtable", *lines, class_=kind, displaystyle="true")
