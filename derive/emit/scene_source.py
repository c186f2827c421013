"""The text of a scene file, by which errors name the line."""

from __future__ import annotations

import re

from derive.emit.errors import SceneError


class Source:
    """The text of a scene file, to find the line of a key (tomllib keeps no lines)."""

    def __init__(self, text: str, label: str) -> None:
        self.lines = text.splitlines()
        self.label = label

    def error(self, message: str, section: str = "", key: str = "") -> SceneError:
        """An error at the line of ``key`` in ``[section]``, else of the section, else of the file."""
        return SceneError(f"{self.label}:{self._line(section, key)}", message)

    def _line(self, section: str, key: str) -> int:
        current, found = "", 1
        for number, line in enumerate(self.lines, start=1):
            if header := re.match(r"\s*\[+\s*([^\]]*?)\s*\]+", line):
                current = header[1].strip("\"'")
                found = number if current == section else found
            elif key and current == section and re.match(rf"\s*[\"']?{re.escape(key)}[\"']?\s*[=.]", line):
                return number
        return found
