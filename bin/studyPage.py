"""Plots and page of bin/study."""

import base64
import html
import re

import matplotlib.pyplot as plt
import numpy as np
import runTables
from matplotlib.ticker import LogLocator
from studyRuns import number, write_whole

STYLE = """
:root { color-scheme: light dark; --line: #8886; --soft: #8882; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 60rem; margin: auto;
       padding: 1rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.2rem; margin-top: 2rem; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
.wide { overflow-x: auto; }
th, td { padding: .25rem .75rem; border-bottom: 1px solid var(--line);
         text-align: right; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; }
img { max-width: 100%; background: white; border-radius: 4px; }
pre { background: var(--soft); padding: .75rem; overflow-x: auto;
      border-radius: 4px; white-space: pre-wrap; }
.warning { border-left: 4px solid #E69F00; padding-left: .75rem; }
.best { border-left: 4px solid #009E73; padding-left: .75rem; }
@media print { body { max-width: none; } h2 { break-after: avoid; } }
"""


def warnings_of(runs):
    """Those of the logs, numbers apart, and in how many runs they stand."""
    found = {}
    for run in runs:
        own = set()
        for log in run.folder.glob("log.*"):
            text = log.read_text(errors="replace")
            for match in re.finditer(
                    r"--> FOAM Warning :\s*(?:From [^\n]*\n\s*in file [^\n]*\n)?"
                    r"\s*(.*?)(?=\n\s*\n|\Z)", text, re.DOTALL):
                own.add(" ".join(match[1].split()))
        for text in own:
            kind = re.sub(r"\d[\d.e+-]*", "#", text)
            first, count = found.get(kind, (text, 0))
            found[kind] = (first, count + 1)
    return {first: count for first, count in found.values()}


def file_name(column):
    return re.sub(r"\W+", "_", column)


def axis_of(table):
    """The factor along the abscissa: the first of those with the most numbers;
    None if no factor has numbers only."""
    best, most = None, 1
    for k, name in enumerate(table.factors):
        values = {key[k] for key, *_ in table.points}
        if all(number(value) is not None for value in values) \
                and len(values) > most:
            best, most = k, len(values)
    return best


def label_of(column):
    return column.replace("_", " ")


def label_axis(axes, values):
    """Logarithmic if the values are far apart, with plain numbers."""
    low, high = min(values), max(values)
    if low > 0 and high/low >= 5:
        axes.set_xscale("log")
        axes.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axes.xaxis.set_major_formatter("{x:g}")
        axes.xaxis.set_minor_formatter("")


