//! What can be said of an expression before it is read.

use crate::errors::Extent;
use crate::families::Family;
use crate::model::{FrameWord, MOTIONS, Motion, is_solid};
use crate::syntax::{self, Description, Expression, Kind, Operator, Prefix};

/// Whether a load has unknown components.
pub fn is_unknown(written: &syntax::Load) -> bool {
    let value = written.vector.as_ref();
    written.family == Family::Reaction
        && value.is_some_and(|value| placeholders(value).next().is_some())
}

/// Whether a load is a drive with unknown components.
pub fn is_drive(written: &syntax::Load) -> bool {
    let drives = matches!(written.family, Family::External | Family::Joint);
    let value = written.vector.as_ref();
    drives && value.is_some_and(|value| placeholders(value).next().is_some())
}

/// Whether a load is such a drive and acts at a point, with a known component in world axes or
/// along a direction.
pub fn is_turning_drive(written: &syntax::Load) -> bool {
    let Some(value) = written.vector.as_ref().filter(|_| is_drive(written)) else {
        return false;
    };
    let in_world = match &value.kind {
        Kind::Call(word, parts) => word == "world" && placeholders(value).count() < parts.len(),
        _ => direction(value).is_some(),
    };
    in_world && written.point.is_some()
}

/// The placeholders in `_`, `body(_, 0, _)` and `body(_, 0, _)[N]`, with the indices of their axes.
pub fn placeholders(value: &Expression) -> impl Iterator<Item = (usize, Extent)> {
    let inner = match &value.kind {
        Kind::Unit(inner, _) => inner,
        _ => value,
    };
    let parts = match &inner.kind {
        Kind::Chain(first, _) if direction(inner).is_some() => std::slice::from_ref(&**first),
        Kind::Call(word, parts) if word == "body" || word == "world" => parts.as_slice(),
        Kind::Placeholder => std::slice::from_ref(inner),
        _ => &[],
    };
    let unknown = parts
        .iter()
        .enumerate()
        .filter(|(_, part)| matches!(part.kind, Kind::Placeholder));
    unknown.map(|(axis, part)| (axis, part.extent))
}

/// The direction of `_ * direction`.
pub fn direction(value: &Expression) -> Option<&Expression> {
    match &value.kind {
        Kind::Chain(first, rest) if matches!(first.kind, Kind::Placeholder) => match &**rest {
            [step] if step.operator == Operator::Multiply => Some(&step.operand),
            _ => None,
        },
        _ => None,
    }
}

pub fn strip_unit(value: &Expression) -> &Expression {
    match &value.kind {
        Kind::Unit(inner, _) => inner,
        _ => value,
    }
}

pub fn has_placeholder(value: &Expression) -> bool {
    match &strip_unit(value).kind {
        Kind::Call(_, parts) | Kind::Tuple(parts) => parts
            .iter()
            .any(|part| matches!(part.kind, Kind::Placeholder)),
        Kind::Placeholder => true,
        _ => false,
    }
}

/// The axes of a written vector, if its form shows them.
pub fn written_frame(value: &Expression) -> Option<FrameWord> {
    match &value.kind {
        Kind::Unit(operand, _) | Kind::Prefix(_, operand) => written_frame(operand),
        Kind::Tuple(_) => Some(FrameWord::Body),
        Kind::Call(name, _) if name == "body" => Some(FrameWord::Body),
        Kind::Call(name, _) if name == "world" => Some(FrameWord::World),
        _ => None,
    }
}

/// The motion named by a description, if the name is valid.
pub fn written_motion(description: &Description) -> Option<Motion> {
    let word = description.motion.as_ref()?.word.to_string();
    motion(&word)
}

pub fn motion(word: &str) -> Option<Motion> {
    MOTIONS.iter().find(|motion| motion.word == word).copied()
}

