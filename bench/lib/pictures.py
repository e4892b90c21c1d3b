"""Whether two programs drew the same picture, by two figures of it."""

import json
import subprocess
import sys

# Programs differ by how they round vertices to the sub-pixel grid: a pixel centre closer to an edge than 1/256 pixel
# may fall on either side, which is one pixel in 128 along it. Silhouettes of 25,000 pixels make 200 pixels, 1e-4 of a
# picture of 1920 x 1080.
COVERED_SHARE, COVERED_LEAST = 1e-4, 4
# Several samples: where an outline begins to cover a pixel depends on how far the samples reach to that side, which is
# 0 with one and at most 0.664 pixel with the standard 16 (0.395 with 4); llvmpipe's patterns are these or upside down.
# So one of two pictures may have two thirds of a pixel more along those 25,000: 0.8 % of the picture. What an outline
# covers in all, and so the mean, is the same whatever the pattern, and has to agree as before.
COVERED_SHARE_BY_SAMPLES = 8e-3
# Half the spacing of halves below 1 is 2.4e-4; a program that cuts off where others round differs by twice that.
MEAN_RED_BOUND = 1e-3


def check_same(what, figures, covered_share=COVERED_SHARE):
    """`figures`: name of the program -> {"width", "height", "covered", "mean_red"}. All against the first; a difference
    ends this process."""
    (first, ours), *others = figures.items()
    for name, theirs in others:
        bound = max(COVERED_LEAST, covered_share * ours["width"] * ours["height"])
        for key, limit in (("covered", bound), ("mean_red", MEAN_RED_BOUND)):
            if abs(ours[key] - theirs[key]) > limit:
                sys.exit(f"{what}: {first} and {name} draw different pictures: {key} {ours[key]} and {theirs[key]}, "
                         f"more than {limit:g} apart")


def figures_of_file(programs, path):
    done = subprocess.run([programs["picture"], path], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{path}: {done.stderr.strip()}")
    return json.loads(done.stdout)
