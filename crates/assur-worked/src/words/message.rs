//! The messages of worked solutions: the keys of the sections of `messages/*.txt`, where their texts and parts stand.

use super::{Language, Sentence, say};
use crate::document::Line;
use std::collections::BTreeMap;
use std::sync::OnceLock;

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
        Letters Unit Pair Links Kind Class ClassOf Group OuterPairs InnerPairs Revolute Prismatic Slot Contact
        Cylinder Transmission Lower Higher Driven FreeLink Train Triad General DrivenLegs Between SchemeAt
        PlotOfMotion VelocityPlan AccelerationPlan Freed Polygon Lever Conventions MobilityIs Replaced Passive Formula
        ForceOrder GroupOf LinkOf DrivenAngle DrivenRate SenseOnly FreeCoordinate Uniform Triangle LeftOf
        RightOf Projected OnGuide AcrossGuide AlongGuide Slotted SlottedThrough Covered TwoGuides TwoSlides
        BetweenGuides Guide Found TurnsCounterClockwise TurnsClockwise DoesNotTurn MotionStated AllTogether
        ThreeLegs NewtonSearched NewtonFollowed Step NewtonLeft NewtonFirst NewtonStarts NewtonPart NewtonMatrix
        NewtonSolution ForcesStated NotAccurateHere InertiaArm RestOfLoads Determinate TwoForces
        MomentsOfLink PolygonCloses InnerPair SumAlongGuide SumAcrossGuide SumOfLink ThroughPoint
        CoupleOfGuide EachAlongGuide CouplesOpen BalanceTurn BalanceShift ForceAlongLine ForceAgainstLine
        NoEffort ActsCounterClockwise ActsClockwise VirtualPower PowerOpen Residuals OpenSizes SweepStated
        TrainPlaces LawsOfTrain LawsTogether Eliminated LawOf TrainForces MemberGives MembersGive SheetHead
        DrawnFor TextOf OtherPose Variants Variant Find Answers Solution KeyHead Position TogetherForces
        EquilibriumOf Closes AskedFor AskedOfGuides AskedOfForces NoForces SeeScheme SeePlan
        SeeFreed SeePolygon SeeLever Rates LoadHere LoadResultant InsideLink CoupleOnFirst EquationsTogether SolutionIs RatesTogether
        PowerFlows TeethPress BearingsOf TrainPowers CarrierLocked CarrierTurns SumOfBoth WillisParts
        WillisSpeeds Sizes SizesOf CamTurned CamTurnedBy LiftBegins PlanetsEven SplineSlopes RootOfLaw
        CamDwells HeldByArc TurnsWith Rests Powers CommonNormal StaticMasses DynamicMasses StiffLink
        CylinderLength LoadRests PlaceOpen CoupleAtSlider ByFormulas AskedBesides
        Jerks AskedForJerks SeveralMasses MethodOfJoints JointOf WholeTruss
        AxialForces SeeAxial EquilibriumAngle Weld NoPair WeldedTo WeldHolds
        HowToAnswer HowToAnswerWithUnit PicturesLeftOut AnswerIsRight
    }
    equations after {
        SumAlongGuide SumAcrossGuide SumOfLink MomentsOfLink MemberGives MembersGive AcrossGuide AlongGuide
        Projected JointOf WholeTruss
    }
}

messages! {
    /// What the letters of equations stand for.
    SymbolMessage of "symbols" {
        Symbols Coordinates Distance Slide LinkAngle LineAngle TriangleAngle OwnAngle Velocity AngularVelocity Acceleration
        Parts AngularAcceleration Mass Inertia Weight InertiaForce InertiaCouple InertiaArm KnownForces Reaction Radius Teeth Stiffness Damping FrictionCoefficient Power Efficiency KineticEnergy ReducedInertia ReducedTorque
    }
}

messages! {
    /// Friction: its sense, its steps, what holds, what is lost.
    FrictionMessage of "friction" {
        FrictionFirst FrictionLaws PairStill PairHeld PairHeldByBalance ClutchSlips ContactPoint RestsOnStop
        ContactCloses HoldTurn HoldShift FrictionDirect FrictionSenses PairMovesPositive PairMovesNegative PairBeginsPositive
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
        CamStart CamPressure CamCurvature FaceCurvature FaceLetters GearsOf InvoluteSolved LengthsInMillimetres WheelOf SlidingOf MeshOf
    }
}