/// The innermost expression, without the methods and units after it.
pub fn base(expression: &Expression) -> &Expression {
    let mut expression = expression;
    while let Kind::Method(inner, ..) | Kind::Unit(inner, _) = &expression.kind {
        expression = inner;
    }
    expression
}

/// Whether an inertia is that of a solid, rotated or not.
pub fn is_of_solid(written: &Expression) -> bool {
    matches!(&base(written).kind, Kind::Call(word, _) if is_solid(word))
}

/// `a - b` for `a == b`, unless a side is long.
pub fn difference(expression: &Expression) -> Option<String> {
    let Kind::Chain(left, rest) = &expression.kind else {
        return None;
    };
    let [step] = rest.as_slice() else {
        return None;
    };
    if step.operator != Operator::Equal {
        return None;
    }
    Some(match (short(left), short(&step.operand)) {
        (Some(left), Some(right)) if right == "0" => left,
        (Some(left), Some(right)) => format!("{left} - {right}"),
        _ => "left - right".to_owned(),
    })
}

/// `x.sin()` for `sin(x)`.
pub fn as_method(function: &str, arguments: &[Expression]) -> String {
    let texts = arguments.iter().map(short);
    let mut texts = texts.map(|text| text.unwrap_or_else(|| "..".to_owned()));
    let receiver = texts.next().map_or("x".to_owned(), |text| match &*text {
        ".." => "(..)".to_owned(),
        _ => text,
    });
    let others: Vec<String> = texts.collect();
    format!("{receiver}.{function}({})", others.join(", "))
}

/// The components of the axis that `z`, `-z`, `world.z` or `body.z` means.
pub fn axis_meant(expression: &Expression, axes: usize) -> Option<String> {
    let (size, axis) = match &expression.kind {
        Kind::Prefix(Prefix::Minus, inner) => ("-1", inner),
        _ => ("1", &Box::new(expression.clone())),
    };
    let word = match &axis.kind {
        Kind::Name(word) => word.to_string(),
        Kind::Text(word) => word.clone(),
        Kind::Field(receiver, word) => match &receiver.kind {
            Kind::Name(frame) if frame == "world" || frame == "body" => word.to_string(),
            _ => return None,
        },
        _ => return None,
    };
    let all = &["x", "y", "z"][..axes];
    let found = all.iter().position(|known| *known == word.to_lowercase())?;
    let parts = (0..axes).map(|axis| if axis == found { size } else { "0" });
    Some(parts.collect::<Vec<_>>().join(", "))
}

/// The end of a message about such a vector in place of a number.
pub const ONE_NUMBER: &str = "is one number in the plane: write the last component alone";

/// The vector of three components that an expression is, or that is a factor of it: `body(0, 0, m)`.
pub fn across_the_plane(expression: &Expression) -> Option<&Expression> {
    match &expression.kind {
        Kind::Call(word, parts) | Kind::Method(_, word, parts)
            if (word == "body" || word == "world") && parts.len() == 3 =>
        {
            Some(expression)
        }
        Kind::Unit(inner, _) | Kind::Prefix(Prefix::Minus, inner) => across_the_plane(inner),
        Kind::Chain(first, rest) => {
            let are_factors = rest.iter().all(|step| step.operator == Operator::Multiply);
            let mut factors =
                core::iter::once(&**first).chain(rest.iter().map(|step| &step.operand));
            factors.find_map(across_the_plane).filter(|_| are_factors)
        }
        _ => None,
    }
}

/// The text of an expression that is a name, a number, or a part of one.
pub fn short(expression: &Expression) -> Option<String> {
    match &expression.kind {
        Kind::Number(digits) => Some(digits.clone()),
        Kind::Name(name) => Some(name.to_string()),
        Kind::Field(receiver, word) => Some(format!("{}.{word}", short(receiver)?)),
        Kind::Method(receiver, word, arguments) if arguments.is_empty() => {
            Some(format!("{}.{word}()", short(receiver)?))
        }
        _ => None,
    }
}
