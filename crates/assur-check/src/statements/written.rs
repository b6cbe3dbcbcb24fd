//! Expressions as they would be written, for lines that a message proposes.

use assur_syntax::document::{BinaryOp, End, Expr, ExprKind, Joint, Path, Property, UnaryOp};

/// The expression as text; `None` for conditions. Brackets stand where the tree needs them.
pub fn written(expr: &Expr) -> Option<String> {
    Some(match &expr.kind {
        ExprKind::Number(n) => match &n.unit {
            Some(unit) if matches!(unit.node.as_str(), "%" | "°") => format!("{}{}", n.text, unit.node),
            Some(unit) => format!("{} {}", n.text, unit.node),
            None => n.text.clone(),
        },
        ExprKind::Name(name) => name.clone(),
        ExprKind::Member(base, part) => format!("{}.{}", written(base)?, part.node),
        ExprKind::Call { function, args } => {
            let arg = |a: &assur_syntax::document::Arg| {
                let value = written(&a.value)?;
                Some(a.name.as_ref().map_or_else(|| value.clone(), |n| format!("{} = {value}", n.node)))
            };
            let args = args.iter().map(arg).collect::<Option<Vec<_>>>()?;
            format!("{}({})", function.node, args.join(", "))
        }
        ExprKind::Vector(x, y) => format!("({}, {})", written(x)?, written(y)?),
        ExprKind::Polar(r, phi) => format!("{} @ {}", bracketed(r)?, bracketed(phi)?),
        ExprKind::Unary(op, inner) => match op.node {
            UnaryOp::Minus => format!("-{}", bracketed(inner)?),
            UnaryOp::Plus => bracketed(inner)?,
            UnaryOp::Not => return None,
        },
        ExprKind::Chain(first, rest) => {
            let mut text = operand_of_chain(first)?;
            for (op, operand) in rest {
                let sign = match op.node {
                    BinaryOp::Add => " + ",
                    BinaryOp::Subtract => " - ",
                    BinaryOp::Multiply => " * ",
                    BinaryOp::Divide => " / ",
                    BinaryOp::And | BinaryOp::Or => return None,
                };
                text.push_str(sign);
                text.push_str(&operand_of_chain(operand)?);
            }
            text
        }
        ExprKind::Power(a, b) => format!("{}^{}", bracketed(a)?, bracketed(b)?),
        ExprKind::Compare(..) => return None,
    })
}

/// A power binds more tightly than what joins the parts of a chain.
fn operand_of_chain(expr: &Expr) -> Option<String> {
    if matches!(expr.kind, ExprKind::Power(..)) { written(expr) } else { bracketed(expr) }
}

fn bracketed(expr: &Expr) -> Option<String> {
    let text = written(expr)?;
    let whole = match &expr.kind {
        ExprKind::Chain(..) | ExprKind::Polar(..) | ExprKind::Power(..) => false,
        ExprKind::Unary(_, inner) => matches!(inner.kind, ExprKind::Number(_) | ExprKind::Name(_)),
        _ => true,
    };
    Some(if whole { text } else { format!("({text})") })
}

// Ends, braces and joints as they would be written, for lines that a message proposes.

/// `write …` with each of some lines.
pub fn write_one(lines: &[String]) -> Option<String> {
    let quoted = lines.iter().map(|l| format!("`{l}`")).collect::<Vec<_>>();
    (!lines.is_empty()).then(|| format!("write {}", quoted.join(" or ")))
}

/// Properties in braces as they would be written, after some more; nothing where there are none.
pub fn braces(properties: &[Property], more: &[&str]) -> String {
    let one = |p: &Property| {
        let values = p.values.iter().map(written).collect::<Option<Vec<_>>>()?.join(", ");
        let blank = if values.is_empty() { "" } else { " " };
        p.properties.is_empty().then(|| format!("{}{blank}{values}", p.name.node))
    };
    let own = properties.iter().map(|p| one(p).unwrap_or_else(|| "…".into()));
    let all = more.iter().map(|m| (*m).to_owned()).chain(own).collect::<Vec<_>>();
    if all.is_empty() { String::new() } else { format!(" {{ {} }}", all.join("; ")) }
}

/// An end as written.
pub fn end_text(end: &End) -> String {
    match end {
        End::At(path) => text(path),
        End::Over(name) => format!("over({})", name.node),
        End::Under(name) => format!("under({})", name.node),
    }
}

/// The line of a joint, each end as `end` writes it.
pub fn line_of(joint: &Joint, end: impl Fn(&End) -> String) -> String {
    let ends = joint.ends.iter().map(end).collect::<Vec<_>>().join(" - ");
    format!("{} {}: {ends}{}", joint.kind.node.word(), joint.name.node, braces(&joint.properties, &[]))
}

/// A path as the author writes it.
pub fn text(path: &Path) -> String {
    match &path.tail {
        Some(tail) => format!("{}.{}", path.head.node, tail.node),
        None => path.head.node.clone(),
    }
}