messages! {
    /// Motions under loads.
    RunMessage of "run" {
        Run SeePlot OneInstant ResultsAt AtBegin Least Greatest AtEnd WhatHappens EndsRun Meets Leaves Held Slides Rises Falls Becomes
        AtInstant EnergyHere Transfers AccelerationHere Reduced ReducedLoad Slope ReducedMotion WorkHere EnergyOfRun EventsOfRun EventsOfSweep Event Instants RunMethod ByEnergy
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
        Travel Stroke TimeRatio TangentialForce TangentialForceOn TangentialForceBetween
        ToothForce ToothForceOn ToothForceBetween Tension TightSide SlackSide DeadPosition Period
        EventTime EventDrive Greatest Least Mean Integral WhereGreatest Work FlywheelInertia Fluctuation RimWidth
        RimHeight RimMass ReducedTorque ReducedInertia ExcessWork StaticMass DynamicMass SecondMass
        SecondDistance InertiaLeft Jerk AngularJerk RelativeJerk CurvatureRadius CurvatureCentre Axial StopsEffort
        Impulse Gap
    }
}

messages! {
    /// The first file, step by step.
    TutorialMessage of "tutorial" {
        Title GroundTitle GroundText LinksTitle LinksText PairsTitle PairsText DriveTitle DriveText AssemblyTitle
        AssemblyText QuestionTitle QuestionText
    }
}

/// The words of a function of the language, for questions on sheets.
#[derive(Clone, Copy, Debug)]
pub struct FunctionWords(&'static str);

impl FunctionWords {
    /// The words of a function of so many arguments, or of a part of what it gives; none where it is better set as a formula.
    #[must_use]
    pub fn of(function: &str, count: usize) -> Option<Self> {
        let key = |name: &str| key("functions", name);
        key(&format!("{function}/{count}")).or_else(|| key(function)).map(Self)
    }
}

impl Sentence for FunctionWords {
    fn template(self, language: Language) -> &'static str {
        text(language, "functions", self.0)
    }
}

/// The words of a section whose keys are data, such as a kind of datum.
#[derive(Clone, Copy, Debug)]
struct KeyedWords(&'static str, &'static str);

impl Sentence for KeyedWords {
    fn template(self, language: Language) -> &'static str {
        text(language, self.0, self.1)
    }
}

/// The words of a key with their parts; nothing where the section lacks it.
pub fn words_of(language: Language, section: &'static str, name: &str, parts: &[Line]) -> Line {
    key(section, name).map_or_else(Vec::new, |key| say(language, KeyedWords(section, key), parts))
}

/// A word of a section; itself where the section lacks it.
pub fn word(language: Language, section: &'static str, name: &str) -> String {
    key(section, name).map_or_else(|| name.to_owned(), |key| text(language, section, key).to_owned())
}

// The texts of the languages: one file each, sections of keys and texts.

/// A key and its text.
type Row = (&'static str, &'static str);

/// The texts of a language.
struct Catalogue {
    /// The rows of every section, in the order of the file: a pattern may begin as a later one does.
    sections: BTreeMap<&'static str, Vec<Row>>,
    texts: BTreeMap<Row, &'static str>,
}

impl Catalogue {
    fn of(file: &'static str) -> Self {
        let mut all = Self { sections: BTreeMap::new(), texts: BTreeMap::new() };
        let mut section = "";
        for line in file.lines() {
            if let Some(name) = line.strip_prefix('[').and_then(|name| name.strip_suffix(']')) {
                section = name;
            } else if let Some((key, text)) = line.split_once(" | ").filter(|_| !line.starts_with('#')) {
                all.sections.entry(section).or_default().push((key, text));
                all.texts.entry((section, key)).or_insert(text);
            }
        }
        all
    }
}

fn catalogue(language: Language) -> &'static Catalogue {
    static ALL: [OnceLock<Catalogue>; 3] = [const { OnceLock::new() }; 3];
    let (index, file) = match language {
        Language::English => (0, include_str!("../../messages/en.txt")),
        Language::Chinese => (1, include_str!("../../messages/zh.txt")),
        Language::Russian => (2, include_str!("../../messages/ru.txt")),
    };
    ALL[index].get_or_init(|| Catalogue::of(file))
}

/// The text of a key; the key itself where a file lacks it, which `tests/worked/languages.rs` rules out.
pub(super) fn text(language: Language, section: &'static str, key: &'static str) -> &'static str {
    catalogue(language).texts.get(&(section, key)).copied().unwrap_or(key)
}

/// The key of this name, if the section has it.
pub(super) fn key(section: &str, name: &str) -> Option<&'static str> {
    rows(Language::English, section).iter().find_map(|row| (row.0 == name).then_some(row.0))
}

/// The rows of a section, in the order of the file.
pub(super) fn rows(language: Language, section: &str) -> &'static [Row] {
    catalogue(language).sections.get(section).map_or(&[], Vec::as_slice)
}
