"""What a module consists of, and how large it is, read from its text."""

from __future__ import annotations

import ast
from dataclasses import dataclass

Item = tuple[str, str]  # kind and name: ("function", "rf"), ("parameter", "rf(x)"), ("field", "Rod.eta")
KINDS = ("parameter", "function", "class", "field", "constant", "import", "formula")


@dataclass(frozen=True)
class Size:
    """How large a module is."""

    functions: int
    lines: int
    bytes: int


def items(text: str) -> list[Item]:
    """What a module consists of, in its order."""
    found: list[Item] = []
    for node in ast.parse(text).body:
        match node:
            case ast.Import():
                found += [("import", alias.name) for alias in node.names]
            case ast.ImportFrom() if node.module != "__future__":
                found += [("import", f"{node.module}.{alias.name}") for alias in node.names]
            case ast.FunctionDef():
                found.append(("function", node.name))
                arguments = (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs)
                found += [("parameter", f"{node.name}({argument.arg})") for argument in arguments]
            case ast.ClassDef():
                found.append(("class", node.name))
                fields = (n.target for n in node.body if isinstance(n, ast.AnnAssign))
                found += [("field", f"{node.name}.{field.id}") for field in fields if isinstance(field, ast.Name)]
            case ast.Assign() | ast.AnnAssign():
                targets = node.targets if isinstance(node, ast.Assign) else [node.target]
                names = [target.id for target in targets if isinstance(target, ast.Name)]
                found += [("constant", name) for name in names if name != "__all__"]
    return found


def lacking(full: list[Item], there: list[Item]) -> list[Item]:
    """Items of ``full`` that are not there; what belongs to a function or class that is gone goes without saying."""
    known = set(there)
    gone = {name for kind, name in full if kind in ("function", "class") and (kind, name) not in known}
    kinds = {kind: place for place, kind in enumerate(KINDS)}
    absent = (item for item in full if item not in known and owner(item) not in gone)
    return sorted(absent, key=lambda item: kinds[item[0]])


def owner(item: Item) -> str:
    """The function of a parameter or the class of a field, else nothing."""
    kind, name = item
    return name.split("(")[0] if kind == "parameter" else name.split(".")[0] if kind == "field" else ""


def size(text: str) -> Size:
    """How large a module is."""
    functions = sum(kind == "function" for kind, _ in items(text))
    return Size(functions, len(text.splitlines()), len(text.encode()))
