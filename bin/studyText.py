"""Values as they are given to bin/study and its relatives, and results as they are
printed and written."""

import csv
import io
import re

import numpy as np
from studyRuns import StudyError, number, write_whole


def split(text, at=","):
    """The text at commas, or blanks, that are in no brackets."""
    words, depth, word = [], 0, ""
    for c in text:
        depth += (c in "([{") - (c in ")]}")
        if depth == 0 and (c == at or at == " " and c.isspace()):
            words.append(word)
            word = ""
        else:
            word += c
    return [word.strip() for word in (*words, word) if word.strip()]


def shown(x):
    """A value as it is written into a dictionary."""
    return f"{x:.10g}"


def expanded(word):
    """The values that a word stands for: those of a range, or itself."""
    whole = re.fullmatch(r"(\d+):(\d+)", word)
    if whole:
        first, last = int(whole[1]), int(whole[2])
        if first > last:
            raise StudyError(f"'{word}' is no range: {first} is above {last}")
        return [str(k) for k in range(first, last + 1)]
    parts = word.split(":")
    if len(parts) < 2 or any(number(part) is None for part in parts[:2]):
        return [word]
    log = parts[3:] == ["log"]
    if len(parts) < 3 or not parts[2].isdigit() or int(parts[2]) < 2 \
            or len(parts) > 3 and not log:
        raise StudyError(f"'{word}' is no range: write 1:5 for whole numbers,"
                         " 500:5000:7 or 500:5000:7:log for seven values")
    low, high = float(parts[0]), float(parts[1])
    if log and min(low, high) <= 0:
        raise StudyError(f"'{word}' is no range of ratios")
    space = np.geomspace if log else np.linspace
    return [shown(x) for x in space(low, high, int(parts[2]))]


def option(text, what):
    """name=values of an option."""
    name, equal, values = text.partition("=")
    if not equal or not name or not values:
        raise StudyError(f"{what} {text}: write name=values")
    return name, values


def write_csv(file, header, rows):
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(header)
    writer.writerows(rows)
    write_whole(file, text.getvalue())


def with_error(value, error):
    """0.153 ± 0.008: as many digits as the error has to say."""
    if value is None:
        return "-"
    if not error:
        return f"{value:.4g}"
    digits = 1 - int(np.floor(np.log10(error)))
    if -2 <= digits <= 6 and abs(value) < 1e6:
        return f"{value:.{max(digits, 0)}f} ± {error:.{max(digits, 0)}f}"
    return f"{value:.4g} ± {error:.2g}"


def print_table(header, rows):
    widths = [max(len(row[k]) for row in [header, *rows])
              for k in range(len(header))]
    for row in [header, *rows]:
        print("  ".join(word.rjust(width)
                        for word, width in zip(row, widths)))
