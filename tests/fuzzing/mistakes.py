"""Mistakes in the text of a file, as by a hand that slips, made at random."""

import re

from bases import BASES, CONTROL, write

NUMBERS = [
    "0", "-1", "1", "1e-300", "1e300", "1e400", "-1e400", "1e200", "-1e30",
    "1e-30", "1e30", "nan", "inf", "-inf", "3.7", "2147483648", "1e10",
    "99999999999999999999", "0x10", "1,5", "1.2.3", "1e", "--1", "-0",
]

WORDS = ["none", "yes", "no", "stick", "foo", "Stokes", "Oseen", "uniform", "on"]

OTHERS = ["(1 2 3)", "()", "{ a 1; }", '"text"', "[0 1 0 0 0 0 0] 1", "$undefined"]


class Mutation:
    """A change of a text, made at random; `done` tells what it was."""

    def __init__(self, chance, text):
        self.chance = chance
        self.text = text
        self.done = ""

    def cut(self, match, new, what):
        """Put a text in the place of a match."""
        old = match.group(0)
        self.text = self.text[:match.start()] + new + self.text[match.end():]
        self.done = f"{what}: {old[:60]!r} -> {new[:60]!r}"

    def pick(self, pattern):
        """One of the places that fit."""
        found = list(re.finditer(pattern, self.text, re.M))
        return self.chance.choice(found) if found else None

    ENTRY = r"\b[A-Za-z]\w*\s+(?:\([^()]*\)|[^\s(){};][^(){};]*);"
    BLOCK = r"\b[A-Za-z]\w*\s*\{[^{}]*\}"
    NUMBER = r"(?<![\w.\"/])-?\d[\d.]*(?:[eE][-+]?\d+)?(?![\w.])"
    WORD = r"\b[A-Za-z]\w{2,}\b"

    def delete_entry(self):
        match = self.pick(self.chance.choice([self.ENTRY, self.BLOCK]))
        return match and self.cut(match, "", "deleted")

    def repeat_entry(self):
        match = self.pick(self.chance.choice([self.ENTRY, self.BLOCK]))
        return match and self.cut(match, match[0] + " " + match[0], "twice")

    def misspell(self):
        match = self.pick(self.WORD)
        if match:
            word = match[0]
            i = self.chance.randrange(len(word) - 1)
            new = self.chance.choice([
                word[:i] + word[i + 1:],
                word[:i] + word[i + 1] + word[i] + word[i + 2:],
                word[:i] + "x" + word[i:],
                word.upper(),
            ])
            self.cut(match, new, "misspelt")

    def number(self):
        match = self.pick(self.NUMBER)
        if match:
            value = self.chance.choice(
                NUMBERS
                + [f"-{match[0]}", f"{match[0]}e3", f"{match[0]}e-3", f"{match[0]}0"]
            )
            self.cut(match, value, "number")

    def kind(self):
        match = self.pick(r"(\b[A-Za-z]\w*\s+)(?:\([^()]*\)|[^\s(){};]+);")
        if match:
            value = self.chance.choice(WORDS + OTHERS + NUMBERS)
            self.cut(match, f"{match[1]}{value};", "value")

    def dictionary(self):
        if self.chance.random() < 0.5:
            match = self.pick(self.BLOCK)
            if match:
                name = re.match(r"\w+", match[0])[0]
                self.cut(match, f"{name} 1.2;", "a value for a dictionary")
        else:
            match = self.pick(self.ENTRY)
            if match:
                name = re.match(r"\w+", match[0])[0]
                self.cut(match, f"{name} {{ a 1; }}", "a dictionary for a value")

    def punctuation(self):
        match = self.pick(r"[;{}()]")
        return match and self.cut(
            match, self.chance.choice(["", "", "", match[0]*2, "{", "}", ")", ";"]),
            "punctuation",
        )

    def insert(self):
        match = self.pick(r"[;{}]")
        return match and self.cut(
            match,
            match[0] + self.chance.choice([
                " unknown 1;", " unknown { type none; }", " #include \"none\"",
                " type none;", " range 20;", "\xa0", "\ufeff", "\0", " ;", " 5;",
                " $none;", " #calc \"1/0\";", " /* ", " \"",
            ]),
            "inserted",
        )

    def end(self):
        i = self.chance.randrange(len(self.text))
        self.done = f"cut off after {i} characters"
        self.text = self.text[:i]

    def mark(self):
        self.text = "\ufeff" + self.text
        self.done = "byte order mark"

    def change(self):
        kinds = (
            [self.number]*8 + [self.kind]*4 + [self.misspell]*3
            + [self.delete_entry]*2 + [self.repeat_entry]
            + [self.dictionary]*3 + [self.punctuation]*4 + [self.insert]*2
            + [self.end, self.mark]
        )
        while not self.done:
            self.chance.choice(kinds)()
        return self.text


def mutate(case, base, chance):
    """Make mistakes in a copy of a base; returns what they are."""
    files = dict(BASES[base])
    files["system/controlDict"] = CONTROL

    if chance.random() < 0.02:
        name = chance.choice([f for f in files if f.startswith("constant")])
        (case/name).unlink()
        kind = chance.choice(["link", "folder", "nothing", "empty"])
        if kind == "link":
            (case/name).symlink_to("nowhere")
        elif kind == "folder":
            (case/name).mkdir()
        elif kind == "empty":
            (case/name).write_text("")
        return [f"{name}: {kind}"]

    # The files of this solver more often than those of OpenFOAM
    names = [
        name for name in files
        for _ in range(3 if "Properties" in name and "t" in name[:3] else 1)
    ]
    done = []
    for _ in range(chance.choice([1, 1, 1, 2])):
        name = chance.choice(names)
        mutation = Mutation(chance, files[name])
        files[name] = mutation.change()
        done.append(f"{name}: {mutation.done}")
        write(case, name, files[name])

    return done
