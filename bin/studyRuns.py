"""Runs a case many times, with other values of some entries, and keeps the runs.

A run is a folder, an ordinary case, in <results>/runs. Its file run.json says
which values it has, what its files contained (by their hashes) and how far it
has come. So

  - a run that is there is not computed again, whatever the study was that made it;
  - a run that was interrupted goes on from its last written time if its
    controlDict says `startFrom latestTime`, and is run anew otherwise;
  - a run of which the case has changed since is neither used nor continued: the
    user is asked what to do with it.

Each folder is made under another name first. Whatever is killed, and when, a
folder in runs is whole. A run holds a lock that its processes inherit, so that no
two of them ever work in one folder.
"""

import ctypes
import fcntl
import hashlib
import io
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path

import acousticDEM
import foamEntries
from foamEntries import EntryError

# What a case has that its runs have to make themselves
NOT_COPIED = re.compile(
    r"\..*|log\..*|postProcessing|processor.*|__pycache__|dynamicCode"
    r"|.*\.(png|foam|html|mp4|gif)|lnInclude"
)
TIME = re.compile(r"(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")
PR_SET_PDEATHSIG = 1
# A run ends with the step that is nearest to its end: as a share of that
NEAR = 0.01


class StudyError(Exception):
    """What ends a study, in a message."""


def digest(data):
    return hashlib.sha256(data).hexdigest()


def number(text):
    """The number that a text is, or None."""
    try:
        return float(text)
    except (TypeError, ValueError):
        return None


def write_whole(file, text):
    """The file is there as a whole, or as it was."""
    new = file.with_name(file.name + ".new")
    new.write_text(text)
    os.replace(new, file)


def die_with_parent(parent):
    """Called in a child: it ends if the study does, whatever ends that."""
    try:
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
    except (OSError, AttributeError):
        return  # not Linux: the lock of the run still keeps others away
    if os.getppid() != parent:
        os._exit(1)


@dataclass
class Run:
    """One set of values: names of entries, such as seed, and their values."""

    values: dict
    settings: dict  # (file, path) of entries, and their values
    name: str = ""
    names: dict = field(default_factory=dict)  # short ones of the keys
    folder: Path = None
    files: dict = field(default_factory=dict)  # that are changed
    hashes: dict = field(default_factory=dict)
    key: str = ""
    end: float = None
    state: str = "new"
    reason: str = ""
    note: str = ""
    process: subprocess.Popen = None
    lock: io.IOBase = None
    commands: list = field(default_factory=list)
    started: float = 0
    seconds: float = 0

    def label(self):
        return " ".join(f"{self.names.get(key, key)}={value}"
                        for key, value in self.values.items())

    def file(self):
        return self.folder/"run.json"

    def save(self, **more):
        write_whole(self.file(), json.dumps({
            "values": self.values, "state": self.state, "key": self.key,
            "end": self.end, "inputs": self.hashes, "reason": self.reason,
            "seconds": round(self.seconds, 1),
            "left": [" ".join(command) for command in self.commands], **more,
        }, indent=1))

    def last_written(self):
        """The last time of which there is a folder, or None."""
        return max((float(path.name) for path in self.folder.iterdir()
                    if path.is_dir() and TIME.fullmatch(path.name)
                    and float(path.name) > 0), default=None)

    def last_time(self):
        """The last row of the tables, or None."""
        try:
            return max(float(acousticDEM.columns(self.folder, cloud)["time_s"][-1])
                       for cloud in acousticDEM.clouds(self.folder))
        except (acousticDEM.TableError, ValueError, KeyError, IndexError):
            return None

    def time_now(self):
        """The time that the solver has printed last."""
        for log in self.folder.glob("log.*"):
            with log.open("rb") as text:
                text.seek(max(0, log.stat().st_size - 4000))
                found = re.findall(rb"(?m)^Time = (\S+)", text.read())
            if found:
                return number(found[-1])
        return None


def cause(folder, command, status):
    """Why a program has failed, from the end of its log."""
    log = Path(folder, f"log.{command}")
    text = log.read_text(errors="replace") if log.exists() else ""
    found = re.findall(
        r"--> FOAM FATAL.*?(?=\n\s*From |\n\s*FOAM exiting|\n\s*FOAM aborting|\Z)",
        text, re.DOTALL)
    if found:
        said = " ".join(found[-1].split())
        said = re.sub(r"^--> FOAM FATAL (IO )?ERROR:?\s*(\([^)]*\))?\s*", "", said)
    elif status < 0:
        said = f"killed by {signal.Signals(-status).name}"
    else:
        lines = [line.strip() for line in text.splitlines() if line.strip()]
        said = f"exit status {status}" + (f": {lines[-1]}" if lines else "")
    return f"{command}: {said[:600]} (see {log})"


