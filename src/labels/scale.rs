//! Numbers along an axis: what their values are, and which of them stay where there is no room for all.

use crate::braille::{is_raised_or_lowered, power};

/// How far a number may stand from where its value says, as a share of the distance to the next: print is moved aside
/// where an axis crosses.
const OFF: f32 = 0.3;
/// How far values may lie off even steps, as a share of a step: rounding.
const UNEVEN: f64 = 0.01;
/// Most characters of a unit behind a number, such as "°C" or "km/h".
const UNIT: usize = 6;
/// Units of lengths.
const LENGTHS: [&str; 8] = ["mm", "cm", "dm", "m", "km", "in", "ft", "yd"];
/// Fewest numbers that are a scale. Two are one only where both stand at lines (`groups`).
const FEWEST: usize = 2;
/// Fewest numbers of a scale beside which another is none of it.
const FEWEST_BESIDE: usize = 3;

/// Every how many-th of the numbers along an axis is written where there is no room for all, the first that fits:
/// steps that are counted easily, as on rulers.
pub const EVERY: [i64; 3] = [2, 5, 10];

/// Of numbers that stand in even steps along a line, how many steps each lies from zero, or from the first of them
/// where zero is none of the steps; none where they do not.
pub(super) fn steps(texts: &[&str], positions: &[f32]) -> Option<Vec<i64>> {
    let numbers: Vec<Number<'_>> = texts.iter().map(|text| number(text)).collect::<Option<_>>()?;
    let unit = numbers.iter().map(|number| number.unit).find(|unit| !unit.is_empty()).unwrap_or_default();
    // behind the first or the last of them, a unit may stand for all
    let has_unit = |end: Option<&Number<'_>>| end.is_some_and(|number| !number.unit.is_empty());
    let count = numbers.iter().filter(|number| !number.unit.is_empty()).count();
    let is_once = count == 1 && numbers.len() > FEWEST && (has_unit(numbers.first()) || has_unit(numbers.last()));
    let is_of_unit =
        |number: &Number<'_>| number.unit == unit || number.unit.is_empty() && (is_once || number.value == 0.0);
    let values = counted(&numbers)?;
    let mut differences = values.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    let step = differences.clone().fold(f64::INFINITY, f64::min);
    let rises = values.first()? < values.last()?;
    let is_in_order = values.windows(2).all(|pair| (pair[0] < pair[1]) == rises);
    if values.len() < FEWEST || !numbers.iter().all(is_of_unit) || !is_in_order || differences.any(|by| by == 0.0) {
        return None;
    }
    let is_whole = |from: f64| values.iter().all(|value| whole((value - from) / step).is_some());
    let from = if is_whole(0.0) { 0.0 } else { values[0] };
    let steps: Vec<i64> = values.iter().map(|value| whole((value - from) / step)).collect::<Option<_>>()?;
    is_even(&steps, positions).then_some(steps)
}

/// The one of some numbers that stand along a line, in their order, which stands at a place in the scale of all others
/// and says something else, as 0 between 0.4 and 0.6: it was read wrongly. None where there is no such scale, or more
/// than one; and none at an end, where a scale may be broken off.
pub fn off_scale(texts: &[&str], positions: &[f32]) -> Option<usize> {
    if texts.len() <= FEWEST_BESIDE || steps(texts, positions).is_some() {
        return None;
    }
    let is_off = |odd: &usize| {
        let other = |at: usize| at != *odd;
        let beside: Vec<&str> = (0..texts.len()).filter(|&at| other(at)).map(|at| texts[at]).collect();
        let places: Vec<f32> = (0..texts.len()).filter(|&at| other(at)).map(|at| positions[at]).collect();
        steps(&beside, &places).is_some_and(|steps| stands_at_free_step(positions[*odd], &steps, &places))
    };
    let mut odd = (0..texts.len()).filter(is_off);
    let first = odd.next()?;
    odd.next().is_none().then_some(first)
}

/// Whether a place along a line is that of a step between these of a scale, and none of them.
fn stands_at_free_step(at: f32, steps: &[i64], positions: &[f32]) -> bool {
    let (Some((&first, &last)), Some((&from, &to))) =
        (steps.first().zip(steps.last()), positions.first().zip(positions.last()))
    else {
        return false;
    };
    let step = first as f32 + (at - from) / (to - from) * (last - first) as f32;
    let whole = step.round() as i64;
    let is_between = (first.min(last)..=first.max(last)).contains(&whole);
    (step - step.round()).abs() <= OFF && is_between && !steps.contains(&whole)
}

/// What is counted along a scale of these numbers: of powers of one base their exponents, as on a scale of logarithms,
/// of others what stands on the line, if what is raised or lowered behind it is the same of all.
fn counted(numbers: &[Number<'_>]) -> Option<Vec<f64>> {
    let first = numbers.first()?;
    if numbers.iter().all(|number| number.script == first.script) {
        return Some(numbers.iter().map(|number| number.value).collect());
    }
    let base = numbers.iter().find(|number| !number.script.is_empty())?.value;
    numbers.iter().map(|number| number.exponent_of(base)).collect()
}

/// Whether a text is a number, with or without a unit.
pub fn is_number(text: &str) -> bool {
    number(text).is_some()
}

/// Whether a text is a number with something raised or lowered behind it, such as a power.
pub(super) fn is_power(text: &str) -> bool {
    number(text).is_some_and(|number| !number.script.is_empty())
}

/// Which texts of a row have no letter in their place, as that would be felt as a digit: the powers, and the numbers
/// without a unit. Where all of these have four digits, as years below bars, they have letters as names do.
pub(super) fn stay(texts: &[&str]) -> Vec<bool> {
    let is_bare = |text: &&str| number(text).is_some_and(|of| of.unit.is_empty() || !of.script.is_empty());
    let is_year = |text: &&str| text.trim().len() == 4 && text.trim().bytes().all(|digit| digit.is_ascii_digit());
    let are_years = texts.iter().filter(|text| is_bare(text)).all(is_year);
    texts.iter().map(|text| !are_years && is_bare(text)).collect()
}

/// Whether a text is a plus or a minus by itself, as at the poles of a battery.
fn is_sign(text: &str) -> bool {
    let mut signs = text.trim().chars();
    signs.next().is_some_and(|sign| sign == '+' || is_minus(sign)) && signs.next().is_none()
}

/// A text that is read by itself though another of its kind stands near to it in one line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Alone {
    /// A number: it begins with its sign.
    Number,
    /// A plus or a minus.
    Sign,
}

