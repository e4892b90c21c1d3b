"""The kernel cache that the tool uses while it is timed: never the user's own."""

from lib import processes


def empty(folder):
    """Environment with a cache that holds nothing: morphcl's, and Mesa's for the peer."""
    return {"MORPHCL_CACHE_DIR": str(folder / "morphcl"), "MESA_SHADER_CACHE_DIR": str(folder / "mesa")}


def warmed(programs, folder, threads):
    """Environment with a cache that holds every kernel: what `morphcl warm` leaves behind."""
    environment = empty(folder)
    processes.output([programs["tool"], "warm", "--threads", threads], environment)
    return environment
