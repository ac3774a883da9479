"""The smallest tension of a lay that keeps to what is asked, between one that does and one that does not."""
from dataclasses import dataclass

CLOSE = 0.005  # of the tension: how far apart the two are at most
MOST_STEPS = 10  # by 2, up or down, until both are found


@dataclass
class Lay:
    """What comes out of one tension."""
    tension: float  # N, at the upper end
    row: list  # as lay.HEAD, without the depth
    clearance: float  # m
    sagbend: float  # local buckling
    overbend: float = 0.0  # the larger of local buckling and the simplified criterion of strain at rest


@dataclass
class Asked:
    clearance: float  # m, of the tip, at least
    utilisation: float  # of the sagbend, at most

    def missed(self, lay):
        """What a lay does not keep to, "" where it keeps to all. What could not be computed (NaN) is not kept to."""
        if lay is None:
            return "no equilibrium"
        missed = [] if lay.clearance >= self.clearance else ["too near the tip"]
        if not lay.sagbend <= self.utilisation:
            missed.append("the sagbend used up" if lay.sagbend > self.utilisation else "no sagbend to be checked")
        return ", ".join(missed)


def smallest(lay_at, asked, start, height):
    """The smallest tension whose lay keeps to what is asked, and one at most CLOSE below whose lay does not, by doubling or
    halving and then bisection: two pairs (tension, lay), None where there is none. `lay_at` makes the lay of a tension [N] at
    the bottom of a catenary, which at its top is larger by `height` [N]; `start` is the first that is tried."""
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
