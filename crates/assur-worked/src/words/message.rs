//! The messages of worked solutions: the keys of the sections of `messages/*.txt`, where their texts and parts stand.

use super::catalogue::text;
use super::{Language, Sentence};

macro_rules! messages {
    ($(#[$doc:meta])* $name:ident of $section:literal { $($key:ident)* } $(equations after { $($before:ident)* })?) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $name { $($key),* }

        impl Sentence for $name {
            fn template(self, language: Language) -> &'static str {
                text(language, $section, match self { $(Self::$key => stringify!($key)),* })
            }

            $(fn awaits_an_equation(self) -> bool {
                matches!(self, $(Self::$before)|*)
            })?
        }
    };
}

messages! {
    /// Structure, motion, forces, headings.
    Message of "words" {
        Structure Positions Velocities Accelerations Inertia Reactions Check Results Given Value Quantity
        Letters Unit Pair Links Kind Class Group OuterPairs InnerPairs Revolute Prismatic Slot Contact
        Cylinder Transmission Lower Higher Driven Train Triad General DrivenLegs Between SchemeAt
        VelocityPlan AccelerationPlan Freed Polygon Lever Conventions MobilityIs Replaced Passive Formula
        ForceOrder GroupOf LinkOf DrivenAngle DrivenRate SenseOnly FreeCoordinate Uniform Triangle LeftOf
        RightOf Projected OnGuide AcrossGuide AlongGuide Slotted SlottedThrough Covered TwoGuides TwoSlides
        BetweenGuides Guide Found TurnsCounterClockwise TurnsClockwise DoesNotTurn MotionStated AllTogether
        ThreeLegs NewtonSearched NewtonFollowed Step NewtonLeft NewtonShift NewtonTurn NewtonMatrix
        NewtonSolution ForcesStated NotAccurateHere InertiaArm RestOfLoads Determinate TwoForces
        MomentsOfLink PolygonCloses InnerPair SumAlongGuide SumAcrossGuide SumOfLink ThroughPoint
        CoupleOfGuide EachAlongGuide CouplesOpen BalanceTurn BalanceShift ForceAlongLine ForceAgainstLine
        NoEffort ActsCounterClockwise ActsClockwise VirtualPower PowerOpen Residuals OpenSizes SweepStated
        TrainPlaces LawsOfTrain LawsTogether Eliminated LawOf TrainForces MemberGives MembersGive SheetHead
        DrawnFor TextOf OtherPose Variants Variant Find Answers KeyHead Position TogetherForces
        EquilibriumOf Closes AskedFor AskedOfGuides AskedOfForces NoForces NothingActs SeeScheme SeePlan
        SeeFreed SeePolygon SeeLever Rates LoadHere CoupleOnFirst EquationsTogether SolutionIs RatesTogether
        PowerFlows TeethPress BearingsOf TrainPowers CarrierLocked CarrierTurns SumOfBoth WillisParts
        WillisSpeeds Sizes SizesOf CamTurned CamTurnedBy LiftBegins PlanetsEven SplineSlopes RootOfLaw
        CamDwells HeldByArc TurnsWith Rests Powers CommonNormal StaticMasses DynamicMasses StiffLink
        CylinderLength LoadRests PlaceOpen CoupleAtSlider ByFormulas AskedBesides
    }
    equations after {
        SumAlongGuide SumAcrossGuide SumOfLink MomentsOfLink MemberGives MembersGive AcrossGuide AlongGuide
        Projected
    }
}

messages! {
    /// Friction: its sense, its steps, what holds, what is lost.
    FrictionMessage of "friction" {
        FrictionFirst FrictionLaws PairStill PairHeld PairHeldByBalance ContactPoint RestsOnStop HoldTurn
        HoldShift FrictionDirect FrictionSenses PairMovesPositive PairMovesNegative PairBeginsPositive
        PairBeginsNegative PairOnGroundPositive PairOnGroundNegative FrictionSteps FrictionSearched Change
        Losses PairsLose WithoutFriction EffortsDrive EffortsResist NotLocked LocksItself OnlyFriction
        LocksFrom Locked FrictionShares FrictionSharesHere
    }
}

messages! {
    /// Flywheels, cams, gears.
    DesignMessage of "design" {
        CycleOf ExtremesOf TimesOf FlywheelOf ReducedTorque FlywheelTable FlywheelExtremes FlywheelInertia
        FlywheelRim CamOf CamStages CamDwell CamOther CamRise CamFall LawUniform LawParabolic LawHarmonic
        LawCycloidal LawPoly345 LawPoly4567 LawModifiedTrapezoid LawModifiedSine LawSpline CamSlopes
        CamStart CamPressure CamCurvature FaceCurvature FaceLetters GearsOf InvoluteSolved
    }
}

messages! {
    /// Motions under loads.
    RunMessage of "run" {
        Run EnergyHere Reduced ReducedMotion EnergyOfRun EventsOfRun Event Instants RunMethod ByEnergy
        ReducedSeveral EnergyReduced
    }
}

messages! {
    /// What a sheet asks for.
    QuestionMessage of "questions" {
        Reactions AlongX AlongY Magnitude Direction Frictionless Position Velocity Acceleration Angle
        AngularVelocity AngularAcceleration Displacement RelativeVelocity Sliding RelativeAcceleration
        Coriolis Reaction Moment Normal Friction FrictionPower Efficiency Locked InertiaForce InertiaTorque
        PressureAngle BalancingTorque BalancingEffort DriveEffort Load Power KineticEnergy PotentialEnergy
        Travel Stroke TimeRatio TangentialForce ToothForce Tension TightSide SlackSide DeadPosition Period
        EventTime MotionScales Least Mean Integral WhereGreatest Work FlywheelInertia Fluctuation RimWidth
        RimHeight RimMass ReducedTorque ReducedInertia ExcessWork StaticMass DynamicMass SecondMass
        SecondDistance InertiaLeft
    }
}

/// The words of a function of the language, for questions on sheets.
#[derive(Clone, Copy, Debug)]
pub struct FunctionWords(&'static str);

impl FunctionWords {
    /// The words of a function of so many arguments, or of a part of what it gives; none where it is better set as a formula.
    #[must_use]
    pub fn of(function: &str, count: usize) -> Option<Self> {
        let key = |name: &str| super::catalogue::key("functions", name);
        key(&format!("{function}/{count}")).or_else(|| key(function)).map(Self)
    }
}

impl Sentence for FunctionWords {
    fn template(self, language: Language) -> &'static str {
        text(language, "functions", self.0)
    }
}