class Case:
    """The case that is varied: its files, and what is to be run in it."""

    def __init__(self, folder, commands=None, leave_out=()):
        self.folder = Path(folder).resolve()
        if not (self.folder/"system"/"controlDict").is_file():
            raise StudyError(f"{folder} is no case: it has no"
                             " system/controlDict")
        self.leave_out = [Path(path).resolve() for path in leave_out]
        self.files = {}
        self.times = []
        self.collect(self.folder)
        self.entries = foamEntries.Entries(self.files)
        self.hashes = {name: digest(self.hashed(name, data))
                       for name, data in self.files.items()}
        self.has_mesh = any(name.startswith("constant/polyMesh/faces")
                            for name in self.files)
        self.commands = commands

    def collect(self, folder):
        """The contents of all files that a run needs."""
        names = {path.name for path in folder.iterdir()}
        for path in sorted(folder.iterdir()):
            top = folder == self.folder
            if NOT_COPIED.fullmatch(path.name) or path in self.leave_out:
                continue
            if top and path.is_dir() and TIME.fullmatch(path.name):
                if path.name != "0":
                    self.times.append(path.name)
                    continue
                if "0.orig" in names:
                    continue
            if folder.name == "0" and path.name in ("lagrangian", "uniform"):
                continue
            if top and (path/"runs").is_dir() and (path/"lock").is_file():
                continue  # of another study
            if path.is_dir():
                self.collect(path)
            elif path.is_file():
                self.files[str(path.relative_to(self.folder))] \
                    = path.read_bytes()
            elif path.is_symlink():
                raise StudyError(f"{path} is a link to nowhere")

    @staticmethod
    def hashed(name, data):
        """What counts of a file: all but the end of the run, since a run that
        is to go on for longer is the same."""
        if not name.startswith("system/") or b"endTime" not in data:
            return data
        try:
            text = data.decode()
            here = foamEntries.entries(text, name)
        except (EntryError, UnicodeDecodeError):
            return data
        for entry in reversed(here):
            if entry.path == ("endTime",):
                text = text[:entry.start] + text[entry.end:]
        return text.encode()

    def end_of(self, files):
        """The end of a run as far as it is a number in some file."""
        for name in ("system/controlDict", *sorted(files)):
            if not name.startswith("system/") or name not in files:
                continue
            try:
                here = foamEntries.entries(files[name].decode(), name)
            except (EntryError, UnicodeDecodeError):
                continue
            for entry in here:
                if entry.path == ("endTime",) and number(entry.value) is not None:
                    return number(entry.value)
        return None

    def goes_on(self, files):
        """Whether the solver goes on from the last time that it has written."""
        here = foamEntries.entries(files["system/controlDict"].decode(),
                                   "system/controlDict")
        return any(entry.path == ("startFrom",) and entry.value == "latestTime"
                   for entry in here)

    def resolve(self, name):
        """(file, path) of an entry that is named."""
        found = self.entries.find(name)
        if isinstance(found, tuple):
            return found
        return found.file, found.path

    def prepare(self, run):
        """The files that the run changes, and the hashes of all."""
        run.files = {}
        for (file, path), value in run.settings.items():
            data = run.files.get(file, self.files[file])
            run.files[file] = foamEntries.changed(
                data.decode(), file, path, value).encode()
        run.hashes = {**self.hashes, **{
            name: digest(self.hashed(name, data))
            for name, data in run.files.items()}}
        commands = self.commands_of(run)
        run.hashes["commands"] = "; ".join(commands)
        run.commands = [command.split() for command in commands]
        run.key = digest(json.dumps(run.hashes, sort_keys=True).encode())
        run.end = self.end_of({**self.files, **run.files})

    def commands_of(self, run):
        if self.commands:
            return self.commands
        mesh = "system/blockMeshDict"
        if not self.has_mesh and mesh in self.files:
            return ["blockMesh", "acousticDEMFoam"]
        if mesh in run.files:
            raise StudyError(
                f"the study changes {mesh}, but the case has a mesh already:"
                " remove constant/polyMesh of the case, or say what makes the"
                " mesh, such as --commands \"blockMesh; acousticDEMFoam\"")
        return ["acousticDEMFoam"]

    def copy(self, run):
        """The folder of the run, whole or not at all."""
        new = run.folder.with_name(run.folder.name + ".new")
        shutil.rmtree(new, ignore_errors=True)
        for name, data in {**self.files, **run.files}.items():
            file = new/name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(data)
        if (new/"0.orig").is_dir():
            shutil.copytree(new/"0.orig", new/"0")
        folder, run.folder = run.folder, new
        run.save()
        run.folder = folder
        # Never a folder of which a part is gone
        old = folder.with_name(folder.name + ".old")
        shutil.rmtree(old, ignore_errors=True)
        if folder.exists():
            folder.rename(old)
        new.rename(folder)
        shutil.rmtree(old, ignore_errors=True)


