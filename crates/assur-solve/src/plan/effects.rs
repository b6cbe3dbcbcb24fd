//! The effects that a file calls for. An effect that nothing calls for has no step in the plan.

use crate::model::{
    Expr, FindKind, FlywheelPart, LoadKind, Mechanism, PairKind, QuantityId, Query, Relation,
};

/// How far motion is followed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// Positions only.
    #[default]
    Positions,
    /// And velocities.
    Velocities,
    /// And accelerations.
    Accelerations,
}

/// What is computed at every position.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effects {
    /// How far motion is followed.
    pub level: Level,
    /// Velocities are there to be asked for: a drive has a speed, or a sense (then they are ratios).
    pub moving: bool,
    /// A drive has a speed: accelerations are there to be asked for.
    pub timed: bool,
    /// Reactions and efforts.
    pub forces: bool,
    /// Inertia forces.
    pub inertia: bool,
    /// Weights.
    pub gravity: bool,
    /// Springs.
    pub springs: bool,
    /// Friction in the pairs.
    pub friction: bool,
    /// Transmissions that lose power.
    pub losses: bool,
}

impl Effects {
    pub(super) fn of(mechanism: &Mechanism) -> Self {
        let mut wanted = Wanted::default();
        wanted.requests(mechanism);
        Self::wanted(mechanism, wanted)
    }

    /// What would be computed if everything were asked for that the file declares.
    #[must_use]
    pub fn declared(mechanism: &Mechanism) -> Self {
        Self::wanted(mechanism, Wanted { level: Level::Accelerations, forces: true, ..Wanted::default() })
    }

    fn wanted(mechanism: &Mechanism, mut wanted: Wanted) -> Self {
        let timed = mechanism.drives.iter().any(|d| d.speed.is_some() || d.acceleration.is_some());
        let moving = timed || mechanism.drives.iter().any(|d| d.sense.is_some());
        let has_mass = mechanism.links.iter().any(|l| l.mass.is_some());
        let forces = wanted.forces;
        let inertia = forces && timed && has_mass && !mechanism.ignore_inertia;
        let rubs = mechanism.pairs.iter().any(|p| p.friction.is_some_and(|f| f.is_some()));
        let friction = forces && moving && rubs;
        let losses = forces && moving && loses(mechanism);
        let damped = mechanism.springs.iter().any(|s| s.damping > 0.0);
        if forces {
            wanted.loads(mechanism);
        }
        let mut level = wanted.level;
        if inertia {
            level = Level::Accelerations;
        } else if forces && moving && (damped || friction || losses) {
            level = level.max(Level::Velocities);
        }
        if !timed {
            level = level.min(Level::Velocities);
        }
        if !moving {
            level = Level::Positions;
        }
        Self {
            level,
            moving,
            timed,
            forces,
            inertia,
            gravity: forces && mechanism.gravity.is_some() && has_mass,
            springs: forces && !mechanism.springs.is_empty(),
            friction,
            losses,
        }
    }

    /// Whether forces differ from those of the same mechanism without losses.
    #[must_use]
    pub const fn loses(&self) -> bool {
        self.friction || self.losses
    }

    /// The physical effects that the file calls for.
    #[must_use]
    pub fn names(&self) -> Vec<&'static str> {
        let all = [
            (self.inertia, "inertia"),
            (self.gravity, "gravity"),
            (self.springs, "springs"),
            (self.friction, "friction"),
            (self.losses, "losses"),
        ];
        all.into_iter().filter(|(on, _)| *on).map(|(_, name)| name).collect()
    }

    /// What is computed at every position beside positions: how far motion is followed, the effects, reactions.
    #[must_use]
    pub fn computed(&self) -> Vec<&'static str> {
        let mut names = Vec::new();
        if self.level >= Level::Velocities {
            names.push("velocities");
        }
        if self.level >= Level::Accelerations {
            names.push("accelerations");
        }
        names.extend(self.names());
        if self.forces {
            names.push("reactions");
        }
        names
    }

    /// What the file declares and nothing asks for: it has no step.
    #[must_use]
    pub fn not_asked_for(&self, mechanism: &Mechanism) -> Vec<&'static str> {
        let computed = self.computed();
        Self::declared(mechanism).computed().into_iter().filter(|name| !computed.contains(name)).collect()
    }
}

/// Whether a transmission has an efficiency.
fn loses(mechanism: &Mechanism) -> bool {
    mechanism.pairs.iter().any(|p| match &p.kind {
        PairKind::Transmission(t) => t.laws.iter().any(|l| l.efficiency.is_some()),
        _ => false,
    })
}

