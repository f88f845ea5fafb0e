"""The variables of a deck as attributes, for editors: variables.pyi names them all with unit and meaning."""

__all__ = ["DeckVariables"]


class DeckVariables:
    """Every variable that a deck may have; a deck has those of its own records."""

    __slots__ = ()
