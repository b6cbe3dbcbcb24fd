//! The messages: every sentence and heading of a worked solution.

/// A message; its parts are numbered in the sentences of the languages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Message {
    /// Heading: structure.
    Structure,
    /// Heading: positions.
    Positions,
    /// Heading: velocities.
    Velocities,
    /// Heading: accelerations.
    Accelerations,
    /// Heading: inertia forces and loads.
    Inertia,
    /// Heading: reactions.
    Reactions,
    /// Heading: check.
    Check,
    /// Heading: results.
    Results,
    /// Header: given, value, quantity, unit and the like.
    Given,
    Value,
    Quantity,
    /// Header: the letters of a quantity.
    Letters,
    Unit,
    Pair,
    Links,
    Kind,
    Class,
    Group,
    OuterPairs,
    InnerPairs,
    /// Cell: revolute pair.
    Revolute,
    /// Cell: prismatic pair.
    Prismatic,
    /// Cell: pin in slot.
    Slot,
    /// Cell: contact.
    Contact,
    /// Cell: cylinder.
    Cylinder,
    /// Cell: transmission.
    Transmission,
    /// Cell: lower pair.
    Lower,
    /// Cell: higher pair.
    Higher,
    Driven,
    Train,
    Triad,
    General,
    /// A dyad with a driven link.
    DrivenLegs,
    /// A body between two guides.
    Between,
    /// Caption of the scheme; 0: the position.
    SchemeAt,
    /// Caption of the plan of velocities.
    VelocityPlan,
    /// Caption of the plan of accelerations.
    AccelerationPlan,
    /// Caption of a free body; 0: links.
    Freed,
    /// Caption of a polygon; 0: links.
    Polygon,
    /// Caption of the lever.
    Lever,
    /// Units and senses of equations.
    Conventions,
    MobilityIs,
    /// Replaced higher pairs; 0: pairs.
    Replaced,
    /// Passive freedoms; 0: links.
    Passive,
    /// The formula of structure; 0: it, 1: class.
    Formula,
    /// The order of forces differs; 0: it.
    ForceOrder,
    /// Heading of a group; 0: links.
    GroupOf,
    /// Heading of a link; 0: it.
    LinkOf,
    /// The angle of a driven link is given.
    DrivenAngle,
    /// The rate of a driven link is given.
    DrivenRate,
    /// A rate of which the file gives the sense alone; 0: it.
    SenseOnly,
    /// A free coordinate, or its rate, at the instant that is shown.
    FreeCoordinate,
    /// A drive without acceleration.
    Uniform,
    /// A triangle; 0: its corners.
    Triangle,
    /// C left of A→B.
    LeftOf,
    /// C right of A→B.
    RightOf,
    /// Projection on a line; 0: the line.
    Projected,
    /// A point on a guide; 0: it.
    OnGuide,
    /// Projection across the guide.
    AcrossGuide,
    /// Projection along the guide.
    AlongGuide,
    /// A slotted link; 0: B, 1: A.
    Slotted,
    /// The same where both hinges are as far from the guide; 0: link of the guide, 1: its hinge, 2: hinge of the slider.
    SlottedThrough,
    /// A point that another covers; 0: it, 1: its link, 2: the other.
    Covered,
    /// A point on two guides; 0: it.
    TwoGuides,
    /// A slide on a slide; 0: the point.
    TwoSlides,
    /// A body between guides; 0: it.
    BetweenGuides,
    Guide,
    Found,
    /// A link turns counter-clockwise; 0: it, 1: its ω.
    TurnsCounterClockwise,
    /// A link turns clockwise.
    TurnsClockwise,
    /// A link does not turn at this instant.
    DoesNotTurn,
    /// Motion is stated; 0: kind.
    MotionStated,
    /// A group that is solved as a whole; 0: kind, 1: how many equations.
    AllTogether,
    /// A link on three legs; 0: it, 1: the mean of its pins, 2: the pins.
    ThreeLegs,
    /// An iteration that begins at a start of the search.
    NewtonSearched,
    /// An iteration that begins at the place before; 0: the drives there.
    NewtonFollowed,
    /// Header: step of an iteration.
    Step,
    /// Header: what is left of the equations.
    NewtonLeft,
    /// Header: how far a step goes.
    NewtonShift,
    /// Header: how far a step turns.
    NewtonTurn,
    /// The equations of the last step that matters; 0: it.
    NewtonMatrix,
    /// The unknowns corrected; 0: steps before the last.
    NewtonSolution,
    /// Forces are stated; 0: kind.
    ForcesStated,
    /// A form loses its digits here.
    NotAccurateHere,
    /// Force and couple as one force; 0: force, 1: mass centre.
    InertiaArm,
    /// What is left of the loads; 0: link.
    RestOfLoads,
    /// The group is determinate.
    Determinate,
    /// A two-force link; 0: link, 1: force, 2: line.
    TwoForces,
    /// Moments; 0: link, 1: point.
    MomentsOfLink,
    /// The normal parts close the polygon.
    PolygonCloses,
    /// The inner pair; 0: point, 1: link.
    InnerPair,
    /// Forces along the guide.
    SumAlongGuide,
    /// Forces across the guide.
    SumAcrossGuide,
    /// Forces on a link; 0: it.
    SumOfLink,
    /// A reaction passes through a point; 0: point, 1: force.
    ThroughPoint,
    /// The couple of a guide; 0: point, 1: couple.
    CoupleOfGuide,
    /// Each slider along its guide; 0: hinge.
    EachAlongGuide,
    /// Couples that are not determined.
    CouplesOpen,
    /// Balance of a link on a hinge; 0: link, 1: hinge, 2: effort.
    BalanceTurn,
    /// Balance of a link on a guide; 0: link, 1: effort.
    BalanceShift,
    /// Sense of an effort; 0: it.
    ForceAlongLine,
    ForceAgainstLine,
    /// A free coordinate has no effort.
    NoEffort,
    ActsCounterClockwise,
    ActsClockwise,
    VirtualPower,
    /// The powers are not all derived.
    PowerOpen,
    /// Residuals; 0: closure, 1: equilibrium, 2: power, 3: condition.
    Residuals,
    /// Sizes that the file leaves open; 0: they.
    OpenSizes,
    /// Quantities over a sweep.
    SweepStated,
    TrainPlaces,
    /// The laws of a train.
    LawsOfTrain,
    /// Several laws give their unknowns together.
    LawsTogether,
    /// Two laws without one of their unknowns; 0: transmissions, 1: it, 2: the other.
    Eliminated,
    /// A law; 0: transmission, 1: what it gives.
    LawOf,
    /// Equilibrium of the members of a train.
    TrainForces,
    /// A member gives an unknown; 0: it, 1: the unknown.
    MemberGives,
    /// Two members give an unknown; 0: they, 1: the other unknown, 2: the unknown.
    MembersGive,
    /// Head of a sheet.
    SheetHead,
    /// Which variant the scheme of a sheet is of; 0: its number and name.
    DrawnFor,
    /// Which variant has the values in the text; 0: its number and name.
    TextOf,
    /// The scheme is at another position.
    OtherPose,
    Variants,
    Variant,
    /// Heading: what to find.
    Find,
    /// Heading: the empty table.
    Answers,
    /// Head of a key.
    KeyHead,
    /// The column that names a position.
    Position,
    /// Reactions that are found together.
    TogetherForces,
    /// Equilibrium of a link; 0: it.
    EquilibriumOf,
    Closes,
    /// Points that the file asks for.
    AskedFor,
    /// Coordinates of sliders that the file asks for.
    AskedOfGuides,
    /// Powers and couples that the file asks for.
    AskedOfForces,
    /// Nothing loads the mechanism.
    NoForces,
    /// No load, no reaction, no effort.
    NothingActs,
    /// The scheme has the points; 0: the figure.
    SeeScheme,
    /// The plan of a section; 0: the figure.
    SeePlan,
    /// A free body; 0: the figure.
    SeeFreed,
    /// A polygon; 0: the figure.
    SeePolygon,
    /// The lever; 0: the figure.
    SeeLever,
    Rates,
    /// A load by an expression; 0: its letters, 1: the expression.
    LoadHere,
    /// The couple of two guides; 0: the point.
    CoupleOnFirst,
    /// Equations of a group; 0: how many, 1: unknowns.
    EquationsTogether,
    /// The solution of equations.
    SolutionIs,
    /// Equations of rates of a group; 0: how many.
    RatesTogether,
    /// The direction of power; 0: transmission, 1: from, 2: to, 3: efficiency.
    PowerFlows,
    /// Radial force of teeth; 0: transmission.
    TeethPress,
    /// Reactions of bearings of a train.
    BearingsOf,
    TrainPowers,
    /// Row: seen from the carrier.
    CarrierLocked,
    /// Row: the carrier's turn.
    CarrierTurns,
    /// Row: the sum.
    SumOfBoth,
    /// Willis' table; 0: carrier, 1: speed.
    WillisParts,
    /// The same in speeds; 0: carrier.
    WillisSpeeds,
    /// Heading: sizes of the file.
    Sizes,
    /// Sizes by formulas of the file.
    SizesOf,
    /// The follower of a cam; 0: cam, 1: angle, 2: lift.
    CamTurned,
    /// A cam that its follower turns; 0: cam, 1: angle, 2: lift.
    CamTurnedBy,
    /// Where the lift of a follower on a guide begins; 0: that distance.
    LiftBegins,
    /// Planets that are one shaft without a place; 0: they, 1: their carrier.
    PlanetsEven,
    /// The slopes of a spline through a table of lifts.
    SplineSlopes,
    /// The angle of a cam at which its law has a lift; 0: it.
    RootOfLaw,
    /// A cam that does not move its follower.
    CamDwells,
    /// A Geneva wheel between two engagements; 0: wheel, 1: angle.
    HeldByArc,
    /// A link that turns with another; 0: it, 1: the other.
    TurnsWith,
    /// A link that rests; 0: it.
    Rests,
    /// Heading: powers of transmissions.
    Powers,
    /// The normal of a cam and its follower; 0: the instant centre, 1: the tip.
    CommonNormal,
    /// Static substitution; 0: link, 1, 2: points.
    StaticMasses,
    /// Dynamic substitution; the same.
    DynamicMasses,
    /// Two bodies with a driven joint between them; 0, 1: these, 2: the inner hinge, 3: the outer one.
    StiffLink,
    /// A driven cylinder; 0: its length.
    CylinderLength,
    /// A load that is nothing here; 0: it.
    LoadRests,
    /// A hinge of a shaft without a place; 0: it.
    PlaceOpen,
    /// The couple of a guide about the point of its slider; 0: the point.
    CoupleAtSlider,
    /// What the file asks for by formulas of its own.
    ByFormulas,
    /// What the file asks for besides.
    AskedBesides,
}

impl Message {
    /// Whether an equation follows, unless it is nothing for all values.
    pub const fn awaits_an_equation(self) -> bool {
        matches!(
            self,
            Self::SumAlongGuide
                | Self::SumAcrossGuide
                | Self::SumOfLink
                | Self::MomentsOfLink
                | Self::MemberGives
                | Self::MembersGive
                | Self::AcrossGuide
                | Self::AlongGuide
                | Self::Projected
        )
    }
}
