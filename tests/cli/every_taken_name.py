"""Everything that may stand at the name of every output; taken_names tries a fifth of it."""

from taken_names import every_case as cases  # noqa: F401
