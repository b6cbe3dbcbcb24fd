//! The effects that a file calls for. An effect that nothing calls for has no step in the plan.

use crate::model::{
    DriveTarget, Expr, FindKind, Level, LoadId, Mechanism, PairKind, QuantityId, Query, Relation,
};

/// What is computed at every position.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effects {
    /// How far motion is followed.
    pub level: Level,
    /// How far results are asked for; the motion may take more.
    pub asked: Level,
    pub asks_forces: bool,
    /// Rates beyond accelerations: jerks.
    pub beyond: bool,
    /// Velocities are there to be asked for: a drive has a speed, or a sense (then they are ratios).
    pub moving: bool,
    /// A drive has a speed: accelerations are there to be asked for.
    pub timed: bool,
    /// The one drive has no speed, and moves at unit speed: the shape of paths is asked for, which is the same at any speed.
    pub geometric: bool,
    /// The motion follows from the loads: they are summed up at every position, whether forces are asked for or not.
    pub simulated: bool,
    pub forces: bool,
    pub inertia: bool,
    pub gravity: bool,
    pub springs: bool,
    /// Friction in the pairs.
    pub friction: bool,
    /// Transmissions that lose power.
    pub losses: bool,
}

impl Effects {
    pub(super) fn of(mechanism: &Mechanism) -> Self {
        let mut wanted = EffectRequest::default();
        wanted.requests(mechanism);
        Self::wanted(mechanism, wanted)
    }

    /// What the file calls for, and at least this much where the file declares it: for a picture that shows more than it asks.
    #[must_use]
    pub fn at_least(mechanism: &Mechanism, level: Level, forces: bool) -> Self {
        let mut wanted = EffectRequest::default();
        wanted.requests(mechanism);
        Self::wanted(
            mechanism,
            EffectRequest { level: wanted.level.max(level), forces: wanted.forces || forces, ..wanted },
        )
    }

    /// What would be computed if everything were asked for that the file declares.
    #[must_use]
    pub fn declared(mechanism: &Mechanism) -> Self {
        Self::wanted(
            mechanism,
            EffectRequest { level: Level::Accelerations, forces: true, ..EffectRequest::default() },
        )
    }

