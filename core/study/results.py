"""Results of a study: frozen, in SI units, nothing computed later."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import groupby

from core.capacity.accuracy import Accuracy
from core.capacity.closed_forms import PowerLaw
from core.capacity.fragility import Fragility
from core.capacity.ida import Ida, Search
from core.capacity.scale_free_law import Estimate
from core.case.hinges import WallPart, variant_key
from core.case.schema import Case
from core.case.wall import Wall
from core.codes.collapse_rate import StateRate
from core.codes.demand import SeismicDemand
from core.codes.eq9 import Inequality
from core.codes.kinematic import KinematicAnalysis
from core.codes.kinematic_chain import restraint_multiplier_at_rest
from core.codes.record_compatibility import Compliance
from core.codes.record_sample import SampleInterval
from core.codes.risk import Risk
from core.codes.vertical_bending import bending, uplift_multiplier
from core.ground.ground_motion import GroundMotion
from core.rocking.history import History
from core.rocking.methods import AUTO, Method, resolve_auto
from core.setting.floors import Floor
from core.setting.record_selection import Selection
from core.text.sentence import Sentence
from core.units import G
from core.variation.assessment import Assessment
from core.variation.measures import Measure
from core.variation.swings import Sensitivity
from core.wall.block import Block
from core.wall.impact import Restitution
from core.wall.kinematics import Kinematics, kinematics
from core.wall.moment_rotation import MomentLaw
from core.wall.rocking_model import RockingModel


@dataclass(frozen=True)
class Run:
    """One wall under one record of one sign.

    record : its name for people; motion : its index in the study
    scale : multiplier of the record at q
    q_eff : Eq. 12
    """

    record: str
    motion: int
    polarity: int
    ida: Ida
    scale: float | None
    q_eff: float | None


@dataclass(frozen=True)
class RecordResult:
    """Governing values of one record: the lower of both signs, quantity by quantity.

    record : its name for people; motion : its index in the study
    polarity : of q
    q_slv_safe : the lower of q_slv_low and q_slv_robust, which the linear check takes
    intensity : of the record [m]
    pga : of the motion under the wall [m/s2]
    scaled : Lambda of Ribalta's law (core/capacity/scale_free_law.py); None where the closed forms do not hold
    closed_form_q_eff, closed_form_q : Eq. 15, 16; None above the ground
    """

    record: str
    motion: int
    polarity: int | None
    q: float | None
    q_robust: float | None
    q_slv: float | None
    q_slv_low: float | None
    q_slv_robust: float | None
    q_slv_safe: float | None
    q_eff: float | None
    intensity: float
    pga: float
    scaled: float | None
    closed_form_q_eff: float | None
    closed_form_q: float | None


@dataclass(frozen=True)
class WallResult:
    """Results of one wall and mechanism; set values are None where the set has none. floor : above the ground; error :
    traceback of what went wrong in a wall that has no number for it"""

    part: WallPart
    block: Block
    mechanism: str
    restitution: Restitution
    law: MomentLaw
    model: RockingModel
    runs: tuple[Run, ...]
    per_record: tuple[RecordResult, ...]
    set_rule: str | None
    q_set: float | None
    q_min: float | None
    q_robust_set: float | None
    q_slv_set: float | None
    q_slv_low_set: float | None
    q_slv_robust_set: float | None
    q_slv_safe_set: float | None
    power_law: PowerLaw | None
    fragility: Fragility | None
    closed_form_q_eff: float | None
    closed_form_q: float | None
    code_check: tuple[Inequality | None, ...]
    estimates: tuple[Estimate, ...]
    warnings: tuple[Sentence, ...]
    assessment: Assessment | None = None
    accuracy: Accuracy | None = None
    floor: Floor | None = None
    error: str = field(compare=False, default="")

    @property
    def kinematics(self) -> Kinematics:
        """What its mechanism does."""
        return kinematics(self.mechanism)

    @property
    def wall(self) -> Wall:
        """Wall that was analysed."""
        return self.part.wall

    @property
    def name(self) -> str:
        """Name of the wall for people: `part` says which it is."""
        return self.part.wall.name

    @property
    def required_assessment(self) -> Assessment:
        """Checks of the wall, in a study with a demand."""
        assert self.assessment is not None
        return self.assessment

    @property
    def mechanics(self) -> KinematicAnalysis:
        """Closed-form checks of the wall, in a study with a demand."""
        kinematic = self.required_assessment.kinematic
        assert kinematic is not None
        return kinematic

    @property
    def pair(self) -> tuple[str, float, str]:
        """Key that the wall shares only with its other variant."""
        return variant_key(self.part, self.mechanism)

    @property
    def governing_model(self) -> RockingModel:
        """The model whose histories decide at the demand: with the elastic branch, or the hinge, that fares worst."""
        dynamic = self.assessment.dynamic if self.assessment else None
        return dynamic.branch.of(self.model) if dynamic and dynamic.branch else self.model

    @property
    def threshold(self) -> float:
        """Acceleration that starts the motion [m/s2]: a_RM, of a wall held at its top alpha_0 g, of one between
        transverse walls that of what holds it before its ties are stretched."""
        own = self.assessment.kinematic.wall if self.assessment and self.assessment.kinematic else self.wall.in_si
        if own.arch is not None:
            return G * restraint_multiplier_at_rest(own, bending(own))
        return G * uplift_multiplier(self.wall.in_si, self.mechanism) if self.wall.bends else self.model.threshold

    @property
    def height(self) -> float:
        """H [m] as given, else of the equivalent rectangle."""
        return self.wall.height_m or self.block.height

    @property
    def thickness(self) -> float:
        """t [m] as given, else H tan(alpha)."""
        return self.wall.thickness or self.block.thickness


@dataclass(frozen=True)
class LimitStateOutcome:
    """A wall at a limit state. code : of the verdict, or no_hazard; zeta, check : of the worst hinge, or None"""

    code: str
    zeta: float | None = None
    check: str | None = None


@dataclass(frozen=True)
class WallVerdict:
    """The verdict of a wall of the case.

    wall : of the case; governing : index of the result that decides, the worst
    results : indices of the results of all its hinges and mechanisms, the worst first
    states : limit state -> outcome, of the worst hinge there
    extra : what limits it beyond the hinge that decides
    zeta_least : the lowest of all hinges and mechanisms, None where one is not known
    risk : what it withstands, of the same; None where one is not known
    interval : of zeta_E for other samples of records, None where none can be said
    rates : how often limit states of the hinge that collapses most often are exceeded, empty without the hazard
    sensitivity : None where it is not asked for
    measures : that make a wall that fails pass, a few; None of one that does not fail, or where none were sought
    """

    wall: Wall
    governing: int
    results: tuple[int, ...]
    states: dict[str, LimitStateOutcome]
    extra: tuple[Sentence, ...] = ()
    zeta_least: float | None = None
    risk: Risk | None = None
    interval: SampleInterval | None = None
    rates: tuple[StateRate, ...] = ()
    sensitivity: Sensitivity | None = None
    measures: tuple[Measure, ...] | None = None

    @property
    def title(self) -> str:
        return self.wall.title

    def moved(self, by: int) -> "WallVerdict":
        """The verdict with the numbers of its results moved by so many places."""
        return replace(self, governing=self.governing + by, results=tuple(k + by for k in self.results))


@dataclass(frozen=True)
class StudyResult:
    """Everything that decides.

    motions : the records, SI units
    walls : one entry for each hinge and mechanism of each wall of the case
    first : place of the first of them in the whole study, from 0, where these are the results of one wall of it
    verdicts : one for each wall of the case, in its order; empty without a demand
    selection : of [select]
    elapsed, analyses : of the run [s], and how many it made, each multiplier of a search or a check among them
    """

    case: Case
    started_utc: str
    method: Method
    search: Search
    demand: SeismicDemand | None
    motions: tuple[GroundMotion, ...]
    kinds: tuple[str, ...]
    walls: tuple[WallResult, ...]
    compliance: Compliance | None = None
    elapsed: float = field(compare=False, default=0.0)
    analyses: int = field(compare=False, default=0)
    verdicts: tuple[WallVerdict, ...] = ()
    selection: Selection | None = None
    first: int = 0

    @property
    def motions_at_demand(self) -> bool:
        """Whether the records are at the demand: scaled to its a_g S, or compatible with its spectrum."""
        scaled = self.demand is not None and self.demand.record_scaling == "pga"
        return scaled or (self.compliance is not None and self.compliance.compatible)

    @property
    def demand_required(self) -> SeismicDemand:
        """Demand the walls have to withstand, in a study with one."""
        assert self.demand is not None
        return self.demand

    def of_wall(self, walls: Sequence[WallResult], verdicts: tuple[WallVerdict, ...], first: int) -> "StudyResult":
        """The results of one wall alone.

        walls : its results; first : place of the first of them
        verdicts : its verdict, none without a demand, in places from 0
        """
        return replace(self, walls=tuple(walls), verdicts=verdicts, first=first)

    def split_by_wall(self) -> Iterator["StudyResult"]:
        """The results of each wall of the case alone, in its order."""
        verdicts = {verdict.governing: verdict for verdict in self.verdicts}
        for _, group in groupby(enumerate(self.walls), lambda entry: entry[1].part.origin):
            places, walls = zip(*group, strict=True)
            own_verdicts = tuple(verdicts[k].moved(-places[0]) for k in places if k in verdicts)
            yield self.of_wall(walls, own_verdicts, self.first + places[0])

    def motion_of(self, wall: WallResult, k: int) -> GroundMotion:
        """The motion under a wall: the k-th of the study, or of a wall above the ground that of its floor."""
        return (wall.floor.motions if wall.floor else self.motions)[k]

    def method_of(self, wall: WallResult, k: int) -> Method:
        """The method the runs of this wall under the k-th motion took."""
        return resolve_auto(self.method, wall.model, self.motion_of(wall, k).time_step)

    @property
    def method_words(self) -> str:
        """Name of the method asked for; of auto with those it took."""
        used = {self.method_of(wall, run.motion).name for wall in self.walls for run in wall.runs}
        if self.method.name != AUTO.name or not used:
            return self.method.name
        return f"{self.method.name} ({', '.join(sorted(used))})"

    def has_remarks(self, wall: WallResult) -> bool:
        """Whether a warning or a reason stands beside the verdict of a wall."""
        verdict = wall.assessment.verdict if wall.assessment else None
        reasons = (*verdict.to_do, *verdict.limits) if verdict else ()
        demand = self.demand.warnings if self.demand else ()
        records = any(motion.warnings for motion in self.motions)
        return bool(wall.warnings or reasons or demand or records)

    @cached_property
    def numbers(self) -> dict[int, int]:
        """Place of each wall, from 1, by its id: a search for each wall would go through all others."""
        return {id(wall): number for number, wall in enumerate(self.walls, start=self.first + 1)}

    @property
    def runs_without_q(self) -> list[tuple[str, str, int, str]]:
        """(wall, record, polarity, status) of the runs that end without a q."""
        return [
            (f"{wall.name} ({wall.mechanism})", run.record, run.polarity, run.ida.status)
            for wall in self.walls
            for run in wall.runs
            if run.ida.q is None
        ]


Q_SOURCES = ("code", "closed_form", "time_histories", "time_histories_slv", "time_histories_robust")
"""Sources of q in the checks of Eq. 9, in the order of WallResult.code_check."""


@dataclass(frozen=True)
class CollapseHistories:
    """Governing record of a wall at its last survived and its collapsing multiplier.

    scales : (survived, collapsing) [-]
    histories : of the same
    motion : the record
    """

    wall: WallResult
    motion: GroundMotion
    polarity: int
    scales: tuple[float, float]
    histories: tuple[History, History]
