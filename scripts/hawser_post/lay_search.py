"""Search for the smallest lay tension that meets the requirements, by bracketing."""
from dataclasses import dataclass

CLOSE = 0.005  # final width of the bracket relative to the tension
MOST_STEPS = 10  # steps by a factor of 2 until the bracket is found


@dataclass
class Lay:
    """Results of a lay with one tension."""
    tension: float  # N, at the upper end
    row: list  # as lay.HEAD, without the depth
    clearance: float  # m
    sagbend: float  # local buckling
    overbend: float = 0.0  # larger of local buckling and the simplified criterion of static strain


@dataclass
class Asked:
    clearance: float  # m, least clearance of the tip
    utilisation: float  # largest utilisation of the sagbend

    def missed(self, lay):
        """Requirements that a lay misses, "" if it meets all. Undefined values (NaN) miss their requirement."""
        if lay is None:
            return "no equilibrium"
        missed = [] if lay.clearance >= self.clearance else ["clearance at the tip too small"]
        if not lay.sagbend <= self.utilisation:
            missed.append("sagbend utilisation exceeded" if lay.sagbend > self.utilisation else "no sagbend to check")
        return ", ".join(missed)


def smallest(lay_at, asked, start, height):
    """Smallest tension whose lay meets the requirements, and one at most CLOSE below whose lay does not, by doubling
    or halving and then bisection: two pairs (tension, lay), or None. `lay_at` computes the lay for a tension [N] at
    the bottom of a catenary, which is larger by `height` [N] at its top; `start` is the first trial."""
    trial, keeps, fails = start, None, None
    while start / 2**MOST_STEPS <= trial <= start * 2**MOST_STEPS:
        lay = lay_at(trial)
        if asked.missed(lay):
            fails = trial, lay
        else:
            keeps = trial, lay
        if keeps and fails and keeps[0] - fails[0] <= CLOSE * (keeps[0] + height):
            break
        trial = trial * 2 if not keeps else trial / 2 if not fails else (keeps[0] + fails[0]) / 2
    return keeps, fails
