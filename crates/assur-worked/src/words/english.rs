//! English.

use super::Message;
use crate::document::Labels;

pub(super) const LABELS: Labels =
    Labels { contents: "Contents", figure: "Figure", rows: ["Equation", "Magnitude", "Direction"] };

#[allow(clippy::too_many_lines, reason = "a table: one line per message")]
pub(super) const fn template(message: Message) -> &'static str {
    match message {
        Message::Structure => "Structure",
        Message::Positions => "Positions",
        Message::Velocities => "Velocities",
        Message::Accelerations => "Accelerations",
        Message::Inertia => "Loads and inertia forces",
        Message::Reactions => "Reactions",
        Message::Check => "Check",
        Message::Results => "Results",
        Message::Given => "Given",
        Message::Value => "Value",
        Message::Quantity => "Quantity",
        Message::Letters => "Symbol",
        Message::Unit => "Unit",
        Message::Pair => "Pair",
        Message::Links => "Links",
        Message::Kind => "Kind",
        Message::Class => "Class",
        Message::Group => "Group",
        Message::OuterPairs => "Outer pairs",
        Message::InnerPairs => "Inner pairs",
        Message::Revolute => "revolute",
        Message::Prismatic => "prismatic",
        Message::Slot => "pin in slot",
        Message::Contact => "contact",
        Message::Cylinder => "cylinder",
        Message::Transmission => "transmission",
        Message::Lower => "lower",
        Message::Higher => "higher",
        Message::Driven => "driven link",
        Message::Train => "train",
        Message::Triad => "triad",
        Message::General => "general group",
        Message::DrivenLegs => "dyad with a driven link",
        Message::Between => "link between two guides",
        Message::SchemeAt => "Kinematic scheme{0}",
        Message::VelocityPlan => "Velocity plan",
        Message::AccelerationPlan => "Acceleration plan",
        Message::Freed => "Free body: {0}",
        Message::Polygon => "Polygon of forces: {0}",
        Message::Lever => "Zhukovsky’s lever: the velocity plan turned by 90° with all forces at its points",
        Message::Conventions => {
            "In the equations numbers are in m, kg, s, N and degrees. Counter-clockwise is positive."
        }
        Message::MobilityIs => "Mobility, with n moving links, lower pairs and higher pairs:",
        Message::Replaced => "Higher pairs are replaced by a link with two lower pairs: {0}.",
        Message::Passive => "Links whose own rotation changes nothing: {0}.",
        Message::Formula => {
            "Formula of structure: {0}. The mechanism is of class {1}. Motion is found in this order, forces in the reverse order."
        }
        Message::ForceOrder => {
            "Forces are found in the order {0}, because drive and balance are on different links."
        }
        Message::GroupOf => "Group {0}",
        Message::LinkOf => "Link {0}",
        Message::DrivenAngle => "The drive gives {0}.",
        Message::DrivenRate => "The drive gives {0}.",
        Message::SenseOnly => {
            "Only the sense of the motion is given: {0} is taken as one unit, and no result depends on it."
        }
        Message::FreeCoordinate => "The motion under the loads gives {0} at this instant.",
        Message::Uniform => "The drive is uniform: {0} = 0.",
        Message::Triangle => "The triangle {0} has three known sides:",
        Message::LeftOf => "{0} is to the left of the line from {1} to {2}:",
        Message::RightOf => "{0} is to the right of the line from {1} to {2}:",
        Message::Projected => "Projection on {0}:",
        Message::OnGuide => "{0} is on its guide, which gives the direction of the link:",
        Message::AcrossGuide => "Projection across the guide:",
        Message::AlongGuide => "Projection along the guide:",
        Message::Slotted => {
            "{2} is off the line through {1} along the guide of link {0} by {3}, positive to the left:"
        }
        Message::SlottedThrough => "The guide of link {0} has the direction of the line through {1} and {2}:",
        Message::Covered => "{0} is the point of link {1} that coincides with {2} at this instant.",
        Message::TwoGuides => "{0} is where the paths along two guides meet:",
        Message::TwoSlides => "Two sliders, one on the other, give the position of {0}:",
        Message::BetweenGuides => "Link {0} slides on two guides and does not turn against them.",
        Message::Guide => "guide",
        Message::Found => "found",
        Message::TurnsCounterClockwise => "Link {0} turns counter-clockwise ({1} > 0).",
        Message::TurnsClockwise => "Link {0} turns clockwise ({1} < 0).",
        Message::DoesNotTurn => "Link {0} does not turn at this instant.",
        Message::MotionStated => {
            "The links of this group ({0}) close together and not one after another. Their positions as the solver found them:"
        }
        Message::AllTogether => {
            "The links of this group ({0}) close together and not one after another: {1} equations for as many unknowns, which are the place x, y of the origin and the direction φ of every link. The solver finds them by Newton’s method."
        }
        Message::ThreeLegs => {
            "The three legs of link {0} close together: three equations for the place of {1}, the mean of the pins {2}, and for the direction of the link. The solver finds them by Newton’s method."
        }
        Message::NewtonSearched => {
            "It begins at one of the starts from which all assemblies are searched for; greatest amounts in every step:"
        }
        Message::NewtonFollowed => {
            "It begins where the group is a little earlier in the motion, at {0}; greatest amounts in every step:"
        }
        Message::Step => "Step",
        Message::NewtonLeft => "left of the equations, m or rad",
        Message::NewtonShift => "shift of a link, m",
        Message::NewtonTurn => "turn of a link, °",
        Message::NewtonMatrix => {
            "The linear equations of step {0}, the last that changes more than rounding, angles in rad. Each row is one equation: its derivatives by the unknowns, and on the right side what is left of it, with the opposite sign:"
        }
        Message::NewtonSolution => {
            "Their solution δ corrects the values after step {0}, which have this number as their index:"
        }
        Message::ForcesStated => "The forces of this group ({0}) are stated, not derived, in this version:",
        Message::NotAccurateHere => {
            "The closed form loses its digits at this position; the value of the solver:"
        }
        Message::InertiaArm => {
            "The force and the couple together are one force {0} at this distance from {1}:"
        }
        Message::RestOfLoads => {
            "Other loads on link {0} are stated as their resultant at the origin of its frame:"
        }
        Message::Determinate => {
            "The group has as many equations of equilibrium as unknown reactions. Known forces are its loads, its inertia forces and the reactions found before."
        }
        Message::TwoForces => "Link {0} carries no load: a two-force link, so {1} lies along {2}.",
        Message::MomentsOfLink => "Link {0}, moments about {1}:",
        Message::PolygonCloses => "The sum of all forces on the group is zero:",
        Message::InnerPair => "The reaction in the inner pair {0}, from link {1} alone:",
        Message::SumAlongGuide => "Sum of forces along the guide:",
        Message::SumAcrossGuide => "Sum of forces across the guide:",
        Message::SumOfLink => "Sum of forces on link {0}:",
        Message::ThroughPoint => "All other forces on link {0} pass through {1}, so {2} does too.",
        Message::CoupleOfGuide => "Moments about {0} give the couple {1} of the guide:",
        Message::EachAlongGuide => "Each slider along its own guide gives the force in {0}:",
        Message::CouplesOpen => {
            "How the two guides share the couple is not determined; their normal forces are:"
        }
        Message::BalanceTurn => "Link {0}: moments about {1} give {2}.",
        Message::BalanceShift => "Link {0}: forces along the guide give {1}.",
        Message::ForceAlongLine => "{0} is positive: it acts in its declared direction.",
        Message::ForceAgainstLine => "{0} is negative: it acts against its declared direction.",
        Message::NoEffort => {
            "No effort acts on this free coordinate: {0} is zero, as the equation of motion demands."
        }
        Message::ActsCounterClockwise => "{0} is positive: it acts counter-clockwise.",
        Message::ActsClockwise => "{0} is negative: it acts clockwise.",
        Message::VirtualPower => {
            "The power of all loads, inertia forces and efforts adds up to zero; none of the equilibrium equations above was used for this:"
        }
        Message::PowerOpen => {
            "The terms derived here are not all terms of the power; the residual of the solver is below."
        }
        Message::Residuals => {
            "Residuals of the solver’s own independent equations, relative to the largest terms: closure {0}, equilibrium {1}, power {2}. The least condition of a group is {3} (1 is best)."
        }
        Message::OpenSizes => {
            "The file gives the sizes of these wheels as ratios only; one of them is taken as 1 m, and no result depends on it: {0}."
        }
        Message::SweepStated => {
            "One position is worked out in full here; all others are in the tables and plots at the end."
        }
        Message::TrainPlaces => {
            "Wheels and shafts turn by the laws of their transmissions; their angles follow from these laws where they are needed."
        }
        Message::LawsOfTrain => {
            "Each transmission is one linear law between rates. Seen from the carrier the wheels of a mesh turn as the numbers of their teeth (Willis)."
        }
        Message::LawsTogether => {
            "The other laws are solved together. Their unknowns, and each law with these values (ε is what is left):"
        }
        Message::Eliminated => "Transmissions {0}, with {1} eliminated, give {2}:",
        Message::LawOf => "Transmission {0} gives {1}:",
        Message::TrainForces => {
            "Equilibrium of every wheel and shaft about its axis, and of every slider along its guide, in the forces of the transmissions at the radii of the wheels:"
        }
        Message::MemberGives => "{0} gives {1}:",
        Message::MembersGive => "{0} together, with {1} eliminated, give {2}:",
        Message::SheetHead => "Name ______________________   Group ________   Variant {0}",
        Message::DrawnFor => "The scheme is drawn for variant {0}.",
        Message::TextOf => "The values in the text are those of variant {0}.",
        Message::OtherPose => "The scheme is drawn at another position, because positions are asked for.",
        Message::Variants => "Variants",
        Message::Variant => "Variant",
        Message::Find => "Find",
        Message::Answers => "Answers",
        Message::KeyHead => {
            "Key, to four digits. `assur grade` counts an answer as right within 3 % of its value, a component within 3 % of the magnitude of its vector. Counter-clockwise, to the right and upwards are positive."
        }
        Message::Position => "Position",
        Message::TogetherForces => "Every equation with these values (what is left of it):",
        Message::EquilibriumOf => "Link {0}:",
        Message::Closes => "Every pair of the group closes with these values (Δ is what is left):",
        Message::AskedFor => "Points that the file asks for:",
        Message::AskedOfGuides => "Along guides, as the file asks:",
        Message::AskedOfForces => "Forces, torques and powers that the file asks for:",
        Message::NothingActs => {
            "Nothing acts on the links at this position: all reactions and efforts are zero."
        }
        Message::NoForces => "The file asks for no forces, or none are determined.",
        Message::SeeScheme => "Points and directions are those of {0}.",
        Message::SeePlan => "{0} shows the vectors of this section to scale.",
        Message::SeeFreed => "{0} shows the freed links and what acts on them.",
        Message::SeePolygon => "Drawn to scale this sum is the closed polygon of {0}.",
        Message::SeeLever => {
            "{0} shows the same balance as moments about the pole of the turned velocity plan."
        }
        Message::Rates => "No drive has a speed: velocities are not worked out.",
        // friction: iteration, losses
        // loads
        Message::LoadHere => "The file gives {0} = {1}. At this position:",
        // guides
        Message::CoupleOnFirst => {
            "The whole couple is put on the first guide, and both normal forces through {0}: normal forces do not depend on this, couples of guides do."
        }
        // groups as a whole
        Message::EquationsTogether => {
            "The links of this group have {0} equations of equilibrium for {1} unknowns, which are solved together. Each row is one equation: the coefficients of the unknowns, and on the right side what is known:"
        }
        Message::SolutionIs => "Their solution:",
        // rates of groups as a whole
        Message::RatesTogether => {
            "The hinges of this group close together (linear equations: {0}). Each row is one equation: the coefficients of the unknowns, and on the right side what is known:"
        }
        // trains
        Message::PowerFlows => {
            "Power flows through {0} from {1} to {2}: of the force on the side of {1} the part {3} gets to {2}."
        }
        Message::TeethPress => "The teeth of {0} also press the wheels apart, by the pressure angle:",
        Message::BearingsOf => "The bearings take the sum of all forces on their wheels:",
        Message::TrainPowers => {
            "Power that every transmission takes from its driving side, relative to its carrier, and its loss:"
        }
        // Willis
        Message::CarrierLocked => "carrier locked",
        Message::CarrierTurns => "turn with the carrier",
        Message::SumOfBoth => "sum",
        Message::WillisParts => "All wheels on the carrier {0}, as exact parts of {1}:",
        Message::WillisSpeeds => "All wheels on the carrier {0}, in rad/s:",
        // cycle, flywheels, cams, gears
        // sizes
        Message::Sizes => "Sizes",
        Message::SizesOf => "What the file works out from its given values:",
        // cams in motion
        Message::CamTurned => {
            "Cam {0} is at the cam angle {1}, counted from where its x axis points to the follower. Its law gives the lift {2} there, and the derivatives by the cam angle (′, ″):"
        }
        Message::CamTurnedBy => {
            "Cam {0} is where its law has the lift {2} of the follower; {1} is the angle by which the cam has turned from where its x axis points to the follower:"
        }
        Message::SplineSlopes => {
            "The slopes σ of the lift by the cam angle at the rows of its table are found together, so that the second derivative does not jump at any row: each follows from its neighbours. The lift is s = s₀ + a u + b u² + c u³:"
        }
        Message::RootOfLaw => {
            "{0} is the root of the law on this flank, found by Newton’s method; the law with it follows."
        }
        Message::CamDwells => "The cam is in a dwell: its follower does not move.",
        Message::PlanetsEven => {
            "The planets {0} are evenly spaced about the axis of {1}: their mass centre stays on it, and {1} has their mass at the distance of their axes in addition to its own moment of inertia:"
        }
        Message::LiftBegins => {
            "The lift begins where the follower is at the distance {0} from the cam’s centre."
        }
        Message::HeldByArc => "The pin is in no slot; the locking arc holds wheel {0} at {1}:",
        Message::TurnsWith => "Link {0} does not turn against link {1}.",
        Message::Rests => "Link {0} rests.",
        // motions under loads
        // powers
        Message::Powers => "Powers",
        // cylinders
        Message::CommonNormal => {
            "{0} is the relative instant centre of cam and follower. The common normal passes through it and {1}:"
        }
        Message::StaticMasses => {
            "Link {0} as two masses in {1} and {2}, with the same mass and mass centre; ΔJ is what the moments of inertia differ by:"
        }
        Message::DynamicMasses => {
            "Link {0} as two masses in {1} and in the centre of oscillation {2}, with the same mass, mass centre and moment of inertia:"
        }
        Message::StiffLink => {
            "Links {0} and {1} are one stiff link at this position. In the axes of link {0}, from {3}, the place of {2} is ξ, η:"
        }
        Message::CylinderLength => "The drive gives the length of the cylinder between its hinges, {0}.",
        Message::PlaceOpen => "The place of a shaft is not given, so the reaction in {0} is not determined.",
        Message::CoupleAtSlider => "About {0}, the point of the slider, the couple of the guide is:",
        Message::AskedBesides => "What else the file asks for, from these results:",
        Message::ByFormulas => "The file’s own formulas with these results:",
        Message::LoadRests => "{0} does not act at this position.",
    }
}