def names_of(points):
    """Short names for the keys of points: the end of the path, of the first of
    several entries, if that is unique."""
    keys = list(dict.fromkeys(key for point in points for key in point))
    ends = [re.split("[:/]", key.split("+")[0])[-1] for key in keys]
    return {key: end if ends.count(end) == 1 else key
            for key, end in zip(keys, ends)}


class Study:
    """Runs of one case, in a folder of results.

    jobs: how many at a time; commands: programs that make a run, default
    blockMesh if the case has no mesh, and acousticDEMFoam; levels: values that
    are names, and the entries that each of them sets; anew: whether runs of a
    case that was another one are thrown away; slim: whether the particles are,
    once a run is complete; file: where the study is written down.
    """

    def __init__(self, case, results, jobs=None, commands=None, levels=None,
                 anew=False, slim=False, file=None, out=sys.stdout):
        self.results = Path(results).resolve()
        self.runs = self.results/"runs"
        # What is varied is no part of what is varied
        files = [Path(case, "system", "studyDict"), *([file] if file else [])]
        self.case = Case(case, commands, [self.results, *files])
        self.jobs = jobs or os.cpu_count()
        self.levels = levels or {}
        self.anew, self.slim, self.out = anew, slim, out
        self.known = {}
        self.live = ""
        self.computed = 0
        self.runs.mkdir(parents=True, exist_ok=True)
        self.lock = (self.results/"lock").open("a")
        try:
            fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise StudyError(f"another study is at work in {self.results}") \
                from None
        for kind in (".new", ".old"):
            for left in self.runs.glob(f"*{kind}"):
                shutil.rmtree(left, ignore_errors=True)
        if self.case.times:
            self.say("NOTE: the times " + " ".join(self.case.times[:5])
                     + " of the case are not copied: its runs begin anew")

    def say(self, text):
        if self.live:
            print("\r" + " "*len(self.live), end="\r", file=self.out)
            self.live = ""
        print(text, file=self.out, flush=True)

    def settings(self, point):
        """(file, path) of the entries, and values, of a point."""
        settings = {}
        for key, value in point.items():
            level = self.levels.get(key)
            if level is None:
                level = {name: value for name in key.split("+")}
            elif value not in level:
                raise StudyError(f"{key} has no '{value}'; it has "
                                 + " ".join(level))
            else:
                level = level[value]
            for name, text in level.items():
                settings[self.case.resolve(name)] \
                    = foamEntries.checked_value(text)
        return settings

    def run_of(self, point, names):
        settings = self.settings(point)
        for file, path in settings:
            found = self.case.entries.find(f"{file}:{'/'.join(path)}")
            note = f"{file} has no {'/'.join(path)}: it is added in the runs"
            if isinstance(found, tuple) and note not in self.known:
                self.known[note] = None
                self.say(f"NOTE: {note}")
        run = Run(dict(point), settings, names=names)
        # A run that is longer is the same run
        words = "_".join(f"{names[key]}={value}" for key, value in point.items()
                         if names[key] != "endTime")
        run.name = re.sub(r"[^\w.+=-]+", "-", words) or "case"
        if len(run.name) > 100 or run.name != words:
            run.name = f"{run.name[:90]}_{digest(words.encode())[:8]}"
        run.folder = self.runs/run.name
        self.case.prepare(run)
        return run

    def find(self):
        """The complete runs that are there, by their inputs."""
        there = {}
        for file in sorted(self.runs.glob("*/run.json")):
            try:
                kept = json.loads(file.read_text())
            except ValueError:
                continue
            if kept["state"] == "done":
                there[kept["key"]] = file.parent
        return there

    def run(self, points):
        """Runs what is not there yet; returns a Run for each of the points,
        whose state is done, failed or stopped."""
        names = names_of(points)
        runs = [self.run_of(point, names) for point in points]
        unique = {}
        for run in runs:
            other = unique.setdefault(run.key, run)
            if run.end and other.end and run.end > other.end:
                unique[run.key] = run
        complete = self.find()
        changed, left = [], []
        for run in unique.values():
            if run.key in complete:
                run.folder = complete[run.key]
            kept = self.kept(run)
            if kept is None:
                left.append(run)
            elif kept["key"] != run.key:
                if kept["state"] in ("done", "running", "stopped"):
                    changed.append((run, kept))
                left.append(run)
            else:
                run.seconds = kept["seconds"]
                if not self.is_done(run, kept):
                    left.append(run)
        if changed and not self.anew:
            raise StudyError(self.of_changed(changed, len(unique)))

        self.computed += len(left)
        self.execute(left, len(unique))
        for run in runs:
            first = unique[run.key]
            run.folder, run.state, run.reason, run.seconds = (
                first.folder, first.state, first.reason, first.seconds)
        return runs

    @staticmethod
    def kept(run):
        try:
            return json.loads(run.file().read_text())
        except (OSError, ValueError):
            return None

    def is_done(self, run, kept):
        """Whether the run is there as far as it is wanted."""
        if kept["state"] != "done":
            return False
        if run.end is None or kept["end"] is None or kept["end"] == run.end:
            run.state = "done"
            return True
        if kept["end"] > run.end:
            # Longer than wanted: if there is a row at the end, it will do
            times = [t for cloud in acousticDEM.clouds(run.folder) for t in
                     acousticDEM.columns(run.folder, cloud)["time_s"]]
            near = [t for t in times if abs(t - run.end) <= NEAR*run.end]
            if near:
                run.state = "done"
                return True
        return False

    @staticmethod
    def of_changed(changed, total):
        files = sorted({
            name for run, kept in changed
            for name in {*run.hashes, *kept["inputs"]}
            if run.hashes.get(name) != kept["inputs"].get(name)})
        return (
            f"the case is not the one of {len(changed)} of the {total} runs"
            f" that are there: changed since are {' '.join(files)}. Nothing is"
            " mixed and nothing was run. Say --anew to throw these runs away and"
            " run them again, or --results FOLDER to begin beside them; or undo"
            " the change")

    # Running

    def begin(self, run):
        """Makes the folder, or goes on in it, and starts the first program."""
        kept = self.kept(run)
        lock = self.runs/f".{run.folder.name}.lock"
        run.lock = lock.open("a")
        try:
            fcntl.flock(run.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            self.say(f"waiting for a process that is still at work in"
                     f" {run.folder}")
            fcntl.flock(run.lock, fcntl.LOCK_EX)

        run.note = ""
        files = {**self.case.files, **run.files}
        same = kept is not None and kept["key"] == run.key
        if same and kept["state"] != "new":
            at = run.last_written()
            longer = kept["state"] == "done" and (kept["end"] or 0) < run.end
            if at and self.case.goes_on(files) \
                    and (longer or kept["state"] in ("running", "stopped")):
                left = kept["left"] or [" ".join(run.commands[-1])]
                run.commands = [command.split() for command in left]
                run.note = f"goes on from {at:g} s"
                # The end of the run may be another one
                for name, data in files.items():
                    if name.startswith("system/"):
                        (run.folder/name).write_bytes(data)
            else:
                run.note = {
                    "failed": "has failed, and is run again",
                    "done": "is run anew, since its end is another one",
                }.get(kept["state"], "was interrupted, and is run anew")
        if not run.note.startswith("goes on"):
            run.seconds = 0
            self.case.copy(run)
        if run.note:
            self.say(f"{run.label()}: {run.note}")
        run.started = time.monotonic()
        self.next_command(run)

    def next_command(self, run):
        """Starts the next program of a run."""
        run.state = "running"
        run.save()
        command = run.commands[0]
        environment = {**os.environ, "PWD": str(run.folder)}
        if environment.get("ACOUSTICDEM_PRELOAD"):
            environment["LD_PRELOAD"] = environment["ACOUSTICDEM_PRELOAD"]
        parent = os.getpid()
        with (run.folder/f"log.{command[0]}").open("a") as log:
            try:
                run.process = subprocess.Popen(
                    command, cwd=run.folder, stdin=subprocess.DEVNULL,
                    stdout=log, stderr=log, env=environment,
                    pass_fds=[run.lock.fileno()],
                    preexec_fn=lambda: die_with_parent(parent))
            except OSError as error:
                raise StudyError(f"cannot start {command[0]}: {error.strerror}"
                                 " (is bin/environment sourced?)") from None

    def advance(self, run):
        """Whether the run has ended; goes on with its next program if not."""
        status = run.process.poll()
        if status is None:
            return False
        command = run.commands[0][0]
        if status == 0 and len(run.commands) > 1:
            run.commands.pop(0)
            self.next_command(run)
            return False
        run.seconds += time.monotonic() - run.started
        if status:
            if status > 0 and run.note.startswith("goes on"):
                self.say(f"{run.label()}: cannot go on"
                         f" ({cause(run.folder, command, status)}); it is run"
                         " anew")
                run.note, run.seconds = "", 0
                self.case.prepare(run)
                self.case.copy(run)
                run.started = time.monotonic()
                self.next_command(run)
                return False
            run.state = "stopped" if status < 0 else "failed"
            run.reason = cause(run.folder, command, status)
        else:
            at = run.last_time()
            if at is None:
                run.state = "failed"
                run.reason = f"{command} left no agglomeration.csv in" \
                    f" {run.folder}/postProcessing"
            elif run.end is not None and at < run.end*(1 - NEAR):
                run.state = "stopped"
                run.reason = f"{command} has stopped at {at:g} s of" \
                    f" {run.end:g} s; the same study goes on with it"
            else:
                run.state = "done"
                run.commands.pop(0)
                if self.slim:
                    for path in run.folder.iterdir():
                        if path.is_dir() and TIME.fullmatch(path.name):
                            shutil.rmtree(path)
        run.save()
        run.lock.close()
        return True

    def execute(self, left, total):
        """As many at a time as there are jobs."""
        waiting, active, ended = list(left), [], []
        start = time.monotonic()
        shown = 0
        try:
            while waiting or active:
                while waiting and len(active) < self.jobs:
                    run = waiting.pop(0)
                    active.append(run)
                    self.begin(run)
                for run in list(active):
                    if self.advance(run):
                        active.remove(run)
                        ended.append(run)
                        self.report(run, ended, active, waiting, total, start)
                if self.out.isatty() and time.monotonic() > shown + 1:
                    shown = time.monotonic()
                    self.show(ended, active, waiting, total, start)
                time.sleep(0.02)
        except BaseException:
            self.stop(active)
            raise

    @staticmethod
    def stop(active):
        """Ends the programs of this study; their runs can go on later."""
        for run in active:
            if run.process and run.process.poll() is None:
                run.process.terminate()
        late = time.monotonic() + 5
        for run in active:
            if run.process:
                try:
                    run.process.wait(max(0, late - time.monotonic()))
                except subprocess.TimeoutExpired:
                    run.process.kill()
                    run.process.wait()

    def to_the_end(self, ended, active, waiting, start):
        """Seconds, from what has run so far; None if nobody knows yet."""
        passed = time.monotonic() - start
        parts = len(ended)
        for run in active:
            now = run.time_now()
            if now and run.end:
                parts += min(now/run.end, 1)
        if parts <= 0.01:
            return None
        return passed*(len(ended) + len(active) + len(waiting) - parts)/parts

    def show(self, ended, active, waiting, total, start):
        """A line that is written over."""
        seconds = self.to_the_end(ended, active, waiting, start)
        text = (f"[{total - len(active) - len(waiting)}/{total}]"
                f" {len(active)} at work"
                + ("" if seconds is None else f", {duration(seconds)} to the"
                   " end"))
        print("\r" + text.ljust(len(self.live)), end="", flush=True,
              file=self.out)
        self.live = text

    def report(self, run, ended, active, waiting, total, start):
        done = total - len(active) - len(waiting)
        said = f"FAILED: {run.reason}"
        if run.state == "done":
            said = f"{run.seconds:.1f} s"
        rest = self.to_the_end(ended, active, waiting, start)
        left = f", {duration(rest)} to the end" if rest and active + waiting \
            else ""
        self.say(f"[{done}/{total}] {run.label()}: {said}{left}")


def duration(seconds):
    if seconds < 100:
        return f"{seconds:.0f} s"
    if seconds < 6000:
        return f"{seconds/60:.0f} min"
    return f"{seconds/3600:.1f} h"


def results_of(run):
    """The last row of each table of a run, up to its end: by name, with the name
    of the cloud before it if there are several."""
    row = {}
    there = acousticDEM.clouds(run.folder)
    for cloud in there:
        before = f"{cloud}." if len(there) > 1 else ""
        for name in ("agglomeration", "quantities"):
            if cloud not in acousticDEM.clouds(run.folder, name):
                continue
            table = acousticDEM.columns(run.folder, cloud, name)
            times = table.pop("time_s")
            if not len(times):
                continue
            last = -1 if not run.end else abs(times - run.end).argmin()
            if run.end and abs(times[last] - run.end) > NEAR*run.end:
                raise StudyError(
                    f"the table {name} of {run.folder} has no row at"
                    f" {run.end:g} s: report more often")
            for column, values in table.items():
                row.setdefault(before + column, values[last].item())
    return row
