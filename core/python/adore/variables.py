"""The variables of a deck as attributes, for editors: variables.pyi names them all with unit and meaning."""

__all__ = ["DeckVariables"]


class DeckVariables:
    """Every variable of all records; a deck has those of its records."""

    __slots__ = ()
