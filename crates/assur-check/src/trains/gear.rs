//! Meshes whose geometry is asked for: two wheels with teeth and a module.

use crate::expr::context::Context;
use crate::expr::positive::Want;
use crate::expr::property::{Read, Value, find, read};
use crate::values::format_value::{digits, format_value};
use assur_math::element::gear::{GearFault, GearPair, NoMesh, STANDARD_RACK, Teeth};
use assur_model::model::Gears;
use assur_syntax::document::{
    Document, End, Expr, Joint, JointKind, Member, Statement, WheelMember, WheelSize,
};
use assur_text::diagnostic::Diagnosis;
use assur_text::language::properties_of_pair;
use assur_text::source::Span;
use assur_text::units::Dimension;

/// Relative difference of two modules that are one.
const EQUAL: f64 = 1e-12;

impl Context<'_> {
    /// The geometry of a mesh. Its errors are reported once.
    pub(crate) fn gear_pair(&mut self, name: &str, asked: Span) -> Option<GearPair> {
        if let Some(known) = self.values.gears.get(name) {
            return known.as_ref().map(|gears| gears.pair);
        }
        let doc = self.doc;
        let joint = doc.statements.iter().find_map(|s| match &s.node {
            Statement::Joint(j) if j.kind.node == JointKind::Mesh && j.name.node == name => Some(j),
            _ => None,
        });
        let gears = joint.and_then(|joint| self.build(joint, asked));
        let pair = gears.as_ref().map(|gears| gears.pair);
        self.values.gears.insert(name.to_owned(), gears);
        pair
    }

    /// Keeps all meshes whose geometry is known, asked for or not.
    pub(crate) fn keep_gears(&mut self) {
        for statement in &self.doc.statements {
            let Statement::Joint(joint) = &statement.node else { continue };
            if joint.kind.node == JointKind::Mesh {
                self.quietly(|cx| cx.gear_pair(&joint.name.node, joint.name.span));
            }
        }
        let are_whole = |gears: &Gears| gears.pair.gears.iter().all(|g| g.alpha_a.is_finite() && g.sa > 0.0);
        self.builder.mech.gears =
            self.values.gears.values().flatten().filter(|g| are_whole(g)).cloned().collect();
    }

    fn build(&mut self, joint: &Joint, asked: Span) -> Option<Gears> {
        // what is wrong with the properties is said where the mesh is checked, before anything is asked
        let properties =
            self.quietly(|cx| read(cx, "a mesh", &joint.properties, properties_of_pair(JointKind::Mesh)))?;
        let wheels = wheels_of(self.doc, joint)?;
        if find(&properties, "bevel").is_some() {
            let message = format!(
                "`{}` is a mesh of bevel wheels: the geometry is that of spur wheels",
                joint.name.node
            );
            let help = "leave out `bevel`, or ask for speeds and torques".to_owned();
            return self.gear_incomplete(message, help, asked, joint.name.span);
        }
        let (z, module) = self.teeth(joint, wheels, asked)?;
        let number = |name: &str, usual: f64| find(&properties, name).map_or(usual, Read::number);
        let shift = match find(&properties, "shift").map(|p| &p.value) {
            Some(Value::Two(both)) => *both,
            _ => [0.0; 2],
        };
        let internal = find(&properties, "internal").is_some();
        let [angle, addendum, clearance] = STANDARD_RACK;
        // the pinion comes first, whichever is written first; only a ring must be the second
        let swapped = internal && z[0] > z[1];
        let turn = |both: [f64; 2]| if swapped { [both[1], both[0]] } else { both };
        let teeth = Teeth {
            z: turn(z),
            module,
            pressure_angle: number("pressure_angle", angle),
            addendum: number("addendum", addendum),
            clearance: number("clearance", clearance),
            shift: turn(shift),
            internal,
        };
        let names = wheels.map(|w| w.name.node.clone());
        let names = if swapped { [names[1].clone(), names[0].clone()] } else { names };
        let mesh = (joint.name.node.clone(), joint.name.span);
        if internal && z[0] == z[1] {
            let message = format!("ring and pinion of `{}` both have {} teeth", mesh.0, digits(z[0]));
            return self.gear_incomplete(
                message,
                "give the ring more teeth than the pinion".into(),
                asked,
                mesh.1,
            );
        }
        match GearPair::new(teeth) {
            Ok(pair) => {
                pair.faults()
                    .into_iter()
                    .for_each(|fault| self.gear_fault(&pair, &mesh, &names, fault, swapped));
                Some(Gears { mesh: mesh.0, wheels: names, pair })
            }
            Err(NoMesh(involute)) => {
                self.error(
                    Diagnosis::error(
                        "mech::gear::no_mesh",
                        format!(
                            "the teeth of `{}` do not reach each other: the involute of the working \
                             pressure angle would be {}, less than zero",
                            mesh.0,
                            digits(involute)
                        ),
                    )
                    .label(mesh.1, "shifted too far")
                    .help(
                        "make the sum of the shifts greater (in an internal pair the shift of the \
                         ring minus that of the pinion)",
                    ),
                );
                None
            }
        }
    }

    fn gear_incomplete<T>(&mut self, message: String, help: String, span: Span, mesh: Span) -> Option<T> {
        self.error(
            Diagnosis::error("mech::gear::incomplete", message)
                .primary(span, "this question")
                .label(mesh, "the mesh")
                .help(help),
        );
        None
    }

    /// Numbers of teeth and the module, which one of the wheels may leave out.
    fn teeth(&mut self, joint: &Joint, wheels: [&WheelMember; 2], asked: Span) -> Option<([f64; 2], f64)> {
        let mesh = joint.name.span;
        let mut z = [0.0; 2];
        for (i, wheel) in wheels.iter().enumerate() {
            let name = &wheel.name.node;
            let Some(WheelSize::Teeth(teeth)) = &wheel.size else {
                let message =
                    format!("the geometry of `{}` needs the teeth of wheel `{name}`", joint.name.node);
                let help = format!("write `wheel {name} teeth 18 module 2 mm`");
                return self.gear_incomplete(message, help, asked, mesh);
            };
            z[i] = self.wheel_value(teeth, Dimension::NUMBER, "the number of teeth")?;
            if z[i].fract() != 0.0 || z[i] < 3.0 {
                let message = format!("wheel `{name}` has {} teeth", digits(z[i]));
                return self.gear_incomplete(
                    message,
                    "give it a whole number of at least 3".into(),
                    asked,
                    mesh,
                );
            }
        }
        let mut modules = Vec::new();
        for wheel in wheels {
            if let Some(module) = &wheel.module {
                modules.push(self.wheel_value(module, Dimension::LENGTH, "the module")?);
            }
        }
        if modules.is_empty() {
            // that of another mesh
            let known = |name: &str| self.builder.mech.wheels.iter().find(|w| w.name == name && !w.open);
            let all = wheels.iter().filter_map(|wheel| known(&wheel.name.node));
            modules.extend(all.filter_map(|wheel| Some(2.0 * wheel.radius / wheel.teeth?)).next());
        }
        match modules[..] {
            [one] => Some((z, one)),
            [one, two] if (one - two).abs() <= EQUAL * one => Some((z, one)),
            // the transmission reports them
            [_, _] if self.names.bad.contains(&joint.name.node) => None,
            [one, two] => {
                let mm = |x| format_value(x, Dimension::LENGTH);
                let message = format!(
                    "the wheels of `{}` have the modules {} and {}",
                    joint.name.node,
                    mm(one),
                    mm(two)
                );
                self.gear_incomplete(message, "wheels in mesh have one module".into(), asked, mesh)
            }
            _ => {
                let name = &wheels[0].name.node;
                let message = format!("the geometry of `{}` needs the module", joint.name.node);
                let help = format!("write `wheel {name} teeth {} module 2 mm`", digits(z[0]));
                self.gear_incomplete(message, help, asked, mesh)
            }
        }
    }

    fn wheel_value(&mut self, expr: &Expr, dimension: Dimension, what: &str) -> Option<f64> {
        self.scalar_constant(expr, &Want(dimension), what).filter(|x| *x > 0.0 && x.is_finite())
    }

    fn gear_fault(
        &mut self,
        pair: &GearPair,
        (mesh, span): &(String, Span),
        names: &[String; 2],
        fault: GearFault,
        swapped: bool,
    ) {
        let (span, mm) = (*span, |x| format_value(x, Dimension::LENGTH));
        let name = |i: usize| names[i].clone();
        let interference = |message: String, help: &str| {
            Diagnosis::error("mech::gear::interference", message)
                .label(span, "these teeth interfere")
                .help(help)
        };
        self.error(match fault {
            GearFault::Undercut { wheel, shift, least } => {
                let mut shifts = pair.teeth.shift.map(digits);
                shifts[wheel] = digits((least * 1e3).ceil() / 1e3);
                if swapped {
                    shifts.swap(0, 1);
                }
                Diagnosis::warning(
                    "mech::gear::undercut",
                    format!(
                        "wheel `{}` is undercut: its profile shift is {}, the least without \
                         undercut is {}",
                        name(wheel),
                        digits(shift),
                        digits(least)
                    ),
                )
                .label(span, "in this mesh")
                .help(format!(
                    "write `shift {}` or give it more teeth: {} are enough without a shift",
                    shifts.join(", "),
                    digits(pair.z_min.ceil())
                ))
            }
            GearFault::Pointed { wheel, thickness } => Diagnosis::error(
                "mech::gear::pointed",
                format!(
                    "the teeth of wheel `{}` come to a point: on the tip circle their \
                     thickness would be {}",
                    name(wheel),
                    mm(thickness)
                ),
            )
            .label(span, "in this mesh")
            .help("use a smaller profile shift, or a smaller addendum"),
            GearFault::Gap { ratio } => Diagnosis::warning(
                "mech::gear::contact_ratio",
                format!(
                    "the contact ratio of `{mesh}` is {}: a pair of teeth parts before the \
                     next one meets",
                    digits(ratio)
                ),
            )
            .label(span, "does not run smoothly")
            .help(
                "use more teeth, a smaller pressure angle, or smaller shifts: it should \
                 be 1.2 or more",
            ),
            GearFault::Tip { wheel, reached, begin } => {
                let message = format!(
                    "the tips of `{}` reach below the involutes of `{}`: to a radius of \
                     curvature of {}, where these begin at {}",
                    name(1 - wheel),
                    name(wheel),
                    mm(reached),
                    mm(begin)
                );
                let help = "give the smaller wheel more teeth or a greater shift, or use a smaller addendum";
                interference(message, help)
            }
            GearFault::RingTip { tip, base } => {
                let message = format!(
                    "the tip circle of ring `{}` has {}, less than its base circle of {}, \
                     inside which it has no involute",
                    name(1),
                    mm(tip),
                    mm(base)
                );
                let help = "give the ring more teeth or a greater shift, or use a smaller addendum";
                interference(message, help)
            }
            GearFault::Overlap { gap } => {
                let message = format!(
                    "the tips of `{}` and ring `{}` meet away from the line of contact: they \
                     overlap by {}",
                    name(0),
                    name(1),
                    format_value(-gap, Dimension::ANGLE)
                );
                let help = "take more teeth for the ring, or a smaller addendum";
                interference(message, help)
            }
        });
    }
}

/// The wheels that a mesh joins; what is wrong there is said where the mesh is checked.
fn wheels_of<'d>(doc: &'d Document, joint: &Joint) -> Option<[&'d WheelMember; 2]> {
    let wheel = |end: &End| {
        let End::At(path) = end else { return None };
        let name = &path.tail.as_ref().unwrap_or(&path.head).node;
        doc.statements.iter().find_map(|s| {
            let body = match &s.node {
                Statement::Shaft(shaft) => &shaft.body,
                Statement::Slider(slider) => &slider.body,
                Statement::Ground(ground) => &ground.body,
                Statement::Link(link) => &link.body,
                _ => return None,
            };
            body.iter().find_map(|m| match &m.node {
                Member::Wheel(w) if w.name.node == *name => Some(w),
                _ => None,
            })
        })
    };
    match joint.ends.as_slice() {
        [a, b] => Some([wheel(a)?, wheel(b)?]),
        _ => None,
    }
}
