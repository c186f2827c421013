"""Records of emitted modules: as NamedTuple, but a class of them takes no time to make when the module is imported."""

from __future__ import annotations

from collections import namedtuple


class Record(tuple):
    """A tuple whose fields have names: the annotations of its class, in order. Made from a tuple of all its values."""

    __slots__ = ()
    _fields: tuple[str, ...]
    _places = namedtuple("_places", "a b c d e f g h i j k l m n o p")  # no record has more fields

    def __init_subclass__(cls):
        """Give every field its place; what reads a place is taken from one named tuple."""
        cls._fields = tuple(cls.__annotations__)
        for name, place in zip(cls._fields, cls._places._fields, strict=False):
            setattr(cls, name, getattr(cls._places, place))

    def __repr__(self):
        """The class and the fields by name."""
        fields = ", ".join(f"{name}={value!r}" for name, value in zip(self._fields, self, strict=True))
        return f"{type(self).__name__}({fields})"

    def _replace(self, **changed):
        """The same with some other values."""
        return type(self)([changed.get(name, value) for name, value in zip(self._fields, self, strict=True)])
