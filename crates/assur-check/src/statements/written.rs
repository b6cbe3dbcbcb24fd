//! Expressions as they would be written, for lines that a message proposes.

use assur_syntax::document::{BinaryOp, Expr, ExprKind, UnaryOp};

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
