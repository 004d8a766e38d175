"""CPU seconds of `photoncube progressive`, and from a curve of them to an error."""

import math
import resource
import subprocess


def seconds(who):
    """User and system time so far: of this process and its threads, or of the ended children."""
    used = resource.getrusage(who)
    return used.ru_utime + used.ru_stime


def progressive(program, scene, picture, side, passes, *options):
    """Makes a picture with the engine `format`, and returns the seconds of all threads and what the program printed."""
    start = seconds(resource.RUSAGE_CHILDREN)
    size = ["--size", f"{side}x{side}", "--passes", str(passes)]
    command = [program, "progressive", scene, "-o", picture, "--engine", "format", *size, *options]
    said = subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
    return seconds(resource.RUSAGE_CHILDREN) - start, said


def time_to(curve, error):
    """The seconds to an error on a curve of (seconds, error), interpolated on logarithmic scales; None beyond its errors."""
    points = sorted((math.log(reached), math.log(time)) for time, reached in curve)
    wanted = math.log(error)
    for (e0, t0), (e1, t1) in zip(points, points[1:]):
        if e0 <= wanted <= e1:
            part = (wanted - e0) / (e1 - e0) if e1 > e0 else 0.0
            return math.exp(t0 + (t1 - t0) * part)
    return None
