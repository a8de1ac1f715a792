"""Published works that derivations and kernels rest on."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Source:
    """A bibliographic record; `key` names it in derivations and claim files."""

    key: str
    authors: str
    title: str
    published: str
    rests_on: str

    def text(self) -> str:
        """One line as a bibliography prints it."""
        return f"{self.authors}: {self.title}. {self.published}."


KALATA = Source(
    "kalata-1984",
    "P. R. Kalata",
    "The Tracking Index: A Generalized Parameter for alpha-beta and alpha-beta-gamma Target "
    "Trackers",
    "IEEE Transactions on Aerospace and Electronic Systems AES-20 (1984), 174-182",
    "the tracking index and the steady-state alpha-beta filter",
)
RICCATI = Source(
    "lancaster-rodman-1995",
    "P. Lancaster, L. Rodman",
    "Algebraic Riccati Equations",
    "Oxford University Press, 1995",
    "a discrete algebraic Riccati equation has at most one stabilising solution",
)
SPECTRAL = Source(
    "anderson-moore-1979",
    "B. D. O. Anderson, J. B. Moore",
    "Optimal Filtering",
    "Prentice-Hall, 1979",
    "the innovation spectrum factors through the closed-loop polynomial",
)
LECTURE = Source(
    "kosuge-slides",
    "Y. Kosuge",
    "Fundamental Properties and Problems of Radar Target Tracking (lecture, in Japanese)",
    "Nagasaki University",
    "gain tables of the least-squares, random velocity and random acceleration filters",
)
GAUSS_MARKOV = Source(
    "kailath-sayed-hassibi-2000",
    "T. Kailath, A. H. Sayed, B. Hassibi",
    "Linear Estimation",
    "Prentice-Hall, 2000",
    "recursive least squares is the Kalman filter without process noise",
)
ELEMENTARY = Source(
    "rudin-1976",
    "W. Rudin",
    "Principles of Mathematical Analysis",
    "McGraw-Hill, 1976",
    "crossings of monotone functions follow their limit",
)
ALGEBRA = Source(
    "van-der-waerden-1991",
    "B. L. van der Waerden",
    "Algebra, Volume I",
    "Springer, 1991",
    "the casus irreducibilis: three real roots of an irreducible cubic defy real radicals",
)
PROBABILITY = Source(
    "feller-1971",
    "W. Feller",
    "An Introduction to Probability Theory and Its Applications, Volume II",
    "Wiley, 1971",
    "the characteristic function of the normal distribution",
)
SUZUKI = Source(
    "suzuki-position-velocity",
    "C. Suzuki",
    "Tracking Accuracy of Radar with Position and Velocity Measurements (in Japanese)",
    "Bulletin of a university",
    "the closed form of the steady state with position and velocity measured",
)
DOPPLER = Source(
    "kosuge-doppler",
    "Y. Kosuge, T. Koga, H. Miyazaki, X. Lu, T. Inaba",
    "Estimation of Location and Velocity Using Range and Doppler Measurements in a Multipath "
    "Environment by Taylor-series Estimation Method (in Japanese)",
    "IEICE Transactions on Communications (Japanese Edition), doi 10.14923/transcomj.2019JBP3014",
    "location from range and Doppler where each range may have a bias of its own",
)
MATRICES = Source(
    "lancaster-tismenetsky-1985",
    "P. Lancaster, M. Tismenetsky",
    "The Theory of Matrices",
    "Academic Press, 1985",
    "solutions of linear equations, of covariances and of time; eigenvectors of a matrix",
)
SINGER = Source(
    "singer-1970",
    "R. A. Singer",
    "Estimating Optimal Tracking Filter Performance for Manned Maneuvering Targets",
    "IEEE Transactions on Aerospace and Electronic Systems AES-6 (1970), 473-483",
    "the model of acceleration that fades exponentially, with its transition and process noise",
)
UPDATED = Source(
    "patent-4869403",
    "JP4869403B2, US7986262B2",
    "Radar tracking apparatus and method",
    "Patents, Japan 2012, United States 2011",
    "gains updated by the derivatives of both by the tracking index",
)

DEBIASED = Source(
    "lerro-bar-shalom-1993",
    "D. Lerro, Y. Bar-Shalom",
    "Tracking with Debiased Consistent Converted Measurements versus EKF",
    "IEEE Transactions on Aerospace and Electronic Systems 29 (1993), 1015-1022",
    "the debiased conversion of polar measurements",
)
UNBIASED = Source(
    "longbin-1998",
    "M. Longbin, S. Xiaoquan, Z. Yiyu, S. Z. Kang, Y. Bar-Shalom",
    "Unbiased Converted Measurements for Tracking",
    "IEEE Transactions on Aerospace and Electronic Systems 34 (1998), 1023-1027",
    "the unbiased conversion of polar measurements",
)
MODIFIED = Source(
    "duan-han-li-2004",
    "Z. Duan, C. Han, X. R. Li",
    "Comments on 'Unbiased Converted Measurements for Tracking'",
    "IEEE Transactions on Aerospace and Electronic Systems 40 (2004), 1374-1377",
    "the modified unbiased conversion of polar measurements",
)
TRACKER_LIBRARY = Source(
    "crouse-tcl-conversion-2025",
    "D. F. Crouse",
    "Tracker Component Library, functions pol2CartTaylor and spher2CartTaylor",
    "Source code in the public domain, GitHub repository "
    "USNavalResearchLaboratory/TrackerComponentLibrary",
    "a transcription of the three papers on conversions, with their equation numbers",
)

SOURCES: tuple[Source, ...] = (
    KALATA,
    RICCATI,
    SPECTRAL,
    LECTURE,
    GAUSS_MARKOV,
    ELEMENTARY,
    ALGEBRA,
    PROBABILITY,
    SUZUKI,
    MATRICES,
    DOPPLER,
    DEBIASED,
    UNBIASED,
    MODIFIED,
    TRACKER_LIBRARY,
    UPDATED,
    SINGER,
)