impl Alone {
    /// What a text is of these, if it is one.
    pub(super) fn of(text: &str) -> Option<Self> {
        let number = is_number(text).then_some(Self::Number);
        number.or_else(|| is_sign(text).then_some(Self::Sign))
    }
}

/// Whether a text is the length of something, such as "6 cm" or "h = 4 cm".
pub(super) fn is_length(text: &str) -> bool {
    let own = text.rsplit('=').next().unwrap_or(text);
    number(own).is_some_and(|number| LENGTHS.contains(&number.unit))
}

/// A number without its unit; none if it has none.
pub(super) fn without_unit(text: &str) -> Option<&str> {
    let unit = number(text)?.unit;
    if unit.is_empty() { None } else { text.trim().strip_suffix(unit).map(str::trim) }
}

/// A number that is whole but for rounding.
fn whole(number: f64) -> Option<i64> {
    // far beyond what is written at an axis
    ((number - number.round()).abs() < UNEVEN && number.abs() < 1e12).then(|| number.round() as i64)
}

/// Whether places along a line are even in these steps.
fn is_even(steps: &[i64], positions: &[f32]) -> bool {
    let (Some((&first, &last)), Some((&from, &to))) =
        (steps.first().zip(steps.last()), positions.first().zip(positions.last()))
    else {
        return false;
    };
    let of_step = (to - from) / (last - first) as f32;
    let off = |(step, at): (&i64, &f32)| (from + of_step * (step - first) as f32 - at).abs();
    steps.iter().zip(positions).all(|pair| off(pair) <= OFF * of_step.abs())
}

/// Whether a sign is that of minus, or one that is typed for it.
pub(super) fn is_minus(sign: char) -> bool {
    matches!(sign, '-' | '\u{2010}'..='\u{2013}' | '\u{2212}')
}

/// A number and what stands behind it.
#[derive(Debug, Clone, Copy)]
struct Number<'a> {
    /// That of the digits on the line.
    value: f64,
    /// What is raised or lowered right behind them, such as the exponent of a power.
    script: &'a str,
    unit: &'a str,
}

impl Number<'_> {
    /// The exponent of a power of this base; of the base itself 1, and of one 0.
    fn exponent_of(&self, base: f64) -> Option<f64> {
        let is = |value: f64| self.value.total_cmp(&value).is_eq();
        match self.script {
            "" if is(base) => Some(1.0),
            "" if is(1.0) => Some(0.0),
            script if is(base) => power(script).map(f64::from),
            _ => None,
        }
    }
}

/// The number that a text begins with, with the unit behind it; none of a text that is no number.
fn number(text: &str) -> Option<Number<'_>> {
    let text = text.trim();
    let (sign, rest) = match text.strip_prefix(is_minus) {
        Some(rest) => (-1.0, rest),
        None => (1.0, text.strip_prefix('+').unwrap_or(text)),
    };
    let part = |text: &str| text.trim().parse::<u16>().ok().map(f64::from);
    if let Some((over, under)) = rest.split_once('/').and_then(|(over, under)| part(over).zip(part(under))) {
        return (under > 0.0).then_some(Number { value: sign * over / under, script: "", unit: "" });
    }
    let grouped = groups_of_three(rest);
    let is_of_number = |sign: char| sign.is_ascii_digit() || matches!(sign, '.' | ',');
    let end = grouped.unwrap_or_else(|| rest.find(|sign| !is_of_number(sign)).unwrap_or(rest.len()));
    let (digits, behind) = rest.split_at(end);
    let value: f64 = if grouped.is_some() {
        digits.chars().filter(char::is_ascii_digit).collect::<String>().parse().ok()?
    } else {
        digits.replace(',', ".").parse().ok()?
    };
    let behind = behind.trim();
    let (script, unit) = behind.split_at(behind.find(|sign| !is_raised_or_lowered(sign)).unwrap_or(behind.len()));
    let unit = unit.trim();
    let is_unit = unit.chars().count() <= UNIT && !unit.contains(|sign: char| sign.is_ascii_digit());
    is_unit.then_some(Number { value: sign * value, script, unit })
}

/// Where a number in groups of three digits ends, as 12 000 or 1,000 do; none of others. A zero in front is that of a
/// decimal fraction.
fn groups_of_three(text: &str) -> Option<usize> {
    let is_between = |sign: char| matches!(sign, ',' | ' ' | '\'' | '\u{a0}' | '\u{2009}' | '\u{202f}');
    let digits = |from: usize| text[from..].chars().take_while(char::is_ascii_digit).count();
    let first = digits(0);
    if !(1..=3).contains(&first) || text.starts_with('0') {
        return None;
    }
    let mut end = first;
    while let Some(between) = text[end..].chars().next().filter(|&sign| is_between(sign)) {
        let from = end + between.len_utf8();
        if digits(from) != 3 {
            break;
        }
        end = from + 3;
    }
    (end > first).then_some(end)
}

#[cfg(test)]
mod tests;
