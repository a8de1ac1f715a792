"""Results of kernels: tuples with names, like those of `typing.NamedTuple`, made in a tenth of the
time. Some two hundred classes of them are made when all kernels are imported.
"""

from __future__ import annotations

from operator import itemgetter
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterable
    from typing import Self


class _Named(type):
    """Gives a class the fields that its body annotates, in their order."""

    def __new__(cls, name: str, bases: tuple[type, ...], body: dict[str, Any]) -> Any:
        fields = tuple(body.get("__annotations__", ()))
        places = {field: property(itemgetter(place)) for place, field in enumerate(fields)}
        own = {"__slots__": (), "__match_args__": fields, "_fields": fields}
        return super().__new__(cls, name, bases, {**own, **body, **places})


class NamedTuple(tuple[Any, ...], metaclass=_Named):
    """What `typing.NamedTuple` offers for fields without defaults."""

    _fields: tuple[str, ...]

    def __new__(cls, *values: Any, **named: Any) -> Self:
        """One value for each field, by place or by name. TypeError if they do not fit."""
        if not named and len(values) == len(cls._fields):
            return super().__new__(cls, values)
        rest = cls._fields[len(values) :]
        if len(values) > len(cls._fields) or named.keys() != set(rest):
            given = [*cls._fields[: len(values)], *named]
            raise TypeError(
                f"{cls.__name__} takes one value for each of {', '.join(cls._fields)}, "
                f"got {len(values) + len(named)} for {', '.join(given) or 'none'}"
            )
        return super().__new__(cls, (*values, *(named[field] for field in rest)))

    @classmethod
    def _make(cls, values: Iterable[Any]) -> Self:
        return cls(*values)

    def _asdict(self) -> dict[str, Any]:
        return dict(zip(self._fields, self, strict=True))

    def _replace(self, **named: Any) -> Self:
        return type(self)(**{**self._asdict(), **named})

    def __getnewargs__(self) -> tuple[Any, ...]:
        return tuple(self)

    def __repr__(self) -> str:
        fields = zip(self._fields, self, strict=True)
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in fields)})"
