"""Finds and sets entries in the text of OpenFOAM's dictionaries.

The text is changed where the value of the entry stands, before OpenFOAM expands
anything: macros, #include, #eval and comments stay as they are.

An entry is named by its file and its path, constant/aerosolProperties:particles/
seed, or by the end of its path, seed or particles/seed, where that is unique in
the case. A value that is nothing but a macro, frequency $frequency, does not
count: it follows another entry.
"""

import re
from dataclasses import dataclass
from pathlib import Path

FOLDERS = ("constant", "system", "0.orig", "0")
LARGEST = 300_000  # bytes of a file that is searched: the rest are fields
NOT_SEARCHED = {"polyMesh", "triSurface", "lagrangian", "uniform"}

OPEN, CLOSE = "([{", ")]}"
SPACE = re.compile(r"(?:\s+|//[^\n]*|/\*.*?\*/)+", re.DOTALL)
STRING = re.compile(r'"(?:\\.|[^"\\])*"', re.DOTALL)
VERBATIM = re.compile(r"#\{.*?#\}", re.DOTALL)


class EntryError(Exception):
    """What is wrong with a name, a value or a file."""


@dataclass
class Entry:
    """An entry of a file; its value is text[start:end], up to stop with the
    semicolon. That of a dictionary includes the braces."""

    file: str
    path: tuple
    text: str
    start: int
    end: int
    stop: int

    @property
    def value(self):
        return self.text[self.start:self.end]

    @property
    def is_dictionary(self):
        return self.text[self.start] == "{"

    @property
    def is_macro(self):
        return re.fullmatch(r"\$[\w.:/{}]+", self.value) is not None

    def __str__(self):
        return f"{self.file}:{'/'.join(self.path)}"


class Parser:
    """Walks through the text of one dictionary."""

    def __init__(self, text, file):
        self.text, self.file = text, file
        self.i, self.found = 0, []

    def fail(self, what):
        line = self.text.count("\n", 0, self.i) + 1
        raise EntryError(f"{self.file}, line {line}: {what}")

    def skip(self, *patterns):
        """Whatever of these patterns stands here."""
        for pattern in patterns:
            match = pattern.match(self.text, self.i)
            if match:
                self.i = match.end()
                return True
        return False

    def peek(self):
        return self.text[self.i:self.i + 1]

    def word(self):
        """A keyword: up to a blank, with what is in brackets, as div(phi,U)."""
        start, depth = self.i, 0
        if self.skip(STRING):
            return self.text[start + 1:self.i - 1]
        while self.i < len(self.text):
            c = self.text[self.i]
            if c.isspace() or c in '{};"':
                break
            depth += (c == "(") - (c == ")")
            if depth < 0:
                break
            self.i += 1
        if self.i == start:
            self.fail(f"found '{self.peek()}' in place of an entry")
        return self.text[start:self.i]

    def value(self):
        """Up to the semicolon; the end is that of what is no comment."""
        depth, end = [], self.i
        while self.i < len(self.text):
            if self.skip(SPACE):
                continue
            if not self.skip(STRING, VERBATIM):
                c = self.text[self.i]
                if c == ";" and not depth:
                    return end
                if c in OPEN:
                    depth.append(c)
                elif c in CLOSE:
                    if not depth or OPEN[CLOSE.index(c)] != depth.pop():
                        self.fail(f"found '{c}' in place of ';'")
                self.i += 1
            end = self.i
        self.fail("the file ends within an entry")

    def directive(self):
        """#include, #remove, #if, ...: the line, and what it opens."""
        while self.i < len(self.text) and self.peek() != "\n":
            if not self.skip(STRING, VERBATIM):
                self.i += 1

    def dictionary(self, path=()):
        while True:
            self.skip(SPACE)
            c = self.peek()
            if not c:
                if path:
                    self.fail(f"the dictionary {'/'.join(path)} has no end")
                return
            if c == "}":
                if not path:
                    self.fail("found '}' that closes nothing")
                self.i += 1
                return
            if c == ";":
                self.i += 1
            elif c == "#":
                self.directive()
            elif c == "$":
                self.value()
                self.i += 1
            else:
                self.entry(path)

    def entry(self, path):
        path = (*path, self.word())
        self.skip(SPACE)
        start = self.i
        entry = Entry(self.file, path, self.text, start, start, start)
        self.found.append(entry)
        if self.peek() == "{":
            self.i += 1
            self.dictionary(path)
            entry.end = entry.stop = self.i
        else:
            entry.end = self.value()
            self.i += 1
            entry.stop = self.i


def entries(text, file="the text"):
    """Of a dictionary, and of all dictionaries in it."""
    parser = Parser(text, file)
    parser.dictionary()
    return parser.found


