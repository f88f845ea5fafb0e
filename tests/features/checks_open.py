"""Features whose checks are to be written, and checks that were set aside because they looked in the wrong place."""

from bench import not_checked

LISTING = "no true check of PRINT.txt yet: the first one looked for other titles than the listing has"
for identifier in ("F231", "F232", "F233", "F238", "F239", "F242"):
    not_checked(identifier, LISTING)
not_checked("F226", "no true check yet: the first one used names that the program keeps for itself")
not_checked("F206", "no true check yet: pocket films do not touch in the scene of the first one")