def curves(table, column, k):
    """A curve for each combination of the other factors."""
    figure, axes = plt.subplots(figsize=(6.4, 4.2), layout="constrained")
    groups = {}
    for key, _, point in table.points:
        other = tuple(value for j, value in enumerate(key) if j != k)
        value, error = point[column]
        if value is not None:
            groups.setdefault(other, []).append(
                (float(key[k]), value, error or 0))
    others = [table.names[name] for j, name in enumerate(table.factors) if j != k]
    for n, (other, rows) in enumerate(groups.items()):
        x, y, e = np.array(sorted(rows)).T
        label = ", ".join(f"{name} {value}"
                          for name, value in zip(others, other))
        axes.errorbar(x, y, e, marker="o", ms=4, capsize=3, color=f"C{n % 8}",
                      ls=("-", "--", ":", "-.")[n//8 % 4], label=label or None)
    label_axis(axes, {row[0] for rows in groups.values() for row in rows})
    axes.set_xlabel(table.names[table.factors[k]])
    axes.set_ylabel(label_of(column))
    if others and len(groups) <= 32:
        axes.legend(fontsize=8 if len(groups) > 6 else 9)
    return figure


def bars(table, column):
    """For factors that are no numbers."""
    rows = [(" ".join(key) or "all", *point[column])
            for key, _, point in table.points if point[column][0] is not None]
    figure, axes = plt.subplots(
        figsize=(6.4, 1.2 + 0.35*len(rows)), layout="constrained")
    y = np.arange(len(rows))
    axes.barh(y, [row[1] for row in rows], color="C0",
              xerr=[row[2] or 0 for row in rows], capsize=3)
    axes.set_yticks(y, [row[0] for row in rows])
    axes.invert_yaxis()
    axes.set_xlabel(label_of(column))
    return figure


def surface(table, column):
    """A map, if there are two factors of at least four numbers each."""
    if len(table.factors) != 2:
        return None
    sides = [sorted({key[k] for key, *_ in table.points}, key=lambda v:
                    number(v) if number(v) is not None else 0) for k in (0, 1)]
    if any(len(side) < 4 or any(number(v) is None for v in side)
           for side in sides):
        return None
    z = np.full((len(sides[1]), len(sides[0])), np.nan)
    for key, _, point in table.points:
        value = point[column][0]
        z[sides[1].index(key[1]), sides[0].index(key[0])] \
            = np.nan if value is None else value
    figure, axes = plt.subplots(figsize=(6.4, 4.4), layout="constrained")
    x, y = ([float(v) for v in side] for side in sides)
    drawn = axes.contourf(x, y, z, 12, cmap="viridis")
    axes.plot(*np.meshgrid(x, y), "k.", ms=2)
    label_axis(axes, x)
    axes.grid(False)
    axes.set_xlabel(table.names[table.factors[0]])
    axes.set_ylabel(table.names[table.factors[1]])
    figure.colorbar(drawn, label=label_of(column))
    return figure


def plots(table, columns):
    """A picture per column that is shown, with error bars of the seeds."""
    written = []

    def save(figure, name):
        target = table.results/f"{name}.png"
        runTables.save(figure, target)
        plt.close(figure)
        written.append(target)

    if len(table.points) < 2:
        return written
    print()
    k = axis_of(table)
    for column in columns:
        save(bars(table, column) if k is None else curves(table, column, k),
             file_name(column))
        if (figure := surface(table, column)) is not None:
            save(figure, f"{file_name(column)}_map")
    return written


def plot_best(study, plan, found, names):
    """The points of a search, the fit, and the top with its error."""
    best, rows, _, searched, search = found
    z, y = search.known()
    y = plan.sign*y
    figure, axes = plt.subplots(figsize=(6.4, 4.2), layout="constrained")

    def real(u, k):
        _, low, high, log = searched[k]
        return low*(high/low)**u if log else low + u*(high - low)

    if len(searched) == 1:
        error = y.std(axis=1, ddof=1)/np.sqrt(y.shape[1]) \
            if y.shape[1] > 1 else None
        u = np.linspace(best.low[0], best.high[0], 101)
        axes.errorbar(real(z[:, 0], 0), y.mean(axis=1), error, fmt="o", ms=4,
                      capsize=3, label="runs, mean of the seeds")
        axes.plot(real(u, 0), plan.sign*best.fit(u[:, None]), color="C1",
                  label="fit")
        _, x, dx, _ = rows[0]
        axes.axvspan(x - dx, x + dx, color="C2", alpha=0.3, lw=0,
                     label="optimum and its standard error")
        axes.axvline(x, color="C2", lw=1)
        axes.set_ylabel(label_of(plan.wanted))
    else:
        drawn = axes.scatter(real(z[:, 0], 0), real(z[:, 1], 1),
                             c=y.mean(axis=1), s=36, cmap="viridis",
                             edgecolors="0.3", linewidths=0.5)
        axes.errorbar(rows[0][1], rows[1][1], rows[1][2], rows[0][2],
                      fmt="*", ms=12, capsize=3, color="C1",
                      label="optimum and its standard error")
        axes.set_ylabel(names[rows[1][0]])
        if searched[1][3]:
            axes.set_yscale("log")
        figure.colorbar(drawn, label=label_of(plan.wanted))
    axes.set_xlabel(names[rows[0][0]])
    if searched[0][3]:
        label_axis(axes, searched[0][1:3])
    axes.legend(frameon=True)
    target = study.results/"optimum.png"
    runTables.save(figure, target)
    plt.close(figure)
    return target


def table_of(header, rows):
    def line(words, tag):
        cells = "".join(f"<{tag}>{html.escape(str(word))}</{tag}>"
                        for word in words)
        return f"<tr>{cells}</tr>"
    body = "\n".join(line(row, "td") for row in rows)
    return ('<div class="wide"><table>\n<thead>' + line(header, "th")
            + f"</thead>\n<tbody>\n{body}\n</tbody></table></div>")


def image(picture):
    data = base64.b64encode(picture.read_bytes()).decode()
    return (f'<p><img alt="{html.escape(picture.stem)}"'
            f' src="data:image/png;base64,{data}"></p>')


def write_page(page, title, parts):
    write_whole(page, (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{html.escape(title)}</title>\n<style>{STYLE}</style>"
        f"</head>\n<body>\n<h1>{html.escape(title)}</h1>\n"
        + "\n".join(parts) + "\n</body></html>\n"))


def versions_of(runs):
    """Of the solvers that made the runs."""
    found = set()
    for run in runs:
        for log in run.folder.glob("log.*"):
            with log.open(errors="replace") as text:
                said = re.search(r"(?m)^acousticDEM \d[^\n]*", text.read(20000))
            if said:
                found.add(said[0])
    return sorted(found)


def write(study, table, columns, pictures, said, warnings, command):
    """The page, one file that needs no other."""
    name = study.case.folder.name
    title = name
    if table.factors:
        title += ": " + ", ".join(table.names[f] for f in table.factors)
    parts = []
    parts.append(
        f"<p>{len(table.runs)} runs of the case"
        f" <code>{html.escape(str(study.case.folder))}</code>"
        + (f"; {len(table.failed)} more have failed" if table.failed else "")
        + ". Mean and standard error are those of the seeds.</p>"
        f"<pre>{html.escape(command)}</pre>")
    if said:
        parts.append('<h2>Optimum</h2><pre class="best">'
                     + html.escape("\n".join(said)) + "</pre>")
    parts.append("<h2>Results</h2>" + table_of(*table.text_rows(columns)))
    parts += [image(picture) for picture in pictures]
    versions = versions_of(table.runs)
    if len(versions) > 1:
        warnings = {**warnings, "the runs were made by several versions: "
                    + "; ".join(versions): len(table.runs)}
    if warnings or table.failed:
        parts.append("<h2>Warnings</h2>")
    for text, count in warnings.items():
        parts.append(f'<p class="warning">{html.escape(text)} ({count} runs)</p>')
    for run in table.failed:
        parts.append('<p class="warning">Failed: '
                     + html.escape(f"{run.label()}: {run.reason}") + "</p>")

    # What the runs have in common; what varies stands above
    parts.append("<h2>The case</h2>")
    files = {"constant/aerosolProperties", "constant/acousticProperties",
             "system/controlDict"}
    for run in table.runs:
        files.update(run.files)
    for file in sorted(files & set(study.case.files)):
        text = study.case.files[file].decode(errors="replace")
        parts.append(
            f"<details><summary><code>{html.escape(file)}</code></summary>"
            f"<pre>{html.escape(text)}</pre></details>")
    parts.append("<h2>Made by</h2><p>"
                 + html.escape("; ".join(versions) or "acousticDEM")
                 + "</p>")
    page = study.results/"study.html"
    write_page(page, title, parts)
    return page
