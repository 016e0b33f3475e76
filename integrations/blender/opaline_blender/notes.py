"""What a render cannot show, reported once."""


class Notes:
    """Kinds of things that are not shown, each with some names."""

    MOST_NAMES = 3

    def __init__(self):
        self._names = {}

    def add(self, what, name=""):
        names = self._names.setdefault(what, [])
        if name and name not in names:
            names.append(name)

    def sentences(self):
        for what, names in self._names.items():
            shown = ", ".join(names[:self.MOST_NAMES])
            more = len(names) - self.MOST_NAMES
            if more > 0:
                shown += f" and {more} more"
            yield f"{what}: {shown}" if shown else what