#[derive(Default)]
struct Wanted {
    level: Level,
    forces: bool,
    /// The file's quantities that something asked for names: a definition alone asks for nothing.
    named: Vec<QuantityId>,
}

impl Wanted {
    fn requests(&mut self, mechanism: &Mechanism) {
        for find in &mechanism.finds {
            match &find.kind {
                FindKind::Value { expr, .. } => self.expr(mechanism, expr),
                // with `find reactions` everything of every pose is reported
                FindKind::Reactions => {
                    self.forces = true;
                    self.level = Level::Accelerations;
                }
                FindKind::Table(_) => {}
            }
        }
        for expect in &mechanism.expects {
            self.expr(mechanism, &expect.expr);
            match &expect.relation {
                Relation::Equal(values) => values.iter().for_each(|e| self.expr(mechanism, e)),
                Relation::Compare(_, bound) => self.expr(mechanism, bound),
                Relation::Truth => {}
            }
        }
        mechanism.cycles.iter().for_each(|c| self.expr(mechanism, &c.expr));
        if !mechanism.flywheels.is_empty() {
            self.forces = true;
            self.level = self.level.max(Level::Velocities);
        }
    }

    fn loads(&mut self, mechanism: &Mechanism) {
        for load in &mechanism.loads {
            if let Some(when) = &load.when {
                self.expr(mechanism, when);
            }
            match &load.kind {
                LoadKind::ForceAgainstMotion { value, .. }
                | LoadKind::Torque { value, against_motion: true, .. } => {
                    self.expr(mechanism, value);
                    self.level = self.level.max(Level::Velocities);
                }
                LoadKind::Force { value, .. }
                | LoadKind::Torque { value, .. }
                | LoadKind::InPair { value, .. } => {
                    self.expr(mechanism, value);
                }
            }
        }
    }

    fn expr(&mut self, mechanism: &Mechanism, expr: &Expr) {
        expr.parts(&mut |part| match part {
            Expr::Query(query) => {
                self.level = self.level.max(level_of(query));
                self.forces |= needs_forces(query);
            }
            Expr::Quantity(id) if !self.named.contains(id) => {
                self.named.push(*id);
                self.expr(mechanism, &mechanism.quantities[id.index()].expr);
            }
            _ => {}
        });
    }
}

/// How far motion must be followed to answer.
#[must_use]
pub fn level_of(query: &Query) -> Level {
    match query {
        Query::Velocity(_)
        | Query::Omega(_)
        | Query::RelativeVelocity(_)
        | Query::Coriolis(_)
        | Query::PressureAngle(_)
        | Query::BalancePower(_)
        | Query::LoadPower(_)
        | Query::FrictionPower(_)
        | Query::Efficiency
        | Query::Locked
        | Query::EffortPower(_)
        | Query::Flywheel(..) => Level::Velocities,
        Query::Acceleration(_)
        | Query::Alpha(_)
        | Query::RelativeAcceleration(_)
        | Query::InertiaForce(_)
        | Query::InertiaTorque(_)
        | Query::InertiaArm(_) => Level::Accelerations,
        Query::StaticSubstitution(_, _, _, part) | Query::DynamicSubstitution(_, _, part) => {
            use crate::model::SubstitutionPart as P;
            if matches!(part, P::A2 | P::F1 | P::F2) { Level::Accelerations } else { Level::Positions }
        }
        _ => Level::Positions,
    }
}

/// Whether an answer needs reactions or efforts.
#[must_use]
pub fn needs_forces(query: &Query) -> bool {
    matches!(
        query,
        Query::Reaction(..)
            | Query::Moment(..)
            | Query::Normal(..)
            | Query::ContactForce(..)
            | Query::LineOffset(_)
            | Query::Balance(_)
            | Query::Effort(_)
            | Query::BalancePower(_)
            | Query::EffortPower(_)
            | Query::Friction(..)
            | Query::FrictionPower(_)
            | Query::Efficiency
            | Query::Locked
            | Query::Critical(_)
            | Query::TangentialForce(_)
            | Query::ToothForce(_)
            | Query::Tension(..)
            | Query::Flywheel(
                _,
                FlywheelPart::Inertia
                    | FlywheelPart::Fluctuation
                    | FlywheelPart::RimWidth
                    | FlywheelPart::RimHeight
                    | FlywheelPart::RimMass
                    | FlywheelPart::Torque
                    | FlywheelPart::Work
            )
    )
}
