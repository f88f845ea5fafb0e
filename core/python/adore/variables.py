"""The deck variables as attributes, for editors: variables.pyi lists all with unit and meaning."""

__all__ = ["DeckVariables"]


class DeckVariables:
    """Every variable of all records; a deck has those of its records."""

    __slots__ = ()