def checked_value(value):
    """The text of a value, which must be one, or a dictionary in braces."""
    value = str(value).strip()
    text = f"x {value}" + ("" if value.startswith("{") else ";")
    try:
        found = entries(text)
    except EntryError:
        found = []
    if not value or [e.path for e in found if len(e.path) == 1] != [("x",)] \
            or found[0].stop != len(text):
        raise EntryError(f"'{value}' is no value of an entry")
    return value


def searched(files):
    """Of the names of files of a case those that may be dictionaries."""
    return [name for name in files
            if Path(name).parts[0] in FOLDERS
            and not NOT_SEARCHED & set(Path(name).parts)]


class Entries:
    """Those of a case, given by the contents of its files."""

    def __init__(self, files):
        self.files = files
        self.all = []
        for name in searched(files):
            data = files[name]
            if len(data) > LARGEST or b"\0" in data:
                continue
            try:
                self.all += entries(data.decode(), name)
            except (EntryError, UnicodeDecodeError):
                pass  # no dictionary; if OpenFOAM needs one, it will say so

    def find(self, name):
        """The entry of that name, or (file, path) of one that may be added."""
        if ":" in name:
            file, _, path = name.partition(":")
            path = tuple(path.split("/"))
            return self.of_path(file, path)

        path = tuple(name.split("/"))
        found = [entry for entry in self.all
                 if entry.path[-len(path):] == path
                 and entry.path[0] != "FoamFile"]
        # With 0.orig, the folder 0 is a copy of it
        if any(Path(entry.file).parts[0] == "0.orig" for entry in found):
            found = [entry for entry in found
                     if Path(entry.file).parts[0] != "0"]
        count = [entry for entry in found if not entry.is_macro] or found
        if not count:
            near = sorted({entry.path[-1] for entry in self.all
                           if entry.path[-1].lower() == path[-1].lower()})
            raise EntryError(
                f"the case has no entry {name}"
                + (f"; there is {' '.join(near)}" if near else "")
                + "; an entry is named by its file and its path, such as"
                " constant/aerosolProperties:particles/seed")
        if len(count) > 1:
            shown = "".join(f"\n    {entry}" for entry in count[:20])
            more = len(count) - 20
            raise EntryError(
                f"the case has {len(count)} entries {name}; name one of"
                " them, or several that are to have the same value, joined by"
                f" +:{shown}"
                + (f"\n    and {more} more" if more > 0 else ""))
        return count[0]

    def of_path(self, file, path):
        if file not in self.files:
            raise EntryError(
                f"the case has no file {file}; it has "
                + " ".join(searched(self.files)))
        here = entries(self.files[file].decode(errors="replace"), file)
        found = [entry for entry in here if entry.path == path]
        if len(found) > 1:
            raise EntryError(f"{found[0]} stands {len(found)} times in the"
                             " file")
        if found:
            return found[0]
        parent = [entry for entry in here if entry.path == path[:-1]]
        if path[:-1] and not (parent and parent[-1].is_dictionary):
            names = ["/".join(entry.path) for entry in here
                     if entry.is_dictionary and entry.path[0] != "FoamFile"]
            raise EntryError(
                f"{file} has no dictionary {'/'.join(path[:-1])}; it has "
                + " ".join(names))
        return file, path


def changed(text, file, path, value):
    """The text with another value of the entry, which is added if it is not
    there."""
    value = checked_value(value)
    here = entries(text, file)
    found = [entry for entry in here if entry.path == path]
    new = value if value.startswith("{") else f"{value};"
    if found:
        entry = found[0]
        if entry.is_dictionary and not value.startswith("{"):
            raise EntryError(f"{entry} is a dictionary: its value must be one,"
                             f" in braces, not {value}")
        return text[:entry.start] + new + text[entry.stop:]
    if len(path) == 1:
        return f"{text.rstrip()}\n\n{path[0]} {new}\n"
    (parent,) = (entry for entry in here if entry.path == path[:-1])
    last = parent.end - 1
    return f"{text[:last].rstrip()}\n{path[-1]} {new}\n{text[last:]}"


def nested(text, file):
    """A dictionary as a dict of dicts and of the texts of values; quotes around
    a whole value are taken off."""
    tree = {}
    for entry in entries(text, file):
        if entry.path[0] == "FoamFile":
            continue
        place = tree
        for word in entry.path[:-1]:
            place = place[word]
        if entry.is_dictionary:
            place[entry.path[-1]] = {}
        else:
            value = entry.value
            if STRING.fullmatch(value):
                value = value[1:-1]
            place[entry.path[-1]] = value
    return tree