    fn wanted(mechanism: &Mechanism, mut wanted: EffectRequest) -> Self {
        let timed = mechanism.drives.iter().any(|d| d.speed.is_some() || d.acceleration.is_some());
        let moving = timed || mechanism.drives.iter().any(|d| d.sense.is_some());
        let has_mass = mechanism.links.iter().any(|l| l.mass.is_some());
        let simulated = mechanism.simulation.is_some();
        let rubs = mechanism.pairs.iter().any(|p| p.friction.is_some_and(|f| f.is_some()));
        // where the motion follows from the loads, friction takes part in it
        let forces = wanted.forces || (simulated && (rubs || loses(mechanism) || may_open(mechanism)));
        let loaded = forces || simulated;
        let (asked, asks_forces) = (wanted.level, wanted.forces);
        let inertia = loaded && timed && has_mass && !mechanism.ignore_inertia;
        let friction = forces && moving && rubs;
        let losses = forces && moving && loses(mechanism);
        let damped = mechanism.springs.iter().any(|s| s.damping > 0.0);
        if loaded {
            wanted.loads(mechanism);
        }
        let mut level = wanted.level;
        if inertia || simulated {
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
        let geometric = wanted.geometric && Self::is_geometric(mechanism);
        if geometric {
            level = Level::Accelerations;
        }
        Self {
            level,
            asked,
            asks_forces,
            beyond: wanted.beyond && timed,
            moving,
            timed,
            geometric,
            simulated,
            forces,
            inertia,
            gravity: loaded && mechanism.gravity.is_some() && has_mass,
            springs: loaded && !mechanism.springs.is_empty(),
            friction,
            losses,
        }
    }

    /// Whether the shape of paths is known without a speed: one drive moves everything, by a number.
    #[must_use]
    pub fn is_geometric(mechanism: &Mechanism) -> bool {
        let [drive] = mechanism.drives.as_slice() else { return false };
        let of_time = mechanism.simulation.is_some() || drive.speed.is_some() || drive.acceleration.is_some();
        !of_time && !matches!(drive.target, DriveTarget::Point(..))
    }

    /// How far the motion that is found has rates of its own: not those at unit speed that paths need alone.
    #[must_use]
    pub fn rates(&self) -> Level {
        match (self.geometric, self.moving) {
            (false, _) => self.level,
            (true, true) => Level::Velocities,
            (true, false) => Level::Positions,
        }
    }

    /// Whether the loads are summed up.
    #[must_use]
    pub const fn loaded(&self) -> bool {
        self.forces || self.simulated
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
        if self.beyond {
            names.push("jerks");
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

/// Whether a pair holds only as long as forces act as it takes them.
fn may_open(mechanism: &Mechanism) -> bool {
    mechanism.pairs.iter().any(|pair| pair.kind.bonds().next().is_some())
}

/// Whether a transmission has an efficiency.
fn loses(mechanism: &Mechanism) -> bool {
    mechanism.pairs.iter().any(|p| match &p.kind {
        PairKind::Transmission(t) => t.laws.iter().any(|l| l.efficiency.is_some()),
        _ => false,
    })
}

#[derive(Default)]
struct EffectRequest {
    level: Level,
    geometric: bool,
    beyond: bool,
    forces: bool,
    /// The file's quantities that something asked for names: a definition alone asks for nothing.
    named: Vec<QuantityId>,
    /// Its loads that something asked for names.
    loads: Vec<LoadId>,
}

impl EffectRequest {
    fn requests(&mut self, mechanism: &Mechanism) {
        for find in &mechanism.finds {
            match &find.kind {
                FindKind::Value { expr, .. } => self.expr(mechanism, expr),
                // with `find reactions` everything of every pose is reported
                FindKind::Reactions => {
                    self.forces = true;
                    self.level = Level::Accelerations;
                }
                FindKind::Table(table) => table.questions().for_each(|expr| self.expr(mechanism, expr)),
            }
        }
        for expect in &mechanism.expects {
            self.expr(mechanism, &expect.expr);
            match &expect.relation {
                Relation::Equal(values) => values.iter().for_each(|e| self.expr(mechanism, e)),
                Relation::Compare(_, bound) => self.expr(mechanism, bound),
                Relation::Condition => {}
            }
        }
        mechanism.events.iter().for_each(|e| self.expr(mechanism, &e.value));
        mechanism.cycles.iter().for_each(|c| self.expr(mechanism, &c.expr));
        if !mechanism.flywheels.is_empty() {
            self.forces = true;
            self.level = self.level.max(Level::Velocities);
        }
    }

    fn loads(&mut self, mechanism: &Mechanism) {
        for id in 0..mechanism.loads.len() {
            self.load(mechanism, LoadId::at(id));
        }
    }

    /// What the value of a load depends on.
    fn load(&mut self, mechanism: &Mechanism, id: LoadId) {
        if self.loads.contains(&id) {
            return;
        }
        self.loads.push(id);
        let load = &mechanism.loads[id.index()];
        load.expressions().for_each(|e| self.expr(mechanism, e));
        if load.is_against_motion() {
            self.level = self.level.max(Level::Velocities);
        }
    }

    fn expr(&mut self, mechanism: &Mechanism, expr: &Expr) {
        expr.parts(&mut |part| match part {
            Expr::Query(query) => {
                let facts = query.facts();
                self.level = self.level.max(facts.level);
                self.geometric |= facts.geometric;
                self.beyond |= facts.beyond;
                self.forces |= facts.forces;
                if let Query::Load(id) | Query::LoadPower(id) = query {
                    self.load(mechanism, *id);
                }
                if let Query::Work(id) = query {
                    self.expr(mechanism, &mechanism.works[*id]);
                }
            }
            Expr::Quantity(id) if !self.named.contains(id) => {
                self.named.push(*id);
                self.expr(mechanism, &mechanism.quantities[id.index()].expr);
            }
            _ => {}
        });
    }
}
