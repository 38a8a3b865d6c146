"""A function of the user's with options, written as a decorator."""

from __future__ import annotations

from typing import Any

from ._check import shown, text
from .errors import InputError


class Decorated:
    """A function that the engine calls. Subclasses take its options as keywords and say what it is.

    Both `@thing` and `@thing(option=...)` decorate; what comes of it is called as the function itself.
    """

    _kind = ""  # for messages, with an article
    _argument = ""  # what the function is a function of
    _usual_name = ""  # of a function without one

    def __init__(self, function, name: str):
        self.name = text(name, "name")
        self.function = None
        if function is not None:
            self(function)

    def __call__(self, argument: Any) -> Any:
        """Decorate a function; afterwards, call it."""
        if self.function is not None:
            return self.function(argument)
        if not callable(argument):
            raise InputError(f"{self._kind} is a function of {self._argument}, found {shown(argument)}")
        self.function = argument
        self.name = self.name or getattr(argument, "__name__", "").replace("<lambda>", "") or self._usual_name
        self.__doc__ = argument.__doc__
        return self

    @classmethod
    def of(cls, given):
        """What was decorated, or a plain function with the defaults. Raises InputError where the function is missing."""
        made = given if isinstance(given, cls) else cls(given)
        if made.function is None:
            raise InputError(f"{cls._kind} without a function: write @ljmd.{cls.__name__}(...) above one")
        return made
